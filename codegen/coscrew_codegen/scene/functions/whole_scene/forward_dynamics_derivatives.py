"""Derivatives of forward dynamics."""

from coscrew_codegen.scene import units
from coscrew_codegen.scene.scene_function import Array, AxisLength, Depends, SceneFunction

_SQUARE = (AxisLength.NV, AxisLength.NV)
FUNCTION = SceneFunction(
    "forward_dynamics_derivatives", 22,
    "The derivatives of a = forward_dynamics(q, v, tau) with "
    "respect to q, along velocities (of q ⊕ phi at phi = 0), to "
    "v, and to tau: the inverse of M(q)",
    "q v tau", (
        Array("da_dq", _SQUARE, units.accelerations_by_displacements),
        Array("da_dv", _SQUARE, units.accelerations_by_velocities),
        Array("da_dtau", _SQUARE, units.accelerations_by_torques)),
    lambda x: x.acceleration_derivatives(), Depends.EFFECTS, divides=True)
