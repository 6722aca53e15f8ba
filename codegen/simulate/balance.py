"""The balance of energy along a trajectory: E(t) - E(0) = ∫ P dt, P the power of all effects that
have no potential energy."""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import cumulative_simpson

from coscrew_codegen.simulate.plan import Trajectory
from coscrew_codegen.simulate.record import largest
from coscrew_codegen.simulate.system import System


@dataclass(frozen=True)
class Balance:
    """Energies in J; `work` is ∫ P dt to the end, by Simpson's rule over the samples."""

    before: float
    after: float
    work: float
    defect: float  # the largest |E(t) - E(0) - ∫ P dt|
    at: float  # where, in s
    scale: float  # the largest of kinetic energy, change of energy, and work

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
    defect = np.abs(change - work)
    at = largest(defect)
    scale = max(np.max(np.abs(x)) for x in (kinetic, change, work))
    return Balance(float(energy[0]), float(energy[-1]), float(work[-1]), float(defect[at]),
                   float(t[at]), float(scale))
