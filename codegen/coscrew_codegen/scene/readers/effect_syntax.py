"""Effects in words: equations, parameters, and how scene files write them."""

import textwrap
from collections.abc import Iterable, Iterator
from fractions import Fraction

from coscrew_codegen.scene.effect import Effect, ParameterOf, Place

WIDTH = 96

_WHERE = {
    Place.SCENE: "[effects.{0}]",
    Place.JOINT: "[effects.{0}] joints = …, or [effects.{0}.JOINT]",
    Place.BODY: "[effects.{0}] bodies = …, [effects.{0}.BODY], or [effects.{0}.LABEL] body = …",
    Place.PAIR: "[effects.{0}.LABEL] bodies = [A, B]"}
_ON_PARTS = ("[effects.{0}.BODY], [effects.{0}.LABEL] bodies = [A, B, …], or [effects.{0}] for all "
             "bodies with shapes in the model's file")
_ON_SUMS = "[effects.{0}] joints = …, [effects.{0}.JOINT], or [effects.{0}.LABEL] joints = {{ … }}"


def described(effect: Effect) -> Iterator[str]:
    """The lines of one effect."""
    yield f"{effect.name}: {effect.words}"
    yield from textwrap.wrap(effect.equation, WIDTH, initial_indent="    ",
                             subsequent_indent="        ")
    yield from textwrap.wrap(where(effect), WIDTH, initial_indent="    ",
                             subsequent_indent="        ")
    for parameter in effect.parameters:
        yield from textwrap.wrap(_line(parameter), WIDTH, initial_indent="      ",
                                 subsequent_indent="          ")
    if effect.any_of:
        yield f"      at least one of {alternatives(effect, effect.any_of)}"


def where(effect: Effect) -> str:
    """The headings of its tables in scene files."""
    pattern = _ON_SUMS if effect.on_sums else _ON_PARTS if effect.parts else \
        _WHERE[effect.place]
    return pattern.format(effect.name)


def alternatives(effect: Effect, names: Iterable[str]) -> str:
    """The parameters `any_of`, written as `names`, and where one of them must have a value."""
    of_model = any(x.model for x in effect.parameters if x.name in effect.any_of)
    return f"{' and '.join(names)}{', here or in the model' if of_model else ''}"


def _line(parameter: ParameterOf) -> str:
    unit = f" [{parameter.unit}]" if parameter.unit else ""
    comment = f" ({'; '.join(given)})" if (given := notes(parameter)) else ""
    return f"{parameter.name}{unit}: {parameter.words}{comment}"


def notes(parameter: ParameterOf) -> list[str]:
    """Notes on its values: type, choices, sign, default."""
    kinds = {"height": "a function of x and y, or a grid of heights", "vector": "three numbers",
             "formula": "a number, a function of t or a "
             "trajectory",
             "formulas": "three numbers or functions of t", "flag": "true or false",
             "matrix": "six rows of six numbers"}
    texts = [kinds[parameter.kind]] if parameter.kind in kinds else []
    if parameter.choices:
        texts.append(" | ".join(parameter.choices))
    if parameter.of:
        texts.append(f"for {' and '.join(parameter.of)}")
    if parameter.optional_of:
        texts.append(f"may be left out for {' and '.join(parameter.optional_of)}")
    if parameter.model:
        texts.append(f'"model": the joint\'s {parameter.model}')
    if parameter.sign:
        texts.append(parameter.sign.value)
    if parameter.default is not None:
        texts.append(f"default {_written(parameter.default)}")
    elif not parameter.required:
        texts.append("may be left out")
    return texts


def _written(value: object) -> str:
    if isinstance(value, tuple):
        return f"[{', '.join(map(_written, value))}]"
    return f"{float(value):g}" if isinstance(value, (int, Fraction)) else str(value)
