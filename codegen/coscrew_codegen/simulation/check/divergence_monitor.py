"""Alarm: reports during a run that its motion is wrong, with the reason and a remedy.

From the first step on, and about a hundred times more, it takes some steps twice: as the run does,
and with a quarter of the step by the default integrator.  Where the two differ, ever smaller steps
in double precision decide.  Errors are compared with the sizes of the run since its start (see
`motion_error`), at its end, or once they have been too large for a tenth of it.  So resting parts
never stop a run, and no start passes if its steps do not resolve it.

It also compares, with the largest kinetic energy about the centres of mass,
- the energy, that of bristles included, in scenes without sources: where effects only dissipate,
  it may not rise;
- the momentum of floating bases, which is known at all times: the energy of the excess motion.
Loops must stay closed, and no contact may be deeper than its radius.  And it compares the change of
coordinates with the integral of velocities: numbers of single precision may be too coarse for the
change."""

import math
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from coscrew_codegen.scene.function_selection import ALL_CONTACTS, CLOSURE
from coscrew_codegen.scene.integrators import INTEGRATOR_NAMED
from coscrew_codegen.scene.joints import KIND_NAMED
from coscrew_codegen.simulation.check import windows
from coscrew_codegen.simulation.check.contact_check import depths_through, sinks, touching
from coscrew_codegen.simulation.check.energy_balance import only_dissipates, rounding, stored
from coscrew_codegen.simulation.check.error_limits import ALLOWED, FROZEN, KEPT
from coscrew_codegen.simulation.check.motion_error import Extent, StateParts
from coscrew_codegen.simulation.loops.closure_check import allowed, gaps
from coscrew_codegen.simulation.plan import Plan
from coscrew_codegen.simulation.system import State, System

UNTRIED = "take a smaller step"
"""Remedy where none was tried."""
_FIRST, _LATER = 32, 8  # steps that are taken twice: at the start, and later
_LOOKS = 100  # windows in a run
_SIZES = 300  # measurements of the parts' ways in a run, also between windows
_APART = 400  # least number of steps between two windows
_PERSISTENT = 0.1  # of the run: a fault that lasts so long stops it
_SETTLED = 1000  # steps before the energy of methods of order 1 is meaningful


Index = tuple[int, ...]
"""A member of a batch; () in a single run."""


