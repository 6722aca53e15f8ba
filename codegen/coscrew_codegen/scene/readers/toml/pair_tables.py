"""Effects on two bodies, in tables under labels, as [effects.contact_pair.cup]."""

from itertools import product
from typing import cast

from coscrew_codegen.scene.effect import FIRST, SECOND, Given
from coscrew_codegen.scene.mechanism.collision import Collision
from coscrew_codegen.scene.mechanism.notices import COLLISION, Notice
from coscrew_codegen.scene.readers.part_tables import listed, shapes_of
from coscrew_codegen.scene.readers.toml.effect_table import EffectTable
from coscrew_codegen.scene.readers.toml.toml_tables import TomlTable, described
from coscrew_codegen.scene.scene import Applied, Setting


def on_pairs(reading: EffectTable) -> list[Applied]:
    """[effects.contact_pair.LABEL] bodies = [a, b], …; a body without a shape there has those that
    the model's file gives it, and each of them touches each of the other's."""
    applied = []
    if not reading.table.values:
        reading.table.refuse("", f"is empty; wanted tables [{reading.table.where}.LABEL]")
    for label, value in reading.table.values.items():
        if not isinstance(value, dict):
            reading.table.refuse(label, f"{described(value)}; wanted a table under a label, "
                                        f"[{reading.table.where}.LABEL], with bodies = [a, b]")
        own = reading.table.table(label)
        own.only("bodies", *reading.parameters)
        pair = own.as_texts("bodies", own.value("bodies", "the two bodies, [a, b]"))
        if len(pair) != 2:
            own.refuse("bodies", f"a list of {len(pair)}; wanted two bodies")
        given = {key: value for key, value in own.values.items() if key != "bodies"}
        values = {**reading.values(own, given, ""), "bodies": reading.pair(own, pair)}
        sides = [_sides(reading, own, side, body) for side, body in zip((FIRST, SECOND), pair,
                                                                        strict=True)]
        every = [{**values, **first, **second} for (a, first), (b, second) in product(*sides)
                 if a is None or b is None or a.may_touch(b)]
        if not every:
            own.refuse("bodies", "their shapes in the model's file do not touch each other (by "
                                 f"contype and conaffinity); wanted {FIRST}_radius, and {FIRST} "
                                 "for its centre, of a sphere in place of one's")
        for number, settings in enumerate(every):
            name = f"{label}.{number}" if len(every) > 1 else label
            both = cast("dict[str, Setting]", settings)
            applied.append(Applied(reading.effect, name, both, name))
    return applied


def _sides(reading: EffectTable, own: TomlTable, side: str, body: str
           ) -> list[tuple[Collision | None, Given]]:
    """The values of one side: what the table says, or those of each shape of its body."""
    of, keys = reading.effect.side_of, (side, f"{side}_end", f"{side}_radius")
    shapes = shapes_of(reading.model, body)
    if of is None or not shapes or any(key in own for key in keys):
        return [(None, {})]
    sides: list[tuple[Collision | None, Given]] = [
        (x, values) for x in shapes if (values := of(side, x))]
    others = [x for x in shapes if not of(side, x)]
    what = f"touch{'es' * (len(others) == 1)} no other body"
    if not sides:
        own.refuse("bodies", f"{listed(others)} of {body!r} in the model's file {what}; wanted "
                             f"{keys[-1]}, and {side} for its centre, of a sphere in its place")
    if others:
        reading.use.notices.append(Notice(
            COLLISION, f"effect {reading.effect.name}", f"{listed(others)} of {body} {what}, other "
            f"shapes there do; write a table [{reading.table.where}.LABEL] with {keys[-1]} for "
            "more"))
    return sides
