"""Writes the findings of a check as text: tables, faults, remedies."""

import math

from tabulate import tabulate

from coscrew_codegen.simulation.check.check_rounding import DIGITS, Certified, RoundedResults
from coscrew_codegen.simulation.check.contact_check import sinks
from coscrew_codegen.simulation.check.error_limits import ALLOWED, ENERGY, STRICTLY
from coscrew_codegen.simulation.check.findings import THIRD_RUN, AlongRun, Findings, Met
from coscrew_codegen.simulation.loops.closure_check import WORK, Closures
from coscrew_codegen.simulation.result_units import in_unit
from coscrew_codegen.simulation.run_summary import gaps

_MOST = 12  # contacts that the table shows
_DEPTHS = "depths over those at rest, share of time that contacts slip"
_WIDE = 1000  # ratio of bounds to errors from which their number says nothing


def table(findings: Findings, strict: bool = False) -> str:
    """The findings as text; with `strict` also the faults that fail only the strict limits."""
    parts = [_expectations(findings.met)] if findings.met else []
    parts += [_checks(findings.along)]
    parts += [_each_contact(findings)] if any(x.contacts for x in findings.along) else []
    parts += [gaps(findings.apart)] if findings.apart else []
    parts += [_rounding(findings.rounding)] if findings.rounding else []
    parts += [x for x in (findings.outside, findings.mobility) if x]
    parts += [f"{x.precision}: closed loops pass a singular position at t = "
              f"{x.loops.singular_at:g} s, where rounding decides how they go on"
              for x in findings.along if x.loops and x.loops.singular]
    parts += [f"{x.precision}: {x.stopped}" for x in findings.along if x.stopped]
    parts += [f"FALSE: {x.precision}: {_false(x)}" for x in findings.along
              if not (x.passed or x.stopped)]
    parts += [f"FALSE: {x.precision}: {_broken(x)}" for x in findings.rounding
              if x.certified and x.certified.broken]
    parts += [f"FALSE with --strict: {x.precision}: {_strictly_false(x)}" for x in findings.along
              if strict and x.passed and not (x.strictly_passed or x.stopped)]
    return "\n\n".join(parts)


def _strictly_false(along: AlongRun) -> str:
    return f"{_off(along)}, allowed is {STRICTLY:g}"


def _expectations(met: tuple[Met, ...]) -> str:
    rows = [("pass" if x.passed else "FAIL", x.wanted.quantity, x.wanted.at, x.wanted.value, x.came,
             abs(x.came - x.wanted.value), x.wanted.rtol * abs(x.wanted.value) + x.wanted.atol,
             x.unit) for x in met]
    columns = ("", "expected", "at t, s", "value", "came", "apart", "allowed", "unit")
    return str(tabulate(rows, columns, floatfmt=("", "", "g", ".12g", ".12g", ".2g", ".2g", "")))


def _checks(along: tuple[AlongRun, ...]) -> str:
    rows = [("largest error of the motion, relative to the way a part moves",
             *(f"{x.error.relative:.2g} ({x.error.part})" if x.known else "unknown"
               for x in along)),
            ("compared with a motion in steps of, s",
             *(f"{x.smallest:.2g}" for x in along)),
            ("largest error of energy, relative",
             *(f"{x.coarse.relative:.2g}" for x in along)),
            ("the same with " + " or ".join(dict.fromkeys(_finer(x) for x in along)),
             *(f"{x.fine.relative:.2g}" for x in along)),
            ("cause of this error", *(_verdict(x) for x in along)),
            *([("largest error of the momentum of floating bases, relative",
                *(f"{x.coarse.momentum:.2g}" for x in along))]
              if any(x.coarse.momentum for x in along) else []),
            *_closures(along), *_contacts(along), *_bristles(along),
            ("forward after inverse dynamics: largest error, in u",
             *(f"{x.round_trip:.3g}" for x in along)),
            ("largest condition number of the mass matrix, SI units",
             *(f"{x.condition:.3g}" for x in along)),
            ("reached at t, s", *(f"{x.at:g}" for x in along))]
    columns = ("", *(f"{x.precision}, {x.step}" for x in along))
    return str(tabulate(rows, columns, disable_numparse=True,
                        colalign=("left", *("right" for _ in along))))


