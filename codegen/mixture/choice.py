"""Chooses a mixture of single precision and pairs whose results are as accurate as asked.

What is carried in pairs follows from a threshold: instructions whose rounding moves a result by
more than it, to first order; the more an instruction costs in pairs, the larger its threshold, by
some power of the cost.  For each of a few powers, the largest threshold is searched at which the
certified bounds of the results' errors are within what is asked, with a margin, at the states where
single precision errs most; the cheapest mixture is taken.  Then other states are drawn; while the
bounds do not hold there, the worst join the sample and the margin grows.

The bounds are those of the certified tier, |x̂ - w| + B with w of double precision, for the x̂ of
the mixture: they hold at their states, whatever the mixture is.
"""

from dataclasses import dataclass
from functools import cache
from math import isfinite, prod, sqrt

import numpy as np

from coscrew_codegen.digits import two_digits_up
from coscrew_codegen.errors import ReportedError
from coscrew_codegen.formats import SINGLE
from coscrew_codegen.mixture.arrays import Array
from coscrew_codegen.mixture.sample import Sample, States
from coscrew_codegen.mixture.sensitivity import OWN, Place, sensitivities
from coscrew_codegen.program import Instruction, Op, Program
from coscrew_codegen.scene_functions import Accuracy, Function
from coscrew_codegen.tiers.accurate_scene import in_pairs
from coscrew_codegen.tiers.certified_wide import in_double
from coscrew_codegen.tiers.mixed import CARRYING, Mixture, mixed
from coscrew_codegen.whole_cost import whole_counts

DRAWN, SEARCHED = 20_000, 4000
"""States; of the first, those where single precision errs most are searched with."""
ROOM = 0.95
"""How much of what pairs leave of the accuracy may be used at the sampled states, at first."""
_RANKED, _WORST = 64, 16  # states where sensitivities are computed: drawn; the worst of a result
_MORE = {Op.ADD: 7, Op.SUB: 7, Op.MUL: 5, Op.DIV: 12, Op.SQRT: 12}
_FUNCTION = 120
"""Operations that instructions take more in pairs, about; elementary functions."""
_POWERS = (0, 1, 2, 3)  # of the root of the cost


class AccuracyError(ReportedError, ValueError):
    """An accuracy that is asked for and cannot be had."""


@dataclass(frozen=True)
class Choice:
    """A function's program in the mixed tier, and what is known of it."""

    program: Program
    pairs: Program  # all in pairs, for comparison
    paired: int  # instructions of the plain program that are in pairs
    worst: tuple[float, ...]  # certified bound of each component of the results, at all states
    states: int  # how many


@cache
def chosen(program: Program, accuracy: Accuracy) -> Choice:
    """The mixture for a plain program, by the formulas for twice the digits.  Raises AccuracyError
    if not even pairs are as accurate."""
    return _Search(program.fine or program, accuracy).choice()


