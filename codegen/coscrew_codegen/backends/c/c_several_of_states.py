"""Sines and cosines of several angles of each of several states, which scenes' functions on vectors
call: the instructions for all angles in turn, so that processors work at all of them at a time."""

from collections.abc import Sequence
from dataclasses import replace

from coscrew_codegen.backends.c.c_nested import declarations, language
from coscrew_codegen.backends.c.c_statements import WIDTH, listed
from coscrew_codegen.backends.c.c_together import LANES
from coscrew_codegen.backends.nesting import planned
from coscrew_codegen.backends.render import render
from coscrew_codegen.program import Constant, Input, Instruction, Operand, Program, Ref
from coscrew_codegen.program.elementary import Elementary
from coscrew_codegen.program.values.formats import BY_NAME, DOUBLE, Precision
from coscrew_codegen.program.values.quantity import Argument


def written(function: Elementary, precision: Precision, count: int) -> str:
    """The function of so many angles, on vectors."""
    assert function.near and function.limit
    numbers = BY_NAME[precision.name]
    limit, vector = function.limit(numbers), precision.c_type
    reduced, outputs = ([a.name for a in x] for x in (function.near(numbers).outputs,
                                                      function.outputs))
    near, statements = _on_vectors(function.near(numbers), precision, count)
    kernel, results = _on_vectors(function.kernel(numbers), precision, count)
    head = listed(f"void ksl_{function.name}_{count}{precision.called}(",
                  [*(f"const {vector} x_{n}" for n in range(1, count + 1)),
                   *(f"{vector} {x}[{LANES}]" for x in outputs)], ")", WIDTH - 20)
    return render("c/several_of_states", precision=numbers, name=function.name, head=head,
                  near=near, kernel=kernel, reduced=reduced,
                  limit=numbers.literal(Constant(limit, limit)) + numbers.suffix,
                  angles=[{"number": n, "reduced": list(zip(reduced, x, strict=True)),
                           "results": list(zip(outputs, y, strict=True))}
                          for n, (x, y) in enumerate(zip(statements, results, strict=True), 1)])


def _on_vectors(program: Program, precision: Precision, count: int
                ) -> tuple[list[str], list[Sequence[str]]]:
    """Declarations, and the results of each angle."""
    each = len(program.results)
    program = in_turn(program, count)

    def access(x: Input) -> str:
        return program.inputs[x.argument].name

    plan = planned(program, language(program, DOUBLE), access, 150)
    text = plan.printed(language(plan.program, precision), access, {})
    return (list(declarations(text.assigned, precision, WIDTH - 2)),
            [text.results[n:n + each] for n in range(0, len(text.results), each)])


def in_turn(program: Program, count: int) -> Program:
    """Returns `count` copies of the program, with arguments of their own, instructions interleaved.
    """
    taken = {a.name for a in program.outputs}

    def named(name: str, n: int) -> str:
        return f"{name}_value_{n + 1}" if name in taken else f"{name}_{n + 1}"

    def operand(x: Operand, n: int) -> Operand:
        if isinstance(x, Input):
            return Input(x.argument + n * len(program.inputs), x.index)
        return Ref(named(x.name, n)) if isinstance(x, Ref) else x

    def step(x: Instruction, n: int) -> Instruction:
        return x._replace(name=named(x.name, n), operands=tuple(operand(y, n) for y in x.operands))

    def arguments(of: Sequence[Argument]) -> tuple[Argument, ...]:
        return tuple(replace(a, name=f"{a.name}_{n + 1}") for n in range(count) for a in of)

    return replace(
        program, inputs=arguments(program.inputs), outputs=arguments(program.outputs),
        instructions=tuple(step(x, n) for x in program.instructions for n in range(count)),
        results=tuple(operand(x, n) for n in range(count) for x in program.results))
