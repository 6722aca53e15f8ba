"""The laws of spatial algebra, exactly: the emitted kernels of either precision, on rationals."""

import re
from fractions import Fraction
from functools import partial

import mpmath
import numpy as np
import pytest

import coscrew
from tests.support.cases import for_all
from tests.support.truth import exact
from tests.support.truth.bodies import POSITIVE_DEFINITE
from tests.support.truth.exact import (
    FORMULAS,
    IRRATIONAL,
    JOINTS,
    TABLE,
    Exact,
    Matrix,
    Sample,
    array,
    displacement,
    eye,
)

INVERTED = tuple(name for name in TABLE if name + "inv" in TABLE)
UNDONE = tuple(name for name in INVERTED  # these end in a factor that `inv` inverts;
               if re.fullmatch(r"product_d(rdr|d|dr|dt)[xyz]?|add_vv[xyz]", name))
NEGATED = tuple(name for name in INVERTED if name not in UNDONE)  # these in a vector or (co)screw

exactly = for_all(k=[partial(Exact, kernels) for kernels in (coscrew.double, coscrew.single)],
                  sample=[partial(Sample, seed) for seed in range(3)])
each_group = pytest.mark.parametrize("group", ["t", "r", ""])
each_space = pytest.mark.parametrize("Ad, x", [("Ad", "s"), ("CoAd", "c")])
each_joint = pytest.mark.parametrize("joint", range(6), ids=JOINTS)


def same(x: object, y: object) -> bool:
    """Returns whether all components of one or several values are exactly equal."""
    if isinstance(x, tuple):
        return all(map(same, x, y))
    return np.shape(x) == np.shape(y) and bool(np.all(np.asarray(x == y)))


def arguments(name: str, sample: Sample) -> list[Matrix | Fraction]:
    return [sample.of(a.quantity.name) for a in TABLE[name].inputs]


def of_group(group: str, sample: Sample) -> tuple[Matrix, Matrix]:
    """An argument of product_…t…, …r… or …, and the displacement it stands for."""
    R, t = sample.rotation(), sample.vector()
    return {"t": (t, displacement(eye(3), t)), "r": (R, displacement(R, exact.O3)),
            "": (displacement(R, t),) * 2}[group]


# what operations compute


def test_every_operation_has_its_law():
    assert set(TABLE) == {*FORMULAS, *(name + "inv" for name in INVERTED), *IRRATIONAL,
                          *POSITIVE_DEFINITE}


@pytest.mark.parametrize("name", FORMULAS)
@exactly
def test_operation_is_its_matrix_formula(k, sample, name):
    values = arguments(name, sample)
    assert same(getattr(k, name)(*values), FORMULAS[name](*values))


@pytest.mark.parametrize("name", UNDONE)
@exactly
def test_inverse_of_a_factor_undoes_it(k, sample, name):
    first, factor = arguments(name, sample)
    there = getattr(k, name)(first, factor)
    assert same(getattr(k, name + "inv")(there, factor), first) and not same(there, first)


@pytest.mark.parametrize("name", NEGATED)
@exactly
def test_inverse_of_a_linear_quantity_is_its_negative(k, sample, name):
    values = arguments(name, sample)
    assert same(getattr(k, name + "inv")(*values), -getattr(k, name)(*values))


@pytest.mark.parametrize("name, inverse", [
    ("product_drv", "product_drinvv"), ("product_dv", "product_dinvv"),
    ("product_dd", "product_dinvd"), ("product_drdr", "product_drinvdr"),
    *((f"product_{Ad}{group}{x}", f"product_{Ad}{group}inv{x}")
      for Ad, x in (("Ad", "s"), ("CoAd", "c")) for group in ("t", "r", ""))])
@exactly
def test_inverse_transform_undoes(k, sample, name, inverse):
    transform, x = arguments(name, sample)
    assert same(getattr(k, inverse)(transform, getattr(k, name)(transform, x)), x)
    assert same(getattr(k, name)(transform, getattr(k, inverse)(transform, x)), x)


@each_space
@each_group
@exactly
def test_inverse_quantity_is_not_inverse_transform(k, sample, Ad, x, group):
    argument, quantity = of_group(group, sample)[0], sample.vector(6)
    of_inverse = getattr(k, f"product_{Ad}{group}{x}inv")(argument, quantity)
    assert not same(of_inverse, getattr(k, f"product_{Ad}{group}inv{x}")(argument, quantity))


@pytest.mark.parametrize("Ad, x, inverse", [("Ad", "s", exact.Ad_inverse),
                                            ("CoAd", "c", exact.CoAd_inverse)])
