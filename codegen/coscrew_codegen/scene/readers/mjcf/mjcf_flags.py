"""Flags of an MJCF, as `<flag spring="disable"/>`: what they switch off is not in the model."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import mujoco

_OFF: Mapping[tuple[str, ...], tuple[str, ...]] = {
    ("SPRING",): ("jnt_stiffness", "jnt_stiffnesspoly", "tendon_stiffness",
                  "tendon_stiffnesspoly"),
    ("DAMPER",): ("dof_damping", "dof_dampingpoly", "tendon_damping", "tendon_dampingpoly",
                  "actuator_damping", "actuator_dampingpoly"),
    ("SPRING", "DAMPER"): ("body_gravcomp",),  # with both all passive forces are off
    ("EQUALITY",): ("eq_active0",), ("CONSTRAINT",): ("eq_active0",)}
"""The numbers of a compiled model that are zero while all these bits are set."""


def obey_flags(model: "mujoco.MjModel") -> None:
    """Set what the model's flags switch off to zero; gravity and actuators have their own readers.
    """
    import mujoco

    bits, off = mujoco.mjtDisableBit, model.opt.disableflags
    for flags, arrays in _OFF.items():
        if all(off & int(getattr(bits, f"mjDSBL_{x}")) for x in flags):
            for name in arrays:
                getattr(model, name)[:] = 0
    if off & int(bits.mjDSBL_SPRING) and off & int(bits.mjDSBL_DAMPER):
        model.opt.density = model.opt.viscosity = 0.0
