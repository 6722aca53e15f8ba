"""Shared parts of rounding-error analyses: the error of a product, and floats that round up."""

from math import inf, nextafter
from typing import Protocol, TypeVar


class Upward(float):
    """A nonnegative bound whose sums and products are rounded up, and exact with 0."""

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
    """Bounds the error of a product, given the sizes and the errors of its factors."""
    return a * error_b + error_a * b + error_a * error_b
