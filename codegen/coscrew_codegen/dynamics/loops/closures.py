"""Closures of loops at the motion of a tree.

A loop holds its first link by constraint coscrews H̄ = (f; τ), which except for a rod's are
constants in that link's frame, and its second link by the opposite ones, which are the same
coscrews in another frame: so the momentum of both does not change.  With the displacement D of the
second link in the first, V = (v; ω) the links' twists and A the rates of their components,

    U = V₁ - [Ad](D) V₂,   E v = H̄·U,   E' v = H̄·(A₁ - [Ad](D) A₂ + [ad](V₁) [Ad](D) V₂) + H̄'·U

The closure φ grows with E v: in m, or the tangent of half an angle, twice, so that it is zero at no
angle but zero.  Velocities of joints that carry both links have exact zeros in E."""

from collections.abc import Iterator, Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from functools import cached_property

from coscrew_codegen.algebra.recording.numbers import (
    Number,
    Vector,
    add,
    cross,
    displacement,
    dot,
    linear,
    negative,
    rotated,
    rotation,
    scaled,
    sqrt,
    subtract,
    translation,
)
from coscrew_codegen.dynamics.algorithms import rnea
from coscrew_codegen.dynamics.algorithms.motion import Displacement, Motion, Twist
from coscrew_codegen.dynamics.algorithms.rnea import Wrench
from coscrew_codegen.scene.mechanism.loop import FRAME, HINGE, ROD, ClosedLoop, LoopEnd, across
from coscrew_codegen.scene.mechanism.tree import Tree

Row = list[Number]  # a number for each velocity


@dataclass(frozen=True)
class Closure:
    """A loop's closure at a motion."""

    loop: ClosedLoop
    motion: Motion
    owner: str  # prefix of the names of its values

    def __hash__(self) -> int:
        return id(self)

    @cached_property
    def ends(self) -> tuple[tuple[int, Displacement], ...]:
        """(link, the loop's frame in it) of both ends."""
        return tuple(_placed(self.motion, end) for end in (self.loop.first, self.loop.second))

    @cached_property
    def links(self) -> tuple[int, int]:
        """Both links."""
        (first, _), (second, _) = self.ends
        return first, second

    @cached_property
    def carrier(self) -> int:
        """The last link that carries both; -1: the world."""
        first, second = (list(_below(self.motion.tree, x, -1)) for x in self.links)
        return max({*first, -1}.intersection({*second, -1}))

    @cached_property
    def between(self) -> Displacement:
        """D of the second link in the first."""
        first, second = (_within(self.motion, x, self.carrier) for x in self.links)
        with self.part("D"):
            return self.motion.recorder.call("product_dinvd", first, second)

    @cached_property
    def separation(self) -> Vector:
        """From the second point to the first, in the first link's frame."""
        first, second = (translation(D) for _, D in self.ends)
        with self.part("d"):
            D = self.between
            return subtract(first, add(rotated(rotation(D), second), translation(D)))

    @cached_property
    def direction(self) -> Vector:
        """The separation's, of length 1."""
        with self.part("n"):
            d = self.separation
            return scaled(1 / sqrt(dot(d, d)), d)

    @cached_property
    def phi(self) -> list[Number]:
        """The closure, row by row."""
        d, kind = self.separation, self.loop.kind
        with self.part("phi"):
            if kind is ROD:
                return [sqrt(dot(d, d)) - self.loop.length]
            angles = _turned(self) if kind is FRAME else _tilted(self) if kind is HINGE else []
            return [*d, *angles]

    @cached_property
    def coscrews(self) -> list[Wrench]:
        """H̄ of each row, on the first link, in its frame."""
        zero, numbers = self.motion.zero, self.motion.recorder.numbers
        point, kind = translation(self.ends[0][1]), self.loop.kind
        with self.part("H"):
            if kind is ROD:
                return [(*self.direction, *cross(point, self.direction))]
            units = [numbers([int(i == k) for i in range(3)]) for k in range(3)]
            pure = units if kind is FRAME else self._axes[1:] if kind is HINGE else []
            return [*((*x, *cross(point, x)) for x in units), *((*zero, *x) for x in pure)]

    @property
    def exerted(self) -> list[Wrench]:
        """The wrench on the first link, in its frame, of a multiplier of 1 of each row."""
        return self.coscrews

    @cached_property
    def _axes(self) -> tuple[Vector, ...]:
        """A hinge's axis and two across it, in the first link's frame."""
        own, numbers = rotation(self.ends[0][1]), self.motion.recorder.numbers
        axis = self.loop.first.axis
        return tuple(rotated(own, numbers(x)) for x in (axis, *across(axis)))

    @cached_property
    def rows(self) -> list[Row]:
        """E."""
        return [self.torques(H) for H in self.coscrews]

    def torques(self, H: Wrench) -> Row:
        """The torques of a wrench on the first link and its opposite on the second."""
        row = [self.motion.zero[0]] * self.motion.tree.nv
        first, second = self.links
        _enter(self.motion, first, self.carrier, H, row)
        if second != self.carrier:
            with self.part("H"):
                other = self.motion.recorder.call("product_CoAdinvc", self.between, negative(H))
            _enter(self.motion, second, self.carrier, other, row)
        return row

    @cached_property
    def rates(self) -> list[Number]:
        """E' v at the motion's velocities: the rate of E v at a = 0."""
        V, U = self._twists
        with self.part("g"):
            call = self.motion.recorder.call
            first, second = (_rate(self.motion, x) for x in self.links)
            moved = subtract(first, call("product_Ads", self.between, second))
            rate = add(moved, call("cross_ss", V, U))
            results = [call("dot_cs", H, rate)[0] for H in self.coscrews]
            return [x + self._turning for x in results] if self.loop.kind is ROD else results

    @property
    def _turning(self) -> Number:
        """H̄'·(V₁ - [Ad] V₂) of a rod: n'·u, with n' = (d' - n (n·d'))/|d|."""
        V, U = self._twists
        call, point = self.motion.recorder.call, translation(self.ends[0][1])
        relative = subtract(V, U)
        u = linear(call("product_Adtinvs", point, relative))
        d, n = self.separation, self.direction
        moving = subtract(u, cross(relative[3:], d))
        return (dot(moving, u) - dot(n, moving) * dot(n, u)) / sqrt(dot(d, d))

    @cached_property
    def _twists(self) -> tuple[Twist, Twist]:
        """V₁ and [Ad](D) V₂."""
        first, second = (_twist(self.motion, x) for x in self.links)
        with self.part("V"):
            return first, self.motion.recorder.call("product_Ads", self.between, second)

    def total(self, coscrews: Sequence[Wrench], multipliers: Mapping[int, Number]) -> Wrench:
        """Σ H̄ λ of these rows."""
        total: Wrench = (*self.motion.zero, *self.motion.zero)
        with self.part("f"):
            for k, x in multipliers.items():
                total = add(total, scaled(x, coscrews[k]))
        return total

    def holding(self, multipliers: Mapping[int, Number]) -> Row:
        """E^T λ."""
        return self.torques(self.total(self.coscrews, multipliers))

    def on_links(self, multipliers: Mapping[int, Number]) -> Iterator[tuple[int, Wrench]]:
        """The wrench on the first link and its opposite on the second, of the links that move."""
        (first, second), wrench = self.links, self.total(self.coscrews, multipliers)
        with self.part("f"):
            if first >= 0:
                yield first, wrench
            if second >= 0:
                call = self.motion.recorder.call
                yield second, call("product_CoAdinvc", self.between, negative(wrench))

    def at_point(self, wrench: Wrench) -> Wrench:
        """A wrench on the first link in the first body's frame, at the loop's point."""
        numbers, call = self.motion.recorder.numbers, self.motion.recorder.call
        _, placed = self.motion.tree.link_and_body(self.loop.first.body)
        R, point = numbers(placed.placement.R), translation(self.ends[0][1])
        return call("product_CoAdinvc", displacement(R, point), wrench)

    def part(self, symbol: str) -> AbstractContextManager[None]:
        """Names the instructions of a block after this value of the loop."""
        return self.motion.recorder.part(self.owner, symbol, f"loop {self.loop.name!r}")


