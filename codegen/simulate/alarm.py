"""Alarm: reports during a run that its motion is wrong, the reason, and a remedy.

About 500 times in a run, at its end, and at least twice it checks
- the momentum of floating bases, which is known at all times: the kinetic energy of the excess
  motion, relative to the largest kinetic energy so far;
- the energy, if nothing feeds it in or dissipates it: its change, relative to the same;
- the step: one of h compared with two of h/2 by the default integrator from the same state.  If the
  step is too long for stiffness or rotation, velocities differ by a large fraction, repeatedly.
  (Two half steps of the same integrator show less: a saturated motor may stop steps of h and of h/2
  alike.)
"""

from dataclasses import dataclass, field

import numpy as np

from coscrew_codegen.integrators import DEFAULT, named
from coscrew_codegen.simulate.balance import rounding
from coscrew_codegen.simulate.plan import Plan
from coscrew_codegen.simulate.system import State, System

ALLOWED = 1e-2
"""Allowed change of an energy that should be constant, relative to the largest kinetic energy so
far; and allowed error of momentum, relative to the largest velocities.  `check` allows a tenth."""
ROUGH, RESOLVED = 0.3, 0.05
"""Allowed difference between one step and two halves, relative to the velocities, for methods of
order 1 and others: that of an undamped spring whose phase advances by about 1 rad per step."""
_SLOW = 1e-3
"""Velocities count as no smaller than those of this fraction of the largest kinetic energy."""
_AGAIN = 2  # consecutive checks that must find the step too large: one may meet a jolt
_LOOKS = 500  # checks in a run
_APART = 50  # least number of steps between two checks
_SETTLED = 1000  # steps before the energy of methods of order 1 is meaningful


@dataclass
class Alarm:
    """Watches one run from its start."""

    system: System
    plan: Plan
    start: State
    of_steps_alone: bool = False  # check the step only, not energy and momentum
    kinetic: float = field(init=False, default=0.0)  # largest kinetic energy so far
    _rounding: float = field(init=False, default=0.0)  # largest rounding error of energy so far
    _steps: int = field(init=False, default=0)
    _looks: int = field(init=False, default=0)
    _next: int = field(init=False, default=_APART)
    _bad: int = field(init=False, default=0)

    def __post_init__(self) -> None:
        self._integrator = named(self.plan.integrator)
        self._every = max(_APART, int(self.plan.until / self.plan.step / _LOOKS))
        its, (q, v) = self.system, self.start
        self._energy = float(sum(its.energies(0.0, q, v)))
        self._momentum = its.call("free_momentum", q=q, v=v) if its.has("free_momentum") else None
        self._conservative = its.zero("power")

    def __call__(self, steps: int, t: float, h: float, q: np.ndarray, v: np.ndarray) -> str:
        """The problem at t, or "", after `steps` further steps, the last one of length h."""
        self._steps += steps
        last = t >= self.plan.until
        if self._steps < self._next and not last:
            return ""
        self._next, self._looks = self._steps + self._every, self._looks + 1
        kinetic, potential = map(float, self.system.energies(t, q, v))
        if not np.isfinite(kinetic + potential):
            return (f"energy is not finite at t = {t:.9g} s: it grew too large, or is beyond "
                    f"the range of {self.system.precision.name} precision; {self._remedy(np.nan)}")
        self.kinetic = max(self.kinetic, kinetic)
        self._rounding = max(self._rounding, rounding(self.system, np.asarray(potential)))
        found = None
        if not self.of_steps_alone:
            found = self._of_momentum(t, q, v) or self._of_energy(kinetic + potential)
        found = found or self._of_step(t, h, q, v)
        if not found and last and self._looks < _AGAIN:  # the only check: take one more step
            q, v = self._stepped(t, h, q, v)
            found = self._of_step(t + h, h, q, v)
        return f"{found[0]} at t = {t:.9g} s: {found[1]}" if found else ""

    def _of_momentum(self, t: float, q: np.ndarray, v: np.ndarray) -> tuple[str, str] | None:
        if self._momentum is None:
            return None
        right = self.system.call("with_free_momentum", t=t, q=q, v=v, c=self._momentum)
        off = self._size(q, np.asarray(right, float) - v, self.kinetic)
        if off <= ALLOWED:
            return None
        joint = self._joint(np.abs(np.asarray(right, float) - v))
        return "momentum is not kept", (f"the floating base {joint} is off by {off:.2g} "
                                        f"of its speed; {self._remedy(off / ALLOWED)}")

    def _of_energy(self, energy: float) -> tuple[str, str] | None:
        if not self._conservative or (self._integrator.order == 1 and self._steps < _SETTLED):
            return None
        change = energy - self._energy
        off = change / self.kinetic if self.kinetic else 0.0
        if abs(change) <= self._rounding or abs(off) <= ALLOWED:
            return None
        return "energy is not kept", (f"it changed by {off:.2g} of the kinetic energy, and nothing "
                                      "feeds it in or dissipates it: "
                                      f"{self._remedy(abs(off) / ALLOWED)}")

    def _of_step(self, t: float, h: float, q: np.ndarray, v: np.ndarray) -> tuple[str, str] | None:
        its, allowed = self.system, ROUGH if self._integrator.order == 1 else RESOLVED
        if self._integrator.splits and its.has("closing_contacts") \
                and its.call("closing_contacts", h=h, q=q, v=v) > 0:
            return None
        once = self._stepped(t, h, q, v)[1]
        twice = its.stepper(named(DEFAULT).step_name)(2, t, h / 2, q, v)[1]
        apart = np.asarray(twice, float) - once
        now = float(its.energies(t, q, v)[0])
        off = self._size(q, apart, max(now, _SLOW * self.kinetic))
        self._bad = 0 if off <= allowed else self._bad + 1
        if self._bad < _AGAIN:
            return None
        joint = self._joint(np.abs(apart) * np.sqrt(np.abs(np.diagonal(self._mass(q)))))
        return "the step is too large", (
            f"at joint {joint} one of {h:.3g} s differs from two halves by {off:.2g} of the "
            f"speeds; {self._remedy(off / allowed)}")

    def _stepped(self, t: float, h: float, q: np.ndarray, v: np.ndarray) -> State:
        return self.system.stepper(self._integrator.step_name)(1, t, h, q, v)

    def _size(self, q: np.ndarray, v: np.ndarray, kinetic: float) -> float:
        """√(T(v)/T) for T = kinetic."""
        own = float(self.system.energies(0.0, q, v.astype(self.system.dtype))[0])
        return float(np.sqrt(own / kinetic)) if kinetic > 0 else 0.0

    def _mass(self, q: np.ndarray) -> np.ndarray:
        """M; the identity if the scene has no mass matrix, since it has too many joints."""
        if not self.system.has("mass_matrix"):
            return np.eye(self.system.functions.nv)
        return np.asarray(self.system.call("mass_matrix", q=q), float)

    def _joint(self, sizes: np.ndarray) -> str:
        worst = int(np.argmax(np.where(np.isfinite(sizes), sizes, np.inf)))
        return next(c.joint for c in self.system.functions.coordinates if worst in c.v)

    def _remedy(self, times: float) -> str:
        """A step for which an error of the integrator's order would be half the allowed one."""
        h = self.plan.step * (0.5 / times)**(1 / self._integrator.order)
        smaller = f"step of {h:.1g} s" if np.isfinite(h) else "smaller step"
        other = "" if self._integrator.name == DEFAULT else f", or integrator {DEFAULT}"
        return f"take a {smaller}{other}"
