"""Runs a scene in the selected precisions, records the runs, and prints a short table of them."""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from tabulate import tabulate

from coscrew_codegen.program.scene_functions import Coordinate
from coscrew_codegen.program.values.formats import BY_NAME
from coscrew_codegen.scene.functions.steps.step_parts import MOST_OF_CONTACTS
from coscrew_codegen.scene.integrators import DEFAULT, INTEGRATOR_NAMED
from coscrew_codegen.scene.joints import KIND_NAMED
from coscrew_codegen.scene.mechanism.assembly import without_chains
from coscrew_codegen.scene.mechanism.model import Joint
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.batch_inputs import values_of
from coscrew_codegen.simulation.check.contact_check import unresolved
from coscrew_codegen.simulation.checkpoint import end_in
from coscrew_codegen.simulation.execution import RunRequest, complete, motion
from coscrew_codegen.simulation.parameter_checks import ranges
from coscrew_codegen.simulation.recordings.record import Difference, differences
from coscrew_codegen.simulation.recordings.result import Result
from coscrew_codegen.simulation.system import System, scene_of

if TYPE_CHECKING:
    from coscrew_codegen.runtime.load import Kernels


_MANY = 3
"""Joints that a warning on speeds lists."""


@dataclass(frozen=True)
class RunOverrides:
    """Settings that override the scene's own; None: the scene's."""

    until: float | None = None
    step: float | None = None
    integrator: str | None = None
    precision: str | None = None
    settings: tuple[tuple[str, float], ...] = ()
    start: Path | None = None  # a recording whose run is continued


def simulated(kernels: "Kernels", overrides: RunOverrides, with_provenance: bool = True
              ) -> tuple[Result, ...]:
    """Runs the scene, in double first; recordings have their provenance only if requested.  Raises
    SimulateError."""
    precision = overrides.precision or scene_of(kernels).precision
    if overrides.start and precision == "both":
        raise SimulateError("--start: a recording is of one precision; wanted --precision double "
                            "or single")
    request = RunRequest(overrides.until, overrides.step, overrides.integrator,
                         start=end_in(overrides.start) if overrides.start else None)
    names = tuple(BY_NAME) if precision == "both" else (precision,)
    results: list[Result] = []
    for name in names:
        p = values_of(scene_of(kernels), BY_NAME[name], dict(overrides.settings), "--set ")
        results.append(motion(complete(kernels, request), name, replace(request, p=p), shown=True,
                              with_provenance=with_provenance))
        if results[-1].trajectory.interrupted:
            break
    return tuple(results)


def summary(results: tuple[Result, ...]) -> str:
    """The final state and the energies of each run, and the differences between precisions."""
    first = results[0]
    parts = [_heading(first), _states(results), _energies(results)]
    if len(results) == 2:
        parts.append(gaps(differences(*(x.recording for x in results))))
    return "\n\n".join(parts)


def gaps(differences: tuple[Difference, ...]) -> str:
    """The table of differences between the precisions."""
    rows = [(x.quantity, x.unit, x.size, x.apart, x.column, x.t) for x in differences]
    return str(tabulate(rows, ("quantity", "unit", "max |double|", "max |double - single|", "in",
                           "at t, s"), floatfmt=("", "", ".3g", ".3g", "", "g")))


def bounces(result: Result) -> str:
    """A warning that bounces are lost, if the integrator does not resolve them and a limit is hit
    in a step that the default integrator would split, or if that would need more parts of a step
    than contacts of bodies may have; else ""."""
    its, planned, run = result.system, result.plan, result.trajectory
    touching = any(x.effect.parts or x.effect.bodies_force for x in its.scene.effects)
    splits = planned.integrator == DEFAULT and touching
    if splits and not math.isnan(at := unresolved(its, run, planned.step)):
        return (f"a contact bounces too fast at t = {at:g} s for parts of steps of "
                f"{planned.step:g} s, {MOST_OF_CONTACTS} at most: it loses speed; take a smaller "
                "step, or a larger depth")
    if not (INTEGRATOR_NAMED[planned.integrator].damps_bounces and its.has("parts")):
        return ""
    with np.errstate(all="ignore"):
        closing = its.call("closing_contacts", h=planned.step, q=run.q, v=run.v) > 0
        parts = its.outputs("parts", h=planned.step, q=run.q, v=run.v)[0]
    if not np.any(closing & (parts > 1)):
        return ""
    return (f"limits close, and {planned.integrator} does not resolve bounces in steps of "
            f"{planned.step:g} s: they lose speed; integrator {DEFAULT} splits such steps")


