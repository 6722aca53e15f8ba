"""Base parameters: the fewest combinations of parameters that determine the torques.

Columns of the regressor, stacked at random states, are eliminated in their order, in 60 digits: a
column is independent if more than 1e-9 of it is left beside those before it.  Each dependent one
is a combination of independent ones before it, to whose parameters it adds.  So links and effects
near the base come first, and the result is the same on every machine.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from random import Random

import mpmath
import numpy as np

from coscrew_codegen.program import Program
from coscrew_codegen.program.interpreter import by_operation, exactly, interpreter
from coscrew_codegen.scene.mechanism.tree import Tree

BITS = 200
"""After the point of the numbers that are eliminated."""
INDEPENDENT = 1e-9
"""The part of a column that must be left."""
_NOTHING = Fraction(1, 2**(BITS // 2))


@dataclass(frozen=True)
class Base:
    """The places of independent columns, and the combinations of all parameters: the number k of
    the base is Σ weight · parameter over (place, weight)."""

    places: tuple[int, ...]
    combinations: tuple[tuple[tuple[int, Fraction], ...], ...]

    def in_words(self, names: Sequence[str]) -> tuple[str, ...]:
        """wrist.mx + 0.11 hand.m, …."""
        return tuple(_sum([(names[place], weight) for place, weight in terms])
                     for terms in self.combinations)


def _sum(terms: Sequence[tuple[str, Fraction]]) -> str:
    words = ""
    for name, weight in terms:
        size = "" if abs(weight) == 1 else f"{float(abs(weight)):.6g} "
        sign = "-" if weight < 0 else "+"
        words += f" {sign} {size}{name}" if words else f"{'-' if weight < 0 else ''}{size}{name}"
    return words


def base_of(regressor: Program, count: int, tree: Tree, p: Sequence[Fraction]) -> Base:
    """The base of a regressor's Program with this many columns."""
    A = _stacked(regressor, count, tree, p)
    columns = [k for k in range(count) if A[:, k].any()]
    places, weights = _eliminated(A[:, columns])
    chosen = tuple(columns[k] for k in places)
    combinations = []
    for row, place in zip(weights, places, strict=True):
        terms = [(columns[place], Fraction(1))]
        for k, x in enumerate(row):
            weight = Fraction(int(x), 2**BITS)
            if k not in places and abs(weight) > _NOTHING:
                terms.append((columns[k], _short(weight)))
        combinations.append(tuple(terms))
    return Base(chosen, tuple(combinations))


def _short(x: Fraction) -> Fraction:
    """The simplest number within 1e-25: elimination leaves rounding errors of 1e-40."""
    near = x.limit_denominator(10**12)
    return near if abs(near - x) < Fraction(1, 10**25) else x


def _eliminated(A: np.ndarray) -> tuple[list[int], np.ndarray]:
    """(independent columns, each column's weights on these) by Gauss–Jordan elimination of integers
    with BITS after the point.  Columns are scaled to 1 before, weights back after."""
    scale = [int(max(abs(x) for x in A[:, k])) for k in range(A.shape[1])]
    A = np.stack([(A[:, k] << BITS) // scale[k] for k in range(A.shape[1])], 1)
    free = list(range(len(A)))
    places: list[int] = []
    rows: list[int] = []
    least = int(INDEPENDENT * 2**53) << (BITS - 53)
    for k in range(A.shape[1]):
        if not free:
            break
        row = max(zip(abs(A[free, k]), [-i for i in free], strict=True))[1] * -1
        if abs(A[row, k]) < least:
            continue
        free.remove(row)
        A[row] = (A[row] << BITS) // A[row, k]
        for other in range(len(A)):
            if other != row and A[other, k]:
                A[other] -= (A[other, k] * A[row]) >> BITS
        places.append(k)
        rows.append(row)
    weights = A[rows]
    for k in range(A.shape[1]):
        for i, place in enumerate(places):
            weights[i, k] = weights[i, k] * scale[k] // scale[place]
    return places, weights


def _stacked(regressor: Program, count: int, tree: Tree, p: Sequence[Fraction]) -> np.ndarray:
    """The regressor at random states: integers with BITS after the point."""
    rng, states = Random(0), math.ceil(count / max(tree.nv, 1)) + 4
    with mpmath.workprec(BITS + 60):
        numbers = by_operation(lambda x: mpmath.mpf(x.double.numerator) / x.double.denominator,
                               exactly(mpmath))
        evaluated, entries = interpreter(regressor, numbers), []
        for _ in range(states):
            given = dict(_state(tree, rng))
            states = next(a.quantity.size for a in regressor.inputs if a.name == "q") - tree.nq
            given["q"] += [mpmath.mpf(rng.uniform(-2, 2)) for _ in range(states)]  # of effects
            given["p"] = [mpmath.mpf(x.numerator) / x.denominator for x in p]
            result = evaluated([given[a.name] for a in regressor.inputs])
            entries += [int(x * 2**BITS) for x in result[:tree.nv * count]]
    return np.array(entries, object).reshape(-1, count)


def _state(tree: Tree, rng: Random) -> Iterator[tuple[str, list[mpmath.mpf]]]:
    """A random state, with unit quaternions."""
    def drawn(wide: int) -> list[mpmath.mpf]:
        return [mpmath.mpf(rng.uniform(-2, 2)) for _ in range(wide)]

    q = drawn(tree.nq)
    for link in tree.links:
        for places in link.joint.kind.quaternions if link.driver is None else ():
            own = slice(link.q.start + places.start, link.q.start + places.stop)
            q[own] = [x / mpmath.norm(q[own]) for x in q[own]]
    yield "q", q
    yield from (("t", drawn(1)), ("v", drawn(tree.nv)), ("a", drawn(tree.nv)))
