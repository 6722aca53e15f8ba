"""Inertia that effects add to bodies, such as that of the fluid around them, and its wrench.

M is constant in the link's frame.  With the link's twist V = (v; w), the fluid's velocity u at all
places, and the rates of their components in the link's frame, the link needs the wrench

    M V_r' + [ad]*(V_r) M V_r,   V_r = (v - u; w),   [ad]*(V) (p; L) = (w × p; w × L + v × p).

Since [ad]*(V) M V does no work in fluid at rest, M is counted as the body's own with the energy
V·M V/2; what is left of the wrench's power, with V' = 0, is the work of wind.

In fluid at rest V = J v, so the Coriolis matrix is J^T (M J' + B J), with B X = [ad]*(X) M V.  B is
skew-symmetric, and so is (J^T M J)' less twice that matrix.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from coscrew_codegen.algebra.recording.numbers import (
    Number,
    Vector,
    add,
    angular,
    cross,
    displacement,
    linear,
    rotated_back,
    rotation,
    subtract,
)
from coscrew_codegen.algebra.recording.recorder import Recorder
from coscrew_codegen.dynamics.algorithms.aba import Articulated
from coscrew_codegen.dynamics.algorithms.motion import Motion, Twist
from coscrew_codegen.dynamics.algorithms.rnea import Wrench
from coscrew_codegen.dynamics.algorithms.screw_rates import subspace_rates
from coscrew_codegen.dynamics.forces.effect_parameters import settings
from coscrew_codegen.scene.mechanism.tree import Tree
from coscrew_codegen.scene.scene import Applied

Matrix = list[list[Number]]


@dataclass(frozen=True)
class Stream:
    """The velocity of the fluid and its rate, in the world's frame."""

    velocity: Vector
    rate: Vector


def inertia_in_link(applied: Applied, recorder: Recorder, tree: Tree) -> tuple[int, Articulated]:
    """(link, M at the link's origin in its frame) of an effect on a body."""
    link, placed = tree.link_and_body(applied.on)
    assert applied.effect.body_inertia
    own = applied.effect.body_inertia(settings(recorder, applied.values, recorder.number(0)))
    R, t = (recorder.numbers(x) for x in (placed.placement.R, placed.placement.t))
    place = displacement(R, t)
    at = recorder.call("product_dv", place, own.point)
    return link, Articulated(own.matrix).transformed(displacement(R, at))


def added_inertias(effects: Iterable[Applied], recorder: Recorder, tree: Tree
                   ) -> Iterable[tuple[int, Articulated]]:
    """The sums of the inertias that these effects add to links, by link, where these are not zero.
    What is added to a body that stands on the world moves nothing."""
    results: dict[int, Articulated] = {}
    for applied in effects:
        link, own = inertia_in_link(applied, recorder, tree)
        if link < 0 or own.is_zero:
            continue
        results[link] = results[link].plus(own) if link in results else own
    return results.items()


def wrench(motion: Motion, link: int, M: Articulated, stream: Stream | None) -> Wrench:
    """The wrench that the link's motion takes."""
    w, v = motion.angular_velocity(link), motion.velocity(link)
    own = rotation(motion.pose(link))
    falling = rotated_back(own, motion.gravity)
    if stream:
        v = subtract(v, rotated_back(own, stream.velocity))
        falling = subtract(falling, rotated_back(own, stream.rate))
    rate = subtract(add(motion.acceleration(link), falling), cross(w, v))
    return _wrench(M, (*v, *w), (*rate, *motion.angular_acceleration(link)))


def power_of_stream(motion: Motion, link: int, M: Articulated, stream: Stream) -> Number:
    """-V·(the wrench at V' = 0): the power of moving fluid on the link."""
    w, v = motion.angular_velocity(link), motion.velocity(link)
    own = rotation(motion.pose(link))
    u, u_rate = (rotated_back(own, x) for x in (stream.velocity, stream.rate))
    rate = (*subtract(cross(w, u), u_rate), *motion.zero)
    needed = _wrench(M, (*subtract(v, u), *w), rate)
    return -motion.recorder.call("dot_cs", needed, (*v, *w))[0]


def with_coriolis(motion: Motion, link: int, M: Articulated, C: Matrix) -> Matrix:
    """C with the Coriolis matrix of the inertia that is added to a link, in fluid at rest."""
    momentum, total = M.times(motion.twist(link)), [list(row) for row in C]
    every = list(_freedoms(motion, link))
    with motion.part(link, "C"):
        for column in every:
            needed = add(M.times(column.rate), _turned(column.screw, momentum))
            for row in every:
                value = motion.recorder.call("dot_cs", needed, row.screw)[0]
                own = total[row.velocity]
                own[column.velocity] = own[column.velocity] + value * (row.times * column.times)
    return total


@dataclass(frozen=True)
class _LinkFreedom:
    """A freedom that moves a link: its velocity is a multiple of one of the scene's, its screw and
    the rate of its components are in the link's frame."""

    velocity: int
    times: Fraction | int
    screw: Twist
    rate: Twist


def _freedoms(motion: Motion, link: int) -> Iterator[_LinkFreedom]:
    """The freedoms from a link inwards: X' = (V_joint - V) × X + S', moved to the link's frame."""
    call, links, number, moved = motion.recorder.call, motion.tree.links, link, motion.zero
    D = displacement(motion.recorder.numbers([int(i % 4 == 0) for i in range(9)]), moved)
    while number >= 0:
        own, driver = links[number], links[number].driver
        with motion.part(link, "J"):
            U = subtract(call("product_Adinvs", D, motion.twist(number)), motion.twist(link))
            screws = zip(motion.subspace(number), subspace_rates(motion, number), strict=True)
            for k, screw_and_rate in enumerate(screws):
                X, S = (call("product_Adinvs", D, x) for x in screw_and_rate)
                rate: Twist = add(call("cross_ss", U, X), S)
                yield _LinkFreedom(links[driver.link].v.start if driver else own.v.start + k,
                               driver.multiplier if driver else 1, X, rate)
            D = call("product_dd", motion.frame(number), D)
        number = own.parent


def _wrench(M: Articulated, twist: Sequence[Number], rate: Sequence[Number]) -> Wrench:
    """M V' + [ad]*(V) M V."""
    momentum, needed = M.times(tuple(twist)), M.times(tuple(rate))
    return add(needed, _turned(twist, momentum))


def _turned(twist: Sequence[Number], momentum: Sequence[Number]) -> Wrench:
    """[ad]*(V) (p; L)."""
    p, L, v, w = linear(momentum), angular(momentum), linear(twist), angular(twist)
    return (*cross(w, p), *add(cross(w, L), cross(v, p)))
