"""A program written for the Kinematics Subroutine Library compiles unchanged and prints the truth.

The truth is matrices of exact fractions, multiplied here and rounded once at the end.
"""

import re
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np
import pytest

from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from tests.support.cases import for_all
from tests.support.compiled.c_harness import DIALECTS, EXACT, INCLUDE, STRICT, run
from tests.support.each import each_precision

PROGRAM = Path(__file__).with_name("ksl_program.c")
BITS = {"double": 53, "single": 24}

# The functions of KSL's page "Coscrews", and ksl_product_CoAdcf, which it omits.
PAGE = """
ksl_coscrew ksl_coscrew_alloc ksl_coscrew_copy ksl_coscrew_scale ksl_coscrew_inverted
ksl_coscrew_invert ksl_axpy_cc ksl_xpy_cc ksl_nxpy_cc ksl_product_ac ksl_add_cc ksl_subtract_cc
ksl_cross_sc ksl_product_CoAdtc ksl_product_CoAdtcinv ksl_product_CoAdrc ksl_product_CoAdrinvc
ksl_product_CoAdc ksl_product_CoAdinvc
ksl_coscrewf ksl_coscrewf_alloc ksl_coscrewf_copy ksl_coscrewf_scale ksl_coscrewf_inverted
ksl_coscrewf_invert ksl_axpy_ccf ksl_xpy_ccf ksl_nxpy_ccf ksl_product_acf ksl_add_ccf
ksl_subtract_ccf ksl_cross_scf ksl_product_CoAdtcf ksl_product_CoAdtcinvf ksl_product_CoAdrcf
ksl_product_CoAdrinvcf ksl_product_CoAdcf ksl_product_CoAdinvcf
""".split()


def exact(*rows) -> np.ndarray:
    """An array of fractions."""
    return np.vectorize(Fraction, otypes=[object])(np.array(rows, object))


def skew(x: np.ndarray) -> np.ndarray:
    """x~, with x~ y = x × y."""
    return exact([0, -x[2], x[1]], [x[2], 0, -x[0]], [-x[1], x[0], 0])


I, O = exact(*np.eye(3, dtype=int)), exact(*np.zeros((3, 3), int))
R, t = exact([1, 2, -3], [4, 5, 6], [-7, 8, 9]), exact("1/2", "-3/2", "9/4")
TURN, STEP = exact([0, 0, 1], [-1, 0, 0], [0, -1, 0]), exact(3, 4, 5)
s = exact("3/2", -2, "1/4", 3, -6, 2)
v, w = s[:3], s[3:]
c, b, a = exact(2, -3, 6, 1, 4, -8), exact(-5, 7, 1, "1/2", 3, 2), Fraction(5, 2)
f, tau = c[:3], c[3:]
AD, CO_AD = np.block([[R, skew(t) @ R], [O, R]]), np.block([[R, O], [skew(t) @ R, R]])
AD_INV = np.block([[R.T, -R.T @ skew(t)], [O, R.T]])
CO_AD_T, CO_AD_R = np.block([[I, O], [skew(t), I]]), np.block([[R, O], [O, R]])
CO_AD_INV = np.block([[R.T, O], [-R.T @ skew(t), R.T]])


def _columns(rotation: np.ndarray, translation: np.ndarray) -> np.ndarray:
    """A displacement as C stores it."""
    return np.concatenate([rotation.T.ravel(), translation])