@exactly
def test_inverse_transform_is_its_matrix_for_any_matrix_R(k, sample, Ad, x, inverse):
    D, quantity = sample.vector(12).reshape(3, 4), sample.vector(6)
    assert same(getattr(k, f"product_{Ad}inv{x}")(D, quantity), inverse(D) @ quantity)


# groups and algebras


@each_group
@exactly
def test_power_is_invariant(k, sample, group):
    D, _ = of_group(group, sample)
    c, s = sample.vector(6), sample.vector(6)
    moved_c = getattr(k, f"product_CoAd{group}c")(D, c)
    assert k.dot_cs(moved_c, getattr(k, f"product_Ad{group}s")(D, s)) == k.dot_cs(c, s)


@exactly
def test_coadjoint_is_inverse_transpose_of_adjoint(k, sample):
    D = sample.displacement()
    assert same(k.CoAd(D) @ k.Ad(D).T, eye(6))
    assert same(k.CoAd(D), k.mat6x6_transposed(k.Ad(k.SE3_inverted(D))))


@each_space
@exactly
def test_transforms_compose(k, sample, Ad, x):
    D1, D2, quantity = sample.displacement(), sample.displacement(), sample.vector(6)
    by, back = getattr(k, f"product_{Ad}{x}"), getattr(k, f"product_{Ad}inv{x}")
    assert same(by(k.product_dd(D1, D2), quantity), by(D1, by(D2, quantity)))
    assert same(back(k.product_dd(D1, D2), quantity), back(D2, back(D1, quantity)))
    assert same(by(k.product_ddinv(D1, D2), quantity), by(D1, back(D2, quantity)))
    assert same(by(k.product_dinvd(D1, D2), quantity), back(D1, by(D2, quantity)))
    assert same(getattr(k, Ad)(k.product_dd(D1, D2)), getattr(k, Ad)(D1) @ getattr(k, Ad)(D2))


@exactly
def test_displacements_are_a_group(k, sample):
    D1, D2, D3 = (sample.displacement() for _ in range(3))
    one = k.SE3_setIdentity(D1)
    assert same(k.product_dd(k.product_dd(D1, D2), D3), k.product_dd(D1, k.product_dd(D2, D3)))
    assert same(k.product_dd(D1, one), D1) and same(k.product_dd(one, D1), D1)
    assert same(k.product_ddinv(D1, D1), one) and same(k.product_dinvd(D1, D1), one)
    assert same(k.product_ddinv(D1, D2), k.product_dd(D1, k.SE3_inverted(D2)))


@exactly
def test_derivative_operators_are_dual(k, sample):
    s = sample.vector(6)
    assert same(k.coad(s), -k.mat6x6_transposed(k.ad(s)))


@pytest.mark.parametrize("cross, n", [("cross_vv", 3), ("cross_ss", 6)])
@exactly
def test_lie_bracket(k, sample, cross, n):
    bracket = getattr(k, cross)
    a, b, c = (sample.vector(n) for _ in range(3))
    assert same(bracket(a, b), -bracket(b, a))
    jacobi = bracket(a, bracket(b, c)) + bracket(b, bracket(c, a)) + bracket(c, bracket(a, b))
    assert not jacobi.any()


@exactly
def test_cross_sc_represents_the_lie_algebra(k, sample):
    s1, s2, c = (sample.vector(6) for _ in range(3))
    commutator = k.cross_sc(s1, k.cross_sc(s2, c)) - k.cross_sc(s2, k.cross_sc(s1, c))
    assert same(k.cross_sc(k.cross_ss(s1, s2), c), commutator)


@exactly
def test_bracket_moves_with_the_frame(k, sample):
    D, s, c = sample.displacement(), sample.vector(6), sample.vector(6)
    moved_s = k.product_Ads(D, s)
    assert same(k.product_CoAdc(D, k.cross_sc(s, c)), k.cross_sc(moved_s, k.product_CoAdc(D, c)))
    assert same(k.product_Ads(D, k.cross_ss(c, s)), k.cross_ss(k.product_Ads(D, c), moved_s))


@pytest.mark.parametrize("operator, derivative", [("Ad", "ad"), ("CoAd", "coad")])
@exactly
def test_derivative_operator_is_the_derivative(k, sample, operator, derivative):
    """Eq. (12).  The central difference quotient is sinh(hA)/h, A = [ad](s): off by h² A³/6."""
    D, s, matrix = sample.displacement(), sample.vector(6), getattr(k, operator)
    with mpmath.workdps(50):
        h = mpmath.mpf(10)**-16
        ahead, behind = (exact.multiprecise(matrix(exact.moved(D, s, x))) for x in (h, -h))
        inverse = exact.multiprecise(matrix(k.SE3_inverted(D)))
        A = exact.multiprecise(getattr(k, derivative)(s))
        error = np.abs((ahead - behind) / (2 * h) @ inverse - A).max()
        rounding = 100 * mpmath.eps / h * np.abs(ahead).max() * np.abs(inverse).max()
        assert error <= h**2 * np.abs(A).sum(axis=1).max()**3 / 6 + rounding


