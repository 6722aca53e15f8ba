"""Screws, coscrews and their operators as plain matrices of exact numbers.

Written from the papers' matrices, independently of the generator; works on arrays of Fractions, of
mpmath numbers or of SymPy symbols.  D = [R | t]; linear parts on top: s = (v; ω), c = (f; τ).
"""

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import partial
from itertools import permutations
from math import prod
from random import Random
from types import FunctionType, ModuleType
from typing import TypeAlias

import mpmath
import numpy as np

from coscrew_codegen.algebra.operations import OPERATIONS
from tests.support.truth.bodies import BODIES
from tests.support.truth.motions import TRUTHS

Matrix = np.ndarray  # of objects
Result: TypeAlias = Matrix | Fraction | tuple[Matrix | Fraction, ...]
TABLE = {op.name: op for op in OPERATIONS}
JOINTS = ("tx", "ty", "tz", "rx", "ry", "rz")


def array(entries: Sequence[object]) -> Matrix:
    """A vector or matrix of these entries, as they are."""
    return np.array(entries, dtype=object)


def zeros(*shape: int) -> Matrix:
    return np.full(shape, Fraction(0), dtype=object)


def eye(n: int) -> Matrix:
    return array([[Fraction(int(i == j)) for j in range(n)] for i in range(n)])


def skew(x: Matrix) -> Matrix:
    """x~ with x~ y = x × y."""
    return array([[0, -x[2], x[1]], [x[2], 0, -x[0]], [-x[1], x[0], 0]])


def R_t(D: Matrix) -> tuple[Matrix, Matrix]:
    return D[:, :3], D[:, 3]


def displacement(R: Matrix, t: Matrix) -> Matrix:
    return np.hstack([R, t[:, None]])


def homogeneous(D: Matrix) -> Matrix:
    """[[R, t], [0, 1]]."""
    return np.vstack([D, eye(4)[3:]])


def compose(*displacements: Matrix) -> Matrix:
    """D1 D2 …, as homogeneous matrices."""
    product = eye(4)
    for D in displacements:
        product = product @ homogeneous(D)
    return product[:3]


def inverse(D: Matrix) -> Matrix:
    """[R^T | -R^T t]."""
    R, t = R_t(D)
    return displacement(R.T, -(R.T @ t))


def Ad(D: Matrix) -> Matrix:
    """[[R, t~R], [0, R]]."""
    R, t = R_t(D)
    return np.block([[R, skew(t) @ R], [zeros(3, 3), R]])


def CoAd(D: Matrix) -> Matrix:
    """[[R, 0], [t~R, R]]."""
    R, t = R_t(D)
    return np.block([[R, zeros(3, 3)], [skew(t) @ R, R]])


def Ad_inverse(D: Matrix) -> Matrix:
    """[[R^T, -R^T t~], [0, R^T]]."""
    R, t = R_t(D)
    return np.block([[R.T, -(R.T @ skew(t))], [zeros(3, 3), R.T]])


def CoAd_inverse(D: Matrix) -> Matrix:
    """[[R^T, 0], [-R^T t~, R^T]]."""
    R, t = R_t(D)
    return np.block([[R.T, zeros(3, 3)], [-(R.T @ skew(t)), R.T]])


def ad(s: Matrix) -> Matrix:
    """[[ω~, v~], [0, ω~]]."""
    return np.block([[skew(s[3:]), skew(s[:3])], [zeros(3, 3), skew(s[3:])]])


def coad(s: Matrix) -> Matrix:
    """[[ω~, 0], [v~, ω~]]."""
    return np.block([[skew(s[3:]), zeros(3, 3)], [skew(s[:3]), skew(s[3:])]])


def turn(axis: int, sine_cosine: Matrix) -> Matrix:
    """The right-handed rotation about x, y or z."""
    sine, cosine = sine_cosine
    y, z = (axis + 1) % 3, (axis + 2) % 3
    R = eye(3)
    R[y, y] = R[z, z] = cosine
    R[z, y], R[y, z] = sine, -sine
    return R


