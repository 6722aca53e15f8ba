"""The rotation nearest to a 3×3 matrix, and the distance of a matrix from a rotation."""

import sympy as sp

from coscrew_codegen.algebra.matrices import I3
from coscrew_codegen.algebra.operations.formulas import special
from coscrew_codegen.algebra.operations.formulas.norm import (
    Let,
    divided,
    l2,
    largest_size,
    moderate,
    nonzero,
    prefixed,
)
from coscrew_codegen.algebra.operations.operation import DEPENDENT, Operation
from coscrew_codegen.program.values.quantity import ANY, MAT3X3, NONZERO_MATRIX, SCALAR, Argument

_A, _Ro = Argument("A", MAT3X3, NONZERO_MATRIX), Argument("Ro", MAT3X3)
_R, _defect = Argument("R", MAT3X3, ANY), Argument("defect", SCALAR)

_SWEEPS = 5  # after four some columns are 1e-12 from perpendicular, after five none beyond rounding
_LEAST = sp.Rational(1, 4)  # |part of a column perpendicular to another|² / |column|², to be used
_NEGLIGIBLE = DEPENDENT / 8  # |column| / |longest column|, below which any direction will do
_ROOTS = 36  # Newton steps towards the largest root: from 1.75 |A|, which is above it, downwards
NEAREST = 16
"""In u: the largest difference of |R - nearest|_F, times (s2 ± s3) / s1, from 0; measured."""
BESIDE = 6
"""In u: the largest |R^T R - I|_ij of a nearest rotation R; measured."""


def _upper_triangle(S: sp.Matrix) -> list[sp.Expr]:
    return [S[i, j] for i in range(3) for j in range(i, 3)]


def _defects(R: sp.Matrix) -> list[sp.Expr]:
    """det R - 1, which is NaN if any entry is, and the different entries of R^T R - I."""
    return [R.det() - 1, *_upper_triangle(R.T * R - I3)]


def _largest_defect(let: Let, R: sp.Matrix) -> sp.Expr:
    det = let("det", R[:, 0].dot(let("n", R[:, 1].cross(R[:, 2]))))
    products = let("g", sp.Matrix(_upper_triangle(R.T * R)))
    ones = sp.Matrix(_upper_triangle(I3))
    return largest_size(let, "defect", let("off", sp.Matrix([det - 1, *(products - ones)])))


def _jacobi(let: Let, a: sp.Matrix, b: sp.Matrix, c: sp.Matrix,
            d: sp.Matrix) -> tuple[sp.Matrix, sp.Matrix, sp.Matrix, sp.Matrix]:
    """a and b, turned into each other such that they are perpendicular and a is not the shorter;
    c and d turned likewise.

    With e = (b·b - a·a) / 2 and g = a·b, the tangent of the smaller angle is
    t = g / (e ± sqrt(e² + g²)), from whichever of g / e and e / g is at most 1: nothing is squared
    that may overflow.  A turn by the other angle, 90° less, exchanges the columns."""
    aa, bb, g = (let(name, x.dot(y)) for name, x, y in (("aa", a, a), ("bb", b, b), ("g", a, b)))
    e = let("e", let("apart", bb - aa) / 2)
    less = let("size_g", sp.Abs(g)) < let("size_e", sp.Abs(e))
    above = let("above", sp.Piecewise((g, less), (e, True)))
    below = let("below", sp.Piecewise((e, less), (g, True)))
    ratio = let("ratio", above / let("divisor", nonzero(below)))
    root = let("root", sp.sqrt(1 + ratio**2))
    signed = let("signed", sp.Piecewise((-root, ratio < 0), (root, True)))
    top = let("top", sp.Piecewise((ratio, less), (1, True)))
    t = let("t", top / let("bottom", sp.Piecewise((1 + root, less), (ratio + signed, True))))
    t = let("tangent", sp.Piecewise((0, sp.Eq(g, 0)), (t, True)))
    cosine = let("cosine", 1 / let("secant", sp.sqrt(1 + t**2)))
    sine = let("sine", t * cosine)
    shorter = aa < bb
    p = let("p", sp.Piecewise((sine, shorter), (cosine, True)))
    q = let("q", sp.Piecewise((-cosine, shorter), (sine, True)))
    return (let("a", p * a - q * b), let("b", q * a + p * b),
            let("c", p * c - q * d), let("d", q * c + p * d))


def _axis_across(let: Let, u: sp.Matrix) -> sp.Matrix:
    """The coordinate axis with the smallest component of u."""
    x, y, z = let("size", u.applyfunc(sp.Abs))
    first = sp.Eq(let("is_y", sp.Piecewise((1, y < x), (0, True))), 0)
    less = let("less", sp.Piecewise((x, first), (y, True)))
    last = sp.Eq(let("is_z", sp.Piecewise((1, z < less), (0, True))), 1)
    xy = let("xy", sp.Matrix([sp.Piecewise((1, first), (0, True)),
                              sp.Piecewise((0, first), (1, True))]))
    return let("axis", sp.Matrix([sp.Piecewise((0, last), (xy[0], True)),
                                  sp.Piecewise((0, last), (xy[1], True)),
                                  sp.Piecewise((1, last), (0, True))]))


