"""Forward dynamics by articulated bodies (ABA), from the wrenches of inverse dynamics at a = 0.

With these wrenches the rest is linear: a link's wrench changes with the acceleration of its frame
by its articulated inertia, and no term contains a velocity.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar

from coscrew_codegen.algebra.recording.numbers import (
    Number,
    add,
    angular,
    linear,
    rotation,
    scaled,
    translation,
)
from coscrew_codegen.dynamics.algorithms import rnea
from coscrew_codegen.dynamics.algorithms.bodies import Rigid
from coscrew_codegen.dynamics.algorithms.linear_systems import Factors, factored
from coscrew_codegen.dynamics.algorithms.motion import Displacement, Motion
from coscrew_codegen.dynamics.algorithms.rnea import Wrench, along, to_parent

Made = TypeVar("Made")
Column = tuple[Number, ...]  # six: force and moment, or linear and angular acceleration
Joint = Callable[[int, Number], tuple[Number, Number]]
"""(number of a velocity, articulated inertia along it) -> (torque along it, additional inertia)."""


@dataclass(frozen=True)
class Articulated:
    """The articulated inertia [[M, H^T], [H, I]]: maps the acceleration (linear; angular) of a link
    to force and moment."""

    entries: tuple[Number, ...]  # 36, row by row; symmetric

    @classmethod
    def of(cls, rigid: Rigid) -> "Articulated":
        """[[m 1, -h~], [h~, I]] of a rigid body, and the inertia that effects add."""
        own = cls(rigid.m.recorder.call("spatial_inertia_matrix", rigid.numbers))
        return own.plus(cls(rigid.added)) if rigid.added else own

    @property
    def is_zero(self) -> bool:
        """True if all its entries are zero."""
        return all(x.is_zero for x in self.entries)

    def plus(self, other: "Articulated") -> "Articulated":
        """The sum."""
        return _symmetric(lambda i, j: self.entry(i, j) + other.entry(i, j))

    def with_row(self, mass: Number, e: Column) -> "Articulated":
        """The sum with mass e e^T."""
        scaled_row = scaled(mass, e)
        return _symmetric(lambda i, j: self.entry(i, j) + scaled_row[i] * e[j])

    def entry(self, row: int, column: int) -> Number:
        """An entry of the 6×6 matrix."""
        return self.entries[6 * max(row, column) + min(row, column)]

    def times(self, s: Column) -> Column:
        """A s."""
        zero = s[0].like(0)
        return tuple(_sum(zero, (self.entry(i, k) * s[k] for k in range(6))) for i in range(6))

    def transformed(self, D: Displacement) -> "Articulated":
        """[Ad]*(D) A [Ad]^-1(D): in the parent's frame."""
        call = D[0].recorder.call
        rotated = call("mat6x6_rotated", rotation(D), self.entries)
        return Articulated(call("mat6x6_shifted", translation(D), rotated))

    def without(self, joint: "Freed") -> "Articulated":
        """A - U D^-1 U^T: the articulated inertia beyond a joint that moves freely; rows and
        columns of its axes are zero."""
        def less(row: int, column: int) -> Number:
            if row in joint.axes or column in joint.axes:
                return joint.zero
            value = self.entry(row, column)
            for u, w in zip(joint.U, joint.W, strict=True):
                value = value - u[row] * w[column]
            return value

        return _symmetric(less)

    def label(self, motion: Motion, symbol: str) -> None:
        """Names its blocks: l linear, a angular, c their coupling."""
        rows, upper = range(3), ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
        blocks = {"l": [self.entry(i, j) for i, j in upper],
                  "c": [self.entry(3 + i, j) for i in rows for j in rows],
                  "a": [self.entry(3 + i, 3 + j) for i, j in upper]}
        for block, numbers in blocks.items():
            motion.recorder.label(f"{symbol}{block}", numbers)