def keeping(joint: int) -> Matrix:
    """The diagonal matrix that keeps component `joint` and clears the others."""
    return eye(6) * eye(6)[joint]


def product(p: Matrix, q: Matrix) -> Matrix:
    """The product of the quaternions x i + y j + z k + w, by i² = j² = k² = i j k = -1."""
    x, y, z, w = q
    return array([[w, z, -y, x], [-z, w, x, y], [y, -x, w, z], [-x, -y, -z, w]]) @ p


def conjugate(q: Matrix) -> Matrix:
    """(-v; w)."""
    return array([*-q[:3], q[3]])


def rotation_of(q: Matrix) -> Matrix:
    """((w² - v·v) I + 2 v v^T + 2 w v~) / q·q."""
    v, w = q[:3], q[3]
    return ((w * w - v @ v) * I3 + 2 * np.outer(v, v) + 2 * w * skew(v)) / (q @ q)


def orthonormalized(R: Matrix) -> Matrix:
    """R (3 I - R^T R) / 2."""
    return R @ (3 * I3 - R.T @ R) / 2


def determinant(R: Matrix) -> Fraction:
    """By permutations."""
    def sign(p: tuple[int, ...]) -> int:
        return prod(1 if p[i] < p[j] else -1 for i in range(3) for j in range(i + 1, 3))
    return sum(sign(p) * R[0, p[0]] * R[1, p[1]] * R[2, p[2]] for p in permutations(range(3)))


def joined(*parts: Matrix | list[int]) -> Matrix:
    return np.concatenate(parts)


def multiprecise(m: Matrix) -> Matrix:
    """The Fractions as numbers of mpmath's precision."""
    return np.vectorize(mpmath.mpmathify, otypes=[object])(m)


def moved(D: Matrix, s: Matrix, time: mpmath.mpf) -> Matrix:
    """D after moving with the screw s: exp(time [[ω~, v], [0, 0]]) D, in mpmath's precision."""
    rate = multiprecise(np.vstack([displacement(skew(s[3:]), s[:3]), zeros(1, 4)]))
    motion = mpmath.expm(mpmath.matrix((rate * time).tolist()))
    return (array(motion.tolist()) @ multiprecise(homogeneous(D)))[:3]


# Exact results that are one line of matrix algebra: name → function of the inputs.

I3, O3 = eye(3), zeros(3)

