"""The balance of energy along a trajectory: E(t) - E(0) = ∫ P dt, P the power of all effects that
have no potential energy; and momentum of what floats free, which nothing changes but gravity.

The power between two samples is Simpson's rule's, over neighbours.  Where that does not account for
the change of energy, it is that of small steps from the first to the second: a bounce may begin and
end between them."""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import cumulative_simpson

from coscrew_codegen.integrators import DEFAULT
from coscrew_codegen.simulate.plan import Trajectory
from coscrew_codegen.simulate.record import largest
from coscrew_codegen.simulate.system import System

_UNCLEAR = 1e-6  # of the energies moved: more between two samples is looked at more closely,
_MOST = 2000  # at most between so many,
_FINE = 256  # with so many steps


@dataclass(frozen=True)
class Balance:
    """Energies in J; `work` is ∫ P dt to the end, by Simpson's rule over the samples."""

    before: float
    after: float
    work: float
    defect: float  # the largest |E(t) - E(0) - ∫ P dt|
    at: float  # where, in s
    scale: float  # the largest of kinetic energy, change of energy, and work
    momentum: float = 0.0  # the largest √(T(v - v')/T), v' with the momentum there should be, T the
    # largest kinetic energy

    @property
    def relative(self) -> float:
        """The defect relative to the energies that were moved; as it is where none were."""
        return self.defect / self.scale if self.scale > 0 else self.defect


def balance(system: System, trajectory: Trajectory) -> Balance:
    """The balance over the samples, which must be dense for ∫ P dt to be right; not finite where
    energies overflow."""
    with np.errstate(all="ignore"):
        return _balance(system, trajectory)


def _balance(system: System, trajectory: Trajectory) -> Balance:
    t, q, v = trajectory.t, trajectory.q, trajectory.v
    kinetic, potential = system.energies(t, q, v)
    energy, work = kinetic + potential, np.zeros(len(t))
    power = np.broadcast_to(np.asarray(system.call("power", t=t, q=q, v=v), float), t.shape)
    if len(t) > 2 and np.any(power):
        work = cumulative_simpson(power, x=t, initial=0)
    elif len(t) == 2:
        work[1] = (t[1] - t[0]) * power.mean()
    change = energy - energy[0]
    scale = max(np.max(np.abs(x)) for x in (kinetic, change))
    if system.programs["power"].instructions:
        work = _refined(system, trajectory, np.diff(energy), work, scale)
    defect = np.abs(change - work)
    at = largest(defect)
    scale = max(np.max(np.abs(x)) for x in (kinetic, change, work))
    return Balance(float(energy[0]), float(energy[-1]), float(work[-1]), float(defect[at]),
                   float(t[at]), float(scale), _momentum(system, t, q, v, np.max(kinetic)))


def _refined(system: System, trajectory: Trajectory, change: np.ndarray, work: np.ndarray,
             scale: float) -> np.ndarray:
    """The work up to each sample, between some of them by small steps."""
    parts = np.diff(work)
    apart = np.abs(change - parts)
    unclear = np.argsort(-np.where(np.isnan(apart), 0, apart), kind="stable")[:_MOST]
    unclear = np.sort(unclear[apart[unclear] > _UNCLEAR * scale])
    if not len(unclear):
        return work
    t, q, v = (x[unclear] for x in (trajectory.t, trajectory.q, trajectory.v))
    h = np.diff(trajectory.t)[unclear] / _FINE
    total, before = np.zeros(len(unclear)), _power(system, t, q, v)
    for k in range(_FINE):
        q, v = system.call(f"step_{DEFAULT}", t=t + k * h, h=h, q=q, v=v)
        after = _power(system, t + (k + 1) * h, q, v)
        total, before = total + h / 2 * (before + after), after
    parts[unclear] = np.where(np.isfinite(total), total, parts[unclear])
    return np.concatenate(([0.0], np.cumsum(parts)))


def _power(system: System, t: np.ndarray, q: np.ndarray, v: np.ndarray) -> np.ndarray:
    return np.asarray(system.call("power", t=t, q=q, v=v), float)


def _momentum(system: System, t: np.ndarray, q: np.ndarray, v: np.ndarray, kinetic: float) -> float:
    """The largest of the energies of motion that is too much, against this one."""
    if not system.has("free_momentum"):
        return 0.0
    c = system.call("free_momentum", q=q[0], v=v[0])
    right = system.call("with_free_momentum", t=t, q=q, v=v, c=c)
    own, _ = system.energies(t, q, (right.astype(float) - v).astype(system.dtype))
    return float(np.sqrt(own[largest(own)] / kinetic)) if kinetic > 0 else 0.0
