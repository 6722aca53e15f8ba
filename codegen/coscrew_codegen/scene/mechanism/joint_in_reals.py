"""A joint whose numbers are floats, mpmath's or others that add and multiply."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from coscrew_codegen.algebra.recording.numbers import displacement, rotation, translation
from coscrew_codegen.scene.mechanism.joint_kind import JointState

_Real = Any
_Reals = Sequence[_Real]
_IDENTITY = (1, 0, 0, 0, 1, 0, 0, 0, 1)


@dataclass(frozen=True)
class JointInReals(JointState):
    """A joint of a kind of real numbers, of which these are the sine and cosine."""

    sin: Callable[[_Real], _Real]
    cos: Callable[[_Real], _Real]

    def numbers(self, values: Sequence[int]) -> tuple[_Real, ...]:
        return tuple(values)

    def rotation(self, axis: _Reals, angle: _Real) -> tuple[_Real, ...]:
        """cos 1 + sin n~ + (1 - cos) n n^T."""
        x, y, z = axis
        c, s = self.cos(angle), self.sin(angle)
        tilde = (0, -z, y, z, 0, -x, -y, x, 0)
        outer = [a * b for a in axis for b in axis]
        return tuple(c * i + s * t + (1 - c) * o
                     for i, t, o in zip(_IDENTITY, tilde, outer, strict=True))

    def quaternion_rotation(self, q: _Reals) -> tuple[_Real, ...]:
        """1 + 2 w v~ + 2 v~²."""
        x, y, z, w = q
        return (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
                2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y))

    def composed(self, first: _Reals, second: _Reals) -> tuple[_Real, ...]:
        moved = self.rotated(rotation(first), translation(second))
        t = [a + b for a, b in zip(translation(first), moved, strict=True)]
        return displacement(_product(rotation(first), rotation(second)), t)

    def turned(self, first: _Reals, R: _Reals) -> tuple[_Real, ...]:
        return displacement(_product(rotation(first), R), translation(first))

    def rotated(self, R: _Reals, a: _Reals) -> tuple[_Real, ...]:
        return tuple(_dot(R[3 * i:3 * i + 3], a) for i in range(3))

    def rotated_back(self, R: _Reals, a: _Reals) -> tuple[_Real, ...]:
        return tuple(_dot(R[i::3], a) for i in range(3))

    def quaternion_product(self, a: _Reals, b: _Reals) -> tuple[_Real, ...]:
        (u, v), (c, d) = (a[:3], b[:3]), (a[3], b[3])
        vector = (c * y + d * x + z for x, y, z in zip(u, v, self.cross(u, v), strict=True))
        return *vector, c * d - _dot(u, v)

    def quaternion_rotated(self, q: _Reals, a: _Reals) -> tuple[_Real, ...]:
        return self.rotated(self.quaternion_rotation(q), a)

    def cross(self, a: _Reals, b: _Reals) -> tuple[_Real, ...]:
        return tuple(a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3))


def _product(a: _Reals, b: _Reals) -> tuple[_Real, ...]:
    return tuple(_dot(a[3 * i:3 * i + 3], b[j::3]) for i in range(3) for j in range(3))


def _dot(a: _Reals, b: _Reals) -> _Real:
    return sum(x * y for x, y in zip(a, b, strict=True))
