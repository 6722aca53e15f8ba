"""Weighted sums of joints' coordinates."""

from dataclasses import dataclass
from fractions import Fraction


@dataclass(frozen=True)
class WeightedCoordinate:
    """A coordinate of a joint, times a weight: a term of a sum."""

    joint: str
    coordinate: int  # its number among those of the joint
    weight: Fraction
