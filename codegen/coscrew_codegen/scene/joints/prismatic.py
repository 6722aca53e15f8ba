"""A prismatic joint: its child slides along an axis."""

from coscrew_codegen.algebra.recording.numbers import (
    add,
    displacement,
    rotation,
    scaled,
    translation,
)
from coscrew_codegen.scene.mechanism.joint_kind import (
    Displacement,
    JointKind,
    JointState,
    Screw,
    numbers,
)


def _displacement(x: JointState, placement: Displacement) -> Displacement:
    """[R₀ | t₀ + q R₀ n]."""
    R = rotation(placement)
    along = scaled(x.q[0], x.rotated(R, x.axes[0]))
    return displacement(R, add(translation(placement), along))


def _subspace(x: JointState) -> tuple[Screw, ...]:
    """(n; 0)."""
    return ((*x.axes[0], *x.zero),)


JOINT = JointKind(
    "prismatic", 20, "moves along {0}", (numbers("position", "m"),), "in m", "in m/s",
    _displacement, _subspace, axes=("axis of sliding",), urdf="prismatic",
    synonyms=("slider", "slide", "sliding", "translational"))
