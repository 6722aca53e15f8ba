"""The regressor of torques for base parameters."""

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
    return (*units.over(torques, its.linear.base_units), *torques)


FUNCTION = SceneFunction(
    "base_regressor", 18, "Y and tau0 with inverse_dynamics(q, v, a) = Y beta + tau0, with the "
    "fewest columns: those of torque_regressor that are independent; beta = base_parameters()",
    "q v a", (
        Array("Y", (AxisLength.NV, AxisLength.BASE), (), "torques for a unit of each parameter"),
        Array("tau0", TAU.shape, (), TAU.words)),
    lambda x: x.base_regressor(), Depends.EFFECTS, units_in=_units, of_tree=True)