@dataclass
class Alarm:
    """Watches one run, or each member of a batch, from its start."""

    system: System
    plan: Plan
    start: State
    driven: bool = False  # a controller may feed in energy
    remedy: Callable[[System, Plan, State], str] | None = None  # names settings
    _steps: int = field(init=False, default=0)
    _next: int = field(init=False, default=0)
    _measured: float = field(init=False, default=0.0)

    def __post_init__(self) -> None:
        self._integrator = INTEGRATOR_NAMED[self.plan.integrator]
        run = self.plan.until - self.plan.begin
        self._count = run / self.plan.step
        self._every = int(min(max(_APART, self._count / _LOOKS), max(1, self._count)))
        its, (q, v) = self.system, self.start
        lead = q.shape[:-1]
        self._parts = StateParts(its)
        self.extent = Extent.since(self._parts, its.precision, self.plan.step, q, v)
        self._kinetic, self._rounding = np.zeros(lead), np.zeros(lead)  # the largest so far
        self._errors = _Worst(lead, len(self._parts.parts), run)
        self._energies, self._momenta = _Worst(lead, 1, run), _Worst(lead, its.functions.nv, run)
        self._energy = sum(its.energies(self.plan.begin, q, v)) + stored(its, self.plan.begin, q, v)
        self._momentum = its.momentum(q, v)
        self._conservative = its.zero("power") and not self.driven
        self._passive = only_dissipates(its) and not self.driven
        self._through = depths_through(its) if its.has(ALL_CONTACTS) else None
        self._way = windows.Way(its, self._integrator)
        self._next = self._every
        first = self.plan.steps(min(self.plan.every, run))
        self._look(0.0, first[1], q, v, min(_FIRST, max(1, round(self._count))))

    def __call__(self, steps: int, t: float, h: float, q: np.ndarray, v: np.ndarray,
                 alive: np.ndarray) -> dict[Index, tuple[str, str]]:
        """Returns (joint, problem) of the members that are `alive` and wrong at t, after `steps`
        further steps, the last one of length h."""
        self._steps += steps
        last = t >= self.plan.until
        if self._steps >= self._measured:
            self._measured = self._steps + self._count / _SIZES
            self.extent.add(t - self.plan.begin, self._parts.places(q))
        if self._steps < self._next and not last:
            return {}
        self._next = self._steps + self._every
        kinetic, potential = self.system.energies(t, q, v)
        lost = alive & ~np.isfinite(kinetic + potential)
        wrong = {i: ("", f"energy is not finite at t = {t:.9g} s: it grew too large, or is beyond "
                     f"the range of {self.system.precision.name} precision; "
                     f"{self.remedy_in_words()}") for i in _indices(lost)}
        alive = alive & ~lost
        if not alive.any():
            return wrong
        self._note(t, q, v, kinetic, potential)
        self._look(t - self.plan.begin, h, q, v, _LATER)
        for problem in (self._of_steps, self._of_rounding, self._of_energy, self._of_momentum):
            wrong = problem(last, alive) | wrong
        return self._of_contacts(t, q, v, alive) | self._of_loops(t, q, alive) | wrong

    @property
    def idle(self) -> int:
        """The number of further steps that calls before the end of the run only count."""
        return math.ceil(min(self._measured, self._next) - self._steps) - 1

    def count(self, steps: int) -> None:
        """Notes so many steps, no more than `idle`."""
        self._steps += steps

    def _note(self, t: float, q: np.ndarray, v: np.ndarray, kinetic: np.ndarray,
              potential: np.ndarray) -> None:
        """Note sizes, energies and momenta at t."""
        since = t - self.plan.begin
        self.extent.add(since, self._parts.places(q))
        moving = self._parts.kinetic(q, v, self.extent.line)
        self._kinetic = np.fmax(self._kinetic, np.where(np.isfinite(moving), moving, 0))
        self._rounding = np.fmax(self._rounding, rounding(self.system, potential) + kinetic *
                                 self._steps * np.finfo(self.system.dtype).eps)
        if (self._conservative or self._passive) and (
                self._integrator.order > 1 or self._steps >= _SETTLED):
            energy = kinetic + potential + stored(self.system, t, q, v)
            risen = energy - self._energy
            off = np.maximum((np.abs(risen) if self._conservative else risen) - self._rounding, 0)
            self._energies.add(since, off[..., None], KEPT * self._kinetic[..., None])
            if not self._conservative:
                self._energy = np.fmin(self._energy, energy)
        if self._momentum is not None:
            right = self.system.kept(self._momentum, since, q, v)[1]
            apart = (np.asarray(right, float) - v).astype(self.system.dtype)
            off = self.system.energies(0.0, q, apart)[0]
            off = np.maximum(off - kinetic * (self._steps * np.finfo(self.system.dtype).eps)**2, 0)
            self._momenta.add(since, off[..., None], KEPT**2 * self._kinetic[..., None])

    def _look(self, since: float, h: float, q: np.ndarray, v: np.ndarray, count: int) -> None:
        """Takes `count` steps from q, v twice, and notes their difference."""
        with np.errstate(all="ignore"):
            window = windows.Window(self._parts, self.plan.integrator, self.plan.begin + since, h,
                                    q, v, count)
            self._way.add(window, self._every)
            for at, places in window.places:
                self.extent.add(since + at, places)
            allowed = ALLOWED * self.extent.sizes
            self._errors.add(since, window.errors(allowed), allowed)

    def _of_steps(self, last: bool, alive: np.ndarray) -> dict[Index, tuple[str, str]]:
        bad = self._errors.beyond(ALLOWED * self.extent.sizes, last) & alive[..., None]
        results = {}
        for i in _indices(bad.any(-1)):
            ratio = self._errors.worst[i] / self.extent.sizes[i]
            k = int(np.argmax(np.where(bad[i], ratio, -1)))
            part = self._parts.parts[k]
            results[i] = (part.joint, f"the step is too large at t = {self._time(i, k):.9g} s: "
                          f"{part.name} is off by {ratio[k]:.2g} of the way it moves; "
                          f"{self.remedy_in_words()}")
        return results

    def _of_rounding(self, last: bool, alive: np.ndarray) -> dict[Index, tuple[str, str]]:
        if not last:
            return {}
        return {i: (joint, f"rounding freezes joint {joint}: {self.system.precision.name} "
                    f"precision loses {share:.2g} of the way that its velocity makes, since a step "
                    f"moves it by little more than the spacing of numbers near {at:.3g}; "
                    f"{windows.remedy_of_rounding(self.system)}")
                for i, (joint, share, at) in self._way.frozen(FROZEN).items() if alive[i]}

    def _of_energy(self, last: bool, alive: np.ndarray) -> dict[Index, tuple[str, str]]:
        bad = self._energies.beyond(KEPT * self._kinetic[..., None], last)[..., 0] & alive
        how, why = ("changed", "in or dissipates it") if self._conservative else ("rose", "in")
        return {i: ("", f"energy is not kept at t = {self._energies.at[i][0]:.9g} s: it {how} by "
                    f"{_ratio(self._energies.worst[i][0], self._kinetic[i]):.2g} of the kinetic "
                    f"energy, and nothing feeds it {why}; {self.remedy_in_words()}")
                for i in _indices(bad)}

    def _of_momentum(self, last: bool, alive: np.ndarray) -> dict[Index, tuple[str, str]]:
        bad = self._momenta.beyond(KEPT**2 * self._kinetic[..., None], last)[..., 0] & alive
        joint = next((c.joint for c in self.system.functions.coordinates
                      if KIND_NAMED[c.kind].floats), "")
        return {i: (joint, f"momentum is not kept at t = {self._momenta.at[i][0]:.9g} s: the "
                    "floating bases are off by "
                    f"{_ratio(self._momenta.worst[i][0], self._kinetic[i])**0.5:.2g} of their "
                    f"speed; {self.remedy_in_words()}")
                for i in _indices(bad)}

    def _of_loops(self, t: float, q: np.ndarray, alive: np.ndarray
                  ) -> dict[Index, tuple[str, str]]:
        if not self.system.has(CLOSURE):
            return {}
        with np.errstate(all="ignore"):
            gap = gaps(self.system, q)
        return {i: ("", f"closed loops open by {gap[i]:.2g} m or rad at t = {t:.9g} s; "
                    f"{self.remedy_in_words()}")
                for i in _indices(alive & ~(gap <= allowed(self.system, q[alive])))}

    def _of_contacts(self, t: float, q: np.ndarray, v: np.ndarray, alive: np.ndarray
                     ) -> dict[Index, tuple[str, str]]:
        if self._through is None:
            return {}
        with np.errstate(all="ignore"):
            sunk = self.system.outputs(ALL_CONTACTS, t=t, q=q, v=v)[2] >= self._through
        names = [x.name for x in touching(self.system)]
        return {i: ("", sinks(names[int(np.argmax(sunk[i]))], t))
                for i in _indices(sunk.any(-1) & alive)}

    def _time(self, i: Index, k: int) -> float:
        return self.plan.begin + float(self._errors.at[i][k])

    def remedy_in_words(self) -> str:
        """Returns a remedy that was tried; for batches and controllers, which are not tried, one
        without a number."""
        if self.remedy and not self.driven and not self.start[0].ndim > 1:
            return self.remedy(self.system, self.plan, self.start)
        return UNTRIED


