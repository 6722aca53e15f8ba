"""Runs of a scene in the selected precisions, their recordings, and a short table of them."""

import math
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from tabulate import tabulate

from coscrew_codegen.formats import BY_NAME
from coscrew_codegen.integrators import DEFAULT, named
from coscrew_codegen.scene.mimics import without_chains
from coscrew_codegen.simulate import SimulateError
from coscrew_codegen.simulate.alarm import Alarm
from coscrew_codegen.simulate.members import start_of, with_parameters
from coscrew_codegen.simulate.onward import read, refuse
from coscrew_codegen.simulate.plan import Plan, Trajectory, plan
from coscrew_codegen.simulate.progress import Progress
from coscrew_codegen.simulate.record import Difference, differences, record
from coscrew_codegen.simulate.recording import Recording
from coscrew_codegen.simulate.run import integrate
from coscrew_codegen.simulate.settings import ranges
from coscrew_codegen.simulate.system import System, scene_of, system

if TYPE_CHECKING:
    from coscrew_codegen.simulate.load import Kernels


@dataclass(frozen=True)
class RunOverrides:
    """Settings that override the scene's own; None: the scene's."""

    until: float | None = None
    step: float | None = None
    integrator: str | None = None
    precision: str | None = None
    settings: tuple[tuple[str, float], ...] = ()
    start: Path | None = None  # a recording to go on from


@dataclass(frozen=True)
class Outcome:
    """A run in one precision."""

    system: System
    plan: Plan
    trajectory: Trajectory
    recording: Recording


def simulated(kernels: "Kernels", overrides: RunOverrides, also: tuple[float, ...] = (),
              told: bool = True) -> tuple[Outcome, ...]:
    """The runs, double first.  `also` are further times to sample at; without `told`, recordings
    have no provenance.  Raises SimulateError."""
    precision = overrides.precision or scene_of(kernels).precision
    if overrides.start and precision == "both":
        raise SimulateError("--start: a recording is of one precision; wanted --precision double "
                            "or single")
    names = tuple(BY_NAME) if precision == "both" else (precision,)
    outcomes: list[Outcome] = []
    for name in names:
        outcomes.append(_run(kernels, name, overrides, also, told))
        if outcomes[-1].trajectory.interrupted:
            break
    return tuple(outcomes)


def _run(kernels: "Kernels", precision: str, overrides: RunOverrides, also: tuple[float, ...],
         told: bool) -> Outcome:
    its = system(kernels, precision, dict(overrides.settings))
    end = read(overrides.start) if overrides.start else None
    if end:
        its = with_parameters(its.at(end.p), dict(overrides.settings))
    planned = plan(its, overrides.until, overrides.step, overrides.integrator, also=also,
                   begin=end.t if end else 0.0)
    if end:
        refuse(end, its, planned)
    state = start_of(its, None, None, end)
    with Progress(its, planned.until) as watch:
        trajectory = integrate(its, planned, watch, Alarm, state,
                               momentum=end.momentum if end else None)
    origin: tuple[tuple[str, str], ...] = ()
    if told:
        from coscrew_codegen.simulate.provenance import provenance, started  # slow: runs Git

        origin = provenance(its, planned, trajectory, kernels.compiler or "none: NumPy",
                            started(planned.begin, *state) if end else "",
                            before=end.steps if end else 0)
    return Outcome(its, planned, trajectory, record(its, trajectory, origin))


def summary(outcomes: tuple[Outcome, ...]) -> str:
    """The final state and the energies of each run, and the differences between precisions."""
    first = outcomes[0]
    parts = [_heading(first), _states(outcomes), _energies(outcomes)]
    if len(outcomes) == 2:
        parts.append(gaps(differences(*(x.recording for x in outcomes))))
    return "\n\n".join(parts)


def gaps(found: tuple[Difference, ...]) -> str:
    """The table of differences between the precisions."""
    rows = [(x.quantity, x.unit, x.size, x.apart, x.column, x.t) for x in found]
    return str(tabulate(rows, ("quantity", "unit", "max |double|", "max |double - single|", "in",
                           "at t, s"), floatfmt=("", "", ".3g", ".3g", "", "g")))


