"""Finds settings that make a run right: the largest of the halved steps with which it is, tried
before it is named."""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np

from coscrew_codegen.program.values.formats import DOUBLE, Precision
from coscrew_codegen.scene.integrators import DEFAULT, INTEGRATOR_NAMED
from coscrew_codegen.simulation.check.divergence_monitor import Alarm
from coscrew_codegen.simulation.check.error_limits import AGREED, ALLOWED
from coscrew_codegen.simulation.check.motion_error import Extent, StateParts
from coscrew_codegen.simulation.check.windows import in_double
from coscrew_codegen.simulation.plan import Plan, Stop, Trajectory
from coscrew_codegen.simulation.run import integrate
from coscrew_codegen.simulation.system import State, System

HALVINGS = 12
TIGHT = 1e-5
"""Tolerances of SciPy's integrators up to which runs are not repeated with smaller ones."""
_LEAST_RTOL = 1e-13  # which SciPy's integrators take
MOST = 4_000_000
"""Velocities times steps that trials, or reference motions, may take: about a second."""
_DOUBTED = 200_000
"""Velocities times steps of a run up to which all of it is compared with one in half steps: about
50 ms."""
_SEEN = 100
"""Samples with which such a run is compared, at least."""
_POLYNOMIAL = 2.0
"""Least ratio of the times at which an error reaches ALLOWED and a tenth of it for an error that
adds up as t or t²: in chaos the ratio is far smaller, in bounces it is 1."""
LADDERS = (8, 64, 512), (4, 16), (2, 4)
"""Divisors of the step for motions that may become the reference."""
SAMPLES = 2000
"""Number of samples at which a motion is compared; at most twice as many."""


@dataclass(frozen=True)
class ReferenceStep:
    """A motion that smaller steps do not change, with the time up to which this holds."""

    q: np.ndarray
    v: np.ndarray
    t: np.ndarray
    until: float  # of t: later, motions with smaller steps differ
    step: float
    end: float  # of the plan, before which the motion may stop
    h: float  # the steps of runs that are compared with it

    @property
    def stops(self) -> bool:
        """True if it stops before the end, because it is no longer finite."""
        return bool(self.t[-1] < self.end)

    @property
    def resolved(self) -> bool:
        """True if it is known to the end."""
        return bool(self.until >= self.end)


@dataclass(frozen=True)
class Error:
    """The largest error of a motion, relative to the size of the part that has it."""

    relative: float
    part: str
    joint: str
    t: float


def affordable(system: System, steps: float) -> bool:
    """Returns whether so many steps take no more than some seconds."""
    return bool(steps * max(1, system.functions.nv) <= MOST)


def reference(system: System, planned: Plan, start: State | None = None) -> ReferenceStep:
    """The motion at the plan's samples, by the default integrator in double precision, with steps
    of 1/8, 1/64, 1/512 of the plan's, until two agree; with larger ones if these take long."""
    exact, steps = in_double(system), (planned.until - planned.begin) / planned.step
    parts, start = StateParts(exact), _in_double(system.start() if start is None else start)
    first, *others = next((x for x in LADDERS if affordable(exact, steps * x[1])), LADDERS[-1])
    before, until, divisor = _finer(exact, planned, start, first), planned.begin, first
    for finer in others:
        if until > planned.begin and not affordable(exact, steps * finer):
            break
        now = _finer(exact, planned, start, finer)
        until, before, divisor = _agreed(parts, planned.step, before, now), now, finer
        if until >= planned.until:
            break
    return ReferenceStep(before.q, before.v, before.t, until, planned.step / divisor, planned.until,
                         planned.step)


def _in_double(start: State) -> State:
    q, v = start
    return q.astype(float), v.astype(float)


def _finer(system: System, planned: Plan, start: State, divisor: int) -> Trajectory:
    finer = replace(planned, integrator=DEFAULT, step=planned.step / divisor, finer=divisor)
    return integrate(system, finer, start=start)


def _agreed(parts: StateParts, h: float, x: Trajectory, y: Trajectory) -> float:
    """The time until which two motions agree."""
    n = min(len(x.t), len(y.t))
    apart = parts.distances(parts.places(x.q[:n]), parts.places(y.q[:n]))
    beyond = (apart > AGREED * ALLOWED * sizes(parts, DOUBLE, h, y)).any(-1)
    return float(y.t[-1] if n == len(y.t) and not beyond.any() else
                 y.t[max(0, int(np.argmax(beyond)) - 1 if beyond.any() else n - 1)])


def sizes(parts: StateParts, precision: Precision, h: float, motion: Trajectory | ReferenceStep
          ) -> np.ndarray:
    """The sizes of the parts in a motion that is judged for runs in this precision and in steps of
    h.  (k)."""
    extent = Extent.since(parts, precision, h, motion.q[0], motion.v[0])
    extent.add(motion.t - motion.t[0], parts.places(motion.q))
    return extent.sizes


