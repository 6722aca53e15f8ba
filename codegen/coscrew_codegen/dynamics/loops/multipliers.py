"""Multipliers of the rows of closed loops.

ConstraintRows E hold at M a = τ + E^T λ with E a = -g:

    W λ = -(E a₀ + g),   W = E M⁻¹ E^T,   a = a₀ + M⁻¹ E^T λ,   a₀ without λ.

The rows may depend on each other, always or at singular positions.  So W is regularized by a
diagonal ε, and three proximal steps x += (W + ε)⁻¹ (b - W x) remove what ε changes: they converge
to the solution of least norm, and refine the rounding of the factors.  ε is 1e-10 of the trace of
the loop's own W (1e-4 in single precision), so that light loops do not soften heavy ones; lengths
and angles are weighed by the model's length."""

from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from coscrew_codegen.algebra.recording.numbers import Number
from coscrew_codegen.dynamics.algorithms.linear_systems import Factors, factored
from coscrew_codegen.dynamics.algorithms.motion import Motion
from coscrew_codegen.dynamics.loops.closures import Closure, Row
from coscrew_codegen.dynamics.loops.couplings import closures
from coscrew_codegen.program import Constant
from coscrew_codegen.scene.mechanism.model import Model, value

Unit = Callable[[Row], list[Number]]
"""e -> M⁻¹ e."""

EPSILON = Constant(Fraction(1, 10**10), Fraction(1, 10**4), "proximal")
"""ε in double and in single precision, relative to the trace of a loop's W."""
STEPS = 3
"""Proximal steps."""


@dataclass(frozen=True)
class ConstraintRows:
    """The rows of all loops at a position that velocities can change, whatever the position is."""

    model: Model
    closures: tuple[Closure, ...]

    @classmethod
    def at(cls, motion: Motion, model: Model) -> "ConstraintRows":
        """The rows at a motion's position."""
        return cls(model, tuple(closures(motion, model.loops)))

    @cached_property
    def places(self) -> list[tuple[int, int]]:
        """(loop, row of it) of each row."""
        return [(n, k) for n, x in enumerate(self.closures) for k, row in enumerate(x.rows)
                if not all(e.is_zero for e in row)]

    @cached_property
    def E(self) -> list[Row]:
        """The rows."""
        return [self.closures[n].rows[k] for n, k in self.places]

    def of(self, values: Callable[[Closure], Sequence[Number]]) -> list[Number]:
        """A number of each row, from those of each closure."""
        return [values(self.closures[n])[k] for n, k in self.places]

    def along(self, v: Sequence[Number]) -> list[Number]:
        """E v."""
        return [product(row, v) for row in self.E]

    def is_length(self, place: tuple[int, int]) -> bool:
        """Returns whether a row holds a point, not a direction."""
        n, k = place
        return k < self.closures[n].loop.kind.lengths


@dataclass(frozen=True)
class Constrained:
    """Accelerations, and the multipliers of the rows."""

    a: list[Number]
    multipliers: list[Number]


class Compliance:
    """W of some rows, factored: changes of velocities by impulses along the rows."""

    def __init__(self, rows: ConstraintRows, unit: Unit):
        self._rows = rows
        self._columns = [unit(e) for e in rows.E]
        with _part(rows, "W"):
            self._W = [[product(e, column) for column in self._columns[:i + 1]]
                       for i, e in enumerate(rows.E)]

    @cached_property
    def factors(self) -> Factors:
        """The factors of W + ε."""
        with _part(self._rows, "L"):
            softened = [list(row) for row in self._W]
            for i, epsilon in enumerate(self._epsilons()):
                softened[i][i] = softened[i][i] + epsilon
            return factored(softened)

    def _epsilons(self) -> list[Number]:
        """ε of each row; the reciprocal of the total mass bounds it where a loop's W vanishes."""
        rows = self._rows
        recorder = rows.closures[0].motion.recorder
        square = Fraction(rows.model.length or 1).limit_denominator(10**6)**2
        mass = sum((value(x.inertia.mass) for x in rows.model.bodies if x.inertia), Fraction(0))
        softness = {n: recorder.number(1 / (mass or Fraction(1))) for n, _ in rows.places}
        for i, place in enumerate(rows.places):
            own = self._W[i][i] if rows.is_length(place) else self._W[i][i] * square
            softness[place[0]] = softness[place[0]] + own
        epsilon = Number(recorder, EPSILON)
        of_loops = {n: epsilon * x for n, x in softness.items()}
        return [of_loops[place[0]] if rows.is_length(place) else of_loops[place[0]] / square
                for place in rows.places]

    def solve(self, b: Sequence[Number]) -> list[Number]:
        """The solution of W x = b of least norm."""
        factors, W = self.factors, self._W
        with _part(self._rows, "x"):
            x = factors.solve(b)
            for _ in range(STEPS - 1):
                rest = [b[i] - product([W[max(i, j)][min(i, j)] for j in range(len(b))], x)
                        for i in range(len(b))]
                x = [y + z for y, z in zip(x, factors.solve(rest), strict=True)]
            return x

    def changed(self, v: Sequence[Number], multipliers: Sequence[Number]) -> list[Number]:
        """v + M⁻¹ E^T λ."""
        with _part(self._rows, "a"):
            result = list(v)
            for column, x in zip(self._columns, multipliers, strict=True):
                result = [y + z * x for y, z in zip(result, column, strict=True)]
            return result


@dataclass(frozen=True)
class Demand:
    """Demands that accelerations keep rows: E a = -g."""

    rows: ConstraintRows
    g: list[Number]

    def met(self, a: Sequence[Number], unit: Unit) -> Constrained:
        """The accelerations that meet it, from those without the loops."""
        return self.solved(a, Compliance(self.rows, unit))

    def solved(self, a: Sequence[Number], compliance: Compliance) -> Constrained:
        """The accelerations that meet it, by the factors of W."""
        with _part(self.rows, "b"):
            missing = [-(x + g) for x, g in zip(self.rows.along(a), self.g, strict=True)]
        multipliers = compliance.solve(missing)
        return Constrained(compliance.changed(a, multipliers), multipliers)


def product(a: Sequence[Number], b: Sequence[Number]) -> Number:
    """a·b."""
    total = a[0].like(0)
    for x, y in zip(a, b, strict=True):
        total = total + x * y
    return total


def _part(rows: ConstraintRows, symbol: str) -> AbstractContextManager[None]:
    """Names the instructions of a block after a value of all loops."""
    return rows.closures[0].motion.recorder.part("loops", symbol, "closed loops")
