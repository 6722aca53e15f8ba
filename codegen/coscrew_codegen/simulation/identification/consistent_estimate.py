"""The physical arm nearest to an estimate: masses, centres and moments that bodies can have, and
friction that does not drive.

A link's numbers are those of a body if its pseudo-inertia

    J = [[Σ, h], [h^T, m]],   Σ = tr(I)/2 1 - I,

is positive definite, so J = U U^T with an upper triangular U whose diagonal is an exponential:
after Rucker and Wensing, "Smooth parameterization of rigid-body inertia" (2022).  The unknowns are
free numbers, those of U, and least squares find the arm, from the scene's own."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from coscrew_codegen.simulation.identification.arm_regressor import ArmRegressor
from coscrew_codegen.simulation.identification.base_estimate import Estimate

Reals = NDArray[np.float64]
TOWARDS_SCENE = 1e-2
"""Weight of the distance from the scene's own arm, which decides what torques leave open: to
change a number by a factor of e costs as much as 1e-2 standard errors."""
LEAST = 1e-6
"""The smallest part of a link's mass and size that a start has."""
SURE = 0.95
_PLACES = tuple((i, j) for j in range(4) for i in range(j + 1))


@dataclass(frozen=True)
class ConsistentArm:
    """A physical arm: its parameters pi, and their base parameters.

    `distance` is the loss of fit against the estimate, in variances, and `allowed` what noise
    alone explains with 95 % probability."""

    pi: Reals
    beta: Reals
    distance: float
    allowed: float

    @property
    def within(self) -> bool:
        """True if noise explains that the estimate is not this arm's."""
        return self.distance <= self.allowed


def nearest(arm: ArmRegressor, estimate: Estimate) -> ConsistentArm:
    """The physical arm whose base parameters fit best."""
    from scipy.optimize import least_squares
    from scipy.stats import chi2

    start = _start(arm)

    def loss(x: Reals) -> Reals:
        fit = estimate.R @ (arm.K @ _numbers(arm, x) - estimate.beta)
        return np.concatenate((fit, TOWARDS_SCENE * (x - start)))

    def slopes(x: Reals) -> Reals:
        return np.concatenate((estimate.R @ arm.K @ _slopes(arm, x),
                               TOWARDS_SCENE * np.eye(len(x))))

    result = least_squares(loss, start, slopes, method="lm", x_scale="jac", max_nfev=300)
    pi = _numbers(arm, result.x)
    beta = arm.K @ pi
    distance = float(((estimate.R @ (beta - estimate.beta))**2).sum())
    return ConsistentArm(pi, beta, distance, float(chi2.ppf(SURE, len(beta))))


def _start(arm: ArmRegressor) -> Reals:
    """The unknowns of the scene's own arm, made definite."""
    masses = arm.pi[0:10 * arm.links:10]
    least = LEAST * max(float(masses.sum()), 1e-3)
    size = arm.scene.model.length or 1.0
    unknowns = []
    for k in range(arm.links):
        J = _pseudo_inertia(arm.pi[10 * k:10 * k + 10])
        J = J + np.diag([LEAST * max(J[3, 3], least) * size**2] * 3 + [least])
        values, axes = np.linalg.eigh(J)
        J = axes @ np.diag(np.maximum(values, LEAST**2 * values.max())) @ axes.T
        flipped = np.linalg.cholesky(J[::-1, ::-1])[::-1, ::-1]
        unknowns += [np.log(flipped[i, j]) if i == j else flipped[i, j] for i, j in _PLACES]
    for x, positive in _others(arm):
        unknowns.append(np.log(max(x, LEAST)) if positive else x)
    return np.array(unknowns)


def _others(arm: ArmRegressor) -> Iterator[tuple[float, bool]]:
    """(number, whether it must not be negative) of each parameter of effects."""
    yield from zip(arm.pi[10 * arm.links:].tolist(), arm.nonnegative, strict=True)


def _factors(arm: ArmRegressor, x: Reals) -> Iterator[Reals]:
    """U of each link."""
    for k in range(arm.links):
        U = np.zeros((4, 4))
        for (i, j), value in zip(_PLACES, x[10 * k:10 * k + 10], strict=True):
            U[i, j] = np.exp(value) if i == j else value
        yield U


def _numbers(arm: ArmRegressor, x: Reals) -> Reals:
    """pi of the unknowns."""
    links = [_inertia(U @ U.T) for U in _factors(arm, x)]
    rest = [np.exp(y) if positive else y for y, (_, positive) in zip(
        x[10 * arm.links:], _others(arm), strict=True)]
    return np.concatenate((*links, rest))


def _slopes(arm: ArmRegressor, x: Reals) -> Reals:
    """pi by the unknowns."""
    result = np.zeros((len(arm.pi), len(x)))
    for k, U in enumerate(_factors(arm, x)):
        for n, (i, j) in enumerate(_PLACES):
            E = np.zeros((4, 4))
            E[i, j] = U[i, j] if i == j else 1
            result[10 * k:10 * k + 10, 10 * k + n] = _inertia(E @ U.T + U @ E.T)
    for n, (_, positive) in enumerate(_others(arm), 10 * arm.links):
        result[n, n] = np.exp(x[n]) if positive else 1
    return result


def _pseudo_inertia(pi: Reals) -> Reals:
    m, hx, hy, hz, xx, yy, zz, xy, xz, yz = pi
    I = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    J = np.zeros((4, 4))
    J[:3, :3] = np.trace(I) / 2 * np.eye(3) - I
    J[:3, 3] = J[3, :3] = hx, hy, hz
    J[3, 3] = m
    return J


def _inertia(J: Reals) -> Reals:
    """The ten numbers of a pseudo-inertia."""
    I = np.trace(J[:3, :3]) * np.eye(3) - J[:3, :3]
    return np.array([J[3, 3], *J[:3, 3], I[0, 0], I[1, 1], I[2, 2], I[0, 1], I[0, 2], I[1, 2]])
