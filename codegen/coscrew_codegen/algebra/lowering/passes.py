"""Simplifications Kernel → Kernel, applied in order by `simplified`.

They remove work without changing the results: bindings to constants and to other symbols are
substituted where they are used, equal bindings are merged, unused ones are dropped.
"""

from collections.abc import Callable
from dataclasses import replace

import sympy as sp

from coscrew_codegen.algebra.lowering.kernel import Binding, Kernel


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
