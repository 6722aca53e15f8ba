"""Bounds of the lengths of vectors whose components are values of a Program: rotations keep these,
along whole chains of them, where bounds by component grow.

For X, up to three values, |X| <= size and |X̂ - X| <= error.  Instructions a p ± b q whose a and b
are sine and cosine of one angle, or sums of multiples of these (a turn by the angle and a constant
one), are turns.  With `own` the length of the components' own roundings:

    components       √(∑ size²); √(∑ error²)
    sin θ, cos θ     1; as components
    a p ± b q        |a, b| |p, q|; |a, b| E + e (|p, q| + E) and own of the products and the sum,
                     where e and E are the errors of (a, b) and of (p, q)
    (a p - b q, b p + a q, z), or one of the first two, and z
                     as |p, q, z|, times |a, b| if that is above 1; likewise
    (xᵢ ± yᵢ)        |x| + |y|; the sum of their errors and own.  A component may stay as it is
    (f xᵢ)           |f| |x|; |f| E + e |x| + e E and own, where e and E are those of f and of x

The first two lines of a turn are by Cauchy and Schwarz.  Of each vector one rule is tried beside
that of its components: for its last component, whose operands are older."""

from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

from coscrew_codegen.program import Constant, Instruction, Op, Operand, Ref
from coscrew_codegen.program.roundoff import (
    CIRCULAR,
    NONE,
    UNBOUNDED,
    RoundedRange,
    Upward,
    length,
    product_error,
)

Vector = tuple[Operand, ...]
_SUMS = frozenset({Op.ADD, Op.SUB})
_LARGEST = 3
_DEEPEST = 100
"""The most rules one after the other, without those whose results are known."""
_ONE = Upward(1)


class Length(NamedTuple):
    """Bounds of a vector's length and of the length of its error, and how they follow: a rule, the
    components in an order, and the vectors that the rule takes, in the same."""

    size: Upward
    error: Upward
    rule: str = ""
    components: Vector = ()
    given: tuple[Vector, ...] = ()


class Turn(NamedTuple):
    """An instruction a p ± b q, a and b of one angle."""

    turning: tuple[Operand, Operand]
    turned: tuple[Operand, Operand]
    op: Op

    def is_sibling(self, other: "Turn") -> bool:
        """Returns whether this and the other are the two components of a turn."""
        (a, b), (p, q) = self.turning, self.turned
        return self.op is not other.op and \
            (other.turning, other.turned) in (((b, a), (p, q)), ((a, b), (q, p)))


