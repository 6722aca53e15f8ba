"""Forward dynamics by articulated bodies (ABA), on top of inverse dynamics without acceleration.

The wrenches of the motion with a = 0 are known from inverse dynamics; what remains is
linear: each link answers an acceleration of its frame with its articulated inertia, and
no term holds a velocity.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from coscrew_codegen.mechanics.bodies import UPPER, Rigid, symmetric
from coscrew_codegen.mechanics.inverse import Wrench, along, handed_on
from coscrew_codegen.mechanics.linear import Factors, factored
from coscrew_codegen.mechanics.motion import Motion
from coscrew_codegen.recording.numbers import Number, Vector, add, cross, rotated_back, scaled
from coscrew_codegen.scene.model import Kind

Column = tuple[Number, ...]  # six: force and moment, or linear and angular acceleration
Joint = Callable[[int, Number], tuple[Number, Number]]
"""Of a speed by number and the inertia it feels: the torque that acts along it, and an inertia that
it has of its own."""


@dataclass(frozen=True)
class Articulated:
    """[[M, H^T], [H, I]]: what maps a link's acceleration (linear; angular) to force and moment."""

    M: tuple[Number, ...]  # symmetric, six numbers
    H: tuple[Number, ...]  # nine, row by row
    I: tuple[Number, ...]  # symmetric, six numbers

    @classmethod
    def of(cls, rigid: Rigid) -> "Articulated":
        """m, h~, I of a rigid body."""
        zero, (x, y, z) = rigid.m.like(0), rigid.h
        return cls((rigid.m,) * 3 + (zero,) * 3, (zero, -z, y, z, zero, -x, -y, x, zero), rigid.I)

    def plus(self, other: "Articulated") -> "Articulated":
        """The sum."""
        return Articulated(*map(add, (self.M, self.H, self.I), (other.M, other.H, other.I)))

    def entry(self, row: int, column: int) -> Number:
        """An entry of the 6×6 matrix."""
        if row < 3 and column < 3:
            return symmetric(self.M)[3 * row + column]
        if row >= 3 and column >= 3:
            return symmetric(self.I)[3 * (row - 3) + column - 3]
        return self.H[3 * (row - 3) + column] if row >= 3 else self.H[3 * (column - 3) + row]

    def moved(self, R: Sequence[Number], t: Vector) -> "Articulated":
        """In the parent's frame: turned by R, then shifted by t.

        M' = R M R^T, G = R H R^T + t~ M', I' = R I R^T + t~ (R H R^T)^T - G t~."""
        M, I = _turned(R, self.M), _turned(R, self.I)
        call = M[0].recorder.call
        H = call("product_drdrinv", call("product_drdr", R, self.H), R)
        G = add(H, _crossed(t, symmetric(M)))
        shift = [x - y for x, y in zip(_crossed(t, _transposed(H)), _crossing(G, t), strict=True)]
        return Articulated(M, G, add(I, [shift[3 * i + j] for i, j in UPPER]))

    def without(self, joint: "Opened") -> "Articulated":
        """A - U D^-1 U^T: what a joint's freedom leaves; rows and columns of its axes vanish."""
        def less(row: int, column: int) -> Number:
            if row in joint.axes or column in joint.axes:
                return joint.zero
            value = self.entry(row, column)
            for u, w in zip(joint.U, joint.W, strict=True):
                value = value - u[row] * w[column]
            return value

        rows = range(3)
        return Articulated(tuple(less(i, j) for i, j in UPPER),
                           tuple(less(3 + i, j) for i in rows for j in rows),
                           tuple(less(3 + i, 3 + j) for i, j in UPPER))


@dataclass(frozen=True)
class Opened:
    """A joint's freedoms as its articulated inertia sees them."""

    S: tuple[tuple[Number, ...], ...]  # screws of the freedoms, six numbers each
    U: tuple[Column, ...]  # A S, a column a freedom
    D: Factors  # of S^T A S + inertias of the joint
    torques: tuple[Number, ...]  # what acts along the freedoms
    W: tuple[Column, ...]  # U D^-1
    axes: frozenset[int]  # components that are freedoms themselves, without inertia of their own
    zero: Number


def freedoms(motion: Motion, number: int) -> tuple[tuple[Number, ...], ...]:
    """The screws of the joint's freedoms, in the link's frame."""
    link, (zero, *_) = motion.tree.links[number], motion.zero
    one = zero.like(1)
    if link.joint.kind in (Kind.FREE, Kind.SPHERICAL):
        first = 0 if link.joint.kind is Kind.FREE else 3
        return tuple(tuple(one if i == k else zero for i in range(6)) for k in range(first, 6))
    axis = motion.axis(link)
    return ((*axis, *motion.zero),) if link.joint.kind is Kind.PRISMATIC else \
        ((*motion.zero, *axis),)


