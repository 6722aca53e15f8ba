"""Derives a scene's functions in a tier: every public function, with the tier's Program of each
precision.

Steps have no tier: they are sequences of calls, whose error is that of the step, not of rounding.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

from coscrew_codegen.accuracy.range_statements import statement
from coscrew_codegen.accuracy.tiers import PLAIN, Tier, tier_named
from coscrew_codegen.algebra.recording.recorder import headings
from coscrew_codegen.program import Program
from coscrew_codegen.program.reported_error import ReportedError
from coscrew_codegen.program.scene_functions import FunctionProgram, SceneFunctions
from coscrew_codegen.program.values.formats import Precision, named


class NoFunctionsError(ReportedError, ValueError):
    """A scene selects a tier, but only functions that have no tier."""


@dataclass(frozen=True)
class SceneTier:
    """A scene in a tier as targets receive it: its functions, by precision."""

    tier: Tier
    plain: SceneFunctions  # in the precisions that the tier has
    in_precisions: tuple[tuple[Precision, SceneFunctions], ...]

    @property
    def first(self) -> SceneFunctions:
        """Its functions in the first precision: names and arguments are the same in all."""
        return self.in_precisions[0][1]

    def called(self, scene: SceneFunctions) -> SceneFunctions:
        """The plain functions, as internal ones, whose results these functions take."""
        taken = tuple(replace(self.plain.named(f.name), internal=True)
                      for f in scene.functions if f.plain)
        return replace(scene, functions=taken, mark=PLAIN.name)

    @property
    def stem(self) -> str:
        """The name of its files: arm_accurate."""
        return f"{self.plain.name}_{self.tier.mark}"


def in_tier(scene: SceneFunctions, tier: Tier) -> SceneTier:
    """The scene's public functions in this floating-point tier.  Raises NoFunctionsError if there
    are none."""
    public = [f for f in scene.functions if not f.internal]
    if tier.on_request:
        public = [f for f in public if f.accuracy]
        if not public:
            raise NoFunctionsError(f"{scene.name}: the {tier.name} tier needs a function with a "
                                   "requested accuracy: [accuracy] in the scene's file")
    if not public:
        raise NoFunctionsError(f"{scene.name}: the {tier.name} tier needs a function; steps, which "
                               "alone are selected, have no tier")
    precisions = [p for p in named(scene.precisions) if p in tier.precisions]
    if not precisions:
        raise NoFunctionsError(
            f"{scene.name}: the {tier.name} tier is of {tier.precisions[0].name} precision, the "
            f"scene of {scene.precisions[0]}: write precision = \"both\", or leave out the tier")
    return SceneTier(tier, replace(scene, precisions=tuple(p.name for p in precisions)), tuple(
        (p, replace(scene, functions=tuple(_function(f, tier, p, precisions) for f in public),
                    steps=(), precisions=(p.name,), tiers=(), mark=tier.mark))
        for p in precisions))


def _function(plain: FunctionProgram, tier: Tier, precision: Precision,
              precisions: Sequence[Precision]) -> FunctionProgram:
    """The function in the tier and precision; its statement is about all of these precisions."""
    program, rounding = _program_in_tier(plain, tier, precision)
    rounding = rounding or stated(plain, tier, precisions)
    more = len(program.inputs) > len(plain.program.inputs)
    return replace(plain, program=program, plain=plain.program if more else None, rounding=rounding,
                   headings=headings_in(plain, program))


def headings_in(plain: FunctionProgram, program: Program) -> tuple[tuple[int, str], ...]:
    """The function's headings in another program of it."""
    words = {_heading(plain, place): text for place, text in plain.headings}
    return tuple((place, words.get(heading, heading)) for place, heading in headings(program))


def _program_in_tier(plain: FunctionProgram, tier: Tier, precision: Precision
                     ) -> tuple[Program, str]:
    """The program, and the statement on its rounding errors."""
    if tier.on_request and plain.accuracy:
        from coscrew_codegen.accuracy.precision_tuning.choice import (
            chosen,  # imported on use: few scenes need it
        )
        from coscrew_codegen.accuracy.precision_tuning.words import in_words

        choice = chosen(plain.program, plain.accuracy)
        return choice.program, in_words(choice, plain)
    if tier.scene is None:
        raise ValueError(f"scenes do not have the {tier.name} tier")
    return tier.scene(plain.program, precision), ""


def stated(plain: FunctionProgram, tier: Tier, precisions: Sequence[Precision]) -> str:
    """States the bounds that are proved of the function in the tier over its stated ranges."""
    if plain.ranges is None or tier.proof is None:
        return ""
    bounds = {p: proof for p in precisions if (proof := tier.proof(plain, p))}
    return statement(plain, bounds) if bounds else ""


def savings(scene: SceneFunctions, units: Callable[[SceneFunctions, str], Sequence[str]]
            ) -> Iterator[str]:
    """A line for each function with a requested accuracy: the savings of its mixture.  `units`
    returns the units of a function's components."""
    if not any(tier_named(name).on_request for name in scene.tiers):
        return
    from coscrew_codegen.accuracy.precision_tuning.choice import chosen
    from coscrew_codegen.accuracy.precision_tuning.words import saving

    for f in scene.functions:
        if f.accuracy and not f.internal:
            yield saving(chosen(f.program, f.accuracy), f, units(scene, f.name))


def _heading(function: FunctionProgram, place: int) -> str:
    """The heading of an instruction, as its component gives it."""
    return function.program.instructions[place].component.rpartition(":")[0] or "total"


def tiers_of(scene: SceneFunctions) -> Iterator[SceneTier]:
    """The scene in each floating-point tier that it selects."""
    for tier in map(tier_named, scene.tiers):
        if not tier.fixed:
            yield in_tier(scene, tier)
