"""A function of a scene in every tier and precision: its results, the exact results, and the states
at which they are compared."""

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np
from gmpy2 import mpfr

from coscrew_codegen.accuracy.tiers import PLAIN, tier_named
from coscrew_codegen.program.in_python import in_python
from coscrew_codegen.program.multiprecise import MULTIPRECISE, precise
from coscrew_codegen.program.values.formats import DOUBLE, PRECISIONS, Precision
from coscrew_codegen.reports.cost.error_states import BATCH, Box, Reals, Values, joined, searched
from coscrew_codegen.reports.cost.loops import CompiledLoops
from coscrew_codegen.simulation.plan import Trajectory
from coscrew_codegen.simulation.result_units import units

DIGITS = 50
ACCURATE, CERTIFIED = (tier_named(name).name for name in ("accurate", "certified"))
_FEWER = BATCH // 16  # most states compared with DIGITS at once, since these take much longer
Exact = list[list[mpfr]]
"""A function's results for each state."""


@dataclass(frozen=True)
class TierChoice:
    """A tier and precision to compute in."""

    tier: str
    precision: Precision

    @property
    def name(self) -> str:
        """single accurate"""
        return f"{self.precision.name} {self.tier}"


def choices(built: CompiledLoops, name: str) -> tuple[TierChoice, ...]:
    """Returns the library's choices of tier and precision for this function, the cheapest tiers
    first."""
    return (*(TierChoice(PLAIN.name, p) for p in PRECISIONS),
            *(TierChoice(x.tier.name, p) for x in built.tiers for p, scene in x.in_precisions
              if scene.has(name)))


@dataclass(frozen=True)
class Counts:
    """Numbers of states: of the run, between the joints' limits, and of the search there."""

    run: int = 16
    limits: int = 32
    search: int = 16

    @classmethod
    def of(cls, total: int) -> "Counts":
        """Divides a total number of states among the three."""
        return cls(total // 4, total - 2 * (total // 4), total // 4)


@dataclass(frozen=True)
class Measured:
    """A function of a scene, to be computed in all choices."""

    built: CompiledLoops
    name: str

    @property
    def units(self) -> tuple[str, ...]:
        """Units of the components."""
        return units(self.built.part.functions, self.name)

    @property
    def different_units(self) -> list[str]:
        """The distinct units, the unit of most components first."""
        return [unit for unit, _ in Counter(self.units).most_common()]

    def inputs(self, states: Values) -> list[Reals]:
        """Returns the states as inputs, in the function's order."""
        program, count = self.built.part.functions.named(self.name).program, len(states["t"])
        return [states[a.name] if a.name in states else np.ones((count, *a.quantity.shape))
                for a in program.inputs]  # directions and weights of derivatives

    def values(self, choice: TierChoice, states: Values) -> list[Reals]:
        """The results and, if it is certified, their bounds: (states, components) each."""
        made = self.built.values(self.name, choice.precision, self.inputs(states), choice.tier)
        results = [x.astype(float) for x in made]
        if choice.tier != CERTIFIED:
            return [np.concatenate(results, axis=1)]
        half = len(results) // 2
        return [np.concatenate(x, axis=1) for x in (results[:half], results[half:])]

    def exact(self, states: Values) -> Exact:
        """The results to DIGITS."""
        with precise(DIGITS):
            return [self._exactly([[*map(mpfr, np.ravel(part[row]).tolist())]
                                   for part in self.inputs(states)])
                    for row in range(len(states["t"]))]

    def states(self, box: Box, trajectory: Trajectory, counts: Counts
               ) -> tuple[dict[str, Reals], tuple[str, ...]]:
        """The states at which it is measured, and the source of each.  The search looks for the
        worst state of each choice in each unit."""
        parts = [("run", box.of_run(trajectory, counts.run)),
                 ("limits", box.drawn(np.random.default_rng(2), counts.limits))]
        searches = [(x, unit) for x in choices(self.built, self.name)
                    for unit in self.different_units]
        for n, (choice, unit) in enumerate(searches):
            count = max(1, (counts.search + n) // len(searches))
            batch = _FEWER if choice == NEAREST else BATCH
            parts.append(("search", searched(
                box, partial(self.badness, choice, unit), count, batch)))
        return (joined([x for _, x in parts]),
                tuple(place for place, x in parts for _ in x["t"]))

    def badness(self, choice: TierChoice, unit: str, states: Values) -> Reals:
        """Returns for each state the largest error of a component with this unit or, if the choice
        is certified, the largest bound.  Errors are approximate: differences from accurate results
        in double; only errors of the latter are differences from DIGITS."""
        result, *bounds = self.values(choice, states)
        off = self._from_exact(result, states) if choice == NEAREST else np.abs(
            result - self.values(NEAREST, states)[0])
        if bounds:
            off = np.minimum(np.where(np.isnan(bounds[0]), np.inf, bounds[0]), np.finfo(float).max)
        worst: Reals = off[:, [x == unit for x in self.units]].max(axis=1)
        return worst

    def _from_exact(self, result: Reals, states: Values) -> Reals:
        with precise(DIGITS):
            return np.array([[float(abs(mpfr(x) - y)) for x, y in zip(row, exact, strict=True)]
                             for row, exact in zip(result.tolist(), self.exact(states),
                                                   strict=True)])

    @cached_property
    def _exactly(self) -> Callable[[Sequence[Sequence[mpfr]]], list[mpfr]]:
        program = self.built.part.functions.named(self.name).program
        with precise(DIGITS):
            return in_python(program.fine or program, MULTIPRECISE)


NEAREST = TierChoice(ACCURATE, DOUBLE)
"""The choice whose results are nearest to the exact ones."""
