"""Measurements of `coscrew report`: errors against independent arithmetic, times, drift, the JSON.
"""

import math
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np
import pytest
from gmpy2 import mpq

from coscrew_codegen.algebra.exact import truth, ulp
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.algebra.operations.operation import Normwise
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE, Precision
from coscrew_codegen.reports.kernels import (
    inputs,
    kernel_errors,
    kernel_library,
    kernel_measurement,
    ranking,
)
from coscrew_codegen.reports.kernels.c_text import Variant, last_component
from coscrew_codegen.reports.kernels.drift import deviations, drifts, power
from coscrew_codegen.reports.kernels.kernel_timing import Timed, python_function
from coscrew_codegen.reports.kernels.variants import variants_of
from coscrew_codegen.reports.timing.loop_timing import Timing
from tests.support.each import each_precision
from tests.support.truth.exact import FORMULAS

BY_NAME = {operation.name: operation for operation in OPERATIONS}
DIGITS = {"double": 53, "single": 24}
NAMES = ("product_CoAdc", "cross_sc", "dot_cs", "product_dd", "mat3x3_determinant", "vec3_swap")



def exactly(operation: Operation, rows: np.ndarray) -> list[list[Fraction]]:
    """The results by the published matrices, in fractions."""
    results = []
    for row in rows:
        arguments = [np.array(list(map(Fraction, map(float, x.ravel()))), object).reshape(
            a.quantity.shape)[()] for x, a in zip(inputs.split(operation, row[None]),
                                                  operation.inputs, strict=True)]
        values = FORMULAS[operation.name](*arguments)
        parts = values if isinstance(values, tuple) else (values,)
        results.append([x for part in parts for x in np.atleast_1d(part).ravel()])
    return results


def spacing(x: Fraction, precision: Precision) -> Fraction:
    """The distance of neighbouring numbers at x, by NumPy; x is rounded towards zero first."""
    near = np.dtype(precision.numpy_type).type(float(x))
    if abs(Fraction(float(near))) > abs(x):
        near = np.nextafter(near, type(near)(0))
    return Fraction(float(np.spacing(abs(near))))


@each_precision
@pytest.mark.parametrize("name", NAMES)
def test_truth_is_what_fractions_say(name: str, precision: Precision):
    operation = BY_NAME[name]
    rows = np.concatenate([draw(operation, precision, 30, 5)
                           for draw in (inputs.benign, inputs.hard)])
    result = truth(operation, precision, rows)
    for i, values in enumerate(exactly(operation, rows)):
        for j, x in enumerate(values):
            near, rest, unit = (Fraction(float(a[i, j]))
                                for a in (result.near, result.rest, result.unit))
            if x:
                assert unit == spacing(x, precision), (x, unit)
            assert abs(near + rest * unit - x) <= unit * abs(rest) / 2**52


def test_ulp_is_of_the_binade_a_number_lies_in():
    """This holds for numbers that are not binary fractions, next to powers of two, and subnormal,
    too."""
    third = mpq(1, 3**60)
    assert [ulp(x, DOUBLE) * 2**53 for x in (mpq(2, 3), mpq(1), 1 - third, 1 + third, -2 + third)] \
        == [1, 2, 1, 2, 2]
    assert ulp(mpq(1, 3 * 2**1030), DOUBLE) == ulp(mpq(0), DOUBLE) == mpq(1, 2**1074)
    assert ulp(mpq(1, 3 * 2**130), SINGLE) == mpq(1, 2**149)


