"""Bodies with a free base that nothing holds against gravity."""

from collections.abc import Iterator, Mapping

from coscrew_codegen.scene.contacts.touching_parts import touches
from coscrew_codegen.scene.mechanism.model import WORLD, Joint, Model
from coscrew_codegen.scene.mechanism.notices import FALLING, Notice
from coscrew_codegen.scene.scene import Applied, zero

ACCEPT = "accept"
"""The value of a scene's `falling` without which the notice is given."""


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
    return (Notice(FALLING, f"joint {fall[0].name}", _line(fall, shaped)),) if fall else ()


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


def _line(fall: list[Joint], shaped: bool) -> str:
    names = ", ".join(joint.child for joint in fall[:3]) + (", …" if len(fall) > 3 else "")
    one = len(fall) == 1
    bodies = f"body {names}: it falls" if one else f"{len(fall)} free bodies ({names}): they fall"
    contact = "[effects.contact] with mu" if shaped else "[effects.contact.LABEL]"
    return (f"nothing holds {bodies}; write an effect that does, as {contact} or "
            '[effects.wrench.LABEL], base = "fixed", or falling = "accept" where that is meant')
