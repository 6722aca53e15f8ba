"""Contacts by Hertz's law, as steps see them: stiffness, depth and load."""

from dataclasses import dataclass
from fractions import Fraction

from coscrew_codegen.algebra.recording.numbers import Number


@dataclass(frozen=True)
class Contact:
    """Contact by Hertz's law, k δ^1.5: steps are split while it is closed or closes."""

    k: Number
    depth: Number  # δ, zero where it is open


@dataclass(frozen=True)
class BodyContact:
    """Contact of a body by Hertz's law: steps are split while it bounces."""

    k: Number
    gap: Number  # below zero where it is closed
    rise: Number  # the gap's rate
    resting: Number  # the depth under its load: less than twice that deep it rests


MOST_AT_REST = 8
"""Contacts that share a tree's weight, at most: of a body with many not all touch."""


@dataclass(frozen=True)
class Resting:
    """The load on each contact of a body at rest, in N, and free fall's acceleration; 0 without
    gravity."""

    load: Fraction
    g: Fraction
