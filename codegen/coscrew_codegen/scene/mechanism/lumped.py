"""The inertia of bodies that move as one, in exact fractions."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache

from coscrew_codegen.scene.mechanism.model import value
from coscrew_codegen.scene.mechanism.rotations import rotated
from coscrew_codegen.scene.mechanism.roundoff_cleanup import length, without_turned
from coscrew_codegen.scene.mechanism.tree import PlacedBody

Six = tuple[Fraction, ...]  # xx, yy, zz, xy, xz, yz

_ROUNDED = Fraction(1, 10**40)
"""Products of inertia up to this times the trace are zero, and moments that differ by as little are
equal: the residue of rotating equal moments with entries of 50 digits."""


@dataclass(frozen=True)
class LumpedInertia:
    """Mass, first moment, second moments about the origin; parameters have their default values."""

    mass: Fraction
    first: tuple[Fraction, ...]
    moments: Six

    @property
    def numbers(self) -> tuple[Fraction, ...]:
        """The mass, first moments and moments of inertia."""
        return (self.mass, *self.first, *self.moments)

    @property
    def about_com(self) -> Six:
        """The second moments about the centre of mass, if there is a mass."""
        return tuple(a - b / self.mass
                     for a, b in zip(self.moments, steiner(self.first), strict=True))


def lumped_inertia(bodies: Sequence[PlacedBody]) -> LumpedInertia:
    """The inertia of all the bodies, about their link's origin in its frame."""
    return _lumped(tuple(placed for placed in bodies if placed.body.inertia))


@lru_cache(maxsize=1024)  # of each link; every function of a scene needs it
def _lumped(bodies: tuple[PlacedBody, ...]) -> LumpedInertia:
    mass = Fraction(0)
    first: tuple[Fraction, ...] = (Fraction(0),) * 3
    moments: Six = (Fraction(0),) * 6
    for placed in bodies:
        if inertia := placed.body.inertia:
            m, R = value(inertia.mass), placed.placement.R
            com = tuple(map(value, inertia.com))
            at = tuple(length(sum((x * y for x, y in zip(R[3 * i:3 * i + 3], com, strict=True)),
                                  placed.placement.t[i])) for i in range(3))
            own = rotated(R, tuple(map(value, inertia.moments)))
            mass += m
            first = tuple(a + m * b for a, b in zip(first, at, strict=True))
            moments = tuple(a + b + m * c
                            for a, b, c in zip(moments, own, steiner(at), strict=True))
    return LumpedInertia(mass, first, without_turned(moments, _ROUNDED))


def steiner(at: tuple[Fraction, ...]) -> Six:
    """-c~²: the second moments of a unit mass at c about the origin."""
    x, y, z = at
    return (y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z)
