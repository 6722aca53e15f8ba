"""What rounding costs: errors of functions in each tier and precision against 50 digits, and their
times."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial

import mpmath
import numpy as np

from coscrew_codegen.cost.exact_run import MULTIPRECISE
from coscrew_codegen.cost.states import Box, Reals, Values, joined, of_run, searched
from coscrew_codegen.formats import PRECISIONS
from coscrew_codegen.native.intervals import Interval
from coscrew_codegen.program.interpreter import interpreter
from coscrew_codegen.simulate.load import Kernels
from coscrew_codegen.simulate.plan import Trajectory
from coscrew_codegen.simulate.system import System, system

UNITS = {"inverse_dynamics": "N m or N", "forward_dynamics": "rad/s² or m/s²",
         "mass_matrix": "kg m², kg m or kg"}
"""The functions whose rounding is measured, and the units of their results."""

DIGITS = 50
PLACES = {"run": 16, "limits": 32, "search": 8}
"""How many states are of the run, between the limits of the joints, the worst of a search there (a
half of them in each precision)."""


@dataclass(frozen=True)
class Rounding:
    """The errors of a function's results in a tier and precision: the largest of a component."""

    function: str
    tier: str
    precision: str
    typical: float  # the median of all states, in the unit of the component
    worst: float
    digits: float  # that are right of the largest component at the worst state
    place: str  # where the worst state is from: run, limits, search
    time: Interval  # ns per call

    def better(self, other: "Rounding") -> bool:
        """Whether it is faster, with disjoint intervals, and at least as accurate."""
        return self.time.below(other.time) and self.worst <= other.worst


@dataclass(frozen=True)
class Variant:
    """The functions in a tier and precision."""

    tier: str
    system: System

    @property
    def precision(self) -> str:
        return self.system.precision.name


def variants(kernels: Kernels, settings: Mapping[str, float]) -> list[Variant]:
    """The scene's own functions and those in the tiers that it selects, in both precisions, at
    parameters of single precision."""
    known = dict(kernels.interface.parameters) | dict(settings)
    near = {name: float(np.float32(value)) for name, value in known.items()}
    own = [Variant("plain", system(kernels, p.name, near)) for p in PRECISIONS]
    return own + [Variant(tier, system(getattr(kernels, tier), p.name, near))
                  for tier in kernels.interface.tiers for p in PRECISIONS]


def measured(found: Sequence[Variant], box: Box, trajectory: Trajectory,
             timed: Callable[[str, Sequence[Variant], Values], Sequence[Interval]]
             ) -> list[Rounding]:
    """Every function in every variant, with its times at some states.  The first is plain in
    double; one is accurate in double."""
    rows = []
    for function in UNITS:
        if found[0].system.has(function):
            states = _states(function, found, box, trajectory)
            truth = _exact(found[0].system, function, states)
            times = timed(function, found, states)
            rows += [_rounding(function, x, states, truth, t)
                     for x, t in zip(found, times, strict=True)]
    return rows


def _states(function: str, found: Sequence[Variant], box: Box, trajectory: Trajectory) -> Values:
    plain = [x for x in found if x.tier == "plain"]
    judge = next(x for x in found if (x.tier, x.precision) == ("accurate", "double"))
    worst = [searched(box, partial(_apart, function, x, judge), PLACES["search"] // len(plain))
             for x in plain]
    return joined((of_run(box.system, trajectory, PLACES["run"]),
                   box.drawn(np.random.default_rng(2), PLACES["limits"]), *worst))


def _apart(function: str, one: Variant, other: Variant, states: Values) -> Reals:
    """The largest difference of a component, for each state."""
    a, b = (_rows(x.system.call(function, **states), len(states["t"])) for x in (one, other))
    largest: Reals = np.abs(a - b).max(axis=1, initial=0)
    return largest


def _rows(found: np.ndarray, count: int) -> Reals:
    """A row of components for each state."""
    return np.asarray(found, float).reshape(count, -1)


def _exact(its: System, function: str, states: Values) -> list[list[mpmath.mpf]]:
    """The results for each state, from the model's own decimals."""
    program = its.programs[function]
    with mpmath.workdps(DIGITS):
        evaluate = interpreter(program, MULTIPRECISE)
        given = {**states, "p": np.tile(np.array(its.p), (len(states["t"]), 1))}
        return [evaluate([[mpmath.mpf(float(x)) for x in np.ravel(given[a.name][row])]
                          for a in program.inputs]) for row in range(len(states["t"]))]


def _rounding(function: str, of: Variant, states: Values, truth: Sequence[Sequence[mpmath.mpf]],
              needed: Interval) -> Rounding:
    found = _rows(of.system.call(function, **states), len(truth))
    with mpmath.workdps(DIGITS):
        errors = np.array([_largest(mpmath.mpf(float(x)) - y for x, y in zip(
            row, exact, strict=True)) for row, exact in zip(found, truth, strict=True)])
        sizes = [_largest(exact) for exact in truth]
    at = int(np.argmax(errors))
    right = math.log10(sizes[at] / errors[at]) if errors[at] and sizes[at] else math.inf
    places = [place for place, count in PLACES.items() for _ in range(count)]
    return Rounding(function, of.tier, of.precision, float(np.median(errors)), float(errors[at]),
                    right, places[at], needed)


def _largest(numbers: Iterable[mpmath.mpf]) -> float:
    return max((float(abs(x)) for x in numbers), default=0.0)
