"""The velocity of the centre of mass."""

from coscrew_codegen.scene.scene_function import Array, SceneFunction, SceneQuantity

FUNCTION = SceneFunction(
    "center_of_mass_velocity", 86,
    "v = p / Σ m, the velocity of the centre of mass, in the world's axes", "q v",
    (Array("x_rate", (3,), ("m/s",), "in m/s"),),
    lambda x: [x.centre_of_mass_velocity()], recorded=(SceneQuantity("center_of_mass_velocity"),))
