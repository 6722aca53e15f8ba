"""Rounding errors at states of a run: errors of plain functions against 50 digits, by unit,
compared with the bounds of the certified tier."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from gmpy2 import mpfr
from numpy.typing import NDArray

from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.program import Program
from coscrew_codegen.program.interpreter import interpreter
from coscrew_codegen.program.multiprecise import multiprecise, precise
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.runtime.load import Kernels, in_tier_of
from coscrew_codegen.scene.functions import FUNCTIONS
from coscrew_codegen.simulation.plan import Trajectory
from coscrew_codegen.simulation.recordings.record import accelerations
from coscrew_codegen.simulation.result_units import units
from coscrew_codegen.simulation.system import System

JUDGED = tuple(x.name for x in FUNCTIONS if x.judged)
"""Functions whose rounding errors are checked."""
DIGITS = 50
STATES = 8  # of a run
_UNSEEN = 1e-20  # of a bound: errors below it are those of the DIGITS, where a result is exact
MOST = 1500
"""Instructions of a plain function up to which its certified one is compiled, if the scene does not
select that tier: larger ones take many seconds."""
CERTIFIED = tier_named("certified").name

Values = Mapping[str, NDArray[np.floating]]
Exact = list[list[mpfr]]


@dataclass(frozen=True)
class Broken:
    """A result whose error exceeds its certified bound."""

    place: int  # of the component
    t: float
    error: float
    bound: float


@dataclass(frozen=True)
class Certified:
    """Certified bounds of a function's results at states of a run."""

    stated: int  # how many results have a finite bound
    of: int
    ratio: float | None  # the median of bound / error; None if all results are exact
    broken: Broken | None  # the one that exceeds its bound most


@dataclass(frozen=True)
class RoundedResults:
    """The rounding errors of a plain function's components with one unit, at states of a run in a
    precision."""

    function: str
    unit: str
    precision: str
    states: int
    error: float  # the largest of a component
    digits: float  # correct digits of the largest of these components, at the worst state
    lost: float  # of the precision's digits
    at: float  # time of the worst state, in s
    certified: Certified | None  # None if the certified function was too large to compile


def rounding(kernels: Kernels, runs: Sequence[tuple[System, Trajectory]]) -> tuple[RoundedResults,
                                                                                   ...]:
    """Every judged function at some states of each run."""
    certified = _certified(kernels)
    programs = {f.name: f.program for f in kernels.functions.functions if f.name in JUDGED}
    results = []
    for system, trajectory in runs:
        values = _states(system, trajectory)
        if len(values["t"]):
            results += [x for name, program in programs.items()
                        for x in _rounded(system, name, program, values, certified,
                                         units(kernels.functions, name))]
    return tuple(results)


def _certified(kernels: Kernels) -> Kernels | None:
    """The checked functions in the certified tier, compiled or loaded from the cache, as far as
    they are selected or small."""
    functions = kernels.functions
    chosen = tuple(f for f in functions.functions if f.name in JUDGED and (
        CERTIFIED in functions.tiers or len(f.program.instructions) <= MOST))
    if not chosen:
        return None
    part: SceneFunctions = replace(functions, functions=chosen, steps=())
    return in_tier_of(kernels, CERTIFIED, part)


def _states(system: System, trajectory: Trajectory) -> Values:
    """States of the run at equal intervals, with τ = 0 and with an a other than the run's
    accelerations, which need no τ."""
    kept = np.linspace(0, len(trajectory.t) - 1, STATES).round().astype(int)
    t, q, v = (np.asarray(x[np.unique(kept)], system.dtype)
               for x in (trajectory.t, trajectory.q, trajectory.v))
    with np.errstate(all="ignore"):  # a run that stopped may end with huge numbers
        free = accelerations(system, t, q, v)
        other = np.cos(np.arange(1, free.shape[-1] + 1))
        a = (free + np.abs(free).max(-1, keepdims=True, initial=1) * other).astype(system.dtype)
    known = np.all([np.isfinite(x).reshape(len(t), -1).all(1) for x in (q, v, a)], axis=0)
    return {"t": t[known], "q": q[known], "v": v[known], "a": a[known],
            "tau": np.zeros_like(v[known]), "p": np.asarray(system.p, system.dtype)}


def _rounded(system: System, name: str, program: Program, values: Values,
             certified: Kernels | None, of: Sequence[str]) -> Iterator[RoundedResults]:
    """Returns the rounding of each unit, the first component's first."""
    count, precision = len(values["t"]), system.precision
    result = _rows(system.call(name, **values), count)
    truth = _exact(program, values, precision)
    with precise(DIGITS):
        errors = [[abs(mpfr(float(x)) - y) for x, y in zip(*rows, strict=True)]
                  for rows in zip(result, truth, strict=True)]
    own = -math.log10(precision.u)
    for unit in dict.fromkeys(of):
        places = [n for n, x in enumerate(of) if x == unit]
        largest = np.array([max(float(row[n]) for n in places) for row in errors])
        at = int(np.argmax(np.nan_to_num(largest, nan=np.inf)))
        size = max(abs(float(truth[at][n])) for n in places)
        right = math.log10(size / largest[at]) if size and largest[at] else own
        bounds = None
        if certified and name in getattr(certified, precision.name):
            bounds = _held(system, certified, name, values, truth, places)
        yield RoundedResults(name, unit, precision.name, count, float(largest[at]), right,
                             max(0.0, own - right), float(values["t"][at]), bounds)


def _exact(program: Program, values: Values, precision: Precision) -> Exact:
    """The results for each state, from the model's own decimals.  Thresholds, and the softness of
    closed loops, are those of the precision."""
    with precise(DIGITS):
        evaluate = interpreter(program, multiprecise(precision))
        numbers = len(values["t"])
        given = {**values, "p": np.tile(values["p"], (numbers, 1))}
        return [evaluate([[mpfr(float(x)) for x in np.ravel(given[a.name][row])]
                          for a in program.inputs]) for row in range(numbers)]


def _held(system: System, certified: Kernels, name: str, values: Values, truth: Exact,
          of: Sequence[int]) -> Certified:
    """Compares the certified bounds of these components with the errors of the certified function's
    own results."""
    count, kernels = len(truth), getattr(certified, system.precision.name)
    results, bounds = (_rows(x, count) for x in getattr(kernels, name)(
        *(values[x] for x in system.inputs[name])))
    known = np.isfinite(results) & np.isfinite(bounds)
    places = [(row, place) for row in range(count) for place in of if known[row, place]]
    ratios, worst, exceeded = [], None, mpfr(1)
    for row, place in places:
        bound = mpfr(float(bounds[row, place]))
        with precise(DIGITS):
            error = abs(mpfr(float(results[row, place])) - truth[row][place])
            if error > _UNSEEN * bound:
                ratios.append(float(bound / error))
            if error > exceeded * bound:
                exceeded = error / bound if bound else mpfr("inf")
                worst = Broken(int(place), float(values["t"][row]), float(error), float(bound))
    ratio = float(np.median(ratios)) if ratios else None
    return Certified(len(places), count * len(of), ratio, worst)


def _rows(result: np.ndarray, count: int) -> NDArray[np.float64]:
    """A row of components for each state."""
    return np.asarray(result, float).reshape(count, -1)
