"""A program written for the Kinematics Subroutine Library compiles unchanged and prints the truth.

The truth is matrices of exact fractions, multiplied here and rounded once at the end.
"""

import re
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np
import pytest

from coscrew_codegen.targets.precision import PRECISIONS, Precision
from tests.c_harness import DIALECTS, EXACT, INCLUDE, STRICT, run

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


def _rounded(number: Fraction | int, precision: Precision) -> float:
    """The number of this precision nearest to `number`."""
    with mpmath.workprec(BITS[precision.name]):
        return float(mpmath.mpf(number.numerator) / number.denominator)


@pytest.fixture(scope="module", params=DIALECTS, ids=lambda x: f"{x[0]} {x[1][-1]}")
def printed(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
            ) -> dict[tuple[str, str], list[str]]:
    """What the program prints: (precision, what) → numbers, in hex."""
    compiler, language = request.param
    binary = tmp_path_factory.mktemp("ksl") / "program"
    run((compiler, *language, *STRICT, EXACT, "-I", INCLUDE / "ksl", PROGRAM, "-o", binary, "-lm"))
    lines = [line.split() for line in run([binary]).splitlines()]
    return {(precision, what): numbers for precision, what, *numbers in lines}


@pytest.mark.parametrize("precision", PRECISIONS, ids=lambda p: p.name)
@pytest.mark.parametrize("what", EXPECTED)
def test_program_prints_the_rounded_truth(what: str, precision: Precision,
                                          printed: dict[tuple[str, str], list[str]]):
    want = [_rounded(number, precision).hex() for number in EXPECTED[what]]
    got = [float.fromhex(number) for number in printed[precision.name, what]]
    assert [(x + 0.0).hex() for x in got] == want  # -0 equals 0 here


@pytest.mark.parametrize("precision", PRECISIONS, ids=lambda p: p.name)
def test_program_prints_sine_and_cosine_within_1_ulp(
        precision: Precision, printed: dict[tuple[str, str], list[str]]):
    number = np.dtype(precision.numpy_type).type
    with mpmath.workdps(50):
        for text, truth in zip(printed[precision.name, "dc"], (mpmath.sin(0.5), mpmath.cos(0.5))):
            assert abs(float.fromhex(text) - truth) <= float(np.spacing(number(truth))), text


def test_program_uses_the_whole_page():
    called = set(re.findall(r"\b(ksl_\w+)\(", PROGRAM.read_text(encoding="utf-8")))
    assert set(PAGE) <= called


def test_everything_printed_is_expected(printed: dict[tuple[str, str], list[str]]):
    assert {what for _, what in printed} == {*EXPECTED, "dc"}
