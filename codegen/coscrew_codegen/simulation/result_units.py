"""The units of a function's results, component by component, and numbers with their unit."""

import math

from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.program.values.digits import three_digits, two_digits_up

Units = tuple[str, ...]

_PREFIXES = {1: "k", 0: "", -1: "m", -2: "µ", -3: "n"}  # others are less known than powers


def units(functions: SceneFunctions, name: str) -> Units:
    """The unit of each component of the function's results, in order; "1" for plain numbers."""
    return functions.named(name).units


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


def written(unit: str) -> str:
    """The unit for readers: rad/s²."""
    return unit.replace("^2", "²")
