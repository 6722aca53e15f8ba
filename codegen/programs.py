"""The plain Programs of operations."""

from functools import cache

from coscrew_codegen.kernel import kernel_of
from coscrew_codegen.operations import OPERATIONS, Operation
from coscrew_codegen.passes import simplified
from coscrew_codegen.program import Program
from coscrew_codegen.schedule import plain

_OPERATIONS = {operation.name: operation for operation in OPERATIONS}


@cache
def program_of(operation: Operation) -> Program:
    """The operation's program: kernel, passes, plain tier."""
    return plain(simplified(kernel_of(operation)))


def library_program(name: str) -> Program:
    """The plain program of an operation of the library."""
    return program_of(_OPERATIONS[name])
