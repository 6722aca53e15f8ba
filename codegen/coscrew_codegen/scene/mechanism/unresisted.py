"""Motions that no inertia resists, whatever q is: the null space of the mass matrix.

The mass matrix is positive semidefinite.  Eliminated from the leaves to the base, as articulated
bodies are, it has a zero pivot for each dimension of its null space.  It is eliminated at a random
q, where nothing is singular that is not singular almost everywhere; first in double precision,
which proves most models regular, then in DIGITS digits.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from random import Random
from typing import Any

from coscrew_codegen.algebra.recording.numbers import (
    angular,
    displacement,
    linear,
    translation,
)
from coscrew_codegen.scene.mechanism.joint_in_reals import JointInReals
from coscrew_codegen.scene.mechanism.model import Joint, Mimic, Model
from coscrew_codegen.scene.mechanism.tree import Link, lumped_inertia, tree_of

DIGITS = 150
"""Axes have 50 digits; the inertias against motions that these make possible, twice as many zeros.
"""

ALONE = 1e-45
"""Inertia against a joint's own motion, in terms of all that it moves, up to which it is zero: a
centre of mass at 1e-18 m from the axis counts, what is left of rounding axes does not."""

TOGETHER = 1e-20
"""Inertia against a joint's motion while others yield, in terms of that while they are locked, up
to which it is zero: it grows with the square of angles, and axes that files give in ten digits are
parallel."""

_CERTAIN = 1e-9  # ratio above which inertias are not zero, whatever the rounding of doubles
_NONE = 1e-8  # ratio of vectors up to which one depends on the others

_Real = Any  # float or mpmath's
_Vector = list[_Real]
_Matrix = list[_Vector]
_Follow = tuple[tuple[str, Mimic], ...]


@dataclass(frozen=True)
class Common:
    """Joints with motions in common that no inertia resists, and those of them to which inertias
    of their own would end that; () if that takes others."""

    joints: tuple[str, ...]
    cure: tuple[str, ...]


@dataclass(frozen=True)
class _Reals:
    """A kind of real numbers: floats, or mpmath's."""

    of: Callable[[Fraction], _Real]
    functions: Any  # a module with sqrt, sin, cos


def _double(x: Fraction) -> float:
    """The number in double precision; infinite if it is beyond the range."""
    try:
        return float(x)
    except OverflowError:
        return math.inf if x > 0 else -math.inf


def _exact(x: Fraction) -> _Real:
    import mpmath

    return mpmath.mpf(x.numerator) / x.denominator


_DOUBLES = _Reals(_double, math)


def _many_digits() -> _Reals:
    import mpmath

    return _Reals(_exact, mpmath)


@lru_cache(maxsize=8)
def alone(model: Model, follow: _Follow) -> frozenset[str]:
    """The joints without inertia against a motion of their own."""
    if not _alone(_moved(model, follow, _DOUBLES), _CERTAIN):
        return frozenset()
    import mpmath

    with mpmath.workdps(DIGITS):
        return _alone(_moved(model, follow, _many_digits()), ALONE)


@lru_cache(maxsize=8)
def common(model: Model, follow: _Follow, held: frozenset[str]) -> Common:
    """The joints that only together move without inertia; those in `held` have one of their own.
    """
    links = _moved(model, follow, _DOUBLES)
    if None not in _pivots(links, held, _CERTAIN, _scale).values():
        return Common((), ())
    import mpmath

    with mpmath.workdps(DIGITS):
        links = _moved(model, follow, _many_digits())
        return _named(links, _null(links, _pivots(links, held, TOGETHER, _locked)), dict(follow))


@dataclass(frozen=True)
class _Moved:
    """A link at some q: `X` takes its parent's motion (w; v) into its frame; its joint moves it
    along the columns."""

    joint: Joint
    parent: int
    X: _Matrix
    columns: tuple[_Vector, ...]
    own: _Matrix  # inertia
    whole: _Matrix  # with all links beyond


@dataclass(frozen=True)
class _Pivot:
    """A column S, I S and S·I S, after all before it were eliminated from I."""

    U: _Vector
    D: _Real


def _moved(model: Model, follow: _Follow, reals: _Reals) -> list[_Moved]:
    """The links at a random q."""
    q, motions = _coordinates(model, follow, reals), []
    for link in tree_of(model, False).links:
        R, t, columns = _frame(link, q[link.joint.name], reals)
        own = _inertia(link, reals.of)
        motions.append(_Moved(link.joint, link.parent, _into(R, t), columns, own,
                              [list(row) for row in own]))
    for moved in reversed(motions):
        if moved.parent >= 0:
            _add(motions[moved.parent].whole, _congruent(moved.X, moved.whole))
    return motions


