"""Runs of a page: poses of all bodies and columns of numbers at the times that are shown; of a
result, of a recording in a file, and of the targets of actuators."""

from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

import coscrew
from coscrew_codegen.program.values.parameter import Scalar
from coscrew_codegen.scene.formulas import Formula
from coscrew_codegen.scene.function_selection import ALL_CONTACTS
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.recordings.recording_reader import columns_of
from coscrew_codegen.simulation.recordings.result import Result
from coscrew_codegen.simulation.system import System
from coscrew_codegen.simulation.view import page_signals
from coscrew_codegen.simulation.view.page_signals import Columns
from coscrew_codegen.simulation.view.part_places import number_of, numbers_of

_FRAMES_A_SECOND = 60
_MOST_NUMBERS = 2_000_000  # numbers in all poses: 8 MB, enough for a minute of thirty bodies


@dataclass(frozen=True, eq=False)
class PageRun:
    """A run as far as it is shown."""

    label: str
    t: np.ndarray  # (n)
    q: np.ndarray  # (n, nq)
    poses: np.ndarray  # (n, bodies, 7): position and unit quaternion x, y, z, w
    columns: Columns
    shown: bool = True  # from the start
    contacts: np.ndarray = field(default_factory=lambda: np.zeros((0, 0, 6), np.float32))
    """(n, contacts, 6): point and force in the world's frame; only of the result's own runs."""


def run_of(result: Result, label: str) -> PageRun:
    """The result's samples, up to the first whose poses overflow: at most 60 a second, and
    _MOST_NUMBERS in all."""
    system, trajectory = result.system, result.trajectory
    frames = _frames(trajectory.t, len(system.scene.model.bodies))
    columns = {x.name: result.recording.values[frames, i].astype(float)
               for i, x in enumerate(result.recording.columns)}
    t, q, v = (x[frames] for x in (trajectory.t, trajectory.q, trajectory.v))
    run = _finite(system, label, t, q, {**columns, **page_signals.energies(system, t, q, v)})
    n = len(run.t)
    return replace(run, contacts=_contacts(system, t[:n], q[:n], v[:n]))


def run_in(path: Path, system: System) -> PageRun:
    """The run that a recording's file holds.  Raises SimulateError if it is not one of the scene,
    or lacks coordinates."""
    t, columns = columns_of(path, "--view")
    q = np.zeros((len(t), system.functions.nq))
    for c in system.functions.coordinates:
        for i, place in enumerate(c.q):
            name = f"q.{c.joint}" if len(c.q) == 1 else f"q.{c.joint}.{i}"
            if name not in columns:
                raise SimulateError(f"--view: {path} has no column {name}; wanted a recording of "
                                    'all coordinates, as record = ["q"] makes it')
            q[:, place] = columns[name]
    frames = _frames(t, len(system.scene.model.bodies))
    return _finite(system, path.stem, t[frames], system.normalized(q[frames]),
                   {name: values[frames] for name, values in columns.items()})


def target_of(system: System, run: PageRun) -> PageRun | None:
    """The run with the targets of actuators in place of the coordinates that they drive; None if
    there are none.  Without kp an actuator drives the velocity alone."""
    q, columns = np.array(run.q, float), {}
    for applied in system.scene.effects:
        kp, target = map(applied.values.get, ("kp", "target"))
        if isinstance(kp, Scalar) and number_of(system, kp) == 0:
            continue
        for c in (x for x in system.functions.coordinates if x.joint == applied.on):
            if isinstance(target, Formula | Scalar):
                q[:, c.q.start] = [target.at(t) for t in run.t] if isinstance(target, Formula) \
                    else numbers_of(system, (target,))[0]
                columns[f"q.{c.joint}"] = q[:, c.q.start]
    return _finite(system, "target", run.t, q, columns, shown=False) if columns else None


def _finite(system: System, label: str, t: np.ndarray, q: np.ndarray, columns: Columns,
            shown: bool = True) -> PageRun:
    """The run up to the first sample whose poses are not finite in single precision."""
    poses = _poses(system, t, q)
    n = max(1, int(np.argmin([*np.isfinite(poses).all((1, 2)), False])))
    return PageRun(label, t[:n], q[:n], poses[:n],
                   {name: values[:n] for name, values in columns.items()}, shown)


def _contacts(system: System, t: np.ndarray, q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Point and force of each contact; zeros at samples next to none at which it touches."""
    if not system.has(ALL_CONTACTS):
        return np.zeros((len(t), 0, 6), np.float32)
    with np.errstate(all="ignore"):
        points, forces, *_ = (np.asarray(x, float) for x in system.outputs(
            ALL_CONTACTS, t=t, q=q, v=v))
        both = np.nan_to_num(np.concatenate((points, forces), -1)).astype(np.float32)
    touches = both[..., 3:].any(-1)
    near = touches.copy()
    near[1:] |= touches[:-1]
    near[:-1] |= touches[1:]
    return np.where(near[..., None], both, np.float32(0))


def _frames(t: np.ndarray, bodies: int) -> np.ndarray:
    """Indices of the samples shown, with the last."""
    most = max(2, min(int(_FRAMES_A_SECOND * (t[-1] - t[0])) + 2,
                      _MOST_NUMBERS // (7 * max(bodies, 1))))
    return np.unique(np.linspace(0, len(t) - 1, min(most, len(t))).round().astype(int))


def _poses(system: System, t: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Position and unit quaternion of each body at each time, in single precision, which is finer
    than pixels.  (frames, bodies, 7)."""
    D = np.asarray(system.call("body_poses", t=t, q=q), float).reshape(len(q), -1, 3, 4)
    turned = coscrew.double.quaternion_from_mat3x3(D[..., :3])
    with np.errstate(over="ignore"):
        return np.concatenate((D[..., 3], turned), -1).astype(np.float32)
