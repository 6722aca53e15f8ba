"""A universal joint: its child turns about an axis, and that about one fixed to the parent."""

from coscrew_codegen.algebra.recording.numbers import scaled
from coscrew_codegen.scene.mechanism.joint_kind import (
    Displacement,
    JointKind,
    JointState,
    Numbers,
    Screw,
    numbers,
)


def _displacement(x: JointState, placement: Displacement) -> Displacement:
    """D₀ [R(n₁, q₁) | 0] [R(n₂, q₂) | 0]."""
    first = x.turned(placement, x.rotation(x.axes[0], x.q[0]))
    return x.turned(first, x.rotation(x.axes[1], x.q[1]))


def _subspace(x: JointState) -> tuple[Screw, ...]:
    """(0; R₂^T n₁), (0; n₂)."""
    first, second = x.axes
    return (*x.zero, *x.rotated_back(x.rotation(second, x.q[1]), first)), (*x.zero, *second)


def _subspace_rate(x: JointState, v: Numbers) -> Screw:
    """(0; v₁ R₂^T n₁ × v₂ n₂)."""
    first, second = (screw[3:] for screw in _subspace(x))
    return *x.zero, *x.cross(scaled(v[0], first), scaled(v[1], second))


JOINT = JointKind(
    "universal", 30, "turns about {0} and {1}", (numbers("first angle", "rad"),
                                                     numbers("second angle", "rad")),
    "angles about both axes in rad", "rates of both angles in rad/s", _displacement, _subspace,
    _subspace_rate, axes=("first axis of rotation, fixed to the parent",
                          "second axis of rotation, fixed to the child"),
    perpendicular=True, synonyms=("cardan", "hooke", "gimbal"),
    without_urdf="two continuous joints, with a link without <inertial> between them, move alike")
