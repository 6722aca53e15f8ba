"""What operations are made for: any numbers, or rotations, unit quaternions, fractions.

Inputs of a domain are functions of free parameters, so that whatever a search does to parameters,
the inputs stay in the domain, rounded once.
"""

import functools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from coscrew_codegen.operations import Operation
from coscrew_codegen.quantity import ANY as ANYTHING
from coscrew_codegen.quantity import FRACTION as A_FRACTION
from coscrew_codegen.quantity import TURN as ANY_TURN
from coscrew_codegen.quantity import UNIT as OF_LENGTH_1
from coscrew_codegen.quantity import Argument

Rows = np.ndarray  # (n, columns)
Generator = np.random.Generator
PI = np.longdouble("3.14159265358979323846264338327950288")
LEAST_TURN = 1e-30  # below it 60 digits do not tell a rotation's axis; it becomes zero


@dataclass(frozen=True)
class Domain:
    """Draws rows of parameters for a dtype; turns parameters into rows of input components."""

    draw: Callable[[Generator, int, np.dtype], Rows]
    inputs: Callable[[Rows], Rows]


def domains(operation: Operation) -> tuple[Domain, ...]:
    """One domain per input.  A polynomial takes any numbers, a rotation or not, and so does what
    says nothing of its inputs."""
    return tuple(_domain(a) if operation.normwise or a.domain != ANYTHING else
                 _any(a.quantity.size) for a in operation.inputs)


def _domain(argument: Argument) -> Domain:
    kind, unit = argument.quantity.name, argument.domain == OF_LENGTH_1
    if kind == "scalar":
        return FRACTION if argument.domain == A_FRACTION else ANGLE
    if argument.domain == ANY_TURN:
        return LARGE_TURN if kind == "vec3" else LARGE_MOTION
    if kind == "vec3":
        return UNIT_VECTOR if unit else TURN
    if kind == "quaternion":
        return UNIT_QUATERNION if unit else QUATERNION
    return {"mat3x3": ROTATION, "SE3": DISPLACEMENT, "screw": MOTION}[kind]


def angle(operation: Operation, given: Sequence[float]) -> float:
    """Of the input that may turn by any angle; 0 where there is none."""
    start = 0
    for a in operation.inputs:
        numbers = given[start:start + a.quantity.size]
        if a.domain == ANY_TURN:
            return math.hypot(*numbers[-3:])
        start += a.quantity.size
    return 0.0


def defect(operation: Operation, given: Sequence[float]) -> float:
    """How far rotations, unit quaternions and unit vectors among the inputs are from being so."""
    worst, start = 0.0, 0
    for a in operation.inputs:
        x = np.reshape(np.array(given[start:start + a.quantity.size], np.longdouble),
                       a.quantity.rows_columns)
        start += a.quantity.size
        if not operation.normwise and a.domain == ANYTHING:
            continue
        if a.quantity.name in ("mat3x3", "SE3"):
            worst = max(worst, np.abs(x[:, :3].T @ x[:, :3] - np.eye(3)).max())
        elif _domain(a) in (UNIT_VECTOR, UNIT_QUATERNION):
            worst = max(worst, abs((x * x).sum() - 1))
    return float(worst)


@functools.cache
def _any(size: int) -> Domain:
    def draw(rng: Generator, n: int, dtype: np.dtype) -> Rows:
        """Ordinary; of sizes around one, which differ; of all sizes."""
        x = rng.standard_normal((n, size))
        reach = np.where(np.arange(n) % 3, np.where(np.arange(n) % 3 == 1, 30, 0),
                         np.finfo(dtype).maxexp - 20)[:, None]
        center = rng.uniform(-1, 1, (n, 1)) * reach
        exponents = center + rng.uniform(-30, 30, x.shape) * (reach > 0)
        return np.ldexp(x, np.clip(exponents, np.finfo(dtype).minexp - 20,
                                   np.finfo(dtype).maxexp - 4).astype(int))

    return Domain(draw, lambda p: p)


