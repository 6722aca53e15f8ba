"""States x of an effect where it acts: their rates, and their bounds.

Beyond its bounds a state acts as on them, as share x.  It keeps its rate there, but the part of the
rate along the bounds is divided by the share, so that share x moves along them as fast as x would
on them: where x is put back onto its bounds, the motion goes on as before.  Only where x has begun
to return must it be put back at once.
"""

from dataclasses import dataclass
from fractions import Fraction

from coscrew_codegen.algebra.recording.numbers import (
    Number,
    Vector,
    add,
    dot,
    less,
    maximum,
    scaled,
    sqrt,
    subtract,
    where,
)
from coscrew_codegen.dynamics.forces.linearization import JointEffect
from coscrew_codegen.dynamics.forces.rotors import Rotor
from coscrew_codegen.scene.effect import ContactForce, Force, Torque

_LEAST = Fraction(1, 8)
"""Smallest divisor of rates along the bounds: where these shrink to nothing, so does what x does.
"""
_TINY = Fraction(1, 10**30)
"""Instead of a length of zero, so that there is no 0/0."""


@dataclass(frozen=True)
class MovingStates:
    """The states of an effect, and its law there."""

    x: Vector
    law: Torque | Force | ContactForce
    lagging: JointEffect | None = None  # whose torque x is
    rotor: Rotor | None = None  # whose angle and speed x are

    @property
    def kept(self) -> Vector:
        """The states within their bounds."""
        share = self.law.share
        return self.x if share is None else scaled(share, self.law.bounded)

    @property
    def rates(self) -> Vector:
        """x', also beyond the bounds; nothing moves states whose bounds are zero."""
        share, rates = self.law.share, self.law.rates
        if self.rotor:
            return self.x[1], self.rotor.acceleration
        if share is None:
            return rates
        if len(rates) > 1:
            length = sqrt(dot(self.law.bounded, self.law.bounded))
            out = scaled(1 / maximum(length, _TINY), self.law.bounded)
            away = scaled(dot(out, rates), out)
            along = scaled(1 / maximum(share, _LEAST), subtract(rates, away))
            rates = add(away, along)
        return tuple(where(less(share.like(0), share), x, 0) for x in rates)

    def drifted(self, time: Number, rounding: Vector) -> Vector:
        """The states after a time at their rates, bristles also moved by a rounding of coordinates;
        a rotor's angle moves at its speed, and a torque with a lag stays."""
        if self.lagging:
            return self.x
        if self.rotor:
            return self.x[0] + time * self.x[1], self.x[1]
        return add(self.x, add(scaled(time, self.law.rates), rounding))

    def followed(self, time: Number) -> Vector:
        """The states after a time in which the demand of a torque with a lag is this one."""
        return (self.lagging.followed(time),) if self.lagging else self.x
