"""Input rows for every operation: ordinary numbers and all special cases of floating point.

Seeded by the operation's name, so that every run, on every machine, uses the same numbers.
"""

from collections.abc import Callable

import numpy as np

from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.program.values.formats import Precision

Rows = np.ndarray  # (n, columns): one row holds all input components of one call
Generator = np.random.Generator


def inputs_of(operation: Operation, precision: Precision, n: int) -> tuple[np.ndarray, ...]:
    """n rows of every input, (n, *shape), a block of rows of each kind below."""
    rng = np.random.default_rng([*operation.name.encode(), precision.bytes])
    sizes = [a.quantity.size for a in operation.inputs]
    inside = np.concatenate([np.arange(size) for size in sizes])  # indices in each input
    dtype = np.dtype(precision.numpy_type)
    counts = np.diff(np.linspace(0, n, len(KINDS) + 1).astype(int))
    with np.errstate(all="ignore"):
        rows = np.concatenate([kind(rng, count, inside, dtype).astype(dtype)
                               for kind, count in zip(KINDS, counts, strict=True)])
    parts = np.split(rows, np.cumsum(sizes)[:-1], axis=1)
    return tuple(np.ascontiguousarray(part).reshape(n, *a.quantity.shape)
                 for part, a in zip(parts, operation.inputs, strict=True))


def ordinary(rng: Generator, n: int, inside: np.ndarray, dtype: np.dtype) -> Rows:
    """Normally distributed about zero."""
    return rng.standard_normal((n, len(inside)), dtype)


def moderate_exponents(rng: Generator, n: int, inside: np.ndarray, dtype: np.dtype) -> Rows:
    """Magnitudes from a quarter below to a quarter above 1: products stay finite."""
    return _of_exponents(rng, (n, len(inside)), dtype, np.finfo(dtype).maxexp // 4)


def all_exponents(rng: Generator, n: int, inside: np.ndarray, dtype: np.dtype) -> Rows:
    """Magnitudes over the whole range: products overflow and underflow."""
    return _of_exponents(rng, (n, len(inside)), dtype, np.finfo(dtype).maxexp)


def zeros(rng: Generator, n: int, inside: np.ndarray, dtype: np.dtype) -> Rows:
    """Half of the components are zeros, of either sign."""
    x = ordinary(rng, n, inside, dtype)
    return np.where(rng.random(x.shape) < 0.5, np.copysign(dtype.type(0), x), x)


def few_numbers(rng: Generator, n: int, inside: np.ndarray, dtype: np.dtype) -> Rows:
    """Numbers whose sums of products are often zero, of either sign; small ones next to huge ones.
    """
    info = np.finfo(dtype)
    numbers = np.array([0, 0, 1, 1, 0.3, 2.5, 7, info.smallest_subnormal, info.max / 8], dtype)
    return rng.choice(numbers, (n, len(inside))) * rng.choice((-1, 1), (n, len(inside)))


def equal_inputs(rng: Generator, n: int, inside: np.ndarray, dtype: np.dtype) -> Rows:
    """Inputs of the same shape are equal."""
    return ordinary(rng, n, np.arange(36), dtype)[:, inside]


def near_cancellation(rng: Generator, n: int, inside: np.ndarray, dtype: np.dtype) -> Rows:
    """Equal up to sign and a few units in the last place, also across parts of an input."""
    x = ordinary(rng, n, np.arange(3), dtype)[:, inside % 3]
    ulps = rng.integers(-2, 3, x.shape) * np.finfo(dtype).eps
    return x * (1 + ulps) * rng.choice((-1, 1), x.shape)


def subnormal(rng: Generator, n: int, inside: np.ndarray, dtype: np.dtype) -> Rows:
    """Half of the components are subnormal, the others ordinary."""
    x = ordinary(rng, n, inside, dtype)
    return np.where(rng.random(x.shape) < 0.5, x * np.finfo(dtype).tiny, x)


def huge(rng: Generator, n: int, inside: np.ndarray, dtype: np.dtype) -> Rows:
    """Half of the components are within a factor 8 of overflow, the others ordinary."""
    x = ordinary(rng, n, inside, dtype)
    near = np.copysign(np.finfo(dtype).max * rng.uniform(0.125, 1, x.shape), x)
    return np.where(rng.random(x.shape) < 0.5, near, x)


def edges(rng: Generator, n: int, inside: np.ndarray, dtype: np.dtype) -> Rows:
    """Every component is a threshold of floating point or of a kernel, of either sign."""
    info = np.finfo(dtype)
    thresholds = [np.nextafter(dtype.type(x), dtype.type(towards))
                  for x in (1e-9, 1e-6, 1) for towards in (0, x, np.inf)]
    numbers = [0, info.smallest_subnormal, info.tiny, info.eps, info.max, *thresholds]
    return rng.choice(np.array(numbers, dtype), (n, len(inside))) * rng.choice((-1, 1), (n, 1))


def infinite(rng: Generator, n: int, inside: np.ndarray, dtype: np.dtype) -> Rows:
    """A tenth of the components are infinite."""
    x = ordinary(rng, n, inside, dtype)
    return np.where(rng.random(x.shape) < 0.1, np.copysign(np.inf, x), x)


def not_a_number(rng: Generator, n: int, inside: np.ndarray, dtype: np.dtype) -> Rows:
    """A tenth of the components are NaN."""
    x = ordinary(rng, n, inside, dtype)
    return np.where(rng.random(x.shape) < 0.1, np.nan, x)


KINDS: tuple[Callable[[Generator, int, np.ndarray, np.dtype], Rows], ...] = (
    ordinary, moderate_exponents, all_exponents, zeros, few_numbers, equal_inputs,
    near_cancellation, subnormal, huge, edges, infinite, not_a_number)


def _of_exponents(rng: Generator, shape: tuple[int, int], dtype: np.dtype, most: int) -> Rows:
    exponents = rng.integers(-most, most, shape)
    return np.ldexp(rng.uniform(0.5, 1, shape), exponents) * rng.choice((-1, 1), shape)
