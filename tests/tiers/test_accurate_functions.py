"""Operations that call elementary functions, in the accurate tier: a component is within one unit
of its last digit as long as its condition is below 1e13, in single precision the nearest number,
except near ties, as long as that is below 1e5.

Truth of operations on rotations, which rounded inputs are not quite, is their formula for twice the
digits in 60 digits; that formula is held against power series, on rotations in 60 digits.
"""

import ctypes

import mpmath
import numpy as np
import pytest

import coscrew.accurate
from coscrew_codegen.accuracy.tiers.accurate import accurate
from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.program import Input, Instruction, Op, Program, Ref
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE, Precision
from coscrew_codegen.program.values.quantity import SCALAR, Argument
from tests.hard_cases.corpus import load
from tests.hard_cases.near_zeros import (
    FUNCTIONS,
    KEPT,
    ORIGIN,
    RANGE,
    beyond,
    condition,
    judged,
    promised,
)
from tests.search import split
from tests.support.cases import for_all
from tests.support.compiled.c_harness import COMPILERS, EXACT, call, harness
from tests.support.compiled.implementations import gufuncs, same_bits, twin
from tests.support.each import each_precision
from tests.support.hard_rows import EXTREMES, hard_rows
from tests.support.limits import LARGEST_CONDITION
from tests.support.sampling import inputs_of
from tests.support.scenes.tiers import DIGITS, Result
from tests.support.truth.motions import exponential_series, hstack, norm, quaternion_exp, skew
from tests.support.truth.truths import by_formula, truth

ANGLES = ("1e-20", "0.999", "1.001", "1.999", "2.001", "3.1415")
BUILDS = ("gcc", "-O1"), ("clang", "-O1", "-march=native")


def _exactly(a: Argument, number: int, theta: mpmath.mpf) -> list[mpmath.mpf]:
    """An argument's components in 60 digits, for this angle; the second displacement or quaternion
    is turned further than the first."""
    axis = mpmath.matrix([3, -5 + number, 7])
    v = axis * (theta / norm(axis))
    turned = v if number == 0 or a.quantity.size < 4 else v * mpmath.mpf("1.75")
    lever = [mpmath.mpf(x) / 3 for x in (2, -1 - number, 5)]
    R = exponential_series(skew(turned))
    return list({"vec3": lambda: v / theta if a.name == "axis" else v,
                 "scalar": lambda: [mpmath.mpf("0.375") if a.name == "k" else theta],
                 "mat3x3": lambda: R, "SE3": lambda: hstack(R, mpmath.matrix(lever)),
                 "screw": lambda: [*lever, *v],
                 "quaternion": lambda: quaternion_exp(turned)}[a.quantity.name]())


CONVERSIONS = tuple(op for op in FUNCTIONS if op.normwise)


@for_all(operation=CONVERSIONS)
def test_formulas_have_twice_the_digits(operation: Operation):
    """In 60 digits they are right to 2^-97 of the largest component, at angles around those where
    series end."""
    with mpmath.workdps(DIGITS):
        for angle in ANGLES:
            given = [x for n, a in enumerate(operation.inputs)
                     for x in _exactly(a, n, mpmath.mpf(angle))]
            wanted = truth(operation, DOUBLE, tuple(given))
            result = by_formula(operation, given)
            largest = max(map(abs, (*wanted, *given)))
            for x, true in zip(result, wanted, strict=True):
                assert abs(x - true) <= largest * mpmath.mpf(2)**-97, (angle, float(x))


@for_all(operation=FUNCTIONS, precision=(DOUBLE, SINGLE))
def test_components_are_right_as_long_as_their_condition_is_good(operation: Operation,
                                                                 precision: Precision):
    result = judged(operation, precision, hard_rows(operation, precision))
    kept = promised(result, precision)
    assert len(kept) > len(result) / 3
    assert not beyond(kept, precision)


