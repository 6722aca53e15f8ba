"""The catalogue of effects as text: equations, parameters, units, and what a scene file writes."""

from collections.abc import Iterator

from coscrew_codegen.effects.effect import Effect, ParameterOf, Place

_TABLE = {Place.SCENE: "[effects.{0}]",
          Place.JOINT: '[effects.{0}] with joints = "all" or a list, or [effects.{0}.JOINT]',
          Place.BODY: '[effects.{0}] with bodies = "all" or a list, or [effects.{0}.BODY], or '
                      '[effects.{0}.LABEL] with body = "BODY"',
          Place.PAIR: '[effects.{0}.LABEL] with bodies = ["A", "B"]'}
_KIND = {"number": "number", "vector": "three numbers", "formula": "number or function of t",
         "formulas": "three numbers or functions of t", "body": "body"}


def catalogue(effects: tuple[Effect, ...]) -> str:
    """All effects, for a terminal; each with the table that calls for it in a scene file."""
    return "\n".join("\n".join(_entry(effect)) + "\n" for effect in effects)


def _entry(effect: Effect) -> Iterator[str]:
    yield f"{effect.name}: {effect.words}"
    yield f"    {effect.equation}"
    yield f"    {_TABLE[effect.place].format(effect.name)}"
    width = max((len(parameter.name) for parameter in effect.parameters), default=0)
    for parameter in effect.parameters:
        unit = f" [{parameter.unit}]" if parameter.unit else ""
        yield f"      {parameter.name:<{width}}  {parameter.words}{unit}: {_rules(parameter)}"
    if effect.any_of:
        yield f"      at least one of {', '.join(effect.any_of)}"


def _rules(parameter: ParameterOf) -> str:
    """What may be given: its kind, bounds and default."""
    rules = [" or ".join(parameter.choices) if parameter.kind == "choice" else _KIND[parameter.kind]]
    if parameter.positive or parameter.nonnegative:
        rules.append("above 0" if parameter.positive else "0 or more")
    if parameter.model:
        rules.append(f'"model" takes the joint\'s {parameter.model}')
    if parameter.of:
        rules.append(f"for kind {' or '.join(parameter.of)}")
    if parameter.default is not None:
        rules.append(f"default {_shown(parameter.default)}")
    elif not parameter.required:
        rules.append("may be left out")
    return ", ".join(rules)


def _shown(default: object) -> str:
    if isinstance(default, tuple):
        return f"[{', '.join(map(_shown, default))}]"
    return default if isinstance(default, str) else f"{float(default):g}"
