"""Closed loops along a run: how far they open, how fast, what they work, how near they come to a
singular position."""

from dataclasses import dataclass

import numpy as np

from coscrew_codegen.scene.function_selection import CLOSURE
from coscrew_codegen.simulation.loops.loop_closing import rank
from coscrew_codegen.simulation.plan import Trajectory
from coscrew_codegen.simulation.recordings.record import accelerations, largest
from coscrew_codegen.simulation.system import System

ALLOWED = 1e-6
"""m or rad: the largest gap of a right motion in double precision."""
WORK = 1e-3
"""Largest work of the closures, relative to the energies moved."""
_SINGULAR = {"double": 1e-10, "single": 1e-6}
"""Squares of the ratio of singular values below which rounding decides how loops go on."""
_ROUNDED = 4  # spacings of the largest coordinate, times a length, by which rounding opens loops


@dataclass(frozen=True)
class Closures:
    """The closures along a run; lengths and angles count alike, in m and rad."""

    gap: float  # the largest
    at: float  # its time, in s
    allowed: float  # the largest gap of a right motion
    rate: float  # the largest |E v|, in m/s or rad/s
    work: float  # of the closures, relative to the energies moved
    ratio: float  # smallest (σ_r/σ_1)² of E, r its largest rank along the run
    singular_at: float  # where that is, in s
    precision: str

    @property
    def passed(self) -> bool:
        """True if loops stay closed and their closures do no work."""
        return self.gap <= self.allowed and self.work <= WORK

    @property
    def singular(self) -> bool:
        """True if the run passes a position where rounding decides how loops go on."""
        return self.ratio < _SINGULAR[self.precision]


def allowed(system: System, q: np.ndarray) -> float:
    """The largest gap of a right motion at coordinates up to these."""
    size = system.scene.model.length * (1 + float(np.max(abs(q), initial=0)))
    return max(ALLOWED, _ROUNDED * float(np.finfo(system.dtype).eps) * size)


def gaps(system: System, q: np.ndarray) -> np.ndarray:
    """The largest closure of each state.  (…, nq)->(…)."""
    result: np.ndarray = abs(np.asarray(system.outputs(CLOSURE, q=q)[0], float)).max(-1)
    return result


def closures(system: System, trajectory: Trajectory, scale: float) -> Closures | None:
    """The closures along a trajectory, whose energies move by up to `scale`; None without loops."""
    if not system.has(CLOSURE):
        return None
    t, q, v = trajectory.t, trajectory.q, trajectory.v
    with np.errstate(all="ignore"):
        phi, E = (np.asarray(x, float) for x in system.outputs(CLOSURE, q=q))
        gap, rates = abs(phi).max(-1), abs(np.einsum("...ij,...j->...i", E, v)).max(-1)
        work = abs(_work(system, trajectory)) / scale if scale > 0 else 0.0
        ratios = _ratios(E[np.isfinite(E).all((-1, -2))])
    worst, least = largest(gap), int(np.argmin(ratios))
    return Closures(float(gap[worst]), float(t[worst]), allowed(system, q[np.isfinite(q).all(-1)]),
                    float(np.max(rates)), work, float(ratios[least]), float(t[least]),
                    system.precision.name)


def _work(system: System, trajectory: Trajectory) -> float:
    """∫ E^T λ·v dt by the trapezoidal rule; E^T λ are the torques of the open tree."""
    t, q, v = trajectory.t, trajectory.q, trajectory.v
    a = accelerations(system, t, q, v)
    torques = system.call("inverse_dynamics", t=t, q=q, v=v, a=a)
    return float(np.trapezoid((np.asarray(torques, float) * v).sum(-1), t))


def _ratios(E: np.ndarray) -> np.ndarray:
    """(σ_r/σ_1)² of each matrix, r the largest rank."""
    sizes = np.linalg.svd(E, compute_uv=False)
    r = max(map(rank, E), default=0)
    return (sizes[:, r - 1] / sizes[:, 0])**2 if r else np.ones(len(E))
