"""Proof of the effect of roundings on arctangents."""

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from math import ceil

from coscrew_codegen.program.elementary.atan2 import DATA, approximation, kernel
from coscrew_codegen.program.elementary.proofs.minimax import pi
from coscrew_codegen.program.elementary.proofs.roundings import (
    Before,
    Known,
    Roundings,
    given,
    pieces,
)
from coscrew_codegen.program.values.formats import Precision


def roundings(precision: Precision) -> Fraction:
    """A proved bound of the error in ulps of a result in the normal range.

    A common power of two passes through all steps, so b is assumed between 1 and 2. Quotients below
    2^-30 err as those above do, their cubes being less than 2^-60 of them; where c is subnormal,
    also by half the least subnormal number: 1/4 ulp from 2^-1021 on, in single precision 2^-125;
    less than that, q_high + c is exact."""
    relative, worst = approximation(precision), Fraction(3, 4)
    for quarters, sign, above in ((0, 1, False), (2, 1, False), (2, -1, False), (4, -1, False),
                                  (1, 1, True), (1, -1, True), (3, 1, True), (3, -1, True)):
        for side, q in product((1, 2)[:1 + above], _pieces(32 if quarters == 0 else 8)):
            if not above or q[0] < Fraction(1, 3):
                piece = _Piece(precision, quarters, sign, above, Fraction(side), *q)
                worst = max(worst, piece.roundings(relative))
    return worst


def _pieces(number: int) -> Iterator[tuple[Fraction, Fraction]]:
    """Quotients up to 1/2: the binades, the upper ones in pieces."""
    for n in range(2, 31):
        yield from pieces(Fraction(1, 2**n), Fraction(2, 2**n), number if n < 8 else 1)


@dataclass(frozen=True)
class _Piece:
    """A piece of the domain: d from d_least to 2 d_least and n/d, rounded, from least to largest,
    in a binade."""

    precision: Precision
    quarters: int
    sign: int
    above: bool
    d_least: Fraction
    least: Fraction
    largest: Fraction

    def roundings(self, relative: Fraction) -> Fraction:
        """The bound, for an approximation of arctan q with this relative error."""
        analysis, data = Roundings(self.precision), DATA[self.precision]
        inputs = [analysis.within(1, 2)] * 2
        result, = analysis.results(kernel(self.precision), ["positive"], inputs, {
            **given(self._cases(analysis)), **given(self._remainder(analysis)),
            "d": analysis.restricted(self.d_least, 2 * self.d_least)})
        if not self.quarters:
            return analysis.ulps(result, relative)
        split = max(abs(x / 4 - sum(data.quarter)) for x in pi())
        return analysis.ulps(result, absolute=relative / 2 + self.quarters * split)

    def _cases(self, analysis: Roundings) -> dict[str, Known | Before]:
        """Returns the ranges of a and b; above, b - a is from 0 to 1, and the rounded a + b at most
        2 b."""
        spare = 1 + Fraction(1, 2**8)
        a = analysis.within(Fraction(1, 2), 2) if self.above else analysis.within(
            self.least / spare, 2 * self.largest * spare)
        return {"quarters": analysis.constant(self.quarters), "sign": analysis.constant(self.sign),
                "above": self.above, "scaled_a": a, "scaled_b": analysis.within(1, 2),
                "n_1": Before(Fraction(-1), Fraction(0)),
                "rest_of_d_1": Before(Fraction(-2), Fraction(0))}

    def _remainder(self, analysis: Roundings) -> dict[str, Known | Before]:
        """Halves of the digits are multiples of a unit, off by half of it at most (Dekker); n times
        1/d, both rounded, and the rounded d are off by 4 u, where u is half the least ulp."""
        u, half = self.precision.u, self.precision.digits // 2
        exponent = -(ceil(1 / self.least) - 1).bit_length()  # 2^exponent <= least
        binade, d_low = Fraction(2)**exponent, self.d_least / 2**half
        missed = binade / 2**half + 4 * u * self.largest  # n/d - q_high at most
        d_most = 2 * self.d_least
        but_high = d_most * missed + 2 * self.largest * d_low
        high = self._signed(max(self.least - binade / 2**half, binade),
                            min(self.largest + binade / 2**half, 2 * binade))
        q = self._signed(self.least * (1 - 4 * u), min(
            self.largest * (1 + 4 * u), Fraction(1, 2) + Fraction(1, 2**70)))
        return {"q_high": analysis.within(*high, exponent + 1 - half), "q": Before(*q),
                "d_high": analysis.within(self.d_least, d_most, int(self.d_least) - half),
                "d_low": Before(-d_low, d_low), "but_high": Before(-but_high, but_high),
                "but_low": Before(-d_most * missed, d_most * missed)}

    def _signed(self, low: Fraction, high: Fraction) -> tuple[Fraction, Fraction]:
        """The range with the sign of q."""
        return (low, high) if (self.sign > 0) != self.above else (-high, -low)
