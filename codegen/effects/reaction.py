"""Reaction: what a joint transmits, as a function of its own."""

from coscrew_codegen.scene.effect import Effect, Place

EFFECT = Effect(
    "reaction", "gives a function for the wrench a joint transmits, along its freedoms too",
    "f = (force; moment) on the body behind the joint, S^T f = tau + the effects' torque",
    Place.JOINT, (), reaction=True)
