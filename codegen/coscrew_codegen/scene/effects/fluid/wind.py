"""Wind: the fluid around all bodies moves."""

from coscrew_codegen.scene.effect import Effect, ParameterOf, Place

EFFECT = Effect(
    "wind", "motion of the fluid around all bodies: drag resists motion relative to it",
    "u is the point's velocity less that of the fluid", Place.SCENE,
    (ParameterOf("velocity", "m/s", "functions of t, in the world's frame", "formulas"),),
    wind=lambda values: values.vector("velocity"))
