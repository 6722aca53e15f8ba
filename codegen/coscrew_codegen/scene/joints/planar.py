"""A planar joint: its child moves in a plane, and turns about the plane's normal."""

from fractions import Fraction

from coscrew_codegen.algebra.recording.numbers import (
    add,
    displacement,
    negative,
    rotation,
    scaled,
    translation,
)
from coscrew_codegen.scene.mechanism.joint_kind import (
    Direction,
    Displacement,
    JointKind,
    JointState,
    Numbers,
    Screw,
    numbers,
)
from coscrew_codegen.scene.mechanism.rotations import unit


def _frame(axes: tuple[Direction, ...]) -> tuple[Direction, ...]:
    """(x, y, n) of the normal n.  Of the joint's axes, x is the one after the one nearest to n (of
    z it is x, of x it is y), less its part along n; y = n × x."""
    n, = axes
    nearest = max(range(3), key=lambda i: (abs(n[i]), i))
    along = n[(nearest + 1) % 3]
    x = unit(tuple(Fraction(int(i == (nearest + 1) % 3)) - along * n[i] for i in range(3)))
    y = tuple(n[i - 2] * x[i - 1] - n[i - 1] * x[i - 2] for i in range(3))
    return x, y, n


def _displacement(joint: JointState, placement: Displacement) -> Displacement:
    """[R₀ | t₀ + R₀ (q₀ x + q₁ y)] [R(n, q₂) | 0]."""
    (x, y, n), R, t = joint.axes, rotation(placement), translation(placement)
    for q, direction in zip(joint.q, (x, y), strict=False):
        t = add(t, scaled(q, joint.rotated(R, direction)))
    return joint.turned(displacement(R, t), joint.rotation(n, joint.q[2]))


def _subspace(joint: JointState) -> tuple[Screw, ...]:
    """(R^T x; 0), (R^T y; 0), (0; n)."""
    x, y, n = joint.axes
    R = joint.rotation(n, joint.q[2])
    return ((*joint.rotated_back(R, x), *joint.zero), (*joint.rotated_back(R, y), *joint.zero),
            (*joint.zero, *n))


def _subspace_rate(joint: JointState, v: Numbers) -> Screw:
    """(-v₂ n × R^T (v₀ x + v₁ y); 0)."""
    x, y, n = joint.axes
    R = joint.rotation(n, joint.q[2])
    moving = joint.rotated_back(R, add(scaled(v[0], x), scaled(v[1], y)))
    return (*negative(joint.cross(scaled(v[2], n), moving)), *joint.zero)


JOINT = JointKind(
    "planar", 40, "moves in the plane with the normal {0}",
    (numbers("position", "m", 2), numbers("angle", "rad")), "x, y in m, angle in rad",
    "rates of x, y in m/s, of the angle in rad/s", _displacement, _subspace, _subspace_rate,
    axes=("normal of the plane",), frame=_frame, urdf="planar")
