"""Integrates a scene's equations of motion and samples the states on the way.

Emitted integrators take equal steps, no longer than asked for, that never span a sample: between
two samples there are ceil(interval / step) of them.  SciPy's choose their steps by tolerances and
are sampled through their interpolants; at the end they stop exactly.
"""

import time
from collections.abc import Callable, Iterator
from functools import partial
from itertools import pairwise

import numpy as np

from coscrew_codegen.integrator import Integrator
from coscrew_codegen.integrators import DEFAULT, named
from coscrew_codegen.simulate import SimulateError
from coscrew_codegen.simulate.alarm import Alarm
from coscrew_codegen.simulate.plan import Plan, Trajectory
from coscrew_codegen.simulate.system import State, System, Watch

_AT_ONCE = 10_000  # steps between two looks at Ctrl-C
_KEPT = 100  # steps after which momentum is what it was, to rounding

Alarming = Callable[[System, Plan, State], Alarm]
Sampled = Iterator[tuple[np.ndarray, np.ndarray, int, str]]


def integrate(system: System, plan: Plan, watch: Watch | None = None,
              alarm: Alarming | None = None) -> Trajectory:
    """The trajectory from the scene's start.  A state that is not finite, a solver that gives up,
    and an interrupt (Ctrl-C) end it early; what was sampled so far is kept.

    Runs of emitted integrators stop where an Alarm, made by `alarm`, says that the motion is not
    the scene's.
    `watch` is called with each sample as it is reached, and often enough in between to tell how far
    the run is: after every step of SciPy's and of pure NumPy's, else after 10000."""
    times, (q, v) = plan.samples, system.start()
    run = _adaptive if plan.adaptive else partial(fixed, alarm=alarm)
    sampled, stopped, interrupted, steps = [(q, v)], "", False, 0
    began, at = time.perf_counter(), 0.0
    if lacking := system.lacking(q, v):
        raise SimulateError(f"the start is not finite: {lacking}")
    try:
        for reached, velocity, steps, stopped in run(  # noqa: B007  steps are told at the end
                system, plan, times, q, v, watch):
            if stopped:
                break
            at = float(times[len(sampled)])
            sampled.append((reached, velocity))
            if watch:
                watch(at, reached, velocity)
    except KeyboardInterrupt:
        stopped, interrupted = f"interrupted after t = {at:.9g} s", True
    seconds = time.perf_counter() - began
    qs, vs = (np.array([state[i] for state in sampled], system.dtype) for i in (0, 1))
    return Trajectory(times[:len(sampled)], qs, vs, steps, seconds, stopped, interrupted)


def _adaptive(system: System, plan: Plan, *others: object) -> Sampled:
    from coscrew_codegen.simulate.adaptive import adaptive  # imports SciPy

    return adaptive(system, plan, *others)


def fixed(system: System, plan: Plan, times: np.ndarray, q: np.ndarray, v: np.ndarray,
          watch: Watch | None = None, alarm: Alarming | None = None) -> Sampled:
    """(q, v, steps so far, "") at each sample after the first, or where and why it stopped."""
    integrator = named(plan.integrator)
    step, taken = system.stepper(integrator.step_name, watch), 0
    if plan.finer > 1 and integrator.splits and system.has("parts"):
        step = _in_finer_parts(system, integrator, plan.finer)
    look = alarm(system, plan, (q, v)) if alarm else None
    kept = system.kept(q, v) if integrator.keeps_momentum else None
    at_once = _KEPT if kept else _AT_ONCE
    with np.errstate(all="ignore"):
        for start, end in pairwise(times):
            count, h = plan.steps(end - start)
            before = q, v
            for i in range(0, count, at_once):
                if watch and i:
                    watch(start + i * h, q, v)
                more = min(at_once, count - i)
                q, v = step(more, start + i * h, h, q, v)
                if kept:
                    v = kept(start + (i + more) * h, q, v)
            taken += count
            finite = np.isfinite(q).all() and np.isfinite(v).all()
            stopped = "" if finite else _where(system, plan, start, h, count, *before)
            if finite and look:
                stopped = look(count, end, h, q, v)
            yield q, v, taken, stopped


def _in_finer_parts(system: System, integrator: Integrator, finer: int
                    ) -> Callable[[int, float, float, np.ndarray, np.ndarray], State]:
    """An integrator that splits steps, with as many parts of a step as one has that is `finer`
    times as long."""
    step = system.stepper(integrator.step_name)

    def steps(n: int, t: float, h: float, q: np.ndarray, v: np.ndarray) -> State:
        for k in range(n):
            parts = 1
            if system.call("closing_contacts", h=finer * h, q=q, v=v) > 0:
                parts = int(system.call("parts", h=finer * h, q=q, v=v)[0])
            q, v = step(parts, t + k * h, h / parts, q, v)
        return q, v

    return steps


def _where(system: System, plan: Plan, start: float, h: float, count: int, q: np.ndarray,
           v: np.ndarray) -> str:
    """When, after how many of `count` steps from `start`, and in which joint the state stops being
    finite; why, and what helps."""
    step = system.stepper(named(plan.integrator).step_name)
    for i in range(count):
        before, (q, v) = (q, v), step(1, start + i * h, h, q, v)
        if lacking := system.lacking(q, v):
            break
    cause = _cause(system, plan, h, *before)
    return f"not finite at t = {start + (i + 1) * h:.9g} s: {lacking}{cause}"


def _cause(system: System, plan: Plan, h: float, q: np.ndarray, v: np.ndarray) -> str:
    """Why a step that starts here may fail, where it is known, and what helps."""
    if plan.integrator != DEFAULT:
        return f"; take a smaller step, or integrator {DEFAULT}"
    if system.has("parts") and np.isnan(system.call("parts", h=h, q=q, v=v)[1]):
        return "; a limit closes that is too stiff for parts of this step; take a smaller step"
    return "; take a smaller step"