class _Search:
    def __init__(self, program: Program, accuracy: Accuracy) -> None:
        self.program, self.accuracy = program, accuracy
        self.pairs = in_pairs(program, SINGLE)
        self.states = States(accuracy, in_double(program))
        self.sensitive: dict[Place, float] = {}

    def choice(self) -> Choice:
        """Draws other states until the bounds hold there and at the first ones."""
        first = self.states.drawn(DRAWN)
        self._refuse(first)
        units = self._units(self.program, first)
        self._rank(first.at(np.arange(_RANKED)))
        self._rank(first.at(_worst(units)))
        self.sample = first.at(np.argsort(-units.max(axis=0), kind="stable")[:SEARCHED])
        least, room = float(self._units(self.pairs, self.sample).max()), ROOM
        while True:
            mixture = self._cheapest(least + room * (1 - least))
            found, both = mixed(self.program, mixture), first.joined(self.states.drawn(DRAWN))
            units = self._units(found, both)
            if units.max() <= 1:
                worst = both.certified(found).max(axis=1).tolist()
                return Choice(found, self.pairs, len(mixture.paired), tuple(worst), both.size)
            self._refuse(both)
            hard = both.at(_worst(units))
            self._rank(hard)
            self.sample = self.sample.joined(hard)
            room *= ROOM

    def _units(self, program: Program, sample: Sample) -> Array:
        """Certified bounds in units of what is asked."""
        units: Array = sample.certified(program) / np.array(self.accuracy.tolerances)[:, None]
        return units

    def _rank(self, sample: Sample) -> None:
        """Let sensitivities hold at these states, too."""
        wide = [[x.astype(float) for x in each] for each in sample.given]
        for place, size in sensitivities(self.program, wide, self.accuracy.tolerances).items():
            self.sensitive[place] = max(size, self.sensitive.get(place, 0))

    def _cheapest(self, aim: float) -> Mixture:
        """The cheapest mixture found with bounds of at most `aim` at the sample."""
        found = [self._largest(power, aim) for power in _POWERS]
        return min(found, key=lambda x: operations(mixed(self.program, x)))

    def _largest(self, power: int, aim: float) -> Mixture:
        """That of the largest threshold; all in pairs if there is none."""
        thresholds = sorted({-1.0, *self.sensitive.values()})
        low, high = 0, len(thresholds) - 1
        while low < high:
            middle = (low + high + 1) // 2
            made = mixed(self.program, self._mixture(thresholds[middle], power))
            if self._units(made, self.sample).max() <= aim:
                low = middle
            else:
                high = middle - 1
        return self._mixture(thresholds[low], power)

    def _mixture(self, threshold: float, power: int) -> Mixture:
        """Pairs are what is more sensitive than the threshold."""
        paired: set[object] = set()
        kept: set[Place] = set()
        for step in self.program.instructions:
            operands = [(step.name, k) for k in range(len(step.operands))
                        if self.sensitive.get((step.name, k), -1) > threshold]
            weight = prod([sqrt(_MORE.get(step.op, _FUNCTION) / _MORE[Op.ADD])] * power)
            own = self.sensitive.get((step.name, OWN), -1) > threshold * weight
            if own or operands and step.op not in CARRYING:
                paired.add(_together(step))
            kept.update(operands)
        names = {step.name for step in self.program.instructions if _together(step) in paired}
        return Mixture(frozenset(names), frozenset(kept))

    def _refuse(self, sample: Sample) -> None:
        """Raise AccuracyError if pairs are not as accurate as asked at these states."""
        bounds = sample.certified(self.pairs).max(axis=1)
        for (name, number), bound, asked in zip(
                self.accuracy.components, bounds, self.accuracy.tolerances, strict=True):
            if bound > asked:
                found = f"err by up to {two_digits_up(bound)}" if np.isfinite(bound) else \
                    "have no certified bound at some states"
                raise AccuracyError(
                    f"accuracy of {self.program.name}: {asked:g} is asked of {name}; even pairs of "
                    f"floats, rounded at the end, {found} in component {number}")


def in_words(choice: Choice, function: Function) -> str:
    """What is certified and where, and what the mixture saves."""
    assert function.accuracy
    asked, components = function.accuracy.tolerances, function.accuracy.components
    outputs = {name: [k for k, (x, _) in enumerate(components) if x == name]
               for name, _ in components}
    found = "; ".join(f"{name} by at most {two_digits_up(max(choice.worst[k] for k in places))} "
                      f"(asked: {asked[places[0]]:g})".replace("e-0", "e-")
                      for name, places in outputs.items() if isfinite(asked[places[0]]))
    plain, mixture, pairs = map(operations, (function.program, choice.program, choice.pairs))
    count = len(function.program.instructions)
    return (f"Certified at {choice.states:,} states drawn between the joints' limits, not proved "
            f"between them: rounding moves {found}.  In pairs: {choice.paired:,} of {count:,} "
            f"instructions ({100 * choice.paired / count:.0f} %).  Operations, those of elementary "
            f"functions included: {mixture:,}; {plain:,} in single precision, {pairs:,} in pairs.")


def operations(program: Program) -> int:
    """Of all kinds, those of elementary functions included."""
    return sum(whole_counts(program, SINGLE).values())


def _together(step: Instruction) -> object:
    """The same for a sine and a cosine of one angle, which are computed together."""
    return step.operands if step.op in (Op.SIN, Op.COS) else step.name


def _worst(units: Array) -> Array:
    """The states of the largest bounds of each component."""
    order = np.argsort(-units, axis=1, kind="stable")
    return np.unique(order[:, :_WORST])
