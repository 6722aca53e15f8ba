"""Gappa, where it is installed, proves the bounds of kernels, and none that is smaller.

It cannot confirm the rule of rotations: it does not know that c² + s² = 1 keeps lengths."""

import shutil
import subprocess
from fractions import Fraction

import pytest

from coscrew_codegen.accuracy.float_rounding import FloatRounding
from coscrew_codegen.accuracy.rounding_rules import ValueBounds
from coscrew_codegen.algebra.lowering.programs import library_program
from coscrew_codegen.program import Constant, Input, Op, Operand, Program, scales
from coscrew_codegen.program.roundoff import Upward
from coscrew_codegen.program.values.formats import SINGLE, Precision

pytestmark = pytest.mark.skipif(shutil.which("gappa") is None, reason="Gappa is not installed")
FORMATS = {"single": "ieee_32", "double": "ieee_64"}
SIGNS = {Op.ADD: "+", Op.SUB: "-", Op.MUL: "*"}


def script(program: Program, precision: Precision, bounds: ValueBounds) -> str:
    """The text for Gappa: computed values h_…, exact ones m_…, arguments up to 1, and the bounds of
    the results' errors as the goal."""
    def name(x: Operand, kind: str) -> str:
        if isinstance(x, Input):
            return f"x{x.argument}_{x.index}"
        if isinstance(x, Constant):
            value = x.double if kind == "m" else Fraction(float(precision.rounded(x.double)))
            return f"({value.numerator}/{value.denominator})"
        return f"{kind}_{x.name}"

    lines = [f"@rnd = float<{FORMATS[precision.name]},ne>;"]
    for step in program.instructions:
        exact = step.op is Op.NEG or scales(step)
        for kind, rounds in (("h", "" if exact else " rnd"), ("m", "")):
            given = [name(x, kind) for x in step.operands]
            value = f"-{given[0]}" if step.op is Op.NEG else f" {SIGNS[step.op]} ".join(given)
            lines.append(f"{kind}_{step.name}{rounds}= {value};")
    inputs = sorted(program.used_inputs())
    lines = [*lines[:1], *(f"{name(x, 'm')} = rnd(r{name(x, 'm')});" for x in inputs), *lines[1:]]
    given = " /\\ ".join(f"{name(x, 'm')} in [-1,1]" for x in inputs)
    goals = " /\\ ".join(f"|{name(x, 'h')} - {name(x, 'm')}| in [0,{1.000001 * y.error:.17g}]"
                         for x, y in zip(program.results, bounds.results, strict=True))
    return "\n".join([*lines, f"{{ {given} -> {goals} }}"])


def proves(text: str) -> bool:
    return subprocess.run(["gappa"], input=text, text=True, capture_output=True).returncode == 0


def of_kernel(kernel: str, precision: Precision) -> tuple[Program, ValueBounds]:
    program = library_program(kernel)
    sizes = [[1.0] * a.quantity.size for a in program.inputs]
    return program, ValueBounds(program, sizes, FloatRounding(precision))


@pytest.mark.parametrize("kernel", ("dot_cs", "cross_sc", "product_CoAdc"))
def test_gappa_proves_the_bounds_of_kernels(kernel):
    program, bounds = of_kernel(kernel, SINGLE)
    assert proves(script(program, SINGLE, bounds))


def test_gappa_proves_no_bound_that_is_smaller():
    program, bounds = of_kernel("dot_cs", SINGLE)
    bounds.results = tuple(x._replace(error=Upward(0.9 * x.error)) for x in bounds.results)
    assert not proves(script(program, SINGLE, bounds))