FORMULAS: dict[str, Callable[..., Result]] = {
    "vec3_scaled": lambda v, k: k * v,
    "vec3_swap": lambda v1, v2: (v2, v1),
    "dot_vv": lambda v1, v2: v1 @ v2,
    "cross_vv": lambda v1, v2: skew(v1) @ v2,
    "mat3x3_copy": lambda R: R,
    "mat3x3_setIdentity": lambda R: I3,
    "mat3x3_setFromVectors": lambda x, y, z: array([x, y, z]).T,
    "mat3x3_transpose": lambda R: R.T,
    "mat3x3_transposed": lambda R: R.T,
    "mat3x3_determinant": determinant,
    "skew": skew,
    "SE3_fromRt": displacement,
    "SE3_copy": lambda D: D,
    "SE3_setIdentity": lambda D: displacement(I3, O3),
    "SE3_getTranslation": lambda D: R_t(D)[1],
    "SE3_getRotation": lambda D: R_t(D)[0],
    "SE3_invert": inverse,
    "SE3_inverted": inverse,
    "mat6x6_copy": lambda M: M,
    "mat6x6_setIdentity": lambda M: eye(6),
    "mat6x6_transposed": lambda M: M.T,
    "product_drv": lambda R, v: R @ v,
    "product_drinvv": lambda R, v: R.T @ v,
    "product_dv": lambda D, v: (homogeneous(D) @ joined(v, [1]))[:3],
    "product_dinvv": lambda D, v: (homogeneous(inverse(D)) @ joined(v, [1]))[:3],
    "product_drdr": lambda R1, R2: R1 @ R2,
    "product_drinvdr": lambda R1, R2: R1.T @ R2,
    "product_dd": compose,
    "product_dinvd": lambda D1, D2: compose(inverse(D1), D2),
    "product_ddr": lambda D, R: compose(D, displacement(R, O3)),
    "product_ddt": lambda D, t: compose(D, displacement(I3, t)),
    "product_dinvdt": lambda D, t: compose(inverse(D), displacement(I3, t)),
    "Ad": Ad, "CoAd": CoAd, "ad": ad, "coad": coad,
    "dot_cs": lambda c, s: c @ s,
    "cross_ss": lambda s1, s2: ad(s1) @ s2,
    "cross_sc": lambda s, c: coad(s) @ c,
    "cross_sst": lambda s1, s2: joined(skew(s1[3:]) @ s2[:3], O3),
    "cross_sca": lambda s, c: joined(O3, skew(s[3:]) @ c[3:]),
    "hsra": lambda D, axis: Ad(D) @ joined(O3, axis),
    "hsta": lambda D, axis: Ad(D) @ joined(axis, O3),
    "reciprocal_product": lambda c, x: c @ joined(x[3:], x[:3]),
    "quaternion_copy": lambda q: q,
    "quaternion_scale": lambda q, a: a * q,
    "quaternion_setIdentity": lambda q: eye(4)[3],
    "quaternion_conjugated": conjugate,
    "quaternion_product_qq": product,
    "quaternion_product_qconjq": lambda q1, q2: product(conjugate(q1), q2),
    "quaternion_product_qqconj": lambda q1, q2: product(q1, conjugate(q2)),
    "quaternion_product_qconjqconj": lambda q1, q2: conjugate(product(q2, q1)),
    "quaternion_product_qv": lambda q, v: product(q, joined(v, [0])),
    "quaternion_product_qconjv": lambda q, v: product(conjugate(q), joined(v, [0])),
    "quaternion_product_vq": lambda v, q: product(joined(v, [0]), q),
    "quaternion_product_vqconj": lambda v, q: product(joined(v, [0]), conjugate(q)),
    "dot_qq": lambda q1, q2: q1 @ q2,
    "axpy_qq": lambda a, x, y: a * x + y,
    "add_dpiToq": lambda dpi, q: q + product(q, joined(dpi, [0])) / 2,
    "subtract_dpiFromq": lambda dpi, q: q - product(q, joined(dpi, [0])) / 2,
    "omega_to_dquaternion": lambda w, q: product(joined(w, [0]), q) / 2 + (1 - q @ q) * q,
    "rotate_qv": lambda q, v: rotation_of(q) @ v,
    "rotate_qconjv": lambda q, v: rotation_of(q).T @ v,
    "mat3x3_from_quaternion": rotation_of,
    "mat3x3_orthonormalize": orthonormalized,
    "mat3x3_orthonormalized": orthonormalized,
    "mat3x3_setFromAxisDC": lambda a, dc: (
        dc[1] * I3 + dc[0] * skew(a) + (1 - dc[1]) * np.outer(a, a)),
    "mat3x3_inverse": lambda R: (determinant(R), R.T),
    "mat3x3_rotation_defect": lambda R: max(abs(determinant(R) - 1), *np.ravel(abs(R.T @ R - I3))),
    "vec4_copy": lambda v: v,
    "vec4_scale": lambda v, a: a * v,
    "vec4_scaled": lambda v, k: k * v,
    "vec4_swap": lambda v1, v2: (v2, v1),
    "vec4_invert": lambda v: -v,
    "vec4_inverted": lambda v: -v,
    "mat4x4_setIdentity": lambda M: eye(4),
    "mat4x4_fromSE3": homogeneous,
    "mat4x4_fromRt": lambda R, t: homogeneous(displacement(R, t)),
    "mat4x4_toSE3": lambda M: M[:3],
    "mat4x4_getTranslation": lambda M: M[:3, 3],
    "SE3_toMat4x4": homogeneous,
}

