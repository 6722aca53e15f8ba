"""Attacks the proven error bounds with exact rational arithmetic, row by row.

A small sample of what tests.long_attack does.

Truth is the operation's formula, expanded by SymPy and evaluated in exact rationals.  Attacked are
the NumPy twins (whose bits the C kernels share) and, for the fused tier, compiled C.  What the
certified tier returns as bounds is attacked with numbers of any size, too.
"""

import functools
import math
import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from gmpy2 import mpq

from coscrew_codegen.exact import CONDITION, UNIT, exact_functions, ulp
from coscrew_codegen.formats import Precision
from coscrew_codegen.operations import OPERATIONS, Operation
from coscrew_codegen.program import Program
from coscrew_codegen.program.bounds import Bound, bounds_of
from coscrew_codegen.programs import program_of
from coscrew_codegen.report.inputs import cancel
from coscrew_codegen.tiers import tier_named
from coscrew_codegen.tiers.tier import is_polynomial
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
    found = bounds_of(tier_named(tier).program(plain_program(operation), precision))
    assert found
    return found


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


def attack(operation: Operation, precision: Precision, tier: str, inputs: Arrays,
           implementation: Implementation) -> Worst:
    """Compare what the implementation returns with the truth, row by row."""
    outputs = implementation(operation, precision, inputs)
    flat_in, flat_out = (np.concatenate([a.reshape(len(inputs[0]), -1) for a in arrays], axis=1)
                         for arrays in (inputs, outputs))
    worst = Worst()
    for given, got in zip(flat_in.tolist(), flat_out.tolist(), strict=True):
        if tier == "certified":
            _compare_certified(operation, given, got, worst)
            continue
        compare(operation, precision, tier, given, got, worst)
    return worst


def compare(operation: Operation, precision: Precision, tier: str, given: Sequence[float],
            got: Sequence[float], worst: Worst) -> None:
    """One row with the truth, exactly."""
    u = UNIT[precision.name]
    values = [mpq(x) for x in given]
    magnitudes = [abs(x) for x in values]
    for bound, (exact, absolute), result in zip(bounds(operation, precision, tier),
                                                exact_functions(operation), got, strict=True):
        truth = exact(*values)
        error = abs(mpq(result) - truth)
        worst.outputs += 1
        if not error:
            continue
        terms = absolute(*magnitudes)
        allowed = ((u * abs(mpq(result)) if bound.rounded else 0)
                   + (mpq(bound.c1) * u + mpq(bound.c2) * u * u) * terms * (1 + 1024 * u))
        ratio = float(error / allowed) if allowed else float("inf")
        if ratio > worst.ratio:
            worst.ratio, worst.witness = ratio, tuple(x.hex() for x in given)
        if terms < CONDITION[precision.name] * abs(truth):
            ulps = float(error / ulp(truth, precision))
            if ulps > worst.ulps:
                worst.ulps, worst.ulps_witness = ulps, tuple(x.hex() for x in given)


def _compare_certified(operation: Operation, given: Sequence[float], got: Sequence[float],
                       worst: Worst) -> None:
    """`got` holds the results, then their bounds; a bound that is not finite makes no statement."""
    if not all(map(math.isfinite, given)):
        return
    values, half = [mpq(x) for x in given], len(got) // 2
    for (exact, _), result, bound in zip(exact_functions(operation), got[:half], got[half:],
                                         strict=True):
        if math.isfinite(bound):
            worst.outputs += 1
            error = abs(mpq(result) - exact(*values))
            ratio = float(error / mpq(bound)) if bound else float("inf") if error else 0.0
            if ratio > worst.ratio:
                worst.ratio, worst.witness = ratio, tuple(x.hex() for x in given)