class _Worst:
    """The largest errors so far, and the times since which they have been too large."""

    def __init__(self, lead: tuple[int, ...], count: int, run: float):
        self.worst, self.at = np.zeros((*lead, count)), np.zeros((*lead, count))
        self._run, self._now = run, 0.0
        self._since = np.full((*lead, count), np.inf)

    def add(self, at: float, errors: np.ndarray, allowed: np.ndarray) -> None:
        """Notes errors at this time after the start, and the allowed ones."""
        new = errors > self.worst
        self.worst, self.at = np.where(new, errors, self.worst), np.where(new, at, self.at)
        bad, self._now = ~(errors <= allowed), at
        self._since = np.where(bad, np.minimum(self._since, at), np.inf)

    def beyond(self, allowed: np.ndarray, last: bool) -> np.ndarray:
        """Mask of the errors that are too large: at the end, the last or the largest one; before,
        the errors that have been too large for a tenth of the run."""
        if last:
            wrong: np.ndarray = ~(self.worst <= allowed) | np.isfinite(self._since)
            return wrong
        result: np.ndarray = self._now - self._since >= _PERSISTENT * self._run
        return result


def _indices(mask: np.ndarray) -> list[Index]:
    """Returns the places where the mask is true."""
    return [tuple(i) for i in np.argwhere(mask).tolist()]


def _ratio(x: float, y: float) -> float:
    """x/y; infinite where y is not positive."""
    return float(x / y) if y > 0 else np.inf
