"""Physical numbers of a model that a scene does not use: reported, never ignored silently."""

from collections.abc import Iterator

from coscrew_codegen.scene.effect import Effect, ParameterOf
from coscrew_codegen.scene.mechanism.model import Joint, Model
from coscrew_codegen.scene.mechanism.notices import Notice
from coscrew_codegen.scene.names import toml_key
from coscrew_codegen.scene.readers.toml.effect_table import MODEL
from coscrew_codegen.scene.scene import Applied

FIELDS = ("damping", "friction", "effort", "velocity", "lower", "upper")
_SUBJECTS = {"lower": "limits", "upper": "limits"}


def unused(model: Model, used: set[tuple[str, str]], catalogue: tuple[Effect, ...],
           acting: tuple[Applied, ...] = ()) -> tuple[Notice, ...]:
    """A notice of each number whose (joint, field) is not `used`, with the effect to add, or the
    change in that effect if it already acts on the joint; then further content of the model's file
    that no effect uses.

    Zeros are not reported, since files write them for unknown numbers, except ends of ranges."""
    notices = [notice for joint in model.joints
               for notice in _of(joint, model, used, catalogue, acting)]
    return (*notices, *besides(model, acting))


def besides(model: Model, acting: tuple[Applied, ...]) -> Iterator[Notice]:
    """Notices of what the model's file says besides the model, and no effect uses."""
    there = {(x.effect.name, on) for x in acting for on in (x.on, x.label, "")}
    yield from (x for x in model.notices if x.used_by not in there)


def _of(joint: Joint, model: Model, used: set[tuple[str, str]], catalogue: tuple[Effect, ...],
        acting: tuple[Applied, ...]) -> Iterator[Notice]:
    for name in FIELDS:
        number = getattr(joint, name)
        if number is None or (joint.name, name) in used:
            continue
        if number or name in ("lower", "upper") and (joint.lower or joint.upper):
            what = f"{name} {float(number):g} {_unit(joint, name)}"
            yield _notice(joint, _SUBJECTS.get(name, name), what,
                          _remedy(joint, name, model, catalogue, acting))
    for fault in joint.faults:
        subject = f"wrong {_SUBJECTS.get(fault.field, fault.field)}"
        yield Notice(subject, f"joint {joint.name}", f"joint {joint.name}: {fault.field} is not "
                     f"used, and cannot be: {fault}")
    if joint.mimic and (joint.name, "mimic") not in used:
        mimic = joint.mimic
        what = (f"mimic of {mimic.joint} (multiplier {float(mimic.multiplier):g}, "
                f"offset {float(mimic.offset):g})")
        name = next((effect.name for effect in catalogue if effect.mimic), "")
        yield _notice(joint, "mimic", what, f"add [effects.{name}]" if name else "")


def _notice(joint: Joint, subject: str, what: str, remedy: str) -> Notice:
    """The notice; without a remedy no effect of the catalogue uses the number."""
    used = f"is not used: {remedy}" if remedy else "is used by no effect"
    return Notice(subject, f"joint {joint.name}", f"joint {joint.name}: {what} {used}",
                  remedy if remedy.startswith("add ") else "")


def _remedy(joint: Joint, field: str, model: Model, catalogue: tuple[Effect, ...],
            acting: tuple[Applied, ...]) -> str:
    for applied in acting:
        for parameter in applied.effect.parameters:
            if applied.on == joint.name and parameter.model == field:
                if applied.values.get(parameter.name) is None:
                    if parameter.needs and applied.values.get(parameter.needs) is None:
                        continue
                    return f'say {parameter.name} = "model" in [effects.{applied.effect.name}]'
                return f"[effects.{applied.effect.name}] has its own {parameter.name}"
    return adding(joint, field, model, catalogue, acting)


def adding(joint: Joint, field: str, model: Model, catalogue: tuple[Effect, ...],
           acting: tuple[Applied, ...]) -> str:
    """The text by which the first suitable effect uses a joint's number; "" if there is none: 'add
    [effects.viscous] with joints = "all" and d = "model"'.

    In a table for this joint alone if the effect acts elsewhere or cannot take all joints'."""
    suitable = [(not p.required, x) for x in catalogue for p in x.parameters if p.model == field]
    effect = min(suitable, key=lambda x: x[0], default=(True, None))[1]
    if effect is None:
        return ""
    alone = getattr(joint, field) is None or any(x.effect is effect for x in acting) or any(
        other.fault(p.model) or p.positive and getattr(other, p.model) == 0
        for p in effect.parameters if p.model for other in model.joints)
    keys = [key for p in effect.parameters if (key := _written(p, effect, joint, field))]
    table = f"{effect.name}.{toml_key(joint.name)}" if alone else effect.name
    keys = keys if alone else ['joints = "all"', *keys]
    *first, last = keys or [""]
    return f"add [effects.{table}]" + (" with " if last else "") + (
        f"{', '.join(first)} and " if first else "") + last


def _written(p: ParameterOf, effect: Effect, joint: Joint, field: str) -> str:
    """A parameter as it must be written for the effect to take the field; "" if it need not be."""
    kind = next((x.default or x.choices[0] for x in effect.parameters if x.name == "kind"), "")
    if p.model and joint.fault(p.model):
        return f"a number for {p.name}"
    if p.model and (p.model == field or p.required) and getattr(joint, p.model) is not None:
        return "" if p.default == MODEL else f'{p.name} = "{MODEL}"'
    if p.default is not None or not p.required and p.model != field or kind in p.optional_of or (
            p.of and kind not in p.of):
        return ""
    if p.kind == "choice":
        return f'{p.name} = "{p.choices[0]}"'
    return f"{p.name} = {'0' if p.kind == 'formula' else p.example}"


def _unit(joint: Joint, name: str) -> str:
    turns = not joint.kind.slides
    return {"damping": "N m s/rad" if turns else "N s/m", "friction": "N m" if turns else "N",
            "effort": "N m" if turns else "N", "velocity": "rad/s" if turns else "m/s",
            "lower": "rad" if turns else "m", "upper": "rad" if turns else "m"}[name]
