"""Writes a Program of the library as C; instructions that are used once are nested.

A product is KSL_MUL(a, b): rounded on its own by compilers that fuse products into sums, within
expressions or across statements.  Products of two single-precision numbers in double are exact:
they are written plainly or, with the sum that uses them, as ksl_product_sum(a, b, c), an fma where
the machine has one.  The options of a choice are named, so that compilers compute both; its
comparison stands in it.
"""

import re
from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property

from coscrew_codegen.backends.c.c_nested import spelled
from coscrew_codegen.backends.c.c_statements import PRODUCT_OF
from coscrew_codegen.backends.nesting import CALL, PRODUCT, Language, Nesting
from coscrew_codegen.program import Constant, Input, Instruction, Op, Operand, Program, Ref
from coscrew_codegen.program.ops import COMPARISONS
from coscrew_codegen.program.values.formats import SINGLE, Precision

_INDEX = re.compile(r"_\d+(?=_|$)")


def nested(program: Program, working: Precision, access: Callable[[Input], str]) -> Nesting:
    """The program's text, computed in the precision `working`."""
    exact = exact_products(program, working)
    sums = sums_of_products(program, exact)
    chosen = {x.name for step in program.instructions if step.op is Op.SELECT
              for x in step.operands[1:] if isinstance(x, Ref)}

    def spelling(step: Instruction) -> tuple[str, int]:
        if step.name in sums:
            return "ksl_product_sum({}, {}, {})", CALL
        if step.op not in (Op.MUL, Op.SCALE):
            return spelled(step, working)
        return ("{} * {}", PRODUCT) if step.name in exact else (PRODUCT_OF[working.name], CALL)

    def constant(x: Constant) -> str:
        return working.literal(x) + working.suffix

    return Nesting(_PrintedProgram(program, sums).program(),
                   Language(spelling, constant, f"({working.c_type})NAN", "", "{arguments}"),
                   access, 150,
                   named=lambda step: step.name == step.component or step.name in chosen,
                   inlined=lambda step: step.op in COMPARISONS)


def quantity(component: str) -> str:
    """The name of the vector or matrix that has this component: R for R_01, Bo_size for Bo_3_size.
    """
    return _INDEX.sub("", component)


def exact_products(program: Program, working: Precision) -> frozenset[str]:
    """The names of products, in double, of two single-precision numbers."""
    def single(x: Operand) -> bool:
        if isinstance(x, Constant):
            value = working.value(x)
            return Fraction(float(SINGLE.rounded(value))) == value
        return isinstance(x, Input)

    return frozenset(step.name for step in program.instructions if program.wide
                     and step.op is Op.MUL and all(map(single, step.operands)))


def sums_of_products(program: Program, exact: Collection[str]) -> dict[str, Instruction]:
    """The exact products that are used once, by a sum or difference, by its name: one each."""
    products = {step.name: step for step in program.instructions
                if step.name in exact and program.uses[step.name] == 1}
    sums: dict[str, Instruction] = {}
    for step in program.instructions:
        if step.op in (Op.ADD, Op.SUB):
            last = [x.name for x in step.operands if isinstance(x, Ref) and x.name in products]
            if last:
                sums[step.name] = products[last[-1]]
    return sums


@dataclass(frozen=True)
class _PrintedProgram:
    """A program in which sums have the factors of their products as operands, and each use of a
    comparison its own instruction."""

    original: Program
    sums: dict[str, Instruction]

    def program(self) -> Program:
        """Returns it."""
        left_out = {step.name for step in self.sums.values()}
        return replace(self.original, instructions=tuple(
            x for step in self.original.instructions
            if step.name not in left_out and step.op not in COMPARISONS
            for x in self._written(step)))

    def _written(self, step: Instruction) -> Iterator[Instruction]:
        """The instruction, after those that its operands become."""
        if step.name in self.sums:
            yield from self._sum(step, self.sums[step.name])
            return
        operands = list(step.operands)
        for place, x in enumerate(operands):
            if isinstance(x, Ref) and x.name in self._comparisons:
                operands[place] = Ref(f"{step.name} {x.name}")
                yield self._comparisons[x.name]._replace(name=f"{step.name} {x.name}")
        yield step._replace(operands=tuple(operands))

    def _sum(self, step: Instruction, product: Instruction) -> Iterator[Instruction]:
        """a b + c, a b + (-c) or (-a) b + c."""
        (a, b), (first, second) = product.operands, step.operands
        c = second if first == Ref(product.name) else first
        if step.op is Op.SUB:
            minuend = Ref(product.name) == first
            negated = c if minuend else a
            opposite: Operand = Ref(f"{step.name}_negated")
            if isinstance(negated, Constant):
                opposite = Constant(-negated.double, -negated.single)
            else:
                yield Instruction(f"{step.name}_negated", Op.NEG, (negated,), step.component)
            a, c = (a, opposite) if minuend else (opposite, c)
        yield step._replace(operands=(a, b, c))

    @cached_property
    def _comparisons(self) -> dict[str, Instruction]:
        return {step.name: step for step in self.original.instructions if step.op in COMPARISONS}
