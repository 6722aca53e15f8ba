"""Rotations and displacements for tests: angles of every magnitude, near π and near the ends of
series.

Rotation matrices and quaternions are rounded from 64 bits or more, so that rounding is their only
error.  Seeded by the operation's name: the same numbers in every run.
"""

from collections.abc import Callable

import numpy as np

from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.quantity import (
    ANGLE,
    DISPLACEMENT,
    FRACTION,
    HALF_TURN,
    NONZERO,
    ORDINARY,
    ROTATION,
    TURN,
    UNIT_QUATERNION,
    UNIT_VECTOR,
    Argument,
    Domain,
)

Rows = np.ndarray
Generator = np.random.Generator
WIDE = np.longdouble


def motions_of(operation: Operation, precision: Precision, n: int) -> tuple[Rows, ...]:
    """n rows of every input.  Two rotations differ by less than 170°: between opposite ones no
    shorter arc is defined."""
    rng = np.random.default_rng([*operation.name.encode(), precision.bytes])
    rows = tuple(_drawing(a)(rng, 2 * n + 20) for a in operation.inputs)
    names = [a.name for a in operation.inputs]
    near = np.full(len(rows[0]), True)
    if "q2" in names:
        near = np.abs((rows[0] * rows[1]).sum(axis=1)) > np.cos(np.radians(85))
    if "D2" in names:
        cosine = ((rows[0] * rows[1])[..., :3].sum(axis=(1, 2)) - 1) / 2
        near = cosine > np.cos(np.radians(170))
    return tuple(x[near][:n].astype(precision.numpy_type) for x in rows)


def angles(rng: Generator, n: int) -> Rows:
    """1e-30 … π on a logarithmic scale, [0, π] uniformly, π - 1e-1 … π - 1e-15, around 2, 0."""
    kinds = (10**rng.uniform(-30, np.log10(np.pi), n), rng.uniform(0, np.pi, n),
             np.pi - 10**rng.uniform(-15, -1, n), 2 + 10**rng.uniform(-16, -1, n),
             2 - 10**rng.uniform(-16, -1, n), np.zeros(n))
    return _mixed(rng, kinds, (3, 4, 3, 2, 2, 0.2))


def axes(rng: Generator, n: int) -> Rows:
    """Unit vectors to 64 bits: random; nearly in a coordinate plane or along an axis; along one."""
    x = rng.standard_normal((n, 3)).astype(WIDE)
    small = 10**rng.uniform(-20, -2, (n, 3)) * x
    axis, plane = (np.eye(3)[rng.integers(0, 3, n)] for _ in range(2))
    kinds = (x, np.where(plane == 1, small, x), np.where(axis == 1, x, small), axis * x)
    x = _mixed(rng, kinds, (4, 2, 2, 1))
    return x / np.sqrt((x * x).sum(axis=1, keepdims=True))


def vectors(rng: Generator, n: int) -> Rows:
    """Vectors of length 1e-6 to 1e6."""
    return axes(rng, n) * 10**rng.uniform(-6, 6, (n, 1))


def rotation_vectors(rng: Generator, n: int) -> Rows:
    return axes(rng, n) * angles(rng, n)[:, None]


def quaternions(rng: Generator, n: int) -> Rows:
    """Quaternions of norm 1 to 64 bits, w of either sign."""
    half = angles(rng, n).astype(WIDE)[:, None] / 2
    q = np.concatenate([np.sin(half) * axes(rng, n), np.cos(half)], axis=1)
    return q * rng.choice((-1, 1), (n, 1))


def multiples(rng: Generator, n: int) -> Rows:
    """Quaternions of any norm."""
    return quaternions(rng, n) * 10**rng.uniform(-9, 9, (n, 1))


def rotations(rng: Generator, n: int) -> Rows:
    """Rotations; the first ones by exactly π, about the axes and half-way between two axes."""
    x, y, z, w = quaternions(rng, n).T
    R = np.array([[w*w + x*x - y*y - z*z, 2*(x*y - w*z), 2*(x*z + w*y)],
                  [2*(x*y + w*z), w*w - x*x + y*y - z*z, 2*(y*z - w*x)],
                  [2*(x*z - w*y), 2*(y*z + w*x), w*w - x*x - y*y + z*z]])
    R = np.moveaxis(R, 2, 0)
    half_turns = [2 * np.outer(a, a) / (a @ a) - np.eye(3) for a in np.array(
        [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (1, 0, 1), (0, 1, 1), (1, -1, 0),
         (1, 0, -1), (0, 1, -1)])]
    R[:len(half_turns)] = half_turns[:n]
    return R


def displacements(rng: Generator, n: int) -> Rows:
    return np.concatenate([rotations(rng, n), vectors(rng, n)[:, :, None]], axis=2)


def screws(rng: Generator, n: int) -> Rows:
    return np.concatenate([vectors(rng, n), rotation_vectors(rng, n)], axis=1)


def fractions(rng: Generator, n: int) -> Rows:
    """0, 1, and numbers about [0, 1]."""
    return _mixed(rng, (rng.uniform(-0.5, 1.5, n), np.zeros(n), np.ones(n)), (8, 1, 1))


DRAW: dict[Domain, Callable[[Generator, int], Rows]] = {
    TURN: rotation_vectors, HALF_TURN: rotation_vectors, ROTATION: rotations,
    DISPLACEMENT: displacements, NONZERO: multiples, ORDINARY: multiples,
    UNIT_QUATERNION: quaternions, UNIT_VECTOR: axes, ANGLE: angles, FRACTION: fractions}


def _drawing(argument: Argument) -> Callable[[Generator, int], Rows]:
    return screws if argument.quantity.name == "screw" else DRAW[argument.domain]


def _mixed(rng: Generator, kinds: tuple[Rows, ...], weights: tuple[float, ...]) -> Rows:
    """Each row from one of the kinds."""
    n, chances = len(kinds[0]), np.array(weights) / sum(weights)
    choice = rng.choice(len(kinds), n, p=chances)
    return np.stack(kinds)[choice, np.arange(n)]