def _symmetric(entry: Callable[[int, int], Number]) -> Articulated:
    """The symmetric matrix with these entries on and below the diagonal."""
    lower = {(i, j): entry(i, j) for i in range(6) for j in range(i + 1)}
    return Articulated(tuple(lower[max(i, j), min(i, j)] for i in range(6) for j in range(6)))


@dataclass(frozen=True)
class Held:
    """A joint's freedoms and the articulated inertia along them, before anything else resists."""

    S: tuple[tuple[Number, ...], ...]  # screws of the freedoms, six numbers each
    U: tuple[Column, ...]  # A S, a column per freedom
    D: tuple[tuple[Number, ...], ...]  # S^T A S


@dataclass(frozen=True)
class Freed:
    """A joint's freedoms with the articulated inertia of its link."""

    S: tuple[tuple[Number, ...], ...]
    U: tuple[Column, ...]
    D: Factors  # of S^T A S + inertias of the joint
    W: tuple[Column, ...]  # U D^-1
    axes: frozenset[int]  # components that are freedoms, of joints without additional inertia
    zero: Number


def _held(motion: Motion, number: int, body: Articulated) -> Held:
    """The joint of a link with this articulated inertia."""
    zero, S = motion.zero[0], motion.subspace(number)
    with motion.part(number, "S"):
        U = tuple(body.times(s) for s in S)
        for column in U:
            _label_column(motion, "S", column)
    with motion.part(number, "D"):
        D = tuple(tuple(_sum(zero, (s[k] * u[k] for k in range(6))) for u in U) for s in S)
    return Held(S, U, D)


def _freed(motion: Motion, number: int, held: Held, inertias: Sequence[Number]) -> Freed:
    """The joint with additional inertias."""
    S, U, D = held.S, held.U, [list(row) for row in held.D]
    with motion.part(number, "D"):
        for k, inertia in enumerate(inertias):
            D[k][k] = D[k][k] + inertia
        factors = factored(D)
        for i, inverse_of_pivot in enumerate(factors.inverse):
            motion.recorder.label("D", D[i][i])
            motion.recorder.label("Di", inverse_of_pivot)
    with motion.part(number, "K"):
        W = tuple(zip(*(factors.solve([u[i] for u in U]) for i in range(6)), strict=True))
        for column in W:
            _label_column(motion, "K", column)
    pure = all(inertia.is_zero for inertia in inertias)
    axes = [k for s in S for k in [_along_axis(s)] if k is not None] if pure else ()
    return Freed(S, U, factors, W, frozenset(axes), motion.zero[0])


def _along_axis(screw: Column) -> int | None:
    """The component that is one, if all others are zero."""
    ones = [k for k, x in enumerate(screw) if x.constant == 1]
    return ones[0] if len(ones) == 1 and sum(x.is_zero for x in screw) == 5 else None


def _label_column(motion: Motion, symbol: str, column: Column) -> None:
    motion.recorder.label(f"{symbol}l", linear(column))
    motion.recorder.label(f"{symbol}a", angular(column))


