"""Inverse dynamics of a model under gravity, to any number of digits, by Newton's and Euler's laws.

All in the world's frame, body by body: the forces of the bodies' motions are summed over all bodies
that a joint carries.  Shares nothing with the generator but the model.  Joints have one coordinate
or are fixed."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, TypeAlias

import mpmath
from mpmath import matrix, mpf

from coscrew_codegen.scene.mechanism.joint_kind import JointKind
from coscrew_codegen.scene.mechanism.model import WORLD, Inertia, Model, value
from tests.support.scenes.kinds import Kind

Vector: TypeAlias = Any  # mpmath has no types


def _number(x: Fraction) -> mpf:
    return mpf(x.numerator) / x.denominator


def _vector(values: Sequence[Fraction]) -> Vector:
    return matrix([_number(x) for x in values])


def _cross(a: Vector, b: Vector) -> Vector:
    return matrix([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                   a[0] * b[1] - a[1] * b[0]])


def _dot(a: Vector, b: Vector) -> mpf:
    return sum((a[k] * b[k] for k in range(3)), mpf(0))


def _about(n: Vector, angle: mpf) -> Vector:
    """The rotation about the unit vector n, after Rodrigues."""
    tilde = matrix([[0, -n[2], n[1]], [n[2], 0, -n[0]], [-n[1], n[0], 0]])
    return mpmath.eye(3) + mpmath.sin(angle) * tilde + (1 - mpmath.cos(angle)) * tilde * tilde


@dataclass(frozen=True)
class _Motion:
    """Motion of a body's frame: rotation, origin, angular velocity and acceleration, the origin's
    acceleration less gravity's."""

    R: Vector
    p: Vector
    w: Vector
    dw: Vector
    a: Vector


def _effort(inertia: Inertia, at: _Motion) -> tuple[Vector, Vector]:
    """Force, and moment about the world's origin, that the body's motion takes."""
    com = at.R * _vector([value(x) for x in inertia.com])
    xx, yy, zz, xy, xz, yz = (_number(value(x)) for x in inertia.moments)
    about_com = at.R * matrix([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) * at.R.T
    force = _number(value(inertia.mass)) * (
        at.a + _cross(at.dw, com) + _cross(at.w, _cross(at.w, com)))
    turning = about_com * at.dw + _cross(at.w, about_com * at.w)
    return force, turning + _cross(at.p + com, force)


def inverse_dynamics(model: Model, gravity: Sequence[Fraction], q: Sequence[mpf],
                     v: Sequence[mpf], a: Sequence[mpf]) -> list[mpf]:
    """τ of each joint that moves, in the order of the model, from q, v and a in that order."""
    still = matrix([0, 0, 0])
    motions = {WORLD: _Motion(mpmath.eye(3), still, still, still, -_vector(gravity))}
    axes: dict[str, tuple[Vector, Vector, JointKind]] = {}  # by the joint's child
    state = iter(zip(q, v, a, strict=True))
    for joint in model.joints:
        parent = motions[joint.parent]
        placement = [_number(x) for x in joint.placement.R]
        R = parent.R * matrix([placement[:3], placement[3:6], placement[6:]])
        n, r = R * _vector(joint.axis), parent.R * _vector(joint.placement.t)
        w, dw = parent.w, parent.dw
        sliding, speeding = still, still
        if joint.kind is not Kind.FIXED:
            position, speed, acceleration = next(state)
            if joint.kind is Kind.REVOLUTE:
                R = R * _about(_vector(joint.axis), position)
                w, dw = w + speed * n, dw + acceleration * n + speed * _cross(w, n)
            else:
                r = r + position * n
                sliding, speeding = speed * n, acceleration * n
            axes[joint.child] = (n, parent.p + r, joint.kind)
        motions[joint.child] = _Motion(
            R, parent.p + r, w, dw,
            parent.a + _cross(parent.dw, r) + _cross(parent.w, _cross(parent.w, r))
            + 2 * _cross(parent.w, sliding) + speeding)
    carried = {joint.child: (still, still) for joint in model.joints}
    for body in model.bodies:
        if body.inertia:
            carried[body.name] = _effort(body.inertia, motions[body.name])
    for joint in reversed(model.joints):
        if joint.parent != WORLD:
            carried[joint.parent] = tuple(
                x + y for x, y in zip(carried[joint.parent], carried[joint.child], strict=True))
    return [_torque(*axes[x.child], *carried[x.child])
            for x in model.joints if x.kind is not Kind.FIXED]


def _torque(n: Vector, p: Vector, kind: JointKind, force: Vector, moment: Vector) -> mpf:
    """Along the axis, at the joint's origin."""
    return _dot(n, moment - _cross(p, force)) if kind is Kind.REVOLUTE else _dot(n, force)
