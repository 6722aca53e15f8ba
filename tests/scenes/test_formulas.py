"""Formulas of scene files are read exactly, evaluate on any numbers, and refuse all else."""

import operator
from fractions import Fraction

import mpmath
import pytest

from coscrew_codegen.scene.formulas import LENGTH, NESTING, POWER, Formula, FormulaError

NAMES = ("sin", "cos", "exp", "tanh", "sqrt")


def fifty_digits():
    functions = {name: getattr(mpmath, name) for name in NAMES}
    return functions | {"abs": abs, "min": min, "max": max, "pi": mpmath.pi(),
                        "number": lambda x: mpmath.mpf(x.numerator) / x.denominator}


RATIONAL = {"number": lambda x: x, "abs": abs, "min": min, "max": max}


@pytest.mark.parametrize("text, truth", [
    ("0.1", lambda t: Fraction(1, 10)),
    ("1.e2", lambda t: Fraction(100)),
    (".5E-1", lambda t: Fraction(1, 20)),
    ("t", lambda t: t),
    (" t ", lambda t: t),
    ("-t**2", lambda t: -(t * t)),
    ("2 - 3 - 4*t/5/2", lambda t: -1 - Fraction(4, 10) * t),
    ("-(t - 1)*(+t + 1)", lambda t: 1 - t * t),
    ("t**-3", lambda t: 1 / (t * t * t)),
    ("t**0", lambda t: Fraction(1)),
    ("t**13", lambda t: t**13),
    ("(t**10)**10", lambda t: t**100),
    ("2**(-4/2)", lambda t: Fraction(1, 4)),
    ("min(t, 3, -1)", lambda t: min(t, 3, -1)),
    ("max(1, min(t, 2))", lambda t: max(1, min(t, 2))),
    ("abs(0.1 - t)", lambda t: abs(Fraction(1, 10) - t)),
    ("t" + "+t" * 400, lambda t: 401 * t),
])
@pytest.mark.parametrize("t", [Fraction(1, 3), Fraction(-7, 2), Fraction(5)])
def test_rational_formulas_are_exact(text, truth, t):
    assert Formula(text).value(t, RATIONAL) == truth(t)


@pytest.mark.parametrize("text, truth", [
    ("sin(2*pi*t)", lambda t: mpmath.sin(2 * mpmath.pi * t)),
    ("exp(-t)*cos(t)", lambda t: mpmath.cos(t) / mpmath.exp(t)),
    ("tanh(sqrt(t))", lambda t: mpmath.tanh(mpmath.sqrt(t))),
    ("t**1.5", lambda t: t * mpmath.sqrt(t)),
    ("t**(-1/2)", lambda t: 1 / mpmath.sqrt(t)),
])
def test_formulas_in_fifty_digits(text, truth):
    with mpmath.workdps(50):
        t = mpmath.mpf("0.3")
        assert abs(Formula(text).value(t, fifty_digits()) - truth(t)) < mpmath.mpf(10)**-48


def test_any_numbers_will_do():
    """Numbers need only the operators that the formula contains."""

    class Written:
        def __init__(self, text):
            self.text = text

        def __mul__(self, other):
            return Written(f"({self.text} * {other.text})")

        def __add__(self, other):
            return Written(f"({self.text} + {other.text})")

    functions = {"number": lambda x: Written(str(x)), "pi": Written("π"),
                 "sin": lambda x: Written(f"sin{x.text}")}
    written = Formula("1.5 + 2*sin(pi*t)").value(Written("t"), functions)
    assert written.text == "(3/2 + (2 * sin(π * t)))"


def test_a_formula_without_t_is_constant():
    assert not Formula("2*pi").timed
    assert Formula("0*t").timed
    assert not Formula("tanh(1)").timed


def test_equal_texts_are_equal_formulas():
    assert Formula("t+1") == Formula("t+1") and hash(Formula("t+1")) == hash(Formula("t+1"))
    assert Formula("t+1") != Formula("1+t")
    assert repr(Formula("t")) == "Formula(text='t')"


