"""Inverse kinematics of an arm for many targets at once, within its joints' ranges: Levenberg and
Marquardt's method on arrays, from random starts; counts successes.

Usage: python examples/many_targets.py MODEL BODY COUNT
"""

import sys
from pathlib import Path

import numpy as np
from inverse_kinematics import CLOSE, STARTS, Arm, Reals
from numpy.typing import NDArray

import coscrew

STEPS, LEAST = 60, 1e-12  # of a start; least damping


def residuals(arm: Arm, q: Reals, targets: Reals) -> Reals:
    """SE3_log of the displacements from the body to its targets."""
    return np.asarray(coscrew.SE3_log(coscrew.product_dinvd(arm.pose(q), targets)))


def descended(arm: Arm, q: Reals, targets: Reals) -> tuple[Reals, NDArray[np.bool_]]:
    """q after STEPS damped Newton steps within the ranges, and whether each reached its target."""
    damping, away = np.full(len(q), 1e-2), residuals(arm, q, targets)
    low, high = arm.ranges
    for _ in range(STEPS):
        far = np.flatnonzero(np.abs(away).max(axis=1) > CLOSE)
        at, error = q[far], away[far]
        J = -np.asarray(coscrew.SE3_leftJacobianInverse(error)) @ np.asarray(arm.jacobian(at))
        slope = np.einsum("nij,ni->nj", J, error)
        free = ~((at <= low) & (slope > 0) | (at >= high) & (slope < 0))
        J *= free[:, None]
        H = np.einsum("nij,nik->njk", J, J) + damping[far, None, None] * np.eye(q.shape[1])
        moved = np.clip(at - np.linalg.solve(H, (slope * free)[..., None])[..., 0], low, high)
        after = residuals(arm, moved, targets[far])
        better = (after**2).sum(axis=1) < (error**2).sum(axis=1)
        q[far[better]], away[far[better]] = moved[better], after[better]
        damping[far] = np.maximum(damping[far] * np.where(better, 0.2, 5), LEAST)
    return q, np.abs(away).max(axis=1) <= CLOSE


def reached(arm: Arm, targets: Reals, rng: np.random.Generator) -> tuple[Reals, NDArray[np.bool_]]:
    """q within the ranges for each target, and whether it brings the body there."""
    q = rng.uniform(*arm.ranges, (len(targets), arm.ranges.shape[1]))
    done = np.zeros(len(targets), bool)
    for _ in range(STARTS):
        rest = np.flatnonzero(~done)
        start = rng.uniform(*arm.ranges, (len(rest), q.shape[1]))
        q[rest], done[rest] = descended(arm, start, targets[rest])
    return q, done


if __name__ == "__main__":
    _, model, body, count = sys.argv
    arm, rng = Arm(Path(model), body), np.random.default_rng(0)
    aims = arm.pose(rng.uniform(*arm.ranges, (int(count), arm.ranges.shape[1])))
    print(f"{reached(arm, aims, rng)[1].sum()} of {count} targets reached")
