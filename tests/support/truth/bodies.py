"""Exact results of operations on spatial inertias and symmetric matrices.

Written from 6×6 operators and determinants; B = (m; h; xx, yy, zz, xy, xz, yz), and with moments
about the centre of mass, as in KSL, J = (m; m c; xx, yy, zz, xy, yz, zx).
"""

from collections.abc import Callable
from fractions import Fraction
from itertools import permutations
from math import prod

import numpy as np

Matrix = np.ndarray  # of objects

UPPER = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))


def skew(x: Matrix) -> Matrix:
    """x~ with x~ y = x × y."""
    return np.array([[0, -x[2], x[1]], [x[2], 0, -x[0]], [-x[1], x[0], 0]], dtype=object)


def second_moments(B: Matrix) -> Matrix:
    """I as a matrix."""
    I = np.zeros((3, 3), dtype=object)
    for (i, j), x in zip(UPPER, B[4:], strict=True):
        I[i, j] = I[j, i] = x
    return I


def operator(B: Matrix) -> Matrix:
    """[[m 1, -h~], [h~, I]]."""
    h = skew(B[1:4])
    return np.block([[B[0] * np.eye(3, dtype=int).astype(object), -h], [h, second_moments(B)]])


def ten_numbers(M: Matrix) -> Matrix:
    """B from its operator."""
    return np.array([M[0, 0], M[5, 1], M[3, 2], M[4, 0], *(M[3 + i, 3 + j] for i, j in UPPER)],
                    dtype=object)


def transformed(D: Matrix, B: Matrix) -> Matrix:
    """[Ad]* M [Ad]^-1 of its operator M."""
    return ten_numbers(transformed_operator(D, operator(B)))


def transformed_operator(D: Matrix, M: Matrix) -> Matrix:
    """[Ad]* M [Ad]^-1 with [Ad]* = [[R, 0], [t~ R, R]] and [Ad]^-1 = [Ad]*^T, of M's lower
    triangle."""
    R, zero = D[:, :3], np.zeros((3, 3), dtype=object)
    A = np.block([[R, zero], [skew(D[:, 3]) @ R, R]])
    return A @ (np.tril(M) + np.tril(M, -1).T) @ A.T


def net_wrench(B: Matrix, w: Matrix, ds: Matrix) -> Matrix:
    """M ds + [ad]*(s) M s for s = (0; w), [ad]*(s) = [[w~, 0], [0, w~]]."""
    M, zero = operator(B), np.zeros((3, 3), dtype=object)
    momentum = M @ np.concatenate([zero[0], w])
    return M @ ds + np.block([[skew(w), zero], [zero, skew(w)]]) @ momentum


def from_com(m: Fraction, com: Matrix, Ic: Matrix) -> Matrix:
    """Ic about the centre of mass, moved by com."""
    at_com = np.array([m, 0, 0, 0, *(Ic[i, j] for i, j in UPPER)], dtype=object)
    return transformed(_moved(com), at_com)


def determinant(A: Matrix) -> Fraction:
    """By permutations."""
    def sign(p: tuple[int, ...]) -> int:
        return prod(1 if p[i] < p[j] else -1 for j in range(len(p)) for i in range(j))

    return sum((sign(p) * prod((A[i, j] for i, j in enumerate(p)), start=Fraction(1))
                for p in permutations(range(len(A)))), start=Fraction(0))


def pivots(A: Matrix) -> list[Fraction]:
    """d_i, the quotients of successive leading minors."""
    minors = [determinant(A[:k, :k]) for k in range(len(A) + 1)]
    return [after / before for before, after in zip(minors, minors[1:], strict=False)]


def pseudo_inertia(B: Matrix) -> Matrix:
    """[[m, h^T], [h, tr(I)/2 1 - I]]."""
    I = second_moments(B)
    sigma = np.eye(3, dtype=int).astype(object) * ((I[0, 0] + I[1, 1] + I[2, 2]) / 2) - I
    return np.block([[np.array([[B[0]]], dtype=object), B[None, 1:4]], [B[1:4, None], sigma]])


def steiner(d: Matrix) -> Matrix:
    """-d~ d~ = d·d 1 - d d^T, the moments of a unit mass at d."""
    return -skew(d) @ skew(d)


