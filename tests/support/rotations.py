"""Matrices that are no rotations."""

import numpy as np

import coscrew

_I = np.eye(3)
NO_ROTATIONS = {
    "a reflection": np.diag([-1.0, 1, 1]), "minus the identity": -_I, "zero": 0 * _I,
    "a turned reflection": coscrew.SO3_exp([0.3, -0.2, 0.5]) @ np.diag([1, 1, -1]),
    "scaled": 1.001 * _I, "scaled down": 0.999 * _I, "sheared": _I + 0.002 * np.eye(3, k=1),
    "sheared far": _I + 0.002 * np.eye(3, k=2), "infinite": np.diag([np.inf, 1, 1]),
    "large": 1e30 * _I, "huge": 1e200 * _I, "permuted": _I[[1, 0, 2]]}
