"""Rates of coordinates as a matrix."""

from coscrew_codegen.scene import units
from coscrew_codegen.scene.effect_quantities import states_of
from coscrew_codegen.scene.scene_function import Array, AxisLength, Depends, SceneFunction
from coscrew_codegen.scene.situation import Situation


def _units(its: Situation) -> tuple[str, ...]:
    """Units of q, which ends with the states of effects, over those of phi, row by row."""
    states = (unit for x in states_of(its.scene) for unit in x.units)
    return units.over((*units.coordinates(its.kinds), *states), units.displacements(its.kinds))


FUNCTION = SceneFunction(
    "chart", 142, "N with q' = N v: the derivative of q ⊕ phi with respect to phi at phi = 0, "
    "which turns derivatives by coordinates into derivatives along velocities; states of effects "
    "have rows of zeros", "q", (Array("N", (AxisLength.NQ, AxisLength.NV), ()),),
    lambda x: [x.chart()], Depends.GEOMETRY, units_in=_units)
