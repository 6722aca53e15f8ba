"""Judges the accurate and the certified tier by states of sixty random robots.

`python -m tests.robots_attack [--robots N] [--states N]`, or `make attack`, compares inverse and
forward dynamics and mass matrices with a Newton-Euler method of the tests' own in 60 digits: in the
accurate tier a component errs by at most one unit of its last digit below a condition of 1e13; in
single precision it is the nearest number below 1e5, except near ties.  Every certified bound that
is stated holds.  The functions run as NumPy, which has the bits of C.
"""

import argparse
import os
import sys
import warnings
from collections.abc import Iterator
from dataclasses import dataclass

import mpmath
import numpy as np
from mpmath import mpf
from tabulate import tabulate

from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.runtime.load import Kernels, kernels_for
from tests.support.limits import LARGEST_CONDITION
from tests.support.scenes.tiers import DIGITS, Result, components, flat
from tests.support.truth.condition import conditions
from tests.support.truth.robots import FUNCTIONS, Robot, robot

MOST = {"double": 1.0, "single": 0.5001}
"""Units of the last digit by which it errs."""
RESOLUTION = mpf(10)**-100
"""What the judge's own roundings, in 120 digits, may leave of an error that is zero."""


@dataclass(frozen=True)
class Judged:
    """A component of a result in both tiers, beside the truth."""

    function: str
    precision: Precision
    accurate: Result
    error: mpf  # of the certified tier's result
    bound: float

    @property
    def judged(self) -> bool:
        """True if the accurate tier promises anything."""
        return bool(self.accurate.true) and (
            self.accurate.condition < LARGEST_CONDITION[self.precision.name])

    @property
    def ulps(self) -> float:
        return self.accurate.ulps(self.precision)

    @property
    def stated(self) -> bool:
        return bool(np.isfinite(self.bound))

    @property
    def broken(self) -> bool:
        """True if a tier breaks its promise."""
        return bool(self.judged and self.ulps > MOST[self.precision.name]) or (
            self.stated and self.error > mpf(float(self.bound)))


def in_numpy(of: Robot) -> Kernels:
    """The robot's functions as generated Python: its C would take long to compile."""
    compiler = os.environ.get("CC")
    os.environ["CC"] = "no-such-compiler"
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", RuntimeWarning)
            result = kernels_for(of.scene)
            _ = result.accurate, result.certified
    finally:
        del os.environ["CC"]
        if compiler is not None:
            os.environ["CC"] = compiler
    return result


def judged(of: Robot, states: int) -> Iterator[Judged]:
    """Every component of every function at random states, in both precisions."""
    kernels = in_numpy(of)
    draw = np.random.default_rng(states)
    for p in PRECISIONS:
        for name in FUNCTIONS:
            program = kernels.functions.named(name).program
            given = [draw.uniform(-2, 2, (states, a.quantity.size)).astype(p.numpy_type)
                     for a in program.inputs]
            accurate = flat(getattr(getattr(kernels.accurate, p.name), name)(*given), states)
            result, bounds = (flat(x, states) for x in getattr(
                getattr(kernels.certified, p.name), name)(*given))
            sizes = [np.broadcast_to(x, states) for x in conditions(
                program, components(program, given))]
            for k in range(states):
                with mpmath.workdps(2 * DIGITS):
                    true = of.true(name, [[mpf(float(y)) for y in x[k]] for x in given])
                    errors = [mpmath.chop(abs(mpf(float(x)) - y), RESOLUTION)
                              for x, y in zip(result[k], true, strict=True)]
                for place, x in enumerate(true):
                    yield Judged(name, p, Result(place, accurate[k, place], x, float(
                        sizes[place][k])), errors[place], bounds[k, place])


def summary(results: list[Judged]) -> str:
    """A row for each function and precision."""
    rows = []
    for p in PRECISIONS:
        for name in FUNCTIONS:
            of = [x for x in results if (x.function, x.precision) == (name, p)]
            judged, stated = [x.ulps for x in of if x.judged], [x for x in of if x.stated]
            ratios = [float(mpf(float(x.bound)) / x.error) for x in stated if x.error]
            rows.append((name, p.name, len(of), len(judged), max(judged, default=0), len(stated),
                         min(ratios, default=0), float(np.median(ratios or [0])),
                         sum(x.broken for x in of)))
    return str(tabulate(rows, ("function", "precision", "results", "promised", "worst, ulps",
                               "bounds", "least bound/error", "median", "broken"), floatfmt=".5g"))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--robots", type=int, default=60)
    parser.add_argument("--states", type=int, default=12)
    options = parser.parse_args()
    results: list[Judged] = []
    for number in range(options.robots):
        results += judged(robot(number), options.states)
    print(summary(results))
    return any(x.broken for x in results)


if __name__ == "__main__":
    sys.exit(main())
