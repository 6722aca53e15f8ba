"""Computes the quantities of `[outputs] record` along a trajectory, from its states."""

from dataclasses import dataclass, replace

import numpy as np

from coscrew_codegen.scene.recorded import Recorded, recorded
from coscrew_codegen.scene.selected import reactions
from coscrew_codegen.simulate import SimulateError
from coscrew_codegen.simulate.plan import Trajectory
from coscrew_codegen.simulate.recording import Column, Provenance, Recording
from coscrew_codegen.simulate.system import System

_AT_ONCE = 4096  # samples per call, so that temporaries of pure NumPy stay within megabytes


def record(system: System, trajectory: Trajectory, provenance: Provenance) -> Recording:
    """The columns that the scene records.  Raises SimulateError for a quantity whose function was
    not selected."""
    wanted = [recorded(text, system.scene) for text in system.scene.record]
    columns = {name: Column(name, unit, x.quantity)
               for x in wanted for name, unit in zip(x.names, x.units, strict=True)}
    names = [name for x in wanted for name in x.names]
    first = [names.index(name) for name in columns]  # duplicates are recorded once
    values = np.concatenate([quantity(system, trajectory, x) for x in wanted], 1)
    return Recording(trajectory.t, tuple(columns.values()), values[:, first], provenance)


def quantity(system: System, trajectory: Trajectory, wanted: Recorded) -> np.ndarray:
    """The quantity at each sample, in the system's precision.  (n, number of its columns)."""
    n = len(trajectory.t)
    parts = [_values(system, wanted, *(x[i:i + _AT_ONCE] for x in (
        trajectory.t, trajectory.q, trajectory.v))) for i in range(0, n, _AT_ONCE)]
    return np.concatenate(parts)[:, list(wanted.places)].astype(system.dtype)


def _values(system: System, wanted: Recorded, t: np.ndarray, q: np.ndarray, v: np.ndarray
            ) -> np.ndarray:
    """All components of the quantity.  (n), (n, nq), (n, nv)->(n, …)."""
    match wanted.quantity:
        case "q":
            return q
        case "v":
            return v
        case "a":
            return accelerations(system, t, q, v)
        case "energy":
            both = system.call("energy", t=t, q=q, v=v)
            return np.concatenate((both, both.sum(-1, keepdims=True)), -1)
        case "power":
            return system.call("power", t=t, q=q, v=v)[:, None]
        case "momentum":
            return system.call("momentum", t=t, q=q, v=v)
        case "reaction":
            a = accelerations(system, t, q, v)
            return system.call(reaction_name(system, wanted.target), t=t, q=q, v=v, a=a)
    body = [x.name for x in system.scene.model.bodies].index(wanted.target)
    if wanted.quantity == "twist":
        return system.call("body_twists", q=q, v=v)[:, body]
    pose = system.call("body_poses", q=q)[:, body]
    return pose[:, :, 3] if wanted.quantity == "position" else pose.reshape(len(q), 12)


def accelerations(system: System, t: np.ndarray, q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """a at tau = 0.  (n), (n, nq), (n, nv)->(n, nv)."""
    return system.call("forward_dynamics", t=t, q=q, v=v, tau=np.zeros_like(v))


def reaction_name(system: System, joint: str) -> str:
    """The function of a joint's reaction.  Raises SimulateError if it was not selected."""
    name = next(name for name, on in reactions(system.scene).items() if on == joint)
    if not system.has(name):
        raise SimulateError(f"reaction.{joint}: {name} is not among the selected functions; "
                            f"wanted functions = [\"default\", {name!r}]")
    return name


@dataclass(frozen=True)
class Difference:
    """The largest difference between the precisions in a quantity's columns."""

    quantity: str
    unit: str
    size: float  # largest |double| of the quantity
    apart: float  # largest |double - single|
    column: str  # that has it
    t: float


def differences(double: Recording, single: Recording) -> tuple[Difference, ...]:
    """The differences by quantity and unit, at the samples that both have."""
    n = min(len(double.t), len(single.t))
    found: dict[tuple[str, str], Difference] = {}
    for i, column in enumerate(double.columns):
        values = double.values[:n, i]
        apart = np.abs(values - single.values[:n, i].astype(float))
        worst, key = largest(apart), (column.quantity, column.unit)
        before = found.get(key)
        size = max(float(np.max(np.abs(values))), before.size if before else 0)
        new = Difference(*key, size, float(apart[worst]), column.name, float(double.t[worst]))
        found[key] = new if before is None or new.apart > before.apart or np.isnan(new.apart) \
            else replace(before, size=size)
    return tuple(found.values())


def largest(values: np.ndarray) -> int:
    """The index of the largest; NaN counts as the largest."""
    return int(np.argmax(np.where(np.isnan(values), np.inf, values)))