def moments(J: Matrix) -> Matrix:
    """Ixx, Iyy, Izz, Ixy, Iyz, Izx of KSL's ten numbers, as a matrix."""
    xx, yy, zz, xy, yz, zx = J[4:]
    return np.array([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]], dtype=object)


def inertia(m: Fraction, mt: Matrix, I: Matrix) -> Matrix:
    """KSL's ten numbers."""
    return np.array([m, *mt, I[0, 0], I[1, 1], I[2, 2], I[0, 1], I[1, 2], I[2, 0]], dtype=object)


def spatial(J: Matrix) -> Matrix:
    """B from KSL's ten numbers."""
    return from_com(J[0], J[1:4] / J[0], moments(J))


def centroidal(B: Matrix) -> Matrix:
    """KSL's ten numbers from B: moments about the centre of mass."""
    c = B[1:4] / B[0]
    at_com = transformed(_moved(-c), B)
    return inertia(B[0], B[1:4], second_moments(at_com))


def _moved(t: Matrix) -> Matrix:
    return np.hstack([np.eye(3, dtype=int), t[:, None]]).astype(object)


def _turned(R: Matrix) -> Matrix:
    return np.hstack([R, np.zeros((3, 1), dtype=object)])


def transformed_inertia(J: Matrix, D: Matrix) -> Matrix:
    """B transformed by D, through its operator."""
    return centroidal(transformed(D, spatial(J)))


def merged(Ji: Matrix, t_ic: Matrix, Jj: Matrix, t_jc: Matrix, D: Matrix) -> Matrix:
    """Steiner's theorem for each body, about the common centre of mass x."""
    R, t, mi, mj = D[:, :3], D[:, 3], Ji[0], Jj[0]
    c = R @ t_jc + t
    x = (mi * t_ic + mj * c) / (mi + mj)
    I = moments(Ji) + mi * steiner(t_ic - x) + R @ moments(Jj) @ R.T + mj * steiner(c - x)
    return inertia(mi + mj, Ji[1:4] + mj * c, I)


BODIES: dict[str, Callable[..., Matrix | Fraction]] = {
    "spatial_inertia_copy": lambda B: B, "spatial_inertia_scale": lambda B, a: a * B,
    "add_BB": lambda B1, B2: B1 + B2, "subtract_BB": lambda B1, B2: B1 - B2,
    "spatial_inertia_from_com": from_com,
    "spatial_inertia_com": lambda B: B[1:4] / B[0],
    "spatial_inertia_about_com": lambda B: second_moments(B) + skew(B[1:4]) @ skew(B[1:4]) / B[0],
    "spatial_inertia_matrix": operator,
    "product_Bs": lambda B, s: operator(B) @ s,
    "spatial_inertia_net_wrench": net_wrench,
    "acceleration_tensor": lambda w, dw: skew(dw) + skew(w) @ skew(w),
    "mat6x6_rotated": lambda R, M: transformed_operator(_turned(R), M),
    "mat6x6_shifted": lambda t, M: transformed_operator(_moved(t), M),
    "spatial_inertia_energy": lambda B, s: s @ operator(B) @ s / 2,
    "spatial_inertia_shifted": lambda t, B: transformed(_moved(t), B),
    "spatial_inertia_transformed": transformed,
    "spatial_inertia_from_inertia": spatial, "inertia_from_spatial_inertia": centroidal,
    "inertia": lambda m, t, *I: np.array([m, *(m * t), *I], dtype=object),
    "inertia_copy": lambda J: J, "inertia_merge": merged,
    **dict.fromkeys(("inertia_rotated", "inertia_rotate"),
                    lambda J, R: transformed_inertia(J, _turned(R))),
    **dict.fromkeys(("inertia_translated", "inertia_translate"),
                    lambda J, t: transformed_inertia(J, _moved(t))),
    **dict.fromkeys(("inertia_transformed", "inertia_transform"), transformed_inertia),
}
"""Name → formula, for inertias physical or not."""

POSITIVE_DEFINITE = ("spatial_inertia_consistency", *(
    f"{kind}_{what}" for kind in ("mat3x3", "mat6x6") for what in ("ldl", "ldl_solve", "solve")))
"""Operations that are tested by laws: they are meaningful for positive definite matrices only."""
