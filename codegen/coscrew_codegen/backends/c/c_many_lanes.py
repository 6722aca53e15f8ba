"""Kernels that call elementary functions, on vectors with a number of each of several elements.

Compilers make no vector instructions of loops over these: their reductions of large angles are
calls.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache

from coscrew_codegen.algebra.operations import Operation, family_named
from coscrew_codegen.backends.c import c_elementary, c_operations
from coscrew_codegen.backends.c.c_function import CFunction, FunctionBody, Stored
from coscrew_codegen.backends.c.c_nested import language
from coscrew_codegen.backends.c.c_statements import WIDTH, broken, listed
from coscrew_codegen.backends.library import FamilyKernels, Library
from coscrew_codegen.backends.nesting import planned
from coscrew_codegen.backends.render import render
from coscrew_codegen.backends.target import Files, Target
from coscrew_codegen.program import Input, Program, renamed
from coscrew_codegen.program.elementary.elementary_calls import FUNCTION_OF
from coscrew_codegen.program.values.formats import DOUBLE, Precision, in_lanes
from coscrew_codegen.program.values.quantity import Quantity

HEADER = "ksl_states"
"""The header that those of families share: elementary functions on vectors."""


@dataclass(frozen=True)
class _Section:
    """Texts from which a template writes elementary functions on vectors of a precision."""

    precision: Precision

    @property
    def functions(self) -> list[c_elementary.ElementaryText]:
        names = c_elementary.CALLABLE[c_elementary.HEADER]
        return [replace(x, body=rounded(x.body, self.precision), near=[
            rounded(text, self.precision) for text in x.near])
            for x in c_elementary.written(in_lanes(self.precision), names, nested=True)]

    @property
    def mask(self) -> str:
        """All bits but the sign."""
        return hex(2**(8 * self.precision.bytes - 1) - 1)

    @property
    def packed(self) -> str:
        """Ending of the names of x86 instructions."""
        return "ps" if self.precision.suffix else "pd"


def files(library: Library) -> Files:
    """c/include/ksl/exponential_states.h and so on."""
    return {f"c/include/ksl/{name}.h": text for name, text in headers(library).items()}


@cache  # also used by the extension target
def headers(library: Library) -> Mapping[str, str]:
    """Returns the shared header, and one for each family that has such kernels."""
    shared = render("c/ksl_states.h", banner=library.banner,
                    sections=list(map(_Section, library.precisions)))
    return {HEADER: shared} | {
        named(family): _header(library, family, held)
        for family, held in library.made(kernels).items() if held}


def named(family: str) -> str:
    """The header of a family's kernels on vectors: exponential_states."""
    return f"{family}_states"


def _header(library: Library, family: str, held: Mapping[tuple[str, str], CFunction]) -> str:
    return render(
        "c/states_of_family.h", banner=library.banner, guard=f"KSL_{family.upper()}_STATES_H",
        title=f"{family_named(family).title}  On vectors.", header=HEADER,
        functions=list(held.values()))


def kernels(held: FamilyKernels) -> Mapping[tuple[str, str], CFunction]:
    """The plain ones that call elementary functions, by operation and precision."""
    return {(op.name, precision.name): _kernel(op, program, precision)
            for precision in held.precisions for op, program in held.plain.items()
            if program.counts.keys() & FUNCTION_OF.keys()}


def place(quantity: Quantity, component: int) -> int:
    """Returns the place of a component in a struct: matrices are stored column by column."""
    row, column = quantity.indices[component]
    return column * quantity.shape[0] + row if len(quantity.shape) == 2 else component


def _kernel(operation: Operation, program: Program, precision: Precision) -> CFunction:
    lanes = in_lanes(precision)
    arguments = {a.name: a for a in (*operation.inputs, *operation.outputs)}
    program = renamed(program, {step.name: f"{step.name}_" if step.name in arguments else step.name
                                for step in program.instructions})

    def access(x: Input) -> str:
        argument = program.inputs[x.argument]
        return f"{argument.name}[{place(argument.quantity, x.index)}]"

    targets = [f"{a.name}[{place(a.quantity, j)}]" for a in operation.outputs
               for j in range(a.quantity.size)]
    written = {a.name for a in operation.outputs}
    plan = planned(program, language(program, DOUBLE), access, 150)
    body = FunctionBody(plan.program, lanes, Stored(access, targets, written), plan,
                        apart=True).text()
    name = f"{c_operations.c_name(operation.name, precision)}_states"
    taken = [f"{'' if x in written else 'const '}{lanes.c_type} *{x}" for x in arguments]
    return CFunction(name, "", listed(f"void {name}(", taken, ")", WIDTH - 19),
                     rounded(body, precision))


def rounded(text: str, precision: Precision) -> str:
    """Wraps a text in the macro of this precision's products."""
    return broken(re.sub(r"\bRN\(", f"KSL_RN_LANES{precision.suffix.upper()}(", text), WIDTH)


TARGET = Target("C headers of kernels on vectors", ("c",), library=files)
