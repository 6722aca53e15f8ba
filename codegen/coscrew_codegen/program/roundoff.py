"""Shared parts of rounding-error analyses: the error of a product, and floats that round up."""

from math import frexp, inf, nextafter, sqrt
from typing import Protocol, TypeVar

_HALF = 0.5  # frexp's mantissa of powers of two


class Upward(float):
    """A nonnegative bound whose sums, products and quotients are rounded up unless they are known
    to be exact: sums that lose no digit, products with 0 or a power of two."""

    def __add__(self, other: float) -> "Upward":
        total = float(self) + other
        part = total - self
        lost = (self - (total - part)) + (other - part)  # exact (Knuth); NaN if infinite
        return Upward(total if lost <= 0 else nextafter(total, inf))

    def __mul__(self, other: float) -> "Upward":
        if not self or not other:
            return Upward(0)
        product = float(self) * other
        exact = product > _NORMAL and (frexp(self)[0] == _HALF or frexp(other)[0] == _HALF)
        return Upward(product if exact else nextafter(product, inf))

    def __truediv__(self, other: float) -> "Upward":
        """The quotient; infinite if the divisor is not positive."""
        if other <= 0:
            return Upward(inf)
        return Upward(nextafter(float(self) / other, inf) if self else 0)


_NORMAL = 2.0**-1021


def length(a: Upward, b: Upward) -> Upward:
    """Bounds √(a² + b²)."""
    if not a or not b:
        return max(a, b)
    return Upward(nextafter(sqrt(a * a + b * b), inf))


class Ring(Protocol):
    """A kind of numbers with sums and products."""

    def __add__(self: "N", other: "N", /) -> "N": ...
    def __mul__(self: "N", other: "N", /) -> "N": ...


N = TypeVar("N", bound=Ring)


def product_error(a: N, error_a: N, b: N, error_b: N) -> N:
    """Bounds the error of a product, given the sizes and the errors of its factors."""
    return a * error_b + error_a * b + error_a * error_b
