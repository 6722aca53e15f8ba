"""Measures accuracy against time: the error at a run's end and the run's time, by integrator,
precision and step."""

import math
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from coscrew_codegen.program.scene_functions import IntegratorStep
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.reports.cost.loops import CompiledLoops
from coscrew_codegen.reports.timing.intervals import FEWEST, Interval, interval
from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.scene.integrators import ADAPTIVE
from coscrew_codegen.simulation.plan import Plan, Trajectory
from coscrew_codegen.simulation.run import integrate
from coscrew_codegen.simulation.run_summary import RunOverrides
from coscrew_codegen.simulation.system import System, system

_TIGHTEST, _TIGHTEST_IMPLICIT = 1e-13, 1e-11
_ADAPTIVE = sorted(ADAPTIVE.items(), key=lambda x: x[1].implicit)
_PATIENCE = 20.0  # s: limit for a reference, or for a run with SciPy
_MOST_STEPS = 1_000_000
_DOUBLINGS = range(-6, 5, 2)  # of the scene's step
_TOLERANCES = (1e-3, 1e-5, 1e-7, 1e-9, 1e-11)
_REPEATS = 3  # of runs with SciPy, if they take at most _SHORT seconds
_SHORT = 1.0


@dataclass(frozen=True)
class ReferenceRun:
    """The state at the end, nearly exact."""

    words: str
    t: float
    q: np.ndarray
    v: np.ndarray
    error: float  # estimate of its error


@dataclass(frozen=True)
class Point:
    """A run: its error and its time."""

    integrator: str
    precision: str
    step: float  # s; the relative tolerance for SciPy's integrators
    steps: int
    time: Interval  # processor time in s; from shortest to longest if there are fewer than 6 runs
    error: float  # the largest error of a coordinate, in m or rad (quaternions: of a component)
    by: str  # C or Python


def error(system: System, q: np.ndarray, truth: ReferenceRun) -> float:
    """The largest error of a coordinate; q and -q of a quaternion are the same."""
    q = np.array(q, float)
    for places in system.quaternions:
        if np.dot(q[places], truth.q[places]) < 0:
            q[places] *= -1
    worst = np.max(np.abs(q - truth.q), initial=0)
    return float(worst) if math.isfinite(worst) else math.inf


def reference(system: System, until: float, digits: int | None) -> ReferenceRun | None:
    """The state at the end: to `digits` digits, if given; else by DOP853 with tolerances of 1e-13,
    or by Radau's method if that takes too long; None if that takes too long, too, and for scenes
    with states of effects, which only the default integrator moves."""
    if system.functions.states:
        return None
    if digits:
        from coscrew_codegen.reports.cost.exact_run import exact_end

        q, v, apart = exact_end(system, until, digits)
        return ReferenceRun(f"extrapolation with {digits} digits", until, q, v, apart)
    for name, scheme in _ADAPTIVE:
        tightest = _TIGHTEST_IMPLICIT if scheme.implicit else _TIGHTEST
        end, looser = (_end(system, until, name, tightest * slack) for slack in (1, 10))
        if end is not None and looser is not None:
            truth = ReferenceRun(f"{name}, rtol {tightest:g}", until, end.q[-1].astype(float),
                                 end.v[-1].astype(float), 0.0)
            return replace(truth, error=error(system, looser.q[-1], truth))
    return None


class _TooLong(Exception):
    pass


def _end(system: System, until: float, integrator: str, tolerance: float) -> Trajectory | None:
    """The run at this tolerance; None if it stops early or takes too long."""
    planned = Plan(until, until, integrator, until, tolerance, tolerance)
    deadline = time.monotonic() + _PATIENCE

    def watch(t: float, q: np.ndarray, v: np.ndarray) -> None:
        if time.monotonic() > deadline:
            raise _TooLong

    try:
        trajectory = integrate(system, planned, watch)
    except _TooLong:
        return None
    if trajectory.interrupted:
        raise KeyboardInterrupt
    return None if trajectory.stopped else trajectory


def work_precision(kernels: Kernels, library: CompiledLoops, planned: Plan, overrides: RunOverrides,
                   truth: ReferenceRun) -> Iterator[Point]:
    """A point for each integrator, precision and step."""
    yield from _in_c(kernels, library, planned, overrides, truth)
    for name, scheme in _ADAPTIVE:
        its = system(kernels, "double", dict(overrides.settings))
        for tolerance in _TOLERANCES[:4] if scheme.implicit else _TOLERANCES:
            samples: list[float] = []
            while len(samples) < (_REPEATS if sum(samples) < _SHORT else 1):
                began = time.thread_time()
                run = _end(its, planned.until, name, tolerance)
                samples.append(time.thread_time() - began)
            if run is None:
                break  # tighter tolerances would take even longer
            yield Point(name, "double", tolerance, run.steps, interval(np.array(samples)),
                        error(its, run.q[-1], truth), "Python")


def _in_c(kernels: Kernels, library: CompiledLoops, planned: Plan, overrides: RunOverrides,
          truth: ReferenceRun) -> Iterator[Point]:
    """The emitted integrators, timed in rounds: each run once per round."""
    runs = [(system(kernels, precision.name, dict(overrides.settings)), step, precision, steps)
            for precision in PRECISIONS for step in library.part.functions.steps
            for steps in _step_counts(planned)]

    def run(its: System, step: IntegratorStep, precision: Precision,
            steps: int) -> tuple[np.ndarray, float]:
        q, _v, seconds = library.run(step, precision, steps, planned.until / steps, tuple(its.p),
                                     its.start())
        return q, seconds

    rounds = [[run(*x) for x in runs] for _ in range(FEWEST)]
    for (its, step, precision, steps), result in zip(runs, zip(*rounds, strict=True), strict=True):
        yield Point(step.integrator, precision.name, planned.until / steps, steps,
                    interval(np.array([seconds for _, seconds in result])),
                    error(its, result[0][0], truth), "C")


def _step_counts(planned: Plan) -> list[int]:
    """Numbers of steps of a run, the fewest first."""
    first = planned.until / planned.step
    counts = {max(1, round(first * 2.0**-k)) for k in _DOUBLINGS}
    return sorted(n for n in counts if n <= _MOST_STEPS) or [_MOST_STEPS]
