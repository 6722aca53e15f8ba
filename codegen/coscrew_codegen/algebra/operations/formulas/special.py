"""Functions for formulas that have no polynomial or simple closed form.

`codegen/coscrew_codegen/algebra/special_values.py` evaluates them to any number of digits.
"""

import sympy as sp


class g(sp.Function):
    """g(k, θ²) = Σ (-θ²)^j / (2j + k)!: cos θ, sin θ / θ, (1 - cos θ) / θ², (θ - sin θ) / θ³, …."""


class b(sp.Function):
    """b(θ²) = (1 - θ/2 cot θ/2) / θ²; singular at θ = 2π."""


class quaternion_of(sp.Function):
    """quaternion_of(i, R00, R01, …): component i of the quaternion, w >= 0, of the rotation nearest
    to R."""


class quaternion_log(sp.Function):
    """quaternion_log(i, x, y, z, w): component i of the rotation vector of q / |q|."""


class slerp(sp.Function):
    """slerp(i, p…, q…, k): component i of p (p* q)^k along the shorter arc."""


class interpolated(sp.Function):
    """interpolated(row, column, D1…, D2…, k): entry of D1 exp(k log(D1^-1 D2))."""


class factor(sp.Function):
    """factor(i, j, a00, a10, a11, …): entry of L, or of D if i = j, in A = L D L^T."""


class smallest_pivot(sp.Function):
    """smallest_pivot(a00, a10, a11, …): min d_i / a_ii."""


class solution(sp.Function):
    """solution(i, b0, b1, …, a00, a10, a11, …): component i of A^-1 b."""


class inverse(sp.Function):
    """inverse(i, j, R00, R01, …): entry of R^-1."""


class orthonormal_rows(sp.Function):
    """orthonormal_rows(i, j, R00, R01, …): entry of R after Gram–Schmidt on its rows, in order."""


class nearest_rotation(sp.Function):
    """nearest_rotation(i, j, A00, A01, …): entry of the rotation nearest to A."""


class largest(sp.Function):
    """largest(x, y, …): the largest absolute value."""


class jacobi(sp.Function):
    """jacobi(k, i, j, A…, V…): entry of A (k = 0) or V (k = 1) after one Jacobi rotation."""


def vector(function: type[sp.Function], size: int, *arguments: sp.Expr) -> sp.Matrix:
    """The components 0, 1, … of a function."""
    return sp.Matrix([function(i, *arguments) for i in range(size)])
