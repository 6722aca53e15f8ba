"""The certified tier of scenes' functions in single precision.

The plain results x̂ are computed first.  Then the certified program in double, with the exact
decimals of single's constants, gives w and its bound B, so

    |x̂ - x| <= |x̂ - w| + B.

That nearly equals the true error, since w is 2^29 times more exact than x̂. So B need not be near
the error of w: |d| <= k u S takes the place of d, which is not computed.  κ is large then, so that
k u S / κ u, a part of A, remains small.  But sizes grow fast where quotients follow each other, as
in forward dynamics, and in polynomials whose coefficients are read from tables: there d is
computed.

The sum has three roundings in double, and one to single precision, which loses at most u of it or
half the least subnormal number.  The factor 1 + 4 u and this number, added unless the sum is 0,
exceed all of them."""

from dataclasses import replace
from fractions import Fraction

from coscrew_codegen.accuracy.tiers.certified_scene import COMPUTED, RULES, extended
from coscrew_codegen.accuracy.tiers.sizes import Sizing
from coscrew_codegen.accuracy.tiers.tier import bounds_of_outputs
from coscrew_codegen.program import (
    ZERO,
    Constant,
    Input,
    Instruction,
    NotANumber,
    Op,
    Operand,
    Program,
    Ref,
    constant,
    with_constants,
    without_dead_steps,
)
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE
from coscrew_codegen.program.values.quantity import Argument

ROUNDED = constant(1 + 4 * SINGLE.u)
LEAST = constant(2 * SINGLE.eta)
SIZES_ALONE = Sizing(RULES, spread=2**24, computed=False)


def of_scene(program: Program) -> Program:
    """The plain program's results, which are further inputs, and their bounds in single precision.
    Raises NoRuleError."""
    return _with_plain_results(program, in_double(program))


def in_double(program: Program) -> Program:
    """w and B: the certified program in double, with the values of single's constants.  Raises
    NoRuleError."""
    exact = with_constants(program.fine or program, lambda x: replace(x, double=x.single))
    grows = any(step.op in (Op.DIV, Op.SQRT, Op.GATHER) and isinstance(step.operands[-1], Ref)
                for step in exact.instructions)
    return extended(exact, DOUBLE, COMPUTED if grows else SIZES_ALONE)


def _with_plain_results(plain: Program, certified: Program) -> Program:
    """The program that takes the plain program's results besides its certified results in double.
    """
    count, first = len(plain.results), len(plain.inputs)
    given = tuple(Argument(f"{plain.name}_{a.name}", a.quantity) for a in plain.outputs)
    places = {f"{a.name}_{k}_distance": Input(first + n, k) for n, a in enumerate(given)
              for k in range(a.quantity.size)}
    steps, bounds = list(certified.instructions), []
    for (name, x), w, bound in zip(places.items(), certified.results[:count],
                                   certified.results[count:], strict=True):
        bounds.append(bound if _is_kept(w, bound) else _bound(steps, name, x, w, bound))
    return without_dead_steps(replace(
        certified, inputs=(*plain.inputs, *given), instructions=tuple(steps), wide=True,
        outputs=(*plain.outputs, *bounds_of_outputs(plain.outputs)),
        results=(*places.values(), *bounds)))


def _is_kept(w: Operand, bound: Operand) -> bool:
    """Returns whether w is a number of single precision, so that the result has no error, or the
    result is NaN."""
    exact = isinstance(w, Input) or isinstance(w, Constant) and w.double == Fraction(
        float(SINGLE.rounded(w.double)))
    return bound == ZERO and exact or isinstance(bound, NotANumber)


def _bound(steps: list[Instruction], name: str, x: Operand, w: Operand, bound: Operand) -> Operand:
    """Issues |x̂ - w| + B, rounded up unless it is 0; its names begin with this one."""
    last = "bounds of the errors:"
    sums = ((Op.ADD, bound),) if bound != ZERO else ()
    for number, (op, *more) in enumerate(((Op.SUB, w), (Op.ABS,), *sums, (Op.MUL, ROUNDED)), 1):
        steps.append(Instruction(f"{name}_{number}", op, (x, *more), last))
        x = Ref(f"{name}_{number}")
    test, least, total = (f"{name}_{word}" for word in ("test", "least", "total"))
    steps += [Instruction(test, Op.LESS, (ZERO, x), last),
              Instruction(least, Op.SELECT, (Ref(test), LEAST, ZERO), last),
              Instruction(total, Op.ADD, (x, Ref(least)), last)]
    return Ref(total)
