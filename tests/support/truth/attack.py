"""Attacks the proven error bounds with exact rational arithmetic, row by row.

The tests run a small sample of what tests.long_attack does.  Truth is the operation's formula,
expanded by SymPy and evaluated in exact rationals.  The NumPy twins, whose bits the C kernels
share, are attacked.  The bounds that the certified tier returns are attacked with numbers of any
size, too.
"""

import functools
import math
import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from gmpy2 import mpq

from coscrew_codegen.accuracy.bounds import Bound, bounds_of
from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.accuracy.tiers.tier import is_polynomial
from coscrew_codegen.algebra.exact import CONDITION, UNIT, exact_functions, ulp
from coscrew_codegen.algebra.lowering.programs import program_of
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.program import Program
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.reports.kernels.inputs import cancel
from tests.support.sampling import inputs_of

Arrays = tuple[np.ndarray, ...]
Implementation = Callable[[Operation, Precision, Arrays], Arrays]


@functools.cache
def plain_program(operation: Operation) -> Program:
    """The operation's plain program."""
    return program_of(operation)


TIERED = tuple(op for op in OPERATIONS if is_polynomial(plain_program(op)))


@functools.cache
def bounds(operation: Operation, precision: Precision, tier: str) -> tuple[Bound, ...]:
    """The emitted bounds of the operation's results."""
    result = bounds_of(tier_named(tier).program(plain_program(operation), precision))
    assert result
    return result


def rows(operation: Operation, precision: Precision, count: int, seed: int) -> Arrays:
    """Inputs: ordinary, of very different sizes, and such that one result nearly cancels."""
    numbers = np.random.default_rng([seed, len(operation.name), precision.bytes])
    size = sum(a.quantity.size for a in operation.inputs)
    real = np.dtype(precision.numpy_type).type
    spread = 40 if precision.name == "double" else 8
    flat = numbers.normal(size=(count, size))
    flat[count // 3:] *= np.exp2(numbers.uniform(-spread, spread, size=(count - count // 3, size)))
    flat = flat.astype(real)
    chooser = random.Random(seed)
    for row in flat[2 * count // 3:]:
        cancel(operation, row, chooser)
    edges = np.cumsum([a.quantity.size for a in operation.inputs])[:-1]
    return tuple(part.reshape(count, *a.quantity.shape) for part, a in
                 zip(np.split(flat, edges, axis=1), operation.inputs, strict=True))


def extreme_rows(operation: Operation, precision: Precision, count: int, seed: int) -> Arrays:
    """Inputs of every kind of floating-point number, and such that a product of two underflows and
    is multiplied by a huge third."""
    numbers = np.random.default_rng([seed, len(operation.name), precision.bytes])
    size = sum(a.quantity.size for a in operation.inputs)
    least, most = {"double": (-1074, 1020), "single": (-149, 124)}[precision.name]
    exponents = numbers.choice((least // 2 - 2, least // 2, least // 2 + 3, 0, most, least + 20),
                               (count, size), p=(.2, .2, .2, .1, .2, .1))
    flat = np.ldexp(numbers.uniform(-1, 1, (count, size)), exponents).astype(precision.numpy_type)
    edges = np.cumsum([a.quantity.size for a in operation.inputs])[:-1]
    parts = [part.reshape(count, *a.quantity.shape) for part, a in
             zip(np.split(flat, edges, axis=1), operation.inputs, strict=True)]
    return tuple(map(np.concatenate, zip(parts, inputs_of(operation, precision, count),
                                         strict=True)))


@dataclass
class Worst:
    """The largest error relative to its bound, with its input; and the largest in ulp among results
    whose condition S / |x| is below the precision's CONDITION."""

    ratio: float = 0.0
    witness: tuple[str, ...] = ()
    ulps: float = 0.0
    ulps_witness: tuple[str, ...] = ()
    outputs: int = 0


@dataclass(frozen=True)
class Row:
    """All input components of one call, and the exact results, each computed when first needed."""

    operation: Operation
    given: list[float]

    @functools.cached_property
    def exact(self) -> list[mpq]:
        """x of every result."""
        values = [mpq(x) for x in self.given]
        return [exact(*values) for exact, _ in exact_functions(self.operation)]

    @functools.cached_property
    def terms(self) -> list[mpq]:
        """S of every result."""
        magnitudes = [abs(mpq(x)) for x in self.given]
        return [absolute(*magnitudes) for _, absolute in exact_functions(self.operation)]


def exact_rows(operation: Operation, inputs: Arrays) -> list[Row]:
    """The rows of these inputs whose components are all finite; tiers may share them."""
    flat = np.concatenate([a.reshape(len(a), -1) for a in inputs], axis=1)
    return [Row(operation, given) for given in flat[np.isfinite(flat).all(axis=1)].tolist()]


def attack(operation: Operation, precision: Precision, tier: str, known: Sequence[Row],
           implementation: Implementation) -> Worst:
    """Compares the implementation's results with the truth, row by row."""
    flat = np.array([row.given for row in known], precision.numpy_type)
    edges = np.cumsum([a.quantity.size for a in operation.inputs])[:-1]
    inputs = tuple(part.reshape(len(known), *a.quantity.shape) for part, a in
                   zip(np.split(flat, edges, axis=1), operation.inputs, strict=True))
    outputs = implementation(operation, precision, inputs)
    results = np.concatenate([a.reshape(len(known), -1) for a in outputs], axis=1).tolist()
    worst = Worst()
    for row, got in zip(known, results, strict=True):
        if tier == "certified":
            _compare_certified(row, got, worst)
        else:
            compare(precision, tier, row, got, worst)
    return worst


@functools.cache
def _factors(operation: Operation, precision: Precision, tier: str) -> list[tuple[mpq, mpq]]:
    """The factors of |x̂| and S in the bound of each result."""
    u = UNIT[precision.name]
    return [(u if bound.rounded else mpq(0),
             (mpq(bound.c1) * u + mpq(bound.c2) * u * u) * (1 + 1024 * u))
            for bound in bounds(operation, precision, tier)]


def compare(precision: Precision, tier: str, row: Row, got: Sequence[float], worst: Worst) -> None:
    """One row with the truth, exactly."""
    worst.outputs += len(got)
    for number, ((of_result, of_terms), truth, result) in enumerate(zip(
            _factors(row.operation, precision, tier), row.exact, map(mpq, got), strict=True)):
        error = abs(result - truth)
        if not error:
            continue
        terms = row.terms[number]
        allowed = of_result * abs(result) + of_terms * terms
        ratio = float(error / allowed) if allowed else float("inf")
        if ratio > worst.ratio:
            worst.ratio, worst.witness = ratio, tuple(x.hex() for x in row.given)
        if terms < CONDITION[precision.name] * abs(truth):
            ulps = float(error / ulp(truth, precision))
            if ulps > worst.ulps:
                worst.ulps, worst.ulps_witness = ulps, tuple(x.hex() for x in row.given)


def _compare_certified(row: Row, got: Sequence[float], worst: Worst) -> None:
    """`got` holds the results, then their bounds; a bound that is not finite makes no statement."""
    half = len(got) // 2
    for truth, result, bound in zip(row.exact, got[:half], got[half:], strict=True):
        if math.isfinite(bound):
            worst.outputs += 1
            error = abs(mpq(result) - truth)
            ratio = float(error / mpq(bound)) if bound else float("inf") if error else 0.0
            if ratio > worst.ratio:
                worst.ratio, worst.witness = ratio, tuple(x.hex() for x in row.given)
