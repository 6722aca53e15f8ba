"""Rotations as matrices, quaternions and rotation vectors: building blocks of operations."""

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from coscrew_codegen.algebra.matrices import skew
from coscrew_codegen.algebra.operations.formulas.half_angle import HalfAngle, known_angle
from coscrew_codegen.algebra.operations.formulas.norm import Let, nonzero, prefixed, safe_norm
from coscrew_codegen.algebra.operations.formulas.series import Angle, alternating, far, taylor

_NEAR = sp.Rational(1, 16)  # |v|²/w² up to which derivatives are those of series
_ARCTANGENT_TERMS = 18  # truncated terms, and their derivatives, are below 2^-60


def rodrigues(let: Let, v: sp.Matrix, alpha: sp.Expr, beta: sp.Expr,
              across: sp.Expr | None = None) -> sp.Matrix:
    """I + α v~ + β v~², with the symmetric part computed once.

    `across`, if given, is 1 - β v·v; then each diagonal entry is 1 - β (v_j² + v_k²) or across + β
    v_i², whichever adds or subtracts less."""
    x, y, z = let("beta_v", beta * v)
    xx, yy, zz, xy, xz, yz = let("m", sp.Matrix(
        [x * v[0], y * v[1], z * v[2], x * v[1], x * v[2], y * v[2]]))
    others = let("others", sp.Matrix([yy + zz, xx + zz, xx + yy]))
    x, y, z = (1 - other if across is None else
               let(f"diagonal{i}", sp.Piecewise((across + own, own < other), (1 - other, True)))
               for i, (own, other) in enumerate(zip((xx, yy, zz), others, strict=True)))
    symmetric = sp.Matrix([[x, xy, xz], [xy, y, yz], [xz, yz, z]])
    return symmetric + skew(let("alpha_v", alpha * v))


def quaternion(v: sp.Matrix, w: sp.Expr) -> sp.Matrix:
    """(v; w), the scalar last."""
    return sp.Matrix([*v, w])


def vector_part(q: sp.Matrix) -> sp.Matrix:
    """v of q = (v; w)."""
    return q[:3, :]


def scalar_part(q: sp.Matrix) -> sp.Expr:
    """w of q = (v; w)."""
    return q[3]


def quaternion_product(p: sp.Matrix, q: sp.Matrix) -> sp.Matrix:
    """(w1 v2 + w2 v1 + v1 × v2; w1 w2 - v1·v2)."""
    (v1, w1), (v2, w2) = ((vector_part(x), scalar_part(x)) for x in (p, q))
    return quaternion(w1 * v2 + w2 * v1 + v1.cross(v2), w1 * w2 - v1.dot(v2))


def conjugate(q: sp.Matrix) -> sp.Matrix:
    """(-v; w), the inverse of a quaternion of norm 1."""
    return quaternion(-vector_part(q), scalar_part(q))


def quaternion_of(let: Let, R: sp.Matrix) -> sp.Matrix:
    """A positive multiple of the quaternion of R: the column of 4 q q^T with a diagonal entry of at
    least 1, so that nothing cancels."""
    a, b, c = R[0, 0], R[1, 1], R[2, 2]
    p = let("p", sp.Matrix([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]))
    s = let("s", sp.Matrix([R[2, 1] + R[1, 2], R[0, 2] + R[2, 0], R[1, 0] + R[0, 1]]))
    first, less = let("first", sp.Matrix([1 + a, 1 - a])), let("others", sp.Matrix([b + c, b - c]))
    # 1 + a + b + c, 1 + a - b - c, …: paired, so that an entry of 1 or more has an error of 3 u.
    w, x, y, z = let("d", sp.Matrix([first[0] + less[0], first[0] - less[0],
                                     first[1] + less[1], first[1] - less[1]]))

    def choice(name: str, test: sp.Basic, first: Sequence[sp.Expr],
               second: Sequence[sp.Expr]) -> sp.Matrix:
        return let(name, sp.Matrix([sp.Piecewise((one, test), (other, True))
                                    for one, other in zip(first, second, strict=True)]))

    low = choice("low", b < a, (x, s[2], s[1], p[0]), (s[2], y, s[0], p[1]))
    opposite = a < -b
    high = choice("high", opposite, (s[1], s[0], z, p[2]), (p[0], p[1], p[2], w))
    return choice("column", c < 0, low, high)


