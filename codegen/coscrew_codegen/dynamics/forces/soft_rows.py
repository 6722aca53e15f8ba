"""Rows of forces between bodies, and on sums of coordinates, in an implicit step, all at once.

Along a row e, whose rate is e^T v, acts a force f; its damping and stiffness are the inertia m and
the force c per rate in the step.  The accelerations a' without the rows change to

    a = a' + M⁻¹ E^T λ,   λ = b - m E a,   (1 + m W) λ = b - m E a',   W = E M⁻¹ E^T,

b = f - c rate, and, linear about the initial velocities of the step, + d (rate - initial rate).
A force far larger than what is left of it in the step never enters a', so that it takes none of
the digits of a.

The rows are eliminated one after the other, from what those before leave of W: never singular, and
an open contact, m = f = 0, changes nothing.  Rows of trees that do not touch each other leave zeros
in W, which cost nothing."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from coscrew_codegen.algebra.recording.numbers import Number, Vector, less, where
from coscrew_codegen.dynamics.algorithms.linear_systems import product
from coscrew_codegen.scene.effect import Slopes

Weights = Callable[..., tuple[Number, Number]]
"""(damping, stiffness, damping over the inertia that it acts on, in 1/s, and for contacts also
stiffness over it, in 1/s²) -> (m, c)."""
Inverse = Callable[[Sequence[Number]], list[Number]]
"""e -> (M + m)⁻¹ e."""


@dataclass(frozen=True)
class SoftRow:
    """A direction of a force: e^T v is the rate along it."""

    e: list[Number]
    slopes: Slopes
    rate: Number  # at the initial velocities of the step
    force: Number
    faster: Number | None = None  # rate now less that; None if it is the same
    contact: bool = False  # its stiffness counts as damping: stiff contacts do not throw


class SoftRows:
    """Rows with m and c, and what is left of W as they are eliminated."""

    def __init__(self, rows: Sequence[SoftRow], weights: Weights, inverse: Inverse):
        self._rows = rows
        self._columns = [inverse(row.e) for row in rows]
        self._left = [[product(row.e, w) for w in self._columns[:i + 1]]
                      for i, row in enumerate(rows)]
        self._masses: list[Number] = []
        self._forces: list[Number] = []
        for i, row in enumerate(rows):
            (d, k), own = (row.slopes.damping, row.slopes.stiffness), self._left[i][i]
            mass, c = weights(d, k, d * own, *([k * own] if row.contact else []))
            self._masses.append(mass)
            pushed = row.force - c * row.rate
            self._forces.append(pushed if row.faster is None else pushed + d * row.faster)
        self._shares = self._eliminated()

    def _eliminated(self) -> list[Number]:
        """1/(1 + m w) of each row, w what those before leave of its W."""
        shares: list[Number] = []
        for k, (W, mass) in enumerate(zip(self._left, self._masses, strict=True)):
            shares.append(1 / (1 + mass * W[k]))
            held = mass * shares[k]
            for i, other in enumerate(self._left[k + 1:], k + 1):
                given = held * other[k]
                for j in range(k + 1, i + 1):
                    other[j] = other[j] - given * self._left[j][k]
        return shares

    def with_forces(self, a: Sequence[Number]) -> list[Number]:
        """a with the forces of the rows, from a without the rows."""
        return self._changed(a, self._forces)

    def resisting(self, a: Sequence[Number]) -> list[Number]:
        """a of other forces with the inertia of the rows, from a without it."""
        return self._changed(a, [a[0].like(0)] * len(self._rows))

    def _changed(self, a: Sequence[Number], forces: Sequence[Number]) -> list[Number]:
        """a' + M⁻¹ E^T λ, (1 + m W) λ = forces - m E a'."""
        met = [product(row.e, a) for row in self._rows]
        multipliers: list[Number] = []
        for k, (force, mass) in enumerate(zip(forces, self._masses, strict=True)):
            multipliers.append((force - mass * met[k]) * self._shares[k])
            for i, W in enumerate(self._left[k + 1:], k + 1):
                met[i] = met[i] + W[k] * multipliers[k]
        for k in reversed(range(len(multipliers))):
            later = a[0].like(0)
            for W, x in zip(self._left[k + 1:], multipliers[k + 1:], strict=True):
                later = later + W[k] * x
            multipliers[k] = multipliers[k] - self._masses[k] * self._shares[k] * later
        result = list(a)
        for column, x in zip(self._columns, multipliers, strict=True):
            result = [y + z * x for y, z in zip(result, column, strict=True)]
        return result


def axes_about(n: Vector) -> tuple[Vector, Vector, Vector]:
    """n and two directions across it, all of length 1 (Duff et al., Building an orthonormal basis,
    revisited, 2017): without a pole."""
    x, y, z = n
    sign = where(less(z, 0), -1, z.like(1))
    a = -1 / (sign + z)
    b = x * y * a
    return n, (1 + sign * (x * x * a), sign * b, -(sign * x)), (b, sign + y * y * a, -y)
