"""The elementary functions in C: for the library, one operation a statement; for scenes, which
contain those that they call, with nested expressions."""

import re
from collections.abc import Collection, Sequence
from dataclasses import dataclass

from coscrew_codegen.elementary import ELEMENTARY, Elementary
from coscrew_codegen.elementary.calls import FUNCTION_OF
from coscrew_codegen.formats import DOUBLE, Precision
from coscrew_codegen.program import Constant, Input, Program, counts_in_words, renamed
from coscrew_codegen.quantity import Argument
from coscrew_codegen.targets import two_over_pi
from coscrew_codegen.targets.c_function import Body, Stored
from coscrew_codegen.targets.c_nested import language
from coscrew_codegen.targets.c_statements import WIDTH, comment_of, listed
from coscrew_codegen.targets.nesting import planned

_VALUE_WIDTH = 150

HEADER = "elementary"
"""The header, and the family, that holds them all."""
CALL = re.compile(rf"\bksl_(sin|cos|{'|'.join(FUNCTION_OF.values())})f?\(")


@dataclass(frozen=True)
class Written:
    """An elementary function in a precision: what a template needs of it."""

    name: str  # exp, sincos
    comment: str
    head: str
    body: str
    near: Sequence[str] = ()  # head and body of the reductions of angles
    far: Sequence[str] = ()
    reduced: Sequence[str] = ()  # the names of what they return
    limit: str = ""
    table: str = ""  # what `far` reads


def written(precision: Precision, names: Collection[str], nested: bool = False) -> list[Written]:
    """The functions of these names."""
    return [_written(function, precision, nested) for function in ELEMENTARY
            if function.name in names]


def _written(function: Elementary, precision: Precision, nested: bool) -> Written:
    kernel = function.kernel(precision)
    comment = comment_of([f"{function.statement}.", function.comment(precision),
                          f"{counts_in_words(kernel).capitalize()}."])
    head, body = _function(f"ksl_{function.name}", function.inputs, function.outputs, kernel,
                           precision, nested)
    if not (function.near and function.far and function.limit):
        return Written(function.name, comment, head, body)
    limit = function.limit(precision)
    near, far = function.near(precision), function.far(precision)
    reductions = (_function(f"ksl_{function.name}_{place}", program.inputs, program.outputs,
                            program, precision, nested)
                  for place, program in (("near", near), ("far", far)))
    return Written(function.name, comment, head, body, *reductions,
                   [a.name for a in near.outputs],
                   precision.literal(Constant(limit, limit)) + precision.suffix,
                   two_over_pi.in_c(precision))


def _function(name: str, inputs: Sequence[Argument], outputs: Sequence[Argument], program: Program,
              precision: Precision, nested: bool) -> tuple[str, str]:
    """Head and body; the first output is returned, others are pointers."""
    first, *others = outputs
    taken = {a.name for a in outputs}
    program = renamed(program, {step.name: f"{step.name}_value" if step.name in taken
                                else step.name for step in program.instructions})
    head = listed(f"{precision.c_type} {name}{precision.suffix}(",
                  [*(f"const {precision.c_type} {a.name}" for a in inputs),
                   *(f"{precision.c_type} *{a.name}" for a in others)], ")", WIDTH - 16)

    def access(x: Input) -> str:
        return program.inputs[x.argument].name

    stored = Stored(access, [first.name, *(f"*{a.name}" for a in others)], taken, first.name)
    plan = planned(program, language(program, DOUBLE), access, _VALUE_WIDTH) if nested else None
    used = plan.program if plan else program
    return head, Body(used, precision, stored, plan).text()
