"""Rotations as exact fractions: entries computed in 50 digits, and snapped to 0 and ±1.

Rotations are nine entries, row by row, as in `Placement`.
"""

from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import mpmath

DIGITS = 50

SNAP = Fraction(1, 10**11)
"""Entries this close to 0 or ±1 count as 0 or ±1.  Files write right angles as 1.57079632679, which
has an error of 4.9e-12, and matrices computed in double precision hold residues such as 6e-17;
kernels that multiply by these would cost as much as those for oblique axes.  1e-11 rad moves a
point at a distance of 100 m by a nanometre."""

IDENTITY = tuple(Fraction(i % 4 == 0) for i in range(9))

Entries = tuple[Fraction, ...]


@cache  # a visual and a collision often stand at one place
def from_rpy(roll: Fraction, pitch: Fraction, yaw: Fraction) -> Entries:
    """R = Rz(yaw) Ry(pitch) Rx(roll), angles in rad.  (9)."""
    return product(_about(2, yaw), product(_about(1, pitch), _about(0, roll)))


def from_quaternion(quaternion: Sequence[Fraction]) -> Entries:
    """R = 1 + 2 (w v~ + v~²) / (w² + v·v) of (v; w) = (x, y, z, w).  (9).

    Raises ValueError if it is zero."""
    x, y, z, w = quaternion
    norm = w * w + x * x + y * y + z * z
    if not norm:
        raise ValueError("the quaternion is zero")
    two = 2 / norm
    return _rounded((
        1 - two * (y * y + z * z), two * (x * y - w * z), two * (x * z + w * y),
        two * (x * y + w * z), 1 - two * (x * x + z * z), two * (y * z - w * x),
        two * (x * z - w * y), two * (y * z + w * x), 1 - two * (x * x + y * y)))


def quaternion(R: Entries) -> Entries:
    """x, y, z, w of norm 1 of a rotation, to 50 digits; the largest is positive.  (9)->(4).

    4 q q^T has the entries 1 + R_xx - R_yy - R_zz, R_xy + R_yx, …; its row with the largest entry
    on the diagonal, normalized, is q."""
    xx, xy, xz, yx, yy, yz, zx, zy, zz = R
    rows = ((1 + xx - yy - zz, xy + yx, xz + zx, zy - yz),
            (xy + yx, 1 - xx + yy - zz, yz + zy, xz - zx),
            (xz + zx, yz + zy, 1 - xx - yy + zz, yx - xy),
            (zy - yz, xz - zx, yx - xy, 1 + xx + yy + zz))
    return unit(max(enumerate(rows), key=lambda x: x[1][x[0]])[1])


def from_axis_angle(axis: Sequence[Fraction], angle: Fraction) -> Entries:
    """R = 1 + sin(angle) n~ + (1 - cos(angle)) n~², n = axis/|axis|, angle in rad.  (9).

    Raises ValueError if the axis is zero."""
    x, y, z = unit(axis)
    sine, cosine = _sine_cosine(angle)
    rest = 1 - cosine
    return _rounded((
        cosine + rest * x * x, rest * x * y - sine * z, rest * x * z + sine * y,
        rest * x * y + sine * z, cosine + rest * y * y, rest * y * z - sine * x,
        rest * x * z - sine * y, rest * y * z + sine * x, cosine + rest * z * z))


def unit(vector: Iterable[Fraction]) -> Entries:
    """v / |v|, snapped, of any length; raises ValueError if |v| is zero."""
    entries = tuple(vector)
    square = sum(x * x for x in entries)
    if not square:
        raise ValueError("the vector is zero")
    if square == 1:
        return snapped(entries)
    import mpmath

    with mpmath.workdps(DIGITS):
        norm = mpmath.sqrt(_real(square))
        return snapped([_fraction(_real(x) / norm) for x in entries])


def product(left: Entries, right: Entries) -> Entries:
    """R = left right, rounded to 50 digits and snapped.  (9),(9)->(9)."""
    if IDENTITY in (left, right):  # true of most rpy angles: two are 0
        return right if left == IDENTITY else left
    return _rounded([sum((left[3 * i + k] * right[3 * k + j] for k in range(3)), Fraction(0))
                     for i in range(3) for j in range(3)])


def rotated(R: Entries, moments: Sequence[Fraction]) -> Entries:
    """R I R^T of the symmetric matrix I, both as xx, yy, zz, xy, xz, yz.  (9),(6)->(6)."""
    if R == IDENTITY:
        return tuple(moments)
    xx, yy, zz, xy, xz, yz = moments
    matrix = (xx, xy, xz, xy, yy, yz, xz, yz, zz)
    half = tuple(_dot(R[3 * i:3 * i + 3], matrix[3 * j:3 * j + 3])
                 for i in range(3) for j in range(3))
    return tuple(_dot(half[3 * i:3 * i + 3], R[3 * j:3 * j + 3])
                 for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)))


def turned(R: Entries, vector: Sequence[Fraction]) -> Entries:
    """R v, exactly.  (9),(3)->(3)."""
    return tuple(_dot(R[3 * i:3 * i + 3], tuple(vector)) for i in range(3))


def _dot(a: Entries, b: Entries) -> Fraction:
    """a·b, exactly; right angles make most terms zero."""
    return sum((x * y for x, y in zip(a, b, strict=True) if x and y), Fraction(0))


def snapped(entries: Sequence[Fraction]) -> Entries:
    """A vector, a rotation, or a sine and cosine, with entries within SNAP of 0 set to 0; an entry
    that is then alone in its row and column is set to ±1.

    An entry close to ±1 is not enough: for a rotation by 1e-6 rad it differs by 1e-12 only."""
    zeros = [Fraction(0) if abs(x) <= SNAP else x for x in entries]
    width = 3 if len(zeros) == 9 else len(zeros)

    def alone(place: int) -> bool:
        row, column = divmod(place, width)
        return not any(zeros[other] for other in range(len(zeros)) if other != place
                       and (other // width == row or other % width == column))

    return tuple(Fraction(round(x)) if x and abs(abs(x) - 1) <= SNAP and alone(place) else x
                 for place, x in enumerate(zeros))


def _about(axis: int, angle: Fraction) -> Entries:
    """The rotation about a coordinate axis; sine and cosine are snapped together, so that the
    result is a rotation."""
    if not angle:
        return IDENTITY
    sine, cosine = _sine_cosine(angle)
    entries = list(IDENTITY)
    after, last = (axis + 1) % 3, (axis + 2) % 3
    entries[3 * after + after] = entries[3 * last + last] = cosine
    entries[3 * after + last], entries[3 * last + after] = -sine, sine
    return tuple(entries)


def _sine_cosine(angle: Fraction) -> Entries:
    import mpmath

    with mpmath.workdps(DIGITS):
        cosine, sine = mpmath.cos_sin(_real(angle))
        return snapped([_fraction(sine), _fraction(cosine)])


def _rounded(entries: Sequence[Fraction]) -> Entries:
    """The entries, snapped, to 50 digits: without rounding, products would have more and more."""
    import mpmath

    with mpmath.workdps(DIGITS):
        return tuple(x if x.denominator == 1 else _fraction(_real(x)) for x in snapped(entries))


def _real(x: Fraction) -> "mpmath.mpf":
    import mpmath

    return mpmath.mpf(x.numerator) / x.denominator


def _fraction(x: "mpmath.mpf") -> Fraction:
    sign, mantissa, exponent, _ = x._mpf_
    return Fraction((-1)**int(sign) * int(mantissa)) * Fraction(2)**int(exponent)
