"""Notices about gaps of a scene: numbers of a model that it does not use, effects that exert
nothing, bodies with a free base that nothing holds against gravity."""

from collections.abc import Iterator, Mapping
from fractions import Fraction

from coscrew_codegen.scene.contacts.touching_parts import touches
from coscrew_codegen.scene.effect import Effect, ParameterOf
from coscrew_codegen.scene.mechanism.model import WORLD, Joint, Model
from coscrew_codegen.scene.mechanism.notices import FALLING, IDLE, Notice
from coscrew_codegen.scene.names import toml_key
from coscrew_codegen.scene.readers.toml.effect_table import MODEL
from coscrew_codegen.scene.scene import Applied, Setting, zero

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


def falling(model: Model, effects: tuple[Applied, ...]) -> tuple[Notice, ...]:
    """A notice of the free bases that fall: gravity acts, and no effect exerts a force from outside
    on their trees at rest, nor does a loop tie them to others."""
    if not any(x.effect.gravity and not all(map(zero, x.vector("g"))) for x in effects):
        return ()
    bases = _bases(model)
    wind = any(x.effect.wind for x in effects)
    held = {base for x in effects if not x.effect.resists or wind and x.effect.in_fluid
            for base in _pushed(x, bases)}
    for loop in model.loops:
        ends = {bases[body] for body in loop.bodies}
        held |= ends if len(ends) > 1 else set()
    fall = [x for x in model.joints if x.name in bases.values() and x.name not in held]
    shaped = any(touches(x, model) and bases[x.body] in (y.name for y in fall)
                 for x in model.collisions)
    return (Notice(FALLING, f"joint {fall[0].name}", _falling_line(fall, shaped)),) if fall else ()


def _bases(model: Model) -> dict[str, str]:
    """The free joint of the tree that each body belongs to, "" for trees on the world, by body."""
    links, bases = model.links(), {WORLD: ""}
    for joint in model.joints:
        floats = joint.kind.floats and links[joint.parent] == WORLD
        bases[joint.child] = joint.name if floats else bases[joint.parent]
    return bases


def _pushed(applied: Applied, bases: Mapping[str, str]) -> Iterator[str]:
    """The free joints of the trees on which an effect acts from outside."""
    if applied.effect.body_force:
        yield bases[applied.on]
    elif applied.effect.pair_force or applied.effect.bodies_force:
        ends = {bases[body] for body in applied.bodies}
        yield from ends if len(ends) > 1 else ()
    elif applied.effect.joint_torque:
        yield from (applied.on, *(term.joint for term in applied.terms))


def _falling_line(fall: list[Joint], shaped: bool) -> str:
    names = ", ".join(joint.child for joint in fall[:3]) + (", …" if len(fall) > 3 else "")
    one = len(fall) == 1
    bodies = f"body {names}: it falls" if one else f"{len(fall)} free bodies ({names}): they fall"
    contact = "[effects.contact] with mu" if shaped else "[effects.contact.LABEL]"
    return (f"nothing holds {bodies}; write an effect that does, as {contact} or "
            '[effects.wrench.LABEL], base = "fixed", or falling = "accept" where that is meant')


_DRIVING = ("torque", "force")


def idle(effects: tuple[Applied, ...]) -> tuple[Notice, ...]:
    """A notice for each kind of effects whose torques and forces are constant zeros, with the entry
    of `runtime` that makes them arguments: actuators of kind "torque", wrenches; and for wind that
    no effect depends on, and ground that nothing touches."""
    effects_of: dict[str, list[str]] = {}
    for applied in effects:
        if names := list(_unset(applied)):
            effects_of.setdefault(applied.effect.name, []).extend(names)
    unfelt = () if any(x.effect.in_fluid for x in effects) else tuple(
        Notice(IDLE, f"effect {x.effect.name}", f"{x.effect.name} does nothing: no effect depends "
               "on the fluid; write [effects.drag.BODY]") for x in effects if x.effect.wind)
    if not any(x.effect.parts for x in effects):
        unfelt += tuple(Notice(IDLE, f"effect {x.effect.name}", f"{x.effect.name} does nothing: "
                               "nothing touches it; write [effects.contact.BODY]")
                        for x in effects if x.effect.ground)
    return (*unfelt, *(Notice(IDLE, f"effect {effect}", _idle_line(effect, names))
                       for effect, names in effects_of.items()))


def _unset(applied: Applied) -> Iterator[str]:
    """The names in `runtime` of the numbers that drive an effect, if all are zero."""
    kind = applied.values.get("kind", "torque")
    given = [name for name in _DRIVING if applied.values.get(name) is not None]
    if kind == "torque" and all(_zero(applied.values[name]) for name in given):
        yield from (f"{applied.name}.{name}" for name in given)


def _zero(setting: Setting) -> bool:
    numbers = setting if isinstance(setting, tuple) else (setting,)
    return all(isinstance(x, Fraction) and not x for x in numbers)


def _idle_line(effect: str, names: list[str]) -> str:
    first = ", ".join(f'"{name}"' for name in names[:3]) + (", …" if len(names) > 3 else "")
    does = "does nothing: it is" if len(names) == 1 else "do nothing: they are"
    return (f"{names[0] if len(names) == 1 else f'{len(names)} torques or forces of {effect}s'} "
            f"{does} zero, and no argument of the functions; write runtime = [{first}]")
