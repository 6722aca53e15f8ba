"""Torques of links as linear functions of their inertias.

With the acceleration a of a link's origin less gravity's, U = w'~ + w~ w~, and the screw (l; e) of
a freedom at or before the link, at its origin in its frame, the freedom's torque is

    m (l·a) + h·(U^T l + a × e) + e·(I w' + w × I w)

linear in mass m, first moment h = m c and moments of inertia I about the origin, not in c.
"""

from collections.abc import Mapping, Sequence

from coscrew_codegen.algebra.recording.numbers import (
    Number,
    add,
    angular,
    cross,
    dot,
    linear,
    rotated_back,
)
from coscrew_codegen.dynamics.algorithms.motion import Motion, Twist
from coscrew_codegen.dynamics.algorithms.rnea import gather

NAMES = ("m", "mx", "my", "mz", "Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz")
"""Mass, first and second moments of a link about its origin, in its frame."""
UNITS = ("kg", *["kg m"] * 3, *["kg m^2"] * 6)

_Screws = Mapping[int, Sequence[Twist]]
"""Screws of the freedoms at a link and at those before it, in its frame; by link."""


def columns(motion: Motion) -> list[Sequence[Number]]:
    """The torques for a unit of each number of each link, the others zero."""
    screws: list[_Screws] = []
    for number, link in enumerate(motion.tree.links):
        before = screws[link.parent] if link.parent >= 0 else {}
        screws.append({number: motion.subspace(number), **_moved(motion, number, before)})
    return [column for number, own in enumerate(screws) for column in _of(motion, number, own)]


def _moved(motion: Motion, number: int, screws: _Screws) -> _Screws:
    """Screws of the link before, in the link's frame."""
    D, call = motion.frame(number), motion.recorder.call
    with motion.part(number, "n"):
        return {at: [call("product_Adinvs", D, s) for s in own] for at, own in screws.items()}


def _of(motion: Motion, number: int, screws: _Screws) -> list[list[Number]]:
    """The columns of a link."""
    moments = [_moment(motion, number, k) for k in range(6)]
    results = [[motion.zero[0]] * motion.tree.nv for _ in NAMES]
    for at, own in screws.items():
        with motion.part(number, "Y"):
            rows = [_row(motion, number, moments, s) for s in own]
            for column, parts in zip(results, zip(*rows, strict=True), strict=True):
                gather(motion, at, parts, column)
    return results


def _moment(motion: Motion, number: int, place: int) -> tuple[Number, ...]:
    """I w' + w × I w for a unit of one moment of inertia."""
    zero = motion.zero[0]
    unit = [zero.like(int(k == 4 + place)) for k in range(10)]
    acceleration = *motion.zero, *motion.angular_acceleration(number)
    return motion.recorder.call("spatial_inertia_net_wrench", unit,
                                motion.angular_velocity(number), acceleration)[3:]


def _row(motion: Motion, number: int, moments: Sequence[tuple[Number, ...]], s: Twist
         ) -> list[Number]:
    """The torques along a freedom."""
    l, e, a = linear(s), angular(s), motion.acceleration(number)
    first = add(rotated_back(motion.acceleration_tensor(number), l), cross(a, e))
    return [dot(l, a), *first, *(dot(e, x) for x in moments)]
