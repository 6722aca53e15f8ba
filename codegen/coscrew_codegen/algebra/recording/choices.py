"""Adjoints of numbers that matter only where a choice takes them.

The adjoint of a number that is not taken is zero.  Its product with an infinite partial derivative
would be NaN, which would spoil the derivatives of all operands of the number."""

from collections.abc import Callable
from typing import Any

from coscrew_codegen.algebra.recording import numbers
from coscrew_codegen.algebra.recording.numbers import Number
from coscrew_codegen.algebra.recording.recorder import Recorder
from coscrew_codegen.program import Instruction, Op, Program, Ref
from coscrew_codegen.program.interpreter import Arithmetic
from coscrew_codegen.program.ops import COMPARISONS, OF_TABLES
from coscrew_codegen.program.program import name_of

Case = frozenset[tuple[str, bool]]
"""The tests on which choices depend, and whether they hold."""
Cases = frozenset[Case]
ALWAYS: Cases = frozenset({Case()})


class Choices:
    """Arithmetic that interprets a program on Numbers, and multiplies its partial derivatives and
    adjoints."""

    def __init__(self, program: Program, recorder: Recorder):
        self._recorder = recorder
        self._tests: dict[str, Number] = {}
        self._unbounded: dict[str, bool] = {}
        self._cases = _cases(program)

    @property
    def arithmetic(self) -> Arithmetic[Number]:
        """The recorder's; the results of comparisons are kept."""
        plain = self._recorder.arithmetic

        def function(step: Instruction, number: int) -> Callable[..., Number]:
            compute = plain.function(step, number)
            if step.op not in COMPARISONS:
                return compute

            def apply(*operands: Number) -> Number:
                self._tests[step.name] = compute(*operands)
                return self._tests[step.name]

            return apply

        return Arithmetic(plain.constant, function, plain.not_a_number, plain.column)

    def product(self, step: Instruction, partial: Any, adjoint: Number) -> Any:
        """Partial derivative times adjoint; zero where the step's result is not taken, if the
        derivative may be infinite there."""
        cases = self._cases[step.name]
        if not all(cases) or not self._may_be_infinite(partial):
            return adjoint * partial
        return numbers.where(numbers.less(adjoint.like(0), self._taken(cases)),
                             adjoint * partial, 0)

    def _taken(self, cases: Cases) -> Number:
        """1 in one of these cases, else 0."""
        taken = self._recorder.number(0)
        for case in sorted(map(sorted, cases)):
            one = self._recorder.number(1)
            for test, holds in case:
                pair = (one, taken) if holds else (taken, one)
                one = numbers.where(self._tests[test], *pair)
            taken = one
        return taken

    def _may_be_infinite(self, x: Any) -> bool:
        """Returns whether a number may be infinite for small or large arguments, because it depends
        on a quotient."""
        if not (isinstance(x, Number) and isinstance(x.operand, Ref)):
            return False
        for step in self._recorder.issued(len(self._unbounded)):
            self._unbounded[step.name] = step.op in (Op.DIV, Op.EXP) or any(
                isinstance(x, Ref) and self._unbounded[x.name] for x in step.operands)
        return self._unbounded[x.operand.name]


def _cases(program: Program) -> dict[str, Cases]:
    """Returns for every instruction the cases in which a result depends on it."""
    results: dict[str, Cases] = {step.name: frozenset() for step in program.instructions}
    results |= {x.name: ALWAYS for x in program.results if isinstance(x, Ref)}
    for step in reversed(program.instructions):
        own = results[step.name]
        for place, x in enumerate(step.operands):
            if not isinstance(x, Ref) or step.op in COMPARISONS | OF_TABLES:
                continue
            if step.op is not Op.SELECT:
                results[x.name] = _either(results[x.name], own)
            elif place:
                test = name_of(step.operands[0]), place == 1
                results[x.name] = _either(results[x.name], frozenset(
                    case | {test} for case in own if (test[0], not test[1]) not in case))
    return results


def _either(a: Cases, b: Cases) -> Cases:
    """The cases of both, without cases that another one includes, and with both outcomes of a test
    merged into one case."""
    cases = set(a | b)
    while pair := next(((x, y) for x in cases for y in cases if x < y or _differ(x, y)), None):
        x, y = pair
        cases -= {y} if x < y else {x, y}
        cases |= set() if x < y else {x & y}
    return frozenset(cases)


def _differ(a: Case, b: Case) -> bool:
    """Returns whether they differ in the outcome of exactly one test."""
    return {(test, not holds) for test, holds in a - b} == b - a and len(a - b) == 1