def opened(motion: Motion, number: int, body: Articulated, joint: Joint) -> Opened:
    """The joint before a link, with what it has of its own."""
    zero = motion.zero[0]
    S = freedoms(motion, number)
    U = tuple(tuple(_sum(zero, (body.entry(i, k) * s[k] for k in range(6))) for i in range(6))
              for s in S)
    D = [[_sum(zero, (s[k] * u[k] for k in range(6))) for u in U] for s in S]
    own = [joint(k, D[i][i]) for i, k in enumerate(motion.tree.links[number].v)]
    for k, (_, inertia) in enumerate(own):
        D[k][k] = D[k][k] + inertia
    factors = factored(D)
    W = tuple(zip(*(factors.solve([u[i] for u in U]) for i in range(6)), strict=True))
    pure = all(inertia.is_zero for _, inertia in own)
    axes = frozenset(s.index(one) for s in S for one in s if one.constant == 1) if pure else ()
    return Opened(S, U, factors, tuple(torque for torque, _ in own), W, frozenset(axes), zero)


def accelerations(motion: Motion, bodies: Sequence[Articulated], wrenches: Sequence[Wrench],
                  joint: Joint) -> list[Number]:
    """a of every speed: bodies the links' inertias, wrenches those of the motion with a = 0."""
    links, body, wrench = motion.tree.links, list(bodies), list(wrenches)
    joints: list[tuple[Opened, list[Number]]] = []
    for number in reversed(range(len(links))):
        link = links[number]
        with motion.recorder.part(f"{motion.names[number]}_articulated", link.name):
            free = opened(motion, number, body[number], joint)
            rest = [torque - x for torque, x in
                    zip(free.torques, along(motion, number, wrench[number]), strict=True)]
            joints.append((free, rest))
            if link.parent >= 0:
                _hand_on(motion, number, free, rest, body, wrench)
    return _outwards(motion, joints[::-1])


def _hand_on(motion: Motion, number: int, joint: Opened, rest: Sequence[Number],
             body: list[Articulated], wrench: list[Wrench]) -> None:
    """Adds what the joint leaves of its link's inertia and wrench to its parent's."""
    parent = motion.tree.links[number].parent
    left = body[number].without(joint)
    felt = [*wrench[number][0], *wrench[number][1]]
    for w, r in zip(joint.W, rest, strict=True):
        felt = [x + y * r for x, y in zip(felt, w, strict=True)]
    R, t = motion.frame(number)
    body[parent] = body[parent].plus(left.moved(R, t))
    brought = handed_on(motion, number, (tuple(felt[:3]), tuple(felt[3:])))
    wrench[parent] = tuple(map(add, wrench[parent], brought))


def _outwards(motion: Motion, joints: Sequence[tuple[Opened, list[Number]]]) -> list[Number]:
    """From the base on: a = D^-1 (rest - U^T A), A = [Ad]^-1 A_parent + S a."""
    found: list[Number] = []
    frames: list[Column] = []
    for number, (joint, rest) in enumerate(joints):
        link = motion.tree.links[number]
        with motion.recorder.part(f"{motion.names[number]}_a", link.name):
            brought = (*motion.zero, *motion.zero)
            if link.parent >= 0:
                (R, t), above = motion.frame(number), frames[link.parent]
                linear = add(tuple(above[:3]), cross(tuple(above[3:]), t))
                brought = (*rotated_back(R, linear), *rotated_back(R, tuple(above[3:])))
            a = [x - _sum(joint.zero, (w[i] * brought[i] for i in range(6)))
                 for x, w in zip(joint.D.solve(rest), joint.W, strict=True)]
            for s, x in zip(joint.S, a, strict=True):
                brought = add(brought, scaled(x, s))
        found += a
        frames.append(brought)
    return found


def _sum(zero: Number, values) -> Number:
    total = zero
    for value in values:
        total = total + value
    return total


def _turned(R: Sequence[Number], six: Sequence[Number]) -> tuple[Number, ...]:
    """R X R^T of a symmetric X."""
    call = R[0].recorder.call
    nine = call("product_drdrinv", call("product_drdr", R, symmetric(six)), R)
    return tuple(nine[3 * i + j] for i, j in UPPER)


def _transposed(X: Sequence[Number]) -> tuple[Number, ...]:
    return tuple(X[3 * j + i] for i in range(3) for j in range(3))


def _crossed(t: Vector, X: Sequence[Number]) -> tuple[Number, ...]:
    """t~ X, column by column."""
    columns = [cross(t, tuple(X[3 * i + j] for i in range(3))) for j in range(3)]
    return tuple(columns[j][i] for i in range(3) for j in range(3))


def _crossing(X: Sequence[Number], t: Vector) -> tuple[Number, ...]:
    """X t~, row by row: x^T t~ = (x × t)^T."""
    rows = [cross(tuple(X[3 * i:3 * i + 3]), t) for i in range(3)]
    return tuple(x for row in rows for x in row)
