"""Errors of kernels against exact results: worst, quantiles, witness, bound, condition."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from coscrew_codegen.accuracy.bounds import Bound, bounds_of, in_words
from coscrew_codegen.algebra.exact import CONDITION, UNIT, Truth, formula, is_polynomial, truth
from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.program import NotANumber, Program
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.reports.kernels import inputs
from coscrew_codegen.reports.kernels.c_text import Variant
from coscrew_codegen.reports.kernels.report_json import ErrorFigures, ProvenBound

Arrays = tuple[np.ndarray, ...]
Evaluate = Callable[[Variant, Arrays], Arrays]

_BINS_PER_OCTAVE = 2  # of condition numbers
_LARGEST_CONDITION = 2.0**100


@dataclass(frozen=True)
class InputSample:
    """Rows of inputs and their exact results."""

    rows: np.ndarray
    truth: Truth


@dataclass(frozen=True)
class KernelAccuracy:
    """The error part of a report's entry."""

    benign: ErrorFigures | None
    hard: ErrorFigures | None
    bound: ProvenBound | None
    condition: tuple[tuple[float, float], ...]


def samples(operation: Operation, precision: Precision, count: int, seed: int,
            corpus: tuple[tuple[float, ...], ...] = ()) -> tuple[InputSample, InputSample]:
    """Returns `count` benign rows, and `count` hard rows with those of the corpus."""
    drawn = [inputs.benign(operation, precision, count, seed),
             inputs.hard(operation, precision, count, seed)]
    if corpus:
        drawn[1] = np.concatenate([drawn[1], np.array(corpus, precision.numpy_type)])
    benign, hard = (InputSample(rows, truth(operation, precision, rows)) for rows in drawn)
    return benign, hard


def accuracy(operation: Operation, variant: Variant, benign: InputSample, hard: InputSample,
             evaluate: Evaluate) -> KernelAccuracy:
    """The errors of a variant of the operation, without its further outputs.

    Hard results count only if their condition is below 0.1/u: beyond that no digit is promised.
    Nothing is promised either where the exact result does not exist, something overflows, or a
    kernel that may refuse its inputs returns NaN."""
    values = [_results(operation, variant, sample, evaluate) for sample in (benign, hard)]
    errors = [sample.truth.errors(results)
              for sample, results in zip((benign, hard), values, strict=True)]
    refused = [np.isnan(results) & _may_refuse(variant.program) for results in values]
    counted = [_computed(operation) & ~np.isnan(e) & ~r
               for e, r in zip(errors, refused, strict=True)]
    fair = counted[1]
    if is_polynomial(operation):
        fair = fair & (hard.truth.condition < float(CONDITION[variant.precision.name]))
    bounds = bounds_of(variant.program)
    return KernelAccuracy(
        summarised(operation, benign.rows, errors[0], counted[0]),
        summarised(operation, hard.rows, errors[1], fair),
        _bound(variant, bounds, [(s.truth, np.where(c, e, 0), r) for s, e, r, c in
                                 zip((benign, hard), errors, values, counted, strict=True)])
        if bounds else None,
        _by_condition(np.concatenate([s.truth.condition[c] for s, c in
                                      zip((benign, hard), counted, strict=True)]),
                      np.concatenate([e[c] for e, c in zip(errors, counted, strict=True)])))


def _may_refuse(program: Program) -> bool:
    """Returns whether a NaN can mean that a result does not exist."""
    return any(isinstance(x, NotANumber) for step in program.instructions for x in step.operands)


def _results(operation: Operation, variant: Variant, sample: InputSample,
             evaluate: Evaluate) -> np.ndarray:
    outputs = evaluate(variant, inputs.split(operation, sample.rows))[:len(operation.outputs)]
    return np.concatenate([a.reshape(len(sample.rows), -1) for a in outputs], axis=1).astype(float)


def _computed(operation: Operation) -> np.ndarray:
    """The mask of components that are computed, not constants or inputs, copied or negated; all if
    none is."""
    computed = np.array([not (x.is_Atom or (-x).is_Atom) for x in formula(operation)])
    return computed if computed.any() else ~computed


def summarised(operation: Operation, rows: np.ndarray, errors: np.ndarray,
               counted: np.ndarray) -> ErrorFigures | None:
    """Worst error with its witness, 99.9th percentile and median of the errors that count."""
    chosen = errors[counted]
    if not chosen.size:
        return None
    row, component = np.unravel_index(np.argmax(np.where(counted, errors, -1)), errors.shape)
    names = [symbol.name for a in operation.outputs for symbol in a.symbols]
    p999, median = np.quantile(chosen, (0.999, 0.5), method="inverted_cdf")
    return ErrorFigures(chosen.size, float(chosen.max()), float(p999), float(median),
                        tuple(float(x).hex() for x in rows[row]), names[component])


def _bound(variant: Variant, bounds: tuple[Bound, ...],
           values: list[tuple[Truth, np.ndarray, np.ndarray]]) -> ProvenBound:
    u = float(UNIT[variant.precision.name])
    constants = np.array([(b.rounded, b.c1, b.c2) for b in bounds], float).T
    rounded, c1, c2 = constants
    worst = 0.0
    for truth_, errors, results in values:
        allowed = (u * np.abs(results) * rounded
                   + (c1 * u + c2 * u * u) * truth_.terms * (1 + 1024 * u))
        with np.errstate(all="ignore"):
            ratios = np.where(errors == 0, 0.0, errors * truth_.unit / allowed)
        worst = max(worst, float(ratios.max(initial=0.0)))
    return ProvenBound(in_words(variant.program), float(c1.max()), float(c2.max()),
                       bool(rounded.any()), worst)


def _by_condition(conditions: np.ndarray,
                  errors: np.ndarray) -> tuple[tuple[float, float], ...]:
    """(condition, error) of the largest error in each bin of condition numbers."""
    usable = (conditions >= 1) & (conditions < _LARGEST_CONDITION)
    conditions, errors = conditions[usable], errors[usable]
    bins = np.floor(np.log2(conditions) * _BINS_PER_OCTAVE)
    largest: dict[float, tuple[float, float]] = {}
    for number, condition, error in zip(bins, conditions.tolist(), errors.tolist(), strict=True):
        if number not in largest or error > largest[number][1]:
            largest[number] = (condition, error)
    return tuple(largest[number] for number in sorted(largest))
