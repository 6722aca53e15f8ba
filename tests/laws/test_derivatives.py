"""Tangents and adjoints of Programs are derivatives: exactly for polynomials, else to 24 digits.

Truth is the function at points along a line.  A polynomial of a degree below nine is interpolated
exactly, in rationals; for others it is a difference over 2e-16 at 50 digits, whose error is about
1e-32 times the third derivative.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from math import factorial
from types import SimpleNamespace

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from coscrew_codegen.algebra.exact import is_polynomial
from coscrew_codegen.algebra.lowering.programs import program_of
from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.algebra.recording.derivatives import adjoint, tangent
from coscrew_codegen.algebra.recording.recorder import array
from coscrew_codegen.program import Input, Instruction, Op, Program, Ref, differentiate
from coscrew_codegen.program.differentiate import Dual
from coscrew_codegen.program.flops import flops
from coscrew_codegen.program.values.formats import DOUBLE
from coscrew_codegen.reports.kernels.inputs import benign
from tests.support.each import each_operation
from tests.support.scenes.evaluation import MULTIPRECISE as FIFTY
from tests.support.scenes.evaluation import Numbers, evaluator, rational

RATIONAL = rational({})
MULTIPRECISE = Numbers(replace(FIFTY.arithmetic, not_a_number=mpmath.nan), FIFTY.number)
STEP, CLOSE = mpf(10)**-16, mpf(10)**-24
ROWS = 2
FUNCTIONS = SimpleNamespace(sin=mpmath.sin, cos=mpmath.cos, less=lambda a, b: a < b,
                            where=lambda test, a, b: a if test else b)
MOST, OF_ARCTANGENT = 5, 20
"""Operations of an adjoint by those of its program: two products and a sum for a product, and the
program itself; divisions and roots take one more; arctangents quotients by the larger operand, the
sum of their squares, and two quotients."""


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(50):
        yield


def slope(f: Callable[[object], object], numbers: Numbers) -> object:
    """f'(0): of a polynomial from its values at -4 … 4, by Lagrange; else of differences."""
    if numbers is MULTIPRECISE:
        return (f(STEP) - f(-STEP)) / (2 * STEP)
    return sum(Fraction((-1)**(k + 1), k) * Fraction(factorial(4)**2,
                                                     factorial(4 - k) * factorial(4 + k))
               * (f(Fraction(k)) - f(Fraction(-k))) for k in range(1, 5))


def test_the_weights_are_exact_for_polynomials_of_a_degree_below_nine() -> None:
    for degree in range(9):
        result = slope(lambda s, n=degree: Fraction(3 + s)**n, RATIONAL)
        assert result == (degree * Fraction(3)**(degree - 1) if degree else 0)


def moved(x: Sequence, d: Sequence, s: object) -> list[list]:
    return [[a + s * b for a, b in zip(*pair, strict=True)] for pair in zip(x, d, strict=True)]


def drawn(operation: Operation, numbers: Numbers) -> Iterator[tuple[list, list, list]]:
    """Inputs of the operation's domains, directions, weights of outputs."""
    sizes = [a.quantity.size for a in operation.inputs]
    count = sum(a.quantity.size for a in operation.outputs)
    rng = np.random.default_rng([3, *operation.name.encode()])
    number = numbers.number
    for row in benign(operation, DOUBLE, ROWS, 5):
        parts = np.split(row, np.cumsum(sizes)[:-1])
        yield ([[number(Fraction(float(x))) for x in part] for part in parts],
               [[number(Fraction(float(x))) for x in rng.standard_normal(n)] for n in sizes],
               [number(Fraction(float(x))) for x in rng.standard_normal(count)])


def numbers_of(operation: Operation) -> Numbers:
    return RATIONAL if is_polynomial(operation) else MULTIPRECISE


def close(a: object, b: object, numbers: Numbers) -> bool:
    if numbers is RATIONAL:
        return a == b
    return abs(a - b) <= CLOSE * (1 + abs(b))


@each_operation
def test_tangents_are_slopes(operation: Operation) -> None:
    program, numbers = program_of(operation), numbers_of(operation)
    f, along = evaluator(program, numbers), evaluator(tangent(program), numbers)
    count = len(program.results)
    for x, d, _ in drawn(operation, numbers):
        result = along([*x, *d])
        assert [numbers.number(y) for y in result[:count]] == [numbers.number(y) for y in f(x)]
        for k in range(count):
            wanted = slope(lambda s, x=x, d=d, k=k: numbers.number(f(moved(x, d, s))[k]), numbers)
            assert close(numbers.number(result[count + k]), wanted, numbers), (operation.name, k)


@each_operation
def test_adjoints_are_transposed_tangents(operation: Operation) -> None:
    """w·(J d) = (J^T w)·d, in at most MOST times the operations."""
    program, numbers = program_of(operation), numbers_of(operation)
    along, back = tangent(program), adjoint(program)
    most = sum(OF_ARCTANGENT if step.op is Op.ATAN2 else MOST for step in program.instructions)
    assert len(back.instructions) <= most + len(back.results)
    forward, backward = evaluator(along, numbers), evaluator(back, numbers)
    count = len(program.results)
    for x, d, w in drawn(operation, numbers):
        J_d, w_J = forward([*x, *d])[count:], backward([*x, *(
            w[i.start:i.stop] for i in places(operation.outputs))])[count:]
        left = sum(a * b for a, b in zip(w, J_d, strict=True))
        right = sum(a * b for a, b in zip(w_J, [y for row in d for y in row], strict=True))
        assert close(numbers.number(left), numbers.number(right), numbers)


