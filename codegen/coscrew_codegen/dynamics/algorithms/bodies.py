"""Inertias of links: the sums of those of their bodies; constants if these are constant."""

from collections.abc import Sequence
from dataclasses import dataclass

from coscrew_codegen.algebra.recording.numbers import Number, Vector, add, displacement
from coscrew_codegen.algebra.recording.recorder import Recorder
from coscrew_codegen.scene.mechanism.model import Inertia
from coscrew_codegen.scene.mechanism.tree import PlacedBody, Tree, lumped_inertia


@dataclass(frozen=True)
class Rigid:
    """Mass, first moment h = m c, moments of inertia about the origin (xx, yy, zz, xy, xz, yz);
    beside them the 36 numbers of the inertia that effects add, which only accelerations feel."""

    m: Number
    h: Vector
    I: tuple[Number, ...]
    added: tuple[Number, ...] | None = None

    @property
    def numbers(self) -> tuple[Number, ...]:
        """All ten numbers, as an argument of the library's operations."""
        return (self.m, *self.h, *self.I)

    @property
    def vanishes(self) -> bool:
        """True if it is zero."""
        return all(x.is_zero for x in self.numbers)


def rigids(recorder: Recorder, names: Sequence[str], tree: Tree) -> list[Rigid]:
    """The inertia of each link; `names` are the links' prefixes in the names of values."""
    results = []
    for name, link in zip(names, tree.links, strict=True):
        with recorder.part(name, "B", link.heading):
            own, label = lumped(recorder, link.bodies), recorder.label
            results.append(rigid_of((*label("Bm", own.m), *label("Bh", own.h),
                                     *label("BI", own.I))))
    return results


def symmetric(six: Sequence[Number]) -> tuple[Number, ...]:
    """The nine entries, row by row, of the symmetric matrix with these six numbers."""
    xx, yy, zz, xy, xz, yz = six
    return (xx, xy, xz, xy, yy, yz, xz, yz, zz)


def lumped(recorder: Recorder, bodies: Sequence[PlacedBody]) -> Rigid:
    """The inertia of all the bodies as one, in their link's frame: constants, unless some have
    parameters."""
    changing = [(placed, placed.body.inertia) for placed in bodies
                if placed.body.inertia and placed.body.inertia.changes]
    constant = lumped_inertia([x for x in bodies if x.body.inertia and not x.body.inertia.changes])
    total: Sequence[Number] = recorder.numbers(constant.numbers)
    for placed, inertia in changing:
        total = add(total, _inertia_in_link(recorder, placed, inertia))
    return rigid_of(total)


def rigid_of(numbers: Sequence[Number]) -> Rigid:
    """The inertia with these ten numbers."""
    return Rigid(numbers[0], tuple(numbers[1:4]), tuple(numbers[4:]))


def _inertia_in_link(recorder: Recorder, placed: PlacedBody, inertia: Inertia
                     ) -> tuple[Number, ...]:
    number, numbers, call = recorder.number, recorder.numbers, recorder.call
    about_com = symmetric(numbers(inertia.moments))
    own = call("spatial_inertia_from_com", number(inertia.mass), numbers(inertia.com), about_com)
    D = displacement(numbers(placed.placement.R), numbers(placed.placement.t))
    return call("spatial_inertia_transformed", D, own)
