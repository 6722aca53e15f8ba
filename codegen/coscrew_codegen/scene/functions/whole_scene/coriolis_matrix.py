"""The Coriolis matrix."""

from coscrew_codegen.scene import units
from coscrew_codegen.scene.scene_function import Array, AxisLength, SceneFunction, Situation


def _lacks(its: Situation) -> str:
    """Says why a scene with added inertia has no such matrix."""
    added = next((x.name for x in its.scene.effects if x.effect.body_inertia), "")
    return added and f"{added} adds inertia, whose Coriolis forces it does not have"


FUNCTION = SceneFunction(
    "coriolis_matrix", 32, "C(q, v), row by row: C v are the torques of Coriolis and centrifugal "
    "forces of bodies, and the rate of M(q) less 2 C is skew-symmetric", "q v",
    (Array("C", (AxisLength.NV, AxisLength.NV), units.torques_by_velocities),),
    lambda x: [x.coriolis_matrix()], lacks=_lacks)
