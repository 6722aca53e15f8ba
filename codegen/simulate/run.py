"""Integrates a scene's equations of motion and samples the states on the way.

Emitted integrators take equal steps, no longer than asked for, that never span a sample: between
two samples there are ceil(interval / step) of them.  SciPy's choose their steps by tolerances and
are sampled through their interpolants; at the end they stop exactly.
"""

import math
import time
from collections.abc import Callable, Iterator

import numpy as np

from coscrew_codegen.simulate import SimulateError
from coscrew_codegen.simulate.adaptive import adaptive
from coscrew_codegen.simulate.plan import Plan, Trajectory
from coscrew_codegen.simulate.system import System, Watch

_AT_ONCE = 10_000  # steps between two looks at Ctrl-C
_ROUND_OFF = 1e-6  # of a step: 0.01 / 1e-3 is 10 steps, not 11

Sampled = Iterator[tuple[np.ndarray, np.ndarray, int, str]]


def integrate(system: System, plan: Plan, watch: Watch | None = None) -> Trajectory:
    """The trajectory from the scene's start.  A state that is not finite, a solver that gives up,
    and an interrupt (Ctrl-C) end it early; what was sampled so far is kept.

    `watch` is called with each sample as it is reached, and often enough in between to tell how far
    the run is: after every step of SciPy's and of pure NumPy's, else after 10000."""
    times, (q, v) = plan.samples, system.start()
    run = adaptive if plan.adaptive else fixed
    sampled, stopped, interrupted, steps = [(q, v)], "", False, 0
    began, at = time.perf_counter(), 0.0
    if lacking := system.lacking(q, v):
        raise SimulateError(f"the start is not finite: {lacking}")
    try:
        for q, v, steps, stopped in run(system, plan, times, q, v, watch):
            if stopped:
                break
            at = float(times[len(sampled)])
            sampled.append((q, v))
            if watch:
                watch(at, q, v)
    except KeyboardInterrupt:
        stopped, interrupted = f"interrupted after t = {at:.9g} s", True
    seconds = time.perf_counter() - began
    qs, vs = (np.array([state[i] for state in sampled], system.dtype) for i in (0, 1))
    return Trajectory(times[:len(sampled)], qs, vs, steps, seconds, stopped, interrupted)


def fixed(system: System, plan: Plan, times: np.ndarray, q: np.ndarray, v: np.ndarray,
          watch: Watch | None = None) -> Sampled:
    """(q, v, steps so far, "") at each sample after the first, or where and why it stopped."""
    step, taken = system.stepper(f"step_{plan.integrator.replace('-', '_')}", watch), 0
    with np.errstate(all="ignore"):
        for start, end in zip(times, times[1:]):
            count = max(1, math.ceil((end - start) / plan.step - _ROUND_OFF))
            h = (end - start) / count
            h = plan.step if math.isclose(h, plan.step, rel_tol=_ROUND_OFF) else h
            before = q, v
            for i in range(0, count, _AT_ONCE):
                if watch and i:
                    watch(start + i * h, q, v)
                q, v = step(min(_AT_ONCE, count - i), start + i * h, h, q, v)
            taken += count
            finite = np.isfinite(q).all() and np.isfinite(v).all()
            yield q, v, taken, "" if finite else _where(system, step, start, h, count, *before)


def _where(system: System, step: Callable, start: float, h: float, count: int, q: np.ndarray,
           v: np.ndarray) -> str:
    """When, after how many of `count` steps from `start`, and in which joint the state stops being
    finite."""
    for i in range(count):
        if lacking := system.lacking(q, v):
            return f"not finite at t = {start + i * h:.9g} s: {lacking}"
        q, v = step(1, start + i * h, h, q, v)
    return f"not finite at t = {start + count * h:.9g} s: {system.lacking(q, v)}"
