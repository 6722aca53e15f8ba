"""The units of a function's results, component by component, and numbers with their unit."""

import math
from collections.abc import Callable

from coscrew_codegen.digits import two_digits_up
from coscrew_codegen.scene.recorded import UNITS
from coscrew_codegen.scene_functions import SceneFunctions

Units = tuple[str, ...]

_PREFIXES = {1: "k", 0: "", -1: "m", -2: "µ", -3: "n"}  # others are less known than powers


def units(functions: SceneFunctions, name: str) -> Units:
    """The unit of each component of the function's results, in order; "1" if it has none."""
    count = sum(math.prod(a.quantity.shape) for a in functions.named(name).program.outputs)
    if name.startswith("effect_"):
        return tuple(unit for a in functions.named(name).program.outputs
                     for unit in (a.quantity.words.removeprefix("in "),) * a.quantity.size)
    made = _OF_FUNCTION.get(name) or _OF_FUNCTION.get(name.partition("_")[0], _always("1"))
    found = made(functions)
    return found * (count // len(found) if found else 0)  # those of bodies are all alike


def in_unit(x: float, unit: str) -> str:
    """Two digits, rounded up, and a prefix of the unit or a power of ten: 3 µN m, 7.1e-13 N m, 2e-7
    kg."""
    if math.isinf(x):
        return "unbounded"
    shown = float(two_digits_up(x * (1 - 1e-12)))  # so that 3e-6, which is no double, stays
    power = math.floor(math.log10(shown) / 3) if shown and math.isfinite(shown) else 0
    if power in _PREFIXES and not unit.startswith(("k", "1")):
        return f"{shown / 1000.0**power:.3g} {_PREFIXES[power]}{written(unit)}"
    return three_digits(shown) if unit == "1" else f"{three_digits(shown)} {written(unit)}"


def three_digits(x: float) -> str:
    """Three digits: 1.25, 1450, 1e-9."""
    digits, _, exponent = f"{float(f'{x:.2e}'):g}".partition("e")
    return f"{digits}e{int(exponent)}" if exponent else digits


def written(unit: str) -> str:
    """The unit for readers: rad/s²."""
    return unit.replace("^2", "²")


def _of_joints(which: str) -> Callable[[SceneFunctions], Units]:
    return lambda scene: tuple(unit for c in scene.coordinates for unit in UNITS[which][c.kind])


_velocities = _of_joints("v")


def _torques(scene: SceneFunctions) -> Units:
    return tuple("N m" if x == "rad/s" else "N" for x in _velocities(scene))


def _masses(scene: SceneFunctions) -> Units:
    turns = [x == "rad/s" for x in _velocities(scene)]
    return tuple(("kg", "kg m", "kg m^2")[a + b] for a in turns for b in turns)


def _jacobian(scene: SceneFunctions) -> Units:
    """Rows of linear velocity, then of angular velocity; a column for each velocity."""
    of = {"rad/s": ("m", "1"), "m/s": ("1", "1/m")}
    return tuple(of[x][row // 3] for row in range(6) for x in _velocities(scene))


def _always(*found: str) -> Callable[[SceneFunctions], Units]:
    return lambda scene: found


_MOMENTUM = _always("N s", "N s", "N s", "N m s", "N m s", "N m s")
_OF_FUNCTION = {
    "inverse_dynamics": _torques, "bias_torques": _torques, "gravity_torques": _torques,
    "forward_dynamics": _of_joints("a"), "mass_matrix": _masses, "energy": _always("J"),
    "power": _always("W"), "momentum": _MOMENTUM,
    "free_momentum": lambda scene: (*_MOMENTUM(scene), "m", "m", "m"),
    "with_free_momentum": lambda scene: (*_of_joints("q")(scene), *_velocities(scene)),
    "integrated": _of_joints("q"), "jacobian": _jacobian,
    "body_poses": _always("1", "1", "1", "m"), "parts": _always("1", "s"),
    "body_twists": _always("m/s", "m/s", "m/s", "rad/s", "rad/s", "rad/s"),
    "reaction": _always("N", "N", "N", "N m", "N m", "N m")}
