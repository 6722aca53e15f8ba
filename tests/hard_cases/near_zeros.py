"""Hard cases of ill-conditioned results: components next to their zeros.

`python -m tests.hard_cases.near_zeros [--seed S]` finds them and puts them into the corpus; with
`--judge` it compares the accurate tier with the truth for them instead.  On the way from one drawn
input to another a component changes its sign; there it is bisected, and left by so little that its
condition is as bad as the accurate tier allows, or up to 100 times better.
"""

import argparse
import sys
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import product

import mpmath
import numpy as np

import coscrew.accurate
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.program.ops import ERROR_OF
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from tests.hard_cases.corpus import Case, load, save
from tests.search import joined, split
from tests.support.compiled.implementations import gufuncs, twin
from tests.support.domains import domains
from tests.support.limits import LARGEST_CONDITION
from tests.support.scenes.tiers import DIGITS, Result, flat
from tests.support.truth.attack import plain_program
from tests.support.truth.condition import conditions
from tests.support.truth.truths import fine, of_given

FUNCTIONS = tuple(op for op in OPERATIONS if ERROR_OF.keys() & plain_program(op).counts.keys())
"""The operations that call elementary functions."""
RANGE = 100
KEPT = 6
DRAWN = 400
ORIGIN = "near a zero:"
MOST = {"double": 0.501, "single": 0.5001}
"""Units of the last digit that are allowed.  Found: 0.5000; promised in double is 1."""
_SMALL = {"double": 1e-280, "single": 1e-36}  # smaller results may be subnormal on the way


def columns(operation: Operation, rows: np.ndarray) -> list[list[np.ndarray]]:
    """The components of each input, each for all rows."""
    return [[x.reshape(len(x), -1)[:, k].astype(float) for k in range(a.quantity.size)]
            for a, x in zip(operation.inputs, split(operation, rows), strict=True)]


def condition(operation: Operation, rows: np.ndarray) -> np.ndarray:
    """The condition of each component of each row, (n, components)."""
    sizes = conditions(fine(operation), columns(operation, rows))
    return np.stack([np.broadcast_to(x, len(rows)) for x in sizes], axis=1)


def judged(operation: Operation, precision: Precision, given: np.ndarray) -> list[Result]:
    """Every component of these calls, with its truth and condition."""
    inputs = split(operation, given)
    size = condition(operation, given)
    result = flat(gufuncs(coscrew.accurate)(operation, precision, inputs), len(given))
    results = []
    with mpmath.workdps(DIGITS):
        for row, got, k in zip(given.tolist(), result, range(len(given)), strict=True):
            true = of_given(operation, precision, tuple(row))
            results += [Result(place, got[place], x, float(size[k, place]))
                        for place, x in enumerate(true)]
    return results


def promised(results: Sequence[Result], precision: Precision) -> list[Result]:
    """The results for which the tier makes a promise."""
    return [x for x in results if x.condition < LARGEST_CONDITION[precision.name]
            and _SMALL[precision.name] < abs(x.true) < np.finfo(precision.numpy_type).max]


def beyond(results: Sequence[Result], precision: Precision) -> list[Result]:
    """The results that err by more than MOST."""
    most = MOST[precision.name]
    return [x for x in results if min(x.ulps(precision), _turned(x).ulps(precision)) > most]


def _turned(x: Result) -> Result:
    """-π for π, and π for -π: the sign of a zero says which, and exact zeros have none."""
    return replace(x, found=-x.found) if abs(abs(x.true) - mpmath.pi) < 1e-6 else x


class Ways:
    """Straight ways between drawn parameters of an operation's inputs."""

    def __init__(self, operation: Operation, rng: np.random.Generator) -> None:
        self.operation, self.free = operation, domains(operation)
        draws = [[free.draw(rng, DRAWN, np.dtype(np.float64)) for free in self.free]
                 for _ in range(2)]
        self.start, self.end = ([np.asarray(x, np.longdouble) for x in row] for row in draws)

    def at(self, share: np.ndarray, precision: Precision) -> np.ndarray:
        """The inputs at this share of each way."""
        k = share[:, None]
        return np.hstack([np.asarray(free.inputs((1 - k) * a + k * b)) for free, a, b in zip(
            self.free, self.start, self.end, strict=True)]).astype(precision.numpy_type)

    def results(self, share: np.ndarray) -> np.ndarray:
        """All components there, in double precision."""
        rows = self.at(share, PRECISIONS[0])
        return joined(twin(coscrew)(self.operation, PRECISIONS[0], split(self.operation, rows)))


def near_zeros(operation: Operation, precision: Precision, seed: int) -> Iterator[Case]:
    """Cases with a component whose condition is at most RANGE times better than allowed."""
    rng = np.random.default_rng([seed, len(operation.name), precision.bytes])
    ways, largest = Ways(operation, rng), LARGEST_CONDITION[precision.name]
    ends = [ways.results(np.full(DRAWN, end, np.longdouble)) for end in (0, 1)]
    results: dict[tuple[float, ...], Case] = {}
    for k in range(ends[0].shape[1]):
        changes = ends[0][:, k] * ends[1][:, k] < 0
        zero = bisected(ways, k, ends[0][:, k])
        for _ in range(4):
            off = 10.0**-rng.uniform(np.log10(largest) - 4, np.log10(largest) + 1, DRAWN)
            rows = ways.at(zero + off * rng.choice((-1, 1), DRAWN), precision)
            bad = condition(operation, rows)[:, k]
            good = changes & (largest / RANGE < bad) & (bad < largest)
            for row, size in zip(rows[good][:KEPT], bad[good][:KEPT], strict=True):
                inputs = tuple(map(float, row))
                results.setdefault(inputs, Case(operation, precision, inputs,
                                                f"{ORIGIN} component {k}, condition {size:.1e}"))
    cases = list(results.values())
    yield from (cases[int(n)] for n in rng.permutation(len(cases))[:KEPT])


def bisected(ways: Ways, k: int, start: np.ndarray) -> np.ndarray:
    """Inputs where component k changes its sign, on each way on which it does."""
    low, high = np.zeros(DRAWN, np.longdouble), np.ones(DRAWN, np.longdouble)
    for _ in range(60):
        middle = (low + high) / 2
        same = ways.results(middle)[:, k] * start > 0
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    return (low + high) / 2


def main() -> int:
    """Replaces the cases near zeros in the corpus by these, or judges them."""
    parser = argparse.ArgumentParser(description=main.__doc__)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--judge", action="store_true", help="the corpus stays as it is")
    options = parser.parse_args()
    made: list[Case] = []
    wrong = 0
    for operation, precision in product(FUNCTIONS, PRECISIONS):
        cases = tuple(near_zeros(operation, precision, options.seed))
        print(f"{operation.name} {precision.name}: {len(cases)}", end="", flush=True)
        if options.judge and cases:
            result = promised(judged(operation, precision, np.array(
                [x.inputs for x in cases], precision.numpy_type)), precision)
            bad = beyond(result, precision)
            print(f", largest error {max(x.ulps(precision) for x in result):.4f} ulp", *bad, end="")
            wrong += len(bad)
        print()
        made += cases
    if not options.judge:
        save((*(x for x in load() if not x.origin.startswith(ORIGIN)), *made))
    return wrong > 0


if __name__ == "__main__":
    sys.exit(main())
