"""Functions of an angle's square whose closed forms lose digits at small angles.

    g(k, θ²) = Σ (-θ²)^j / (2j + k)!      b(θ²) = (1 - θ/2 cot θ/2) / θ²

g(1) = sin θ / θ, g(2) = (1 - cos θ) / θ², g(3) = (θ - sin θ) / θ³; g(k + 2) = (1/k! - g(k)) / θ².
They are computed by series up to θ = 1 (g(1), g(2)) or 2, beyond that by closed forms in sin θ and
cos θ, which are evaluated only there.  If ω has the rate v, then g(k, ω·ω) has the rate
2 g'(k) v·ω; likewise b.
"""

from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp

from coscrew_codegen.algebra.operations.formulas.norm import Let
from coscrew_codegen.algebra.operations.operation import GRID, truncated

_NEAR = sp.Integer(1)  # θ² up to which g(1), g(2) are series; beyond, closed forms lose no digits
_MIDDLE = sp.Integer(4)  # θ² up to which the other functions are series
_LATE = sp.Integer(9)  # θ² up to which 2 g'(2), 2 g'(3) are: their closed forms cancel most
_CORRECTED = sp.Rational(1, 2**7)  # errors of angles below it are corrected, to first order
_TAYLOR_TERMS, _BERNOULLI_TERMS = 13, 17  # truncation error below u / 4 there, in double


