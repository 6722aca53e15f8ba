"""Products of quaternions with quaternions, rotations about an axis and vectors; and rates.

Names are KSL's: `conj` after a factor conjugates it; `qx`, `qy`, `qz` is the rotation about an axis
with dci = (sine, cosine) of half its angle; `v` is the quaternion (v; 0).
"""

from collections.abc import Callable, Iterator
from functools import partial

import sympy as sp

from coscrew_codegen.algebra.matrices import unit
from coscrew_codegen.algebra.operations.formulas.rotation import (
    conjugate,
    quaternion,
    quaternion_product,
)
from coscrew_codegen.algebra.operations.operation import Operation
from coscrew_codegen.program.values.quantity import ANY, DC, QUATERNION, SCALAR, VEC3, Argument

_NAME = "quaternion"

_q1, _q2, _qi, _qo, _dqo = (Argument(name, QUATERNION)
                            for name in ("q1i", "q2i", "qi", "qo", "dqo"))
_dc = Argument("dci", DC)
_vi, _w, _dpi = (Argument(name, VEC3, ANY) for name in ("vi", "w", "dpi"))

# name in operations, text in equations, argument, conversion to a quaternion
Factor = tuple[str, str, Argument, Callable[[sp.Matrix], sp.Matrix]]
_op = partial(Operation, _NAME)


def _pure(v: sp.Matrix) -> sp.Matrix:
    return quaternion(v, sp.Integer(0))


def _turn(axis: int) -> Factor:
    letter = "xyz"[axis]
    return (f"q{letter}", f"(s e_{letter}; c)", _dc,
            lambda dc: quaternion(dc[0] * unit(axis), dc[1]))


def _given(argument: Argument) -> Factor:
    return "q", argument.name, argument, lambda q: q


def _conjugated(factor: Factor) -> Factor:
    name, words, argument, of = factor
    return f"{name}conj", f"{words}*", argument, lambda x: conjugate(of(x))


def _product(first: Factor, second: Factor, also: str = "") -> Operation:
    (left, words1, a, of_a), (right, words2, b, of_b) = first, second
    return _op(f"quaternion_product_{left}{right}", f"qo = {words1} {words2}{also}", (a, b), (_qo,),
               lambda x, y: quaternion_product(of_a(x), of_b(y)))


def _every_conjugation(first: Factor, second: Factor, also: str = "") -> Iterator[Operation]:
    for a in (first, _conjugated(first)):
        for b in (second, _conjugated(second)):
            yield _product(a, b, also)


def _about_axes() -> Iterator[Operation]:
    for axis in range(3):
        turn, other = _turn(axis), _given(_qi)
        also = ", dci = (s, c), sine and cosine of half the angle"
        yield from _every_conjugation(turn, other, also)
        yield from _every_conjugation(other, turn, also)


def _with_vectors() -> Iterator[Operation]:
    vector, other = ("v", "(vi; 0)", _vi, _pure), _given(_qi)
    yield from (_product(other, vector), _product(_conjugated(other), vector),
                _product(vector, other), _product(vector, _conjugated(other)))


def _increment(q: sp.Matrix, dpi: sp.Matrix) -> sp.Matrix:
    return quaternion_product(q, _pure(dpi)) / 2


def _rate(w: sp.Matrix, q: sp.Matrix) -> sp.Matrix:
    return quaternion_product(_pure(w), q) / 2 + (1 - q.dot(q)) * q


PRODUCTS = (
    *_every_conjugation(_given(_q1), _given(_q2)), *_about_axes(), *_with_vectors(),
    _op("dot_qq", "q1i·q2i", (_q1, _q2), (Argument("dot", SCALAR),), lambda p, q: p.dot(q)),
    _op("add_dpiToq", "qi = qi + qi (dpi; 0) / 2: rotated by the small rotation vector dpi in the "
        "rotated frame, to first order; not normalized", (_dpi, _qi), (_qi,),
        lambda dpi, q: q + _increment(q, dpi)),
    _op("subtract_dpiFromq", "qi = qi - qi (dpi; 0) / 2, the opposite of add_dpiToq to first order",
        (_dpi, _qi), (_qi,), lambda dpi, q: q - _increment(q, dpi)),
    _op("omega_to_dquaternion", "dqo = (w; 0) qi / 2 + (1 - qi·qi) qi: the rate of qi for the "
        "angular velocity w in the reference frame, rad/s, and a term that draws its norm to 1",
        (_w, _qi), (_dqo,), _rate),
)
