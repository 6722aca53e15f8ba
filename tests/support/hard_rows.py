"""Inputs of operations beyond polynomials: the committed cases and some that are drawn."""

import numpy as np

from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.program.values.formats import Precision
from tests.hard_cases.corpus import load
from tests.support.domains import domains

DRAWN = 12
EXTREMES = 100
_CASES = load()


def hard_rows(operation: Operation, precision: Precision) -> np.ndarray:
    """A call's components a row."""
    kind = np.dtype(precision.numpy_type)
    rng = np.random.default_rng([len(operation.name), precision.bytes])
    drawn = np.hstack([d.inputs(d.draw(rng, DRAWN, kind).astype(kind).astype(float))
                       for d in domains(operation)])
    kept = [c.inputs for c in _CASES if c.operation == operation and c.precision == precision]
    return np.vstack([drawn, *(np.array([x]) for x in kept)]).astype(kind)
