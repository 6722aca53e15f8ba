"""Motion of a tree's links: frames, velocities, accelerations, each computed when first asked for.

All vectors of a link are in its own frame.  Accelerations are those of points (not of
screws), so that linear velocities enter only where points slide: a prismatic joint, a free
one, an effect that asks.
"""

from collections.abc import Callable, Sequence
from functools import wraps

from coscrew_codegen.recording.numbers import (
    Number,
    Vector,
    add,
    cos,
    cross,
    rotated,
    rotated_back,
    scaled,
    sin,
    subtract,
)
from coscrew_codegen.recording.recorder import Recorder
from coscrew_codegen.scene.model import Kind
from coscrew_codegen.scene.tree import Link, Tree

Rotation = tuple[Number, ...]  # nine, row by row


def _of_link(compute: Callable[["Motion", int], object]) -> Callable[["Motion", int], object]:
    """Computed once a link, instructions named after link and method, below the link's heading."""
    title = compute.__name__

    @wraps(compute)
    def cached(self: "Motion", link: int) -> object:
        known = self._known.setdefault(title, {})
        if link not in known:
            name = self.names[link] if link >= 0 else "world"
            with self.recorder.part(f"{name}_{title}", self.tree.links[link].name
                                    if link >= 0 else "world"):
                known[link] = compute(self, link)
        return known[link]
    return cached