# rotations


@exactly
def test_quaternions_are_a_group_of_rotations(k, sample):
    p, q, r, v = (*(sample.vector(4) for _ in range(3)), sample.vector())
    R, one = k.mat3x3_from_quaternion, k.quaternion_setIdentity(p)
    product = k.quaternion_product_qq
    assert same(product(product(p, q), r), product(p, product(q, r)))
    assert same(k.quaternion_product_qq(p, one), p) and same(k.quaternion_product_qq(one, p), p)
    assert same(k.quaternion_product_qconjq(p, p), (p @ p) * one)
    assert same(k.quaternion_product_qqconj(p, p), (p @ p) * one)
    assert same(R(k.quaternion_product_qq(p, q)), R(p) @ R(q)) and same(R(-q), R(q))
    assert same(R(k.quaternion_conjugated(q)), R(q).T) and same(R(q).T @ R(q), eye(3))
    unit = sample.quaternion()
    assert same(k.rotate_qv(unit, v), R(unit) @ v)
    assert same(k.rotate_qconjv(unit, k.rotate_qv(unit, v)), v)
    turned = k.quaternion_product_qqconj(k.quaternion_product_qq(unit, array([*v, 0])), unit)
    assert same(turned, array([*k.rotate_qv(unit, v), 0]))


@exactly
def test_orthonormalization_leaves_a_defect_of_the_second_order(k, sample):
    """d = I - R^T R becomes (3 d² + d³) / 4, for any matrix."""
    matrix = sample.vector(9).reshape(3, 3)
    better = k.mat3x3_orthonormalized(matrix)
    assert same(better, exact.orthonormalized(matrix))
    assert same(k.mat3x3_orthonormalize(matrix), better)
    d = eye(3) - matrix.T @ matrix
    assert same(eye(3) - better.T @ better, (3 * d @ d + d @ d @ d) / 4)


# joints


@each_joint
@exactly
def test_constraint_and_working_forces_make_the_wrench(k, sample, joint):
    D, c = sample.displacement(), sample.vector(6)
    constraint, working = (getattr(k, f"{w}_c{JOINTS[joint]}") for w in ("constraint", "working"))
    assert same(constraint(D, c) + working(D, c), k.product_CoAdc(D, c))
    own = k.SE3_setIdentity(D)  # eqs. (7), (9): in the joint's own frame
    assert same(working(own, c), exact.keeping(joint) @ c)
    assert same(constraint(own, c), c - exact.keeping(joint) @ c)
    h = getattr(k, f"hc{JOINTS[joint]}")(D)
    assert same(working(D, c), h * c[joint])


@exactly
def test_joint_columns_are_reciprocal_and_make_the_operators(k, sample):
    """Eq. (11), H̄^T h* = 0, for screws H̄; eq. (10): the columns together are [Ad], [Ad]*."""
    D = sample.displacement()
    screws = [getattr(k, f"hs{joint}")(D) for joint in JOINTS]
    coscrews = [getattr(k, f"hc{joint}")(D) for joint in JOINTS]
    powers = array([[k.dot_cs(h, H) for H in screws] for h in coscrews])
    assert same(powers, eye(6))
    assert same(array(screws).T, k.Ad(D)) and same(array(coscrews).T, k.CoAd(D))


@pytest.mark.parametrize("axis", range(3))
@exactly
def test_joint_about_a_unit_axis(k, sample, axis):
    D, e = sample.displacement(), eye(3)[axis]
    assert same(k.hsra(D, e), getattr(k, f"hsr{'xyz'[axis]}")(D))
    assert same(k.hsta(D, e), getattr(k, f"hst{'xyz'[axis]}")(D))


@exactly
def test_reciprocal_product_is_power(k, sample):
    c, s = sample.vector(6), sample.vector(6)
    assert k.reciprocal_product(c, k.screw_to_angular_first(s)) == k.dot_cs(c, s)
    assert k.reciprocal_product(s, k.coscrew_to_angular_first(c)) == k.dot_cs(c, s)


@pytest.mark.parametrize("kind", ["screw", "coscrew"])
@exactly
def test_angular_first_round_trip(k, sample, kind):
    x, to = sample.vector(6), getattr(k, f"{kind}_to_angular_first")
    back = getattr(k, f"{kind}_from_angular_first")
    assert same(back(to(x)), x) and same(to(back(x)), x)