EXPECTED = {
    "coscrew_alloc": [0] * 6, "sum": 3 * c,
    "coscrew_parts": (f[1], tau[2]), "coscrew_members": (f[1], tau[2]),
    "SE3_members": (R[1, 2], R[1, 2]), "SE3_array": (t[0], R[2, 0]), "SE3_column": R[:, 1],
    "SE3_columns": t, "SE3_t": t,
    "mat3x3_as_array": R.T.ravel(), "mat3x3_members": (R[0, 2], R[2, 1]), "mat3x3_column": R[:, 2],
    "coscrew_copy": c, "coscrew_scale": a * c, "coscrew_inverted": -c, "coscrew_invert": -b,
    "axpy_cc": a * c + b, "xpy_cc": c + b, "nxpy_cc": b - c, "product_ac": a * c,
    "add_cc": c + b, "subtract_cc": c - b,
    "cross_sc": np.concatenate([np.cross(w, f), np.cross(v, f) + np.cross(w, tau)]),
    "product_CoAdtc": CO_AD_T @ c, "product_CoAdtcinv": CO_AD_T @ -c,
    "product_CoAdrc": CO_AD_R @ c, "product_CoAdrinvc": CO_AD_R.T @ c,
    "product_CoAdc": CO_AD @ c, "product_CoAdinvc": CO_AD_INV @ c, "there_and_back": c,
    "add_cct": np.concatenate([f + b[:3], tau]), "cross_sca": [0, 0, 0, *np.cross(w, tau)],
    "product_CoAdtinvc": np.block([[I, O], [-skew(t), I]]) @ c, "product_CoAdrcinv": CO_AD_R @ -c,
    "product_CoAdcinv": CO_AD @ -c, "hcty": CO_AD[:, 1], "hcrzinv": -CO_AD[:, 5],
    "coscrew_norm": (7, 9),  # 2² + 3² + 6² and 1² + 4² + 8²
    "coscrew_normalize": c / 7, "coscrew_normalize_zero": [0] * 6,
    "product_Ads": AD @ s, "product_Adinvs": AD_INV @ s, "cross_ss": [0] * 6, "hsrx": AD[:, 3],
    "hsra": AD @ [0, 0, 0, *t], "dot_cs_and_screw_norm": (c @ s, 7),
    "product_drv": R @ t, "product_dv": R @ v + t, "cross_vv": np.cross(f, w),
    "product_dd": _columns(R @ TURN, R @ STEP + t),
    "product_ddinv": _columns(R @ TURN.T, t - R @ TURN.T @ STEP),
}

# Quaternions (x, y, z, w), and inertias about the centre of mass.

p, q, turn = exact(1, -2, "1/2", 3), exact(-4, "1/4", 2, 1), exact("1/2", -2)
third, K = exact(*["1/2"] * 4), exact([0, 0, 1], [1, 0, 0], [0, 1, 0])  # about (1, 1, 1)


def conjugate(q: np.ndarray) -> np.ndarray:
    return np.array([*-q[:3], q[3]])


def times(p: np.ndarray, q: np.ndarray) -> np.ndarray:
    """(p_w q_v + q_w p_v + p_v × q_v; p_w q_w - p_v·q_v)."""
    return np.array([*(p[3] * q[:3] + q[3] * p[:3] + np.cross(p[:3], q[:3])),
                     p[3] * q[3] - p[:3] @ q[:3]])


def about(axis: int) -> np.ndarray:
    """The rotation with this sine and cosine of half its angle."""
    return np.array([*(turn[0] * I[axis]), turn[1]])


def pure(v: np.ndarray) -> np.ndarray:
    return np.array([*v, Fraction(0)])


ci, cj, mi, mj = exact(1, "-1/2", 2), exact(-2, "1/4", 1), Fraction(2), Fraction(6)
Ii = exact([5, "1/2", "-1/8"], ["1/2", 6, "1/4"], ["-1/8", "1/4", 7])
Ij = exact([3, "-1/2", 1], ["-1/2", 2, "1/8"], [1, "1/8", 4])
there = R @ cj + t  # the second centre of mass, moved
middle = (mi * ci + mj * there) / (mi + mj)


def ten(m: Fraction, c: np.ndarray, moments: np.ndarray) -> np.ndarray:
    return np.array([m, *(m * c), *(moments[i, j] for i, j in (
        (0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)))])


def steiner(m: Fraction, x: np.ndarray) -> np.ndarray:
    return -m * skew(x) @ skew(x)


