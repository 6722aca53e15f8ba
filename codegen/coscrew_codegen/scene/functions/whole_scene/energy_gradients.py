"""Gradients of the kinetic and the potential energy."""

from coscrew_codegen.scene import units
from coscrew_codegen.scene.scene_function import Array, AxisLength, Depends, SceneFunction

FUNCTION = SceneFunction(
    "energy_gradients", 62, "The gradients of e = energy(q, v): of the kinetic energy T with "
    "respect to q, along velocities (of q ⊕ phi at phi = 0), and to v: M(q) v, the generalized "
    "momenta; of the potential energy V with respect to q", "q v", (
        Array("dT_dq", (AxisLength.NV,), units.torques),
        Array("dT_dv", (AxisLength.NV,), units.momenta),
        Array("dV_dq", (AxisLength.NV,), units.torques)),
    lambda x: x.energy_gradients(), Depends.EFFECTS)
