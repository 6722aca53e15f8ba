"""Effects on parts of bodies, in tables under labels, as [effects.contact.feet]; and values that
depend on the whole scene."""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from math import sqrt
from typing import cast

from coscrew_codegen.scene.contacts.closeness import MOST_AT_REST, Resting
from coscrew_codegen.scene.contacts.touching_parts import (
    SHAPE_KEYS,
    SHAPES,
    meets_planes,
    touches,
)
from coscrew_codegen.scene.effect import required
from coscrew_codegen.scene.mechanism.collision import PLANE, Collision
from coscrew_codegen.scene.mechanism.model import WORLD, Model, value
from coscrew_codegen.scene.mechanism.notices import COLLISION, Notice
from coscrew_codegen.scene.names import toml_key
from coscrew_codegen.scene.patterns import PatternError, expanded
from coscrew_codegen.scene.readers.toml.effect_table import ALL, MANY, EffectTable
from coscrew_codegen.scene.readers.toml.toml_tables import TomlTable, described
from coscrew_codegen.scene.scene import Applied, Setting


def on_parts(reading: EffectTable) -> list[Applied]:
    """[effects.contact.LABEL] bodies = [a, b], … or, of one body, under its name; [effects.contact]
    with numbers, for all bodies that have shapes in the model's file and no table of their own.

    The label, the body's name if there are several, and a part's number make the effect's name."""
    table, results = reading.table, list[Applied]()
    plain = {key: x for key, x in table.values.items() if not isinstance(x, dict)}
    labels = [key for key in table.values if key not in plain]
    if not table.values:
        table.refuse("", f"is empty; wanted tables [{table.where}.LABEL], or numbers for all "
                         "bodies that have collision shapes in the model's file")
    for label in labels:
        own = table.table(label)
        own.only("bodies", *reading.parameters)
        names = _bodies(reading, own, label)
        for name in names:
            words = (label, *([name] if len(names) > 1 else []))
            results += _on_body(reading, own, own.values, name, words)
    if plain:
        table.only("bodies", *reading.parameters, *labels)
        for name in _all_bodies(reading, {x.on for x in results}):
            results += _on_body(reading, table, plain, name, (name,))
    for name, times in Counter(x.name for x in results).items():
        if times > 1:
            table.refuse("", f"two contacts are called {name}; wanted other labels")
    _note_unused(reading, {x.on for x in results})
    return results


def _on_body(reading: EffectTable, table: TomlTable, given: Mapping[str, object], body: str,
             words: tuple[str, ...]) -> Iterator[Applied]:
    """The effect on each part of a body."""
    settings = {key: x for key, x in given.items() if key != "bodies"}
    values = reading.values(table, settings, body)
    shapes = () if any(key in given for key in SHAPE_KEYS) else shapes_of(reading.model, body)
    usable = [x for x in shapes if touches(x, reading.model)]
    if shapes and not usable:
        met = any(meets_planes(x, reading.model) for x in shapes)
        what = "cannot touch" if met else (
            f"touch{'es' * (len(shapes) == 1)} no {PLANE} there (by contype and conaffinity)")
        table.refuse("bodies" if "bodies" in given else "",
                     f"{listed(shapes)} of body {body!r} in the model's file {what}; wanted a "
                     f"shape, as shape = \"sphere\" with radius, in a table of {body!r}")
    of_shape, of_values = required(reading.effect.parts_of), required(reading.effect.parts)
    parts = [y for x in usable for y in of_shape(values, x)] if usable else of_values(values)
    for number, part in enumerate(cast("Sequence[dict[str, Setting]]", parts)):
        label = ".".join((*words, *([str(number)] if len(parts) > 1 else [])))
        yield Applied(reading.effect, body, part, label)


def shapes_of(model: Model, body: str) -> list[Collision]:
    """The shapes of a body in the model's file."""
    return [x for x in model.collisions if x.body == body]


def listed(shapes: Sequence[Collision]) -> str:
    """Shapes by number and kind: the mesh, 2 meshes."""
    (one, count), *others = Counter(x.shape for x in shapes).items()
    if count == 1 and not others:
        return f"the {one}"
    return f"{len(shapes)} shapes ({', '.join((one, *(x for x, _ in others)))})"


def _all_bodies(reading: EffectTable, elsewhere: set[str]) -> tuple[str, ...]:
    """The bodies of [effects.contact] itself: those it lists, or all that move and have shapes that
    can touch, and no table of their own."""
    table, links = reading.table, reading.links
    if isinstance(table.values.get("bodies", ALL), list):
        return _listed_bodies(reading, table)
    if table.values.get("bodies", ALL) != ALL:
        table.refuse("bodies", f'{described(table.values["bodies"])}; wanted "{ALL}" or a list of '
                               "names")
    shaped = {x.body for x in reading.model.collisions if touches(x, reading.model)}
    names = tuple(x for x in reading.targets if x in shaped - elsewhere and links[x] != WORLD)
    if not names:
        table.refuse("", f"no body that moves has collision shapes ({', '.join(SHAPES)}) in the "
                         f"model's file{' and no table of its own' if elsewhere else ''}; wanted "
                         f"tables [{table.where}.LABEL] with bodies and a shape")
    return names


def _note_unused(reading: EffectTable, bodies: set[str]) -> None:
    """Note the shapes of the model's file that cannot touch, though others of their bodies do and
    the file means them to."""
    model = reading.model
    shapes = [x for x in model.collisions if x.body in bodies and not touches(x, model)
              and meets_planes(x, model)]
    taken = [x for x in shapes if any(touches(y, model) for y in shapes_of(model, x.body))]
    if taken:
        names = [*dict.fromkeys(x.body for x in taken)]
        more = ", …" * (len(names) > MANY)
        reading.use.notices.append(Notice(
            COLLISION, f"effect {reading.effect.name}", f"{listed(taken)} of "
            f"{', '.join(names[:MANY])}{more} cannot touch, other shapes there do; write "
            f"[{reading.table.where}.{toml_key(names[0])}] with a shape for more"))


def _bodies(reading: EffectTable, own: TomlTable, label: str) -> tuple[str, ...]:
    """The bodies of a table: those it lists, or the one that its label names."""
    if "bodies" not in own:
        if label not in reading.targets:
            own.missing("bodies", f"a list of bodies, or the name of one in place of {label!r}")
        return (reading.target(own, "bodies", label),)
    return _listed_bodies(reading, own)


def _listed_bodies(reading: EffectTable, own: TomlTable) -> tuple[str, ...]:
    given = own.as_texts("bodies", own.values["bodies"])
    try:
        given = expanded(given, reading.all_targets({}), tuple(reading.targets))
    except PatternError as error:
        own.refuse("bodies", str(error))
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
            trees = {roots.get(body, WORLD) for body in x.bodies or (x.on,)} - {WORLD}
            weight = g * min((_mass(model, roots, root) for root in trees), default=Fraction(0))
            count = 1 if x.bodies else counts[x.effect.name, roots.get(x.on)]
            resting = Resting(weight / min(count, MOST_AT_REST), g)
            try:
                values = x.effect.completed(x.values, resting)
            except ValueError as error:
                table = effects.table(x.effect.name)
                label = max((key for key, of in table.values.items() if isinstance(of, dict)
                             and f"{x.label or x.on}.".startswith(f"{key}.")), key=len, default="")
                table.refuse(label, str(error))
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
