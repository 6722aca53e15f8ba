"""Bounds of operations on rotations are infinite where a matrix is no rotation."""

import numpy as np
import pytest

import coscrew.certified
from coscrew_codegen.formats import Precision
from coscrew_codegen.operations import OPERATIONS, Operation
from coscrew_codegen.programs import program_of
from coscrew_codegen.quantity import DISPLACEMENT, ROTATION
from coscrew_codegen.tiers import tier_named
from coscrew_codegen.tiers.tier import is_polynomial
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
            found = twin(x)[count:]
        in_c = call(library, CERTIFIED.operation(operation), precision, [x[None]])[count:]
        for a, b in zip(found, in_c, strict=True):
            assert np.array_equal(a, b[0], equal_nan=True)
        return [float(b) for bound in found for b in np.ravel(bound)]

    assert all(map(np.isfinite, bounds(coscrew.SO3_exp([0.3, -0.2, 0.5]))))
    assert all(map(np.isfinite, bounds(np.round(coscrew.SO3_exp([0.3, -0.2, 0.5]), 4))))
    for R in (*NO_ROTATIONS.values(), np.full((3, 3), np.nan)):
        assert not any(map(np.isfinite, bounds(R))), R