def resting(system: System, motion: ReferenceStep) -> bool:
    """Returns whether no part moves farther than a resting one may."""
    parts = StateParts(in_double(system))
    result = sizes(parts, system.precision, motion.h, motion)
    return bool(motion.resolved and (result <= parts.least).all())


def error(system: System, trajectory: Trajectory, true: ReferenceStep) -> Error:
    """The largest error of a motion while the reference is known."""
    return _errors(StateParts(in_double(system)), system.precision, trajectory, true).largest


@dataclass(frozen=True)
class _Errors:
    """Errors of a motion's parts at times when the reference is known, relative to their sizes."""

    parts: StateParts
    t: np.ndarray
    relative: np.ndarray  # (n, k)

    @property
    def largest(self) -> Error:
        """The largest one."""
        if not self.relative.size:
            return Error(0.0, "none", "", 0.0)
        at, k = np.unravel_index(int(np.argmax(self.relative)), self.relative.shape)
        part = self.parts.parts[k]
        return Error(float(self.relative[at, k]), part.name, part.joint, float(self.t[at]))

    @property
    def add_up(self) -> bool:
        """True if the largest error became too large no faster than by adding up."""
        if not self.relative.size:
            return False
        grown = self.relative[:, self.relative.max(0).argmax()]
        first = [float(self.t[int(np.argmax(grown > x))]) - float(self.t[0])
                 for x in (ALLOWED / 10, ALLOWED)]
        return bool(grown.max() > ALLOWED and first[1] >= _POLYNOMIAL * first[0])


def _errors(parts: StateParts, precision: Precision, trajectory: Trajectory, true: ReferenceStep
            ) -> _Errors:
    known = true.t[true.t <= true.until]
    _, here, there = np.intersect1d(trajectory.t, known, assume_unique=True, return_indices=True)
    apart = parts.distances(parts.places(trajectory.q[here].astype(float)),
                            parts.places(true.q[there]))
    return _Errors(parts, known[there], apart / sizes(parts, precision, true.h, true))


def remedy(system: System, planned: Plan, start: State | None = None) -> str:
    """A sentence on what makes a run right, all of it tried: a step, or another integrator."""
    planned = dense(as_taken(planned))
    return advised(system, planned, reference(system, planned, start), start)


def loose(system: System, planned: Plan, trajectory: Trajectory, start: State) -> Stop | None:
    """Returns why the motion of SciPy's integrator is wrong (a motion with a sixteenth of the
    tolerances differs), or None.  Tolerances up to TIGHT are not doubted."""
    if trajectory.stopped or max(planned.rtol, planned.atol) <= TIGHT:
        return None
    first, before, now = Error(0.0, "", "", 0.0), trajectory, planned
    for tighter in _tightened(planned):
        motion = integrate(system, tighter, start=start)
        result = _differ(system, planned, before, motion)
        if result.relative <= ALLOWED:
            helps = f"take rtol = {now.rtol:.3g} and atol = {now.atol:.3g}"
            break
        first, before, now = first if first.part else result, motion, tighter
    else:
        helps = f"no rtol down to {now.rtol:.2g} is small enough"
    return _stop(first, "the tolerances are too large", helps) if first.part else None


def drifting(system: System, planned: Plan, trajectory: Trajectory, start: State,
             momentum: np.ndarray | None = None) -> Stop | None:
    """Returns why a motion is wrong although no window of the Alarm shows it, or None.  A motion is
    wrong if it differs from one with steps of half the length (by the default integrator, if the
    run's loses bounces) and from the reference, provided that the reference is known to the end or
    the errors add up.  Runs that are long, stopped or in pure NumPy are not examined."""
    planned = as_taken(planned)
    steps = (planned.until - planned.begin) / planned.step
    compiled = system.origin and system.origin.compiled
    if trajectory.stopped or not compiled or steps * system.functions.nv > _DOUBTED:
        return None

    def run(how: Plan) -> Trajectory:
        return integrate(system, how, start=start, momentum=momentum)

    if _SEEN <= len(trajectory.t) <= SAMPLES:
        seen, whole = planned, trajectory
    else:
        seen = replace(planned, every=planned.step * max(1, round(steps / (2 * _SEEN))), also=())
        whole = run(seen)
    loses = INTEGRATOR_NAMED[planned.integrator].damps_bounces and system.has("parts")
    half = run(replace(seen, step=planned.step / 2, finer=2,
                       integrator=DEFAULT if loses else planned.integrator))
    if _differ(system, planned, whole, half).relative <= ALLOWED / 4:
        return None
    return _proven(system, dense(planned), run, start)


def _proven(system: System, planned: Plan, run: Callable[[Plan], Trajectory], start: State
            ) -> Stop | None:
    """Returns why a doubted motion is wrong; None if that is not known."""
    true, exact = reference(system, planned, start), in_double(system)
    result = _errors(StateParts(exact), system.precision, run(planned), true)
    if true.stops or result.largest.relative <= ALLOWED or not (true.resolved or result.add_up):
        return None
    why = ("single precision does not resolve it"
           if system.precision is not DOUBLE and _right(exact, planned, true, start)
           else "the step is too large")
    return _stop(result.largest, why, advised(system, planned, true, start))