def upper(let: Let, q: sp.Matrix) -> sp.Matrix:
    """q or -q, whichever has w >= 0.  If fine, products may be fused into sums, which therefore are
    not negated (accuracy/tiers/negation.py)."""
    w = scalar_part(q)
    result = q.applyfunc(lambda x: sp.Piecewise((-x, w < 0), (x, True)))
    return let("upper", quaternion(vector_part(result), sp.Abs(w)) if let.fine else result)


def half_angle(let: Let, q: sp.Matrix, reduced: bool = False) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """θ/2 = atan2(|v|, w), in [0, π/2]; |v|; and as a divisor |v|, or 1 if that is zero."""
    n = let("n", safe_norm(prefixed(let, "v"), vector_part(q), reduced))
    return let("half", sp.atan2(n, scalar_part(q))), n, let("divisor", nonzero(n))


@dataclass(frozen=True)
class SmoothAngle:
    """θ/2 = atan2(|v|, w) for derivatives; the length |v| has none at zero.  Where |v| is small
    against w, θ² and θ/2|v| are series in |v|²/w², and the other two members are meaningless."""

    square: sp.Expr  # θ²
    rate: sp.Expr  # θ / 2|v|
    half: sp.Expr  # θ/2
    n: sp.Expr  # |v|

    @classmethod
    def of(cls, let: Let, q: sp.Matrix) -> "SmoothAngle":
        """Makes it from any positive multiple of a unit quaternion with w >= 0."""
        v, w = vector_part(q), scalar_part(q)
        vv, ww = let("vv", v.dot(v)), let("ww", w**2)
        near = sp.Eq(let("near", sp.Piecewise((1, vv < _NEAR * ww), (0, True))), 1)

        def where_near(value: sp.Expr, other: int) -> sp.Piecewise:
            return sp.Piecewise((value, near), (sp.Integer(other), True))

        y = let("tangent_square", where_near(vv, 0) / let("near_ww", where_near(ww, 1)))
        series = let("arctangent", alternating(
            lambda j: sp.Rational((-1)**j, 2 * j + 1), y, _ARCTANGENT_TERMS, _NEAR))
        n = let("n", sp.sqrt(let("far_vv", sp.Piecewise((1, near), (vv, True)))))
        half = let("half", sp.atan2(n, w))
        near_rate = let("near_rate", series / let("near_w", where_near(w, 1)))
        far_rate = let("far_rate", half / let("divisor", nonzero(n)))
        return cls(let("square", sp.Piecewise((4 * y * series**2, near), (4 * half**2, True))),
                   let("rate", sp.Piecewise((near_rate, near), (far_rate, True))), half, n)


def rotation_vector(let: Let, q: sp.Matrix,
                    reduced: bool = False) -> tuple[sp.Matrix, Angle | HalfAngle]:
    """θ v / |v| and θ, of any positive multiple of a unit quaternion with w >= 0."""
    v, w = vector_part(q), scalar_part(q)
    if let.smooth:
        smooth = SmoothAngle.of(let, q)
        theta = let("theta", 2 * smooth.half)
        return (let("vector", 2 * smooth.rate * v),
                Angle.known(let, theta, smooth.n, w, smooth.square))
    half, n, divisor = half_angle(let, q, reduced)
    theta = let("theta", 2 * half)
    return let("vector", let("k", theta / divisor) * v), known_angle(let, theta, n, w)


def versor(let: Let, h: sp.Matrix) -> sp.Matrix:
    """exp (h; 0) = (h sin |h| / |h|; cos |h|)."""
    if let.fine:
        fine = HalfAngle.of_any(let, h)
        return quaternion(fine.k * h, fine.c)
    angle = Angle.of(let, h)
    x, far_k = angle.square, let("far_k", angle.sine / angle.angle)
    k = let("k", far(x, far_k, taylor(1, x)))
    near = let("near", 1 - x * let("g2", taylor(2, x)))
    return quaternion(k * h, far(x, angle.cosine, near))
