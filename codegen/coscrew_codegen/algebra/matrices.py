"""Spatial algebra as SymPy matrices: the definitions from which every kernel is derived, and
against which it is tested.

Convention: the linear part is on top, in screws ``s = (v; ω)`` and in coscrews ``c = (f; τ)``, so
that power is ``f·v + τ·ω``. ``D = [R | t]`` is a displacement; ``x~ y = x × y``.

Knows nothing of operations, rounding or text."""

from collections.abc import Callable
from functools import cache

import sympy as sp
from sympy.polys.matrices import DomainMatrix
from sympy.polys.rings import PolyElement

I3 = sp.eye(3)
O3 = sp.zeros(3, 3)


def skew(x: sp.Matrix) -> sp.Matrix:
    """x~ with x~ y = x × y.  (3) -> (3,3)."""
    return sp.Matrix([[0, -x[2], x[1]], [x[2], 0, -x[0]], [-x[1], x[0], 0]])


def blocks(a: sp.Matrix, b: sp.Matrix, c: sp.Matrix, d: sp.Matrix) -> sp.Matrix:
    """[[a, b], [c, d]] as one explicit matrix."""
    return sp.Matrix.vstack(sp.Matrix.hstack(a, b), sp.Matrix.hstack(c, d))


def stack(lin: sp.Matrix, ang: sp.Matrix) -> sp.Matrix:
    """(lin; ang).  (3),(3) -> (6)."""
    return sp.Matrix.vstack(lin, ang)


def lin(x: sp.Matrix) -> sp.Matrix:
    """The linear part of a screw or coscrew.  (6) -> (3)."""
    return x[:3, :]


def ang(x: sp.Matrix) -> sp.Matrix:
    """The angular part of a screw or coscrew.  (6) -> (3)."""
    return x[3:, :]


def rotation(D: sp.Matrix) -> sp.Matrix:
    """R of D = [R | t].  (3,4) -> (3,3)."""
    return D[:, :3]


def translation(D: sp.Matrix) -> sp.Matrix:
    """t of D = [R | t].  (3,4) -> (3)."""
    return D[:, 3]


def displacement(R: sp.Matrix, t: sp.Matrix) -> sp.Matrix:
    """D = [R | t].  (3,3),(3) -> (3,4)."""
    return sp.Matrix.hstack(R, t)


def homogeneous(D: sp.Matrix) -> sp.Matrix:
    """[[R, t], [0, 1]] of D = [R | t].  (3,4) -> (4,4)."""
    return sp.Matrix.vstack(D, sp.Matrix([[0, 0, 0, 1]]))


def inverse(D: sp.Matrix) -> sp.Matrix:
    """D^-1 = [R^T | -R^T t].  (3,4) -> (3,4)."""
    R = rotation(D)
    return displacement(R.T, -R.T * translation(D))


def compose(D1: sp.Matrix, D2: sp.Matrix) -> sp.Matrix:
    """D1 D2 = [R1 R2 | R1 t2 + t1].  (3,4),(3,4) -> (3,4)."""
    R1 = rotation(D1)
    return displacement(R1 * rotation(D2), R1 * translation(D2) + translation(D1))


def Ad(D: sp.Matrix) -> sp.Matrix:
    """[Ad] = [[R, t~R], [0, R]], acting on screws.  (3,4) -> (6,6)."""
    R = rotation(D)
    return blocks(R, skew(translation(D)) * R, O3, R)


def CoAd(D: sp.Matrix) -> sp.Matrix:
    """[Ad]* = [Ad]^-T = [[R, 0], [t~R, R]], acting on coscrews.  (3,4) -> (6,6)."""
    R = rotation(D)
    return blocks(R, O3, skew(translation(D)) * R, R)


def turned(R: sp.Matrix) -> sp.Matrix:
    """The displacement [R | 0]."""
    return displacement(R, sp.zeros(3, 1))


def shifted(t: sp.Matrix) -> sp.Matrix:
    """The displacement [I | t]."""
    return displacement(I3, t)


def inverse_operator(operator: Callable[[sp.Matrix], sp.Matrix], D: sp.Matrix) -> sp.Matrix:
    """operator(D)^-1 = operator(R^T) operator(-t), since operator(D) = operator(t) operator(R).

    For [Ad] it is [[R^T, -R^T t~], [0, R^T]], for [Ad]* [[R^T, 0], [-R^T t~, R^T]]; the matrices
    printed in eq. (4) and `product_CoAdinvc` of the page Coscrews are not the inverses."""
    return operator(turned(rotation(D).T)) * operator(shifted(-translation(D)))


def rotation_about(axis: int, sine: sp.Expr, cosine: sp.Expr) -> sp.Matrix:
    """The rotation about x, y or z (axis 0, 1, 2) whose angle has this sine and cosine."""
    a = unit(axis)
    return I3 * cosine + skew(a) * sine + a * a.T * (1 - cosine)