def _stop(error: Error, why: str, helps: str) -> Stop:
    return Stop(0, error.t, error.joint, f"{why} at t = {error.t:.9g} s: {error.part} is off by "
                f"{error.relative:.2g} of the way it moves; {helps}")


def _differ(system: System, planned: Plan, motion: Trajectory, other: Trajectory) -> Error:
    """The largest difference of a motion from another, which has the same samples."""
    (q, v), end = _in_double((other.q, other.v)), float(other.t[-1])
    true = ReferenceStep(q, v, other.t, end, 0.0, end, planned.step)
    return _errors(StateParts(system), system.precision, motion, true).largest


def as_taken(planned: Plan) -> Plan:
    """The plan with the length of the steps that it takes: samples may shorten them."""
    return replace(planned, step=planned.steps(min(planned.every,
                                                   planned.until - planned.begin))[1])


def dense(planned: Plan) -> Plan:
    """The plan sampled at its steps, or at some of them."""
    return thinned(replace(planned, every=planned.step, also=()))


def thinned(planned: Plan) -> Plan:
    """The plan with a part of its samples: the first ones and every 2^n-th."""
    times = planned.samples
    stride = 2**max(0, math.ceil(math.log2(len(times) / SAMPLES)))
    return replace(planned, every=planned.every * stride,
                   also=(*planned.also, *times[1:17].tolist()) if stride > 1 else planned.also)


def advised(system: System, planned: Plan, true: ReferenceStep, start: State | None = None) -> str:
    """The sentence of `remedy` for a plan whose reference is known."""
    if true.stops:
        return f"so are motions with steps down to {true.step:.2g} s"
    if settings := _helping(system, planned, true, start):
        return f"take {', or '.join(settings)}"
    if system.precision is not DOUBLE:
        exact = in_double(system)
        if _right(exact, planned, true, start):
            return "take --precision double"
        if settings := _helping(exact, planned, true, start):
            return f"take {', or '.join(f'--precision double and {x}' for x in settings)}"
    if planned.adaptive:
        least = min([planned.rtol, *(x.rtol for x in _tightened(planned))])
        return f"no rtol down to {least:.2g} is small enough"
    smallest = planned.step / 2**max(0, len(tuple(_halved(system, planned))))
    return (f"no step down to {smallest:.2g} s is small enough" if smallest < planned.step
            else "smaller steps were not tried, since they would take long")


def _helping(system: System, planned: Plan, true: ReferenceStep, start: State | None
             ) -> list[str]:
    """Returns settings that make the run right in its precision: "a step of 0.01 s", "integrator
    leapfrog"."""
    settings = []
    if planned.adaptive:
        for tighter in _tightened(planned):
            if _right(system, tighter, true, start):
                return [f"rtol = {tighter.rtol:.3g} and atol = {tighter.atol:.3g}"]
    elif step := largest_step(system, planned, true, start):
        settings.append(f"a step of {step:g} s")
    if planned.integrator != DEFAULT and _right(
            system, replace(planned, integrator=DEFAULT), true, start):
        settings.append(f"integrator {DEFAULT}")
    return settings


def _tightened(planned: Plan) -> tuple[Plan, ...]:
    """The plan with ever smaller tolerances, which double precision can meet."""
    rtols = [planned.rtol / 16**n for n in range(1, 12)]
    return tuple(replace(planned, rtol=x, atol=planned.atol * (x / planned.rtol))
                 for x in rtols if x >= _LEAST_RTOL)


def largest_step(system: System, planned: Plan, true: ReferenceStep, start: State | None = None
                 ) -> float:
    """The largest of the halved steps with which the run is right; 0 if there is none."""
    return next((_shortened(x.step) for x in _halved(system, planned)
                 if _right(system, x, true, start)), 0.0)


def _shortened(step: float) -> float:
    """The step with two or three digits, no longer than it was: at least 0.97 of it."""
    for digits in (2, 3):
        unit = 10.0**(math.floor(math.log10(step)) + 1 - digits)
        result = float(f"{math.floor(step / unit * (1 + 1e-12)) * unit:.{digits}g}")
        if result >= 0.97 * step:
            break
    return result


def _halved(system: System, planned: Plan) -> Iterator[Plan]:
    for n in range(1, HALVINGS + 1):
        step = planned.step / 2**n
        if not affordable(system, (planned.until - planned.begin) / step):
            return
        yield replace(planned, step=step)


def _right(system: System, planned: Plan, true: ReferenceStep, start: State | None) -> bool:
    """Returns whether the run reaches its end, is right, and passes the Alarm, which takes most of
    the time and runs last."""
    for alarm in (None, Alarm):
        trajectory = integrate(system, planned, alarm=alarm, start=start)
        if trajectory.stopped or error(system, trajectory, true).relative > ALLOWED:
            return False
    if true.resolved:
        return True
    own = reference(system, planned, start)  # which its step may resolve
    return own.resolved and error(system, trajectory, own).relative <= ALLOWED
