"""A revolute joint: its child turns about an axis."""

from coscrew_codegen.scene.mechanism.joint_kind import (
    Displacement,
    JointKind,
    JointState,
    Screw,
    numbers,
)


def _displacement(x: JointState, placement: Displacement) -> Displacement:
    """D₀ [R(n, q) | 0]."""
    return x.turned(placement, x.rotation(x.axes[0], x.q[0]))


def _subspace(x: JointState) -> tuple[Screw, ...]:
    """(0; n)."""
    return ((*x.zero, *x.axes[0]),)


JOINT = JointKind(
    "revolute", 10, "turns about {0}", (numbers("angle", "rad"),), "in rad", "in rad/s",
    _displacement, _subspace, axes=("axis of rotation",), unlimited=("continuous",),
    urdf="revolute", synonyms=("hinge", "pin", "rotary", "rotational"))
