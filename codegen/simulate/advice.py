"""The smaller step that a check advises for an error of energy or momentum."""

import math

from coscrew_codegen.simulate.findings import ALLOWED, FINER, FINEST, Along

_LEAST = 0.5  # least order on which an advised step is based


def order(along: Along) -> float:
    """The order of the defect of energy in the step; 0 if it does not shrink.  In single precision
    the order in double, if the defect is the same: rounding disturbs its own."""
    if along.double and along.as_double:
        return order(along.double)
    finer, times = (along.fine, FINER) if along.fine_helps else (along.finest, FINEST)
    if finer is None or not (finer.relative and along.less(finer)):
        return 0.0
    return math.log(along.coarse.relative / finer.relative, times)


def unresolved(along: Along) -> bool:
    """Whether no step is advised, since smaller steps do not help."""
    return along.doubtful if not along.energy else not along.fine_energy


def factor(along: Along) -> float:
    """What to multiply the step by, or the length of its parts if these are too long, with one
    digit: then the defect of energy or momentum is about half the allowed one."""
    off, its = along.coarse.momentum, float(along.integrator.order)
    if not along.energy:
        off, its = along.coarse.relative, min(its, order(along) or its)
    return float(f"{(0.5 * ALLOWED / off)**(1 / max(_LEAST, its)):.1g}")


def step(along: Along) -> float:
    """The advised step in s; 0 if none is advised."""
    if along.true or along.stopped or not along.length or unresolved(along):
        return 0.0
    if not along.energy and along.part < math.inf:
        return float(f"{factor(along) * along.part:.1g}")
    return factor(along) * along.length
