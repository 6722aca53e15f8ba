"""Rates of coordinates, in double: what velocities make of them."""

from collections.abc import Sequence
from math import cos, sin
from typing import Any

import numpy as np

from coscrew_codegen.scene.joints import KIND_NAMED
from coscrew_codegen.scene.mechanism.joint_in_reals import JointInReals

_Column = Any  # an array of many states, as a number


class _JointInArrays(JointInReals):
    """A joint of many states: the library's operations on arrays.  Imports the library where it is
    used, which takes as long as short runs."""

    def quaternion_product(self, a: Sequence[_Column], b: Sequence[_Column]) -> tuple[_Column, ...]:
        import coscrew

        return _columns(coscrew.double.quaternion_product_qq(_array(a), _array(b)))

    def quaternion_rotated(self, q: Sequence[_Column], a: Sequence[_Column]) -> tuple[_Column, ...]:
        import coscrew

        return _columns(coscrew.double.rotate_qv(_array(q), _array(a)))


def rates(kind: str, r: np.ndarray, q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """The rates of a joint's coordinates r; q is r with normalized quaternions.
    (…, nq), (…, nq), (…, nv)->(…, nq)."""
    manifold = KIND_NAMED[kind].manifold
    if manifold is None:
        return v
    state = _JointInArrays((), _columns(q), sin, cos)
    return _array(manifold.rates(state, _columns(r), _columns(v)))


def _columns(x: np.ndarray) -> tuple[_Column, ...]:
    return tuple(np.moveaxis(x, -1, 0))


def _array(columns: Sequence[_Column]) -> np.ndarray:
    return np.stack(np.broadcast_arrays(*columns), -1)
