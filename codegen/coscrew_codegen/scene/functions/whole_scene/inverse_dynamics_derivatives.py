"""Derivatives of inverse dynamics."""

from coscrew_codegen.scene import units
from coscrew_codegen.scene.scene_function import Array, AxisLength, Depends, SceneFunction

_SQUARE = (AxisLength.NV, AxisLength.NV)
FUNCTION = SceneFunction(
    "inverse_dynamics_derivatives", 12,
    "The derivatives of tau = inverse_dynamics(q, v, a) with "
    "respect to q, along velocities (of q ⊕ phi at phi = 0), to "
    "v, and to a: M(q); of effects at a corner, those of the "
    "option taken",
    "q v a", (
        Array("dtau_dq", _SQUARE, units.torques_by_displacements),
        Array("dtau_dv", _SQUARE, units.torques_by_velocities),
        Array("M", _SQUARE, units.masses)),
    lambda x: x.torque_derivatives(), Depends.EFFECTS)
