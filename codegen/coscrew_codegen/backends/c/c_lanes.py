"""Sines and cosines of several angles at once, and their errors, in the C of scenes: on vectors
where the processor has them, with the bits of one angle alone."""

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from coscrew_codegen.backends.c.c_nested import declarations, language
from coscrew_codegen.backends.c.c_statements import WIDTH, listed
from coscrew_codegen.backends.c.c_together import LANES, TOGETHER
from coscrew_codegen.backends.nesting import CALL, Language, planned
from coscrew_codegen.backends.render import render
from coscrew_codegen.program import Constant, Input, Instruction, Op, Operand, Program, renamed
from coscrew_codegen.program.elementary import Elementary
from coscrew_codegen.program.values.formats import DOUBLE, Precision

SEVERAL = {name: {f"{name}_{n}": n for n in range(2, LANES + 1)} for name in TOGETHER.values()}
"""The functions that compute one of these for several angles, and how many."""

_ZERO = Constant(Fraction(0), Fraction(0))

_FUSED = {"double": {"vector": "(__m256d)", "fused": "_mm256_fmsub_pd"},
          "single": {"vector": "(__m128)", "fused": "_mm_fmsub_ps"}}


def written(function: Elementary, precision: Precision, wanted: Sequence[int]) -> str:
    """The functions for so many angles."""
    assert function.near and function.limit
    limit = function.limit(precision)
    given = [a.name for a in function.inputs[1:]]
    near, kernel = (_on_vectors(make(precision), precision, given)
                    for make in (function.near, function.kernel))
    outputs = [a.name for a in function.outputs]
    low = precision.digits - precision.digits // 2  # bits of the lower halves
    return render("c/lanes", precision=precision, near=near, kernel=kernel, lanes=LANES,
                  size=LANES * precision.bytes, several=f"ksl_{function.name}_",
                  padded={n: ", ".join((_padded(n), *given, *outputs)) for n in wanted},
                  heads={n: _head(function, n, precision) for n in (LANES, *wanted)},
                  name=function.name, given=given,
                  outputs=outputs,
                  limit=precision.literal(Constant(limit, limit)) + precision.suffix,
                  reduced=[a.name for a in function.near(precision).outputs],
                  mask=hex(2**(8 * precision.bytes - 1) - 1), exact=Op.PRODUCT_ERROR in
                  function.kernel(precision).counts, half=hex(2**(low - 1)),
                  upper=hex(2**(8 * precision.bytes) - 2**low), **_FUSED[precision.name])


def _head(function: Elementary, count: int, precision: Precision) -> str:
    real = precision.c_type
    return listed(f"void ksl_{function.name}_{count}{precision.suffix}(",
                  [*(f"const {real} x{n}" for n in range(count)),
                   *(f"const {real} {a.name}[{LANES}]" for a in function.inputs[1:]),
                   *(f"{real} {a.name}[{LANES}]" for a in function.outputs)], ")", WIDTH - 20)


def _padded(count: int) -> str:
    """Returns `count` angles, the last of them repeated up to a number that a function takes."""
    return ", ".join(f"x{min(n, count - 1)}" for n in range(LANES))


def _on_vectors(program: Program, precision: Precision, given: Sequence[str]
                ) -> tuple[Sequence[str], Sequence[str]]:
    """Declarations, and the results.  Constants have no names: no vector is initialised with a
    number."""
    outputs = {a.name for a in program.outputs}
    program = _without_names_of_constants(renamed(program, {
        step.name: f"{step.name}_value" if step.name in outputs else step.name
        for step in program.instructions}))
    vectors = replace(precision, c_type=f"ksl_lanes{precision.suffix}")

    def access(x: Input) -> str:
        name = program.inputs[x.argument].name
        return f"{name}_lanes" if name in given else name

    plan = planned(program, language(program, DOUBLE), access, 150)
    text = plan.printed(_language(plan.program, precision), access, {})
    return list(declarations(text.assigned, vectors, WIDTH - 2)), text.results


def _language(program: Program, precision: Precision) -> Language:
    """C on vectors."""
    scalar, f = language(program, precision), precision.suffix.upper()

    def spelling(step: Instruction) -> tuple[str, int]:
        if step.op is Op.ABS:
            return f"KSL_ABS_LANES{f}({{}})", CALL
        if step.op is Op.PRODUCT_ERROR:
            return f"KSL_PRODUCT_ERROR_LANES{f}({{}}, {{}}, {{}})", CALL
        if step.op is Op.SELECT and step.operands[1] == _ZERO:
            return f"KSL_UNLESS_LANES{f}({{0}}, {{2}})", CALL
        pattern, binding = scalar.spelling(step)
        return pattern.replace("RN(", f"KSL_ROUNDED_LANES{f}("), binding

    return replace(scalar, spelling=spelling)


def _without_names_of_constants(program: Program) -> Program:
    def other(x: Operand) -> Operand:
        return replace(x, name="") if isinstance(x, Constant) else x

    return replace(program, instructions=tuple(
        step._replace(operands=tuple(map(other, step.operands))) for step in program.instructions))