@dataclass(frozen=True)
class Angle:
    """θ, θ², and sin θ, cos θ and cot θ/2 for the closed forms; meaningless unless θ > 1."""

    let: Let
    square: sp.Expr
    angle: sp.Expr
    sine: sp.Expr
    cosine: sp.Expr
    cotangent: sp.Expr  # of θ/2

    @classmethod
    def of(cls, let: Let, vector: sp.Matrix) -> "Angle":
        """The angle θ = |v| of a rotation vector v.

        θ² has about one rounding error: the squares of the components' leading digits add up
        exactly.  θ = sqrt(θ²) has an error of half an ulp, which near π is 2 u in sin θ; it is
        corrected by the residual |v|² - θ² while θ u < 2^-7.  The error of larger angles is 2 u θ.
        """
        sizes = let("size", vector.applyfunc(sp.Abs))
        grid = let("grid", GRID * let("sizes", sizes[0] + sizes[1] + sizes[2]))
        shifted = let("shifted", vector.applyfunc(lambda x: x + grid))
        high = let("high", shifted.applyfunc(lambda x: x - grid))
        low, sum_ = let("low", vector - high), let("sum", vector + high)
        squares, cross = let("squares", high.dot(high)), let("cross", low.dot(sum_))
        x = let("x", squares + cross)
        theta = let("theta", far(x, sp.sqrt(x), sp.Integer(1)))
        top = let("theta_high", let("theta_shifted", theta + grid) - grid)
        bottom = let("theta_low", theta - top)
        rest = let("cross_rest", cross - bottom * let("theta_sum", theta + top))
        small = let("small", let("residual", let("exact", squares - top**2) + rest) / (2 * theta))
        delta = let("delta", sp.Piecewise((small, sp.Abs(small) < _CORRECTED), (0, True)))
        sine = let("far_sine", far(x, sp.sin(theta), sp.Integer(1)))
        cosine = let("far_cosine", far(x, sp.cos(theta), sp.Integer(0)))
        corrected = let("sine", sine + delta * cosine), let("cosine", cosine - delta * sine)
        return cls(let, x, theta, *corrected, _half_cotangent(let, *corrected))

    @classmethod
    def known(cls, let: Let, theta: sp.Expr, sine: sp.Expr, cosine: sp.Expr,
              square: sp.Expr | None = None) -> "Angle":
        """Makes it from a known angle and any common multiple of sin θ/2 and cos θ/2; serves only
        b.  `square` is θ², if that is known better."""
        x = let("x", theta**2 if square is None else square)
        divisor = let("far_sine", far(x, sine, sp.Integer(1)))
        return cls(let, x, theta, sine, cosine, let("cotangent", cosine / divisor))

    def g(self, *orders: int) -> tuple[sp.Expr, ...]:
        """g(k, θ²) for these k in ascending order; g(0) = cos θ only together with g(2)."""
        let, x = self.let, self.square
        far_x, middle_x = let("far_x", far(x, x, _NEAR)), let("middle_x", beyond(x, x, _MIDDLE))
        closed = {1: let("closed1", self.sine / self.angle),
                  2: let("closed2", let("versine", 1 - self.cosine) / far_x)}
        for k in range(3, max(orders) + 1):
            rest = let(f"rest{k}", sp.Rational(1, sp.factorial(k - 2)) - closed[k - 2])
            closed[k] = let(f"closed{k}", rest / middle_x)
        results = {k: let(f"g{k}", (far if k <= 2 else beyond)(x, closed[k], taylor(k, x)))
                   for k in orders if k}
        if 0 in orders:
            results[0] = let("g0", far(x, self.cosine, 1 - x * results[2]))
        return tuple(results[k] for k in orders)

    def b(self) -> tuple[sp.Expr, sp.Expr]:
        """b(θ²), and 1 - θ² b = θ/2 cot θ/2."""
        let, x = self.let, self.square
        half = let("half_cotangent", self.angle * self.cotangent / 2)
        closed = let("closed_b", let("b_rest", 1 - half) / let("b_divisor", beyond(x, x, _MIDDLE)))
        b = let("b", beyond(x, closed, _bernoulli(x)))
        return b, let("b_across", beyond(x, half, 1 - x * b))


    def g_rates(self, g1: sp.Expr, g2: sp.Expr, g3: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """2 g'(2) = (g(1) - 2 g(2)) / θ² and 2 g'(3) = (g(2) - 3 g(3)) / θ²."""
        let, x = self.let, self.square
        late = let("late_x", sp.Piecewise((sp.Integer(1), x < _LATE), (x, True)))
        closed = (let("closed_rate2", let("rate2_rest", g1 - 2 * g2) / late),
                  let("closed_rate3", let("rate3_rest", g2 - 3 * g3) / late))
        series = (_taylor_rate(k, x) for k in (2, 3))
        return tuple(let(f"rate{k}", sp.Piecewise((near, x < _LATE), (far_off, True)))
                     for k, near, far_off in zip((2, 3), series, closed, strict=True))

    def b_rate(self) -> sp.Expr:
        """2 b' = ((1 + cot² θ/2) / 4 - (2 - θ/2 cot θ/2) / θ²) / θ²."""
        let, x, cotangent = self.let, self.square, self.cotangent
        divisor = let("b_rate_divisor", beyond(x, x, _MIDDLE))
        across = let("b_rate_across",
                     (2 - let("b_rate_half", self.angle * cotangent / 2)) / divisor)
        rest = let("b_rate_rest", let("b_rate_square", (1 + cotangent**2) / 4) - across)
        return let("b_rate", beyond(x, let("closed_b_rate", rest / divisor), _bernoulli_rate(x)))


def _half_cotangent(let: Let, sine: sp.Expr, cosine: sp.Expr) -> sp.Expr:
    """cot θ/2 = sin θ / (1 - cos θ) = (1 + cos θ) / sin θ, whichever has no cancellation."""
    obtuse = cosine < 0
    above = let("above", sp.Piecewise((sine, obtuse), (1 + cosine, True)))
    below = let("below", sp.Piecewise((1 - cosine, obtuse), (sine, True)))
    return let("cotangent", above / below)


def far(x: sp.Expr, value: sp.Expr, near: sp.Expr) -> sp.Piecewise:
    """`near` where g(1) and g(2) are series, else `value`."""
    return sp.Piecewise((near, x < _NEAR), (value, True))


def beyond(x: sp.Expr, value: sp.Expr, near: sp.Expr) -> sp.Piecewise:
    """`near` where the other functions are series, else `value`."""
    return sp.Piecewise((near, x < _MIDDLE), (value, True))


def taylor(k: int, x: sp.Expr, terms: int = _TAYLOR_TERMS) -> sp.Expr:
    """The series of g(k, x)."""
    return alternating(lambda j: sp.Rational((-1)**j, sp.factorial(2 * j + k)), x, terms, _MIDDLE)


def _taylor_rate(k: int, x: sp.Expr) -> sp.Expr:
    """The series of 2 g'(k, x)."""
    return alternating(
        lambda j: 2 * (j + 1) * sp.Rational((-1)**(j + 1), sp.factorial(2 * j + 2 + k)), x,
        _TAYLOR_TERMS, _LATE)


def _bernoulli_rate(x: sp.Expr) -> sp.Expr:
    return _bernoulli_sum(lambda j: 2 * (j - 1), range(2, _BERNOULLI_TERMS + 3), x)


def _bernoulli(x: sp.Expr) -> sp.Expr:
    return _bernoulli_sum(lambda j: 1, range(1, _BERNOULLI_TERMS + 1), x)


def _bernoulli_sum(weight: Callable[[int], int], terms: range, x: sp.Expr) -> sp.Expr:
    """Σ w(j) β_j x^(j - first), β_j = |B_2j| / (2j)!: since β_(j+1) < β_j / 39, the truncated terms
    are less than a geometric series with the ratio of the first two."""
    coefficients = [weight(j) * abs(sp.bernoulli(2 * j)) / sp.factorial(2 * j) for j in terms]
    ratio = sp.Rational(weight(terms[-1] + 1), 39 * weight(terms[-1])) * _MIDDLE
    return horner(coefficients, x, coefficients[-1] * ratio / (1 - ratio))


def alternating(c: Callable[[int], sp.Rational], x: sp.Expr, terms: int,
                most: sp.Rational) -> sp.Expr:
    """Σ c(j) x^j for x from 0 to `most`, where signs alternate and sizes decrease: the truncation
    error is less than the first truncated term."""
    return horner(list(map(c, range(terms))), x, abs(c(terms)) * most)


def horner(coefficients: list[sp.Rational], x: sp.Expr, tail: sp.Rational) -> sp.Expr:
    """c0 + x (c1 + x (c2 + …)); truncated terms amount to a change of the last coefficient by at
    most `tail`."""
    *rest, final = coefficients
    total = sp.sign(final) * truncated(abs(final), tail)
    for coefficient in reversed(rest):
        total = coefficient + x * total
    return total