def outside(its: System, q: np.ndarray) -> str:
    """A warning that names joints that start outside the range of a limit, which then acts from the
    start; else "". (…, nq): of several members it names the one farthest outside."""
    values = dict(zip((x for x, _ in its.functions.parameters), np.array(its.p).T, strict=True))
    start = {c.joint: _ranged(c, q) for c in its.functions.coordinates}
    model = its.scene.model
    chained = any(joint.mimic for joint in model.joints)
    for joint in (without_chains(model) if chained else model).joints:
        if joint.mimic and joint.name not in start:
            start[joint.name] = (float(joint.mimic.multiplier) * start[joint.mimic.joint]
                                 + float(joint.mimic.offset))
    results = []
    for limited, *ends in ranges(its.scene, values):
        if limited.on in start:
            x, low, high = (y.ravel() for y in np.broadcast_arrays(start[limited.on], *ends))
            rounding = 4 * np.finfo(q.dtype).eps * np.abs(x)  # of followers, and of the precision
            k = int(np.argmax(beyond := np.maximum(low - x, x - high) - rounding))
            if beyond[k] > 0:
                results.append(f"joint {limited.on} starts at {x[k]:g}, outside its range from "
                               f"{low[k]:g} to {high[k]:g}")
    return f"{'; '.join(results)}: pushed from the start" if results else ""


def _ranged(c: Coordinate, q: np.ndarray) -> np.ndarray:
    """The number that a range of a joint holds: its coordinate, or the angle of its turn."""
    own: np.ndarray = np.moveaxis(q[..., c.q.start:c.q.stop].astype(float), -1, 0)
    if not KIND_NAMED[c.kind].by_angle:
        return np.asarray(own[0])
    return np.asarray(2 * np.arctan2(np.linalg.norm(own[:3], axis=0), abs(own[3])))


def overspeed(result: Result) -> str:
    """A warning that names joints whose speed passes the model's limit at a sample, those that pass
    it most first; else "".  Of several members it is the fastest."""
    speeds = dict(_speeds(result))
    passed = []
    for joint in result.system.scene.model.joints:
        if joint.velocity and joint.name in speeds:
            v, limit = np.abs(speeds[joint.name]), float(joint.velocity)
            fastest = float(np.max(v, initial=0, where=np.isfinite(v)))
            if fastest > limit * (1 + 4 * float(np.finfo(result.v.dtype).eps)):
                unit = "m/s" if joint.kind.slides else "rad/s"
                passed.append((fastest / limit, f"joint {joint.name} moves at {fastest:.3g} {unit}"
                               f", above the model's limit, {limit:g} {unit}"))
    first = [words for _, words in sorted(passed, reverse=True)[:_MANY]]
    more = f"; likewise {len(passed) - _MANY} more" if len(passed) > _MANY else ""
    cure = "; [effects.speed_limit] brakes" if passed else ""
    return "; ".join(first) + more + cure


def _speeds(result: Result) -> Iterator[tuple[str, np.ndarray]]:
    """The velocities of joints with one, (…); those of followers are multiples of their leaders'.
    """
    of = {}
    for c in result.system.functions.coordinates:
        if len(c.v) == 1:
            of[c.joint] = result.v[..., c.v.start].astype(float)
    yield from of.items()
    yield from ((joint.name, of[joint.mimic.joint] * float(joint.mimic.multiplier))
                for joint in _followers(result)
                if joint.mimic and joint.name not in of and joint.mimic.joint in of)


def _followers(result: Result) -> tuple[Joint, ...]:
    model = result.system.scene.model
    return (without_chains(model) if any(x.mimic for x in model.joints) else model).joints


def _heading(result: Result) -> str:
    trajectory = result.trajectory
    begin, end, seconds = result.plan.begin, trajectory.t[-1], trajectory.seconds
    speed = f", {(end - begin) / seconds:.3g}x real time" if seconds > 0 else ""
    since = f"{begin:g} to " if begin else ""
    return (f"{result.system.scene.name}: {since}{end:g} s in {trajectory.steps} steps of "
            f"{result.plan.integrator}, {seconds:.3g} s{speed}")


def _states(results: tuple[Result, ...]) -> str:
    rows = []
    for c in results[0].system.functions.coordinates:
        for name, places in (("q", c.q), ("v", c.v)):
            for i, place in enumerate(places):
                label = f"{name}.{c.joint}" + (f".{i}" if len(places) > 1 else "")
                rows.append((label, *(getattr(x.trajectory, name)[-1, place] for x in results)))
    at = f"at t = {results[0].trajectory.t[-1]:g} s"
    return str(tabulate(rows, (at, *(x.system.precision.name for x in results)), floatfmt=(
        "", *(f".{x.system.precision.decimals}g" for x in results))))


def _energies(results: tuple[Result, ...]) -> str:
    """Energies at both ends.  The samples are too sparse for the work between them."""
    with np.errstate(all="ignore"):  # a run that stopped may end with huge numbers
        values = [_ends(x) for x in results]
    rows = [(f"energy at the {where}", *(x[i] for x in values))
            for i, where in enumerate(("start", "end"))]
    table = tabulate(rows, ("J", *(x.system.precision.name for x in results)), floatfmt=".9g")
    return f"{table}\n(`coscrew check` compares the change with the work of effects.)"


def _ends(result: Result) -> np.ndarray:
    """Energy in J at the start and at the end."""
    ends = [0, -1]
    t, q, v = (x[ends] for x in (result.trajectory.t, result.trajectory.q, result.trajectory.v))
    kinetic, potential = result.system.energies(t, q, v)
    total: np.ndarray = kinetic + potential
    return total
