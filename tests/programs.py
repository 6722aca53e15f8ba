"""Programs evaluated step by step, on arrays."""

import numpy as np

from coscrew_codegen.program import Constant, Input, Op, Program

_NUMPY = {
    Op.ADD: np.add, Op.SUB: np.subtract, Op.MUL: np.multiply, Op.SCALE: np.multiply,
    Op.DIV: np.divide, Op.NEG: np.negative, Op.ABS: np.abs, Op.SQRT: np.sqrt, Op.SIN: np.sin,
    Op.COS: np.cos, Op.ATAN2: np.arctan2, Op.EXP: np.exp, Op.TANH: np.tanh, Op.LESS: np.less,
    Op.EQUAL: np.equal, Op.SELECT: np.where}


def evaluated(program: Program, *arguments: np.ndarray) -> list[np.ndarray]:
    """All components of the outputs, in the arguments' precision; an argument's last axis is its
    components, but for scalars."""
    dtype = np.result_type(*arguments)
    found = {}

    def operand(x):
        if isinstance(x, Constant):
            value = x.single if dtype == np.float32 else x.double
            return dtype.type(float(value))
        if isinstance(x, Input):
            whole = arguments[x.argument]
            return whole[..., x.index] if program.inputs[x.argument].quantity.shape else whole
        return found[x.name]

    for step in program.instructions:
        found[step.name] = _NUMPY[step.op](*map(operand, step.operands))
    shape = np.broadcast_shapes(*(a.shape[:-1] if program.inputs[n].quantity.shape else a.shape
                                  for n, a in enumerate(arguments)))
    return [np.broadcast_to(np.asarray(operand(x), dtype), shape) for x in program.results]
