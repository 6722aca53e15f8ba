"""Base parameters by weighted least squares.

Each joint's torques are weighted by the standard deviation of its own residual, from a first
estimate with equal weights; standard errors follow from the weighted regressor."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.identification.arm_regressor import ArmRegressor
from coscrew_codegen.simulation.identification.measurements import Measurements, smoothed

Reals = NDArray[np.float64]
PASSES = 4
"""Estimates, each weighted by the residuals of the one before."""
UNDETERMINED = 1e-10
"""The ratio of singular values below which a combination of parameters is not determined."""


@dataclass(frozen=True)
class Estimate:
    """Base parameters and their standard errors, and the residuals of torques."""

    beta: Reals
    errors: Reals
    R: Reals  # |R (beta - the estimate)|² is the loss of fit of another beta, in variances
    deviations: Reals  # of each joint's residual
    explained: Reals  # the part of each joint's torque, squared, that the model explains
    condition: float  # of the weighted regressor, its columns scaled to length 1
    t: Reals
    measured: Reals  # torques (n, NV)
    residuals: Reals


def stacked(arm: ArmRegressor, x: Measurements, cutoff: float | None
            ) -> tuple[Reals, Reals, Reals]:
    """(t, Y, tau - tau0) of the samples: with a cutoff both sides filtered alike, and as many
    samples as are then independent."""
    Y, rest = arm.at(x.t, x.q, x.v, x.a)
    tau = x.tau - rest
    if cutoff is None:
        return x.t, Y, tau
    ends, step = int(x.rate / cutoff) + 1, max(1, int(x.rate / (2 * cutoff)))
    kept = slice(ends, len(x.t) - ends, step)
    return (x.t[kept], smoothed(Y, x.rate, cutoff)[kept], smoothed(tau, x.rate, cutoff)[kept])


def estimated(arm: ArmRegressor, t: Reals, Y: Reals, tau: Reals) -> Estimate:
    """The estimate from samples.  Raises SimulateError for too few, and for a motion that does not
    determine all parameters."""
    count, nv, wide = Y.shape
    if count * nv <= wide + nv:
        raise SimulateError(f"identify: {count} samples of {nv} torques; wanted more than the "
                            f"{wide} base parameters")
    deviations, beta = np.ones(nv), np.zeros(wide)
    for _ in range(PASSES):
        A = (Y / deviations[:, None]).reshape(-1, wide)
        lengths = np.linalg.norm(A, axis=0)
        U, s, V = np.linalg.svd(A / np.where(lengths, lengths, 1), full_matrices=False)
        if s[-1] <= UNDETERMINED * s[0]:
            raise SimulateError(_undetermined(arm, V[-1]))
        beta = V.T @ ((U.T @ (tau / deviations).reshape(-1)) / s) / lengths
        residuals = tau - Y @ beta
        freedoms = count - wide / nv
        deviations = np.maximum(np.sqrt((residuals**2).sum(0) / freedoms),
                                np.finfo(float).eps * np.abs(tau).max(0) + np.finfo(float).tiny)
    A = (Y / deviations[:, None]).reshape(-1, wide)
    R: Reals = np.asarray(np.linalg.qr(A, mode="r"))
    errors = np.linalg.norm(np.linalg.inv(R), axis=1)
    scatter = ((tau - tau.mean(0))**2).sum(0)
    explained = 1 - (residuals**2).sum(0) / np.where(scatter, scatter, 1)
    return Estimate(beta, errors, R, deviations, explained, float(s[0] / s[-1]), t, tau, residuals)


def _undetermined(arm: ArmRegressor, direction: Reals) -> str:
    """Names the parameters of a combination that the motion leaves open."""
    worst = [arm.base_names[k] for k in np.argsort(-np.abs(direction))
             if abs(direction[k]) > 0.1 * np.abs(direction).max()][:3]
    return ("identify: the motion does not determine all base parameters, such as "
            f"{'; '.join(worst)}; wanted one that moves all joints, as --excite writes")
