"""Draws inputs from the domains of arguments, for the report, searches and tests.

`ordinary` draws numbers about 1. `hard` draws difficult inputs as functions of free parameters: for
any values of the parameters, the inputs are in the domain, rounded once."""

import functools
import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from coscrew_codegen.program.values.quantity import (
    ANGLE,
    BODY,
    DISPLACEMENT,
    FRACTION,
    HALF_TURN,
    LDL_FACTOR,
    MASS,
    NEAR_ROTATION,
    NONZERO,
    ORDINARY,
    POSITIVE_DEFINITE,
    ROTATION,
    SINE_COSINE,
    SYMMETRIC,
    TURN,
    UNIT_QUATERNION,
    UNIT_VECTOR,
    Argument,
    Domain,
)

Rows = np.ndarray  # (n, columns)
Generator = np.random.Generator
Ordinary = Callable[[Generator, np.ndarray, int], Rows]
PI = np.longdouble("3.14159265358979323846264338327950288")
LEAST_TURN = 1e-30  # below it 60 digits do not determine a rotation's axis; it becomes zero


def ordinary(argument: Argument) -> Ordinary | None:
    """The function that draws `size` components for each of some angles; None if normally
    distributed numbers are in the domain."""
    if argument.domain == BODY:
        return _inertias if argument.quantity.name == "inertia" else _spatial_inertias
    return _ORDINARY.get(argument.domain)


def holds_less(argument: Argument) -> bool:
    """Returns whether values of the domain, scaled down by any factor, stay in it."""
    return argument.domain == HALF_TURN or ordinary(argument) is None


@dataclass(frozen=True)
class Free:
    """Draws rows of free parameters for a dtype, and turns them into rows of input components."""

    draw: Callable[[Generator, int, np.dtype], Rows]
    inputs: Callable[[Rows], Rows]


def hard(argument: Argument) -> Free:
    """Difficult inputs of the argument's domain; any numbers if the domain has none."""
    if argument.domain in _OF_SCREWS and argument.quantity.name == "screw":
        return _OF_SCREWS[argument.domain]
    return _HARD.get(argument.domain) or anything(argument.quantity.size)


@functools.cache
def anything(size: int) -> Free:
    """Rows of `size` numbers without restriction."""

    def draw(rng: Generator, n: int, dtype: np.dtype) -> Rows:
        """Draws numbers about 1, numbers within 2^±60 of each other and not far from 1, and numbers
        of any size, a third each."""
        x = rng.standard_normal((n, size))
        reach = np.where(np.arange(n) % 3, np.where(np.arange(n) % 3 == 1, 30, 0),
                         np.finfo(dtype).maxexp - 20)[:, None]
        center = rng.uniform(-1, 1, (n, 1)) * reach
        exponents = center + rng.uniform(-30, 30, x.shape) * (reach > 0)
        return np.ldexp(x, np.clip(exponents, np.finfo(dtype).minexp - 20,
                                   np.finfo(dtype).maxexp - 4).astype(int))

    return Free(draw, lambda p: p)


# Ordinary numbers.


def _unit_vectors(numbers: Generator, angles: np.ndarray, size: int) -> np.ndarray:
    """Vectors of length 1."""
    axes = numbers.normal(size=(len(angles), size))
    return axes / np.linalg.norm(axes, axis=1, keepdims=True)


def _rotations(numbers: Generator, angles: np.ndarray, _: int) -> np.ndarray:
    """R = I + sin θ k~ + (1 - cos θ) k~² about random axes k, row by row."""
    x, y, z = _unit_vectors(numbers, angles, 3).T
    zero = np.zeros_like(x)
    k = np.stack([zero, -z, y, z, zero, -x, -y, x, zero], axis=1).reshape(-1, 3, 3)
    sine, versine = np.sin(angles)[:, None, None], 2 * np.sin(angles / 2)[:, None, None]**2
    return (np.eye(3) + sine * k + versine * (k @ k)).reshape(-1, 9)


def _displacements(numbers: Generator, angles: np.ndarray, _: int) -> np.ndarray:
    R = _rotations(numbers, angles, 9).reshape(-1, 3, 3)
    t = numbers.normal(size=(len(angles), 3, 1))
    return np.concatenate([R, t], axis=2).reshape(-1, 12)


def _quaternions(numbers: Generator, angles: np.ndarray, _: int) -> np.ndarray:
    """(k sin θ/2; cos θ/2) about random axes k."""
    half = angles[:, None] / 2
    return np.hstack([np.sin(half) * _unit_vectors(numbers, angles, 3), np.cos(half)])


def _sines_and_cosines(numbers: Generator, angles: np.ndarray, _: int) -> np.ndarray:
    return np.stack([np.sin(angles), np.cos(angles)], axis=1)


