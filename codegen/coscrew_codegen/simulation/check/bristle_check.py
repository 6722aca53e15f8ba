"""Energy that effects with bristles dissipate along a run: never less than nothing."""

from dataclasses import dataclass

import numpy as np

from coscrew_codegen.scene.function_selection import BRISTLES
from coscrew_codegen.simulation.check.error_limits import ENERGY
from coscrew_codegen.simulation.plan import Trajectory
from coscrew_codegen.simulation.recordings.record import largest
from coscrew_codegen.simulation.system import System


@dataclass(frozen=True)
class Bristles:
    """Energies of contacts and sticking joints, in J."""

    stored: float  # by bristles, the largest
    dissipated: float  # to the end
    returned: float  # the largest amount by which what was dissipated falls
    at: float  # where it does, in s
    allowed: float  # the largest such amount

    @property
    def passed(self) -> bool:
        """True if they only dissipate."""
        return self.returned <= self.allowed


def only_dissipates(system: System) -> bool:
    """Returns whether no effect of the scene drives: each stores energy, or resists, whatever the
    time is, and no fluid flows."""
    timed = any("t" in system.inputs.get(name, ()) for name in ("energy", "power"))
    return not timed and all(
        x.effect.stores_energy or x.effect.resists or x.effect.switches or x.effect.joint_inertia
        or x.effect.ground or x.effect.reaction or x.effect.mimic for x in system.scene.effects)


def stored(system: System, t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray | float:
    """The energy of bristles; 0 without them."""
    return np.asarray(system.outputs(BRISTLES, t=t, q=q, v=v)[0], float) if system.has(
        BRISTLES) else 0.0


def bristles_of(system: System, trajectory: Trajectory, scale: float) -> Bristles | None:
    """-∫ P dt - (S(t) - S(0)), with the energy S of bristles, along a trajectory that is sampled at
    every step, by the trapezoidal rule, which keeps signs; energies move by up to `scale`.  None
    without bristles."""
    if not system.has(BRISTLES):
        return None
    t, q, v = trajectory.t, trajectory.q, trajectory.v
    with np.errstate(all="ignore"):
        held, power = (np.asarray(x, float) for x in system.outputs(BRISTLES, t=t, q=q, v=v))
        work = np.cumsum(np.diff(t) * (power[1:] + power[:-1]) / 2)
        spent = held[0] - held - np.concatenate([[0.0], work])
        returned = np.maximum.accumulate(spent) - spent
    worst, most = largest(returned), float(held.max())
    return Bristles(most, float(spent[-1]), float(returned[worst]), float(t[worst]),
                    ENERGY * max(scale, most))
