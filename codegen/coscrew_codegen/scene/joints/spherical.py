"""A spherical joint: its child turns about a point."""

from coscrew_codegen.algebra.recording.numbers import cross
from coscrew_codegen.scene.mechanism.joint_kind import (
    ROTATION,
    Displacement,
    JointKind,
    JointState,
    Manifold,
    Numbers,
    Screw,
    quaternion_difference,
    quaternion_integrated,
    quaternion_rate,
    quaternion_velocity,
)


def _displacement(x: JointState, placement: Displacement) -> Displacement:
    """D₀ [R(q) | 0]."""
    return x.turned(placement, x.quaternion_rotation(x.q))


def _subspace(x: JointState) -> tuple[Screw, ...]:
    """(0; 1)."""
    return tuple((*x.zero, *x.numbers(row))
                 for row in ((1, 0, 0), (0, 1, 0), (0, 0, 1)))


def _rates(x: JointState, r: Numbers, v: Numbers) -> Numbers:
    return quaternion_rate(x, r, v)


def _bracket(phi: Numbers, v: Numbers) -> Numbers:
    """phi × v."""
    return cross(tuple(phi), tuple(v))


JOINT = JointKind(
    "spherical", 50, "turns freely", (ROTATION,), "quaternion (x, y, z, w)",
    "angular velocity in rad/s in the body's frame", _displacement, _subspace,
    manifold=Manifold(quaternion_integrated, quaternion_difference, _bracket, _rates,
                      quaternion_velocity, deviation=quaternion_difference),
    urdf="spherical", synonyms=("ball", "socket"))
