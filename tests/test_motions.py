"""Exponentials, logarithms, Jacobians, quaternions: as accurate as stated, for every rotation."""

from collections.abc import Callable
from functools import cache
from pathlib import Path

import mpmath as mp
import numpy as np
import pytest

import coscrew
from coscrew_codegen.operations import OPERATIONS, Operation
from coscrew_codegen.targets.precision import PRECISIONS, Precision
from tests.c_harness import COMPILERS, EXACT, call, harness
from tests.motion_inputs import motions_of
from tests.motions import DIGITS, TRUTHS, alternatives

ROWS = 100
MOTIONS = tuple(op for op in OPERATIONS if op.name in TRUTHS)
Arrays = tuple[np.ndarray, ...]

IMPLEMENTATIONS = ("gufunc", "C", "twin")


@cache
def inputs(operation: Operation, precision: Precision) -> Arrays:
    return motions_of(operation, precision, ROWS)


@cache
def truths(operation: Operation, precision: Precision) -> list[list[list[np.ndarray]]]:
    """What the operation should return for each row: alternatives, each an array per output."""
    rounding = 16 * unit(precision)
    with mp.workdps(DIGITS):
        found = (TRUTHS[operation.name](*map(multiprecise, row))
                 for row in zip(*inputs(operation, precision), strict=True))
        return [[as_arrays(x) for x in alternatives(operation.name, truth, rounding)]
                for truth in found]


def unit(precision: Precision) -> mp.mpf:
    """u, the unit roundoff."""
    return mp.mpf(float(np.finfo(precision.numpy_type).eps)) / 2


def multiprecise(x: np.ndarray) -> mp.matrix | mp.mpf:
    """The numbers as they are."""
    x = np.asarray(x, float)
    return mp.matrix(x.tolist()) if x.ndim else mp.mpf(float(x))


def as_arrays(value: mp.matrix | mp.mpf | tuple) -> list[np.ndarray]:
    values = value if isinstance(value, tuple) else (value,)
    return [np.array(v.tolist() if isinstance(v, mp.matrix) else [[v]], dtype=object)
            for v in values]


def errors(operation: Operation, given: list[np.ndarray], found: list[np.ndarray],
           truth: list[np.ndarray]) -> dict[str, mp.mpf]:
    """Of each part that has a bound, the largest error as a part of its largest component, in the
    output or an input of its kind."""
    result = {}
    for output, x, t in zip(operation.outputs, found, truth, strict=True):
        x = np.array(np.asarray(x, float).reshape(t.shape).tolist(), dtype=object) * mp.mpf(1)
        alike = [g.reshape(t.shape) for a, g in zip(operation.inputs, given, strict=True)
                 if a.quantity == output.quantity]
        for part in output.quantity.parts:
            name = part.name if part.name in dict(operation.normwise) else output.name
            inside = np.ix_(part.rows, part.columns) if name == part.name else ...
            size = max(abs(c) for y in (t, *alike) for c in np.ravel(y[inside]))
            error = max(map(abs, np.ravel((x - t)[inside])))
            result[name] = error / mp.mpf(size) if size else (mp.inf if error else mp.mpf(0))
    return result


def least_errors(operation: Operation, given: list[np.ndarray], found: list[np.ndarray],
                 alternatives: list[list[np.ndarray]]) -> dict[str, mp.mpf]:
    return min((errors(operation, given, found, truth) for truth in alternatives),
               key=lambda x: max(x.values()))