def _closures(along: tuple[AlongRun, ...]) -> list[tuple[str, ...]]:
    """Rows on closed loops."""
    loops = [x.loops for x in along if x.loops]
    if not loops:
        return []
    return [("largest gap of closed loops, in m or rad", *(f"{x.gap:.2g}" for x in loops)),
            ("fastest opening of closed loops, in m/s or rad/s",
             *(f"{x.rate:.2g}" for x in loops)),
            ("work of closures, relative to the energies moved", *(f"{x.work:.2g}" for x in loops)),
            ("nearest to a singular position: smallest over largest pivot",
             *(f"{x.ratio:.2g}, at t = {x.singular_at:g} s" for x in loops))]


def _contacts(along: tuple[AlongRun, ...]) -> list[tuple[str, ...]]:
    """Rows on contacts of bodies."""
    contacts = [x.contacts for x in along if x.contacts]
    if not contacts:
        return []
    return [("share of closed contacts in all, and of slipping ones in these",
             *(f"{x.closed:.2g}, {x.slipping:.2g}" for x in contacts)),
            ("least normal force of contacts, over the largest force",
             *(f"{x.least:.2g}" for x in contacts)),
            ("bounces that the parts of steps resolve",
             *("all" if math.isnan(x.unresolved) else f"not at t = {x.unresolved:g} s"
               for x in contacts))]


def _bristles(along: tuple[AlongRun, ...]) -> list[tuple[str, ...]]:
    """Rows on friction that holds."""
    bristles = [x.bristles for x in along if x.bristles]
    if not bristles:
        return []
    return [("dissipated by contacts and sticking joints, J",
             *(f"{x.dissipated:.3g}" for x in bristles)),
            ("most energy in bristles, J", *(f"{x.stored:.2g}" for x in bristles)),
            ("most that they give back, J", *(f"{x.returned:.2g}" for x in bristles))]


def _each_contact(findings: Findings) -> str:
    """A table of the contacts that ever close, the deepest first, or a line that none does."""
    its = [x.contacts.each for x in findings.along if x.contacts]
    order = sorted(range(len(its[0])), key=lambda i: -max(x[i].depth for x in its))
    closed = [i for i in order if any(x[i].closed for x in its)]
    if not closed:
        return "no contact closes"
    apart = findings.contact_distances
    rows = [(its[0][i].name, *(text for x in its for text in (
        f"{x[i].depth:.2f}", f"{x[i].at:g}", f"{x[i].ends:.2f}", f"{x[i].slipping:.2g}")),
        *([f"{apart[i]:.2g}"] if apart else [])) for i in closed[:_MOST]]
    columns = [text for x in findings.along if x.contacts
               for text in (f"deepest, {x.precision}", "at t, s", "at the end", "slips")]
    more = f"\nand {len(closed) - _MOST} less deep contacts" if len(closed) > _MOST else ""
    return str(tabulate(rows, (_DEPTHS, *columns, *(["apart, m"] if apart else [])),
                        disable_numparse=True, colalign=("left", *["right"] * (
                            len(rows[0]) - 1)))) + more


def _open(loops: Closures) -> str:
    """A sentence on loops that open, or whose closures do work, with the cause."""
    why = f"a singular position at t = {loops.singular_at:g} s is not resolved; run it in double" \
        if loops.singular else "take a smaller step"
    if loops.gap > loops.allowed:
        return (f"closed loops open by {loops.gap:.2g} m or rad at t = {loops.at:.4g} s, allowed "
                f"is {loops.allowed:.2g}: {why}")
    return (f"closures do work, {loops.work:.2g} of the energies moved, allowed is {WORK:g}: {why}")


