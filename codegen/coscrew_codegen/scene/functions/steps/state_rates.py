"""Rates of the states of effects."""

from coscrew_codegen.scene import units
from coscrew_codegen.scene.effect_quantities import states_of
from coscrew_codegen.scene.scene_function import Array, AxisLength, Depends, Q, SceneFunction
from coscrew_codegen.scene.situation import STATES, Situation


def _units(its: Situation) -> tuple[str, ...]:
    """Units of x' and q."""
    own = [unit for x in states_of(its.scene) for unit in x.units]
    return (*(f"{unit}/s" for unit in own), *units.coordinates(its.kinds), *own)


FUNCTION = SceneFunction(
    "state_rates", 152, "dx, the rates of the states x of effects, and q with x within their "
    "bounds", "q v", (Array("dx", (AxisLength.EFFECT_STATES,), (), "rates of x"), Q),
    lambda x: x.state_rates(), Depends.EFFECTS, needs=STATES, units_in=_units)
