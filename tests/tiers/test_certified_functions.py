"""Operations that call elementary functions, in the certified tier: results are plain's, bit for
bit, and every bound holds, against 60 digits, on the committed cases and on drawn ones; the same
bits in C, gufuncs and NumPy.
"""

import ctypes

import numpy as np
import pytest

import coscrew
import coscrew.certified
from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.program.ops import ERROR_OF
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE, Precision
from tests.functions_attack import FUNCTIONS, attacked
from tests.search import joined, split
from tests.support.cases import for_all
from tests.support.compiled.c_harness import COMPILERS, EXACT, call, harness
from tests.support.compiled.implementations import gufuncs, same_bits, twin
from tests.support.hard_rows import EXTREMES, hard_rows
from tests.support.sampling import inputs_of
from tests.support.truth.attack import plain_program
from tests.support.truth.judge import in_bounds

CERTIFIED = tier_named("certified")
CALLING = tuple(op for op in OPERATIONS if ERROR_OF.keys() & plain_program(op).counts.keys())
OF_VECTORS = tuple(op for op in FUNCTIONS if op.name in (
    "SO3_exp", "SO3_leftJacobian", "SO3_rightJacobian", "SO3_leftJacobianInverse",
    "SO3_rightJacobianInverse", "SE3_exp", "quaternion_exp"))
TIGHT = {"double": 1.0001, "single": 7.3}
"""Half of the bounds are at most so many times the error."""
BUILDS = ("gcc", "-O1"), ("clang", "-O1", "-march=native")


def test_quaternions_exponentials_logarithms_and_angles_have_the_tier():
    """For those without it, some bounds would take more than two thousand operations."""
    assert {op.name for op in CALLING} - {op.name for op in FUNCTIONS} == {
        "quaternion_interpolated", "SE3_interpolated", "SE3_leftJacobian", "SE3_rightJacobian",
        "SE3_leftJacobianInverse", "SE3_rightJacobianInverse"}


@for_all(operation=FUNCTIONS, precision=(DOUBLE, SINGLE))
def test_every_bound_holds(operation: Operation, precision: Precision):
    given, result, stated = hard_rows(operation, precision), [], 0
    results = joined(gufuncs(coscrew.certified)(operation, precision, split(operation, given)))
    plain = joined(gufuncs(coscrew)(operation, precision, split(operation, given)))
    half = plain.shape[1]
    assert same_bits((np.ascontiguousarray(results[:, :half]),), (plain,))
    for row, got in zip(given.tolist(), results.tolist(), strict=True):
        ratios = in_bounds(operation, precision, row, got[:half], got[half:])
        stated += len(ratios)
        result += [x for x in ratios if x]
    assert max(result, default=0) <= 1
    assert stated > 0.4 * results[:, :half].size
    assert np.median(result) > 1 / TIGHT[precision.name]


@for_all(operation=FUNCTIONS, precision=(DOUBLE, SINGLE))
def test_bounds_hold_at_all_sizes_and_where_series_end(operation: Operation, precision: Precision):
    result = attacked(operation, precision, 200, seed=1)
    assert not result.broken and result.outputs > 2 * result.silent


@for_all(operation=OF_VECTORS, precision=(DOUBLE, SINGLE))
def test_small_rotations_have_bounds(operation: Operation, precision: Precision):
    """Down to none: of at most 4 u of the largest component, and 32 where series end."""
    kind = np.dtype(precision.numpy_type)
    tiny = np.geomspace(np.finfo(kind).smallest_subnormal, 0.25, 400)
    angles = np.array([0, *tiny, *2.0**-25 * (1 + np.finfo(kind).eps * np.arange(-4, 5))])
    given = np.outer(angles, [0.6, 0, -0.8])
    if operation.name == "SE3_exp":
        given = np.hstack([np.tile([1.0, -2, 3], (angles.size, 1)), given])
    results = joined(gufuncs(coscrew.certified)(
        operation, precision, split(operation, given.astype(kind))))
    plain, bounds = np.hsplit(results, 2)
    most = np.where(abs(angles - 2.0**-25) < 1e-12, 32, 4) * precision.u
    close = bounds.max(axis=1) <= most * abs(plain).max(axis=1)
    grows = precision == SINGLE and operation.name not in ("SO3_exp", "quaternion_exp")
    assert np.all(close | (grows & (angles >= 2.0**-25 * (1 - 1e-6))))


@pytest.mark.filterwarnings("error")
def test_no_statement_is_no_warning():
    """Neither gufuncs nor NumPy warn where nothing is certain or numbers overflow."""
    for module in (coscrew.certified, coscrew.certified.double):
        for results in (module.SO3_log(np.eye(3)), module.quaternion_log([0.0, 0, 0, 1]),
                        module.angle_vv([1.0, 0, 0], [2.0, 0, 0]),
                        module.dot_vv([1e200, 0, 0], [1e200, 0, 0])):
            assert not np.isfinite(results[1]).any()


@for_all(operation=FUNCTIONS, precision=(DOUBLE, SINGLE))
def test_c_gufunc_and_numpy_agree_in_bits(operation: Operation, precision: Precision,
                                          libraries: list[ctypes.CDLL]):
    """The twins, gufuncs, C without and with an fma instruction agree for numbers of all kinds."""
    drawn = split(operation, hard_rows(operation, precision))
    inputs = tuple(map(np.concatenate, zip(drawn, inputs_of(operation, precision, EXTREMES),
                                           strict=True)))
    want = twin(coscrew.certified)(operation, precision, inputs)
    assert same_bits(gufuncs(coscrew.certified)(operation, precision, inputs), want), "gufunc"
    for library in libraries:
        result = call(library, CERTIFIED.operation(operation), precision, inputs)
        assert same_bits(result, want), library


@pytest.fixture(scope="module")
def libraries(tmp_path_factory: pytest.TempPathFactory) -> list[ctypes.CDLL]:
    """C of all these operations, compiled."""
    folder = tmp_path_factory.mktemp("functions")
    return [harness(folder, compiler, (*flags, EXACT), "certified",
                    tuple(map(CERTIFIED.operation, FUNCTIONS)))
            for compiler, *flags in BUILDS if compiler in COMPILERS]