# Directions and angles, with what makes them hard.


def directions(rng: Generator, n: int) -> Rows:
    """Unit vectors: a third anywhere, a third near a plane or an axis, a third in one."""
    x = rng.standard_normal((n, 3))
    near = np.exp2(-rng.uniform(0, 60, x.shape) * (rng.random(x.shape) < 0.6))
    inside = rng.random(x.shape) < 0.6
    kind = np.arange(n)[:, None] % 3
    x *= np.where(kind == 1, near, np.where((kind == 2) & inside, 0, 1))
    x[~x.any(axis=1), rng.integers(3)] = 1
    return x / np.linalg.norm(x, axis=1)[:, None]


def angles(rng: Generator, n: int) -> np.ndarray:
    """Anywhere from 0 to π; tiny; just below π; around π/2 and around 2, where series end."""
    tiny, below = np.exp(rng.uniform(np.log(1e-30), 0, n)), np.exp2(rng.uniform(-56, 0, n))
    around = rng.choice([2.0, np.pi / 2, np.pi / 4], n) + below * rng.choice((-1, 1), n)
    kinds = np.array([rng.uniform(0, np.pi, n), tiny, np.pi - below, around])
    return kinds[rng.integers(len(kinds), size=n), np.arange(n)]


def _turns(rng: Generator, n: int, dtype: np.dtype) -> Rows:
    return directions(rng, n) * angles(rng, n)[:, None]


def _large_turns(rng: Generator, n: int, dtype: np.dtype) -> Rows:
    """A third beyond π, to 1e5, half of them next to a multiple of π/2."""
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
    """Of a unit quaternion, by 2^-20 to 2^20; the last parameter says which."""
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


def _displacements(p: Rows) -> Rows:
    R = rotation_matrices(p[:, :3]).reshape(-1, 3, 3)
    return np.concatenate([R, p[:, 3:, None]], axis=2).reshape(-1, 12)


TURN = Domain(_turns, _within_pi)
UNIT_VECTOR = Domain(lambda rng, n, dtype: directions(rng, n), _normalized)
ANGLE = Domain(lambda rng, n, dtype: (angles(rng, n) * rng.choice((-1, 1), n))[:, None],
               lambda p: np.clip(p, -PI, PI))
FRACTION = Domain(lambda rng, n, dtype: rng.choice([0, 1, 0.5, *rng.uniform(0, 1, 8)], (n, 1)),
                  lambda p: np.clip(p, 0, 1))
ROTATION = Domain(_turns, rotation_matrices)
DISPLACEMENT = Domain(lambda rng, n, dtype: np.hstack([_turns(rng, n, dtype),
                                                       _wide(rng, n, dtype)]), _displacements)
LARGE_TURN = Domain(_large_turns, lambda p: np.clip(p, -5e4, 5e4))
LARGE_MOTION = Domain(lambda rng, n, dtype: np.hstack([_wide(rng, n, dtype),
                                                       _large_turns(rng, n, dtype)]),
                      lambda p: np.hstack([p[:, :3], np.clip(p[:, 3:], -5e4, 5e4)]))
MOTION = Domain(lambda rng, n, dtype: np.hstack([_wide(rng, n, dtype), _turns(rng, n, dtype)]),
                lambda p: np.hstack([p[:, :3], _within_pi(p[:, 3:])]))


def _quaternions(rng: Generator, n: int, dtype: np.dtype) -> Rows:
    half, sign = angles(rng, n)[:, None] / 2, rng.choice((-1, 1), (n, 1))
    return sign * np.hstack([np.sin(half) * directions(rng, n), np.cos(half)])


UNIT_QUATERNION = Domain(_quaternions, _normalized)
QUATERNION = Domain(lambda rng, n, dtype: np.hstack([
    _quaternions(rng, n, dtype), rng.uniform(-20, 20, (n, 1)) * (rng.random((n, 1)) < 0.5)]),
    _some_multiple)
