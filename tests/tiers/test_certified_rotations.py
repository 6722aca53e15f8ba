"""Bounds of operations on rotations are infinite where a matrix is no rotation."""

from itertools import permutations, product

import numpy as np
import pytest

import coscrew.certified
from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.accuracy.tiers.tier import is_polynomial
from coscrew_codegen.algebra.lowering.programs import program_of
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.quantity import DISPLACEMENT, ROTATION
from tests.support.compiled.c_harness import call, harness
from tests.support.each import each_precision
from tests.support.rotations import NO_ROTATIONS

CERTIFIED = tier_named("certified")
OF_ROTATIONS = tuple(op for op in OPERATIONS if op.inputs[0].domain in (ROTATION, DISPLACEMENT)
                     and CERTIFIED.has(program_of(op)) and not is_polynomial(program_of(op)))

def given(operation: Operation, R: np.ndarray) -> np.ndarray:
    return np.column_stack([R, [1, 2, 3]]) if operation.inputs[0].domain == DISPLACEMENT else R


def test_they_are_there():
    assert {op.name for op in OF_ROTATIONS} >= {"SO3_log", "SE3_log", "euler_xyz_from_mat3x3"}


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory):
    return harness(tmp_path_factory.mktemp("certified"), "gcc", ("-O2",), "certified",
                   tuple(map(CERTIFIED.operation, OF_ROTATIONS)))


@each_precision
@pytest.mark.parametrize("operation", OF_ROTATIONS, ids=lambda op: op.name)
def test_no_statement_is_made(operation: Operation, precision: Precision, library):
    twin = getattr(getattr(coscrew.certified, precision.name), operation.name)
    count = len(operation.outputs)

    def bounds(R: np.ndarray) -> list[float]:
        with np.errstate(all="ignore"):
            x = given(operation, R).astype(precision.numpy_type)
            result = twin(x)[count:]
        in_c = call(library, CERTIFIED.operation(operation), precision, [x[None]])[count:]
        for a, b in zip(result, in_c, strict=True):
            assert np.array_equal(a, b[0], equal_nan=True)
        return [float(b) for bound in result for b in np.ravel(bound)]

    assert all(map(np.isfinite, bounds(coscrew.SO3_exp([0.3, -0.2, 0.5]))))
    assert all(map(np.isfinite, bounds(np.round(coscrew.SO3_exp([0.3, -0.2, 0.5]), 4))))
    for R in (*NO_ROTATIONS.values(), np.full((3, 3), np.nan)):
        assert not any(map(np.isfinite, bounds(R))), R


def turns_of_a_cube() -> list[tuple[np.ndarray, int, np.ndarray]]:
    """The 24 rotations of a cube to itself, with angle in degrees and axis."""
    signed = [np.diag(signs) @ np.eye(3)[list(order)]
              for order in permutations(range(3)) for signs in product((1, -1), repeat=3)]
    results = []
    for R in signed:
        if np.linalg.det(R) > 0:
            angle = {3: 0, 1: 90, 0: 120, -1: 180}[round(np.trace(R))]
            axis = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
            results.append((R, angle, axis / max(1, np.linalg.norm(axis))))
    return results


@each_precision
@pytest.mark.parametrize("name", ["SO3_log", "SE3_log", "axis_angle_from_mat3x3"])
def test_right_rotations_have_bounds(name: str, precision: Precision):
    """All turns of a cube, but none and half ones, which have no axis and two."""
    operation = next(op for op in OF_ROTATIONS if op.name == name)
    twin, u = getattr(getattr(coscrew.certified, precision.name), name), float(precision.u)
    for R, angle, axis in turns_of_a_cube():
        with np.errstate(all="ignore"):
            result = twin(given(operation, R).astype(precision.numpy_type))
        values, bounds = (np.concatenate([np.ravel(x).astype(float) for x in part]) for part in (
            result[:len(operation.outputs)], result[len(operation.outputs):]))
        if angle not in (90, 120):
            assert not np.isfinite(bounds[-3:]).any()
            continue
        assert np.isfinite(bounds).all() and (bounds <= 64 * u).all()
        theta, K = np.radians(angle), coscrew.skew(axis)
        inverse = np.eye(3) - theta / 2 * K + (1 - theta / 2 / np.tan(theta / 2)) * K @ K
        wanted = {"SO3_log": theta * axis, "axis_angle_from_mat3x3": [theta, *axis],
                  "SE3_log": [*(inverse @ [1, 2, 3]), *(theta * axis)]}[name]
        assert (np.abs(values - wanted) <= bounds + 2.0**-50).all()
