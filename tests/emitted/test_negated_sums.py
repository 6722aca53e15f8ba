"""No sum with a fused product is negated: with gcc the sign of a zero would differ.  Comparisons do
not read it."""

import random
from collections.abc import Iterator
from fractions import Fraction

import pytest

from coscrew_codegen.accuracy.tiers import MARKED
from coscrew_codegen.accuracy.tiers.negation import negating_terms
from coscrew_codegen.accuracy.tiers.tier import Tier, is_polynomial
from coscrew_codegen.algebra.operations import OPERATIONS
from coscrew_codegen.backends.c.c_library import exact_products, sums_of_products
from coscrew_codegen.program import Instruction, Op, Operand, Program, Ref
from coscrew_codegen.program.ops import COMPARISONS
from coscrew_codegen.program.values.formats import DOUBLE, Precision
from tests.support.each import each_precision
from tests.support.scenes.evaluation import evaluator, rational
from tests.support.truth.attack import plain_program

FUSING = {Op.PRODUCT_ERROR, Op.PRODUCT_REST}


def negated(step: Instruction, product: Instruction | None) -> Iterator[Operand]:
    """The sum that C negates, or subtracts from a fused product; `product` is the one that this sum
    fuses in C alone."""
    if step.op is Op.NEG:
        yield step.operands[0]
    if step.op is Op.SUB and product is not None and step.operands[1] != Ref(product.name):
        yield step.operands[1]


def negated_fused_sums(program: Program) -> list[str]:
    """The names of the negated sums with a fused product."""
    absorbed = sums_of_products(program, exact_products(program, DOUBLE))
    fused = {step.name for step in program.instructions
             if step.op in FUSING or step.name in absorbed}
    read = {x for step in program.instructions if step.op not in COMPARISONS
            for x in step.operands} | set(program.results)
    return [x.name for step in program.instructions if Ref(step.name) in read
            for x in negated(step, absorbed.get(step.name))
            if isinstance(x, Ref) and x.name in fused]


@each_precision
@pytest.mark.parametrize("tier", MARKED, ids=lambda tier: tier.name)
def test_no_fused_sum_is_negated(tier: Tier, precision: Precision):
    plain = [p for p in map(plain_program, OPERATIONS) if tier.has(p)]
    assert len(plain) > 100
    results = {p.name: negated_fused_sums(tier.program(p, precision)) for p in plain}
    assert {name: sums for name, sums in results.items() if sums} == {}


def test_negating_terms_changes_no_value_and_adds_no_rounding():
    chooser, changed = random.Random(5), 0
    for plain in filter(is_polynomial, map(plain_program, OPERATIONS)):
        inputs = [[Fraction(chooser.randint(-99, 99), 7) for _ in range(a.quantity.size)]
                  for a in plain.inputs]
        program = negating_terms(plain)
        assert evaluator(program, rational({}))(inputs) == evaluator(plain, rational({}))(inputs)
        assert _rounded(program) == _rounded(plain)
        changed += program != plain
    assert changed > 20


def _rounded(program: Program) -> tuple[int, int]:
    """Numbers of products, and of sums and differences."""
    counts = program.counts
    return counts[Op.MUL], counts[Op.ADD] + counts[Op.SUB]
