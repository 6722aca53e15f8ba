"""Effects that a model's file declares, as springs of joints: they act if the file is taken alone,
and are reported if a scene that names the file lacks them."""

from collections.abc import Iterable, Iterator, Mapping

from coscrew_codegen.scene.effect import Effect
from coscrew_codegen.scene.mechanism.model import WORLD, Joint, Model
from coscrew_codegen.scene.mechanism.notices import SUBJECTS, Notice
from coscrew_codegen.scene.names import toml_key
from coscrew_codegen.scene.readers.toml.toml_text import joined, toml_pairs

Effects = Mapping[str, Mapping[str, object]]
"""Tables as [effects] of a scene holds them: by effect, then by joint, body or label, or the values
of an effect on the whole scene."""


_SUBJECTS = {"viscous": "damping", "coulomb": "friction", "limit": "limits"}
"""Subjects of notices of effects that have other names."""


def of_file_alone(model: Model, declared: Effects, catalogue: tuple[Effect, ...]
                  ) -> dict[str, object]:
    """The table [effects] of a model's file that is taken alone: its declared effects, and effects
    that are `alone` with the model's numbers, on the joints for which it has numbers other than 0.
    """
    tables: dict[str, object] = {}
    acting = _on_moving_bodies(declared, model)
    for effect in catalogue:
        of_model = _from_model(effect, model) if effect.alone else None
        if effect.name in acting or of_model is not None:
            tables[effect.name] = {**acting.get(effect.name, {}), **(of_model or {})}
    return tables


def _on_moving_bodies(declared: Effects, model: Model) -> Effects:
    """The declared effects without those on bodies that never move."""
    links = model.links()
    tables = {name: {on: values for on, values in table.items() if not (
        isinstance(values, Mapping) and links.get(str(values.get("body"))) == WORLD)}
        for name, table in declared.items()}
    return {name: table for name, table in tables.items() if table or not declared[name]}


def _from_model(effect: Effect, model: Model) -> dict[str, object] | None:
    """The table with the model's numbers; None if the model has none that the effect can take."""
    if effect.mimic:
        follow = any(x.mimic for x in model.joints)
        return {} if follow and not any(x.fault("mimic") for x in model.joints) else None
    fields = {x.name: x.model for x in effect.parameters if x.model}
    if not fields:
        return {}
    joints = [x.name for x in model.joints if _has(x, fields.values())]
    return {"joints": joints, **dict.fromkeys(fields, "model")} if joints else None


def _has(joint: Joint, fields: Iterable[str]) -> bool:
    return any(getattr(joint, x) and not joint.fault(x) for x in fields)


def notices(declared: Effects, model: Model) -> Iterator[Notice]:
    """A notice of each effect on a joint, on a body or on the scene that the file declares, which a
    scene with such an effect leaves out."""
    joints = {x.name for x in model.joints}
    for name, table in _on_moving_bodies(declared, model).items():
        places = table if all(isinstance(x, Mapping) for x in table.values()) else {"": table}
        for on, values in places.items():
            assert isinstance(values, Mapping)
            key = f"{name}.{toml_key(on)}" if on else name
            pairs = toml_pairs(values)
            of = f"joint {on}" if on in joints else f"effect {on or name}"
            remedy = f"add [effects.{key}]" + (f" with {joined(pairs)}" if pairs else "")
            text = f"{of}: {name} of the model's file is not used: {remedy}"
            yield Notice(_subject(name), of, text, remedy, (name, on))


def _subject(effect: str) -> str:
    """The subject of notices of an effect."""
    subject = _SUBJECTS.get(effect, effect)
    return subject if subject in SUBJECTS else "other tools' numbers"
