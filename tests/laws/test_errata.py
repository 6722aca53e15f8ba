"""The errata of the page `Coscrews` and of KSL: on an exact example their formula fails, and ours
holds."""

import numpy as np
import pytest
import sympy as sp

import coscrew
from tests.support.compiled.c_reader import Place, Record, functions_in, header
from tests.support.truth import bodies, exact
from tests.support.truth.exact import JOINTS, Exact, Sample, eye, keeping, skew, zeros

kernels = Exact(coscrew.double)


@pytest.fixture(params=range(3))
def sample(request: pytest.FixtureRequest) -> Sample:
    return Sample(100 + request.param)


def test_inverse_of_the_adjoint(sample):
    """Eq. (4) prints [[R^T, t~R^T], [0, R^T]]; it is [[R^T, -R^T t~], [0, R^T]]."""
    D = sample.displacement()
    R, t = exact.R_t(D)
    printed = np.block([[R.T, skew(t) @ R.T], [zeros(3, 3), R.T]])
    assert (printed @ exact.Ad(D) != eye(6)).any()
    assert (exact.Ad_inverse(D) @ exact.Ad(D) == eye(6)).all()

    s = sample.vector(6)
    assert (kernels.product_Adinvs(D, s) == exact.Ad_inverse(D) @ s).all()
    assert (kernels.product_Adinvs(D, s) != printed @ s).any()


def test_inverse_of_the_coadjoint(sample):
    """product_CoAdinvc prints [[R^T, 0], [-t~R^T, R^T]]; it is (R^T f ; R^T (τ - t×f))."""
    D, c = sample.displacement(), sample.vector(6)
    R, t = exact.R_t(D)
    printed = np.block([[R.T, zeros(3, 3)], [-(skew(t) @ R.T), R.T]])
    moved = kernels.product_CoAdc(D, c)
    assert (printed @ moved != c).any()
    assert (kernels.product_CoAdinvc(D, moved) == c).all()
    corrected = exact.joined(R.T @ c[:3], R.T @ (c[3:] - np.cross(t, c[:3])))
    assert (kernels.product_CoAdinvc(D, c) == corrected).all()


def test_inverse_of_a_coscrew_is_its_negative(sample):
    """…cinv is CoAd (-c), …invc is CoAd^-1 c; for a translation -(f; τ + t×f), (f; τ - t×f)."""
    D, c = sample.displacement(), sample.vector(6)
    R, t = exact.R_t(D)
    shift = np.cross(t, c[:3])
    assert (kernels.product_CoAdtcinv(t, c) == -exact.joined(c[:3], c[3:] + shift)).all()
    assert (kernels.product_CoAdtinvc(t, c) == exact.joined(c[:3], c[3:] - shift)).all()
    assert (kernels.product_CoAdrcinv(R, c) == -exact.joined(R @ c[:3], R @ c[3:])).all()
    assert (kernels.product_CoAdrinvc(R, c) == exact.joined(R.T @ c[:3], R.T @ c[3:])).all()
    assert (kernels.product_CoAdcinv(D, c) == -exact.CoAd(D) @ c).all()
    for group, x in (("t", t), ("r", R), ("", D)):
        of_inverse = getattr(kernels, f"product_CoAd{group}cinv")(x, c)
        assert (of_inverse != getattr(kernels, f"product_CoAd{group}invc")(x, c)).any()


@pytest.mark.parametrize("joint", range(6), ids=JOINTS)
def test_orthogonality_of_constraints_and_working_force(sample, joint):
    """Eq. (11), H̄^T h* = 0: of the screws H̄ = Ad P and the coscrew h* = CoAd (I - P)."""
    D, P = sample.displacement(), eye(6) - keeping(joint)
    h = kernels.CoAd(D) @ (eye(6) - P)
    assert not ((kernels.Ad(D) @ P).T @ h).any()


@pytest.mark.parametrize("joint", range(6), ids=JOINTS)
def test_starred_columns_are_orthogonal_in_the_joints_frame_only(sample, joint):
    """The sentence under eq. (11) holds for t = 0 and fails for t = (1, 2, 3)."""
    P, R = eye(6) - keeping(joint), sample.rotation()

    def gram(t: list[int]) -> exact.Matrix:
        starred = kernels.CoAd(exact.displacement(R, exact.array(t)))
        return (starred @ P).T @ (starred @ (eye(6) - P))

    assert not gram([0, 0, 0]).any()
    assert gram([1, 2, 3]).any()


