"""The reference of operations: a page for each family, an entry for each operation."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from coscrew_codegen.accuracy import bounds
from coscrew_codegen.accuracy.tiers import TIERS
from coscrew_codegen.algebra.operations import FAMILIES, OPERATIONS, Operation, family_named
from coscrew_codegen.backends.c import c_operations
from coscrew_codegen.backends.library import FamilyKernels, Library
from coscrew_codegen.backends.render import render
from coscrew_codegen.program import Program
from coscrew_codegen.program.values.formats import DOUBLE, PRECISIONS
from coscrew_codegen.program.values.quantity import in_words
from coscrew_codegen.program.whole_cost import whole_cost
from coscrew_codegen.reports.reference.formula import formulas
from coscrew_codegen.reports.reference.notation import escaped, markdown

_CODE = frozenset(operation.name for operation in OPERATIONS if "_" in operation.name)


@dataclass(frozen=True)
class OperationEntry:
    """The content of one operation's entry."""

    name: str
    anchor: str
    statement: str  # plain, for the table
    equation: str  # with formulas in LaTeX
    formulas: tuple[str, ...]  # LaTeX, of each output by components
    signature: str
    arguments: str
    domain: str  # the domain of each input
    tiers: tuple[tuple[str, str, str], ...]  # name, cost, error bound; plain first
    prototypes: tuple[str, ...]  # in C, double and single
    call: str  # in Python
    modules: str  # that have it in Python


def families_page(banner: str) -> str:
    """The list of families, in Markdown."""
    families = [{"name": family, "title": escaped(family_named(family).title),
                 "count": sum(operation.family == family for operation in OPERATIONS)}
                for family in FAMILIES]
    return render("docs/operations.md", banner=banner, families=families)


def family_page(family: str, library: Library) -> str:
    """The page of a family, in Markdown."""
    operations = [op for op in OPERATIONS if op.family == family]
    anchors, derived = _anchors(op.name for op in operations), library.made(_derived)[family]
    entries = [_entry(op, derived[op.name], anchor)
               for op, anchor in zip(operations, anchors, strict=True)]
    return render("docs/family.md", banner=library.banner, family=family,
                  title=family_named(family).title, entries=entries)


def _anchors(names: Iterator[str]) -> Iterator[str]:
    """The anchors of headings, as GitHub and MyST generate them: Ad, ad → ad, ad-1."""
    taken: dict[str, int] = {}
    for name in (name.lower() for name in names):
        taken[name] = taken.get(name, -1) + 1
        yield f"{name}-{taken[name]}" if taken[name] else name


@dataclass(frozen=True)
class Derived:
    """Fields of an operation's Entry that take deriving it."""

    formulas: tuple[str, ...]
    tiers: tuple[tuple[str, str, str], ...]


def _derived(kernels: FamilyKernels) -> Mapping[str, Derived]:
    return {op.name: Derived(formulas(op), tuple(_tiers(op, program)))
            for op, program in kernels.plain.items()}


def _entry(operation: Operation, derived: Derived, anchor: str) -> OperationEntry:
    arguments = tuple({a.name: a for a in (*operation.inputs, *operation.outputs)}.values())
    names = {a.name for a in arguments} | {part.name for a in arguments
                                           for part in a.quantity.parts if part.name}
    remark = f"  {operation.remark}" if operation.remark else ""
    held = {name for name, _, _ in derived.tiers}
    packages = [tier.package for tier in TIERS if tier.name in held]
    modules = [*packages[:1], *(f"{packages[0]}.{p.name}" for p in PRECISIONS), *packages[1:]]
    return OperationEntry(
        operation.name, anchor, escaped(operation.statement),
        f"{markdown(operation.statement, names, _CODE)}.{escaped(remark)}",
        derived.formulas, operation.signature, escaped(in_words(arguments)),
        escaped("; ".join(dict.fromkeys(a.domain_in_words for a in operation.inputs))),
        derived.tiers,
        tuple(f"{c_operations.prototype(operation, precision)};" for precision in PRECISIONS),
        f"{operation.name}({', '.join(a.name for a in operation.inputs)}, out=None)",
        ", ".join(f"`{module}`" for module in modules))


def _tiers(operation: Operation, program: Program) -> Iterator[tuple[str, str, str]]:
    """Rows of the table of tiers, in double precision."""
    for tier in (tier for tier in TIERS if tier.has(program)):
        made = tier.program(program, DOUBLE)
        returned = "returned beside the result" if len(made.outputs) > len(program.outputs) else ""
        tested = tier.operation(operation).tested_bounds
        yield (tier.name, whole_cost(made, DOUBLE),
               _bound(bounds.in_words(made) or tested) or returned)


def _bound(words: str) -> str:
    """The bound without the explanations that the page gives once."""
    return escaped(re.sub(r"^Error <= |, S the sum of .*|, barring over- .*|\.$", "", words))
