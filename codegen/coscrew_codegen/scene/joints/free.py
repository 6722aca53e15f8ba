"""A free joint: its child moves as if nothing carried it."""

from coscrew_codegen.algebra.recording.numbers import (
    add,
    cross,
    displacement,
    rotated,
    rotated_back,
    subtract,
)
from coscrew_codegen.scene.mechanism.joint_kind import (
    ROTATION,
    Displacement,
    JointKind,
    JointState,
    Manifold,
    Numbers,
    Screw,
    call,
    numbers,
    quaternion_difference,
    quaternion_integrated,
    quaternion_rate,
    quaternion_velocity,
)


def _displacement(x: JointState, placement: Displacement) -> Displacement:
    """D₀ [R(q) | x]."""
    R = x.quaternion_rotation(x.q[3:])
    return x.composed(placement, displacement(R, x.q[:3]))


def _subspace(x: JointState) -> tuple[Screw, ...]:
    """1."""
    return tuple(x.numbers([int(i == k) for i in range(6)]) for k in range(6))


def _integrated(q: Numbers, phi: Numbers) -> Numbers:
    """The frame [R(q) | x] moved by the screw motion phi."""
    exponential = call("SE3_exp", phi)
    R = call("mat3x3_from_quaternion", q[3:])
    position = add(q[:3], rotated(R, exponential[3::4]))
    return (*position, *quaternion_integrated(q[3:], phi[3:]))


def _difference(q1: Numbers, q0: Numbers) -> Numbers:
    """(J_l(ω)⁻¹ R0^T (x1 - x0); ω), ω the rotation vector of q0* q1."""
    omega = quaternion_difference(q1[3:], q0[3:])
    apart = call("rotate_qconjv", q0[3:], subtract(q1[:3], q0[:3]))
    return (*rotated(call("SO3_leftJacobianInverse", omega), apart), *omega)


def _velocities(q: Numbers, rate: Numbers) -> Numbers:
    """(R^T x'; 2 vec(q* q'))."""
    moving = call("rotate_qconjv", q[3:], rate[:3])
    return (*moving, *quaternion_velocity(q[3:], rate[3:]))


def _rates(x: JointState, r: Numbers, v: Numbers) -> Numbers:
    """(R v, r (ω; 0) / 2)."""
    moving = x.quaternion_rotated(x.q[3:], tuple(v[:3]))
    return (*moving, *quaternion_rate(x, r[3:], v[3:]))


def _bracket(phi: Numbers, v: Numbers) -> Numbers:
    """[ad](phi) v."""
    return call("cross_ss", phi, v)


def _deviation(q: Numbers, q0: Numbers) -> Numbers:
    """(R^T (x - x0); the rotation vector of q0* q)."""
    apart = subtract(tuple(q[:3]), tuple(q0[:3]))
    return (*rotated_back(call("mat3x3_from_quaternion", q[3:]), apart),
            *quaternion_difference(q[3:], q0[3:]))


def _inertial(v: Numbers) -> Numbers:
    """(ω × v; 0)."""
    linear, angular = tuple(v[:3]), tuple(v[3:])
    return (*cross(angular, linear), *(x.like(0) for x in angular))


JOINT = JointKind(
    "free", 60, "moves freely", (numbers("position", "m", 3), ROTATION),
    "position in m, then quaternion (x, y, z, w)",
    "velocity in m/s, then angular velocity in rad/s, both in the body's frame",
    _displacement, _subspace,
    manifold=Manifold(_integrated, _difference, _bracket, _rates, _velocities,
                      deviation=_deviation, inertial=_inertial), urdf="floating",
    synonyms=("floating", "freeflyer", "free_flyer", "free-flyer"), base=True, floats=True)
