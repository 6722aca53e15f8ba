"""Functions accept matrices as rotations, and quaternions as those of length 1, exactly where the
predicates are true."""

from collections.abc import Callable
from importlib import import_module
from types import ModuleType

import numpy as np
import pytest

import coscrew
from coscrew_codegen.accuracy.tiers import TIERS
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.quantity import TOLERANCE
from tests.support.each import each_precision

PACKAGES = tuple(import_module(f"{tier.package}{module}") for tier in TIERS
                 for module in ("", "._dispatch"))
in_each_package = pytest.mark.parametrize("package", PACKAGES, ids=lambda x: x.__name__)
COUNT = 200
MOST = float(TOLERANCE)


def at_the_tolerance(defect: Callable[[np.ndarray], np.ndarray], exact: np.ndarray,
                     precision: Precision, seed: int) -> np.ndarray:
    """These, moved in random directions to either side of the tolerance, as near as doubles are;
    rounded."""
    off = np.random.default_rng(seed).normal(size=exact.shape)
    low = np.zeros((len(exact), *np.ones(exact.ndim - 1, int)))
    high = low + 10 * MOST
    for _ in range(60):
        middle = (low + high) / 2
        within = np.reshape(np.abs(defect(exact + middle * off)) <= MOST, low.shape)
        low, high = np.where(within, middle, low), np.where(within, high, middle)
    low[::2] = high[::2]
    return (exact + low * off).astype(precision.numpy_type)


def matrices(precision: Precision) -> np.ndarray:
    R = coscrew.SO3_exp(np.random.default_rng(1).normal(size=(COUNT, 3)))
    return at_the_tolerance(coscrew.double.mat3x3_rotation_defect, R, precision, 2)


def quaternions(precision: Precision) -> np.ndarray:
    q = coscrew.quaternion_exp(np.random.default_rng(3).normal(size=(COUNT, 3)))
    return at_the_tolerance(coscrew.double.quaternion_unit_defect, q, precision, 4)


def accepts(function: Callable[..., object], *given: np.ndarray) -> bool:
    try:
        function(*given)
    except ValueError as error:
        assert " is no " in str(error)
        return False
    return True


def check(function: Callable[..., object], given: np.ndarray, wanted: np.ndarray,
          *more: np.ndarray) -> None:
    """Checks faults one by one, all together and in pairs, and right files."""
    assert COUNT / 10 < wanted.sum() < COUNT * 9 / 10  # else they are not at the tolerance
    assert [accepts(function, x, *more) for x in given] == wanted.tolist()
    for two, both in zip(given.reshape(-1, 2, *given.shape[1:]), wanted.reshape(-1, 2),
                         strict=True):
        assert accepts(function, two, *more) == both.all()
    with pytest.raises(ValueError, match=rf"element \({np.argmin(wanted)},\) of"):
        function(given, *more)
    assert accepts(function, given[wanted], *more)
    assert accepts(function, given[wanted][::-2], *more)


@each_precision
@in_each_package
def test_matrices(package: ModuleType, precision: Precision):
    R = matrices(precision)
    wanted = coscrew.mat3x3_is_rotation(R)
    check(package.SO3_log, R, wanted)
    check(package.SO3_log, np.asfortranarray(R), wanted)
    t = np.ones((COUNT, 3, 1), R.dtype)
    check(package.SE3_log, np.concatenate([R, t], axis=2), wanted)


@each_precision
@in_each_package
def test_quaternions(package: ModuleType, precision: Precision):
    q = quaternions(precision)
    check(package.rotate_qv, q, coscrew.quaternion_is_unit(q), np.ones(3, q.dtype))


@each_precision
def test_bounds_are_finite_where_the_predicate_is_true(precision: Precision):
    R = matrices(precision)
    for log in (coscrew.unchecked(coscrew.certified.SO3_log),
                getattr(coscrew.certified, precision.name).SO3_log):
        _, bound = log(R)
        assert np.array_equal(np.isfinite(bound).all(axis=1), coscrew.mat3x3_is_rotation(R))


@each_precision
@in_each_package
def test_matrices_whose_defect_overflows_are_refused(package: ModuleType, precision: Precision):
    """Their determinant may be inf - inf; only where an entry is NaN, so is the result."""
    huge = np.finfo(precision.numpy_type).max / 1e3
    A = (huge * np.random.default_rng(5).normal(size=(COUNT, 3, 3))).astype(precision.numpy_type)
    sheared = np.eye(3, dtype=A.dtype)
    sheared[0, 1] = np.inf
    with np.errstate(all="ignore"):
        assert np.isnan(coscrew.mat3x3_rotation_defect(A)).any()
        for R in (*A, sheared):
            assert not accepts(package.SO3_log, R) and not coscrew.mat3x3_is_rotation(R)
            R[0, 0] = np.nan
            assert accepts(package.SO3_log, R)
