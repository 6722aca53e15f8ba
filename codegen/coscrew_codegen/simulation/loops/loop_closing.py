"""Starts of scenes with closed loops: assembled, or refused with an assembled one near them."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from coscrew_codegen.scene.function_selection import CLOSED, CLOSURE
from coscrew_codegen.scene.mechanism.loop import ClosedLoop
from coscrew_codegen.scene.names import toml_key
from coscrew_codegen.simulation import SimulateError

if TYPE_CHECKING:
    from coscrew_codegen.simulation.system import State, System

OPEN = 1e-3
"""m, rad, m/s or rad/s: a start that violates closures by less is moved onto them."""
_STEPS = 30  # of Newton's method
_ROUNDED = 8  # roundoffs of closures that count as closed
_RANK = 1e-9  # of the largest singular value: the others count as zero


def closed(system: "System", q: np.ndarray, v: np.ndarray) -> "State":
    """q and v on the closures of the scene's loops.  Raises SimulateError for a start that is
    farther than OPEN from them, with an assembled start near it."""
    phi, gaps = _gaps(system, q, v)
    at, speeds = _onto(system, q, v)
    lost = abs(phi).max(-1) > OPEN
    if lost.any():
        one = np.argwhere(lost)[0]
        raise SimulateError(_is_open(system, phi[*one], at[*one], q[*one]))
    lost = abs(gaps).max(-1) > OPEN * np.maximum(1, abs(v).max(-1))
    if lost.any():
        one = np.argwhere(lost)[0]
        raise SimulateError(_opens(system, gaps[*one], at[*one], v[*one]))
    return at, speeds


def mobility(system: "System") -> str:
    """A line on the freedoms that the loops leave at the start; "" without loops."""
    if not system.has(CLOSURE):
        return ""
    phi, E = system.outputs(CLOSURE, q=system.start()[0])
    count = rank(E)
    return (f"closed loops: {len(phi)} rows of rank {count} leave {E.shape[-1] - count} of "
            f"{E.shape[-1]} velocities free")


def rank(E: np.ndarray) -> int:
    """The number of independent rows."""
    sizes = np.linalg.svd(np.asarray(E, float), compute_uv=False)
    least = max(_RANK, 30 * float(np.finfo(E.dtype).eps)) * sizes.max(initial=0)
    return int((sizes > least).sum())


def _gaps(system: "System", q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """phi and E v."""
    phi, E = system.outputs(CLOSURE, q=q)
    return phi, np.einsum("...ij,...j->...i", E, v)


def _onto(system: "System", q: np.ndarray, v: np.ndarray) -> "State":
    """The state after steps of Newton's method, until its closures are those of rounding."""
    least = _ROUNDED * float(np.finfo(system.dtype).eps) * max(1, system.scene.model.length)
    with np.errstate(all="ignore"):
        for _ in range(_STEPS):
            phi, gaps = _gaps(system, q, v)
            fast = np.maximum(1, abs(v).max(-1, initial=0))
            done = (abs(phi).max(-1) <= least) & (abs(gaps).max(-1) <= least * fast)
            if done.all():
                break
            moved, speeds = system.outputs(CLOSED, q=q, v=v)
            q, v = (np.where(done[..., None], x, y) for x, y in ((q, moved), (v, speeds)))
    return q, v


def _is_open(system: "System", phi: np.ndarray, at: np.ndarray, q: np.ndarray) -> str:
    """The loop that is open, and an assembled q if one was reached."""
    loop, size = _widest(system, phi)
    what = f"loop {loop.name} is open by {size} at the start; wanted at most {OPEN:g}"
    with np.errstate(all="ignore"):
        rest = abs(system.outputs(CLOSURE, q=at)[0]).max()
    if not rest <= OPEN:
        return (f"{what}, and no position near it closes all loops; wanted another q in [start], "
                "or lengths that fit")
    return f"{what}; assembled near it: start.q = {_by_joint(system, at, 'q')}"


def _opens(system: "System", gaps: np.ndarray, q: np.ndarray, v: np.ndarray) -> str:
    """The loop that opens, and velocities that keep those that were given, if there are any."""
    loop, size = _widest(system, gaps)
    E = np.asarray(system.outputs(CLOSURE, q=q)[1], float)
    free = v == 0
    others = np.linalg.lstsq(E[:, free], -E[:, ~free] @ v[~free], rcond=_RANK)[0]
    fitting = v.astype(float)
    fitting[free] = others
    if abs(E @ fitting).max() > OPEN * max(1, abs(v).max()):
        fitting = _onto(system, q, v)[1]
    return (f"loop {loop.name} opens at {size}/s at the start; wanted velocities that keep it "
            f"closed, as start.v = {_by_joint(system, fitting, 'v')}")


def _widest(system: "System", phi: np.ndarray) -> tuple[ClosedLoop, str]:
    """The loop with the largest gap, and the gap."""
    worst, first = int(np.argmax(np.where(np.isnan(phi), np.inf, abs(phi)))), 0
    for loop in system.scene.model.loops:
        if worst < first + loop.kind.count:
            break
        first += loop.kind.count
    return loop, f"{abs(phi[worst]):.3g} {loop.kind.units[worst - first]}"


def _by_joint(system: "System", values: np.ndarray, of: str) -> str:
    """{ elbow = 0.5, base = [0, 0, 1, …] } in TOML."""
    return f"{{ {', '.join(_entries(system, values, of))} }}"


def _entries(system: "System", values: np.ndarray, of: str) -> Iterator[str]:
    for c in system.functions.coordinates:
        own = [f"{x:.9g}" for x in values[c.q if of == "q" else c.v]]
        text = own[0] if len(own) == 1 else f"[{', '.join(own)}]"
        yield f"{toml_key(c.joint)} = {text}"
