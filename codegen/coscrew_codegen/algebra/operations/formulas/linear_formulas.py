"""The operations of every linear space: copy, scale, negate, add, subtract, a x + y."""

from functools import partial

from coscrew_codegen.algebra.operations.operation import Operation
from coscrew_codegen.program.values.quantity import ANY, SCALAR, Argument, Quantity


def linear_space(family: str, kind: Quantity, letter: str) -> tuple[Operation, ...]:
    """Linear operations of `kind`; `letter` names it in binary operations (add_cc, axpy_ss)."""
    one, two, i, o, self, x, y = (Argument(name, kind, kind.domain or ANY) for name in (
        *(f"{letter}{suffix}" for suffix in "12io"), "self", "x", "y"))
    a = Argument("a", SCALAR, ANY)
    pair = letter * 2
    out, oi = o.name, i.name

    op = partial(Operation, family)
    return (
        op(f"{kind.name}_copy", f"{out} = {oi}", (i,), (o,), lambda x: x),
        op(f"{kind.name}_scale", "self = a self", (self, a), (self,), lambda x, a: a * x),
        op(f"{kind.name}_inverted", f"{out} = -{oi}", (i,), (o,), lambda x: -x),
        op(f"{kind.name}_invert", "self = -self", (self,), (self,), lambda x: -x),
        op(f"axpy_{pair}", "y = a x + y", (a, x, y), (y,), lambda a, x, y: a * x + y),
        op(f"xpy_{pair}", "y = x + y", (x, y), (y,), lambda x, y: x + y),
        op(f"nxpy_{pair}", "y = -x + y", (x, y), (y,), lambda x, y: y - x),
        op(f"product_a{letter}", f"{out} = a {oi}", (a, i), (o,), lambda a, x: a * x),
        op(f"add_{pair}", f"{out} = {letter}1 + {letter}2", (one, two), (o,), lambda x, y: x + y),
        op(f"subtract_{pair}", f"{out} = {letter}1 - {letter}2", (one, two), (o,),
           lambda x, y: x - y),
    )
