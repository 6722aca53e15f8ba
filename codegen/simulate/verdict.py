"""The findings of a check as text: tables, what is false, what helps."""

import math

from tabulate import tabulate

from coscrew_codegen.formats import DOUBLE
from coscrew_codegen.integrators import DEFAULT
from coscrew_codegen.simulate import advice
from coscrew_codegen.simulate.check_rounding import DIGITS, Certified, Rounded
from coscrew_codegen.simulate.findings import (
    ALLOWED,
    FINEST,
    STRICTLY,
    Along,
    Findings,
    Met,
)
from coscrew_codegen.simulate.outcome import gaps
from coscrew_codegen.simulate.units import in_unit


def table(findings: Findings, strict: bool = False) -> str:
    """The findings as text; with what fails `strict` alone, if that is given."""
    parts = [_expectations(findings.met)] if findings.met else []
    parts += [_checks(findings.along)]
    parts += [gaps(findings.apart)] if findings.apart else []
    parts += [_rounding(findings.rounding)] if findings.rounding else []
    parts += [findings.outside] if findings.outside else []
    parts += [f"{x.precision}: {x.stopped}" for x in findings.along if x.stopped]
    parts += [f"FALSE: {x.precision}: {_false(x)}" for x in findings.along
              if not (x.true or x.stopped)]
    parts += [f"FALSE: {x.precision}: {_broken(x)}" for x in findings.rounding
              if x.certified and x.certified.broken]
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
    rows = [("largest error of energy, relative",
             *(f"{x.coarse.relative:.2g}" for x in along)),
            ("the same with " + " or ".join(dict.fromkeys(_finer(x) for x in along)),
             *(f"{x.fine.relative:.2g}" for x in along)),
            ("cause of this error", *(_verdict(x) for x in along)),
            ("largest change of a joint's velocity with smaller steps",
             *(f"{x.speeds[0]:.2g} ({x.speeds[1]})" for x in along)),
            *([("largest error of the momentum of floating bases, relative",
                *(f"{x.coarse.momentum:.2g}" for x in along))]
              if any(x.coarse.momentum for x in along) else []),
            ("forward after inverse dynamics: largest error, in u",
             *(f"{x.round_trip:.3g}" for x in along)),
            ("largest condition number of the mass matrix, SI units",
             *(f"{x.condition:.3g}" for x in along)),
            ("reached at t, s", *(f"{x.at:g}" for x in along))]
    columns = ("", *(f"{x.precision}, {x.step}" for x in along))
    return str(tabulate(rows, columns, disable_numparse=True,
                        colalign=("left", *("right" for _ in along))))


def _rounding(found: tuple[Rounded, ...]) -> str:
    rows = [(f"{x.function}, {x.precision}", in_unit(x.error, x.unit), f"{x.at:g}",
             f"{x.digits:.1f}", f"{x.lost:.1f}", _bounds(x.certified)) for x in found]
    columns = (f"at states of the run, against {DIGITS} digits", "largest error",
               "at t, s", "digits right", "digits lost", "certified bounds")
    return str(tabulate(rows, columns, disable_numparse=True,
                        colalign=("left", *["right"] * 4, "left")))


def _bounds(certified: Certified | None) -> str:
    if certified is None:
        return 'not computed: large; select tiers = ["certified"]'
    if certified.broken:
        return "BROKEN"
    if not certified.stated:
        return f"0 of {certified.of} stated"
    said = f"{certified.stated} of {certified.of} " if certified.stated < certified.of else ""
    return f"{said or 'all '}hold, {certified.ratio:#.3g} times the error (median)"


def _broken(found: Rounded) -> str:
    """A sentence on the bound that is exceeded most."""
    assert found.certified and found.certified.broken
    worst = found.certified.broken
    return (f"{found.function}: component {worst.place} at t = {worst.t:g} s errs by "
            f"{worst.error:.3g}, beyond its certified bound {worst.bound:.3g}: this is a defect of "
            "coscrew or of the compiler; please report it with the scene")


def _false(along: Along) -> str:
    """A sentence on a defect beyond the allowed one, with its cause and a remedy; else ""."""
    energy = not along.energy
    if not (energy or along.fine_energy):
        return (f"energy is off by {along.coarse.relative:.2g}, but by {along.fine.relative:.2g} "
                f"with {_finer(along)}, allowed is {ALLOWED:g}: what the scene asks is not "
                f"resolved{_or_double(along)}")
    what, off = (("energy", along.coarse.relative) if energy
                 else ("momentum", along.coarse.momentum))
    said = f"{what} is off by {off:.2g}, allowed is {ALLOWED:g}"
    name = along.integrator.name
    if energy and along.doubtful:
        tried = (f"neither half the step nor 1/{FINEST} of it helps" if along.finest
                 else "smaller steps do not help")
        other = f"; integrator {DEFAULT} splits steps in which limits close"
        return (f"{said}, and {tried}: what the scene asks is not resolved{_or_double(along)}"
                f"{other if along.limits and name != DEFAULT else ''}")
    if not along.length:
        return f"{said}; take a smaller rtol{_or_double(along)}"
    other = "" if name == DEFAULT else f", or integrator {DEFAULT}"
    return f"{said}: {_smaller(along)}{other}"


def _smaller(along: Along) -> str:
    """What is too long, and the step to take; in double, unless single precision resolves it."""
    if not along.energy and along.part < math.inf:
        long = ("the parts are too long in which steps are taken while limits are closed, "
                f"{along.part:.2g} s and more")
        take, other = f"take a step of {advice.step(along):.1g} s", ", or softer limits"
    else:
        long, take = "the step is too large", f"take one {advice.factor(along):.1g} times as long"
        other = ""
    double = along.precision != DOUBLE.name and not along.helps
    why = ", since single precision does not resolve it" if along.helps is False else ""
    return f"{long}; {take}{f' with --precision double{why}' if double else ''}{other}"


def _or_double(along: Along) -> str:
    """Double precision as a remedy, unless it does not help either."""
    if along.precision == DOUBLE.name or (along.double and not along.double.true):
        return ""
    return "; take --precision double"


def _finer(along: Along) -> str:
    return "a sixteenth of the tolerance" if along.step.startswith("rtol") else "half the step"


def _verdict(along: Along) -> str:
    """The cause of the defect of energy."""
    if along.still:
        return "none: nothing moves"
    if along.doubtful:
        return "DOUBTFUL: smaller steps do not help"
    if along.untold:
        return "unknown: potential energy rounds by more than moved"
    if along.rounding:
        return "rounding"
    if along.step.startswith("rtol"):
        return "integrator: smaller tolerances help"
    order = advice.order(along)
    return f"integrator, of order {order:.1f}" if order else "integrator, as in double"