# Operations with irrational results, or that round rationals.
IRRATIONAL = (
    "sincos", "sin", "cos", "exp", "tanh", "atan2",
    "vec3_l2norm", "vec3_normalize", "vec3_normalized", "screw_norm", "screw_normalize",
    "screw_normalized", "coscrew_norm", "coscrew_normalize", "coscrew_normalized", "dc",
    "product_ainvv", "angle_vv", "vec4_l2norm", "vec4_normalize", "vec4_normalized",
    "mat3x3_normalize", "mat3x3_normalized", "mat3x3_jacobi", "mat3x3_from_euler_xyz",
    "mat3x3_from_euler_xyx", "euler_xyz_from_mat3x3", "euler_xyx_from_mat3x3", "quaternion_norm",
    "quaternion_normalize", "quaternion_normalized", "quaternion_unit_defect",
    "quaternion_nearest_unit", "mat3x3_nearest_rotation",
    *(name for name in TRUTHS if name not in FORMULAS))


def _of_axis(i: int) -> dict[str, Callable[..., Matrix]]:
    x, e = "xyz"[i], I3[i]
    return {
        f"add_vv{x}": lambda v, k: v + k * e,
        f"product_drvt{x}": lambda R, k: R @ (k * e),
        f"product_drdr{x}": lambda R, dc: R @ turn(i, dc),
        f"product_ddr{x}": lambda D, dc: compose(D, displacement(turn(i, dc), O3)),
        f"product_ddt{x}": lambda D, k: compose(D, displacement(I3, k * e)),
    }


def _of_turn(i: int) -> dict[str, Callable[..., Matrix]]:
    """Products with the turn whose half angle has this sine and cosine."""
    def turned(dc: Matrix) -> Matrix:
        return joined(I3[i] * dc[0], [dc[1]])

    both, x = (("", lambda q: q), ("conj", conjugate)), "xyz"[i]
    return {name: formula for a, of_a in both for b, of_b in both for name, formula in (
        (f"quaternion_product_q{x}{a}q{b}",
         lambda dc, q, of_a=of_a, of_b=of_b: product(of_a(turned(dc)), of_b(q))),
        (f"quaternion_product_q{a}q{x}{b}",
         lambda q, dc, of_a=of_a, of_b=of_b: product(of_a(q), of_b(turned(dc)))))}


def _of_kind(kind: str, x: str) -> dict[str, Callable[..., Matrix]]:
    return {
        f"{kind}_copy": lambda x: x, f"{kind}_scale": lambda x, a: a * x,
        f"{kind}_inverted": lambda x: -x, f"{kind}_invert": lambda x: -x,
        f"axpy_{x}{x}": lambda a, x, y: a * x + y, f"xpy_{x}{x}": lambda x, y: x + y,
        f"nxpy_{x}{x}": lambda x, y: y - x, f"product_a{x}": lambda a, x: a * x,
        f"add_{x}{x}": lambda x, y: x + y, f"subtract_{x}{x}": lambda x, y: x - y,
    }


def _of_space(kind: str, x: str, name: str, matrix: Callable[[Matrix], Matrix],
              matrix_inverse: Callable[[Matrix], Matrix]) -> dict[str, Callable[..., Matrix]]:
    groups = {"t": lambda t: displacement(I3, t), "r": lambda R: displacement(R, O3),
              "": lambda D: D}
    return {
        f"{kind}_from_lin_ang": joined,
        f"{kind}_to_angular_first": lambda x: joined(x[3:], x[:3]),
        f"{kind}_from_angular_first": lambda x: joined(x[3:], x[:3]),
        f"add_{x}{x}t": lambda x, y: joined(x[:3] + y[:3], x[3:]),
        **{f"h{x}{joint}": lambda D, i=i: matrix(D)[:, i] for i, joint in enumerate(JOINTS)},
        **{f"product_{name}{g}{x}": lambda a, x, to=to: matrix(to(a)) @ x
           for g, to in groups.items()},
        **{f"product_{name}{g}inv{x}": lambda a, x, to=to: matrix_inverse(to(a)) @ x
           for g, to in groups.items()},
    }


