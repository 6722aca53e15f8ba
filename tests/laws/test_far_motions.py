"""Translations and velocities up to the limits where comments say that nothing overflows, and
beyond."""

import mpmath as mp
import numpy as np
import pytest

import coscrew
from coscrew_codegen.algebra.operations.exponential import FAR
from coscrew_codegen.program.values.formats import DOUBLE, PRECISIONS, Precision
from tests.hard_cases.corpus import TABLE
from tests.support.each import each_precision
from tests.support.motion_inputs import axes, motions_of
from tests.support.truth import judge

NAMES = tuple(op.name for op in TABLE.values() if "may overflow" in op.tested_bounds)
ROWS, JUDGED = 400, 6
SHORTER = 2.0**-900

each_name = pytest.mark.parametrize("name", NAMES)


def far(name: str, precision: Precision) -> tuple[np.ndarray, ...]:
    """Motions by all sizes of angles, with the longest allowed vectors, along an axis or in any
    direction."""
    rng, length = np.random.default_rng(9), float(FAR[PRECISIONS.index(precision)])
    inputs = motions_of(TABLE[name], precision, ROWS)
    for x in inputs:
        along = axes(rng, len(x)).astype(float) * length
        if x.ndim == 3:
            x[:, :, 3] = along * (1 - 2.0**-10)
        elif x.ndim == 2:
            turned = np.linalg.norm(x[:, 3:].astype(float), axis=1, keepdims=True)
            x[:, :3] = along / np.maximum(1, turned if name == "SE3_exp" else 1) * (1 - 2.0**-10)
    return inputs


def outputs(name: str, inputs: tuple[np.ndarray, ...]) -> np.ndarray:
    """Each row's components."""
    with np.errstate(all="ignore"):
        result = getattr(coscrew, name)(*inputs)
    return np.asarray(result).reshape(len(inputs[0]), -1)


def test_everything_that_has_lengths_says_so():
    assert set(NAMES) == {"SE3_exp", "SE3_log", "SE3_interpolated",
                          *(f"SE3_{side}Jacobian{inverse}" for side in ("left", "right")
                            for inverse in ("", "Inverse"))}


@each_name
@each_precision
def test_nothing_overflows_up_to_there(name, precision):
    """Errors are as stated there."""
    inputs = far(name, precision)
    result = outputs(name, inputs)
    assert np.isfinite(result).all()
    for row in range(0, ROWS, ROWS // JUDGED):
        given = [float(c) for x in inputs for c in np.ravel(x[row])]
        got = [float(c) for c in result[row]]
        if "Jacobian" in name and precision == DOUBLE:  # linear in v; the judge sums series, slowly
            given[:3] = [SHORTER * c for c in given[:3]]
            rows, columns = np.divmod(np.arange(36), 6)
            got = np.where((rows < 3) & (columns >= 3), SHORTER * np.array(got), got).tolist()
        assert judge.ratio(TABLE[name], precision, "plain", given, got) <= 1


def test_beyond_it_may():
    """A finite result whose intermediate sums are infinite."""
    D = np.array([[-1, 0, 0, 1e308], [0, -1, 0, 1], [0, 0, 1, 0]])
    with np.errstate(all="ignore"):
        assert not np.isfinite(coscrew.SE3_log(D)).all()
    assert np.isfinite(coscrew.SE3_log(D * [1, 1, 1, 0.01])).all()
    with mp.workdps(30):
        assert mp.pi / 2 * mp.mpf(1e308) < np.finfo(float).max
