"""Certificates: the bounds of every value of a function over its stated ranges, a line each, as a
checker of our own rules, which needs only fractions, reads them."""

from collections.abc import Iterator
from math import isfinite

from coscrew_codegen.accuracy.float_rounding import FloatRounding
from coscrew_codegen.accuracy.range_proofs import values
from coscrew_codegen.accuracy.rounding_rules import RoundedRange, ValueBounds
from coscrew_codegen.program import Constant, Input, Operand, Program, Ref
from coscrew_codegen.program.elementary.sincos import FUNCTION as SINCOS
from coscrew_codegen.program.scene_functions import FunctionProgram
from coscrew_codegen.program.values.formats import Precision


def certificate(function: FunctionProgram, precision: Precision) -> str:
    """The certificate of the plain function in a precision, for the results that have a bound; ""
    if none has."""
    its = values(function.program, function.ranges, precision, FloatRounding(precision))
    proved = [k for k, x in enumerate(its.results) if isfinite(x.size + x.error)]
    if not proved:
        return ""
    return "\n".join(_lines(function, precision, its, proved)) + "\n"


def _lines(function: FunctionProgram, precision: Precision, its: ValueBounds, proved: list[int]
           ) -> Iterator[str]:
    program = function.program
    sine = SINCOS.error(precision)
    yield f"# {function.name} in {precision.name} precision: for every value a line with its"
    yield "# operation, name, operands, largest size, largest error, largest error of its rounding."
    yield "# First: digits and least exponent of the format; error of sine and cosine in ulps."
    yield f"{precision.digits} {precision.least_exponent} {sine}"
    groups = {x: f"quaternion{n}" for n, each in enumerate(function.ranges.quaternions)
              for x in each} if function.ranges else {}
    needed = _needed(program, [program.results[k] for k in proved])
    for x in sorted(x for x in needed if isinstance(x, Input)):
        group = [groups[x]] if x in groups else []
        yield " ".join(["input", _name(x, program), *group, *_figures(its.of(x))])
    for step in program.instructions:
        if Ref(step.name) in needed:
            yield " ".join([step.op.value, step.name, *(_name(x, program) for x in step.operands),
                            *_figures(its.by_name[step.name])])
    places = [f"{a.name}[{k}]" for a in program.outputs for k in range(a.quantity.size)]
    for k in proved:
        yield f"# {places[k]} is {_name(program.results[k], program)}"


def _needed(program: Program, results: list[Operand]) -> set[Operand]:
    """The operands on which these results depend, and they themselves."""
    needed = set(results)
    for step in reversed(program.instructions):
        if Ref(step.name) in needed:
            needed.update(step.operands)
    return needed


def _name(x: Operand, program: Program) -> str:
    """q[3], a name, or a constant as a fraction."""
    if isinstance(x, Input):
        return f"{program.inputs[x.argument].name}[{x.index}]"
    if isinstance(x, Constant):
        return str(x.double)
    assert isinstance(x, Ref)
    return x.name


def _figures(x: RoundedRange) -> tuple[str, ...]:
    return tuple(float(y).hex() for y in (x.size, x.error, x.own))