class VectorLengths:
    """The lengths of vectors of a program's values, whose bounds `of` returns."""

    def __init__(self, of: Callable[[Operand], RoundedRange]) -> None:
        self._of = of
        self._steps: dict[Operand, tuple[int, Instruction]] = {}  # with their places
        self._angles: dict[Operand, Operand] = {}  # of sines, cosines and sums of multiples
        self.turns: dict[Operand, Turn] = {}
        self.known: dict[frozenset[Operand], Length] = {}

    def turned(self, step: Instruction) -> Length | None:
        """Bounds of the size of an instruction's result, and of its error before it is rounded, if
        it is a turn.  All instructions have to come, in turn."""
        me = Ref(step.name)
        turn = self._turn(step) if step.op in _SUMS else None
        self._steps[me] = len(self._steps), step
        if step.op in CIRCULAR:
            self._angles[me] = step.operands[0]
        if not turn:
            return None
        self.turns[me] = turn
        if all(isinstance(x, Constant) for x in turn.turned):
            self._angles[me] = self._angles[turn.turning[0]]
        by, of = self.length(turn.turning), self.length(turn.turned)
        products = [self._of(x).own for x in step.operands]
        return Length(by.size * of.size, _moved(by, of) + products[0] + products[1], "result",
                      (me,), (turn.turned, turn.turning))

    def _turn(self, step: Instruction) -> Turn | None:
        first, second = (self._products(x) for x in step.operands)
        for a, p in first:
            for b, q in second:
                if a in self._angles and a != b and p != q and \
                        self._angles[a] == self._angles.get(b):
                    return Turn((a, b), (p, q), step.op)
        return None

    def _products(self, x: Operand) -> tuple[tuple[Operand, Operand], ...]:
        """The factors of a product, in both orders."""
        _, step = self._steps.get(x, (0, None))
        if not step or step.op is not Op.MUL:
            return ()
        a, b = step.operands
        return (a, b), (b, a)

    def length(self, vector: Vector, deep: int = _DEEPEST) -> Length:
        """The bounds of a vector's length."""
        key = frozenset(vector)
        if key in self.known:
            return self.known[key]
        parts = [self._of(x) for x in vector]
        best = Length(_root([x.size for x in parts]), _root([x.error for x in parts]),
                      "components", vector)
        if len(vector) == 1 or not deep:
            return best
        other = self._by_rule(vector, deep - 1)
        if other and (other.size < best.size or other.error < best.error):
            best = other._replace(size=min(best.size, other.size),
                                  error=min(best.error, other.error))
        self.known[key] = best
        return best

    def _by_rule(self, vector: Vector, deep: int) -> Length | None:
        last = max(vector, key=self._place)
        if last not in self._steps:
            return None
        step = self._steps[last][1]
        if last in self.turns:
            return self._of_turn(vector, last, deep)
        if step.op in _SUMS:
            return self._of_sums(vector, deep)
        if step.op in CIRCULAR:
            return self._of_circle(vector, step)
        return self._of_multiples(vector, step, deep) if step.op is Op.MUL else None

    def _of_circle(self, vector: Vector, step: Instruction) -> Length | None:
        """Sine and cosine of one angle."""
        steps = [self._steps[x][1] for x in vector if x in self._steps]
        one = len(steps) == len(vector) == 2 and all(
            x.op in CIRCULAR and x.operands == step.operands for x in steps)
        return Length(_ONE, UNBOUNDED, "circle", vector) if one else None

    def _of_turn(self, vector: Vector, last: Operand, deep: int) -> Length | None:
        turn = self.turns[last]
        outputs = (last, *(x for x in vector if x in self.turns and
                           turn.is_sibling(self.turns[x])))
        others = tuple(x for x in vector if x not in outputs)
        before = (*turn.turned, *others)
        if len({*before}) < len(before) or len(before) > _LARGEST:
            return None
        by = self.length(turn.turning, deep)
        by = by._replace(size=max(by.size, _ONE))
        of = self.length(before, deep)
        own = _root([self._own(x) for x in outputs])
        return Length(by.size * of.size, _moved(by, of) + own, "turn", (*outputs, *others),
                      (before, turn.turning))

    def _own(self, x: Operand) -> Upward:
        """The own roundings of a turn and of its products."""
        a, b = self._steps[x][1].operands
        return self._of(x).own + self._of(a).own + self._of(b).own

    def _of_sums(self, vector: Vector, deep: int) -> Length | None:
        sums = [x for x in vector if x not in self.turns and x in self._steps and
                self._steps[x][1].op in _SUMS]
        terms = [sorted(self._steps[x][1].operands, key=self._place) for x in sums]
        if len(terms) == 1 and not isinstance(terms[0][0], Ref):
            terms = [terms[0][::-1]]
        others = tuple(x for x in vector if x not in sums)
        first, second = (*others, *(x for x, _ in terms)), tuple(y for _, y in terms)
        if len({*first}) < len(first) or len({*second}) < len(second):
            return None
        a, b = self.length(first, deep), self.length(second, deep)
        return Length(a.size + b.size, a.error + b.error + _root([self._of(x).own for x in sums]),
                      "sum", (*others, *sums), (first, second))

    def _of_multiples(self, vector: Vector, step: Instruction, deep: int) -> Length | None:
        for f in step.operands:
            others = tuple(next((y for z, y in self._products(x) if z == f), f) for x in vector)
            products = all(any(z == f for z, _ in self._products(x)) for x in vector)
            if products and len({*others}) == len(others):
                x, of = self._of(f), self.length(others, deep)
                own = _root([self._of(y).own for y in vector])
                return Length(x.size * of.size, product_error(
                    x.size, x.error, of.size, of.error) + own, "multiple", vector, (others, (f,)))
        return None

    def _place(self, x: Operand) -> int:
        return self._steps[x][0] if x in self._steps else -1

    def proof(self, length: Length) -> Iterator[Length]:
        """The bounds on which these rest, those before them first, and these."""
        for x in length.given:
            if len(x) > 1:
                yield from self.proof(self.length(x))
        yield length


def _moved(by: Length, of: Length) -> Upward:
    """Bounds the error of a turn: `by` is the length of (sine, cosine), `of` that of the vector."""
    return by.size * of.error + by.error * (of.size + of.error)


def _root(parts: Sequence[Upward]) -> Upward:
    """Bounds √(∑ x²)."""
    result = NONE
    for x in parts:
        result = length(result, x)
    return result