def unit(axis: int) -> sp.Matrix:
    """e_x, e_y or e_z (axis 0, 1, 2)."""
    return I3[:, axis]


def left_derivative(operator: Callable[[sp.Matrix], sp.Matrix], s: sp.Matrix) -> sp.Matrix:
    """d/dτ operator(D(τ)) · operator(D)^-1 for the displacement D(τ) that moves with the screw s.

    D moves with s = (v; ω) when R' = ω~ R and t' = v + ω × t (v is the velocity of the body-fixed
    point now at the origin).  R is the rotation of a quaternion q, whose rate is q' = ½ (ω; 0) q.
    Every entry of operator(D) is then a polynomial N over n = |q|², and every entry of
    operator(D)^-1 a polynomial K over n.  (N' n - N n') K is divisible by n³, and D cancels.
    Here 1/n is a variable, so that all are polynomials: quotients' common divisors took five sixths
    of the time.
    """
    v, w = lin(s), ang(s)
    q = sp.symbols("q_x q_y q_z q_w")
    t = sp.Matrix(sp.symbols("t_0:3"))
    size, inverse_size = sum(x**2 for x in q), sp.Symbol("m")
    D = displacement(rotation_of_quaternion(q).xreplace({1 / size: inverse_size}), t)
    imaginary = sp.Matrix(q[:3])
    q_rate = [*((q[3] * w + w.cross(imaginary)) / 2), -w.dot(imaginary) / 2]
    t_rate = v + w.cross(t)

    ring = sp.QQ[(inverse_size, *q, *t, *s)]
    rates = [(ring.from_sympy(x), ring.from_sympy(y))
             for x, y in zip((*q, *t), (*q_rate, *t_rate), strict=True)]
    n = ring.from_sympy(size)

    def numerator(x: sp.Expr) -> PolyElement:
        terms = ring.from_sympy(x).terms()  # degree in 1/n: at most 2
        return sum((n**(2 - powers[0]) * ring.ring.term_new((0, *powers[1:]), factor)
                    for powers, factor in terms), ring.zero).exquo(n)

    def numerators(M: sp.Matrix) -> DomainMatrix:
        return DomainMatrix([[numerator(x) for x in row] for row in M.tolist()], M.shape, ring)

    def rate(x: PolyElement) -> PolyElement:
        return sum((x.diff(variable) * y for variable, y in rates), ring.zero)

    N = numerators(operator(D))
    product = (N.applyfunc(rate, ring) * n - N * rate(n)) * numerators(operator(inverse(D)))
    return product.applyfunc(lambda x: x.exquo(n**3), ring).to_Matrix()


def rotation_of_quaternion(q: tuple[sp.Symbol, ...]) -> sp.Matrix:
    """R = ((w² - u·u) I + 2 u u^T + 2 w u~) / |q|², orthonormal for every q = (u; w) ≠ 0."""
    u, w = sp.Matrix(q[:3]), q[3]
    R = (w**2 - u.dot(u)) * I3 + 2 * u * u.T + 2 * w * skew(u)
    return R / (w**2 + u.dot(u))


@cache
def _derivative_operator(operator: Callable[[sp.Matrix], sp.Matrix]) -> sp.ImmutableMatrix:
    return sp.ImmutableMatrix(left_derivative(operator, sp.Matrix(sp.symbols("s_0:6"))))


def ad(s: sp.Matrix) -> sp.Matrix:
    """[ad](s) = [Ad]' [Ad]^-1 = [[ω~, v~], [0, ω~]], derived.  (6) -> (6,6)."""
    return _of_screw(_derivative_operator(Ad), s)


def coad(s: sp.Matrix) -> sp.Matrix:
    """[ad]*(s) = [Ad]*' [Ad]*^-1 = [[ω~, 0], [v~, ω~]], derived.  (6) -> (6,6)."""
    return _of_screw(_derivative_operator(CoAd), s)


def _of_screw(matrix: sp.ImmutableMatrix, s: sp.Matrix) -> sp.Matrix:
    return sp.Matrix(matrix.subs(dict(zip(sp.symbols("s_0:6"), s, strict=True)), simultaneous=True))


def working_projector(joint: int) -> sp.Matrix:
    """h̄* of a primitive joint in its own frame: keeps component `joint` (0…5 = tx ty tz rx ry rz).

    Source: Coscrews, eq. (9)."""
    return sp.diag(*(int(i == joint) for i in range(6)))


def constraint_projector(joint: int) -> sp.Matrix:
    """H̄* of a primitive joint in its own frame: I - h̄*.  Source: Coscrews, eq. (7)."""
    return sp.eye(6) - working_projector(joint)
