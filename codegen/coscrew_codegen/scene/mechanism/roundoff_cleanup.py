"""Removes residues of arithmetic in files: lengths and moments that are meant to be zero."""

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from coscrew_codegen.scene.mechanism.loop import ClosedLoop
from coscrew_codegen.scene.mechanism.model import Body, Inertia, Joint, Model, Placement, value
from coscrew_codegen.scene.mechanism.rotations import snapped, unit

LENGTH = Fraction(1, 10**18)
"""Coordinates of origins and centres of mass, in m, up to which they count as zero.  Files contain
2.7e-51 m for zero, and products of two such numbers leave single precision's range.  For a robot of
a metre, 1e-18 m is 1 % of the rounding error in double precision."""

TURNED = Fraction(1, 10**15)
"""A product of inertia xy up to this times √(xx yy) counts as zero, and moments that differ by up
to this times xx as equal: residues of rotating equal moments in double precision."""


def without_residues(model: Model) -> Model:
    """The model with zero in place of its residues."""
    return replace(model, bodies=tuple(map(_body, model.bodies)),
                   joints=tuple(map(_joint, model.joints)),
                   loops=tuple(map(_loop, model.loops)))


def without_residue(placement: Placement) -> Placement:
    """A frame composed of frames, rounded as theirs are: right angles that their rotations add up
    to are exact, and coordinates that cancel are zero."""
    return Placement(snapped(placement.R), tuple(map(length, placement.t)))


def length(x: Fraction) -> Fraction:
    """A coordinate, or zero up to LENGTH."""
    return Fraction(0) if abs(x) <= LENGTH else x


def _joint(joint: Joint) -> Joint:
    at = joint.placement
    return replace(joint, placement=replace(at, t=tuple(map(length, at.t))))


def _loop(loop: ClosedLoop) -> ClosedLoop:
    first, second = (replace(x, point=tuple(map(length, x.point)), R=snapped(x.R),
                             axis=unit(x.axis))
                     for x in (loop.first, loop.second))
    return replace(loop, first=first, second=second)


def _body(body: Body) -> Body:
    if body.inertia is None:
        return body
    inertia = body.inertia
    return replace(body, inertia=Inertia(
        inertia.mass, tuple(length(value(x)) for x in inertia.com),
        without_turned(tuple(map(value, inertia.moments)), TURNED)))


def without_turned(moments: Sequence[Fraction], within: Fraction) -> tuple[Fraction, ...]:
    """Moments xx, yy, zz, xy, xz, yz without the residues of turning equal ones: products xy up to
    `within` √(xx yy) become zero, and moments that differ by up to `within` xx equal."""
    def product(xy: Fraction, xx: Fraction, yy: Fraction) -> Fraction:
        return Fraction(0) if xy * xy <= within**2 * abs(xx * yy) else xy

    def moment(yy: Fraction, xx: Fraction) -> Fraction:
        return xx if abs(yy - xx) <= within * abs(xx) else yy

    xx, yy, zz, xy, xz, yz = moments
    yy = moment(yy, xx)
    zz = moment(moment(zz, xx), yy)
    return xx, yy, zz, product(xy, xx, yy), product(xz, xx, zz), product(yz, yy, zz)
