"""Draws inputs from the domains of operations, and measures how far inputs are from these."""

import math
from collections.abc import Sequence

import numpy as np

from coscrew_codegen.algebra.domains import Free, anything, hard
from coscrew_codegen.algebra.exact import is_polynomial
from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.program.values.quantity import (
    DISPLACEMENT,
    ROTATION,
    TURN,
    UNIT_QUATERNION,
    UNIT_VECTOR,
)


def domains(operation: Operation) -> tuple[Free, ...]:
    """The functions that draw each input.  A polynomial takes any numbers, since its bound is
    proved for all."""
    return tuple(anything(a.quantity.size) if is_polynomial(operation) else hard(a)
                 for a in operation.inputs)


def angle(operation: Operation, given: Sequence[float]) -> float:
    """The angle of the input whose rotation vector may have any length; 0 if there is none."""
    start = 0
    for a in operation.inputs:
        numbers = given[start:start + a.quantity.size]
        if a.domain == TURN:
            return math.hypot(*numbers[-3:])
        start += a.quantity.size
    return 0.0


def defect(operation: Operation, given: Sequence[float]) -> float:
    """The defect of the rotations, unit quaternions and unit vectors among the inputs."""
    worst, start = 0.0, 0
    for a in operation.inputs:
        x = np.reshape(np.array(given[start:start + a.quantity.size], np.longdouble),
                       a.quantity.rows_columns)
        start += a.quantity.size
        if is_polynomial(operation):
            continue
        if a.domain in (ROTATION, DISPLACEMENT):
            worst = max(worst, np.abs(x[:, :3].T @ x[:, :3] - np.eye(3)).max())
        elif a.domain in (UNIT_VECTOR, UNIT_QUATERNION):
            worst = max(worst, abs((x * x).sum() - 1))
    return float(worst)
