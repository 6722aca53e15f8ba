"""Laws of joints as rows: a sum of coordinates is a polynomial of another.

    φ = s - P(r),   E v = s' - P'(r) r',   E' v = -P''(r) r'²

with the weighted sums s of the joints and r of their leaders.  They hold no bodies: their forces
act as torques of the joints do, between the bodies that each connects."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from coscrew_codegen.algebra.recording.numbers import Number
from coscrew_codegen.dynamics.algorithms.motion import Motion
from coscrew_codegen.dynamics.algorithms.rnea import Wrench
from coscrew_codegen.dynamics.forces.acted_coordinates import link_of, sum_of, weights_of
from coscrew_codegen.dynamics.loops.closures import Closure, Row
from coscrew_codegen.scene.effect import required
from coscrew_codegen.scene.identifiers import identifiers
from coscrew_codegen.scene.mechanism.loop import ClosedLoop


@dataclass(frozen=True)
class Coupling(Closure):
    """A law at a motion."""

    def __hash__(self) -> int:
        return id(self)

    @cached_property
    def _polynomial(self) -> tuple[Number, Number, Number]:
        """P, P' and P'' at r, by Horner's rule."""
        law, zero = required(self.loop.law), self.motion.zero[0]
        r, _ = sum_of(self.motion, law.leaders)
        with self.part("P"):
            P, slope, bend = zero, zero, zero
            for c in reversed(law.polynomial):
                bend = bend * r + slope
                slope = slope * r + P
                P = P * r + c
            return P, slope, bend * 2

    @cached_property
    def phi(self) -> list[Number]:
        """s - P(r)."""
        s, _ = sum_of(self.motion, required(self.loop.law).joints)
        with self.part("phi"):
            return [s - self._polynomial[0]]

    @cached_property
    def rows(self) -> list[Row]:
        """The weights of s, less P' times those of r."""
        law, (_, slope, _) = required(self.loop.law), self._polynomial
        row = [self.motion.zero[0]] * self.motion.tree.nv
        with self.part("E"):
            for place, weight in weights_of(self.motion.tree, law.joints).items():
                row[place] = row[place] + weight
            for place, weight in weights_of(self.motion.tree, law.leaders).items():
                row[place] = row[place] - slope * weight
        return [row]

    @cached_property
    def rates(self) -> list[Number]:
        """-P''(r) r'², and E a of a motion that accelerates."""
        _, rate = sum_of(self.motion, required(self.loop.law).leaders)
        with self.part("g"):
            total = -(self._polynomial[2] * (rate * rate))
            for x, a in zip(self.rows[0], self.motion.a, strict=True):
                total = total + x * a
            return [total]

    @cached_property
    def coscrews(self) -> list[Wrench]:
        """No wrench from outside on any link."""
        return [(*self.motion.zero, *self.motion.zero)]

    def holding(self, multipliers: Mapping[int, Number]) -> Row:
        """E^T λ."""
        with self.part("f"):
            return [x * multipliers[0] for x in self.rows[0]]

    def on_links(self, multipliers: Mapping[int, Number]) -> Iterator[tuple[int, Wrench]]:
        """Nothing: joints transmit the torques, from the links that they connect."""
        return iter(())

    @property
    def exerted(self) -> list[Wrench]:
        """The wrench of its first joint along its axis, on the link that it moves."""
        first = required(self.loop.law).joints[0]
        screw = self.motion.subspace(link_of(self.motion, first.joint))[first.coordinate]
        return [tuple(x * first.weight for x in screw)]


def closures(motion: Motion, loops: Sequence[ClosedLoop]) -> list[Closure]:
    """The closures of these loops, and laws of joints."""
    owners = identifiers([f"{x.name}_loop" for x in loops])
    return [(Coupling if x.law else Closure)(x, motion, owner)
            for x, owner in zip(loops, owners, strict=True)]
