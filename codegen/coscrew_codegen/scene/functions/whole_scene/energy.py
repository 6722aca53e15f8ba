"""Kinetic and potential energy, and their sum in recordings."""

from coscrew_codegen.scene.scene_function import (
    ALWAYS,
    Array,
    Depends,
    SceneFunction,
    SceneQuantity,
)

FUNCTION = SceneFunction(
    "energy", 60, "e = (kinetic, potential) energy; gravity's is zero for centres of mass at the "
    "world's origin", "q v", (Array("e", (2,), ("J",), "energies in J"),),
    lambda x: [x.energies()], Depends.EFFECTS, ALWAYS,
    (SceneQuantity("energy", components=("kinetic", "potential", "total"),
                   places=((0,), (1,), (0, 1)), expected="total"),))
