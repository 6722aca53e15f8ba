"""Requirements of Python's functions: matrices that are rotations, quaternions with a direction."""

from collections.abc import Iterable, Mapping
from enum import Enum
from functools import cache

from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.backends.library import FamilyKernels
from coscrew_codegen.program import Input, Program
from coscrew_codegen.program.ops import POLYNOMIAL
from coscrew_codegen.program.values.quantity import (
    DC,
    DISPLACEMENT,
    MAT3X3,
    NONZERO,
    NONZERO_MATRIX,
    ORDINARY,
    ROTATION,
    SCALAR,
    UNIT_QUATERNION,
    VEC3,
)


class Required(Enum):
    """Requirements of an argument; values are letters that generated code stores."""

    NOTHING = "."
    ROTATION = "R"  # the matrix, or R of a displacement
    UNIT = "U"  # a quaternion of length 1
    DIRECTION = "N"  # a quaternion other than zero
    NOT_ZERO = "M"  # a matrix other than zero


@cache
def defects() -> Mapping[Required, Operation]:
    """The operations whose results show, by a size above TOLERANCE, that an argument violates its
    requirement."""
    named = {op.name: op for op in OPERATIONS}
    return {Required.ROTATION: named["mat3x3_rotation_defect"],
            Required.UNIT: named["quaternion_unit_defect"]}


def defects_of(letters: Iterable[str]) -> Mapping[Required, Operation]:
    """The defects that functions with these requirements need, by requirement."""
    results = set().union(*letters)
    return {required: op for required, op in defects().items() if required.value in results}


def requirements(kernels: FamilyKernels) -> Mapping[str, str]:
    """The letters of every operation's arguments, by name; without operations that take all."""
    letters_of = {op.name: "".join(_of(op, program, n).value for n in range(len(op.inputs)))
                  for op, program in kernels.plain.items()}
    return {name: letters for name, letters in letters_of.items()
            if set(letters) != {Required.NOTHING.value}}


def _of(operation: Operation, program: Program, number: int) -> Required:
    domain = operation.inputs[number].domain
    if domain in (NONZERO, ORDINARY):
        return Required.DIRECTION
    if domain == NONZERO_MATRIX:
        return Required.NOT_ZERO
    if domain == ROTATION and not _is_algebra_of_matrices(operation, program):
        return Required.ROTATION
    if domain == DISPLACEMENT and _calculates(program, number):
        return Required.ROTATION
    if domain == UNIT_QUATERNION and not _is_product_of_quaternions(operation, program):
        return Required.UNIT
    return Required.NOTHING


def _is_algebra_of_matrices(operation: Operation, program: Program) -> bool:
    """Returns whether it copies, transposes or multiplies matrices and vectors, which need no
    rotation."""
    plain = all(a.quantity in (MAT3X3, VEC3, DC, SCALAR)
                for a in (*operation.inputs, *operation.outputs))
    return plain and program.counts.keys() <= POLYNOMIAL


def _calculates(program: Program, number: int) -> bool:
    """Returns whether instructions read R of this displacement."""
    columns = range(3)
    indices = program.inputs[number].quantity.indices
    return any(isinstance(x, Input) and x.argument == number and indices[x.index][1] in columns
               for step in program.instructions for x in step.operands)


def _is_product_of_quaternions(operation: Operation, program: Program) -> bool:
    """Returns whether it multiplies or adds quaternions, which may also be rates or multiples of
    unit ones; else it turns vectors, or interpolates rotations."""
    turns = any(a.quantity == VEC3 for a in operation.outputs)
    return not turns and program.counts.keys() <= POLYNOMIAL
