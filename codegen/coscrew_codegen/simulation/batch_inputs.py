"""Converts parameters and starts of a run to arrays, which have a leading axis in a batch."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import ArrayLike

from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.scene.joints import KIND_NAMED
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.checkpoint import Checkpoint
from coscrew_codegen.simulation.parameter_checks import dependent, refuse_each, refuse_together
from coscrew_codegen.simulation.system import State, System

_OF_NORM = 1e-6
_ROUNDED = 4  # spacings by which rounding may move the norm of a quaternion
Parameters = Mapping[str, ArrayLike] | ArrayLike | None
Values = Mapping[str, np.ndarray]
"""Values of parameters by name: one, or one for each member."""


def values_of(scene: Scene, precision: Precision, given: Parameters, prefix: str = "p: ") -> Values:
    """Returns the parameters by name, from values by name or from all values in order; each value,
    or row of values, is one or one for each member.  `said` stands before their names in errors.
    Raises SimulateError."""
    names = tuple(x.name for x in scene.parameters)
    if given is None:
        return {}
    if isinstance(given, Mapping):
        if unnamed := [name for name in given if not isinstance(name, str)]:
            raise SimulateError(f"{prefix}{unnamed[0]!r}: wanted the name of a parameter")
        results = {name: _numbers(f"{prefix}{name}", value, ()) for name, value in given.items()}
    else:
        rows = _numbers("p", given, (len(names),))
        results = dict(zip(names, np.moveaxis(rows, -1, 0), strict=True))
    _as_many({f"{prefix}{name}": x.shape for name, x in results.items()})
    _refuse(scene, precision, results, prefix)
    return results


def with_parameters(system: System, by_name: Values) -> System:
    """The system with these parameters."""
    names = tuple(name for name, _ in system.functions.parameters)
    own = np.moveaxis(np.asarray(system.p, float), -1, 0)
    columns = [by_name.get(name, x) for name, x in zip(names, own, strict=True)]
    if not any(np.ndim(x) for x in columns):
        return system.at(np.array(columns, float))
    return system.at(np.stack(np.broadcast_arrays(*columns), -1))


def start_of(system: System, q0: ArrayLike | None, v0: ArrayLike | None,
             start: Checkpoint | None = None) -> State:
    """q and v at the start, of all members if there is a batch; by default those of `start`, or the
    scene's."""
    (q, v), its = (start.q.astype(system.dtype), start.v.astype(system.dtype)) if start \
        else system.written_start(), system.functions
    with np.errstate(over="ignore"):  # `integrate` refuses infinities
        if q0 is not None:
            q = normalize_quaternions(system, _numbers("q0", q0, (its.nq,))).astype(system.dtype)
        if v0 is not None:
            v = _numbers("v0", v0, (its.nv,)).astype(system.dtype)
    leads = {name: x.shape[:-1] for name, x in (("p", np.array(system.p)), ("q0", q), ("v0", v))}
    lead = _as_many(leads)
    q, v = (np.broadcast_to(x, (*lead, x.shape[-1])).copy() for x in (q, v))
    if start is None and q0 is None:
        q = system.with_rotors(q, v)
    return (q, v) if start and q0 is None and v0 is None else system.closed(q, v)


def _as_many(leads: Mapping[str, tuple[int, ...]]) -> tuple[int, ...]:
    """The leading axis that all arrays with one share.  Raises SimulateError."""
    counts = {name: lead[0] for name, lead in leads.items() if lead}
    if len(set(counts.values())) > 1:
        raise SimulateError("wanted as many members everywhere; got "
                            + ", ".join(f"{n} of {name}" for name, n in counts.items()))
    return tuple(counts.values())[:1]


def normalize_quaternions(system: System, q: np.ndarray) -> np.ndarray:
    """Normalizes the quaternions in q, whose norms must be 1 within 1e-6, as in a scene's file.
    Quaternions already unit to working precision stay unchanged, so that a run's states reproduce
    exactly.  Raises SimulateError."""
    least = _ROUNDED * float(np.finfo(system.dtype).eps)
    for c in system.functions.coordinates:
        for quaternion in KIND_NAMED[c.kind].quaternions:
            places = c.q[quaternion]
            norms = np.linalg.norm(q[..., places], axis=-1)
            if (wrong := np.abs(norms - 1) > _OF_NORM).any():
                raise SimulateError(f"q0: joint {c.joint}: a quaternion of norm "
                                    f"{norms[wrong].flat[0]:.9g}; wanted 1 within {_OF_NORM:g}, as "
                                    "(x, y, z, w)")
            q[..., places] /= np.where(np.abs(norms - 1) > least, norms, 1)[..., None]
    return q


def _numbers(name: str, given: ArrayLike, shape: tuple[int, ...]) -> np.ndarray:
    """The numbers, in double, of this shape or with a leading axis of members."""
    try:
        result = np.asarray(given)
        if result.dtype.kind not in "iuf" or isinstance(given, np.ma.MaskedArray):
            raise TypeError
        result = result.astype(float)
    except (TypeError, ValueError):
        raise SimulateError(f"{name}: wanted real numbers; got {given!r}") from None
    lead = result.shape[:max(0, result.ndim - len(shape))]
    if result.shape[len(lead):] != shape or len(lead) > 1 or lead == (0,):
        wanted = f"({', '.join(map(str, shape))})" if shape else "a number"
        several = f"(members, {', '.join(map(str, shape))})" if shape else "one for each member"
        raise SimulateError(f"{name}: wanted {wanted} or {several}; got shape {result.shape}")
    return result


def _refuse(scene: Scene, precision: Precision, by_name: Values, prefix: str) -> None:
    """Checks values as `--set` does: the extreme values of each parameter, and together the
    parameters whose values must suit each other."""
    for row in _extremes(by_name):
        refuse_each(scene, row, precision, prefix)
    together = sorted(dependent(scene) & by_name.keys())
    if not together:
        return
    columns = np.broadcast_arrays(*(by_name[name] for name in together))
    for values in np.unique(np.stack([np.atleast_1d(x) for x in columns], -1), axis=0):
        refuse_together(scene, dict(zip(together, values.tolist(), strict=True)), prefix)


def _extremes(by_name: Values) -> Iterator[dict[str, float]]:
    """Yields the values that are not finite, the least, the greatest, and the smallest in size
    except 0, one by one."""
    for name, given in by_name.items():
        values = np.ravel(given)
        lost, others = values[~np.isfinite(values)], values[values != 0]
        few = [*lost[:1], values.min(), values.max()] if values.size else []
        few += [others[np.argmin(np.abs(others))]] if others.size else []
        for value in few:
            yield {name: float(value)}
