"""Effects on parts of bodies, in tables under labels, as [effects.contact.feet]; and values that
depend on the whole scene."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from math import sqrt
from typing import cast

from coscrew_codegen.scene.effect import Resting, required
from coscrew_codegen.scene.mechanism.model import WORLD, Model, value
from coscrew_codegen.scene.readers.toml.effect_table import EffectTable
from coscrew_codegen.scene.readers.toml.toml_tables import TomlTable, described
from coscrew_codegen.scene.scene import Applied, Setting


def on_parts(reading: EffectTable) -> list[Applied]:
    """[effects.contact.LABEL] bodies = [a, b], … or, of one body, under its name.

    The label, the body's name if there are several, and a part's number make the effect's name."""
    table, results = reading.table, list[Applied]()
    if not table.values:
        table.refuse("", f"is empty; wanted tables [{table.where}.LABEL]")
    for label, given in table.values.items():
        if not isinstance(given, dict):
            table.refuse(label, f"{described(given)}; wanted a table under a label, "
                                f"[{table.where}.LABEL], with bodies = [a, b]")
        own = table.table(label)
        own.only("bodies", *reading.parameters)
        names = _bodies(reading, own, label)
        settings = {key: x for key, x in own.values.items() if key != "bodies"}
        for name in names:
            values = reading.values(own, settings, name)
            parts = cast("Sequence[dict[str, Setting]]", required(reading.effect.parts)(values))
            for number, part in enumerate(parts):
                words = [label, *([name] if len(names) > 1 else []),
                         *([str(number)] if len(parts) > 1 else [])]
                results.append(Applied(reading.effect, name, part, ".".join(words)))
    return results


def _bodies(reading: EffectTable, own: TomlTable, label: str) -> tuple[str, ...]:
    """The bodies of a table: those it lists, or the one that its label names."""
    if "bodies" not in own:
        if label not in reading.targets:
            own.missing("bodies", f"a list of bodies, or the name of one in place of {label!r}")
        return (reading.target(own, "bodies", label),)
    given = own.as_texts("bodies", own.values["bodies"])
    names = tuple(reading.target(own, "bodies", name) for name in given)
    if not names or len({*names}) < len(names):
        own.refuse("bodies", "wanted names of bodies, each once")
    return names


def completed(effects: TomlTable, model: Model, applied: list[Applied]) -> list[Applied]:
    """The effects, with values that depend on the scene."""
    roots, g = _roots(model), _gravity(applied)
    counts = Counter((x.effect.name, roots.get(x.on)) for x in applied)
    results = []
    for x in applied:
        if x.effect.completed:
            root = roots.get(x.on)
            weight = g * _mass(model, roots, root) if root else Fraction(0)
            resting = Resting(weight / counts[x.effect.name, root], g)
            try:
                values = x.effect.completed(x.values, resting)
            except ValueError as error:
                table = effects.table(x.effect.name)
                labels = (key for key in table.values if x.label.startswith(key))
                table.refuse(next(labels) if x.label else "", str(error))
            x = replace(x, values=cast("dict[str, Setting]", values))
        results.append(x)
    return results


def _roots(model: Model) -> dict[str, str]:
    """The first body of each body's tree."""
    results = {WORLD: WORLD}
    for joint in model.joints:
        results[joint.child] = joint.child if joint.parent == WORLD else results[joint.parent]
    return results


def _mass(model: Model, roots: dict[str, str], root: str) -> Fraction:
    return sum((value(body.inertia.mass) for body in model.bodies
                if body.inertia and roots[body.name] == root), Fraction(0))


def _gravity(applied: list[Applied]) -> Fraction:
    """|g|, 0 without gravity."""
    own = [x.vector("g") for x in applied if x.effect.gravity]
    return Fraction(repr(sqrt(sum(float(value(y))**2 for y in own[0])))) if own else Fraction(0)
