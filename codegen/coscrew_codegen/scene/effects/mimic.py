"""Mimic: joints with a mimic in the model follow their leaders and have no own coordinates."""

from coscrew_codegen.scene.effect import Effect, ParameterOf, Place

EFFECT = Effect(
    "mimic", "joints with a mimic follow their leaders; without this effect they move freely",
    "q_2 = multiplier q_1 + offset", Place.SCENE,
    (ParameterOf("joints", "", 'which joints follow: all that have a mimic in the model; "all" and '
                 '"model" mean the same', "choice", "all", choices=("all", "model")),),
    mimic=True, alone=True)
