"""A Rust target: a module a family, each kernel a function on slices, in double precision."""

from coscrew_codegen.formats import DOUBLE, Precision
from coscrew_codegen.library import Library
from coscrew_codegen.operations import Operation, family_named
from coscrew_codegen.program import Constant, Input, NotANumber, Op, Operand, Program
from coscrew_codegen.quantity import Argument
from coscrew_codegen.render import render
from coscrew_codegen.targets.target import Files, Target
from coscrew_codegen.tiers import PLAIN

_SPELLING = {Op.ADD: "{} + {}", Op.SUB: "{} - {}", Op.MUL: "{} * {}", Op.NEG: "-{}"}


def files(library: Library) -> Files:
    """rust/vec3.rs and so on: the kernels that are sums and products."""
    return {f"rust/{family}.rs": render(
        "rust/family.rs", banner=library.banner, title=family_named(family).title,
        functions=[_function(op, program, DOUBLE) for op, program in kernels.items()
                   if program.counts.keys() <= _SPELLING.keys()])
        for family, kernels in library.by_family(PLAIN, DOUBLE).items()}


def _function(operation: Operation, program: Program, precision: Precision) -> dict[str, object]:
    def operand(x: Operand) -> str:
        if isinstance(x, Input):
            return f"{program.inputs[x.argument].name}[{x.index}]"
        if isinstance(x, Constant):
            return f"{precision.literal(x)}_f64"
        return "f64::NAN" if isinstance(x, NotANumber) else x.name

    steps = [(step.name, _SPELLING[step.op].format(*map(operand, step.operands)))
             for step in program.instructions]
    return {"name": operation.name, "statement": operation.statement,
            "parameters": ", ".join(map(_parameter, program.inputs)), "steps": steps,
            "size": len(program.results), "results": ", ".join(map(operand, program.results))}


def _parameter(argument: Argument) -> str:
    return f"{argument.name}: &[f64; {argument.quantity.size}]"


TARGET = Target("Rust", ("rust",), library=files)
