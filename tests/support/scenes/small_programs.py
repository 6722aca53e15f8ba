"""Programs of a few instructions."""

from coscrew_codegen.program import Input, Instruction, Op, Operand, Program, Ref
from tests.support.scenes.generated_scenes import argument

X, Y, ANGLE = (Input(0, n) for n in range(3))


def program(*steps: tuple[Op, Operand, Operand | None]) -> Program:
    """Instructions a, b, c, …, the last the result; x has three components."""
    made = tuple(Instruction("abcdefgh"[n], op, tuple(x for x in operands if x is not None), "y")
                 for n, (op, *operands) in enumerate(steps))
    return Program("small", (argument("x", 3),), (argument("y"),), made, (Ref(made[-1].name),))