def _placed(motion: Motion, end: LoopEnd) -> tuple[int, Displacement]:
    """The link of an end, and the end's frame in it."""
    numbers = motion.recorder.numbers
    number, placed = motion.tree.link_and_body(end.body)
    own = displacement(numbers(placed.placement.R), numbers(placed.placement.t))
    there = displacement(numbers(end.R), numbers(end.point))
    return number, motion.recorder.call("product_dd", own, there)


def _below(tree: Tree, link: int, carrier: int) -> Iterator[int]:
    """The links from one inwards to the carrier, without it."""
    while link != carrier:
        yield link
        link = tree.links[link].parent


def _within(motion: Motion, link: int, carrier: int) -> Displacement:
    """D of a link in one that carries it."""
    if carrier < 0:
        return motion.pose(link)
    D = displacement(motion.recorder.numbers([int(i % 4 == 0) for i in range(9)]), motion.zero)
    for number in _below(motion.tree, link, carrier):
        with motion.part(number, "Rl"):
            D = motion.recorder.call("product_dd", motion.frame(number), D)
    return D


def _enter(motion: Motion, link: int, carrier: int, wrench: Wrench, row: Row) -> None:
    """Adds to a row the components of a wrench on a link along the joints up to the carrier."""
    for number in _below(motion.tree, link, carrier):
        with motion.part(number, "e"):
            rnea.gather(motion, number, rnea.along(motion, number, wrench), row)
            wrench = motion.recorder.call("product_CoAdc", motion.frame(number), wrench)


def _twist(motion: Motion, link: int) -> Twist:
    return motion.twist(link) if link >= 0 else (*motion.zero, *motion.zero)


def _rate(motion: Motion, link: int) -> Twist:
    """The rates of the components of (v; ω), less gravity's, which all links share."""
    if link < 0:
        return (*motion.acceleration(link), *motion.zero)
    w, v = motion.angular_velocity(link), motion.velocity(link)
    return (*subtract(motion.acceleration(link), cross(w, v)), *motion.angular_acceleration(link))


def _turned(closure: Closure) -> list[Number]:
    """The rotation of the first frame in the second, in the first link's axes: 2 tan(θ/2) n."""
    call, (_, first), (_, second) = closure.motion.recorder.call, *closure.ends
    there = call("product_drdr", rotation(closure.between), rotation(second))
    Q = call("product_drdrinv", there, rotation(first))
    size = 2 / (1 + (Q[0] + Q[4] + Q[8]))
    return [size * x for x in (Q[5] - Q[7], Q[6] - Q[2], Q[1] - Q[3])]


def _tilted(closure: Closure) -> list[Number]:
    """The rotation that takes the first axis from the second, along both directions across it."""
    (_, second), numbers = closure.ends[1], closure.motion.recorder.numbers
    own = rotated(rotation(second), numbers(closure.loop.second.axis))
    other, (axis, *across_it) = rotated(rotation(closure.between), own), closure._axes
    size, tilt = 2 / (1 + dot(axis, other)), cross(other, axis)
    return [size * dot(x, tilt) for x in across_it]