def bounces(outcome: Outcome) -> str:
    """A warning that bounces are lost, if the integrator does not resolve them and a limit is hit
    in a step that the default integrator would split; else ""."""
    its, planned, run = outcome.system, outcome.plan, outcome.trajectory
    if not (named(planned.integrator).damps_bounces and its.has("parts")):
        return ""
    with np.errstate(all="ignore"):
        closing = its.call("closing_contacts", h=planned.step, q=run.q, v=run.v) > 0
        parts = its.outputs("parts", h=planned.step, q=run.q, v=run.v)[0]
    if not np.any(closing & (parts > 1)):
        return ""
    return (f"limits close, and {planned.integrator} does not resolve bounces in steps of "
            f"{planned.step:g} s: they lose speed; integrator {DEFAULT} splits such steps")


def outside(its: System) -> str:
    """A warning that names joints that start outside the range of a limit, which then acts from the
    start; else ""."""
    names = (name for name, _ in its.functions.parameters)
    start = {c.joint: its.scene.start_q.get(c.joint, (its.functions.neutral[c.q.start],))[0]
             for c in its.functions.coordinates}
    for joint in without_chains(its.scene.model).joints:
        if joint.mimic and joint.name not in start:
            start[joint.name] = float(joint.mimic.multiplier * Fraction(start[joint.mimic.joint])
                                      + joint.mimic.offset)
    found = [f"joint {limited.on} starts at {start[limited.on]:g}, outside its range from {low:g} "
             f"to {high:g}"
             for limited, low, high in ranges(its.scene, dict(zip(names, its.p, strict=True)))
             if limited.on in start and not _within(start[limited.on], low, high)]
    return f"{'; '.join(found)}: pushed from the start" if found else ""


def _within(x: float, low: float, high: float) -> bool:
    """Whether x is in the range, except for rounding: a follower's position is computed."""
    return low <= x <= high or any(math.isclose(x, end, rel_tol=1e-12) for end in (low, high))


def _heading(outcome: Outcome) -> str:
    trajectory = outcome.trajectory
    begin, end, seconds = outcome.plan.begin, trajectory.t[-1], trajectory.seconds
    speed = f", {(end - begin) / seconds:.3g}x real time" if seconds > 0 else ""
    since = f"{begin:g} to " if begin else ""
    return (f"{outcome.system.scene.name}: {since}{end:g} s in {trajectory.steps} steps of "
            f"{outcome.plan.integrator}, {seconds:.3g} s{speed}")


def _states(outcomes: tuple[Outcome, ...]) -> str:
    rows = []
    for c in outcomes[0].system.functions.coordinates:
        for name, places in (("q", c.q), ("v", c.v)):
            for i, place in enumerate(places):
                label = f"{name}.{c.joint}" + (f".{i}" if len(places) > 1 else "")
                rows.append((label, *(getattr(x.trajectory, name)[-1, place] for x in outcomes)))
    at = f"at t = {outcomes[0].trajectory.t[-1]:g} s"
    return str(tabulate(rows, (at, *(x.system.precision.name for x in outcomes)), floatfmt=(
        "", *(f".{x.system.precision.decimals}g" for x in outcomes))))


def _energies(outcomes: tuple[Outcome, ...]) -> str:
    """Energies at both ends.  The samples are too sparse for the work between them."""
    with np.errstate(all="ignore"):  # a run that stopped may end with huge numbers
        found = [_ends(x) for x in outcomes]
    rows = [(f"energy at the {where}", *(x[i] for x in found))
            for i, where in enumerate(("start", "end"))]
    table = tabulate(rows, ("J", *(x.system.precision.name for x in outcomes)), floatfmt=".9g")
    return f"{table}\n(`coscrew check` compares the change with the work of effects.)"


def _ends(outcome: Outcome) -> np.ndarray:
    """Energy in J at the start and at the end."""
    ends = [0, -1]
    t, q, v = (x[ends] for x in (outcome.trajectory.t, outcome.trajectory.q, outcome.trajectory.v))
    kinetic, potential = outcome.system.energies(t, q, v)
    total: np.ndarray = kinetic + potential
    return total
