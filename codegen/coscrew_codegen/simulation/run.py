"""Integrates a scene's equations of motion and samples the states.

Emitted integrators take ceil(interval / step) equal steps between two samples, so that samples are
at the ends of steps.  SciPy's choose their steps by tolerances and are sampled by their
interpolants; they stop exactly at the end.
"""

import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from copy import copy
from functools import partial
from itertools import pairwise

import numpy as np

from coscrew_codegen.runtime.compiled_calls import Take
from coscrew_codegen.scene.integrators import DEFAULT, INTEGRATOR_NAMED
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.check.divergence_monitor import UNTRIED, Alarm
from coscrew_codegen.simulation.controlled_run import Driven
from coscrew_codegen.simulation.plan import Plan, Stop, Trajectory
from coscrew_codegen.simulation.system import Sampler, State, System, Watch

_AT_ONCE = 400  # steps per call of C, which Ctrl-C cannot interrupt, and between looks of the Alarm
_KEPT = 100  # steps after which rounding errors of momentum are removed

Alarming = Callable[[System, Plan, State], Alarm]
Sampled = Iterator[tuple[np.ndarray, np.ndarray, int, tuple[Stop, ...]]]
Advance = Callable[[int, int, float, float, np.ndarray, np.ndarray], State]
"""Maps (n, k, t, h, q, v) to q and v after n steps of h from t, the first of them the run's k-th.
"""


def integrate(system: System, plan: Plan, watch: Watch | None = None,
              alarm: Alarming | None = None, start: State | None = None,
              driven: Driven | None = None, momentum: np.ndarray | None = None,
              failed: tuple[Stop, ...] = ()) -> Trajectory:
    """Integrates from `start`, by default the scene's; the result is a batch if the start, or the
    parameters of the system, have a leading axis.

    A state that is not finite, a failing solver, or an interrupt (Ctrl-C) ends a trajectory early;
    samples so far are kept.  Runs of emitted integrators also stop if an Alarm, made by `alarm`,
    reports that the motion is wrong.  Other members of a batch continue; samples of stopped members
    are NaN. `driven` sets parameters during the run.  `momentum` of floating bases is that of the
    start, unless the run continues another, whose stopped members are `failed`. `watch` is called
    at each sample and in between: after every step of SciPy and of pure NumPy, else after 400
    steps, or 100 where momentum is kept."""
    times, (q, v) = plan.samples, start or system.start()
    alive = np.ones(q.shape[:-1], bool)
    for stop in failed:
        alive[stop.member] = False
    for i in np.argwhere(alive & ~_finite(q, v))[:1].tolist():
        raise SimulateError(f"the start is not finite: {system.lacking(q[*i], v[*i])}")
    if momentum is not None:
        momentum = momentum.astype(system.dtype)
    elif INTEGRATOR_NAMED[plan.integrator].keeps_momentum:
        momentum = system.momentum(q, v)
    if plan.adaptive:
        run = _adaptive(system, plan, times, q, v, watch)
    else:
        run = fixed(system, plan, times, q, v, watch, alarm, driven, momentum, alive.copy())
    if driven:
        with np.errstate(all="ignore"):
            driven.update(driven.steps, plan.begin, q, v)
    samples = _Samples(times, q, v, driven, alive, failed)
    began = time.perf_counter()
    interrupted, at = "", plan.begin
    try:
        for q, v, steps, stops in run:  # noqa: B020  the state goes on
            samples.add(q, v, steps, stops)
            if samples.ended:
                break
            at = float(times[samples.count - 1])
            if watch:
                watch(at, q, v)
    except KeyboardInterrupt:
        interrupted = f"interrupted after t = {at:.9g} s"
    return samples.trajectory(time.perf_counter() - began, interrupted, momentum)


class _Samples:
    """The samples of a run so far: one after the other, so that each is written at once."""

    def __init__(self, times: np.ndarray, q: np.ndarray, v: np.ndarray, driven: Driven | None,
                 alive: np.ndarray, failed: tuple[Stop, ...]):
        lead, self._driven = q.shape[:-1], driven
        given = [q, v, *([np.broadcast_to(driven.p, (*lead, driven.p.shape[-1]))]
                         if driven else [])]
        self._kept = [np.full((len(times), *x.shape), np.nan, x.dtype) for x in given]
        for kept, x in zip(self._kept, given, strict=True):
            kept[0] = x
        self._times, self._alive, self._steps = times, alive, 0
        self._stops = list(failed)
        self.count = 1

    @property
    def ended(self) -> bool:
        """True if all members have stopped."""
        return not self._alive.any()

    def add(self, q: np.ndarray, v: np.ndarray, steps: int, stops: tuple[Stop, ...]) -> None:
        """The next sample, before which members stopped."""
        self._stops += stops
        self._steps = steps
        for stop in stops:
            self._alive[stop.member if self._alive.ndim else ()] = False
        if self.ended:
            return
        p = [self._driven.p] if self._driven else []
        for kept, x in zip(self._kept, (q, v, *p), strict=True):
            kept[self.count] = x
            if self._stops:
                kept[self.count][~self._alive] = np.nan
        self.count += 1

    def trajectory(self, seconds: float, interrupted: str, momentum: np.ndarray | None
                   ) -> Trajectory:
        """The whole trajectory: of a single run up to its stop, of a batch up to the end."""
        single = not self._alive.ndim
        stopped = interrupted or (self._stops[0].cause if self._stops and single else "")
        n = self.count if single or interrupted else len(self._times)
        q, v, *held = (np.moveaxis(x[:n], 0, -2) for x in self._kept)
        return Trajectory(self._times[:n], q, v, self._steps, seconds, stopped, bool(interrupted),
                          tuple(self._stops), held[0] if held else None, momentum)


