"""Checkpoints: the start and the end of a run, with everything that the following steps depend on.
"""

import json
import math
import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path

import numpy as np

from coscrew_codegen.scene.integrators import INTEGRATOR_NAMED
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.plan import Plan, Stop, Trajectory
from coscrew_codegen.simulation.recordings.recording_reader import provenance_of
from coscrew_codegen.simulation.system import System

START, END = "start", "end"
"""Names in provenance of the first and the last checkpoint of a run, as JSON."""


@dataclass(frozen=True)
class Checkpoint:
    """State of a run, or of each member of a batch, at one time: everything that the following
    steps depend on."""

    t: float
    steps: int  # since t = 0, for a controller that is called every n steps
    q: np.ndarray  # (…, nq)
    v: np.ndarray  # (…, nv)
    p: np.ndarray  # (…, np)
    momentum: np.ndarray | None  # of floating bases at t = 0, if the run keeps it
    of: tuple[str, str] = ("", "")  # the precision's name and the scene's sha256
    failed: tuple[Stop, ...] = ()  # members that have stopped; their numbers are NaN
    controller: str = ""  # description, in provenance, of the previous run's controller

    @property
    def as_json(self) -> str:
        """The checkpoint as JSON, whose decimals read back the same; for a batch, a hash of the
        numbers."""
        arrays = {name: np.asarray(values, float) for name, values in (
            ("q", self.q), ("v", self.v), ("p", self.p), ("momentum", self.momentum))
            if values is not None}
        known: dict[str, object] = {"t": self.t, "steps": self.steps}
        if self.q.ndim < 2:
            return json.dumps(known | {name: x.tolist() for name, x in arrays.items()})
        axes = {"momentum": 2}  # of one member
        rows = [np.broadcast_to(x, (len(self.q), *x.shape[-axes.get(name, 1):])).reshape(
            len(self.q), -1) for name, x in arrays.items()]
        numbers = np.concatenate(rows, -1).astype("<f8")
        numbers[np.isnan(numbers)] = np.nan
        return json.dumps(known | {"members": len(self.q),
                                   "sha256": sha256(numbers.tobytes()).hexdigest()})


def start_at(system: System, q: np.ndarray, v: np.ndarray, momentum: np.ndarray | None
             ) -> Checkpoint:
    """The start of a run at t = 0."""
    return Checkpoint(0.0, 0, q, v, np.asarray(system.p, float), momentum, of_run(system))


def end_of(system: System, trajectory: Trajectory, start: Checkpoint) -> Checkpoint:
    """The end of a run from this start."""
    p = np.asarray(system.p, float)
    if trajectory.held is not None:
        held = trajectory.held[..., -1, :]  # not finite: of members that stopped
        p = np.where(np.isfinite(held) & (held != p.astype(held.dtype)), held, p)
    return Checkpoint(float(trajectory.t[-1]), start.steps + trajectory.steps,
                      trajectory.q[..., -1, :], trajectory.v[..., -1, :], p, trajectory.momentum,
                      of_run(system), trajectory.failed)


def of_run(system: System) -> tuple[str, str]:
    """The precision's name and the scene's hash."""
    return system.precision.name, system.scene.motion_hash


def end_in(path: Path) -> Checkpoint:
    """Reads the end of the run from a recording.  Raises SimulateError."""
    entries = provenance_of(path, "start")
    if END not in entries:
        why = f": {entries['stopped']}" if "stopped" in entries else ""
        raise SimulateError(f"start: {path} does not contain the end of a run{why}; wanted a "
                            "recording of an emitted integrator that did not stop early")
    return checkpoint_in(entries, END, f"start: {path}: its end")


def checkpoint_in(entries: Mapping[str, str], which: str, prefix: str) -> Checkpoint:
    """Reads the first or the last checkpoint from provenance.  Raises SimulateError."""
    try:
        given = json.loads(entries[which])
        q, v, p = (_numbers(given[name], 1) for name in ("q", "v", "p"))
        momentum = _numbers(given["momentum"], 2) if "momentum" in given else None
        t, steps = float(given["t"]), given["steps"]
        begun = t > 0 or which == START and t == 0
        if not (type(steps) is int and steps >= 0 and math.isfinite(t) and begun):
            raise ValueError
    except (ValueError, TypeError, KeyError, AttributeError, OverflowError, RecursionError):
        raise SimulateError(f"{prefix} is not as coscrew writes it") from None
    return Checkpoint(t, steps, q, v, p, momentum, (entries.get("precision", ""),
                                                    entries.get("scene sha256", "")),
                      controller=entries.get("controller", ""))


def refuse(start: Checkpoint, system: System) -> None:
    """Raises SimulateError if no run of this system can begin there; warns if it is of another
    scene."""
    its, (precision, scene) = system.functions, start.of
    sizes = tuple(x.shape[-1] for x in (start.q, start.v, start.p))
    if sizes != (its.nq, its.nv, len(its.parameters)):
        raise SimulateError(
            f"start: another scene: {sizes[0]} coordinates, {sizes[1]} velocities, {sizes[2]} "
            f"parameters; wanted {its.nq}, {its.nv}, {len(its.parameters)}")
    if precision != system.precision.name:
        raise SimulateError(f"start: a run in {precision or 'unknown'} precision; wanted "
                            f"{system.precision.name}")
    free = system.momentum(start.q, start.v)
    if start.momentum is not None and (
            free is None or free.shape[-2:] != start.momentum.shape[-2:]):
        raise SimulateError("start: another scene: the momentum of its floating bases differs in "
                            "size")
    if scene != of_run(system)[1]:
        warnings.warn("start: the recording is of another scene, or of one that has changed since",
                      RuntimeWarning, stacklevel=5)


def refuse_plan(start: Checkpoint, system: System, plan: Plan) -> None:
    """Raises SimulateError if the integrator cannot continue from there."""
    if plan.adaptive and start.t > 0:
        raise SimulateError(f"start: integrator {plan.integrator} begins with steps of its own; "
                            "wanted an emitted integrator")
    free = system.has("free_momentum")
    if start.momentum is None and free and INTEGRATOR_NAMED[plan.integrator].keeps_momentum:
        raise SimulateError("start: a run that did not keep the momentum of floating bases, as "
                            f"{plan.integrator} does; wanted the integrator of that run")


def _numbers(values: object, axes: int) -> np.ndarray:
    result = np.array(values, float)
    if result.ndim != axes or not np.isfinite(result).all():
        raise ValueError
    return result
