"""The functions of series.py to twice the digits, from sine and cosine of half the angle.

With h = θ/2, y = h², k = sin h / h and c = cos h, nothing cancels in

    g(0) = 1 - 2 sin² h    g(1) = k c    g(2) = k²/2    θ/2 cot θ/2 = c / k
    b = f / 4k             2 b' = (f²/2 - φ k) / 8k²

where f = (k - c) / y = (k + 2 y φ) / 3 and φ = -f' = (3 f - k) / 2y.  Only g(4), g(5), of which
g(3) = 1/6 - θ² g(5) is made, and φ are series, up to θ = 1 and θ = 2.  Their closed forms cancel
7 bits at most.
"""

from dataclasses import dataclass
from functools import cached_property

import sympy as sp

from coscrew_codegen.algebra.operations.formulas.norm import Let, l2, largest_size
from coscrew_codegen.algebra.operations.formulas.series import (
    Angle,
    alternating,
    beyond,
    far,
    taylor,
)
from coscrew_codegen.algebra.operations.operation import LARGE, REDUCING, scaled

_SMALL = sp.Rational(1, 2**26)  # two terms of sin h / h leave out less than 2^-110 up to it
_TERMS = 14  # the first truncated term is below 2^-105 of g(4), g(5) and f


@dataclass(frozen=True)
class HalfAngle:
    """y, sin h, k and c."""

    let: Let
    y: sp.Expr
    sine: sp.Expr
    k: sp.Expr
    c: sp.Expr

    @classmethod
    def of(cls, let: Let, half: sp.Matrix) -> "HalfAngle":
        """h is the length of half a rotation vector."""
        y = let("y", half.dot(half))
        return cls._of(let, y, let("half_angle", sp.sqrt(y)))

    @classmethod
    def of_any(cls, let: Let, half: sp.Matrix) -> "HalfAngle":
        """Returns the angle also where y overflows; only sin h, k and c are then usable."""
        s = let("s", sp.Piecewise((REDUCING, largest_size(let, "h", half) > LARGE), (1, True)))
        reduced = let("reduced", half.applyfunc(lambda x: scaled(x, s)))
        up = let("up", sp.Piecewise((1 / REDUCING, s < 1), (sp.Integer(1), True)))
        h = let("half_angle", scaled(let("reduced_length", l2(reduced)), up))
        return cls._of(let, let("y", h**2), h)

    @classmethod
    def _of(cls, let: Let, y: sp.Expr, h: sp.Expr) -> "HalfAngle":
        sine, c = let("sine", sp.sin(h)), let("c", sp.cos(h))
        return cls(let, y, sine, _quotient(let, sine, h, y), c)

    @classmethod
    def known(cls, let: Let, theta: sp.Expr, sine: sp.Expr, cosine: sp.Expr) -> "HalfAngle":
        """Makes it from a known angle and any common multiple of sin θ/2 and cos θ/2; serves only
        b."""
        h, length = let("half_angle", theta / 2), let("length", sp.sqrt(sine**2 + cosine**2))
        sine, c = let("sine", sine / length), let("c", cosine / length)
        y = let("y", h**2)
        return cls(let, y, sine, _quotient(let, sine, h, y), c)

    def g(self, *orders: int) -> tuple[sp.Expr, ...]:
        """g(k, θ²) for these k from 0 to 3."""
        let, k = self.let, self.k
        results = {1: let("g1", k * self.c), 2: let("g2", k**2 / 2)}
        if 0 in orders:
            results[0] = let("g0", 1 - 2 * let("sine_square", self.sine**2))
        if 3 in orders:
            closed = let("closed3", let("rest3", 1 - results[1]) / self._far)
            results[3] = let("g3", far(self.square, closed,
                                       sp.Rational(1, 6) - self.square * self._series5))
        return tuple(results[k] for k in orders)

    def g_rates(self, g1: sp.Expr, g2: sp.Expr, g3: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """2 g'(2) = 2 g(4) - g(3) and 2 g'(3) = 3 g(5) - g(4)."""
        let, x = self.let, self.square
        closed4 = let("closed4", let("rest4", sp.Rational(1, 2) - g2) / self._far)
        closed5 = let("closed5", let("rest5", sp.Rational(1, 6) - g3) / self._far)
        g4 = let("g4", far(x, closed4, let("series4", taylor(4, x, _TERMS))))
        g5 = let("g5", far(x, closed5, self._series5))
        return let("rate2", 2 * g4 - g3), let("rate3", 3 * g5 - g4)

    def b(self) -> tuple[sp.Expr, sp.Expr]:
        """b(θ²), and 1 - θ² b = θ/2 cot θ/2."""
        let = self.let
        return let("b", self._f / let("four_k", 4 * self.k)), let("b_across", self.c / self.k)

    def b_rate(self) -> sp.Expr:
        """2 b'(θ²)."""
        let, k, f = self.let, self.k, self._f
        closed = let("closed_phi", let("phi_rest", 3 * f - k) / let("twice_y", 2 * self._y))
        phi = let("phi", beyond(self.square, closed, self._series_phi))
        rest = let("b_rate_above", f**2 / 2 - k * phi)
        return let("b_rate", rest / let("b_rate_below", 8 * k**2))

    @cached_property
    def square(self) -> sp.Expr:
        """θ²."""
        return self.let("x", 4 * self.y)

    @cached_property
    def _far(self) -> sp.Expr:
        """θ², or 1 where that is small."""
        return self.let("far_x", far(self.square, self.square, sp.Integer(1)))

    @cached_property
    def _series5(self) -> sp.Expr:
        return self.let("series5", taylor(5, self.square, _TERMS))

    @cached_property
    def _y(self) -> sp.Expr:
        """y, or 1 where that is small."""
        return self.let("far_y", beyond(self.square, self.y, sp.Integer(1)))

    @cached_property
    def _series_phi(self) -> sp.Expr:
        series = alternating(
            lambda j: (-1)**j * (j + 1) * (2 * j + 4) / sp.factorial(2 * j + 5), self.y, _TERMS,
            sp.Integer(1))
        return self.let("series_phi", series)

    @cached_property
    def _f(self) -> sp.Expr:
        let, y = self.let, self.y
        near = let("near_f", (self.k + let("f_more", 2 * y * self._series_phi)) / 3)
        closed = let("closed_f", let("f_rest", self.k - self.c) / self._y)
        return let("f", beyond(self.square, closed, near))


def _quotient(let: Let, sine: sp.Expr, h: sp.Expr, y: sp.Expr) -> sp.Expr:
    """k = sin h / h; its series up to h = 2^-26, so that nothing is divided by a number that may be
    0."""
    quotient = let("sinc_quotient", sine / let("sinc_divisor", _far_from_zero(h, h, _SMALL)))
    return let("sinc", _far_from_zero(h, quotient, alternating(
        lambda j: sp.Rational((-1)**j, sp.factorial(2 * j + 1)), y, 2, _SMALL**2)))


def _far_from_zero(h: sp.Expr, value: sp.Expr, near: sp.Expr) -> sp.Piecewise:
    """`near` where h is small, else `value`."""
    return sp.Piecewise((near, h < _SMALL), (value, True))


def angle_of(let: Let, vector: sp.Matrix) -> Angle | HalfAngle:
    """The angle of a rotation vector."""
    return HalfAngle.of(let, let("halved", vector / 2)) if let.fine else Angle.of(let, vector)


def known_angle(let: Let, theta: sp.Expr, sine: sp.Expr, cosine: sp.Expr) -> Angle | HalfAngle:
    """A known angle, and any common multiple of sin θ/2 and cos θ/2; serves only b."""
    return (HalfAngle if let.fine else Angle).known(let, theta, sine, cosine)
