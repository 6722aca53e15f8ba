"""Physical numbers of a model that a scene does not use: reported, never ignored silently."""

from collections.abc import Iterator

from coscrew_codegen.scene.effect import Effect
from coscrew_codegen.scene.model import Joint, Kind, Model
from coscrew_codegen.scene.notices import Notice
from coscrew_codegen.scene.scene import Applied

FIELDS = ("damping", "friction", "effort", "velocity", "lower", "upper")
_SUBJECTS = {"lower": "limits", "upper": "limits"}


def unused(model: Model, used: set[tuple[str, str]], catalogue: tuple[Effect, ...],
           acting: tuple[Applied, ...] = ()) -> tuple[Notice, ...]:
    """A notice of each number whose (joint, field) is not `used`, with the effect to add, or the
    change in that effect if it already acts on the joint; then what else the model's file says.

    Zeros are not reported, since files write them for unknown numbers, except ends of ranges."""
    found = [notice for joint in model.joints for notice in _of(joint, used, catalogue, acting)]
    return (*found, *model.notices)


def _of(joint: Joint, used: set[tuple[str, str]], catalogue: tuple[Effect, ...],
        acting: tuple[Applied, ...]) -> Iterator[Notice]:
    for name in FIELDS:
        number = getattr(joint, name)
        if number is None or (joint.name, name) in used:
            continue
        if number or name in ("lower", "upper") and (joint.lower or joint.upper):
            what = f"{name} {float(number):g} {_unit(joint, name)}"
            yield _notice(joint, _SUBJECTS.get(name, name), what,
                          _remedy(joint, name, catalogue, acting))
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
    """Without a remedy no effect of the catalogue takes it."""
    used = f"is not used: {remedy}" if remedy else "is used by no effect"
    return Notice(subject, f"joint {joint.name}", f"joint {joint.name}: {what} {used}",
                  remedy if remedy.startswith("add ") else "")


def _remedy(joint: Joint, field: str, catalogue: tuple[Effect, ...], acting: tuple[Applied, ...]
            ) -> str:
    for applied in acting:
        for parameter in applied.effect.parameters:
            if applied.on == joint.name and parameter.model == field:
                if applied.values.get(parameter.name) is None:
                    return f'say {parameter.name} = "model" in [effects.{applied.effect.name}]'
                return f"[effects.{applied.effect.name}] has its own {parameter.name}"
    name = effect_using(field, catalogue)
    return f"add [effects.{name}]" if name else ""


def effect_using(field: str, catalogue: tuple[Effect, ...]) -> str:
    """The name of the first effect that takes this field of joints; "" if none does."""
    return next((effect.name for effect in catalogue
                 if any(parameter.model == field for parameter in effect.parameters)), "")


def _unit(joint: Joint, name: str) -> str:
    turns = joint.kind is Kind.REVOLUTE
    return {"damping": "N m s/rad" if turns else "N s/m", "friction": "N m" if turns else "N",
            "effort": "N m" if turns else "N", "velocity": "rad/s" if turns else "m/s",
            "lower": "rad" if turns else "m", "upper": "rad" if turns else "m"}[name]
