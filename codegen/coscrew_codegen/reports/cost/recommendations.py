"""Recommendations from a scene's figures, in sentences."""

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise

from coscrew_codegen.program.values.digits import three_digits
from coscrew_codegen.reports.cost.function_errors import FunctionErrors
from coscrew_codegen.reports.cost.measured import CERTIFIED
from coscrew_codegen.simulation.result_units import in_unit

AFFORDABLE = 1.5
"""The most accurate of all choices that take at most this many times as long as the fastest is
recommended."""


def undominated(rows: Sequence[FunctionErrors]) -> tuple[FunctionErrors, ...]:
    """Returns the function's Pareto-optimal choices, the fastest first."""
    return tuple(sorted((x for x in rows if not any(y.better(x) for y in rows)),
                        key=lambda x: x.time.median))


def recommended(rows: Sequence[FunctionErrors]) -> FunctionErrors:
    """The most accurate of a function's choices that cost little more than the fastest, in the
    precisions in which the scene is generated.  Certified ones are not considered: their results
    are plain's."""
    rows = undominated(_results(rows))
    return min((x for x in rows if x.time.median <= AFFORDABLE * rows[0].time.median),
               key=lambda x: x.relative)


def better(x: FunctionErrors, rows: Sequence[FunctionErrors]) -> FunctionErrors | None:
    """The fastest of the better choices; a certified one only if no other is better."""
    return min((y for y in rows if y.better(x)), default=None,
               key=lambda y: (y.tier == CERTIFIED, y.time.median))


def _results(rows: Sequence[FunctionErrors]) -> list[FunctionErrors]:
    return [x for x in rows if x.emitted and x.tier != CERTIFIED]


def sentences(rows: Sequence[FunctionErrors]) -> tuple[str, ...]:
    """The recommendation for a function, then what other choices gain and cost."""
    return tuple(_sentences(rows))


def _sentences(rows: Sequence[FunctionErrors]) -> Iterator[str]:
    results = _results(rows)
    best, fastest = recommended(results), undominated(results)[0]
    cost = "the fastest choice" if best is fastest else f"at {_times(best, fastest)}"
    yield (f"{best.function}: {best.name} is {within(best)} everywhere we looked ({best.states} "
           f"states), {cost} ({three_digits(best.time.median)} ns).")
    finer = [x for x in undominated(results) if x.relative < best.relative]
    for a, b in pairwise((best, *finer)):
        yield (f"{b.name.capitalize()} is {within(b)}: {_gain(a, b)} than {a.name}, at "
               f"{_times(b, a)}.")
    single = [x for x in results if x.precision == "single"]
    if single and best.precision != "single":
        own, fastest = recommended(single), undominated(single)[0]
        more = "" if own is fastest else f", at {_ratio(own, fastest)}× {fastest.tier}"
        yield f"In single precision {own.tier} is {within(own)}{more}."
    for x in rows:
        if x.tier == CERTIFIED and x.precision == best.precision:
            plain = next(y for y in rows if y.name == f"{x.precision} plain")
            yield f"{x.name.capitalize()} {_bounded(x)}, at {_times(x, plain)}."
    proofs = [f"{x.name} {_over_ranges(x)}" for x in rows
              if all(e.proved is not None and math.isfinite(e.proved) for e in x.errors)]
    if proofs:
        yield f"Proved over the scene's ranges: {'; '.join(proofs)}."


def within(x: FunctionErrors) -> str:
    """The worst errors: within 3 µN m and 2 µN."""
    results = [in_unit(e.worst, e.unit) for e in x.errors if e.worst]
    return f"within {_listed(results)}" if results else "exact"


def _over_ranges(x: FunctionErrors) -> str:
    """The errors that rounding cannot exceed: within 0.59 mN m."""
    return f"within {_listed([in_unit(e.proved or 0.0, e.unit) for e in x.errors])}"


def _bounded(x: FunctionErrors) -> str:
    results = [(e.bounds.worst, e.unit) for e in x.errors if e.bounds]
    if any(math.isinf(bound) for bound, _ in results):
        return "returns the plain results, but no bounds of their errors at some of these states"
    stated = [in_unit(*y) for y in results if y[0]]
    return ("returns the plain results and bounds of their errors, here "
            f"{f'at most {_listed(stated)}' if stated else 'all zero'}")


def _listed(words: Iterable[str]) -> str:
    *first, last = words
    return " and ".join((*([", ".join(first)] if first else ()), last))


def _gain(a: FunctionErrors, b: FunctionErrors) -> str:
    return (f"{in_unit(a.relative / b.relative, '1')} times less error" if b.relative else
            "without error, rather")


def _times(a: FunctionErrors, b: FunctionErrors) -> str:
    """1.3× single plain"""
    return f"{_ratio(a, b)}× {b.name}"


def _ratio(a: FunctionErrors, b: FunctionErrors) -> str:
    return three_digits(a.time.median / b.time.median)