def test_single_precision_has_the_whole_coadjoint_product():
    """The page lists ksl_product_CoAdrcf twice; the second stands for ksl_product_CoAdcf."""
    functions = functions_in("coscrew")
    assert {"ksl_product_CoAdrcf", "ksl_product_CoAdcf"} <= set(functions)
    parameters = header().parameters("ksl_product_CoAdcf")
    assert list(parameters) == ["D", "ci", "co"]
    assert parameters["D"] == header().types["ksl_SE3f_t"]


@pytest.mark.parametrize("f", ["", "f"])
@pytest.mark.parametrize("name, written, formula", [
    ("coscrew{f}_scale", "self", lambda self, a: a * self),
    ("axpy_cc{f}", "y", lambda a, x, y: a * x + y),
    ("xpy_cc{f}", "y", lambda x, y: x + y),
    ("nxpy_cc{f}", "y", lambda x, y: -x + y),
    ("product_ac{f}", "co", lambda a, ci, co: a * ci),
    ("coscrew{f}_copy", "co", lambda ci, co: ci)])
def test_formula_is_the_authority_over_the_parameter_list(name, written, formula, f):
    """Arguments that the page marks [in/out] are read and written, [in] ones are read only."""
    c_name = "ksl_" + name.format(f=f)
    parameters = header().parameters(c_name)
    assert list(parameters) == list(formula.__code__.co_varnames)
    memory = {n: Place.new(kind) for n, kind in parameters.items() if isinstance(kind, Record)}
    before = [{n: sp.Symbol(f"{n}_{i}") if n in memory else sp.Symbol(n) for n in parameters}
              for i in range(6)]
    for n, place in memory.items():
        for i in range(6):
            place.entry(i).write(before[i][n])
    header().call(c_name, *(memory.get(n, sp.Symbol(n)) for n in parameters))
    for i in range(6):
        after = {n: place.entry(i).read() for n, place in memory.items()}
        assert before[i] | after == before[i] | {written: formula(**before[i])}


def test_velocity_in_the_derivative_operator(sample):
    """Eq. (12): with R' = ω~R, CoAd' CoAd^-1 = [ad]*(v, ω) for v = t' - ω×t; not for v = t'."""
    D, w, t_rate = sample.displacement(), sample.vector(), sample.vector()
    R, t = exact.R_t(D)
    R_rate = skew(w) @ R
    coadjoint_rate = np.block([[R_rate, zeros(3, 3)],
                               [skew(t_rate) @ R + skew(t) @ R_rate, R_rate]])
    derivative = coadjoint_rate @ exact.CoAd_inverse(D)
    assert (derivative == kernels.coad(exact.joined(t_rate - np.cross(w, t), w))).all()
    assert (derivative != kernels.coad(exact.joined(t_rate, w))).any()


# KSL's own code, where its results differ from what its names promise.


def test_product_with_an_inverse_rotation(sample):
    """KSL's product_drdrinv multiplies columns by columns: R1^T R2, not R1 R2^T."""
    R1, R2 = sample.rotation(), sample.rotation()
    assert (kernels.product_drdrinv(R1, R2) == R1 @ R2.T).all()
    assert (R1.T @ R2 != R1 @ R2.T).any()
    assert (kernels.product_drdr(kernels.product_drdrinv(R1, R2), R2) == R1).all()


def test_products_with_inverse_displacements(sample):
    """KSL's rotations in product_ddrinv and product_ddinv are wrong alike; the former adds its
    translation to the old value, and the translation of product_dinvd is R1 t2 - R1^T t1."""
    D1, D2 = sample.displacement(), sample.displacement()
    (R1, t1), (R2, t2) = exact.R_t(D1), exact.R_t(D2)
    assert (kernels.product_ddrinv(D1, R2) == exact.displacement(R1 @ R2.T, t1)).all()
    assert (kernels.product_dd(kernels.product_ddinv(D1, D2), D2) == D1).all()
    assert (t1 - R1.T @ R2 @ t2 != exact.R_t(kernels.product_ddinv(D1, D2))[1]).any()
    assert (kernels.product_dd(D1, kernels.product_dinvd(D1, D2)) == D2).all()
    assert (R1 @ t2 - R1.T @ t1 != exact.R_t(kernels.product_dinvd(D1, D2))[1]).any()


