"""Plan and trajectory: the settings of a run, and its result.  Frozen data."""

import math
from dataclasses import dataclass
from numbers import Real

import numpy as np

from coscrew_codegen.scene.integrators import ADAPTIVE, INTEGRATOR_NAMED, NAMES
from coscrew_codegen.scene.names import or_mean
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.system import System

_ROUND_OFF = 1e-6  # of a step: 0.01 / 1e-3 is 10 steps, not 11
_SAME = 1e-6  # of `every`: times closer than this count as one
MOST_SAMPLES = 10_000_000
MOST_STEPS = 10**12  # weeks even for the fastest scenes


@dataclass(frozen=True)
class Plan:
    """Settings of an integration: times of its end and of its samples, in s, and its integrator;
    `step` is for emitted integrators, rtol and atol for SciPy's; `also` are further times to sample
    at.

    The default integrator splits a step in which a limit is hit into parts, whose length hardly
    depends on the step.  With `finer` = 2 the parts are half as long.  The run starts at `begin`:
    after 0 if it continues another."""

    until: float
    every: float
    integrator: str
    step: float
    rtol: float
    atol: float
    also: tuple[float, ...] = ()
    finer: int = 1
    begin: float = 0.0

    @property
    def adaptive(self) -> bool:
        """True if SciPy integrates."""
        return self.integrator in ADAPTIVE

    def steps(self, interval: float) -> tuple[int, float]:
        """(number, length) of the steps from one sample to the next: the fewest of equal length
        that are no longer than `step`.  Intervals of `every` differ by rounding of their ends; they
        all take the same steps."""
        if math.isclose(interval, self.every, rel_tol=_SAME):
            interval = self.every
        count = max(1, math.ceil(interval / self.step - _ROUND_OFF))
        h = interval / count
        return count, self.step if math.isclose(h, self.step, rel_tol=_ROUND_OFF) else h

    @property
    def samples(self) -> np.ndarray:
        """The times of the samples: the beginning, multiples of `every`, `also`, and the end.

        A beginning that is a multiple except for rounding is that multiple."""
        grid = self.every * np.arange(math.floor(self.until / self.every) + 2)
        also = [t for t in self.also if 0 < t < self.until]
        inner = np.sort(np.concatenate((grid[1:], also)))
        inner = inner[inner < self.until - _SAME * self.every]
        apart = np.diff(inner, prepend=0) > _SAME * self.every
        inner, near = inner[apart], _SAME * self.every
        begin = next(iter(grid[np.abs(grid - self.begin) <= near]), self.begin)
        return np.concatenate(([begin], inner[inner > begin + near], [self.until]))


@dataclass(frozen=True)
class Stop:
    """Place and cause of the early end of a run, or of a member of a batch."""

    member: int
    t: float
    joint: str  # "" if none in particular
    cause: str  # a sentence with all of it, and with a remedy


@dataclass(frozen=True)
class Trajectory:
    """States at the times of samples; `stopped` says where and why, if it stopped before the end.

    In a batch the states have a leading axis of members; samples of a member after its stop are
    NaN."""

    t: np.ndarray  # (n)
    q: np.ndarray  # (…, n, nq)
    v: np.ndarray  # (…, n, nv)
    steps: int
    seconds: float  # that the integration took
    stopped: str = ""
    interrupted: bool = False
    failed: tuple[Stop, ...] = ()
    held: np.ndarray | None = None  # (…, n, np): the parameters, where a controller sets some
    momentum: np.ndarray | None = None  # of floating bases, which the run kept


def plan(system: System, until: float | None = None, step: float | None = None,
         integrator: str | None = None, every: float | None = None,
         also: tuple[float, ...] = (), begin: float = 0.0) -> Plan:
    """The scene's plan with these settings in place of its own.  Raises SimulateError."""
    run = system.scene.run
    until, step, every = (default if given is None else seconds(name, given)
                          for name, given, default in (("until", until, run.duration),
                                                       ("step", step, run.step),
                                                       ("every", every, system.scene.every)))
    made = Plan(until, every, known(run.integrator if integrator is None else integrator), step,
                *tolerances(system), also, begin=begin)
    called = INTEGRATOR_NAMED[made.integrator].step_name
    if called and not system.has(called):
        raise SimulateError(f"integrator {made.integrator}: {called} is not among the selected "
                            f"functions; wanted functions = [\"default\", {called!r}]")
    for name, value in (("until", made.until), ("step", made.step), ("every", made.every)):
        if not (math.isfinite(value) and value > 0):
            raise SimulateError(f"{name}: wanted a positive number of seconds; got {value}")
    if made.until <= begin:
        raise SimulateError(f"until: wanted more than {begin:.9g} s, where the run starts; got "
                            f"{made.until:.9g}")
    if made.until / made.step > MOST_STEPS:
        raise SimulateError(f"{made.until:g} s are {made.until / made.step:.3g} steps of "
                            f"{made.step:g} s; wanted at most {MOST_STEPS:.0e}")
    if made.until / made.every > MOST_SAMPLES:
        raise SimulateError(f"{made.until:g} s are {made.until / made.every:.3g} samples, one "
                            f"every {made.every:g} s; wanted at most {MOST_SAMPLES}")
    return made


def seconds(name: str, given: object) -> float:
    """A time as Python's float, whose digits provenance holds completely.  Raises SimulateError."""
    if isinstance(given, (bool, np.bool_)) or not isinstance(given, Real):
        raise SimulateError(f"{name}: wanted a number of seconds; got {given!r}")
    try:
        return float(given)
    except OverflowError:  # of a huge whole number
        return math.inf


def known(integrator: object) -> str:
    """The name of an integrator.  Raises SimulateError if there is none of this name."""
    if isinstance(integrator, str) and integrator in NAMES:
        return integrator
    hint = or_mean(integrator, NAMES) if isinstance(integrator, str) else ""
    raise SimulateError(f"integrator: {integrator!r}; wanted one of {', '.join(NAMES)}{hint}")


def tolerances(system: System) -> tuple[float, float]:
    """The scene's (rtol, atol), but at least 16 spacings of the precision: with less, estimates of
    errors are noise and steps shrink without end.  SciPy accepts no rtol below 100 spacings in
    double."""
    least = max(16 * float(np.finfo(system.dtype).eps), 100 * float(np.finfo(float).eps))
    return max(system.scene.run.rtol, least), max(system.scene.run.atol, least)