@pytest.mark.parametrize("text, words", [
    ("", "nothing there"), ("   ", "nothing there"),
    ("sinn(t)", "did you mean 'sin'?"),
    ("Sin(t)", "did you mean 'sin'?"),
    ("coss(t)", "did you mean 'cos'?"),
    ("heaviside(t)", "'heaviside'; formulas know t, pi and the functions sin, cos, exp, tanh"),
    ("2*omega", "'omega'; formulas know t, pi and the functions sin, cos, exp, tanh"),
    ("time", "unknown name 'time'"),
    ("x", "unknown name 'x'"),
    ("nan", "unknown name 'nan'"),
    ("sin", "lacks its argument"),
    ("t^2", "powers are written **"),
    ("t//2", "'//'"),
    ("2 kg", "unexpected 'kg'; wanted the number alone: units are those of SI, angles in rad"),
    ("90°", "unexpected '°'; wanted the number alone"), ("-1.5e3 m/s^2", "unexpected 'm/s^2'"),
    ("2deg", "unexpected 'deg'"),
    ("2 t", "cannot be read"), ("2t", "unexpected '2t'"), ("t +", "cannot be read"),
    ("(t", "cannot be read"), ("t)", "cannot be read"),
    ("sin()", "0 arguments"), ("sin(t, t)", "2 arguments"), ("min(t)", "two arguments or more"),
    ("sin(*t)", "unexpected"), ("t(1)", "unknown function 't'"),
    ("t.real", "unexpected 't.real'"), ("lambda", "cannot be read"),
    ("__import__(t)", "unknown function"), ("(t, t)", "unexpected"), ("()", "unexpected"),
    ("t if t else t", "unexpected"), ("not t", "unexpected"), ("None", "decimal numbers"),
    ("0x10", "unexpected '0x10'"), ("1_000", "'1_000'"), ("1j", "'1j'"), ("1or 2", "'1or'"),
    ("1e999", "out of range"), ("1e-301", "out of range"), ("1e99999", "'1e99999'"),
    ("t**t", "exponent 't'"), ("2**pi", "exponent 'pi'"), ("t**0.3", "exponent 0.3"),
    ("t**101", "at most 100"), ("(t**20)**6", "at most 100"), ("t**-101", "at most 100"),
    ("t**2**3", "exponent '2**3'"), ("t**(1/0)", "divides by zero"),
    ("t\n+1", "unexpected '\\n'"), ("\N{FULLWIDTH LATIN SMALL LETTER T}", "unexpected"),
    ("t\0", "unexpected"), ("'t'", "unexpected"), ("[t]", "unexpected"), ("t=1", "unexpected"),
])
def test_anything_else_is_refused(text, words):
    with pytest.raises(FormulaError) as caught:
        Formula(text)
    assert words in str(caught.value)
    assert str(caught.value).startswith("formula ") and "\n" not in str(caught.value)


@pytest.mark.parametrize("text", [
    "(" * 400 + "t" + ")" * 400, "-" * 900 + "t", "sin(" * 120 + "t" + ")" * 120,
    "t" * (LENGTH + 1), "(" * 900, "1+" * 400 + "-" * 60 + "t", "t**-" + "-" * 900 + "1",
    "t*(" * 60 + "1" + ")" * 60])
def test_length_and_nesting_are_bounded(text):
    with pytest.raises(FormulaError) as caught:
        Formula(text)
    assert len(str(caught.value)) < 300


def test_nesting_up_to_the_bound():
    depth = NESTING - 1
    assert Formula("-" * depth + "t").value(Fraction(2), RATIONAL) == 2 * (-1)**depth
    with pytest.raises(FormulaError):
        Formula("-" * (depth + 1) + "t")


def test_powers_need_few_products():
    """Powers are computed by repeated squaring, since kernels contain these products."""
    count = 0

    class Counted:
        def __mul__(self, other):
            nonlocal count
            count += 1
            return self

    Formula(f"t**{POWER}").value(Counted(), {"number": operator.pos})
    assert count <= 8
