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


Index = tuple[int, ...]
"""A member of a batch; () in a single run."""
Problem = tuple[str, str, str]
"""A joint, or ""; the problem; its reason and a remedy."""


@dataclass
class Alarm:
    """Watches one run, or each member of a batch, from its start."""

    system: System
    plan: Plan
    start: State
    of_steps_alone: bool = False  # check the step only, not energy and momentum
    driven: bool = False  # a controller may feed in energy
    _steps: int = field(init=False, default=0)
    _looks: int = field(init=False, default=0)
    _next: int = field(init=False, default=_APART)

    def __post_init__(self) -> None:
        self._integrator = named(self.plan.integrator)
        run = self.plan.until - self.plan.begin
        self._every = max(_APART, int(run / self.plan.step / _LOOKS))
        its, (q, v) = self.system, self.start
        lead = q.shape[:-1]
        self.kinetic, self._rounding = np.zeros(lead), np.zeros(lead)  # the largest so far
        self._bad = np.zeros(lead, int)
        self._energy = sum(its.energies(self.plan.begin, q, v))
        self._momentum = its.momentum(q, v)
        self._conservative = its.zero("power") and not self.driven

    def __call__(self, steps: int, t: float, h: float, q: np.ndarray, v: np.ndarray,
                 alive: np.ndarray) -> dict[Index, tuple[str, str]]:
        """(joint, problem) of the members that are `alive` and wrong at t, after `steps` further
        steps, the last one of length h."""
        self._steps += steps
        last = t >= self.plan.until
        if self._steps < self._next and not last:
            return {}
        self._next, self._looks = self._steps + self._every, self._looks + 1
        kinetic, potential = self.system.energies(t, q, v)
        lost = alive & ~np.isfinite(kinetic + potential)
        found = dict.fromkeys(_indices(lost), (
            "", f"energy is not finite at t = {t:.9g} s: it grew too large, or is beyond the range "
            f"of {self.system.precision.name} precision; {self._remedy(np.nan)}"))
        alive = alive & ~lost
        self.kinetic = np.fmax(self.kinetic, kinetic)
        self._rounding = np.fmax(self._rounding, rounding(self.system, potential))
        problems: dict[Index, Problem] = {}
        if not self.of_steps_alone and alive.any():
            problems = self._of_energy(kinetic + potential, alive) | self._of_momentum(
                t, q, v, alive)
        if len(problems) < np.count_nonzero(alive):
            problems = self._of_step(t, h, q, v, alive) | problems
            if last and self._looks < _AGAIN:  # the only check: take one more step
                q, v = self._stepped(t, h, q, v)
                problems = self._of_step(t + h, h, q, v, alive) | problems
        return found | {i: (joint, f"{what} at t = {t:.9g} s: {why}")
                        for i, (joint, what, why) in problems.items()}

    def _of_momentum(self, t: float, q: np.ndarray, v: np.ndarray, alive: np.ndarray
                     ) -> dict[Index, Problem]:
        if self._momentum is None:
            return {}
        right = self.system.kept(self._momentum, t - self.plan.begin, q, v)
        apart = np.asarray(right, float) - v
        off = self._size(q, apart, self.kinetic)
        return {i: (joint := self._joint(np.abs(apart[i])), "momentum is not kept",
                    f"the floating base {joint} is off by {off[i]:.2g} of its speed; "
                    f"{self._remedy(off[i] / ALLOWED)}")
                for i in _indices(alive & ~(off <= ALLOWED))}

    def _of_energy(self, energy: np.ndarray, alive: np.ndarray) -> dict[Index, Problem]:
        if not self._conservative or (self._integrator.order == 1 and self._steps < _SETTLED):
            return {}
        change = energy - self._energy
        off = _ratio(change, self.kinetic)
        right = (np.abs(change) <= self._rounding) | (np.abs(off) <= ALLOWED)
        return {i: ("", "energy is not kept",
                    f"it changed by {off[i]:.2g} of the kinetic energy, and nothing feeds it in or "
                    f"dissipates it: {self._remedy(abs(off[i]) / ALLOWED)}")
                for i in _indices(alive & ~right)}

    def _of_step(self, t: float, h: float, q: np.ndarray, v: np.ndarray, alive: np.ndarray
                 ) -> dict[Index, Problem]:
        its, allowed = self.system, ROUGH if self._integrator.order == 1 else RESOLVED
        free = alive
        if self._integrator.splits and its.has("closing_contacts"):
            free = alive & ~(its.call("closing_contacts", h=h, q=q, v=v) > 0)
            if not free.any():
                return {}
        once = self._stepped(t, h, q, v)[1]
        twice = its.stepper(named(DEFAULT).step_name)(2, t, h / 2, q, v)[1]
        apart = np.asarray(twice, float) - once
        now = its.energies(t, q, v)[0]
        off = self._size(q, apart, np.fmax(now, _SLOW * self.kinetic))
        self._bad = np.where(free, np.where(off <= allowed, 0, self._bad + 1), self._bad)
        found = {}
        for i in _indices(free & (self._bad >= _AGAIN)):
            inertia = np.abs(np.diagonal(self._mass(its.member(i), q[i])))
            joint = self._joint(np.abs(apart[i]) * np.sqrt(inertia))
            found[i] = (joint, "the step is too large",
                        f"at joint {joint} one of {h:.3g} s differs from two halves by {off[i]:.2g}"
                        f" of the speeds; {self._remedy(off[i] / allowed)}")
        return found

    def _stepped(self, t: float, h: float, q: np.ndarray, v: np.ndarray) -> State:
        return self.system.stepper(self._integrator.step_name)(1, t, h, q, v)

    def _size(self, q: np.ndarray, v: np.ndarray, kinetic: np.ndarray) -> np.ndarray:
        """√(T(v)/T) for T = kinetic."""
        own = self.system.energies(0.0, q, v.astype(self.system.dtype))[0]
        found: np.ndarray = np.sqrt(_ratio(own, kinetic))
        return found

    def _mass(self, its: System, q: np.ndarray) -> np.ndarray:
        """M; the identity if the scene has no mass matrix, since it has too many joints."""
        if not its.has("mass_matrix"):
            return np.eye(its.functions.nv)
        return np.asarray(its.call("mass_matrix", q=q), float)

    def _joint(self, sizes: np.ndarray) -> str:
        worst = int(np.argmax(np.where(np.isfinite(sizes), sizes, np.inf)))
        return next(c.joint for c in self.system.functions.coordinates if worst in c.v)

    def _remedy(self, times: float) -> str:
        """A step for which an error of the integrator's order would be half the allowed one."""
        h = self.plan.step * (0.5 / times)**(1 / self._integrator.order)
        smaller = f"step of {h:.1g} s" if np.isfinite(h) else "smaller step"
        other = "" if self._integrator.name == DEFAULT else f", or integrator {DEFAULT}"
        return f"take a {smaller}{other}"


def _indices(mask: np.ndarray) -> list[Index]:
    """Where the mask is true."""
    return [tuple(i) for i in np.argwhere(mask).tolist()]


def _ratio(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """x/y; 0 where y is not positive."""
    found: np.ndarray = np.where(y > 0, x / y, 0.0)
    return found
