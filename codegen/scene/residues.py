"""Removes residues of arithmetic in files: lengths and moments that are meant to be zero."""

from dataclasses import replace
from fractions import Fraction

from coscrew_codegen.scene.model import Body, Inertia, Joint, Model, value

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
                   joints=tuple(map(_joint, model.joints)))


def _length(x: Fraction) -> Fraction:
    return Fraction(0) if abs(x) <= LENGTH else x


def _joint(joint: Joint) -> Joint:
    at = joint.placement
    return replace(joint, placement=replace(at, t=tuple(map(_length, at.t))))


def _body(body: Body) -> Body:
    if body.inertia is None:
        return body
    inertia = body.inertia
    xx, yy, zz, xy, xz, yz = map(value, inertia.moments)
    yy = _moment(yy, xx)
    zz = _moment(_moment(zz, xx), yy)
    return replace(body, inertia=Inertia(
        inertia.mass, tuple(_length(value(x)) for x in inertia.com),
        (xx, yy, zz, _product(xy, xx, yy), _product(xz, xx, zz), _product(yz, yy, zz))))


def _product(xy: Fraction, xx: Fraction, yy: Fraction) -> Fraction:
    """xy, or 0 where xy² <= TURNED² xx yy."""
    return Fraction(0) if xy * xy <= TURNED**2 * abs(xx * yy) else xy


def _moment(yy: Fraction, xx: Fraction) -> Fraction:
    """yy, or xx if they differ by at most TURNED xx."""
    return xx if abs(yy - xx) <= TURNED * abs(xx) else yy
