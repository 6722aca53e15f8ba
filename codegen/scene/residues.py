"""Residues of the programs that write files: lengths and moments that are meant to be zero."""

from dataclasses import replace
from fractions import Fraction

from coscrew_codegen.scene.model import Body, Inertia, Joint, Model, value

LENGTH = Fraction(1, 10**18)
"""Lengths in m up to which an origin or a centre of mass is at zero.  Files hold 2.7e-51 m where
zero is meant: products of two such leave single precision's range.  On a robot of a metre, 1e-18 m
is 1 % of double's rounding."""

TURNED = Fraction(1, 10**15)
"""Parts of √(xx yy) up to which a product of inertia xy is zero, and of xx up to which yy is xx:
what is left of equal moments that are turned by angles, whose sines and cosines are doubles."""


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
    """yy, or xx where they are the same but for TURNED."""
    return xx if abs(yy - xx) <= TURNED * abs(xx) else yy