def _positive_definite(numbers: Generator, angles: np.ndarray, size: int) -> np.ndarray:
    """I + X X^T, row by row."""
    n = math.isqrt(size)
    X = numbers.normal(size=(len(angles), n, n))
    return (np.eye(n) + X @ X.swapaxes(1, 2)).reshape(-1, size)


def _inertias(numbers: Generator, angles: np.ndarray, size: int) -> np.ndarray:
    """The bodies of `_spatial_inertias`, moments about the centre of mass: I - (h·h 1 - h h^T) / m.
    """
    B = _spatial_inertias(numbers, angles, size)
    h = B[:, 1:4] / np.sqrt(B[:, :1])
    x, y, z = h.T
    own = np.stack([y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z], axis=1)
    return np.hstack([B[:, :4], (B[:, 4:] - own)[:, [0, 1, 2, 3, 5, 4]]])


def _spatial_inertias(numbers: Generator, angles: np.ndarray, _: int) -> np.ndarray:
    """Σ m (1, r, r·r 1 - r r^T) of six point masses, so that the body can exist."""
    shape = (len(angles), 6)
    m, (x, y, z) = 0.1 + numbers.random(shape), numbers.normal(size=(3, *shape))
    return np.stack([np.sum(m * part, axis=1) for part in (
        1, x, y, z, y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z)], axis=1)


def _half_turns(numbers: Generator, angles: np.ndarray, size: int) -> np.ndarray:
    """Normally distributed; rotation vectors longer than π are shortened to π."""
    x = numbers.normal(size=(len(angles), size))
    x[:, -3:] = _within_pi(x[:, -3:])
    return x


def _fractions(numbers: Generator, angles: np.ndarray, size: int) -> np.ndarray:
    """Numbers in [0, 1)."""
    return numbers.random((len(angles), size))


def _factors(numbers: Generator, angles: np.ndarray, size: int) -> np.ndarray:
    """L + D - 1, row by row: a unit lower triangle L with pivots D about 1 on its diagonal."""
    n = math.isqrt(size)
    lower = np.tril(numbers.normal(size=(len(angles), n, n)), -1)
    pivots = np.exp2(numbers.normal(size=(len(angles), n, 1)))
    return (lower + pivots * np.eye(n)).reshape(-1, size)


def _masses(numbers: Generator, angles: np.ndarray, size: int) -> np.ndarray:
    return np.abs(numbers.normal(size=(len(angles), size)))


_ORDINARY: dict[Domain, Ordinary] = {
    ROTATION: _rotations, NEAR_ROTATION: _rotations, DISPLACEMENT: _displacements,
    SINE_COSINE: _sines_and_cosines, UNIT_QUATERNION: _quaternions, NONZERO: _quaternions,
    ORDINARY: _quaternions, UNIT_VECTOR: _unit_vectors, FRACTION: _fractions, MASS: _masses,
    HALF_TURN: _half_turns, POSITIVE_DEFINITE: _positive_definite, SYMMETRIC: _positive_definite,
    LDL_FACTOR: _factors}


# Difficult directions and angles.


def directions(rng: Generator, n: int) -> Rows:
    """Unit vectors: a third anywhere, a third near a coordinate plane or axis, a third in one."""
    x = rng.standard_normal((n, 3))
    near = np.exp2(-rng.uniform(0, 60, x.shape) * (rng.random(x.shape) < 0.6))
    inside = rng.random(x.shape) < 0.6
    kind = np.arange(n)[:, None] % 3
    x *= np.where(kind == 1, near, np.where((kind == 2) & inside, 0, 1))
    x[~x.any(axis=1), rng.integers(3)] = 1
    return x / np.linalg.norm(x, axis=1)[:, None]


def angles(rng: Generator, n: int) -> np.ndarray:
    """Angles from 0 to π; tiny ones; just below π; around π/4, π/2 and 2, where series end."""
    tiny, below = np.exp(rng.uniform(np.log(1e-30), 0, n)), np.exp2(rng.uniform(-56, 0, n))
    around = rng.choice([2.0, np.pi / 2, np.pi / 4], n) + below * rng.choice((-1, 1), n)
    kinds = np.array([rng.uniform(0, np.pi, n), tiny, np.pi - below, around])
    return kinds[rng.integers(len(kinds), size=n), np.arange(n)]


def _turns(rng: Generator, n: int, dtype: np.dtype) -> Rows:
    return directions(rng, n) * angles(rng, n)[:, None]


def _large_turns(rng: Generator, n: int, dtype: np.dtype) -> Rows:
    """Rotation vectors: a third from π to 5e4 long, half of those next to a multiple of π/2."""
    far = np.exp(rng.uniform(np.log(np.pi), np.log(5e4), n))
    near = np.rint(far / (np.pi / 2)) * (np.pi / 2) + np.exp2(-rng.uniform(0, 40, n))
    large = np.where(rng.random(n) < 0.5, far, near)
    return directions(rng, n) * np.where(rng.random(n) < 1 / 3, large, angles(rng, n))[:, None]


