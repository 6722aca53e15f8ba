"""Kernel: an operation as named let-bound assignments with SymPy right-hand sides.

Says which intermediate results lead to the outputs; knows nothing of rounding or text.  Passes
remove work without changing the results: bindings to constants and to other symbols are substituted
where they are used, equal bindings are merged, unused ones are dropped.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

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


def _substituting(kernel: Kernel, replaces: Callable[[Binding], sp.Expr | None]) -> Kernel:
    """Drop each binding for which `replaces` gives an expression, and substitute that."""
    known: dict[sp.Symbol, sp.Expr] = {}
    kept: list[Binding] = []
    for binding in kernel.bindings:
        binding = replace(binding, expression=binding.expression.xreplace(known))
        replacement = replaces(binding)
        if replacement is None:
            kept.append(binding)
        else:
            known[binding.symbol] = replacement
    return replace(kernel, bindings=tuple(kept),
                   values=tuple(value.xreplace(known) for value in kernel.values))


def fold_trivial(kernel: Kernel) -> Kernel:
    """Substitute bindings to a number, a symbol or a negated symbol: structural zeros, copies."""
    def trivial(binding: Binding) -> sp.Expr | None:
        core = -binding.expression if binding.expression.could_extract_minus_sign() \
            else binding.expression
        return binding.expression if core.is_Atom else None

    return _substituting(kernel, trivial)


def merge_equal(kernel: Kernel) -> Kernel:
    """Bind equal right-hand sides once."""
    first: dict[sp.Expr, sp.Symbol] = {}

    def earlier(binding: Binding) -> sp.Symbol | None:
        symbol = first.setdefault(binding.expression, binding.symbol)
        return None if symbol == binding.symbol else symbol

    return _substituting(kernel, earlier)


def drop_dead(kernel: Kernel) -> Kernel:
    """Drop bindings that no output depends on."""
    used = set().union(*(value.free_symbols for value in kernel.values))
    kept: list[Binding] = []
    for binding in reversed(kernel.bindings):
        if binding.symbol in used:
            kept.append(binding)
            used |= binding.expression.free_symbols
    return replace(kernel, bindings=tuple(reversed(kept)))


PASSES = (fold_trivial, merge_equal, drop_dead)


def simplified(kernel: Kernel) -> Kernel:
    """The kernel after all passes, in order."""
    for one_pass in PASSES:
        kernel = one_pass(kernel)
    return kernel
