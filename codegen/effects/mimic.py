"""Mimic: joints that the model lets follow others do so, and have no coordinates of their own."""

from coscrew_codegen.scene.effect import Effect, ParameterOf, Place

EFFECT = Effect(
    "mimic", "followers of the model follow; without it they move on their own",
    "q_2 = multiplier q_1 + offset", Place.SCENE,
    (ParameterOf("joints", "", "which joints follow: those the model says", "choice", "all",
                 choices=("all", "model")),),
    mimic=True)