@for_all(precision=(DOUBLE, SINGLE))
def test_what_is_wrong_is_told(precision: Precision):
    """An error of a unit is, unless the condition is bad or -π came for π."""
    third, pi, unit = mpmath.mpf(1) / 3, +mpmath.pi, np.finfo(precision.numpy_type).eps
    largest = LARGEST_CONDITION[precision.name]

    def wrong(result: float, true: mpmath.mpf, condition: float = 1.0) -> bool:
        rounded = float(np.asarray(result, precision.numpy_type))
        return bool(beyond(promised([Result(0, rounded, true, condition)], precision), precision))

    assert not wrong(1 / 3, third) and wrong(1 / 3 + unit / 2, third)
    assert wrong(0.5, third, 0.99 * largest) and not wrong(0.5, third, largest)
    assert not wrong(-np.pi, pi) and wrong(-np.pi + 4 * unit, pi) and wrong(-1 / 3, third)


NEAR_ZEROS = {(c.operation, c.precision) for c in load() if c.origin.startswith(ORIGIN)}


@pytest.mark.parametrize("operation, precision", sorted(
    NEAR_ZEROS, key=lambda x: (x[0].name, x[1].name)), ids=lambda x: x.name)
def test_conditions_just_below_the_limit_are_judged(operation: Operation, precision: Precision):
    largest = LARGEST_CONDITION[precision.name]
    result = condition(operation, hard_rows(operation, precision))
    assert ((largest / RANGE < result) & (result < largest)).sum() >= KEPT


def test_most_operations_have_components_near_zeros():
    """Others are exact functions of the given numbers, and have no condition."""
    assert len(NEAR_ZEROS) > len(FUNCTIONS)


@for_all(operation=FUNCTIONS, precision=(DOUBLE, SINGLE))
def test_c_gufunc_and_numpy_agree_in_bits(operation: Operation, precision: Precision,
                                          libraries: list[ctypes.CDLL]):
    """The twins, gufuncs, C without and with an fma instruction agree for numbers of all kinds."""
    drawn = split(operation, hard_rows(operation, precision))
    inputs = tuple(map(np.concatenate, zip(drawn, inputs_of(operation, precision, EXTREMES),
                                           strict=True)))
    want = twin(coscrew.accurate)(operation, precision, inputs)
    with np.errstate(all="ignore"):
        assert same_bits(gufuncs(coscrew.accurate)(operation, precision, inputs), want), "gufunc"
    for library in libraries:
        assert same_bits(call(library, operation, precision, inputs), want), library


@pytest.fixture(scope="module")
def libraries(tmp_path_factory: pytest.TempPathFactory) -> list[ctypes.CDLL]:
    """C of all these operations, compiled."""
    folder = tmp_path_factory.mktemp("functions")
    return [harness(folder, compiler, (*flags, EXACT), "accurate", FUNCTIONS)
            for compiler, *flags in BUILDS if compiler in COMPILERS]


def test_steps_of_a_program_and_of_its_compensation_have_different_names():
    """The names of residuals end in _rest."""
    x, y = Input(0, 0), Input(1, 0)
    steps = (Instruction("r_rest", Op.ADD, (x, y), "r"),
             Instruction("r", Op.DIV, (Ref("r_rest"), y), "r"))
    program = Program("f", tuple(Argument(name, SCALAR) for name in "xy"),
                      (Argument("r", SCALAR),), steps, (Ref("r"),))
    with pytest.raises(ValueError, match="^f: rename 'r_rest', as its compensation is named$"):
        accurate(program)


@each_precision
def test_any_rotation_vector_gives_a_rotation(precision: Precision):
    """Subnormal and the largest angles are included; beyond 2^50, sine and cosine of an angle's
    rest err as in the plain tier."""
    info = np.finfo(precision.numpy_type)
    sizes = np.geomspace(float(info.tiny), float(info.max) / 2, 400, dtype=precision.numpy_type)
    sizes = np.append(sizes, np.array([info.smallest_subnormal, 1e3 * info.smallest_subnormal],
                                      precision.numpy_type))
    v = sizes[:, None] * np.array([0.3, -0.5, 0.7], precision.numpy_type)
    R = coscrew.accurate.SO3_exp(v).astype(np.longdouble)
    q = coscrew.accurate.quaternion_exp(v).astype(np.longdouble)
    allowed = np.where(sizes < 1e15, 8, 64) * 2.0**-precision.digits
    assert (np.abs(R.swapaxes(1, 2) @ R - np.eye(3)).max(axis=(1, 2)) <= allowed).all()
    assert (np.abs((q * q).sum(axis=1) - 1) <= allowed).all()
    small = sizes < 1e-30
    assert (R[small, 1, 0] == v[small, 2]).all() and (q[small, 3] == 1).all()
