"""A family's kernels in Python: their text, what their modules import, what precisions share."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from types import MappingProxyType
from typing import Any

from coscrew_codegen.accuracy.tiers import TIERS, Tier
from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.backends.c.c_statements import listed
from coscrew_codegen.backends.library import FamilyKernels, Kernels, Library
from coscrew_codegen.backends.numpy.numpy_operations import (
    ELEMENTARY,
    NUMPY_NAMES,
    PythonFunction,
    docstring_of,
    exactly_in,
    function,
    is_choice_of_constants,
    literal,
)
from coscrew_codegen.backends.numpy.shared_twins import SharedProgram, shared
from coscrew_codegen.program import NotANumber, Op, Program
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE, Precision


@dataclass(frozen=True)
class Twins:
    """A family's kernels in a tier and a precision; docstrings by their names; names in the text of
    double precision that are others in this one."""

    functions: tuple[PythonFunction, ...]
    docstrings: Mapping[str, str]
    imports: tuple[tuple[str, str], ...]  # module, names
    wide: bool
    others: tuple[str, ...] = ()


def twins(kernels: FamilyKernels) -> Mapping[tuple[str, str], Twins]:
    """A family's kernels, by tier and precision."""
    return {(tier.name, precision.name): twins_of(
        kernels.of(tier, precision), precision, _shared(kernels, tier))
        for tier in TIERS for precision in kernels.precisions}


def _shared(kernels: FamilyKernels, tier: Tier) -> Mapping[str, SharedProgram]:
    """The programs of a tier that both precisions share, by the operation's name; of plain ones
    without parameters, so that the text of plain kernels has numbers."""
    if not {DOUBLE, SINGLE} <= {*kernels.precisions}:
        return {}
    single = {op.name: program for op, program in kernels.of(tier, SINGLE).items()}
    if any(program.wide for program in single.values()):
        return {}
    programs = {op.name: shared(program, single[op.name])
                for op, program in kernels.of(tier, DOUBLE).items() if op.name in single}
    return {name: program for name, program in programs.items()
            if program is not None and (tier.marked or not program.names)}


def twins_of(kernels: Kernels, precision: Precision,
             both: Mapping[str, SharedProgram] = MappingProxyType({})) -> Twins:
    """Returns the twins of these kernels in a precision; `both` have the programs that single and
    double share."""
    docstrings = {op.name: docstring_of(op, program, precision) for op, program in kernels.items()}
    wide = any(program.wide for program in kernels.values())
    if precision == DOUBLE or not both:
        return Twins(tuple(function(op, program, precision, both.get(op.name))
                           for op, program in kernels.items()),
                     docstrings, imports(tuple(kernels.values()), precision), wide)
    functions = tuple(_made_of_double(op, both[op.name], program) if op.name in both else
                      function(op, program, precision) for op, program in kernels.items())
    shared = [program for op, program in kernels.items() if op.name in both]
    own = [program for op, program in kernels.items() if op.name not in both]
    others = (x for _, names in imports((), precision, shared) for x in names.split(", "))
    return Twins(functions, docstrings, imports(own, precision, shared), wide,
                 tuple(x.partition(" as ")[2] for x in others))


def _made_of_double(operation: Operation, both: SharedProgram, single: Program) -> PythonFunction:
    """The statement that makes a kernel of single precision from that of double; its docstring is
    given if it differs."""
    words = docstring_of(operation, single, SINGLE)
    doc = [] if words == docstring_of(operation, both.program, DOUBLE) else [
        f'doc="""{words}\n"""']
    constants = both.parameters(partial(literal, precision=SINGLE))
    statement = listed(f"{operation.name} = twin(",
                       [f"double.{operation.name}", *constants, *doc], ")")
    return PythonFunction(operation.name, operation.signature, "", words, "", statement)


def imports(programs: Sequence[Program], precision: Precision,
            shared: Sequence[Program] = ()) -> tuple[tuple[str, str], ...]:
    """(module, names) of the functions these programs call; and of those that programs whose text
    is `shared` call by the name of another in double precision."""
    called, others = _called(programs, precision), _called(shared, precision)
    working = DOUBLE if any(program.wide for program in programs) else precision
    module = f"_elementary_{working.name} as elementary"
    kinds = {x: x for x in ("float32 as real", "float64 as real", "nan")}
    imported: list[tuple[str, Mapping[Any, str]]] = [
        ("coscrew", dict.fromkeys(ELEMENTARY, module)),
        ("numpy", NUMPY_NAMES | kinds),
        ("coscrew._exact", exactly_in(working))]
    texts = ((place, {names[x] for x in called & set(names)}
              | {names[x] for x in others & set(names) if " as " in names[x]})
             for place, names in imported)
    return tuple((place, ", ".join(sorted(names))) for place, names in texts if names)


def _called(programs: Sequence[Program], precision: Precision) -> set[Op | str]:
    return {op for program in programs for op in program.counts} | {
        kind for program in programs for kind in _types(program, precision)}


def _types(program: Program, precision: Precision) -> set[str]:
    """The NumPy names that choices need: nan, and the type of constants to choose between."""
    working = DOUBLE if program.wide else precision
    choices = [step for step in program.instructions if step.op is Op.SELECT]
    return ({f"{working.numpy_type} as real" for step in choices if is_choice_of_constants(step)}
            | {"nan" for step in choices if NotANumber() in step.operands})


def docstrings(library: Library, tier: Tier, precision: Precision) -> Mapping[str, str]:
    """The docstrings of a tier's kernels, by name."""
    return {name: text for made in library.made(twins).values()
            for name, text in made[tier.name, precision.name].docstrings.items()}