def _coordinates(model: Model, follow: _Follow, reals: _Reals) -> dict[str, _Vector]:
    """Random coordinates of each joint; quaternions of norm 1."""
    random, values = Random(1), {}
    for joint in model.joints:
        q = [reals.of(Fraction(random.uniform(-1.5, 1.5))) for _ in range(joint.kind.nq)]
        for places in joint.kind.quaternions:
            norm = reals.functions.sqrt(_dot(q[places], q[places]))
            q[places] = [x / norm for x in q[places]]
        values[joint.name] = q
    for name, mimic in follow:
        leader, *_ = values[mimic.joint]
        values[name] = [reals.of(mimic.multiplier) * leader + reals.of(mimic.offset)]
    return values


def _frame(link: Link, q: _Vector, reals: _Reals) -> tuple[_Matrix, _Vector, tuple[_Vector, ...]]:
    """The link's frame in its parent's, and the screws (w; v) of its freedoms."""
    axes = tuple(tuple(map(reals.of, axis)) for axis in link.joint.directions)
    joint = JointInReals(axes, tuple(q), reals.functions.sin, reals.functions.cos)
    placement = displacement(*(tuple(map(reals.of, x)) for x in (
        link.placement.R, link.placement.t)))
    D = link.joint.kind.displacement(joint, placement)
    R = [list(D[4 * i:4 * i + 3]) for i in range(3)]
    return R, list(translation(D)), tuple(
        [*angular(screw), *linear(screw)] for screw in link.joint.kind.subspace(joint))


def _into(R: _Matrix, t: _Vector) -> _Matrix:
    """X of w' = R^T w, v' = R^T (v - t × w)."""
    x, y, z = t
    turned = [list(column) for column in zip(*R, strict=True)]
    moved = _times(turned, [[0, z, -y], [-z, 0, x], [y, -x, 0]])
    return [[*row, 0, 0, 0] for row in turned] + [
        [*a, *b] for a, b in zip(moved, turned, strict=True)]


def _inertia(link: Link, number: Callable[[Fraction], _Real]) -> _Matrix:
    """The link's inertia about its origin, for (w; v)."""
    lumped = lumped_inertia(link.bodies)
    m, x, y, z, xx, yy, zz, xy, xz, yz = (number(value) for value in lumped.numbers)
    return [[xx, xy, xz, 0, -z, y], [xy, yy, yz, z, 0, -x], [xz, yz, zz, -y, x, 0],
            [0, z, -y, m, 0, 0], [-z, 0, x, 0, m, 0], [y, -x, 0, 0, 0, m]]


def _alone(links: Sequence[_Moved], tiny: float) -> frozenset[str]:
    return frozenset(link.joint.name for link in links if not _definite(link, tiny))


def _definite(link: _Moved, tiny: float) -> bool:
    """Returns whether all that the joint moves, rigid, has inertia against its motions."""
    left = [list(row) for row in link.whole]
    return all(_eliminated(left, S, 0, tiny * _scale(link, S)) for S in link.columns)


def _scale(link: _Moved, S: _Vector) -> _Real:
    """The inertia against S, were it about the worst axis."""
    turning, moving = sum(link.whole[i][i] for i in range(3)), link.whole[3][3]
    return turning * _dot(S[:3], S[:3]) + moving * _dot(S[3:], S[3:])


def _locked(link: _Moved, S: _Vector) -> _Real:
    """The inertia against S while the joints beyond are locked."""
    return _dot(S, _applied(link.whole, S))


def _pivots(links: Sequence[_Moved], held: frozenset[str], tiny: float,
            scale: Callable[[_Moved, _Vector], _Real]) -> dict[tuple[int, int], _Pivot | None]:
    """The pivot of each joint's columns, eliminated from the leaves on; None where it is zero."""
    left = [[list(row) for row in link.own] for link in links]
    pivots: dict[tuple[int, int], _Pivot | None] = {}
    for number in reversed(range(len(links))):
        link = links[number]
        more = int(link.joint.name in held)
        for k, S in enumerate(link.columns):
            zero = tiny * (scale(link, S) + more)
            pivots[number, k] = _eliminated(left[number], S, more, zero)
        if link.parent >= 0:
            _add(left[link.parent], _congruent(link.X, left[number]))
    return pivots