def _wide(rng: Generator, n: int, dtype: np.dtype) -> Rows:
    """Vectors from 2^-40 to 2^40 long, a quarter with components of different sizes."""
    x = directions(rng, n) * np.exp2(rng.uniform(-40, 40, (n, 1)) * (rng.random((n, 1)) < 0.5))
    return x * np.exp2(rng.uniform(-30, 0, x.shape) * (rng.random((n, 1)) < 0.25))


def _within_pi(v: Rows) -> Rows:
    length = np.sqrt((v.astype(np.longdouble)**2).sum(axis=1))[:, None]
    return v * np.minimum(1, PI / np.maximum(length, 1))


def _flushed(x: Rows) -> Rows:
    return np.where(np.abs(x) < LEAST_TURN, 0, x).astype(np.longdouble)


def _normalized(x: Rows) -> Rows:
    x = x.astype(np.longdouble)
    largest = np.abs(x).max(axis=1)[:, None]
    x = x / np.where(largest > 0, largest, 1)
    x[:, 0] += largest[:, 0] == 0
    x = _flushed(x)
    return x / np.sqrt((x * x).sum(axis=1))[:, None]


def _some_multiple(p: Rows) -> Rows:
    """A unit quaternion times 2^p, -20 <= p <= 20 the last parameter."""
    return _normalized(p[:, :4]) * np.exp2(np.clip(p[:, 4:], -20, 20))


def rotation_matrices(v: Rows) -> Rows:
    """exp v~, row by row, in extended precision."""
    v = _flushed(v)
    half = np.sqrt((v * v).sum(axis=1)) / 2
    k = np.where(half > 0, np.sin(half) / np.where(half > 0, 2 * half, 1), 0.5)
    w, (x, y, z) = np.cos(half), k * v.T
    return np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
                     2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                     2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)], axis=1)


def _moved(p: Rows) -> Rows:
    R = rotation_matrices(p[:, :3]).reshape(-1, 3, 3)
    return np.concatenate([R, p[:, 3:, None]], axis=2).reshape(-1, 12)


_TURN = Free(_turns, _within_pi)
_UNIT_VECTOR = Free(lambda rng, n, dtype: directions(rng, n), _normalized)
_ANGLE = Free(lambda rng, n, dtype: (angles(rng, n) * rng.choice((-1, 1), n))[:, None],
               lambda p: np.clip(p, -PI, PI))
_FRACTION = Free(lambda rng, n, dtype: rng.choice([0, 1, 0.5, *rng.uniform(0, 1, 8)], (n, 1)),
                  lambda p: np.clip(p, 0, 1))
_ROTATION = Free(_turns, rotation_matrices)
_DISPLACEMENT = Free(lambda rng, n, dtype: np.hstack([_turns(rng, n, dtype),
                                                       _wide(rng, n, dtype)]), _moved)
_LARGE_TURN = Free(_large_turns, lambda p: np.clip(p, -5e4, 5e4))
_LARGE_MOTION = Free(lambda rng, n, dtype: np.hstack([_wide(rng, n, dtype),
                                                       _large_turns(rng, n, dtype)]),
                      lambda p: np.hstack([p[:, :3], np.clip(p[:, 3:], -5e4, 5e4)]))
_MOTION = Free(lambda rng, n, dtype: np.hstack([_wide(rng, n, dtype), _turns(rng, n, dtype)]),
                lambda p: np.hstack([p[:, :3], _within_pi(p[:, 3:])]))


def _hard_quaternions(rng: Generator, n: int, dtype: np.dtype) -> Rows:
    half, sign = angles(rng, n)[:, None] / 2, rng.choice((-1, 1), (n, 1))
    return sign * np.hstack([np.sin(half) * directions(rng, n), np.cos(half)])


_UNIT_QUATERNION = Free(_hard_quaternions, _normalized)
_QUATERNION = Free(lambda rng, n, dtype: np.hstack([
    _hard_quaternions(rng, n, dtype), rng.uniform(-20, 20, (n, 1)) * (rng.random((n, 1)) < 0.5)]),
    _some_multiple)
_HARD: dict[Domain, Free] = {
    ROTATION: _ROTATION, DISPLACEMENT: _DISPLACEMENT, UNIT_VECTOR: _UNIT_VECTOR, ANGLE: _ANGLE,
    FRACTION: _FRACTION, TURN: _LARGE_TURN, HALF_TURN: _TURN, UNIT_QUATERNION: _UNIT_QUATERNION,
    NONZERO: _QUATERNION, ORDINARY: _QUATERNION}
_OF_SCREWS: dict[Domain, Free] = {TURN: _LARGE_MOTION, HALF_TURN: _MOTION}
