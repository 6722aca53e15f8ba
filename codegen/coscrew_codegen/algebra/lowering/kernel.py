"""Kernel: an operation as named let-bound assignments with SymPy right-hand sides.

Says which intermediate results lead to the outputs; knows nothing of rounding or text.
"""

from dataclasses import dataclass

import sympy as sp

from coscrew_codegen.algebra.operations import Operation, components
from coscrew_codegen.algebra.operations.formulas.norm import Let
from coscrew_codegen.program.values.quantity import Argument


@dataclass(frozen=True)
class Binding:
    """One let: component `index` of the intermediate vector or matrix `group` is `expression`."""

    symbol: sp.Symbol
    group: str
    index: int
    expression: sp.Expr


@dataclass(frozen=True)
class Kernel:
    """inputs → bindings, in order → outputs.  Later bindings may use earlier ones."""

    name: str
    inputs: tuple[Argument, ...]
    bindings: tuple[Binding, ...]
    outputs: tuple[Argument, ...]
    values: tuple[sp.Expr, ...]  # every component of every output, row by row


def kernel_of(operation: Operation, fine: bool = False, smooth: bool = False) -> Kernel:
    """The kernel of an operation: its derivation recorded, or its formula without lets; `fine` for
    twice the digits, `smooth` for derivatives."""
    bindings: list[Binding] = []
    taken = {a.name for a in (*operation.inputs, *operation.outputs)}

    def let(name: str, value: sp.Matrix | sp.Expr) -> sp.Matrix | sp.Expr:
        if name in taken:
            raise ValueError(f"{operation.name}: the name {name!r} is bound twice")
        taken.add(name)
        parts = components(value)
        symbols = sp.symbols(f"{name}_0:{len(parts)}") if len(parts) > 1 else (sp.Symbol(name),)
        bindings.extend(Binding(symbol, name, index, part)
                        for index, (symbol, part) in enumerate(zip(symbols, parts, strict=True)))
        return sp.Matrix(*value.shape, symbols) if isinstance(value, sp.MatrixBase) else symbols[0]

    arguments = [a.value for a in operation.inputs]
    if operation.derivation is None:
        values = operation.formula(*arguments)
    else:
        values = operation.derivation(Let(let, fine, smooth), *arguments)
    made, wanted = components(values), sum(a.quantity.size for a in operation.outputs)
    if len(made) != wanted:
        raise ValueError(f"{operation.name}: its formula has {len(made)} components, its outputs "
                         f"{wanted}")
    return Kernel(operation.name, operation.inputs, tuple(bindings), operation.outputs, made)
