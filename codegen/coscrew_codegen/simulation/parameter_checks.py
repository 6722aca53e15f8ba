"""Checks values of run-time parameters by the same rules as the numbers in the scene's file."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import TypeVar

from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.parameter import Parameter, Scalar
from coscrew_codegen.scene.mechanism.assembly import ModelError
from coscrew_codegen.scene.mechanism.inertia_checks import judged, why_singular
from coscrew_codegen.scene.mechanism.model import Model, value
from coscrew_codegen.scene.names import nearest
from coscrew_codegen.scene.readers.decimals import bounded
from coscrew_codegen.scene.readers.toml.runtime import constants, swapped_model
from coscrew_codegen.scene.scene import Applied, Scene, Setting
from coscrew_codegen.simulation import SimulateError

N = TypeVar("N")


def refuse_settings(scene: Scene, settings: Mapping[str, float], precision: Precision) -> None:
    """Raise SimulateError for an unknown parameter, a number out of its range or the precision's,
    and numbers that make a body that cannot exist or leave a joint without inertia."""
    if not settings:
        return
    refuse_each(scene, settings, precision)
    if any(name in settings for name in dependent(scene)):
        refuse_together(scene, settings)


def refuse_each(scene: Scene, settings: Mapping[str, float], precision: Precision,
                prefix: str = "--set ") -> None:
    """Raise SimulateError for an unknown parameter, or a number out of its range or the
    precision's.  `said` stands before its name."""
    names = tuple(parameter.name for parameter in scene.parameters)
    least, most = (float(precision.limit(x)) for x in ("smallest_normal", "max"))
    for name, number in settings.items():
        if name not in names:
            listed = ", ".join(names) or "none"
            near = nearest(name, names)
            hint = f"; did you mean {near!r}?" if near else ""
            if name in constants(scene.model, scene.effects):
                hint = "; to change this constant, write it there"
            raise SimulateError(f"{prefix}{name}: wanted a parameter that the scene lists in "
                                f"`runtime`: {listed}{hint}")
        if not math.isfinite(number):
            raise SimulateError(f"{prefix}{name}={number:g}: wanted a finite number")
        try:
            bounded(Fraction(number), f"{number:g}")
        except ValueError as error:
            raise SimulateError(f"{prefix}{name}={number:g}: {error}") from None
        if number and not least <= abs(number) <= most:
            raise SimulateError(f"{prefix}{name}={number:g}: outside {precision.name} precision's "
                                f"range: 0, and {least:.2g} to {most:.2g} in size")
    for name, sign in scene.signs.items():
        number = settings.get(name, 1)
        if sign.refuses(number):
            raise SimulateError(f"{prefix}{name}={number:g}: wanted {sign.value}")


def refuse_together(scene: Scene, settings: Mapping[str, float], prefix: str = "--set ") -> None:
    """Raise SimulateError for ranges whose ends are in the wrong order, and for bodies that cannot
    exist or leave a joint without inertia."""
    given = " ".join(f"{prefix}{name}={number:g}" for name, number in settings.items())
    for applied, low, high in ranges(scene, settings):
        if applied.effect.ascending and low > high:
            raise SimulateError(f"{given}: {applied.name}: {applied.effect.ascending[0]}, {low:g}, "
                                f"is above {applied.effect.ascending[1]}, {high:g}")
    if any(name in settings for name in _of_bodies(scene)):
        _refuse_model(scene, settings, given)


def dependent(scene: Scene) -> set[str]:
    """Names of the parameters whose values must suit each other: those of bodies, ends of ranges.
    """
    ends = (applied.values[name] for applied in scene.effects
            if applied.effect.ascending for name in applied.effect.ascending)
    return {*_of_bodies(scene), *(x.name for x in ends if isinstance(x, Parameter))}


def constant(scene: Scene) -> set[str]:
    """Names of the parameters that a controller must not set, since their values are checked."""
    return {*scene.signs, *dependent(scene)}


def ranges(scene: Scene, settings: Mapping[str, N]
           ) -> Iterator[tuple[Applied, N | float, N | float]]:
    """Returns (effect, lower, upper) of the ranges in which effects keep joints, for these values
    of parameters, or rows of values; infinite where a range has no end."""
    for applied in scene.effects:
        if applied.effect.ascending:
            low, high = (applied.values[name] for name in applied.effect.ascending)
            yield (applied, _number(low, settings, -math.inf), _number(high, settings, math.inf))


def _number(given: Setting, settings: Mapping[str, N], without: float) -> N | float:
    if not isinstance(given, Scalar):
        return without
    named = settings.get(given.name) if isinstance(given, Parameter) else None
    return float(value(given)) if named is None else named


def _of_bodies(scene: Scene) -> tuple[str, ...]:
    """Names of the parameters that are bodies' masses, centres and moments."""
    results: list[str] = []

    def note(name: str, number: Scalar) -> Scalar:
        if isinstance(number, Parameter):
            results.append(name)
        return number

    swapped_model(scene.model, note)
    return tuple(results)


def _refuse_model(scene: Scene, settings: Mapping[str, float], given: str) -> None:
    def swap(name: str, number: Scalar) -> Scalar:
        return Fraction(settings[name]) if name in settings else number

    model: Model = swapped_model(scene.model, swap)
    try:
        judged(model, scene.implausible)
    except ModelError as error:
        raise SimulateError(f"{given}: {error}") from None
    if problem := why_singular(replace(scene, model=model)):
        raise SimulateError(f"{given}: {problem}")
