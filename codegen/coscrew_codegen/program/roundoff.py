"""What analyses of rounding errors share: how a product passes errors on, and floats that round up.
"""

from math import inf, nextafter
from typing import Protocol, TypeVar


class Upward(float):
    """A bound, no less than 0: its sums and products are rounded up, and exact with 0."""

    def __add__(self, other: float) -> "Upward":
        return Upward(nextafter(float(self) + other, inf)) if other else self

    def __mul__(self, other: float) -> "Upward":
        return Upward(nextafter(float(self) * other, inf)) if self and other else Upward(0)


class Ring(Protocol):
    """A kind of numbers with sums and products."""

    def __add__(self: "N", other: "N", /) -> "N": ...
    def __mul__(self: "N", other: "N", /) -> "N": ...


N = TypeVar("N", bound=Ring)


def product_error(a: N, error_a: N, b: N, error_b: N) -> N:
    """How far a product is from a b, of factors up to a and b in size that err by so much."""
    return a * error_b + error_a * b + error_a * error_b