class Elimination:
    """Accelerations of links with the inertias `bodies`, by elimination from the leaves inwards.
    What depends on inertias alone is recorded once."""

    def __init__(self, motion: Motion, bodies: Sequence[Articulated]):
        self._motion, self._bodies = motion, bodies
        self._known: dict[object, Any] = {}

    def accelerations(self, wrenches: Sequence[Wrench], joint: Joint) -> list[Number]:
        """a, from the `wrenches` of the motion with a = 0."""
        motion, links = self._motion, self._motion.tree.links
        body, wrench = list(self._bodies), list(wrenches)
        joints: list[tuple[Freed, list[Number]]] = []
        for number in reversed(range(len(links))):
            free, torques, parent = *self._free(number, body[number], joint), links[number].parent
            with motion.part(number, "u"):
                rest = [torque - x for torque, x in
                        zip(torques, along(motion, number, wrench[number]), strict=True)]
                for value in rest:
                    motion.recorder.label("u", value)
            joints.append((free, rest))
            if parent >= 0:
                beyond = self._once((number, id(free)), self._beyond, number, body[number], free)
                body[parent] = self._once((parent, id(body[parent]), id(beyond)), self._joined,
                                          parent, body[parent], beyond)
                _add_to_parent(motion, number, free, rest, wrench)
        return _outwards(motion, joints[::-1])

    def _free(self, number: int, body: Articulated, joint: Joint
              ) -> tuple[Freed, tuple[Number, ...]]:
        """The joint of a link, and the torques along it."""
        motion = self._motion
        held = self._once((number, id(body)), _held, motion, number, body)
        with motion.part(number, "D"):
            own = [joint(k, held.D[i][i]) for i, k in enumerate(motion.tree.links[number].v)]
        torques, inertias = zip(*own, strict=True) if own else ((), ())
        free = self._once((number, id(held), tuple(x.operand for x in inertias)), _freed, motion,
                          number, held, inertias)
        return free, torques

    def _beyond(self, number: int, body: Articulated, free: Freed) -> Articulated:
        """The inertia beyond a joint, in the parent's frame."""
        with self._motion.part(number, "Ap"):
            beyond = body.without(free).transformed(self._motion.frame(number))
            beyond.label(self._motion, "Ap")
        return beyond

    def _joined(self, parent: int, body: Articulated, beyond: Articulated) -> Articulated:
        """The parent's inertia with that beyond a joint."""
        with self._motion.part(parent, "A"):
            total = body.plus(beyond)
            total.label(self._motion, "A")
        return total

    def _once(self, key: object, made: Callable[..., Made], *given: Any) -> Made:
        """The value of a key; it is kept with what it is made of, whose identities are keys."""
        if key not in self._known:
            self._known[key] = made(*given), given
        result: Made = self._known[key][0]
        return result


def _add_to_parent(motion: Motion, number: int, joint: Freed, rest: Sequence[Number],
                   wrench: list[Wrench]) -> None:
    """Adds the wrench beyond the joint to its parent's."""
    parent = motion.tree.links[number].parent
    with motion.part(number, "fB"):
        transmitted = wrench[number]
        for w, r in zip(joint.W, rest, strict=True):
            transmitted = tuple(x + y * r for x, y in zip(transmitted, w, strict=True))
        rnea.label(motion, "fB", "mB", transmitted)
    if all(x.is_zero for x in transmitted):
        return
    in_parent = to_parent(motion, number, transmitted)
    with motion.part(parent, "fA"):
        wrench[parent] = add(wrench[parent], in_parent)
        rnea.label(motion, "fA", "mA", wrench[parent])


def _outwards(motion: Motion, joints: Sequence[tuple[Freed, list[Number]]]) -> list[Number]:
    """Computes accelerations from the base outwards: a = D^-1 (rest - U^T A), A = [Ad]^-1 A_parent
    + S a."""
    results: list[Number] = []
    frames: list[Column] = []
    for number, (joint, rest) in enumerate(joints):
        link = motion.tree.links[number]
        A: Column = (*motion.zero, *motion.zero)
        if link.parent >= 0:
            with motion.part(number, "al"):
                A = motion.recorder.call("product_Adinvs", motion.frame(number),
                                         frames[link.parent])
        with motion.part(number, "qdd"):
            a = [x - _sum(joint.zero, (w[i] * A[i] for i in range(6)))
                 for x, w in zip(joint.D.solve(rest), joint.W, strict=True)]
            for value in a:
                motion.recorder.label("qdd", value)
        with motion.part(number, "al"):
            for s, x in zip(joint.S, a, strict=True):
                A = add(A, scaled(x, s))
            motion.recorder.label("al", linear(A))
            motion.recorder.label("aa", angular(A))
        results += a
        frames.append(A)
    return results


def _sum(zero: Number, values: Iterable[Number]) -> Number:
    total = zero
    for value in values:
        total = total + value
    return total