def test_axis_and_angle_of_small_and_half_turns():
    """By the arc cosine of the trace, KSL's getAxisAngle finds no angle of 1e-9, and by its last
    diagonal entry the axis x of half a turn about y."""
    small = coscrew.double.mat3x3_from_axis_angle(np.array([0.6, 0, 0.8]), 1e-9)
    assert np.arccos((np.trace(small) - 1) / 2) == 0
    angle, axis = coscrew.double.axis_angle_from_mat3x3(small)
    assert abs(angle - 1e-9) <= 1e-24 and np.abs(axis - [0.6, 0, 0.8]).max() <= 1e-15
    about_y = np.diag([-1.0, 1, -1])
    assert about_y[2, 2] == -1  # for which KSL's axis is (1, 0, 0)
    angle, axis = coscrew.double.axis_angle_from_mat3x3(about_y)
    assert angle == np.pi and (np.abs(axis) == [0, 1, 0]).all()


def test_inverses_of_matrices_without_a_leading_entry_and_of_small_ones():
    """KSL's mat3x3_invert exchanges no rows, and treats determinants below 1e-12 as singular."""
    turned = np.array([[0.0, 1, 0], [0, 0, 1], [1, 0, 0]])
    determinant, inverse = coscrew.double.mat3x3_inverse(turned)
    assert determinant == 1 and (inverse == turned.T).all()
    determinant, inverse = coscrew.double.mat3x3_inverse(np.eye(3) * 2.0**-50)
    assert determinant == 2.0**-150 and (inverse == np.eye(3) * 2.0**50).all()


def test_inertias_that_are_moved(sample):
    """KSL's inertia_translated and inertia_transformed add Steiner's term to members that are about
    the centre of mass: a body moved there and back gains m c² each time, c from the origin."""
    D, J = sample.displacement(), sample.of("inertia")

    def of_ksl(J, D):
        R, t = exact.R_t(D)
        mt = R @ J[1:4] + J[0] * t
        I = R @ bodies.moments(J) @ R.T + J[0] * bodies.steiner(mt / J[0])
        return bodies.inertia(J[0], mt, I)

    moved, back = kernels.inertia_transformed(J, D), kernels.SE3_inverted(D)
    assert (kernels.inertia_transformed(moved, back) == J).all()
    assert (of_ksl(of_ksl(J, D), back) != J).any()
    assert (of_ksl(J, D)[:4] == moved[:4]).all() and (of_ksl(J, D)[4:] != moved[4:]).any()
    about_the_origin = kernels.spatial_inertia_from_inertia(moved)  # is where to ask for KSL's
    assert (bodies.moments(of_ksl(J, D)) == bodies.second_moments(about_the_origin)).all()


def test_inertias_that_are_merged(sample):
    """KSL's inertia_merge moves by its inertia_translated, whose term is of the centre of mass plus
    the way, not of the way between the centres, and is added to the output's old value."""
    D, Ji, Jj = sample.displacement(), sample.of("inertia"), sample.of("inertia")
    ci, cj = (J[1:4] / J[0] for J in (Ji, Jj))
    merged = kernels.inertia_merge(Ji, ci, Jj, cj, D)
    R, t = exact.R_t(D)
    c = merged[1:4] / merged[0]

    def of_ksl(J, I, way):
        return I + J[0] * bodies.steiner(J[1:4] / J[0] + way)

    added = (of_ksl(Ji, bodies.moments(Ji), c - ci)  # to outputs that held the inputs
             + of_ksl(kernels.inertia_rotated(Jj, R), R @ bodies.moments(Jj) @ R.T,
                      c - R @ cj - t))
    assert (bodies.moments(merged) != added).any()
    both = kernels.add_BB(*map(kernels.spatial_inertia_from_inertia,
                               (Ji, kernels.inertia_transformed(Jj, D))))
    assert (kernels.inertia_from_spatial_inertia(both) == merged).all()