@each_precision
def test_truth_of_a_norm_is_the_integer_root(precision: Precision):
    """floor(2^400 |v|) by integers lies where the report's truth does."""
    operation = BY_NAME["vec3_l2norm"]
    rows = inputs.hard(operation, precision, 40, 3)
    result = truth(operation, precision, rows)
    for row, near, rest, unit in zip(rows, result.near[:, 0], result.rest[:, 0], result.unit[:, 0],
                                     strict=True):
        square = sum(Fraction(float(x))**2 for x in row)
        root = Fraction(math.isqrt(square.numerator * 2**800 // square.denominator), 2**400)
        ours = Fraction(float(near)) + Fraction(float(rest)) * Fraction(float(unit))
        assert abs(ours - root) <= Fraction(float(unit)) / 2**50


@each_precision
def test_a_wrong_kernel_shows_its_error(precision: Precision):
    """A result three numbers above the nearest one has an error of 2.5 to 3.5 ulp, by fractions."""
    operation = BY_NAME["cross_sc"]
    (plain, *_) = variants_of(operation, precision)
    benign, hard = kernel_errors.samples(operation, precision, 60, 2)
    results: list[np.ndarray] = []

    def wrong(variant: Variant, arguments: tuple[np.ndarray, ...]) -> tuple[np.ndarray, ...]:
        exact = benign if len(results) == 0 else hard
        x = exact.truth.near.astype(precision.numpy_type)
        for _ in range(3):
            x = np.nextafter(x, x.dtype.type(np.inf))
        results.append(x)
        return (x,)

    result = kernel_errors.accuracy(operation, plain, benign, hard, wrong)
    values = exactly(operation, benign.rows)
    counted = [abs(Fraction(float(r)) - x) / spacing(x, precision) for row, got in
               zip(values, results[0], strict=True) for r, x in zip(got, row, strict=True)]
    assert result.benign.worst == pytest.approx(float(max(counted)), rel=1e-12)
    assert 2.5 <= result.benign.median <= result.benign.worst <= 6.5  # twice beside a power of two
    assert result.bound.worst_ratio > 1
    witness = [float.fromhex(x) for x in result.benign.witness]
    assert witness in benign.rows.astype(float).tolist()


def counted_of(name: str, rows: list[list[float]],
               results: list[list[float]]) -> tuple[int, float]:
    """The number of these results that the report counts, and their worst error."""
    operation = BY_NAME[name]
    plain, *_ = variants_of(operation, DOUBLE)
    inputs_ = np.array(rows)
    sample = kernel_errors.InputSample(inputs_, truth(operation, DOUBLE, inputs_))
    sizes = np.cumsum([a.quantity.size for a in operation.outputs])[:-1]
    outputs = tuple(np.split(np.array(results), sizes, axis=1))
    result = kernel_errors.accuracy(operation, plain, sample, sample, lambda *_: outputs)
    return (result.benign.outputs, result.benign.worst) if result.benign else (0, 0.0)


NAN, INF = math.nan, math.inf
REGULAR, SINGULAR = [2.0, 0, 0, 0, 4, 0, 0, 0, 8, 2, 4, 8], [1.0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 2, 3]


def test_a_row_without_truth_is_not_counted():
    """1 / 0 v, and a singular system, whatever the result is."""
    assert counted_of("product_ainvv", [[0.0, 1, 2, 3], [2.0, 2, 4, 6]],
                      [[INF, INF, 7], [1, 2, 3]]) == (3, 0)
    assert counted_of("mat3x3_solve", [SINGULAR, REGULAR], [[0.0, 9, 9, 9], [1, 1, 1, 1]]) == (4, 0)


def test_a_refusal_is_not_counted_but_garbage_is():
    assert counted_of("mat3x3_solve", [REGULAR], [[1.0, NAN, NAN, NAN]]) == (1, 0)
    assert counted_of("mat3x3_solve", [REGULAR], [[1.0, 1, 1, 2]])[1] == 2.0**52
    assert counted_of("mat3x3_solve", [REGULAR], [[1.0, 1, 1, INF]])[1] == INF
    assert counted_of("dot_vv", [[1.0] * 6], [[NAN]]) == (1, INF)  # it refuses nothing


def test_what_overflows_is_not_counted_but_garbage_is():
    large, ordinary = [1e200] * 6, [1.0] * 6
    assert counted_of("dot_vv", [large, ordinary], [[INF], [3]]) == (1, 0)
    assert counted_of("dot_vv", [[1e200, 0, 0, 1e200, 0, 0]], [[7.0]]) == (1, INF)
    assert counted_of("dot_vv", [[1e300, 0, 0, 1e3, 0, 0]], [[1e303 * (1 - 2**-50)]])[1] > 1
    assert counted_of("dot_vv", [ordinary], [[INF]]) == (1, INF)
    # -1e200² + 1e200² + 1 is 1, but not in numbers that overflow on the way.
    vanishing = [1e200, 1e200, 1, -1e200, 1e200, 1]
    assert counted_of("dot_vv", [vanishing], [[NAN]]) == (0, 0)
    assert counted_of("vec3_l2norm", [[1e308, 1e308, 1e308]], [[INF]]) == (1, INF)  # 1.7e308 it is
    assert counted_of("vec3_l2norm", [[1.7e308, 1.7e308, 0]], [[INF]]) == (0, 0)


def test_quantiles_of_known_errors():
    operation = BY_NAME["dot_cs"]
    rows = np.arange(12000.0).reshape(1000, 12)
    known = np.random.default_rng(1).permutation(np.arange(1.0, 1001.0))[:, None]
    result = kernel_errors.summarised(operation, rows, known, np.ones_like(known, bool))
    assert (result.outputs, result.worst, result.p999, result.median) == (1000, 1000, 999, 500)
    worst = int(np.argmax(known))
    assert result.witness == tuple(float(x).hex() for x in rows[worst])
    half = kernel_errors.summarised(operation, rows, known, known <= 500)
    assert (half.outputs, half.worst) == (500, 500)
    assert kernel_errors.summarised(operation, rows, known, known > 1000) is None


@pytest.mark.parametrize("named", [("lin", "ang"), ("co",)])
def test_normwise_errors_are_relative_to_the_largest_component(named: tuple[str, ...]):
    """The component is the largest of the part, or of the output, as the operation states."""
    plain = BY_NAME["cross_sc"]
    operation = replace(plain, normwise=tuple(Normwise(name, 3) for name in named))
    rows = inputs.benign(operation, DOUBLE, 20, 4)
    units = truth(operation, DOUBLE, rows).unit
    size = 6 // len(named)
    for values, unit in zip(exactly(plain, rows), units, strict=True):
        for part in (slice(0, size), slice(6 - size, 6)):
            largest = max(map(abs, values[part])) / 2**53
            assert unit[part].tolist() == [float(largest)] * size


@each_precision
def test_the_same_seed_gives_the_same_errors(precision: Precision):
    task = kernel_measurement.Task("product_dv", precision, 50, 3, (), None)
    assert task.run() == task.run()
    assert task.run() != replace(task, seed=4).run()


@each_precision
def test_compiled_kernels_give_the_packages_bits(precision: Precision, tmp_path: Path):
    """With both compilers, and for whole arrays: rows and columns of matrices are not exchanged."""
    names = ("product_dd", "product_drdrx", "SE3_invert", "coscrew_to_angular_first", "dot_cs")
    variants = [v for name in names for v in variants_of(BY_NAME[name], precision)]
    for library in kernel_library.libraries(variants, kernel_library.compilers(tmp_path), tmp_path):
        for v in filter(python_function, variants):
            arguments = inputs.split(v.operation, inputs.benign(v.operation, precision, 9, 1))
            result = python_function(v)(*arguments)
            want = result if isinstance(result, tuple) else (result,)
            for x, y in zip(library.call(v, arguments), want, strict=True):
                assert np.ascontiguousarray(x).tobytes() == y.tobytes(), (v.name, library.compiler)


def test_a_chain_of_calls_waits_for_each(tmp_path: Path):
    """A call that waits for the one before takes longer than one of many independent calls."""
    moved = variants_of(BY_NAME["product_CoAdc"], DOUBLE)[0].program
    assert last_component(moved) >= 3  # the moment, t × (R f) + R τ
    plain = variants_of(BY_NAME["dot_cs"], DOUBLE)[0]
    (compiler, *_) = kernel_library.compilers(tmp_path)
    (library,) = kernel_library.libraries([plain], [compiler], tmp_path)
    arguments = inputs.split(plain.operation, inputs.benign(plain.operation, DOUBLE, 256, 1))
    chain, rows, planes = (library.times([plain], loop, [arguments], 2e7)[0].minimum
                           for loop in ("chain", "rows", "planes"))
    assert chain > 2 * rows > 0 and chain > 2 * planes > 0


def test_dominated_is_slower_and_no_better_with_intervals_apart():
    variants = variants_of(BY_NAME["dot_cs"], DOUBLE)
    keys = [("dot_cs", "double", tier) for tier in ("plain", "accurate", "certified")]
    spread = np.linspace(0.9, 1.1, 25)  # its interval is about ±4 %

    def verdicts(ns: tuple[float, ...], worst: tuple[float, ...]) -> list[tuple[float, bool]]:
        timed = [[Timed(v, "C", "gcc", "latency", Timing(t * spread)) for v, t in
                  zip(variants, ns, strict=False)]]
        result = ranking.times(timed, dict(zip(keys, worst, strict=False)))
        return [(round(result[k][0].ratio, 9), result[k][0].dominated) for k in keys[:len(ns)]]

    assert verdicts((2, 1), (9, 8)) == [(1, True), (0.5, False)]
    assert verdicts((1, 2), (9, 8)) == [(1, False), (2, False)]
    assert verdicts((1, 2), (9, 9)) == [(1, False), (2, True)]
    assert verdicts((1, 1, 1), (5, 5, 5)) == [(1, False)] * 3
    assert verdicts((1, 3, 4), (9, 1, 9))[1:] == [(3, False), (4, False)]  # certified alone
    assert verdicts((1, 1.05), (5, 5)) == [(1, False), (1.05, False)]  # intervals overlap
    assert verdicts((1, 1.2), (5, 5)) == [(1, False), (1.2, True)]


def test_a_ratio_is_taken_round_by_round():
    """A machine that becomes half as fast after some rounds slows both: the ratio stays."""
    slow = np.repeat([1.0, 2.0], 20)
    noisy = slow * np.linspace(1.99, 2.01, 40)
    ratio = Timing(noisy).ratio(Timing(slow))
    assert 1.99 < ratio.low < ratio.median < ratio.high < 2.01
    assert Timing(slow).time.low == 1 and Timing(slow).time.high == 2


def test_power_and_deviations_of_a_quarter_turn():
    """Four quarter turns about z with a step along z are the identity, four steps up."""
    E = np.array([[0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0.25]])
    motion = power(E, 4 * 10**6 + 1)
    assert motion[:3, :3] == mpmath.matrix(E[:, :3].tolist())
    assert motion[2, 3] == mpmath.mpf(10**6) + mpmath.mpf("0.25")
    D = np.array(motion[:3, :].tolist(), float)
    assert deviations(D, motion) == (0, 0)
    D[1, 0] = 1 + 2**-20
    assert deviations(D, motion) == (2**-19 + 2**-40, 2**-20)


def test_newton_steps_hold_the_defect(tmp_path: Path):
    (compiler, *_) = kernel_library.compilers(tmp_path)
    (library,) = kernel_library.libraries([], [compiler], tmp_path)
    results = {(d.precision, d.orthonormalised): d for d in drifts(library, 20_000)}
    for precision in DIGITS:
        without, held = results[precision, False], results[precision, True]
        assert held.defect_u <= 8 < 100 < without.defect_u
        assert held.error_u < without.error_u
        assert held.ns_per_step > 0


def test_hard_cases_are_measured(tmp_path: Path):
    """One line is tried besides the random inputs: with e = 2^-12, (1 + e) (1 + 3 e) - (1 + 4 e) is
    3 e^2; the product is rounded to 1 + 4 e + 4 e^2, an error of e^2, which is 2^22 spacings of 3
    e^2."""
    (tmp_path / "vec3.txt").write_text(
        "# a remark\ndot_vv single : 0x1.001p0 1 0 0x1.003p0 -0x1.004p0 0 : by hand\n")
    cases = inputs.corpus(tmp_path)
    row = (1 + 2**-12, 1.0, 0.0, 1 + 3 * 2**-12, -1 - 2**-10, 0.0)
    assert cases == {("dot_vv", "single"): (row,)}
    task = kernel_measurement.Task("dot_vv", SINGLE, 8, 1, cases["dot_vv", "single"], None)
    result = task.run()["dot_vv", "single", "plain"]
    assert result.hard.worst == 2**22
    assert result.hard.witness == tuple(x.hex() for x in row)
