"""A fixed joint: its child is part of what carries it."""

from coscrew_codegen.scene.mechanism.joint_kind import Displacement, JointKind, JointState


def _displacement(x: JointState, placement: Displacement) -> Displacement:
    """D₀."""
    return placement


JOINT = JointKind(
    "fixed", 70, "is fixed", (), "", "", _displacement, lambda x: (), urdf="fixed",
    synonyms=("weld", "welded", "rigid"), base=True)
