"""Finds the sums of a Program with all their terms, for tiers that add in another order: no tier
here does, CONTRIBUTING.md shows one.

A chain of additions in which only the next one uses each partial sum is one sum of many terms."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from coscrew_codegen.program.ops import Op
from coscrew_codegen.program.program import Instruction, Operand, Program, Ref

_SUMS = (Op.ADD, Op.SUB)


@dataclass(frozen=True)
class Term:
    """± x, one term of a sum."""

    negative: bool
    x: Operand


Tree = int | tuple["Tree", "Tree"]
"""How n terms are added: a term's number, or two trees whose values are added."""


def rearranged(program: Program, tree: Callable[[Sequence[Term]], Tree]) -> Program:
    """The program with every sum added in the order of `tree(terms)`.

    `tree` receives the terms in the order of the program.  There are as many additions as before,
    under their old names; other instructions stay as they are."""
    sums = {step.name: step for step in program.instructions if step.op in _SUMS}
    partial = {x.name for step in sums.values() for x in step.operands
               if isinstance(x, Ref) and x.name in sums and program.uses[x.name] == 1}
    steps: list[Instruction] = []
    for step in program.instructions:
        if step.name in sums and step.name not in partial:
            terms, names = _taken_apart(step, sums, partial)
            steps += _added(step, terms, names, tree(terms))
        elif step.name not in partial:
            steps.append(step)
    return replace(program, instructions=tuple(steps))


def _taken_apart(step: Instruction, sums: dict[str, Instruction], partial: set[str]
                 ) -> tuple[list[Term], list[str]]:
    """The terms of a sum, and the names of its additions, the last one last."""
    terms: list[Term] = []
    names: list[str] = []
    for x, negated in zip(step.operands, (False, step.op is Op.SUB), strict=True):
        if isinstance(x, Ref) and x.name in partial:
            inner, inside = _taken_apart(sums[x.name], sums, partial)
            terms += [Term(term.negative != negated, term.x) for term in inner]
            names += inside
        else:
            terms.append(Term(negated, x))
    return terms, [*names, step.name]


def _added(last: Instruction, terms: Sequence[Term], names: list[str], tree: Tree
           ) -> list[Instruction]:
    """The additions, those of the left subtree first.

    A sum of negative terms is added up without its sign and subtracted where it meets a positive
    one; the first term of a sum is always positive."""
    steps: list[Instruction] = []

    def value(tree: Tree) -> Term:
        if isinstance(tree, int):
            return terms[tree]
        left, right = map(value, tree)
        op = Op.ADD if left.negative == right.negative else Op.SUB
        operands = (right.x, left.x) if left.negative and not right.negative else (left.x, right.x)
        steps.append(last._replace(name=names[len(steps)], op=op, operands=operands))
        return Term(left.negative and right.negative, Ref(steps[-1].name))

    value(tree)
    return steps
