"""Runs that go on where another ended, to the last bit: its end, from a Result or a recording."""

import csv
import json
import math
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from coscrew_codegen.integrators import named
from coscrew_codegen.scene.content import content_hash
from coscrew_codegen.simulate import SimulateError
from coscrew_codegen.simulate.plan import Plan, Trajectory
from coscrew_codegen.simulate.system import System

END = "end"
"""What provenance calls the end of a run, as JSON."""


@dataclass(frozen=True)
class End:
    """The end of a run, or of each member of a batch: all that the following steps depend on."""

    t: float
    steps: int  # since t = 0, for a controller that is called every n steps
    q: np.ndarray  # (…, nq)
    v: np.ndarray  # (…, nv)
    p: np.ndarray  # (…, np)
    momentum: np.ndarray | None  # of floating bases at t = 0, if the run keeps it
    of: tuple[str, str] = ("", "")  # the precision's name and the scene's sha256

    @property
    def told(self) -> str:
        """JSON of a single run's end; the decimals read back the same."""
        arrays = {"q": self.q, "v": self.v, "p": self.p, "momentum": self.momentum}
        return json.dumps({"t": self.t, "steps": self.steps} | {
            name: np.asarray(values, float).tolist() for name, values in arrays.items()
            if values is not None})


def end_of(system: System, trajectory: Trajectory, before: int = 0) -> End:
    """The end of a run which `before` steps preceded that its own count leaves out."""
    p = np.asarray(system.p, system.dtype) if trajectory.held is None \
        else trajectory.held[..., -1, :]
    return End(float(trajectory.t[-1]), before + trajectory.steps, trajectory.q[..., -1, :],
               trajectory.v[..., -1, :], p, trajectory.momentum,
               (system.precision.name, content_hash(system.scene)))


def read(path: Path) -> End:
    """The end that a recording tells.  Raises SimulateError."""
    reader = _READERS.get(path.suffix)
    if reader is None:
        raise SimulateError(f"start: {path}: wanted a recording, {', '.join(_READERS)}")
    try:
        told = reader(path)
    except OSError as error:
        raise SimulateError(f"start: cannot read {path}: {error.strerror or error}") from None
    except Exception as error:  # noqa: BLE001  whatever a reader says of a broken file
        raise SimulateError(f"start: {path} is no recording: {error}") from None
    if END not in told:
        why = f": {told['stopped']}" if "stopped" in told else ""
        raise SimulateError(f"start: {path} does not tell the end of a run{why}; wanted a "
                            "recording of an emitted integrator that did not stop early")
    try:
        given = json.loads(told[END])
        q, v, p = (_numbers(given[name]) for name in ("q", "v", "p"))
        momentum = _numbers(given["momentum"]) if "momentum" in given else None
        t, steps = float(given["t"]), int(given["steps"])
        if not (math.isfinite(t) and t > 0 and steps >= 0):
            raise ValueError
    except (ValueError, TypeError, KeyError, AttributeError):
        raise SimulateError(f"start: {path}: its end is not as coscrew writes it") from None
    return End(t, steps, q, v, p, momentum, (told.get("precision", ""),
                                             told.get("scene sha256", "")))


def refuse(end: End, system: System, plan: Plan) -> None:
    """Raise SimulateError if a run of this system cannot go on from the end; warn if it is the end
    of another scene."""
    its, (precision, scene) = system.functions, end.of
    sizes = tuple(x.shape[-1] for x in (end.q, end.v, end.p))
    if sizes != (its.nq, its.nv, len(its.parameters)):
        raise SimulateError(
            f"start: another scene: {sizes[0]} coordinates, {sizes[1]} velocities, {sizes[2]} "
            f"parameters; wanted {its.nq}, {its.nv}, {len(its.parameters)}")
    if precision != system.precision.name:
        raise SimulateError(f"start: a run in {precision or 'unknown'} precision; wanted "
                            f"{system.precision.name}")
    if plan.adaptive:
        raise SimulateError(f"start: integrator {plan.integrator} begins with steps of its own; "
                            "wanted an emitted integrator")
    free = system.momentum(end.q, end.v)
    if end.momentum is not None and (free is None or free.shape != end.momentum.shape):
        raise SimulateError("start: another scene: the momentum of its floating bases differs in "
                            "size")
    if end.momentum is None and free is not None and named(plan.integrator).keeps_momentum:
        raise SimulateError("start: a run that did not keep the momentum of floating bases, as "
                            f"{plan.integrator} does; wanted the integrator of that run")
    if scene != content_hash(system.scene):
        warnings.warn("start: the recording is of another scene, or of one that has changed since",
                      RuntimeWarning, stacklevel=3)


def _numbers(values: object) -> np.ndarray:
    found = np.array(values, float)
    if not np.isfinite(found).all():
        raise ValueError
    return found


def _of_csv(path: Path) -> dict[str, str]:
    told = {}
    with path.open(encoding="utf-8", newline="") as file:
        for line in file:
            if not line.startswith("# "):
                if next(csv.reader([line]))[0] != "t [s]":
                    raise ValueError("its first column is not t [s]")
                break
            what, _, value = line[2:].rstrip("\n").partition(": ")
            told[what] = value
    return told


def _of_npz(path: Path) -> dict[str, str]:
    with np.load(path, allow_pickle=False) as file:
        return {str(what): str(value) for what, value in file["provenance"]}


def _of_parquet(path: Path) -> dict[str, str]:
    import pyarrow.parquet

    told: dict[str, str] = json.loads(pyarrow.parquet.read_schema(path).metadata[b"coscrew"])
    return told


_READERS: dict[str, Callable[[Path], dict[str, str]]] = {
    ".csv": _of_csv, ".npz": _of_npz, ".parquet": _of_parquet}