def _of_joint(i: int) -> dict[str, Callable[..., Matrix]]:
    return {f"working_c{JOINTS[i]}": lambda D, c: CoAd(D) @ keeping(i) @ c,
            f"constraint_c{JOINTS[i]}": lambda D, c: CoAd(D) @ (eye(6) - keeping(i)) @ c}


for _formulas in (*map(_of_axis, range(3)), *map(_of_turn, range(3)), *map(_of_joint, range(6)),
                  _of_kind("vec3", "v"), _of_kind("screw", "s"), _of_kind("coscrew", "c"),
                  _of_space("screw", "s", "Ad", Ad, Ad_inverse),
                  _of_space("coscrew", "c", "CoAd", CoAd, CoAd_inverse)):
    FORMULAS |= _formulas
FORMULAS |= BODIES


class Sample:
    """Random rational quantities; the same seed gives the same ones."""

    def __init__(self, seed: int):
        self._random = Random(seed)

    def scalar(self) -> Fraction:
        """Never zero."""
        numerator = self._random.randint(1, 999) * self._random.choice((-1, 1))
        return Fraction(numerator, self._random.randint(1, 99))

    def vector(self, n: int = 3) -> Matrix:
        return array([self.scalar() for _ in range(n)])

    def rotation(self) -> Matrix:
        """The rotation of a quaternion of any norm."""
        return rotation_of(joined(self.vector(), [self._random.randint(1, 9)]))

    def quaternion(self) -> Matrix:
        """p² / |p|² of a quaternion p: of norm 1."""
        p = self.vector(4)
        return product(p, p) / (p @ p)

    def displacement(self) -> Matrix:
        return displacement(self.rotation(), self.vector())

    def sine_cosine(self) -> Matrix:
        """Sine and cosine of the angle whose half has this rational tangent."""
        h = self.scalar()
        return array([2 * h, 1 - h * h]) / (1 + h * h)

    def of(self, kind: str) -> Matrix | Fraction:
        """The quantity of this name; a mat3x3 is a rotation."""
        draw: dict[str, Callable[[], Matrix | Fraction]] = {
            "scalar": self.scalar, "vec3": self.vector, "dc": self.sine_cosine,
            "mat3x3": self.rotation, "SE3": self.displacement, "quaternion": self.quaternion,
            "mat6x6": lambda: self.vector(36).reshape(6, 6),
            "mat4x4": lambda: self.vector(16).reshape(4, 4), "vec4": partial(self.vector, 4),
            **dict.fromkeys(("inertia", "spatial_inertia"), partial(self.vector, 10))}
        return draw[kind]() if kind in draw else self.vector(6)


class Exact:
    """The kernels as emitted for one precision, on Fractions, their constants Fractions too."""

    def __init__(self, kernels: ModuleType):
        self._kernels = kernels

    def __getattr__(self, name: str) -> Callable[..., Result]:
        operation, kernel = TABLE[name], getattr(self._kernels, name).__wrapped__
        constants = tuple(map(_exactly, kernel.__code__.co_consts))
        exact = FunctionType(kernel.__code__.replace(co_consts=constants), kernel.__globals__)
        exact.__kwdefaults__ = {k: _exactly(x) for k, x in (kernel.__kwdefaults__ or {}).items()}

        def on_arrays(*values: Matrix | Fraction) -> Result:
            result = exact(*(tuple(x.ravel()) if isinstance(x, np.ndarray) and x.ndim else x
                             for x in values))
            result = iter(result if isinstance(result, tuple) else (result,))
            results = tuple(array([next(result) for _ in range(a.quantity.size)])
                            .reshape(a.quantity.shape)[()] for a in operation.outputs)
            return results if len(results) > 1 else results[0]

        return on_arrays


def _exactly(x: object) -> object:
    return Fraction(x) if isinstance(x, float) else x
