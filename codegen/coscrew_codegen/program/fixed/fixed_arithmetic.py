"""Programs of integers on NumPy's 64-bit integers: the bits that every target has."""

from collections.abc import Callable
from typing import Any

import numpy as np

from coscrew_codegen.program import Constant, Instruction, Op
from coscrew_codegen.program.fixed import fixed_sine
from coscrew_codegen.program.interpreter import Arithmetic, evaluate


def high_product(a: Any, b: Any) -> Any:
    """a b / 2^32 to nearest, ties upward."""
    return (a * b + (1 << 31)) >> 32


def wide_product(a: Any, b: Any, shift: int) -> Any:
    """a b 2^shift, rounded down."""
    return a * b << shift if shift >= 0 else a * b >> -shift


def rounded_shift(x: Any, shift: int) -> Any:
    """x / 2^shift to nearest, ties upward."""
    return (x + (1 << (shift - 1))) >> shift if shift else x


def sine_and_cosine(q: Any, bits: int) -> tuple[Any, Any]:
    """Sine and cosine in 2^-30 of q 2^-bits."""
    k = (high_product(q, fixed_sine.TWO_OVER_PI) + (1 << (bits - 2))) >> (bits - 1)
    r = (q << (31 - bits)) - k * fixed_sine.HALF_PI
    s, c = evaluate(fixed_sine.kernel(), [[r]], ARITHMETIC)
    s, c = np.where(k & 1, c, s), np.where(k & 1, -s, c)
    return np.where(k & 2, -s, s), np.where(k & 2, -c, c)


_FUNCTIONS: dict[Op, Callable[..., Any]] = {
    Op.ADD: lambda a, b: a + b, Op.SUB: lambda a, b: a - b, Op.NEG: lambda a: -a,
    Op.MUL: lambda a, b: a * b, Op.HIGH_PRODUCT: high_product,
    Op.WIDE_PRODUCT: lambda a, b, s: wide_product(a, b, int(s)),
    Op.ROUNDED_SHIFT: lambda x, s: rounded_shift(x, int(s)),
    Op.SIN: lambda q, bits: sine_and_cosine(q, int(bits))[0],
    Op.COS: lambda q, bits: sine_and_cosine(q, int(bits))[1]}


def _constant(x: Constant) -> Any:
    return np.int64(int(x.double))


def _function(step: Instruction, _: int) -> Callable[..., Any]:
    return _FUNCTIONS[step.op]


ARITHMETIC: Arithmetic[Any] = Arithmetic(_constant, _function)
"""Programs of integers on 64-bit integers, single or in arrays."""
