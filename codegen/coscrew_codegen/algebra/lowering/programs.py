"""The plain Programs of operations."""

from dataclasses import replace
from functools import cache

from coscrew_codegen.algebra.lowering.kernel import kernel_of, simplified
from coscrew_codegen.algebra.lowering.schedule import plain
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.program import Program
from coscrew_codegen.program.program import has_rounded_constants

_OPERATIONS = {operation.name: operation for operation in OPERATIONS}


@cache
def program_of(operation: Operation) -> Program:
    """The operation's program: kernel, passes, plain tier.  Rounded constants mean that it has
    series, which end too early for twice the digits."""
    program = _derived(operation)
    if not has_rounded_constants(program):
        return program
    return replace(program, fine=_derived(operation, fine=True))


def _derived(operation: Operation, fine: bool = False) -> Program:
    return plain(simplified(kernel_of(operation, fine)))


@cache
def smooth_program(operation: Operation) -> Program:
    """The operation's program for derivatives: the same function, with results whose last digits
    differ where they are series."""
    return plain(simplified(kernel_of(operation, smooth=True)))


def library_program(name: str) -> Program:
    """The plain program of an operation of the library."""
    return program_of(_OPERATIONS[name])
