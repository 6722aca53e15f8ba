"""Computes the quantities of `[outputs] record` along a trajectory, from its states."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import prod

import numpy as np

from coscrew_codegen.scene.names import listed
from coscrew_codegen.scene.recorded_quantities import (
    QuantityError,
    Recorded,
    quantities_of,
    recorded,
)
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.plan import Trajectory
from coscrew_codegen.simulation.recordings.recording import Column, Provenance, Recording
from coscrew_codegen.simulation.system import System

_AT_ONCE = 4096  # samples per call, so that temporaries of pure NumPy stay within megabytes


def quantities(given: object, scene: Scene | None = None) -> tuple[str, ...]:
    """The names of the quantities to record; with a scene, patterns are expanded.  Raises
    SimulateError."""
    names = listed("record", given, "energy", SimulateError)
    if not names:
        raise SimulateError('record: an empty list; wanted quantities, as ["q", "v"]')
    if scene is None:
        return names
    try:
        return quantities_of(names, scene)
    except QuantityError as error:
        raise SimulateError(f"record: {error}") from None


def record(system: System, trajectory: Trajectory, provenance: Provenance,
           wanted: Sequence[str] | None = None, columns: Sequence[Recorded] | None = None
           ) -> Recording:
    """Computes the columns that the scene records, or the `wanted` ones.  Raises SimulateError for
    a quantity whose function was not selected."""
    texts = system.scene.record if wanted is None else wanted
    results = columns or [recorded(text, system.scene) for text in texts]
    by_name = {name: Column(name, unit, x.quantity)
               for x in results for name, unit in zip(x.names, x.units, strict=True)}
    names = [name for x in results for name in x.names]
    first = [names.index(name) for name in by_name]  # duplicates are recorded once
    values = np.concatenate([quantity(system, trajectory, x) for x in results], -1)
    return Recording(trajectory.t, tuple(by_name.values()), values[..., first], provenance)


def quantity(system: System, trajectory: Trajectory, wanted: Recorded) -> np.ndarray:
    """The quantity at each sample, in the system's precision.  (…, n, number of its columns)."""
    if not wanted.function:  # q, v or x, the end of q: those of a joint, or all, are neighbours
        states: np.ndarray = trajectory.v if wanted.quantity == "v" else trajectory.q
        return states[..., wanted.places[0]:wanted.places[-1] + 1]
    n, members = len(trajectory.t), prod(trajectory.q.shape[:-2])
    at_once = max(1, _AT_ONCE // max(1, members))
    parts = []
    with np.errstate(all="ignore"):  # members that stopped
        for i in range(0, n, at_once):
            t, q, v = trajectory.t[i:i + at_once], *(
                x[..., i:i + at_once, :] for x in (trajectory.q, trajectory.v))
            p = system.p_of_samples if trajectory.held is None \
                else trajectory.held[..., i:i + at_once, :]
            parts.append(_values(system.at(p), wanted, t, q, v))
    return np.concatenate(parts, -2).astype(system.dtype)


def _values(system: System, wanted: Recorded, t: np.ndarray, q: np.ndarray, v: np.ndarray
            ) -> np.ndarray:
    """The quantity's components: results of its function, or sums of them.
    (n), (…, n, nq), (…, n, nv)->(…, n, k)."""
    results = _results(system, wanted, t, q, v)
    return np.stack([results[..., list(places)].sum(-1) if len(places) > 1
                     else results[..., places[0]] for places in wanted.sums], -1)


def _results(system: System, wanted: Recorded, t: np.ndarray, q: np.ndarray, v: np.ndarray
             ) -> np.ndarray:
    """All components of all results of the function of the quantity."""
    if not system.has(wanted.function):
        raise _unselected(wanted.text, wanted.function)
    outputs, given = system.described(wanted.function).outputs, {"tau": np.zeros_like(v)}
    if wanted.takes_a:
        given["a"] = accelerations(system, t, q, v)
    result = system.call(wanted.function, t=t, q=q, v=v, **given)
    several = result if len(outputs) > 1 else (result,)
    lead = np.broadcast_shapes(q.shape[:-1], t.shape)
    return np.concatenate([
        np.broadcast_to(np.asarray(x), (*lead, *shape)).reshape(*lead, -1)
        for x, (_, shape) in zip(several, outputs, strict=True)], -1)


def accelerations(system: System, t: np.ndarray, q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """a at tau = 0.  (n), (…, n, nq), (…, n, nv)->(…, n, nv)."""
    return system.call("forward_dynamics", t=t, q=q, v=v, tau=np.zeros_like(v))


def _unselected(quantity: str, function: str) -> SimulateError:
    return SimulateError(f"{quantity}: {function} is not among the selected functions; "
                         f"wanted functions = [\"default\", \"{function}\"]")


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
    """The differences by quantity and unit, at the common samples."""
    n = min(len(double.t), len(single.t))
    results: dict[tuple[str, str], Difference] = {}
    for i, column in enumerate(double.columns):
        values = double.values[:n, i]
        apart = np.abs(values - single.values[:n, i].astype(float))
        worst, key = largest(apart), (column.quantity, column.unit)
        before = results.get(key)
        size = max(float(np.max(np.abs(values))), before.size if before else 0)
        new = Difference(*key, size, float(apart[worst]), column.name, float(double.t[worst]))
        results[key] = new if before is None or new.apart > before.apart or np.isnan(new.apart) \
            else replace(before, size=size)
    return tuple(results.values())


def largest(values: np.ndarray) -> int:
    """The index of the largest; NaN counts as the largest."""
    return int(np.argmax(np.where(np.isnan(values), np.inf, values)))
