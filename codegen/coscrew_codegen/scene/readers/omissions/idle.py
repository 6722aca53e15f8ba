"""Effects that exert nothing: their drive is zero and no argument of the functions, or nothing is
in the wind, or on the ground."""

from collections.abc import Iterator
from fractions import Fraction

from coscrew_codegen.scene.mechanism.notices import IDLE, Notice
from coscrew_codegen.scene.scene import Applied, Setting

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
    return (*unfelt, *(Notice(IDLE, f"effect {effect}", _line(effect, names))
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


def _line(effect: str, names: list[str]) -> str:
    first = ", ".join(f'"{name}"' for name in names[:3]) + (", …" if len(names) > 3 else "")
    does = "does nothing: it is" if len(names) == 1 else "do nothing: they are"
    return (f"{names[0] if len(names) == 1 else f'{len(names)} torques or forces of {effect}s'} "
            f"{does} zero, and no argument of the functions; write runtime = [{first}]")