def _adaptive(system: System, plan: Plan, times: np.ndarray, q: np.ndarray, v: np.ndarray,
              watch: Watch | None = None) -> Sampled:
    from coscrew_codegen.simulation.solvers.adaptive import adaptive  # imports SciPy

    for reached, speeds, steps, stopped in adaptive(system, plan, times, q, v, watch):
        yield reached, speeds, steps, (Stop(0, float("nan"), "", stopped),) if stopped else ()


def fixed(system: System, plan: Plan, times: np.ndarray, q: np.ndarray, v: np.ndarray,
          watch: Watch | None = None, alarm: Alarming | None = None, driven: Driven | None = None,
          momentum: np.ndarray | None = None, alive: np.ndarray | None = None) -> Sampled:
    """Yields (q, v, steps so far, members that stopped) at each sample after the first, for the
    members that are `alive`."""
    integrator = INTEGRATOR_NAMED[plan.integrator]
    earlier = taken = driven.steps if driven else 0
    advance = driven.advance if driven else _advance(system, plan, watch)
    look = alarm(system, plan, (q, v)) if alarm else None
    at_once = _KEPT if momentum is not None else _AT_ONCE
    alive = np.ones(q.shape[:-1], bool) if alive is None else alive
    plain = not (driven or alive.ndim or momentum is not None)
    sampler = _sampler(system, plan) if plain else None
    waiting = deque(pairwise(times))
    with np.errstate(all="ignore"):
        while waiting:
            ahead = _samples_ahead(sampler, plan, waiting, look, q, v) if sampler else ()
            for n, q, v in ahead:
                waiting.popleft()
                taken += n
                yield q, v, taken - earlier, ()
            start, end = waiting.popleft()
            count, h = plan.steps(end - start)
            before, stops = (q, v, copy(driven)), tuple[Stop, ...]()
            for i in range(0, count, at_once):
                if watch and i:
                    watch(start + i * h, q, v)
                more = min(at_once, count - i)
                q, v = advance(more, taken + i, start + i * h, h, q, v)
                if integrator.keeps_momentum:
                    q, v = system.kept(momentum, start + (i + more) * h, q, v)
                if look and i + more < count:
                    look.system = system.at(driven.p) if driven else system
                    stops += _stops(look, alive, more, start + (i + more) * h, h, q, v)
                    if not alive.any():
                        break
            stops += driven.refused(alive) if driven else ()
            _end(alive, stops)
            lost = alive & ~_finite(q, v)
            if lost.any():
                helps = look.remedy_in_words() if look else UNTRIED
                stops += _lost(system, plan, lost, (start, h, count, taken), helps, *before)
                _end(alive, stops)
            taken += i + more
            if driven:
                driven.update(taken, end, q, v)
            if look:
                look.system = system.at(driven.p) if driven else system
                stops += _stops(look, alive, more, end, h, q, v)
            yield q, v, taken - earlier, stops


def _samples_ahead(sampler: Sampler, plan: Plan, waiting: Iterable[tuple[float, float]],
                   look: Alarm | None, q: np.ndarray, v: np.ndarray
                   ) -> Iterator[tuple[int, np.ndarray, np.ndarray]]:
    """(steps, q, v) of the next samples, before the last, as long as they are finite and the Alarm
    only counts steps: together they take a third of the time."""
    most = min(_AT_ONCE, look.idle) if look else _AT_ONCE
    takes: list[Take] = []
    for start, end in waiting:
        count, h = plan.steps(end - start)
        most -= count
        if most < 0 or end >= plan.until:
            break
        takes.append((count, start, h))
    if len(takes) < 2:
        return
    all_q, all_v = sampler(takes, q, v)
    lost = np.flatnonzero(~_finite(all_q, all_v))
    for k, (count, _, _) in enumerate(takes[:lost[0] if len(lost) else None]):
        if look:
            look.count(count)
        yield count, all_q[k], all_v[k]