def _across(let: Let, u: sp.Matrix, column: sp.Matrix, least: sp.Expr) -> sp.Matrix:
    """The direction of the column's part perpendicular to the unit vector u; of a coordinate
    axis's, if that part is nearly all rounding errors, or |part|² <= least."""
    part = let("part", column - let("along", u.dot(column)) * u)
    whole, kept = let("whole", column.dot(column)), let("kept", part.dot(part))
    enough = let("enough", sp.Piecewise((least, _LEAST * whole < least), (_LEAST * whole, True)))
    is_kept = sp.Eq(let("is_kept", sp.Piecewise((1, enough < kept), (0, True))), 1)
    axis = _axis_across(let, u)
    other = let("other", axis - let("along_axis", u.dot(axis)) * u)
    result = let("found", sp.Matrix([sp.Piecewise((one, is_kept), (two, True))
                                     for one, two in zip(part, other, strict=True)]))
    return let("across", divided(result, let("length", l2(result))))


def _newton(let: Let, R: sp.Matrix) -> sp.Matrix:
    """R (3 I - R^T R) / 2, nearer to orthonormal."""
    products = let("gram", sp.Matrix(_upper_triangle(R.T * R)))
    xx, xy, xz, yy, yz, zz = products
    half = let("half", sp.Matrix([[3 - xx, -xy, -xz], [-xy, 3 - yy, -yz], [-xz, -yz, 3 - zz]]) / 2)
    return R * half


def _nearest(let: Let, A: sp.Matrix) -> sp.Matrix:
    """U V^T, where A V has perpendicular columns, the longest first (one-sided Jacobi). U has the
    directions of the first two, and their cross product, so it is a rotation for either sign of det
    A and any smallest singular value."""
    if let.smooth:
        return _by_root(let, A)
    scaled_A, V = moderate(let, "s", A), sp.eye(3)
    columns, axes = [scaled_A[:, j] for j in range(3)], [V[:, j] for j in range(3)]
    for sweep in range(_SWEEPS):
        for i, j in ((0, 1), (0, 2), (1, 2)):
            named = prefixed(let, f"turn{sweep}{i}{j}")
            columns[i], columns[j], axes[i], axes[j] = _jacobi(
                named, columns[i], columns[j], axes[i], axes[j])
    longest = let("longest", l2(columns[0]))
    first = let("u0", divided(columns[0], let("first_divisor", nonzero(longest))))
    second = _across(prefixed(let, "second"), first, columns[1],
                     let("least", (_NEGLIGIBLE * longest)**2))
    third = let("u2", first.cross(second))
    R = let("turned", sp.Matrix(3, 3, lambda i, j: first[i] * axes[0][j] + second[i] * axes[1][j]
                                + third[i] * axes[2][j]))
    return _newton(let, R).applyfunc(
        lambda x: sp.Piecewise((sp.nan, sp.Eq(longest, 0)), (x, True)))


def _by_root(let: Let, A: sp.Matrix) -> sp.Matrix:
    """((κ + |B|²) B + λ adj B^T - B B^T B) / (κ λ - det B) of B = A / |A|, with κ = (λ² - |B|²) / 2
    and λ = s1 + s2 ± s3, the largest root of (λ² - |B|²)² - 8 λ det B - 4 |adj B|²: smooth
    wherever the nearest rotation is.

    Source: F. L. Markley, J. Astronaut. Sci. 41 (1993) 261."""
    scaled_A = moderate(let, "s", A)
    B = let("B", divided(scaled_A, let("length", l2(sp.Matrix(list(scaled_A))))))
    cofactors = let("cofactor", sp.Matrix.hstack(*(
        B[:, (j + 1) % 3].cross(B[:, (j + 2) % 3]) for j in range(3))))
    det = let("det", B[:, 0].dot(cofactors[:, 0]))
    area = let("area", sum(x**2 for x in cofactors))
    root = sp.Rational(7, 4)
    for n in range(_ROOTS):
        named = prefixed(let, f"root{n}")
        square = named("square", sp.sympify(root)**2) if n else root**2
        off = named("off", square - 1)
        value = named("value", off**2 - 8 * det * root - 4 * area)
        root = named("next", root - value / named("slope", 4 * root * off - 8 * det))
    kappa = let("kappa", (root**2 - 1) / 2)
    gram = let("gram", B.T * B)
    cubed = let("cubed", B * gram)
    total = let("total", (kappa + 1) * B + root * cofactors - cubed)
    return total / let("zeta", kappa * root - det)


OPERATIONS = (
    Operation("mat3x3", "mat3x3_rotation_defect", "the largest of |det R - 1| and |R^T R - I|_ij: "
              "0 for a rotation, 2 for a reflection, NaN if an entry is NaN", (_R,), (_defect,),
              lambda R: special.largest(*_defects(R)), _largest_defect,
              rounding="Error <= 6 u near a rotation; measured, not proved."),
    Operation("mat3x3", "mat3x3_nearest_rotation", "Ro = the rotation nearest to A, U diag(1, 1, "
              "±1) V^T of A = U diag(s1, s2, s3) V^T: no rotation R has a larger tr R^T A or a "
              "smaller |R - A|.  For every finite A but 0, for which it is NaN; where several are "
              "equally near (s2 ± s3 = 0: reflections with s2 = s3, matrices of rank 1) one of "
              "them", (_A,), (_Ro,),
              lambda A: sp.Matrix(3, 3, lambda i, j: special.nearest_rotation(i, j, *A)),
              _nearest,
              rounding=f"|Ro - nearest|_F <= {NEAREST} u s1 / (s2 ± s3), + if det A > 0, and "
              f"|Ro^T Ro - I|_ij <= {BESIDE} u; measured, not proved."),
)