def _rounding(results: tuple[RoundedResults, ...]) -> str:
    rows = [(f"{x.function}, {x.precision}", in_unit(x.error, x.unit), f"{x.at:g}",
             f"{x.digits:.1f}", f"{x.lost:.1f}", _bounds(x.certified)) for x in results]
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
    stated = f"{certified.stated} of {certified.of} " if certified.stated < certified.of else ""
    if certified.ratio is None:
        return f"{stated or 'all '}hold, results are exact"
    ratio = f"over {_WIDE}" if certified.ratio > _WIDE else f"{certified.ratio:#.3g}"
    return f"{stated or 'all '}hold, {ratio} times the error (median)"


def _broken(rounded: RoundedResults) -> str:
    """A sentence on the bound that is exceeded most."""
    assert rounded.certified and rounded.certified.broken
    worst = rounded.certified.broken
    return (f"{rounded.function}: component {worst.place} at t = {worst.t:g} s errs by "
            f"{worst.error:.3g}, beyond its certified bound {worst.bound:.3g}: this is a defect of "
            "coscrew or of the compiler; please report it with the scene")


def _false(along: AlongRun) -> str:
    """A sentence on a motion that is wrong or not known, or on energies that do not balance, with
    the cause and a remedy that was tried."""
    if not along.right:
        why = ("single precision does not resolve it" if along.by_rounding else
               "the step is too large" if along.length else "the tolerances are too large")
        return f"{_off(along)}, allowed is {ALLOWED:g}: {why}; {along.remedy}"
    if math.isnan(along.coarse.relative):
        return (f"energies or powers are not finite at t = {along.coarse.at:.4g} s: a formula of "
                "an effect is not finite, or numbers grow too large")
    if not along.resolved:
        until = f"; check a shorter run: --until {along.known:.3g}" if along.known else ""
        return (f"the motion is known only until t = {along.known:.3g} s: later, steps of "
                f"{along.smallest:.2g} s and larger ones give different motions, since it is "
                f"chaotic, or too stiff for them{until}")
    if along.loops and not along.loops.passed:
        return _open(along.loops)
    if along.contacts and (sunk := along.contacts.through):
        return sinks(sunk.name, sunk.at)
    if along.bristles and not along.bristles.passed:
        return (f"contacts or sticking joints return {along.bristles.returned:.2g} J of the "
                f"energy dissipated by t = {along.bristles.at:.4g} s, allowed is "
                f"{along.bristles.allowed:.2g} J: take a smaller step")
    if along.contacts and not along.contacts.passed:
        return (f"a contact pulls at t = {along.contacts.pulls_at:.4g} s, by "
                f"{-along.contacts.least:.2g} of the largest force: this is a defect of its law, "
                "or its numbers overflow")
    return (f"energy is off by {along.coarse.relative:.2g}, allowed is {ENERGY:g}, and neither "
            f"half the step nor 1/{THIRD_RUN} of it helps: the power of an effect is not that of "
            "its force, or changes between the samples")


def _off(along: AlongRun) -> str:
    return (f"{along.error.part} is off by {along.error.relative:.2g} of the way it moves, at t = "
            f"{along.error.t:.4g} s")


def _finer(along: AlongRun) -> str:
    return "a sixteenth of the tolerance" if along.step.startswith("rtol") else "half the step"


def _verdict(along: AlongRun) -> str:
    """The cause of the defect of energy."""
    if along.still or along.resting and not along.meaningless:
        return "none: nothing moves"
    if along.doubtful and along.balanced and not along.meaningless:
        return "small: smaller steps do not help"
    if along.doubtful:
        return "DOUBTFUL: smaller steps do not help"
    if along.meaningless:
        return "unknown: the potential energy's rounding exceeds the energy moved"
    if along.rounding:
        return "rounding"
    if along.step.startswith("rtol"):
        return "integrator: smaller tolerances help"
    order = along.order
    return f"integrator, of order {order:.1f}" if order else "integrator, as in double"