EXPECTED |= {
    "quaternion_alloc": (0, 0, 0, 1), "quaternion_members": (p[3], p[2]), "quaternion_r": p[:3],
    "dot_qq": (p @ q, 0), "axpy_qq": a * p + q, "quaternion_normalize": exact(2, 4, -4, 8) / 10,
    "product_qq": times(p, q), "product_qconjq": times(conjugate(p), q),
    "product_qqconj": times(p, conjugate(q)),
    "product_qconjqconj": times(conjugate(p), conjugate(q)),
    "product_qxq": times(about(0), q), "product_qqyconj": times(p, conjugate(about(1))),
    "product_qzconjqconj": times(conjugate(about(2)), conjugate(q)),
    "product_qconjqx": times(conjugate(p), about(0)),
    "product_qv": times(p, pure(t)), "product_vqconj": times(pure(t), conjugate(p)),
    "add_dpiToq": p + times(p, pure(t)) / 2, "subtract_dpiFromq": p - times(p, pure(t)) / 2,
    "omega_to_dquaternion": times(pure(t), third) / 2,
    "quaternion_toMat3x3": K.T.ravel(), "mat3x3_toQuaternion": third,
    "product_uqinverseq": times(conjugate(third), q),
    "inertia_alloc": [0] * 10, "inertia": ten(mi, ci, Ii), "inertia_copy": ten(mi, ci, Ii),
    "inertia_names": (mi, mi * ci[2]), "inertia_products": (Ii[1, 0], Ii[2, 1]),
    "inertia_moments": (Ii[0, 2], Ii[1, 1]),
    **dict.fromkeys(("inertia_rotated", "inertia_rotate"), ten(mi, R @ ci, R @ Ii @ R.T)),
    **dict.fromkeys(("inertia_translated", "inertia_translate"), ten(mi, ci + t, Ii)),
    **dict.fromkeys(("inertia_transformed", "inertia_transform"),
                    ten(mi, R @ ci + t, R @ Ii @ R.T)),
    "inertia_merge": ten(mi + mj, middle, Ii + R @ Ij @ R.T + steiner(mi, ci - middle)
                         + steiner(mj, there - middle)),
    "inertia_factor": (3, 2),
}
HALFWAY = ("slerp", "nlerp", "squad")  # a quarter turn about z, halfway through a half turn


def _rounded(number: Fraction | int, precision: Precision) -> float:
    """The number of this precision nearest to `number`."""
    with mpmath.workprec(BITS[precision.name]):
        return float(mpmath.mpf(number.numerator) / number.denominator)


@pytest.fixture(scope="module", params=DIALECTS, ids=lambda x: f"{x[0]} {x[1][-1]}")
def printed(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
            ) -> dict[tuple[str, str], list[str]]:
    """The program's output: (precision, what) → numbers, in hex."""
    compiler, language = request.param
    binary = tmp_path_factory.mktemp("ksl") / "program"
    run((compiler, *language, *STRICT, EXACT, "-I", INCLUDE / "ksl", PROGRAM, "-o", binary, "-lm"))
    lines = [line.split() for line in run([binary]).splitlines()]
    return {(precision, what): numbers for precision, what, *numbers in lines}


@for_all(precision=PRECISIONS, what=EXPECTED)
def test_program_prints_the_rounded_truth(what: str, precision: Precision,
                                          printed: dict[tuple[str, str], list[str]]):
    want = [_rounded(number, precision).hex() for number in EXPECTED[what]]
    got = [float.fromhex(number) for number in printed[precision.name, what]]
    assert [(x + 0.0).hex() for x in got] == want  # -0 equals 0 here


@each_precision
def test_program_prints_sine_and_cosine_within_1_ulp(
        precision: Precision, printed: dict[tuple[str, str], list[str]]):
    number = np.dtype(precision.numpy_type).type
    with mpmath.workdps(50):
        truths = mpmath.sin(0.5), mpmath.cos(0.5)
        for text, truth in zip(printed[precision.name, "dc"], truths, strict=True):
            assert abs(float.fromhex(text) - truth) <= float(np.spacing(number(truth))), text


@for_all(precision=PRECISIONS, what=HALFWAY)
def test_program_prints_quarter_turns(what: str, precision: Precision,
                                      printed: dict[tuple[str, str], list[str]]):
    """(0, 0, 1, 1) / sqrt 2 within 4 u."""
    with mpmath.workdps(50):
        wanted = [0, 0, mpmath.sqrt(0.5), mpmath.sqrt(0.5)]
        for text, truth in zip(printed[precision.name, what], wanted, strict=True):
            error = abs(float.fromhex(text) - truth)
            assert error <= 4 * mpmath.mpf(2)**-BITS[precision.name] * truth, text


def test_program_uses_the_whole_page():
    called = set(re.findall(r"\b(ksl_\w+)\(", PROGRAM.read_text(encoding="utf-8")))
    assert set(PAGE) <= called


def test_everything_printed_is_expected(printed: dict[tuple[str, str], list[str]]):
    assert {what for _, what in printed} == {*EXPECTED, *HALFWAY, "dc"}
