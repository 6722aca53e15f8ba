"""Motion of a tree's links: frames, velocities, accelerations, each computed on first use.

All vectors of a link are in its own frame.  Accelerations are those of points (not of screws), so
that linear velocities are needed only for prismatic and free joints, and for effects that use them.
"""

from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager
from functools import wraps

from coscrew_codegen.algebra.recording.numbers import (
    Number,
    Vector,
    add,
    angular,
    cross,
    displacement,
    linear,
    rotated,
    rotated_back,
    rotation,
    scaled,
    subtract,
    translation,
)
from coscrew_codegen.algebra.recording.recorder import Recorder
from coscrew_codegen.dynamics.algorithms.recorded_joint import RecordedJoint
from coscrew_codegen.scene.mechanism.tree import Tree

Numbers = tuple[Number, ...]
Rotation = tuple[Number, ...]  # nine, row by row
Displacement = tuple[Number, ...]  # twelve: [R | t], row by row
Twist = tuple[Number, ...]  # six: velocity of the origin; angular velocity


def _of_link(symbol: str, origin: str = "") -> Callable[["_OfLink"], "_OfLink"]:
    """Decorates a method: its value is computed once per link and named by the symbol, below the
    link's heading.  `origin` names the translation of a displacement."""
    def decorated(compute: "_OfLink") -> "_OfLink":
        @wraps(compute)
        def cached(self: "Motion", link: int) -> Numbers:
            known = self._known.setdefault(symbol, {})
            if link not in known:
                with self.part(link, symbol):
                    result, label = compute(self, link), self.recorder.label
                    known[link] = displacement(
                        label(symbol, rotation(result)), label(origin, translation(result))
                    ) if origin else label(symbol, result)
            return known[link]
        return cached
    return decorated


_OfLink = Callable[["Motion", int], Numbers]


