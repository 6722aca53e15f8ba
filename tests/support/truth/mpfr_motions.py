"""Motions and elementary functions in MPFR, from sines, cosines and arctangents: none of the
kernels' formulas, and no series but that of (θ - sin θ) / θ³ and of b at small angles.

Arguments are exact, numbers of a context of BITS; so results have as many digits as are wanted.
"""

import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import reduce
from itertools import chain

import gmpy2
from gmpy2 import mpfr

BITS = 320
Vector = Sequence[mpfr]
Matrix = Sequence[Vector]
ZERO, ONE = mpfr(0), mpfr(1)


def ratio(result: float, bound: float, true: mpfr) -> float:
    """The error as a part of its bound, rounded up."""
    with gmpy2.context(precision=BITS, round=gmpy2.RoundUp):
        error = abs(mpfr(result) - true)
        return float(error / mpfr(bound)) if bound else math.inf if error else 0.0


def dot(a: Vector, b: Vector) -> mpfr:
    """a·b."""
    return sum(map(gmpy2.mul, a, b), ZERO)


def cross(a: Vector, b: Vector) -> list[mpfr]:
    """a × b."""
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def times(A: Matrix, b: Vector) -> list[mpfr]:
    """A b."""
    return [dot(row, b) for row in A]


def size(v: Vector) -> mpfr:
    """|v|."""
    return gmpy2.sqrt(dot(v, v))


def sinc(x: mpfr) -> mpfr:
    """sin x / x."""
    return gmpy2.sin(x) / x if x else ONE


def third(angle: mpfr) -> mpfr:
    """(θ - sin θ) / θ³; below 1 by Σ (-θ²)^j / (2j + 3)!, in which nothing cancels."""
    if angle > 1:
        return (angle - gmpy2.sin(angle)) / angle**3
    j, total, term = 2, ZERO, mpfr(Fraction(1, 6))
    while abs(term) > gmpy2.exp2(-BITS):
        j, total, term = j + 1, total + term, -term * angle**2 / (2 * j * (2 * j + 1))
    return total


def of_inverse(angle: mpfr) -> mpfr:
    """(1 - θ/2 cot θ/2) / θ², of which 2 log2 θ digits cancel; 1/12 below 2^-BITS."""
    if angle < gmpy2.exp2(-BITS):
        return mpfr(Fraction(1, 12))
    with gmpy2.context(precision=3 * BITS if angle < 1 else BITS):
        return (1 - angle / 2 * gmpy2.cot(angle / 2)) / angle**2


def polynomial(a: mpfr, b: mpfr, v: Vector) -> list[list[mpfr]]:
    """I + a v~ + b v~²."""
    square, (x, y, z) = dot(v, v), v
    across = ((ZERO, -z, y), (z, ZERO, -x), (-y, x, ZERO))
    return [[(i == j) * (1 - b * square) + a * across[i][j] + b * v[i] * v[j] for j in range(3)]
            for i in range(3)]


def rotation(v: Vector) -> list[list[mpfr]]:
    """exp v~."""
    angle = size(v)
    return polynomial(sinc(angle), sinc(angle / 2)**2 / 2, v)


def jacobian(v: Vector, sign: int = 1) -> list[list[mpfr]]:
    """The left one; the right one with sign -1."""
    angle = size(v)
    return polynomial(sign * sinc(angle / 2)**2 / 2, third(angle), v)


def inverse_jacobian(v: Vector, sign: int = 1) -> list[list[mpfr]]:
    """The left one's inverse; the right one's with sign -1."""
    return polynomial(mpfr(-sign) / 2, of_inverse(size(v)), v)


def versor(v: Vector) -> list[mpfr]:
    """exp (v/2; 0)."""
    half = size(v) / 2
    return [*(sinc(half) / 2 * x for x in v), gmpy2.cos(half)]


def moved(s: Vector) -> list[mpfr]:
    """The twelve components of exp s."""
    R, t = rotation(s[3:]), times(jacobian(s[3:]), s[:3])
    return [x for row, last in zip(R, t, strict=True) for x in (*row, last)]


def axis_and_angle(q: Vector) -> tuple[mpfr, list[mpfr]]:
    """The shorter angle of q's rotation and its axis; 0 and the x axis for a real q."""
    length, sign = size(q[:3]), -1 if q[3] < 0 else 1
    axis = [sign * x / length for x in q[:3]] if length else [ONE, ZERO, ZERO]
    return 2 * gmpy2.atan2(length, abs(q[3])), axis


def _logarithm(q: Vector) -> list[mpfr]:
    angle, axis = axis_and_angle(q)
    return [angle * x for x in axis]


def _about(axis: Vector, angle: mpfr) -> list[list[mpfr]]:
    return polynomial(gmpy2.sin(angle), 2 * gmpy2.sin(angle / 2)**2, axis)


def _product(A: Matrix, B: Matrix) -> list[list[mpfr]]:
    return [[dot(row, column) for column in zip(*B, strict=True)] for row in A]


def _euler(axes: str) -> Callable[[Vector], Matrix]:
    unit = {name: [ONE if x == name else ZERO for x in "xyz"] for name in axes}
    return lambda angles: reduce(_product, (
        _about(unit[name], a) for name, a in zip(axes, angles, strict=True)))


def _angle_between(x: Vector) -> list[mpfr]:
    return [gmpy2.atan2(size(cross(x[:3], x[3:])), dot(x[:3], x[3:]))]


def _flat(matrix: Callable[[Vector], Matrix]) -> Callable[[Vector], list[mpfr]]:
    return lambda v: list(chain.from_iterable(matrix(v)))


def _sincos(x: Vector) -> list[mpfr]:
    return [gmpy2.sin(x[0]), gmpy2.cos(x[0])]


TRUTHS: dict[str, Callable[[Vector], list[mpfr]]] = {
    "sincos": _sincos, "dc": _sincos, "sin": lambda x: [gmpy2.sin(x[0])],
    "cos": lambda x: [gmpy2.cos(x[0])], "exp": lambda x: [gmpy2.exp(x[0])],
    "tanh": lambda x: [gmpy2.tanh(x[0])], "atan2": lambda x: [gmpy2.atan2(*x)],
    "angle_vv": _angle_between,
    "mat3x3_from_euler_xyz": _flat(_euler("xyz")),
    "mat3x3_from_euler_xyx": _flat(_euler("xyx")),
    "mat3x3_from_axis_angle": _flat(lambda x: _about(x[:3], x[3])),
    "quaternion_from_axis_angle": lambda x: [
        *(gmpy2.sin(x[3] / 2) * y for y in x[:3]), gmpy2.cos(x[3] / 2)],
    "axis_angle_from_quaternion": lambda q: [axis_and_angle(q)[0], *axis_and_angle(q)[1]],
    "quaternion_exp": versor, "quaternion_log": _logarithm, "SO3_exp": _flat(rotation),
    "SO3_leftJacobian": _flat(jacobian), "SO3_rightJacobian": _flat(lambda v: jacobian(v, -1)),
    "SO3_leftJacobianInverse": _flat(inverse_jacobian),
    "SO3_rightJacobianInverse": _flat(lambda v: inverse_jacobian(v, -1)), "SE3_exp": moved}
"""From an operation's components to its results'."""
