"""Integrates a scene's equations of motion and samples the states.

Emitted integrators take ceil(interval / step) equal steps between two samples, so that samples are
at the ends of steps.  SciPy's choose their steps by tolerances and are sampled by their
interpolants; they stop exactly at the end.
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

_AT_ONCE = 10_000  # steps per call of C, which Ctrl-C cannot interrupt
_KEPT = 100  # steps after which rounding errors of momentum are removed

Alarming = Callable[[System, Plan, State], Alarm]
Sampled = Iterator[tuple[np.ndarray, np.ndarray, int, str]]


def integrate(system: System, plan: Plan, watch: Watch | None = None,
              alarm: Alarming | None = None) -> Trajectory:
    """The trajectory from the scene's start.

    A state that is not finite, a failing solver, and an interrupt (Ctrl-C) end it early; samples so
    far are kept.  Runs of emitted integrators also stop if an Alarm, made by `alarm`, reports that
    the motion is wrong.
    `watch` is called at each sample and in between: after every step of SciPy and of pure NumPy,
    else after 10000 steps."""
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


def _adaptive(system: System, plan: Plan, times: np.ndarray, q: np.ndarray, v: np.ndarray,
              watch: Watch | None = None) -> Sampled:
    from coscrew_codegen.simulate.adaptive import adaptive  # imports SciPy

    return adaptive(system, plan, times, q, v, watch)


def fixed(system: System, plan: Plan, times: np.ndarray, q: np.ndarray, v: np.ndarray,
          watch: Watch | None = None, alarm: Alarming | None = None) -> Sampled:
    """(q, v, steps so far, "") at each sample after the first; instead of "" the place and reason
    if the run stopped early."""
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
    """The steps of an integrator that splits steps, with parts shorter by `finer`."""
    step = system.stepper(integrator.step_name)

    def steps(n: int, t: float, h: float, q: np.ndarray, v: np.ndarray) -> State:
        for k in range(n):
            parts = 1
            if system.call("closing_contacts", h=finer * h, q=q, v=v) > 0:
                parts = int(system.outputs("parts", h=finer * h, q=q, v=v)[0])
            q, v = step(parts, t + k * h, h / parts, q, v)
        return q, v

    return steps


def _where(system: System, plan: Plan, start: float, h: float, count: int, q: np.ndarray,
           v: np.ndarray) -> str:
    """The time and the joint at which the state stops being finite, within `count` steps from
    `start`; with cause and remedy if known."""
    step = system.stepper(named(plan.integrator).step_name)
    for i in range(count):
        before, (q, v) = (q, v), step(1, start + i * h, h, q, v)
        if lacking := system.lacking(q, v):
            break
    cause = _cause(system, plan, h, *before)
    return f"not finite at t = {start + (i + 1) * h:.9g} s: {lacking}{cause}"


def _cause(system: System, plan: Plan, h: float, q: np.ndarray, v: np.ndarray) -> str:
    """Cause, if known, and remedy of a failing step that starts at q, v."""
    if plan.integrator != DEFAULT:
        return f"; take a smaller step, or integrator {DEFAULT}"
    if system.has("parts") and np.isnan(system.outputs("parts", h=h, q=q, v=v)[1]):
        return "; a limit closes that is too stiff for parts of this step; take a smaller step"
    return "; take a smaller step"
