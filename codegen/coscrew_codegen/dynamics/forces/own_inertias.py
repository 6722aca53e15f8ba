"""Inertias of joints themselves, as of the rotors of their motors, and of sums of coordinates."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from coscrew_codegen.algebra.recording.numbers import Number


@dataclass(frozen=True)
class SummedInertia:
    """The inertia I against the rate w·v of a weighted sum: I w w^T of the mass matrix."""

    weights: Mapping[int, Fraction]  # by velocity
    inertia: Number

    def along(self, rates: Sequence[Number]) -> Number:
        """w·rates."""
        total = self.inertia.like(0)
        for place, weight in self.weights.items():
            total = total + rates[place] * weight
        return total


class OwnInertias(dict[str, Number]):
    """The inertias of joints themselves, by joint, and `sums`, those of weighted sums."""

    def __init__(self) -> None:
        super().__init__()
        self.sums: list[SummedInertia] = []

    @property
    def alone(self) -> list[SummedInertia]:
        """The inertias of sums of one term, which are on the diagonal."""
        return [x for x in self.sums if len(x.weights) == 1]

    @property
    def coupling(self) -> "OwnInertias":
        """The inertias of sums of several terms alone."""
        result = OwnInertias()
        result.sums = [x for x in self.sums if len(x.weights) > 1]
        return result

    def enter(self, M: list[list[Number]]) -> list[list[Number]]:
        """The mass matrix with those of sums entered."""
        for x in self.sums:
            for i, of_row in x.weights.items():
                for j, of_column in x.weights.items():
                    M[i][j] = M[i][j] + x.inertia * (of_row * of_column)
        return M

    def with_sums(self, torques: list[Number], a: Sequence[Number]) -> list[Number]:
        """Torques by velocity, with those that sums take at the accelerations a."""
        results = list(torques)
        for x in self.sums:
            torque = x.inertia * x.along(a)
            for place, weight in x.weights.items():
                results[place] = results[place] + torque * weight
        return results

    def energy(self, v: Sequence[Number], others: Number) -> Number:
        """A kinetic energy with those of sums, I (w·v)²/2, added."""
        total = others
        for x in self.sums:
            rate = x.along(v)
            total = total + x.inertia * (rate * rate) / 2
        return total
