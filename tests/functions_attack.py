"""Attacks the certified bounds of operations that call elementary functions.

`python -m tests.functions_attack [--outputs N] [--operation NAME …] [--seed S]`, or `make attack`,
judges them in MPFR (mpfr_motions.py; of rotations that rounding has changed, by the formulas), and
prints the largest error / bound.  Angles are of all sizes, or next to those where series give way
to closed forms, to π and to 2π, or 0; vectors along axes and nearly so, of all sizes; matrices
of rotations rounded; and the committed cases, moved by some last digits.
"""

import argparse
import math
from collections.abc import Callable, Iterator

import gmpy2
import numpy as np
from gmpy2 import mpfr
from tabulate import tabulate

import coscrew.certified
from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.program.ops import ERROR_OF
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from tests.certified_attack import Found
from tests.search import joined, split
from tests.support.compiled.implementations import gufuncs
from tests.support.hard_rows import hard_rows
from tests.support.truth import truths
from tests.support.truth.attack import plain_program
from tests.support.truth.free_motion import Array, angles, axes, powers
from tests.support.truth.mpfr_motions import (
    BITS,
    TRUTHS,
    Vector,
    inverse_jacobian,
    ratio,
    times,
)

FUNCTIONS = tuple(op for op in OPERATIONS if ERROR_OF.keys() & plain_program(op).counts.keys()
                  and tier_named("certified").has(plain_program(op)))
BATCH = 200
_LOGARITHM = next(op for op in FUNCTIONS if op.name == "SO3_log")