class Motion:
    """The motion of all links for the function's q, v, a; v is zero unless `moving`, a unless
    `accelerating`; `at` = (q, v) replaces the function's, `a` its accelerations; `states` are the
    places of effects' states behind the coordinates in q, by the effects' names.  `carried`: the
    acceleration of a free base is that of its origin, in its axes, instead of the rate of its v."""

    def __init__(self, recorder: Recorder, tree: Tree, names: Sequence[str],
                 gravity: Vector | None = None, moving: bool = True, accelerating: bool = True,
                 at: tuple[Sequence[Number], Sequence[Number]] | None = None,
                 a: Sequence[Number] | None = None, states: Mapping[str, range] | None = None,
                 carried: bool = False):
        self.recorder, self.tree, self.names = recorder, tree, names
        self._known: dict[str, dict[int, Numbers]] = {}
        self._subspaces: dict[int, tuple[Twist, ...]] = {}
        zero = recorder.number(0)
        self.zero: Vector = (zero, zero, zero)
        self.gravity = gravity or self.zero
        still = (zero,) * tree.nv
        self._q: Sequence[Number] = recorder.argument("q") if recorder.has("q") else ()
        self.v: Sequence[Number] = (
            recorder.argument("v") if moving and recorder.has("v") else still)
        if at:
            self._q, self.v = at
        self.a: Sequence[Number] = a or (
            recorder.argument("a") if accelerating and recorder.has("a") else still)
        self.still = not (moving and recorder.has("v"))
        self._states, self._carried = states or {}, carried

    @property
    def x(self) -> tuple[Number, ...]:
        """The states of effects, behind the coordinates in q."""
        return tuple(self._q[self.tree.nq:])

    def states(self, effect: str) -> tuple[Number, ...]:
        """The states x of the effect of this name."""
        return tuple(self.x[place] for place in self._states.get(effect, ()))

    def at_rest(self) -> "Motion":
        """The links at the same q, without velocities and accelerations."""
        return Motion(self.recorder, self.tree, self.names, self.gravity, moving=False,
                      accelerating=False, at=(self._q, (self.zero[0],) * self.tree.nv),
                      states=self._states)

    def part(self, link: int, symbol: str) -> AbstractContextManager[None]:
        """Name the instructions of this block after this value of the link."""
        if link < 0:
            return self.recorder.part("world", symbol, "world")
        return self.recorder.part(self.names[link], symbol, self.tree.links[link].heading)

    # joints

    def coordinates(self, link: int) -> tuple[Number, ...]:
        """q of the link's joint; of a follower, from its leader."""
        x = self.tree.links[link]
        if x.driver is None:
            return tuple(self._q[x.q.start:x.q.stop])
        own = self._q[self.tree.links[x.driver.link].q.start]
        return (own * x.driver.multiplier + x.driver.offset,)

    def _rates(self, link: int, values: Sequence[Number]) -> tuple[Number, ...]:
        x = self.tree.links[link]
        if x.driver is None:
            return tuple(values[x.v.start:x.v.stop])
        return (values[self.tree.links[x.driver.link].v.start] * x.driver.multiplier,)

    def speeds(self, link: int) -> tuple[Number, ...]:
        """v of the link's joint."""
        return self._rates(link, self.v)

    def accelerations(self, link: int) -> tuple[Number, ...]:
        """a of the link's joint."""
        return self._rates(link, self.a)

    def state(self, link: int) -> RecordedJoint:
        """The link's joint at its coordinates."""
        directions = self.tree.links[link].joint.directions
        return RecordedJoint(tuple(map(self.recorder.numbers, directions)),
                             self.coordinates(link), self.recorder)

    def subspace(self, link: int) -> tuple[Twist, ...]:
        """S: the screws of the joint's freedoms, in the link's frame."""
        known = self._subspaces
        if link not in known:
            with self.part(link, "n"):
                known[link] = tuple(self.tree.links[link].joint.kind.subspace(self.state(link)))
                for screw in known[link]:
                    self.recorder.label("nl", linear(screw))
                    self.recorder.label("na", angular(screw))
        return known[link]

    def relative_twist(self, link: int) -> Twist:
        """(v; ω) of the link relative to its parent, in its frame."""
        return self._relative(link, self.speeds(link))

    def _relative(self, link: int, values: Sequence[Number]) -> Twist:
        """S v: the joint's screw for these velocities."""
        first, *others = (scaled(x, s) for x, s in
                          zip(values, self.subspace(link), strict=True))
        for other in others:
            first = add(first, other)
        return first

    def _relative_rate(self, link: int) -> Twist:
        """S a + S' v."""
        result = self._relative(link, self.accelerations(link))
        rate = self.tree.links[link].joint.kind.subspace_rate
        return add(result, rate(self.state(link), self.speeds(link))) if rate else result

    # frames

    @_of_link("R", "t")
    def frame(self, link: int) -> Displacement:
        """D of the link in its parent: the joint's placement times its displacement."""
        x, numbers = self.tree.links[link], self.recorder.numbers
        placement = displacement(numbers(x.placement.R), numbers(x.placement.t))
        return x.joint.kind.displacement(self.state(link), placement)

    @_of_link("Rw", "tw")
    def pose(self, link: int) -> Displacement:
        """D of the link in the world."""
        if link < 0:
            return displacement(self.recorder.numbers([int(i % 4 == 0) for i in range(9)]),
                                self.zero)
        return self.recorder.call("product_dd", self.pose(self.tree.links[link].parent),
                                  self.frame(link))

    # velocities

    @_of_link("wp")
    def parent_angular_velocity(self, link: int) -> Vector:
        """The parent's angular velocity, in the link's frame."""
        return rotated_back(rotation(self.frame(link)),
                            self.angular_velocity(self.tree.links[link].parent))

    @_of_link("w")
    def angular_velocity(self, link: int) -> Vector:
        """ω."""
        if link < 0 or self.still:
            return self.zero
        return add(self.parent_angular_velocity(link),
                   angular(self.relative_twist(link)))

    @_of_link("v")
    def velocity(self, link: int) -> Vector:
        """The velocity of the link's origin."""
        if link < 0 or self.still:
            return self.zero
        from_parent = self.recorder.call("product_Adinvs", self.frame(link),
                                         self.twist(self.tree.links[link].parent))
        return add(linear(from_parent), linear(self.relative_twist(link)))

    def twist(self, link: int) -> Twist:
        """(v; ω)."""
        return (*self.velocity(link), *self.angular_velocity(link))

    # accelerations

    @_of_link("dw")
    def angular_acceleration(self, link: int) -> Vector:
        """ω'."""
        if link < 0:
            return self.zero
        from_parent = rotated_back(rotation(self.frame(link)),
                                   self.angular_acceleration(self.tree.links[link].parent))
        relative = angular(self.relative_twist(link))
        own = angular(self._relative_rate(link))
        return add(add(from_parent, cross(self.parent_angular_velocity(link), relative)), own)

    @_of_link("U")
    def acceleration_tensor(self, link: int) -> Rotation:
        """ω'~ + ω~ ω~: maps a point of the link to its acceleration less the origin's."""
        return self.recorder.call("acceleration_tensor", self.angular_velocity(link),
                                  self.angular_acceleration(link))

    @_of_link("a")
    def acceleration(self, link: int) -> Vector:
        """The acceleration of the link's origin, less that of gravity."""
        if link < 0:
            return subtract(self.zero, self.gravity)
        D, parent = self.frame(link), self.tree.links[link].parent
        at_origin = add(self.acceleration(parent),
                        rotated(self.acceleration_tensor(parent), translation(D)))
        relative = self.relative_twist(link)
        own = linear(self._relative_rate(link))
        if not (self._carried and parent < 0 and self.tree.links[link].joint.kind.floats):
            own = add(own, cross(angular(relative), linear(relative)))
        w = self.parent_angular_velocity(link)
        return add(rotated_back(rotation(D), at_origin),
                   add(cross(add(w, w), linear(relative)), own))
