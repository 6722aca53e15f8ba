"""Nested text equals its Program; every product that is added or subtracted is rounded first."""

import gc
import random
import re
import sys
from dataclasses import dataclass, replace
from fractions import Fraction
from threading import Barrier, Thread

import pytest

from coscrew_codegen.backends.c.c_nested import declarations, language, summed_products
from coscrew_codegen.backends.nesting import NestingPlan, planned
from coscrew_codegen.backends.scene.scene_text import access
from coscrew_codegen.program import Constant, Input, Op, Operand, Program
from coscrew_codegen.program.interpreter import by_operation, evaluate, exactly
from coscrew_codegen.program.kept_results import kept_with
from coscrew_codegen.program.values.formats import DOUBLE
from tests.support.scenes.generated_scenes import Writer, argument

ARITHMETIC = {Op.ADD: 2, Op.SUB: 2, Op.MUL: 2, Op.DIV: 2, Op.NEG: 1}


@dataclass(frozen=True)
class Made:
    """A number's history as a hash: its operations in their order, none of them associative."""

    n: int

    def __add__(self, x): return Made(hash((1, self.n, x.n)))
    def __sub__(self, x): return Made(hash((2, self.n, x.n)))
    def __mul__(self, x): return Made(hash((3, self.n, x.n)))
    def __truediv__(self, x): return Made(hash((4, self.n, x.n)))
    def __neg__(self): return Made(hash((5, self.n)))


def constant(x: Constant) -> Made:
    """In the Program the sign is part of the constant; in the text it precedes the literal."""
    return Made(int(x.double)) if x.double >= 0 else -Made(-int(x.double))


def drawn(seed: int, steps: int = 300) -> Program:
    """A random Program."""
    draw = random.Random(seed)
    w = Writer(argument("x", 5))
    pool: list[Operand] = [Input(0, i) for i in range(5)]
    for n in range(steps):
        op = draw.choice(list(ARITHMETIC))
        number = Constant(Fraction(draw.choice((-3, 2, 5, 7))), Fraction(1))
        operands = [number if draw.random() < .1 else draw.choice(pool[-12:])
                    for _ in range(ARITHMETIC[op])]
        pool.append(w.do(f"value_{n}" if draw.random() < .9 else f"named{n}", op, *operands))
    return w.function("f", "numbers", (argument("y", 4),), pool[-4:]).program


def nested(program: Program, width: int) -> NestingPlan:
    return planned(program, language(program, DOUBLE), access(program), width)


def shown(plan: NestingPlan) -> tuple[str, list[str]]:
    """Declarations, results."""
    result = plan.printed(language(plan.program, DOUBLE), access(plan.program), {})
    return "\n".join(declarations(result.assigned, DOUBLE, 98)), result.results


@pytest.mark.parametrize("width", (40, 150, 10_000))
@pytest.mark.parametrize("seed", range(6))
def test_text_computes_what_the_program_does(seed: int, width: int) -> None:
    program = drawn(seed, 40 if width > 150 else 300)
    x = [Made(n) for n in (3, 5, 11, 13, 17)]
    wanted = evaluate(program, [x], by_operation(constant, exactly()))
    text, results = shown(nested(program, width))
    code = re.sub(r"const double |;$", "", text, flags=re.MULTILINE)
    code = re.sub(r"\n {4,}", " ", code)
    code = re.sub(r"(?<![\w.])(\d+\.\d+)", r"Made(int(\1))", code)
    names: dict[str, object] = {"x": x, "RN": lambda y: y, "Made": Made}
    for line in code.split("\n"):
        for item in re.split(r", (?=\w+ = )", line):
            exec(item, names)
    assert [eval(y, names) for y in results] == wanted


@pytest.mark.parametrize("seed", range(3))
def test_lines_are_short_and_numbers_have_no_gaps(seed: int) -> None:
    plan = nested(drawn(seed), 150)
    text, _ = shown(plan)
    assert all(len(line) <= 98 for line in text.split("\n"))
    numbers = [int(x) for x in re.findall(r"\bvalue_(\d+) = ", text)]
    assert numbers == list(range(1, len(numbers) + 1)) and numbers
    for step in plan.program.instructions:
        if step.name.startswith("named"):
            assert f"{step.name} = " in text


@pytest.mark.parametrize("user, rounded", (
    ((Op.ADD, "y"), True), ((Op.SUB, "y"), True), ((Op.NEG,), True), ((Op.MUL, 2), True),
    ((Op.MUL, "y"), False), ((Op.DIV, "y"), False), ((Op.SIN,), False), ((Op.ABS,), False)))
def test_products_that_a_sum_sees_are_rounded(user: tuple, rounded: bool) -> None:
    """Added directly, with the other sign, or as the sum x + x that compilers make of 2 x; results
    are rounded, too."""
    w = Writer(argument("x", 2))
    product = w.do("product", Op.MUL, w.at("x", 0), w.at("x", 1))
    op, *others = user
    use = w.do("use", op, product, *(w.at("x", 1) if y == "y" else y for y in others))
    results = [w.do("root", Op.SQRT, use)] if op is not Op.NEG else [use]
    program = w.function("f", "", (argument("y", 1),), results).program
    assert ("product" in summed_products(program)) == rounded


def test_results_and_chosen_products_are_rounded() -> None:
    w = Writer(argument("x", 2))
    a, b = w.at("x", 0), w.at("x", 1)
    chosen, result = w.do("chosen", Op.MUL, a, b), w.do("result", Op.MUL, a, a)
    choice = w.do("choice", Op.SELECT, w.do("test", Op.LESS, a, b), chosen, a)
    total = w.do("total", Op.ADD, choice, b)
    program = w.function("f", "", (argument("y", 2),), [result, total]).program
    assert summed_products(program) == {"chosen", "result"}


def test_results_are_kept_with_their_program_alone() -> None:
    """Equal programs have results of their own; none outlives its program."""
    lengths: list[int] = []

    @kept_with
    def length(program: Program) -> int:
        lengths.append(len(program.instructions))
        return lengths[-1]

    one = drawn(1, 20)
    other = replace(one)
    assert one == other and [length(x) for x in (one, other, one, other)] == [20] * 4
    assert len(lengths) == 2
    del one, other
    gc.collect()
    programs = [drawn(1, n) for n in range(21, 41)]
    for x in programs:  # a copy stands in memory where the one before it stood
        assert length(replace(x)) == len(x.instructions)


def test_threads_at_once_keep_one_result(monkeypatch: pytest.MonkeyPatch) -> None:
    """Both compute it; it goes once with the program."""
    ignored: list[object] = []
    monkeypatch.setattr(sys, "unraisablehook", ignored.append)
    both = Barrier(2)
    computed = kept_with(lambda program: both.wait(10))
    program = drawn(1, 20)
    threads = [Thread(target=computed, args=(program,)) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    del program, threads, thread
    gc.collect()
    assert not both.broken and not ignored