def drawn(rng: np.random.Generator, operation: Operation, kind: type[np.floating]) -> Array:
    """Calls, their components a row."""
    size = sum(a.quantity.size for a in operation.inputs)
    if size == 1 or operation.name.startswith("mat3x3_from_euler"):
        return np.hstack([angles(rng, BATCH, kind) for _ in range(size)])
    if operation.name in ("atan2", "angle_vv"):
        return _two(rng, size // 2, kind)
    angle, axis = _turns(rng, kind), axes(rng, BATCH)
    if operation.name.endswith("from_axis_angle"):
        return np.hstack([axis, angle])
    if size in (3, 6):
        linear = axes(rng, BATCH) * powers(rng, BATCH, kind)
        return np.hstack([linear, angle * axis])[:, -size:]
    if size == 4:
        q = np.hstack([axis * np.sin(angle / 2), np.cos(angle / 2)])
        return q * np.where(rng.random((BATCH, 1)) < 0.3, powers(rng, BATCH, kind), 1)
    R = _rotations(axis, np.where(abs(angle) < 1e4, angle, 3)) * (
        1 + np.finfo(kind).eps * rng.integers(-2, 3, (BATCH, 3, 3)))
    linear = axes(rng, BATCH) * powers(rng, BATCH, kind)
    return np.concatenate([R, linear[:, :, None]], 2)[:, :, :size // 3].reshape(BATCH, size)


def _turns(rng: np.random.Generator, kind: type[np.floating]) -> Array:
    """Angles of rotations; some are 0, or next to 2^-25, where sin θ/2 is divided by θ/2 from."""
    some, step = rng.random((BATCH, 1)), rng.integers(-40, 41, (BATCH, 1))
    return np.select([some < 0.05, some < 0.15], [
        0, 2.0**-25 * (1 + np.finfo(kind).eps * step)], angles(rng, BATCH, kind))


def _two(rng: np.random.Generator, size: int, kind: type[np.floating]) -> Array:
    """Vectors of all sizes; half are nearly parallel."""
    a, b = (axes(rng, BATCH)[:, -size:] * powers(rng, BATCH, kind) for _ in range(2))
    near = a * rng.choice([1, -1, 3], (BATCH, 1)) + b * 10**rng.uniform(-17, -1, (BATCH, 1))
    return np.hstack([a, np.where(rng.random((BATCH, 1)) < 0.5, near, b)])


def _rotations(axis: Array, angle: Array) -> Array:
    x, y, z = axis.T
    zero = np.zeros_like(x)
    across = np.moveaxis(np.array([[zero, -z, y], [z, zero, -x], [-y, x, zero]]), 2, 0)
    return np.eye(3) + np.sin(angle)[:, :, None] * across + (
        2 * np.sin(angle / 2)[:, :, None]**2 * (across @ across))


def _truth(operation: Operation) -> Callable[[Vector], Vector]:
    if operation.name in TRUTHS:
        return TRUTHS[operation.name]
    if operation.name == "SE3_log":
        return _screw
    return lambda given: truths.of_formula(operation, given)


def _screw(displacement: Vector) -> list[mpfr]:
    """J(ω)⁻¹ t and ω, the logarithm of R."""
    columns = [displacement[n::4] for n in range(4)]
    turn = truths.of_formula(_LOGARITHM, [x for row in zip(*columns[:3], strict=True) for x in row])
    return [*times(inverse_jacobian(turn), columns[3]), *turn]


def judged(operation: Operation, given: Array, precision: Precision) -> Found:
    """Judges these calls."""
    result = joined(gufuncs(coscrew.certified)(operation, precision, split(operation, given)))
    half, errors, truth = result.shape[1] // 2, [], _truth(operation)
    for row, got in zip(given.tolist(), result.tolist(), strict=True):
        with gmpy2.context(precision=BITS):
            true = truth(list(map(mpfr, row))) if any(map(math.isfinite, got[half:])) else ()
        errors += [ratio(x, bound, y) for x, bound, y in zip(
            got[:half], got[half:], true or [mpfr("nan")] * half, strict=True)
            if math.isfinite(bound) and not gmpy2.is_nan(y) and not _is_other_sign(x, y)]
    ratios = np.array(errors)
    return Found(ratios.size, half * len(given) - ratios.size, int((~(ratios <= 1)).sum()),
                 float(np.max(ratios, initial=0)))


def _is_other_sign(x: float, y: mpfr) -> bool:
    """Returns whether these are π and -π: the sign of a zero says which, and exact zeros have none.
    """
    return abs(abs(x) - math.pi) < 1e-6 and abs(x + y) < 1e-6


def attacked(operation: Operation, precision: Precision, outputs: int, seed: int) -> Found:
    """Attacks an operation on at least so many outputs."""
    kind = np.dtype(precision.numpy_type).type
    rng = np.random.default_rng([seed, precision.bytes, *operation.name.encode()])
    cases, result = hard_rows(operation, precision), Found()
    while result.outputs + result.silent < outputs:
        beside = cases[rng.integers(0, len(cases), BATCH // 4)]
        beside = beside * (1 + np.finfo(kind).eps * rng.integers(-3, 4, beside.shape))
        given = np.vstack([drawn(rng, operation, kind), beside]).astype(kind)
        result += judged(operation, given[np.isfinite(given).all(axis=1)], precision)
    return result


def rows(names: list[str], outputs: int, seed: int) -> Iterator[tuple[str, str, Found]]:
    """Attacks each operation in each precision."""
    for operation in FUNCTIONS:
        for precision in PRECISIONS:
            if operation.name in names:
                yield operation.name, precision.name, attacked(operation, precision, outputs, seed)


def main() -> None:
    """Print the table and its sum."""
    names = [op.name for op in FUNCTIONS]
    parser = argparse.ArgumentParser(description="Attack certified bounds of operations.")
    parser.add_argument("--outputs", type=int, default=30_000,
                        help="at least, per operation and precision")
    parser.add_argument("--operation", nargs="+", default=names, choices=names, metavar="NAME")
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    table = list(rows(options.operation, options.outputs, options.seed))
    print(tabulate([(*names, x.outputs, x.silent, x.in_words, x.broken) for *names, x in table],
                   ("operation", "precision", "outputs", "no statement", "error / bound", "broken"),
                   disable_numparse=True))
    total = sum((x for *_, x in table), Found())
    print(f"{total.outputs} outputs with a statement, {total.silent} without; "
          f"{total.broken} bounds broken; worst error / bound {total.in_words}")


if __name__ == "__main__":
    main()