def _eliminated(inertia: _Matrix, S: _Vector, more: int, zero: _Real) -> _Pivot | None:
    """Take the motion along S out of an inertia, to which `more` is added along S; None if its
    inertia is up to `zero`."""
    U = _applied(inertia, S)
    d = _dot(S, U) + more
    if abs(d) > zero:  # below zero for impossible bodies; false for NaN
        for row, x in zip(inertia, U, strict=True):
            for j, y in enumerate(U) if x else ():
                row[j] -= x * y / d
        return _Pivot(U, d)
    return None


def _null(links: Sequence[_Moved], pivots: Mapping[tuple[int, int], _Pivot | None]
          ) -> list[dict[tuple[int, int], _Real]]:
    """A basis of the null space: in each vector one coordinate with a zero pivot moves by 1, the
    others of these rest, and the rest yields."""
    return [_yielding(links, pivots, place) for place, pivot in pivots.items() if pivot is None]


def _yielding(links: Sequence[_Moved], pivots: Mapping[tuple[int, int], _Pivot | None],
              moved: tuple[int, int]) -> dict[tuple[int, int], _Real]:
    motions: list[_Vector] = []
    numbers: dict[tuple[int, int], _Real] = {}
    for number, link in enumerate(links):
        motion = _applied(link.X, motions[link.parent]) if link.parent >= 0 else [0] * 6
        for k in reversed(range(len(link.columns))):
            pivot = pivots[number, k]
            x = int((number, k) == moved) if pivot is None else -_dot(pivot.U, motion) / pivot.D
            numbers[number, k] = x
            motion = [a + x * b for a, b in zip(motion, link.columns[k], strict=True)]
        motions.append(motion)
    return numbers


def _named(links: Sequence[_Moved], basis: list[dict[tuple[int, int], _Real]],
           follow: Mapping[str, Mimic]) -> Common:
    """The joints that move in the part of the null space which followers allow."""
    place = {link.joint.name: (number, 0) for number, link in enumerate(links)}
    bound = [[vector[place[name]] - _exact(mimic.multiplier) * vector[place[mimic.joint]]
              for vector in basis] for name, mimic in follow.items()]
    rows, _ = _spanning(bound)
    units = [[int(i == k) for i in range(len(basis))] for k in range(len(basis))]
    allowed = _spanning(units, rows)[0][len(rows):]
    moving: dict[str, list[_Vector]] = {}
    for (number, k), _ in basis[0].items() if basis else ():
        vector = [_dot(weights, [x[number, k] for x in basis]) for weights in allowed]
        if links[number].joint.name not in follow and max(map(abs, vector), default=0) > _NONE:
            moving.setdefault(links[number].joint.name, []).append(vector)
    ordered = {x.joint.name: moving[x.joint.name] for x in links if x.joint.name in moving}
    single = [name for name in ordered if len(links[place[name][0]].columns) == 1]
    _, kept = _spanning([ordered[name][0] for name in single])
    enough = len(kept) == len(allowed)
    return Common(tuple(ordered), tuple(single[i] for i in kept) if enough else ())


def _spanning(vectors: Sequence[_Vector], basis: Sequence[_Vector] = ()
              ) -> tuple[list[_Vector], list[int]]:
    """An orthonormal basis of these vectors and the given orthonormal ones, which come first; and
    the places of the vectors that each add a dimension."""
    spanning, kept = list(basis), []
    largest = max((_dot(x, x) for x in vectors), default=0)
    for place, vector in enumerate(vectors):
        rest = vector
        for unit in spanning:
            along = _dot(unit, rest)
            rest = [x - along * y for x, y in zip(rest, unit, strict=True)]
        square = _dot(rest, rest)
        if square > _NONE**2 * largest:
            spanning.append([x / square**0.5 for x in rest])
            kept.append(place)
    return spanning, kept


def _congruent(X: _Matrix, inertia: _Matrix) -> _Matrix:
    """X^T I X."""
    half = _times(inertia, X)
    return _times([list(column) for column in zip(*X, strict=True)], half)


def _times(a: _Matrix, b: _Matrix) -> _Matrix:
    columns = list(zip(*b, strict=True))
    return [[_dot(row, column) for column in columns] for row in a]


def _applied(matrix: _Matrix, vector: Sequence[_Real]) -> _Vector:
    return [_dot(row, vector) for row in matrix]


def _add(to: _Matrix, more: _Matrix) -> None:
    for row, others in zip(to, more, strict=True):
        row[:] = [x + y for x, y in zip(row, others, strict=True)]


def _dot(a: Sequence[_Real], b: Sequence[_Real]) -> _Real:
    return sum((x * y for x, y in zip(a, b, strict=True) if x and y), 0)
