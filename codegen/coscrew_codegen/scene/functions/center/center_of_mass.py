"""The centre of mass."""

from coscrew_codegen.scene.scene_function import Array, SceneFunction, SceneQuantity

FUNCTION = SceneFunction(
    "center_of_mass", 84, "x = Σ m (R c + t) / Σ m, the centre of mass of all bodies that can "
    "move, in the world", "q", (Array("x", (3,), ("m",), "in m"),),
    lambda x: [x.centre_of_mass()], recorded=(SceneQuantity("center_of_mass"),))
