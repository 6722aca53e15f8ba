"""The regressor of torques."""

from coscrew_codegen.scene import units
from coscrew_codegen.scene.scene_function import (
    TAU,
    Array,
    AxisLength,
    Depends,
    SceneFunction,
    Situation,
)


def _units(its: Situation) -> tuple[str, ...]:
    """Units of Y, row by row, and of tau0."""
    torques = units.torques(its.kinds)
    return (*units.over(torques, its.linear.units), *torques)


FUNCTION = SceneFunction(
    "torque_regressor", 14, "Y and tau0 with inverse_dynamics(q, v, a) = Y pi + tau0, for all "
    "inertias and numbers of effects in pi = linear_parameters(); tau0, torques of effects that "
    "are not linear in their numbers", "q v a", (
        Array("Y", (AxisLength.NV, AxisLength.LINEAR), (), "torques for a unit of each parameter"),
        Array("tau0", TAU.shape, (), TAU.words)),
    lambda x: x.torque_regressor(), Depends.EFFECTS, units_in=_units, of_tree=True)
