"""The accuracy of exponentials, logarithms and Jacobians over all angles, in u.

Angles run from 1e-30 to π, spaced logarithmically, evenly, and logarithmically towards π; axes are
random, along coordinate axes and nearly so.  Logarithms of exponentials that are rounded once must
return their arguments.
"""

from functools import cache

import mpmath as mp
import numpy as np
import pytest

import coscrew
from coscrew_codegen.program.values.formats import Precision
from tests.support.each import each_precision
from tests.support.truth.motions import DIGITS, SE3_exp, ad, exponential_series, skew

TARGETS = {"SO3_exp": 5, "SO3_log": 4, "SE3_exp": 6, "SE3_log": 6, "SO3_leftJacobian": 3,
           "SO3_leftJacobianInverse": 4, "SE3_leftJacobian": 5, "SE3_leftJacobianInverse": 4}
# SE3_exp, SE3_log: of the translation, the linear part.
ANGLES = 50  # of each of the three kinds


@cache
def screws(precision: Precision) -> np.ndarray:
    """(v; ω): of every angle, v between 1e-3 and 1e3 m."""
    numbers = np.random.default_rng(11)
    angles = np.concatenate([10**numbers.uniform(-30, np.log10(np.pi), ANGLES),
                             numbers.uniform(0, np.pi, ANGLES),
                             np.pi - 10**numbers.uniform(-14, 0, ANGLES)])
    axes = numbers.normal(size=(len(angles), 3))
    axes[::3] = np.eye(3)[numbers.integers(0, 3, len(axes[::3]))]
    axes[1::3, 0] *= 1e-5
    axes /= np.linalg.norm(axes, axis=1, keepdims=True)
    v = numbers.normal(size=axes.shape) * 10.0**numbers.uniform(-3, 3, (len(axes), 1))
    result = np.hstack([v, axes * angles[:, None]]).astype(precision.numpy_type)
    return result[np.linalg.norm(result[:, 3:].astype(float), axis=1) < 3.1415925]  # as in single


@cache
def truths(precision: Precision) -> list[tuple[mp.matrix, mp.matrix]]:
    """Displacement and left Jacobian of each screw, in many digits."""
    with mp.workdps(DIGITS):
        return [(SE3_exp(mp.matrix(s)), exponential_series(skew(mp.matrix(s[3:])), 1))
                for s in screws(precision).astype(float).tolist()]


def motion_jacobian(s: np.ndarray) -> mp.matrix:
    """Σ (ad s)^k / (k+1)!."""
    return exponential_series(ad(mp.matrix(s)), 1)


@each_precision
@pytest.mark.parametrize("name", TARGETS)
def test_swept_errors_are_within_the_targets(name: str, precision: Precision):
    u, real = 2.0**-{"double": 53, "single": 24}[precision.name], precision.numpy_type
    s = screws(precision)
    D = np.array([[[float(x) for x in row] for row in T.tolist()] for T, _ in truths(precision)])
    D = D.astype(real)
    given = {"SO3_log": D[..., :3], "SE3_log": D}.get(name, s if name[:3] == "SE3" else s[:, 3:])
    result = np.asarray(getattr(coscrew, name)(np.ascontiguousarray(given)), float)
    with mp.workdps(DIGITS):
        for row, x, (T, J), start in zip(range(len(s)), result, truths(precision),
                                         s.astype(float), strict=True):
            truth, x = {
                "SO3_exp": lambda: (T[0:3, 0:3], x), "SO3_log": lambda: (start[3:], x),
                "SE3_exp": lambda: (T[0:3, 3], x[:, 3]), "SE3_log": lambda: (start[:3], x[:3]),
                "SO3_leftJacobian": lambda: (J, x),
                "SO3_leftJacobianInverse": lambda: (J**-1, x),
                "SE3_leftJacobian": lambda: (motion_jacobian(start), x),
                "SE3_leftJacobianInverse": lambda: (motion_jacobian(start)**-1, x)}[name]()
            pairs = list(zip(np.ravel(x).tolist(), list(truth), strict=True))
            error = max(abs(mp.mpf(a) - b) for a, b in pairs) / max(abs(b) for _, b in pairs)
            assert error <= TARGETS[name] * u, (
                float(error / u), [c.hex() for c in s[row].tolist()])
