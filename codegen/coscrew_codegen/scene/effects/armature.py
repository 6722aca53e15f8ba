"""Armature: the inertia of a motor's rotor, reflected to its joint, or to a sum of coordinates."""

from typing import TYPE_CHECKING

from coscrew_codegen.scene.effect import Effect, ParameterOf, Place, Values

if TYPE_CHECKING:
    from coscrew_codegen.algebra.recording.numbers import Number


def _inertia(values: Values) -> "Number":
    """inertia + gear^2 rotor, without the terms that are not given."""
    inertia, gear, rotor = values.get("inertia"), values["gear"], values.get("rotor")
    if rotor is None:
        return values["inertia"]
    reflected = gear * gear * rotor
    return reflected if inertia is None else inertia + reflected


EFFECT = Effect(
    "armature", "inertia of a joint itself, as of a motor's rotor with a gear, or of a sum w·q",
    "M_jj = M_jj + inertia + gear^2 rotor; on a sum M = M + (inertia + gear^2 rotor) w w^T",
    Place.JOINT,
    (ParameterOf("inertia", "kg m^2 or kg", "reflected to the joint", required=False,
                 nonnegative=True),
     ParameterOf("rotor", "kg m^2", "inertia of the rotor", required=False, nonnegative=True),
     ParameterOf("gear", "1, or rad/m", "turns of the rotor for one of the joint", default=1)),
    any_of=("inertia", "rotor"), joint_inertia=_inertia, stores_energy=True, each=True)
