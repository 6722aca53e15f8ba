"""Uniformly distributed rotations from uniformly distributed numbers."""

import numpy as np

import coscrew


def quaternions(unit: np.ndarray) -> np.ndarray:
    """(√(1-a) sin 2πb, √(1-a) cos 2πb, √a sin 2πc, √a cos 2πc): (x, y, z, w) of numbers in
    [0, 1], with the same bits on every machine.  (…, 3)->(…, 4).

    Source: K. Shoemake, Uniform random rotations, Graphics Gems III, 1992."""
    first, second = np.sqrt(1 - unit[..., :1]), np.sqrt(unit[..., :1])
    one, other = (np.stack(coscrew.sincos(2 * np.pi * unit[..., k]), -1) for k in (1, 2))
    return np.concatenate((first * one, second * other), -1)