def _stops(look: Alarm, alive: np.ndarray, steps: int, t: float, h: float, q: np.ndarray,
           v: np.ndarray) -> tuple[Stop, ...]:
    """The members that are wrong at t, after so many further steps; they are removed from `alive`.
    """
    result = look(steps, t, h, q, v, alive & _finite(q, v))
    stops = tuple(Stop(i[0] if i else 0, float(t), *x) for i, x in result.items())
    _end(alive, stops)
    return stops


def _end(alive: np.ndarray, stops: tuple[Stop, ...]) -> None:
    """Notes that these members have stopped."""
    for x in stops:
        alive[x.member if alive.ndim else ()] = False


def _finite(q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Returns the mask of finite states."""
    result: np.ndarray = np.isfinite(q).all(-1) & np.isfinite(v).all(-1)
    return result


def _advance(system: System, plan: Plan, watch: Watch | None = None) -> Advance:
    """Returns the stepping function of the plan's integrator, with fixed parameters."""
    step_name, finer = INTEGRATOR_NAMED[plan.integrator].step_name, _finer(system, plan)
    if finer == 1:
        step = system.stepper(step_name, watch)
    elif sampler := system.sampler(step_name, finer):
        step = partial(_last, sampler)
    else:
        step = _in_finer_parts(system, step_name, finer)
    return lambda n, k, t, h, q, v: step(n, t, h, q, v)


def _last(sampler: Sampler, n: int, t: float, h: float, q: np.ndarray, v: np.ndarray) -> State:
    """q and v after n steps."""
    (q,), (v,) = sampler(((n, t, h),), q, v)
    return q, v


def _sampler(system: System, plan: Plan) -> Sampler | None:
    """Returns the function that takes the steps to several samples, if it is compiled."""
    return system.sampler(INTEGRATOR_NAMED[plan.integrator].step_name, _finer(system, plan))


def _finer(system: System, plan: Plan) -> int:
    """The factor by which parts of split steps are shorter; 1 if steps are not split."""
    splits = INTEGRATOR_NAMED[plan.integrator].splits and system.has("parts")
    return plan.finer if splits else 1


def _in_finer_parts(system: System, step_name: str, finer: int
                    ) -> Callable[[int, float, float, np.ndarray, np.ndarray], State]:
    """Returns the stepping function of an integrator that splits steps, with parts shorter by the
    factor `finer`, in pure NumPy."""
    step = system.stepper(step_name)

    def steps(n: int, t: float, h: float, q: np.ndarray, v: np.ndarray) -> State:
        for k in range(n):
            parts = 1
            if system.call("closing_contacts", h=finer * h, q=q, v=v) > 0:
                parts = int(system.outputs("parts", h=finer * h, q=q, v=v)[0])
            q, v = step(parts, t + k * h, h / parts, q, v)
        return q, v

    return steps


def _lost(system: System, plan: Plan, lost: np.ndarray, interval: tuple[float, float, int, int],
          helps: str, q: np.ndarray, v: np.ndarray, driven: Driven | None) -> tuple[Stop, ...]:
    """The times and the joints at which states stop being finite in an interval (its start, the
    length and the number of its steps, steps before it); with the cause, if known, and a remedy."""
    (start, h, count, taken), rows = interval, np.flatnonzero(lost)
    if driven or not lost.ndim:
        advance = driven.advance if driven else _advance(system, plan)
        members = {int(row): (int(row) if lost.ndim else ()) for row in rows}
    else:  # the lost ones alone
        system, q, v = system.member(rows), q[rows], v[rows]
        advance, members = _advance(system, plan), {int(row): n for n, row in enumerate(rows)}
    stops = []
    for i in range(count):
        before, (q, v) = (q, v), advance(1, taken + i, start + i * h, h, q, v)
        t, finite = start + (i + 1) * h, _finite(q, v)
        for row, at in [x for x in members.items() if not finite[x[1]]]:
            joint_and_number = system.lacking(q[at], v[at])
            joint = joint_and_number.removeprefix("joint ").partition(": ")[0]
            cause = _cause(system.member(at), plan, h, before[0][at], before[1][at]) + helps
            stops.append(Stop(row, t, joint,
                              f"not finite at t = {t:.9g} s: {joint_and_number}{cause}"))
            del members[row]
    return (*stops, *(Stop(row, t, "", f"not finite before t = {t:.9g} s") for row in members))


def _cause(system: System, plan: Plan, h: float, q: np.ndarray, v: np.ndarray) -> str:
    """The cause, if known, of a failing step that starts at q, v."""
    splits = plan.integrator == DEFAULT and system.has("parts")
    if splits and np.isnan(system.outputs("parts", h=h, q=q, v=v)[1]):
        return "; a limit closes that is too stiff for parts of this step; "
    return "; "
