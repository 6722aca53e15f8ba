"""Torques of links as linear functions of their inertias.

With the acceleration a of a link's origin less gravity's, U = w'~ + w~ w~, and the screw (l; e) of
a freedom at or before the link, at its origin in its frame, the freedom's torque is

    m (l·a) + h·(U^T l + a × e) + e·(I w' + w × I w)

linear in mass m, first moment h = m c and moments of inertia I about the origin, not in c.
"""

from collections.abc import Sequence

from coscrew_codegen.algebra.recording.numbers import (
    Number,
    add,
    angular,
    cross,
    dot,
    linear,
    rotated_back,
)
from coscrew_codegen.dynamics.algorithms.motion import Displacement, Motion, Twist
from coscrew_codegen.dynamics.algorithms.rnea import gather

NAMES = ("m", "mx", "my", "mz", "Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz")
"""Mass, first and second moments of a link about its origin, in its frame."""
UNITS = ("kg", *["kg m"] * 3, *["kg m^2"] * 6)


def columns(motion: Motion) -> list[Sequence[Number]]:
    """The torques for a unit of each number of each link, the others zero."""
    return [column for number in range(len(motion.tree.links)) for column in _of(motion, number)]


def _of(motion: Motion, number: int) -> list[list[Number]]:
    """The columns of a link."""
    call, links, zero = motion.recorder.call, motion.tree.links, motion.zero[0]
    moments = [_moment(motion, number, k) for k in range(6)]
    results = [[zero] * motion.tree.nv for _ in NAMES]
    at, D = number, None
    while at >= 0:
        with motion.part(number, "Y"):
            rows = [_row(motion, number, moments, s if D is None else call(
                "product_Adinvs", D, s)) for s in motion.subspace(at)]
            for column, parts in zip(results, zip(*rows, strict=True), strict=True):
                gather(motion, at, parts, column)
            frame: Displacement = motion.frame(at)
            D = frame if D is None else call("product_dd", frame, D)
        at = links[at].parent
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
