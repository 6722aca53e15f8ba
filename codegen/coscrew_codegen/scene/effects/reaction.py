"""Reaction: the wrench that a joint transmits, as a function of the scene."""

from coscrew_codegen.scene.effect import Effect, Place

EFFECT = Effect(
    "reaction", "adds a function for the wrench that a joint transmits, also along its freedoms",
    "f = (force; moment) on the joint's child, S^T f = tau + the effects' torque",
    Place.JOINT, (), reaction=True)
