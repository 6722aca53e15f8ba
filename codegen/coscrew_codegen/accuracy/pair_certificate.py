"""Certificates of functions whose values are carried as pairs hi + lo, all or some: a line for
every value of the plain program, and for every instruction that computes its pair.

The bounds of values are those of `rounding_rules.py`; their own errors are those of the pairs as
they are computed, by `pair_instructions.py`, where `pair_rounding.py` has a rule for all pairs."""

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

from coscrew_codegen.accuracy.pair_instructions import (
    ONE,
    SUMS,
    PairInstructions,
    Polynomial,
    monomial,
    plus,
)
from coscrew_codegen.accuracy.pair_rounding import PairRounding
from coscrew_codegen.accuracy.rounding_rules import above
from coscrew_codegen.accuracy.tiers.compensated import (
    Carrier,
    Carrying,
    rest_of,
    rounded_constant,
)
from coscrew_codegen.accuracy.tiers.mixed import Mixture
from coscrew_codegen.program import (
    Constant,
    Input,
    Instruction,
    Op,
    Operand,
    Program,
    Ref,
    without_dead_steps,
)
from coscrew_codegen.program.program import name_of
from coscrew_codegen.program.roundoff import CIRCULAR, NONE, RoundedRange, Upward, down
from coscrew_codegen.program.values.formats import Precision

_WORDS = {Op.PRODUCT_ERROR: "error", Op.PRODUCT_REST: "rest", Op.SIN_ERROR: "sin_rest",
          Op.COS_ERROR: "cos_rest"}
_NEARLY = 1 + Fraction(1, 2**40)


Noted = tuple[int, tuple[str, ...]]
"""The number of instructions after which a value is known, and the numbers that stand for it."""


class NotedCarrier(Carrier):
    """A Carrier that notes which numbers stand for each value, and after which instruction."""

    def __init__(self, program: Program, precision: Precision, how: Carrying) -> None:
        super().__init__(program, precision, how)
        self.plain = program
        self.ends: dict[str, int] = {}  # instructions that are issued once a value is carried
        self.sums: dict[str, tuple[str, ...]] = {}  # numbers that stand for a value
        self.normal: dict[str, Noted] = {}  # of normalized values
        self.single: dict[str, Noted] = {}  # of values that are rounded, by hi

    def note(self, step: Instruction) -> None:
        """Notes the sum that stands for the value; a product's lo may still lack what is lost."""
        lost = (f"'{step.name}",) if step.name in self.products else ()
        self.sums[step.name] = *self._sum(Ref(step.name)), *lost
        self.ends[step.name] = len(self.steps)

    def normalized(self, step: Instruction, x: Operand) -> Operand:
        """Notes the normalized sum."""
        total = super().normalized(step, x)
        if total != x and isinstance(x, Ref):
            self.normal.setdefault(x.name, (len(self.steps), self._sum(total)))
        return total

    def once(self, what: str, x: Operand, make: Callable[[], tuple[Ref, ...]]) -> tuple[Ref, ...]:
        """Notes hi + lo rounded."""
        results = super().once(what, x, make)
        if what == "single":
            self.single.setdefault(name_of(x), (len(self.steps), (results[0].name,)))
        return results

    def _sum(self, x: Operand) -> tuple[str, ...]:
        low = self.known(x)
        return (name_of(x), *([name_of(low)] if low is not None else []))


