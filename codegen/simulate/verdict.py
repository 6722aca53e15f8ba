"""The findings of a check as text: tables, what is false, what helps."""

import math

from tabulate import tabulate

from coscrew_codegen.integrators import DEFAULT
from coscrew_codegen.simulate.findings import (
    ALLOWED,
    FINER,
    FINEST,
    STRICTLY,
    Along,
    Findings,
    Met,
)
from coscrew_codegen.simulate.outcome import gaps

_LEAST = 0.5  # least order on which a proposed step is based


def table(findings: Findings, strict: bool = False) -> str:
    """The findings as text; with what fails `strict` alone, if that is given."""
    parts = [_expectations(findings.met)] if findings.met else []
    parts += [_checks(findings.along)]
    parts += [gaps(findings.apart)] if findings.apart else []
    parts += [findings.outside] if findings.outside else []
    parts += [f"{x.precision}: {x.stopped}" for x in findings.along if x.stopped]
    parts += [f"FALSE: {x.precision}: {_false(x)}" for x in findings.along
              if not (x.true or x.stopped)]
    parts += [f"FALSE with --strict: {x.precision}: {_strictly_false(x)}" for x in findings.along
              if strict and x.true and not (x.strictly_true or x.stopped)]
    return "\n\n".join(parts)


def _strictly_false(along: Along) -> str:
    if along.doubtful:
        return "smaller steps do not reduce the error of energy; it is not rounding"
    return f"energy is off by {along.coarse.relative:.2g}, allowed is {STRICTLY:g} if not rounding"


def _expectations(met: tuple[Met, ...]) -> str:
    rows = [("pass" if x.passed else "FAIL", x.wanted.quantity, x.wanted.at, x.wanted.value, x.came,
             abs(x.came - x.wanted.value), x.wanted.rtol * abs(x.wanted.value) + x.wanted.atol,
             x.unit) for x in met]
    columns = ("", "expected", "at t, s", "value", "came", "apart", "allowed", "unit")
    return str(tabulate(rows, columns, floatfmt=("", "", "g", ".12g", ".12g", ".2g", ".2g", "")))


def _checks(along: tuple[Along, ...]) -> str:
    rows = [("energy off by, from the work of effects, relative, at most",
             *(f"{x.coarse.relative:.2g}" for x in along)),
            ("the same with " + " or ".join(dict.fromkeys(_finer(x) for x in along)),
             *(f"{x.fine.relative:.2g}" for x in along)),
            ("it is", *(_verdict(x) for x in along)),
            ("a joint's speed differs from that with smaller steps by, of its largest, at most",
             *(f"{x.speeds[0]:.2g} ({x.speeds[1]})" for x in along)),
            *([("momentum of floating bases off by, relative, at most",
                *(f"{x.coarse.momentum:.2g}" for x in along))]
              if any(x.coarse.momentum for x in along) else []),
            ("|aba(rnea(a)) - a| / (|a| + |aba(0)|), at most, in u",
             *(f"{x.round_trip:.3g}" for x in along)),
            ("condition of the mass matrix (SI units), at most",
             *(f"{x.condition:.3g}" for x in along)),
            ("where that is, t in s", *(f"{x.at:g}" for x in along))]
    columns = ("", *(f"{x.precision}, {x.step}" for x in along))
    return str(tabulate(rows, columns, disable_numparse=True,
                        colalign=("left", *("right" for _ in along))))


def _false(along: Along) -> str:
    """A sentence on a defect beyond the allowed one, with its cause and a remedy; else ""."""
    energy = not along.energy
    if not (energy or along.fine_energy):
        return (f"energy is off by {along.coarse.relative:.2g}, but by {along.fine.relative:.2g} "
                f"with {_finer(along)}, allowed is {ALLOWED:g}: what the scene asks is not "
                "resolved")
    what, off = (("energy", along.coarse.relative) if energy
                 else ("momentum", along.coarse.momentum))
    said = f"{what} is off by {off:.2g}, allowed is {ALLOWED:g}"
    name = along.integrator.name
    if energy and along.doubtful:
        tried = (f"neither half the step nor 1/{FINEST} of it helps" if along.finest
                 else "smaller steps do not help")
        other = f"; integrator {DEFAULT} splits steps in which limits close"
        return (f"{said}, and {tried}: what the scene asks is not resolved"
                f"{other if along.limits and name != DEFAULT else ''}")
    if along.step.startswith("rtol"):
        return f"{said}; take a smaller rtol"
    order: float = along.integrator.order
    order = max(_LEAST, min(order, _order(along) or order)) if energy else order
    smaller = (0.5 * ALLOWED / off)**(1 / order)
    if energy and along.part < math.inf:
        return (f"{said}: the parts are too long in which steps are taken while limits are closed, "
                f"{along.part:.2g} s and more; take a step of {smaller * along.part:.1g} s, or "
                "softer limits")
    other = "" if name == DEFAULT else f", or integrator {DEFAULT}"
    return f"{said}: the step is too large; take one {smaller:.1g} times as long{other}"


def _finer(along: Along) -> str:
    return "a sixteenth of the tolerance" if along.step.startswith("rtol") else "half the step"


def _verdict(along: Along) -> str:
    """The cause of the defect of energy."""
    if along.doubtful:
        return "DOUBTFUL: it does not shrink"
    if along.untold:
        return "untold: potential energy rounds by more than was moved"
    if along.rounding:
        return "rounding"
    if along.step.startswith("rtol"):
        return "the integrator's: it shrinks"
    order = _order(along)
    return f"the integrator's, of order {order:.1f}" if order else "the integrator's, as in double"


def _order(along: Along) -> float:
    """The order of the defect of energy in the step; 0 if it does not shrink.  In single precision
    the order in double, if the defect is the same: rounding disturbs its own."""
    if along.double and along.as_double:
        return _order(along.double)
    finer, times = (along.fine, FINER) if along.fine_helps else (along.finest, FINEST)
    if finer is None or not (finer.relative and along.less(finer)):
        return 0.0
    return math.log(along.coarse.relative / finer.relative, times)
