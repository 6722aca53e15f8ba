"""Derives a scene's functions in fixed point: every public function that is a polynomial of its
arguments and of their sines and cosines, for the ranges that the scene states."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import inf

from coscrew_codegen.accuracy.scene_tiers import NoFunctionsError
from coscrew_codegen.accuracy.tiers import Tier, tier_named
from coscrew_codegen.program import Input, NotANumber
from coscrew_codegen.program.fixed.fixed_program import (
    KNOWN,
    FixedProgram,
    NoFormatError,
    Products,
    angles_of,
    in_fixed_point,
    of_inputs,
)
from coscrew_codegen.program.fixed.fixed_value import FixedValue
from coscrew_codegen.program.scene_functions import FunctionProgram, SceneFunctions


@dataclass(frozen=True)
class FixedFunction:
    """A function in fixed point: its plain one, and its Programs by their products."""

    plain: FunctionProgram
    programs: Mapping[Products, FixedProgram]

    @property
    def inputs(self) -> tuple[tuple[FixedValue, ...], ...]:
        """The values of the arguments."""
        return self.programs[Products.FULL].inputs


@dataclass(frozen=True)
class FixedScene:
    """A scene in fixed point as targets receive it; `left_out` has the functions that are not in
    it, with reasons."""

    tier: Tier
    plain: SceneFunctions
    functions: tuple[FixedFunction, ...]
    left_out: tuple[tuple[str, str], ...]

    @property
    def arguments(self) -> dict[str, tuple[FixedValue, ...]]:
        """The values of each argument, which are the same for all functions."""
        return {a.name: values for f in self.functions
                for a, values in zip(f.plain.inputs, f.inputs, strict=True)}

    @property
    def stem(self) -> str:
        """The name of its files: arm_fixed."""
        return f"{self.plain.name}_{self.tier.mark}"


def in_fixed(scene: SceneFunctions, tier: Tier) -> FixedScene:
    """The scene in fixed point.  Raises NoFunctionsError if it states no ranges or has no function
    that fixed point has."""
    if not scene.box:
        raise NoFunctionsError(f"{scene.name}: the {tier.name} tier needs the ranges of arguments: "
                               "[ranges] in the scene's file")
    public = [f for f in scene.functions if not f.internal]
    reasons = {f.name: reason for f in public if (reason := _unknown(f))}
    known = [f for f in public if f.name not in reasons]
    angles = frozenset((f.program.inputs[x.argument].name, x.index) for f in known
                       for x in angles_of(f.program) if isinstance(x, Input))
    made = []
    for f in known:
        try:
            made.append(_made(f, dict(scene.box), angles))
        except NoFormatError as error:
            reasons[f.name] = str(error)
    if not made:
        words = "; ".join(f"{name}: {reason}" for name, reason in reasons.items())
        raise NoFunctionsError(f"{scene.name}: the {tier.name} tier has none of the selected "
                               f"functions: {words or 'steps have no tier'}")
    return FixedScene(tier, scene, tuple(made), tuple(reasons.items()))


def _unknown(f: FunctionProgram) -> str:
    """The reason for which fixed point has no such function; "" if there is none."""
    others = [op.value for op in f.program.counts if op not in KNOWN]
    if others or NotANumber() in f.program.results:
        return f"it is no polynomial of its arguments, their sines and cosines " \
               f"({', '.join(others) or 'not defined everywhere'})"
    return ""


def _made(f: FunctionProgram, box: Mapping[str, tuple[float, ...]],
          angles: frozenset[tuple[str, int]]) -> FixedFunction:
    """The function.  Raises NoFormatError."""
    sizes = []
    for a in f.program.inputs:
        stated = box.get(a.name, ())
        sizes.append(stated + (inf,) * (a.quantity.size - len(stated)))
        if inf in sizes[-1]:
            raise NoFormatError(f"the scene states no range of {a.name}")
    inputs = of_inputs(sizes, frozenset(
        Input(n, index) for n, a in enumerate(f.program.inputs) for name, index in angles
        if name == a.name))
    return FixedFunction(f, {products: in_fixed_point(f.program, inputs, products)
                             for products in Products})


def fixed_of(scene: SceneFunctions) -> Iterator[FixedScene]:
    """The scene in fixed point, if it selects that."""
    for tier in map(tier_named, scene.tiers):
        if tier.fixed:
            yield in_fixed(scene, tier)
