"""The balance of energy along a trajectory: E(t) - E(0) = ∫ P dt, P the power of all effects that
have no potential energy; the momentum of floating bases, which only gravity changes; the energy
that effects with bristles dissipate, which is never negative.

Work between two samples is computed by Simpson's rule.  Where that does not account for the change
of energy, the work is computed by small steps from one sample to the next, since a bounce may begin
and end between them.  Small steps during a contact continue from the previous small steps, not from
the sample: within a bounce the samples have errors of about 0.1 % of its energy, all of the same
sign, which the work would inherit although the bounce ends with the right speed."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from coscrew_codegen.scene.function_selection import BRISTLES
from coscrew_codegen.scene.integrators import DEFAULT, INTEGRATOR_NAMED
from coscrew_codegen.simulation.check.error_limits import ENERGY
from coscrew_codegen.simulation.plan import Trajectory
from coscrew_codegen.simulation.recordings.record import largest
from coscrew_codegen.simulation.system import System

ROUNDINGS = 4
"""Estimate of the largest rounding error of the potential energy, in spacings of its numbers."""
_UNCLEAR = 1e-6  # defect between two samples, relative to the energies moved, that is refined; less
# during contacts, so that the defects that are not refined add up to no more
_MOST = 2000  # largest number of intervals that are refined
_FINE = 256  # small steps in an interval without contact
_LEAST, _PER_PART = 64, 8  # least number of small steps during contact; steps per integrator's part
_LONGEST = 32  # most samples that such steps span: in longer, slow contacts samples are accurate


@dataclass(frozen=True)
class Balance:
    """The balance of energy, in J; `work` is ∫ P dt over the whole run."""

    before: float
    after: float
    work: float
    defect: float  # the largest |E(t) - E(0) - ∫ P dt|
    at: float  # its time, in s
    scale: float  # the largest of kinetic energy, change of energy, and work
    rounding: float = 0.0  # estimated rounding error of energy
    part: float = np.inf  # shortest part of a split step, in s
    momentum: float = 0.0  # the largest √(T(v - v')/T), v' with the correct momentum, T the largest
    # kinetic energy

    @property
    def rounded(self) -> bool:
        """True if the defect is within the rounding error of energies."""
        return self.defect <= self.rounding

    @property
    def relative(self) -> float:
        """The defect relative to `scale`; absolute if that is zero."""
        return self.defect / self.scale if self.scale > 0 else self.defect


def balance(system: System, trajectory: Trajectory, among: np.ndarray | None = None) -> Balance:
    """The balance over the samples, which must be dense enough for ∫ P dt; not finite if energies
    overflow.  With `among`, the defect is the largest at these times only."""
    with np.errstate(all="ignore"):
        return _balance(system, trajectory, among)


def _balance(system: System, trajectory: Trajectory, among: np.ndarray | None) -> Balance:
    t, q, v = trajectory.t, trajectory.q, trajectory.v
    kinetic, potential = system.energies(t, q, v)
    energy, work = kinetic + potential, np.zeros(len(t))
    power = np.broadcast_to(np.asarray(system.call("power", t=t, q=q, v=v), float), t.shape)
    if len(t) > 2 and np.any(power):
        from scipy.integrate import cumulative_simpson  # takes longer to import than short runs

        work = cumulative_simpson(power, x=t, initial=0)
    elif len(t) == 2:
        work[1] = (t[1] - t[0]) * power.mean()
    change = energy - energy[0]
    scale = max(np.max(np.abs(x)) for x in (kinetic, change))
    parts = _parts(system, trajectory)
    if not system.zero("power"):
        work = _refined(system, trajectory, np.diff(energy), work, scale, parts)
    defect = np.abs(change - work)
    at = largest(defect if among is None else np.where(np.isin(t, among), defect, 0))
    scale = max(np.max(np.abs(x)) for x in (kinetic, change, work))
    return Balance(float(energy[0]), float(energy[-1]), float(work[-1]), float(defect[at]),
                   float(t[at]), float(scale), _rounding(system, potential),
                   _shortest(trajectory, parts), _momentum(system, t, q, v, np.max(kinetic)))


def _rounding(system: System, potential: np.ndarray) -> float:
    """The largest rounding error of the energies; 0 if one overflows."""
    return float(rounding(system, np.max(np.abs(potential))))


def rounding(system: System, potential: np.ndarray) -> np.ndarray:
    """The rounding error of energy that comes from each potential energy; 0 if that overflows."""
    eps = float(np.finfo(system.dtype).eps)
    return np.where(np.isfinite(potential), ROUNDINGS * eps * np.abs(potential), 0.0)


def _parts(system: System, trajectory: Trajectory) -> np.ndarray:
    """The number of parts of the default integrator from each sample to the next, if a limit is hit
    between them; else 0."""
    t, q, v = trajectory.t, trajectory.q[:-1], trajectory.v[:-1]
    if not system.has("parts"):
        return np.zeros(len(t) - 1)
    h = np.diff(t)
    closing = system.call("closing_contacts", h=h, q=q, v=v) > 0
    return np.where(closing, system.outputs("parts", h=h, q=q, v=v)[0], 0).astype(float)


def _shortest(trajectory: Trajectory, parts: np.ndarray) -> float:
    split = parts > 1
    return float(np.min(np.diff(trajectory.t)[split] / parts[split], initial=np.inf))


def _refined(system: System, trajectory: Trajectory, change: np.ndarray, work: np.ndarray,
             scale: float, parts: np.ndarray) -> np.ndarray:
    """The work up to each sample, with some intervals refined by small steps."""
    works = np.diff(work)
    apart = np.abs(change - works)
    closing = parts > 0
    clear = np.where(closing, _UNCLEAR / max(1, int(np.count_nonzero(closing))), _UNCLEAR) * scale
    unclear = np.argsort(-np.where(np.isnan(apart), 0, apart), kind="stable")[:_MOST]
    unclear = np.sort(unclear[apart[unclear] > clear[unclear]])
    counts = np.where(closing, np.maximum(_LEAST, _PER_PART * parts), _FINE).astype(int)
    t, q, v = trajectory.t, trajectory.q.copy(), trajectory.v.copy()
    for some in _rounds(system, trajectory, unclear):
        total, q[some + 1], v[some + 1] = _closely(system, t[some], np.diff(t)[some], counts[some],
                                                   q[some], v[some])
        works[some] = np.where(np.isfinite(total), total, works[some])
    return np.concatenate(([0.0], np.cumsum(works)))


def _rounds(system: System, trajectory: Trajectory, unclear: np.ndarray) -> Iterator[np.ndarray]:
    """The intervals to refine, in groups: the first group starts from samples, each later one
    continues from intervals of the previous group."""
    q, v = (x[unclear] for x in (trajectory.q, trajectory.v))
    before = np.zeros(len(unclear), int)
    if system.has("parts"):
        closed = system.call("closing_contacts", h=np.zeros(len(unclear)), q=q, v=v) > 0
        for i in np.flatnonzero(closed & (np.diff(unclear, prepend=-2) == 1)):
            before[i] = (before[i - 1] + 1) % _LONGEST
    yield from (unclear[before == k] for k in range(before.max(initial=-1) + 1))


def _closely(system: System, t: np.ndarray, interval: np.ndarray, count: np.ndarray, q: np.ndarray,
             v: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(work, q, v) after an interval from each t, in `count` small steps."""
    h, total, before = interval / count, np.zeros(len(t)), _power(system, t, q, v)
    for k in range(count.max(initial=0)):
        i = np.flatnonzero(k < count)
        q[i], v[i] = system.outputs(INTEGRATOR_NAMED[DEFAULT].step_name, t=t[i] + k * h[i],
                                    h=h[i], q=q[i], v=v[i])
        after = _power(system, t[i] + (k + 1) * h[i], q[i], v[i])
        total[i] += h[i] / 2 * (before[i] + after)
        before[i] = after
    return total, q, v


def _power(system: System, t: np.ndarray, q: np.ndarray, v: np.ndarray) -> np.ndarray:
    return np.asarray(system.call("power", t=t, q=q, v=v), float)


def _momentum(system: System, t: np.ndarray, q: np.ndarray, v: np.ndarray, kinetic: float) -> float:
    """The largest √(T(v - v')/kinetic), v' the velocities with the correct momentum."""
    if not system.has("free_momentum"):
        return 0.0
    c = system.call("free_momentum", q=q[0], v=v[0])
    _, right = system.outputs("with_free_momentum", t=t, q=q, v=v, c=c)
    own, _ = system.energies(t, q, (right.astype(float) - v).astype(system.dtype))
    return float(np.sqrt(own[largest(own)] / kinetic)) if kinetic > 0 else 0.0


@dataclass(frozen=True)
class Bristles:
    """Energies of contacts and sticking joints, in J."""

    stored: float  # by bristles, the largest
    dissipated: float  # to the end
    returned: float  # the largest amount by which the dissipated energy falls
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