class Motion:
    """The motion of all links for given q, v, a (those that are left out are zero); `at` has a q
    and a v other than the function's."""

    def __init__(self, recorder: Recorder, tree: Tree, names: Sequence[str],
                 gravity: Vector | None = None, moving: bool = True, accelerating: bool = True,
                 at: tuple[Sequence[Number], Sequence[Number]] | None = None):
        self.recorder, self.tree, self.names = recorder, tree, names
        self._known: dict[str, dict[int, object]] = {}
        zero = recorder.number(0)
        self.zero: Vector = (zero, zero, zero)
        self.gravity = gravity or self.zero
        still = (zero,) * tree.nv
        self._q = recorder.argument("q") if recorder.has("q") else ()
        self.v = recorder.argument("v") if moving and recorder.has("v") else still
        if at:
            self._q, self.v = at
        self._a = recorder.argument("a") if accelerating and recorder.has("a") else still
        self.still = not (moving and recorder.has("v"))

    # joints

    def coordinates(self, link: int) -> tuple[Number, ...]:
        """q of the joint before the link, a follower's from its driver."""
        x = self.tree.links[link]
        if x.driver is None:
            return self._q[x.q.start:x.q.stop]
        own = self._q[self.tree.links[x.driver.link].q.start]
        return (own * x.driver.multiplier + x.driver.offset,)

    def _rates(self, link: int, values: Sequence[Number]) -> tuple[Number, ...]:
        x = self.tree.links[link]
        if x.driver is None:
            return tuple(values[x.v.start:x.v.stop])
        return (values[self.tree.links[x.driver.link].v.start] * x.driver.multiplier,)

    def speeds(self, link: int) -> tuple[Number, ...]:
        """v of the joint before the link."""
        return self._rates(link, self.v)

    def accelerations(self, link: int) -> tuple[Number, ...]:
        """a of the joint before the link."""
        return self._rates(link, self._a)

    def _relative(self, link: int, values: Sequence[Number]) -> tuple[Vector, Vector]:
        """Linear and angular part of the joint's screw for these speeds."""
        x = self.tree.links[link]
        if x.joint.kind is Kind.FREE:
            return tuple(values[:3]), tuple(values[3:])
        if x.joint.kind is Kind.SPHERICAL:
            return self.zero, tuple(values)
        along = scaled(values[0], self.axis(x))
        return (along, self.zero) if x.joint.kind is Kind.PRISMATIC else (self.zero, along)

    def axis(self, link: Link) -> Vector:
        """The joint's axis: the same in both frames it joins, but for the placement."""
        return self.recorder.numbers(link.joint.axis)

    # frames

    @_of_link
    def frame(self, link: int) -> tuple[Rotation, Vector]:
        """R and t of the link in its parent."""
        x = self.tree.links[link]
        R, t = self.recorder.numbers(x.placement.R), self.recorder.numbers(x.placement.t)
        q, call = self.coordinates(link), self.recorder.call
        if x.joint.kind is Kind.PRISMATIC:
            return R, add(t, scaled(q[0], rotated(R, self.axis(x))))
        if x.joint.kind is Kind.REVOLUTE:
            return call("product_drdr", R, self._turn(x, q[0])), t
        if x.joint.kind is Kind.SPHERICAL:
            return call("product_drdr", R, call("mat3x3_from_quaternion", q)), t
        return (call("product_drdr", R, call("mat3x3_from_quaternion", q[3:])),
                add(t, rotated(R, tuple(q[:3]))))

    def _turn(self, link: Link, angle: Number) -> Rotation:
        """I cos + a~ sin + a a^T (1 - cos): entry by entry a constant, a cosine and a sine."""
        a, s, c = link.joint.axis, sin(angle), cos(angle)
        skew = (0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0)
        outer = [x * y for x in a for y in a]
        return tuple(c * ((i % 4 == 0) - outer[i]) + outer[i] + s * skew[i] for i in range(9))

    @_of_link
    def pose(self, link: int) -> tuple[Rotation, Vector]:
        """R and t of the link in the world."""
        if link < 0:
            return self.recorder.numbers([int(i % 4 == 0) for i in range(9)]), self.zero
        (R, t), (Rp, tp) = self.frame(link), self.pose(self.tree.links[link].parent)
        return self.recorder.call("product_drdr", Rp, R), add(tp, rotated(Rp, t))

    # velocities

    @_of_link
    def carried(self, link: int) -> Vector:
        """The parent's angular velocity, in the link's frame."""
        return rotated_back(self.frame(link)[0], self.turning(self.tree.links[link].parent))

    @_of_link
    def turning(self, link: int) -> Vector:
        """ω."""
        if link < 0 or self.still:
            return self.zero
        return add(self.carried(link), self._relative(link, self.speeds(link))[1])

    @_of_link
    def velocity(self, link: int) -> Vector:
        """Of the link's origin."""
        if link < 0 or self.still:
            return self.zero
        (R, t), parent = self.frame(link), self.tree.links[link].parent
        brought = add(self.velocity(parent), cross(self.turning(parent), t))
        return add(rotated_back(R, brought), self._relative(link, self.speeds(link))[0])

    # accelerations

    @_of_link
    def spinning(self, link: int) -> Vector:
        """ω', the angular acceleration."""
        if link < 0:
            return self.zero
        brought = rotated_back(self.frame(link)[0], self.spinning(self.tree.links[link].parent))
        relative = self._relative(link, self.speeds(link))[1]
        own = self._relative(link, self.accelerations(link))[1]
        return add(add(brought, cross(self.carried(link), relative)), own)

    @_of_link
    def curl(self, link: int) -> Rotation:
        """ω'~ + ω~ ω~: maps points of the link to their accelerations beyond the origin's."""
        (x, y, z), (a, b, c) = self.turning(link), self.spinning(link)
        xx, yy, zz, xy, xz, yz = x * x, y * y, z * z, x * y, x * z, y * z
        return (-(yy + zz), xy - c, xz + b, xy + c, -(xx + zz), yz - a, xz - b, yz + a, -(xx + yy))

    @_of_link
    def acceleration(self, link: int) -> Vector:
        """Of the link's origin, less that of gravity."""
        if link < 0:
            return subtract(self.zero, self.gravity)
        (R, t), parent = self.frame(link), self.tree.links[link].parent
        brought = rotated_back(R, add(self.acceleration(parent), rotated(self.curl(parent), t)))
        v, w = self._relative(link, self.speeds(link))
        own = add(self._relative(link, self.accelerations(link))[0], cross(w, v))
        carried = self.carried(link)
        return add(brought, add(cross(add(carried, carried), v), own))
