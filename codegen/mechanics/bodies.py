"""Inertias of links: those of their bodies, lumped; of constant bodies a constant."""

from collections.abc import Sequence
from dataclasses import dataclass

from coscrew_codegen.recording.numbers import (
    Number,
    Vector,
    add,
    cross,
    dot,
    rotated,
    row_by_row,
    scaled,
)
from coscrew_codegen.recording.recorder import Recorder
from coscrew_codegen.scene.model import Inertia
from coscrew_codegen.scene.tree import Seat

UPPER = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
"""Where the six numbers of a symmetric matrix stand."""


@dataclass(frozen=True)
class Rigid:
    """Mass, first moment h = m c, moments of inertia about the origin (xx, yy, zz, xy, xz, yz)."""

    m: Number
    h: Vector
    I: tuple[Number, ...]

    @property
    def numbers(self) -> tuple[Number, ...]:
        """All ten, as the library's operations on inertias take them."""
        return (self.m, *self.h, *self.I)

    @property
    def second(self) -> tuple[Number, ...]:
        """∫ r r^T dm = tr(I)/2 - I, its six numbers."""
        half = (self.I[0] + self.I[1] + self.I[2]) / 2
        return tuple(half - x if n < 3 else -x for n, x in enumerate(self.I))

    @property
    def vanishes(self) -> bool:
        """Whether it is zero."""
        return all(x.is_zero for x in self.numbers)


def symmetric(six: Sequence[Number]) -> tuple[Number, ...]:
    """The nine entries, row by row, of the matrix with these six."""
    xx, yy, zz, xy, xz, yz = six
    return (xx, xy, xz, xy, yy, yz, xz, yz, zz)


def lumped(recorder: Recorder, seats: Sequence[Seat]) -> Rigid:
    """The inertia of all the bodies as one, in their link's frame."""
    zero = recorder.number(0)
    total = (zero,) * 10
    for seat in seats:
        if seat.body.inertia:
            total = add(total, _seated(recorder, seat, seat.body.inertia))
    return Rigid(total[0], tuple(total[1:4]), tuple(total[4:]))


def _seated(recorder: Recorder, seat: Seat, inertia: Inertia) -> tuple[Number, ...]:
    number, numbers, call = recorder.number, recorder.numbers, recorder.call
    about_com = symmetric(numbers(inertia.moments))
    own = call("spatial_inertia_from_com", number(inertia.mass), numbers(inertia.com), about_com)
    R, t = numbers(seat.placement.R), numbers(seat.placement.t)
    return call("spatial_inertia_transformed", row_by_row(R, t), own)


def net_force(body: Rigid, curl: Sequence[Number], acceleration: Vector) -> tuple[Vector, Vector]:
    """Force and moment about the origin that give a body this motion.

    F = m a + U h; N = h × a + ∫ r × U r dm, where U = ω'~ + ω~ ω~ maps points to
    their accelerations beyond the origin's a.  The integral takes 15 products,
    against 24 of I ω' + ω × I ω.
    """
    xx, yy, zz, xy, xz, yz = body.second
    Uxx, Uxy, Uxz, Uyx, Uyy, Uyz, Uzx, Uzy, Uzz = curl
    turning = (
        (yy * Uzy - zz * Uyz) + (yz * (Uzz - Uyy) + (xy * Uzx - xz * Uyx)),
        (zz * Uxz - xx * Uzx) + (xz * (Uxx - Uzz) + (yz * Uxy - xy * Uzy)),
        (xx * Uyx - yy * Uxy) + (xy * (Uyy - Uxx) + (xz * Uyz - yz * Uxz)))
    force = add(scaled(body.m, acceleration), rotated(curl, body.h))
    return force, add(turning, cross(body.h, acceleration))


def kinetic_energy(body: Rigid, velocity: Vector, turning: Vector) -> Number:
    """(m v·v)/2 + v·(ω × h) + (ω·I ω)/2."""
    own = dot(turning, rotated(symmetric(body.I), turning)) + body.m * dot(velocity, velocity)
    return own / 2 + dot(velocity, cross(turning, body.h))