def places(arguments: Sequence) -> list[slice]:
    ends = list(np.cumsum([a.quantity.size for a in arguments]))
    return [slice(a, b) for a, b in zip([0, *ends[:-1]], ends, strict=True)]


@pytest.mark.parametrize("op", [op for op in Op if op.meaning.slopes], ids=lambda op: op.value)
def test_partial_derivatives_of_every_operation(op: Op) -> None:
    """By every operand, alone and together: one instruction, at positive and negative numbers."""
    names = [f"x{k}" for k in range(op.meaning.arity)]
    program = Program("one", tuple(array(x, ()) for x in names), (array("y", ()),),
                      (Instruction("y", op, tuple(Input(k, 0) for k in range(len(names))), "y"),),
                      (Ref("y"),))
    f = evaluator(program, MULTIPRECISE)
    for sign in (1, -1) if op is not Op.SQRT else (1,):
        x = [[sign * mpf(3 + 2 * k) / 7] for k in range(len(names))]
        if op is Op.PRODUCT_REST:
            x[2] = [x[0][0] * x[1][0]]  # the product, which the result does not depend on
        for chosen in range(len(names) if op is not Op.PRODUCT_REST else 2):
            d = [[mpf(k == chosen)] for k in range(len(names))]
            inputs = [[Dual(a[0], (b[0],))] for a, b in zip(x, d, strict=True)]
            (result,) = differentiate.tangent(program, MULTIPRECISE.arithmetic, FUNCTIONS, inputs)
            wanted = slope(lambda s, x=x, d=d: f(moved(x, d, s))[0], MULTIPRECISE)
            assert abs((result.slopes[0] or 0) - wanted) <= CLOSE


@pytest.mark.parametrize("first, second", [(Op.ADD, Op.SUB), (Op.SUB, Op.ADD)])
def test_a_turned_vector_is_the_derivative_of_the_other_component(first: Op, second: Op) -> None:
    """x' = c x ± s y, y' = c y ∓ s x: the derivatives by the angle are the components, so that the
    tangent takes 10 operations besides them, the adjoint 9."""
    angle, x, y = (Input(k, 0) for k in range(3))
    steps = (Instruction("s", Op.SIN, (angle,), ""), Instruction("c", Op.COS, (angle,), ""),
             Instruction("cx", Op.MUL, (Ref("c"), x), ""),
             Instruction("sy", Op.MUL, (y, Ref("s")), ""),
             Instruction("cy", Op.MUL, (Ref("c"), y), ""),
             Instruction("sx", Op.MUL, (Ref("s"), x), ""),
             Instruction("a", first, (Ref("cx"), Ref("sy")), ""),
             Instruction("b", second, (Ref("cy"), Ref("sx")), ""))
    program = Program("turn", tuple(array(name, ()) for name in ("angle", "x", "y")),
                      (array("a", ()), array("b", ())), steps, (Ref("a"), Ref("b")))
    own = evaluator(program, MULTIPRECISE)
    along, back = tangent(program), adjoint(program)
    assert (flops(along) - flops(program), flops(back) - flops(program)) == (10, 9)
    at, d, w = ([[mpf(k)] for k in row] for row in ((2, 3, 5), (7, 1, 4), (6, 8)))
    result = evaluator(along, MULTIPRECISE)([*at, *d])[2:]
    for k in range(2):
        wanted = slope(lambda s, k=k: own(moved(at, d, s))[k], MULTIPRECISE)
        assert abs(result[k] - wanted) <= CLOSE
    gradient = evaluator(back, MULTIPRECISE)([*at, *w])[2:]
    assert abs(sum(a * b[0] for a, b in zip(gradient, d, strict=True))
               - sum(a[0] * b for a, b in zip(w, result, strict=True))) <= CLOSE


@pytest.mark.parametrize("chosen", [True, False])
def test_a_choice_has_the_slopes_of_what_it_chooses(chosen: bool) -> None:
    """The slopes of the other operand, infinite here, have no effect."""
    x = Input(0, 0)
    steps = (Instruction("root", Op.SQRT, (x,), ""), Instruction("twice", Op.ADD, (x, x), ""),
             Instruction("test", Op.LESS, (x, Input(1, 0)), ""),
             Instruction("y", Op.SELECT, (Ref("test"), Ref("twice"), Ref("root")), ""))
    program = Program("choice", (array("x", ()), array("a", ())), (array("y", ()),), steps,
                      (Ref("y"),))
    f = evaluator(tangent(program), MULTIPRECISE)
    g = evaluator(adjoint(program), MULTIPRECISE)
    at, limit = mpf(9), mpf(10) if chosen else mpf(2)
    wanted = mpf(2) if chosen else mpf(1) / 6
    assert abs(f([[at], [limit], [mpf(1)], [mpf(0)]])[1] - wanted) <= CLOSE
    assert abs(g([[at], [limit], [mpf(1)]])[1] - wanted) <= CLOSE
