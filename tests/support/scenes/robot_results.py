"""Results of a scene's functions at several states of a robot, and their distance from a peer's."""

import numpy as np

from coscrew_codegen.program import Program
from tests.support.scenes import evaluation

STATES = 4


def evaluated(program: Program, given: dict[str, np.ndarray]) -> np.ndarray:
    """The results of each state."""
    columns = evaluation.evaluator(program, evaluation.DOUBLE)(
        [list(given[a.name].T) for a in program.inputs])
    return np.stack([np.broadcast_to(np.asarray(y, float), STATES) for y in columns], -1)


def full(upper: np.ndarray) -> np.ndarray:
    """The symmetric matrix whose upper triangle this has."""
    return np.triu(upper) + np.triu(upper, 1).T


def apart(result: np.ndarray, wanted: np.ndarray) -> float:
    """The largest difference, relative to the largest number."""
    return float(np.abs(result - wanted).max() / np.abs(wanted).max())