class CertifiedPairs(PairRounding):
    """The rule of a precision, and of a mixture, that reads a function's instructions and writes
    the lines of a certificate."""

    def __init__(self, precision: Precision, carrier: NotedCarrier, emitted: Program,
                 proved: Collection[int], mixture: Mixture | None = None) -> None:
        super().__init__(precision, mixture)
        self.lines: list[str] = []
        self._numbers = PairInstructions(precision)
        self._carrier, self._emitted, self._proved = carrier, emitted, proved
        self._steps = {step.name: step for step in emitted.instructions}
        self._finals = [self._final(x) for x in emitted.results]
        self._alive = {step.name for step in without_dead_steps(replace(
            emitted, results=tuple(self._finals[k] for k in proved))).instructions}
        self._at = self._count = 0  # of instructions that are written, of results
        self._words: dict[tuple[str, int], str] = {}  # values that instructions take
        self._normalized: dict[str, str] = {}  # values that are normalized, by their former names
        self._copies: dict[str, RoundedRange] = {}
        self._results: dict[Operand, str] = {}
        self._sums: dict[str, Polynomial] = {}  # of numbers that stand for values

    def start(self, sizes: Sequence[Sequence[float]], groups: Mapping[Operand, Sequence[str]]
              ) -> None:
        """Writes the inputs, each with the quaternion that it belongs to."""
        used = {x for step in self._emitted.instructions if step.name in self._alive
                for x in step.operands} | {self._finals[k] for k in self._proved}
        for x in sorted(x for x in used if isinstance(x, Input)):
            size, name = Upward(sizes[x.argument][x.index]), self._word(x)
            self._numbers.add_number(name, Fraction(size))
            self._sums[name] = monomial(name)
            self._line("input", name, groups.get(x, ()), RoundedRange(size))

    def operand(self, step: Instruction, place: int, x: RoundedRange) -> RoundedRange:
        """The operand; normalized, or rounded, if its instruction has it so."""
        plain, name = step.operands[place], name_of(step.operands[place])
        if step.name not in self._alive:
            return x
        end = self._carrier.ends[step.name]
        normal = self._taken(f"{name}_normalized", name, x, self._carrier.normal.get(name), end)
        if normal:
            x, self._normalized[name] = normal, f"{name}_normalized"
        word, ((hi,), *low) = self._word(plain), self._sum(plain)
        if step.op is Op.NEG:
            self._negated(step, word, x)
        elif not self.carries(step) and (step.name, place) not in self._kept:
            noted = self._carrier.single.get(hi) if name else (0, (hi,)) if low else None
            if single := self._taken(f"single_{word}", word, x, noted, end):
                x, word = single, f"single_{word}"
        self._words[step.name, place] = word
        return x

    def rounded(self, step: Instruction, before: RoundedRange, operands: Sequence[RoundedRange]
                ) -> RoundedRange:
        """The result of a sum, product, quotient, sine or cosine."""
        end, numbers = self._carrier.ends[step.name], self._of_alive(step.name)
        if not numbers:
            self._write(end)
            return before
        words = [self._words[step.name, n] for n in range(len(step.operands))]
        truth = self._truth(step.op, [self._sums[x] for x in words])
        divisor, left = ONE, Fraction(1)
        if step.op is Op.DIV:
            divisor, least = self._sums[words[1]], down(operands[1].least, operands[1].error)
            left = Fraction(least)
            words.append(str(Fraction(least)))
        inside = (Fraction(before.size) + Fraction(before.error)) * _NEARLY

        def close(f: Polynomial) -> Fraction:
            return inside + self._numbers.bound(plus(f, self._numbers.times(truth), -1))

        place = len(self.lines)
        self._write(end, close if step.op is not Op.DIV else None, left - self._more(divisor))
        result = before.rounded(above(self._error(numbers, truth, divisor) / left))
        self._line(step.op.value, step.name, words, result, place)
        self._stand(step.name, numbers, result)
        return result

    def result(self, x: RoundedRange) -> RoundedRange:
        """hi + lo rounded."""
        k, self._count = self._count, self._count + 1
        if k not in self._proved:
            return x
        self._write(len(self._carrier.steps))
        value, final = self._carrier.plain.results[k], self._finals[k]
        self._sum(value)
        word = self._results.get(value, self._word(value, number=True))
        name = self._results[value] = component_names(self._emitted)[k]
        return self._copy(name, word, self._copies.get(word, x),
                          (self._word(final, number=True),))

    def _taken(self, name: str, word: str, x: RoundedRange, noted: Noted | None, end: int
               ) -> RoundedRange | None:
        """The bounds of a value as other numbers; None if these are not known up to here."""
        if name not in self._copies and noted and noted[0] <= end:
            self._write(noted[0])
            self._copy(name, word, x, noted[1])
        return self._copies.get(name)

    def _copy(self, name: str, word: str, x: RoundedRange, numbers: Sequence[str]) -> RoundedRange:
        """Writes a value that other numbers stand for, and returns its bounds."""
        result = x.rounded(above(self._error(numbers, self._sums[word])))
        self._line("copy", name, [word], result)
        self._stand(name, numbers, result)
        self._copies[name] = result
        return result

    def _negated(self, step: Instruction, word: str, x: RoundedRange) -> None:
        """Writes a value of the other sign; that of a product may lack what is lost."""
        self._sums[step.name] = plus({}, self._sums[word], -1)
        self._line("neg", step.name, [word], x._replace(own=NONE))
        self._write(self._carrier.ends[step.name])
        if step.name not in self._carrier.sums[step.name][-1][1:]:
            self._stand(step.name, self._of_alive(step.name), x)

    def _write(self, end: int, close: Callable[[Polynomial], Fraction] | None = None,
               least: Fraction = Fraction(1)) -> None:
        """Writes the instructions up to this place."""
        for name in (step.name for step in self._carrier.steps[self._at:end]):
            if name in self._alive:
                op, words = self._steps[name].op, [self._word(x, number=True)
                                                   for x in self._steps[name].operands]
                figures = self._numbers.add_instruction(op, name, words, least, close)
                word = _WORDS.get(op, SUMS.get(op, op).value)
                self.lines.append(" ".join(["", word, name, *words, *(x.hex() for x in figures)]))
        self._at = max(end, self._at)

    def _truth(self, op: Op, sums: Sequence[Polynomial]) -> Polynomial:
        """The polynomial that equals the operation on the operands' sums; of a quotient, the
        dividend."""
        if op in SUMS:
            return plus(sums[0], sums[1], 1 if op is Op.ADD else -1)
        if op is Op.MUL:
            return self._numbers.times(*sums)
        if op not in CIRCULAR:
            return sums[0]
        angle = [x for x, in sums[0]]
        for x in angle:
            self._numbers.circular(Op.SIN, x)
            self._numbers.circular(Op.COS, x)
        return of_angle_sum(op, angle)

    def _error(self, numbers: Sequence[str], truth: Polynomial, divisor: Polynomial = ONE
               ) -> Fraction:
        """Bounds the difference of the numbers' sum, times the divisor, and the truth."""
        its, f = self._numbers, Polynomial()
        for x in numbers:
            f = plus(f, its.forms.get(x, monomial(x)))
        return its.bound(plus(its.times(f, divisor), its.times(truth), -1))

    def _stand(self, name: str, numbers: Sequence[str], x: RoundedRange) -> None:
        self.lines.append(" ".join(["", "is", name, *numbers]))
        self._sums[name] = self._numbers.as_value(numbers, Fraction(x.size) + Fraction(x.error))

    def _of_alive(self, name: str) -> tuple[str, ...]:
        """The numbers that stand for a value, without those that no result needs."""
        return tuple(x for x in self._carrier.sums[name] if x.lstrip("'") in self._alive)

    def _sum(self, x: Operand) -> Polynomial:
        """The numbers that stand for an operand."""
        word = self._word(x)
        if isinstance(x, Constant) and word not in self._sums:
            hi = rounded_constant(x, self.precision)
            self._sums[word] = {}
            for y in filter(None, (hi, rest_of(x, self.precision))):
                self._numbers.add_number(str(y.double), abs(y.double))
                self._sums[word] |= monomial(str(y.double))
        return self._sums[word]

    def _more(self, f: Polynomial) -> Fraction:
        """Bounds all but the first of the numbers of a sum."""
        return sum((self._numbers.bound(monomial(*x)) for x in [*f][1:]), Fraction(0))

    def _word(self, x: Operand, number: bool = False) -> str:
        """The name of a value, or of a number."""
        if isinstance(x, Input):
            return f"{self._emitted.inputs[x.argument].name}[{x.index}]"
        if isinstance(x, Constant):
            return str(self.precision.value(x))
        assert isinstance(x, Ref)
        return x.name if number else self._normalized.get(x.name, x.name)

    def _line(self, op: str, name: str, words: Sequence[str], x: RoundedRange,
              place: int | None = None) -> None:
        figures = (float(y).hex() for y in (x.size, x.error, x.own))
        self.lines.insert(len(self.lines) if place is None else place,
                          " ".join([op, name, *words, *figures]))

    def _final(self, x: Operand) -> Operand:
        """A result; of a choice the first option, as the other is taken for NaN alone."""
        step = self._steps.get(name_of(x))
        return step.operands[1] if step and step.op is Op.SELECT else x


def of_angle_sum(op: Op, angle: Sequence[str]) -> Polynomial:
    """The sine or cosine of the sum of one or two numbers, as a polynomial in those of each."""
    if len(angle) == 1:
        return monomial(f"{op.value} {angle[0]}")
    (w, v), other = angle, "cos" if op is Op.SIN else "sin"
    return plus(monomial(f"{op.value} {w}", f"cos {v}"), monomial(f"{other} {w}", f"sin {v}"),
                1 if op is Op.SIN else -1)


def component_names(program: Program) -> list[str]:
    """The names of the components of the results."""
    return [f"{a.name}[{k}]" for a in program.outputs for k in range(a.quantity.size)]
