"""Names the instructions of a recorded Program, when the unused ones have been removed."""

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from coscrew_codegen.program import Input, Instruction, Op, Program, Ref, renamed


@dataclass(frozen=True)
class NamePart:
    """The value that instructions compute: a symbol of an owner, below a heading in the text."""

    owner: str  # the number of a link, or a name
    symbol: str = ""
    heading: str = ""
    suffix: str = ""  # of a vector's or matrix's component: x, yz

    @cached_property
    def stem(self) -> str:
        """The beginning of its instructions' names: w3x, elbow_viscous_tau."""
        if self.owner.isdigit():
            return f"{self.symbol}{self.owner}{self.suffix}"
        return f"{self.owner}_{self.symbol}{self.suffix}" if self.symbol else self.owner

    @cached_property
    def component(self) -> str:
        """The `component` of its instructions."""
        return f"{self.heading}:{self.stem}"


def named(program: Program, parts: Mapping[str, NamePart], labels: Mapping[str, NamePart],
          known: Mapping[str, Instruction]) -> Program:
    """The program with instructions named after the values that they compute.

    `parts` maps instructions to their parts, `labels` some instructions to the values that they
    hold; `known` also contains instructions that were removed from the program."""
    steps = program.instructions
    alive = {step.name for step in steps}
    names = _labelled(labels, alive, known) | _of_angles(program)
    users = _only_users(program)
    taken: Counter[str] = Counter()
    for step in reversed(steps):  # so that the user of an instruction is named before it
        user = users.get(step.name)
        if step.name not in names and user and user.component == step.component \
                and user.name in names:
            names[step.name] = names[user.name].partition(".")[0] + "."
        names.setdefault(step.name, f"{parts[step.name].stem}.")
    for step in steps:
        if names[step.name].endswith("."):
            stem = names[step.name][:-1]
            taken[stem] += 1
            names[step.name] = f"{stem}_{taken[stem]}"
    return renamed(program, names)


def _of_angles(program: Program) -> dict[str, str]:
    """sin_q3 and cos_q3, of q[3], by the old names; sin_t."""
    names = {}
    for step in program.instructions:
        x = step.operands[0]
        if step.op in (Op.SIN, Op.COS) and isinstance(x, Input):
            argument = program.inputs[x.argument]
            index = str(x.index) if argument.quantity.shape else ""
            names[step.name] = f"{step.op.name.lower()}_{argument.name}{index}"
    return names


def _labelled(labels: Mapping[str, NamePart], alive: set[str],
              known: Mapping[str, Instruction]) -> dict[str, str]:
    """New names, by old ones, of the instructions that hold labelled values or their negatives."""
    results: dict[str, str] = {}
    taken: Counter[str] = Counter()
    for old, part in labels.items():
        stem = part.stem
        if old not in alive and known[old].op is Op.NEG:
            (x,) = known[old].operands
            if isinstance(x, Ref) and x.name not in labels:
                old, stem = x.name, f"{stem}n"
        if old in alive and old not in results:
            taken[stem] += 1
            results[old] = stem if taken[stem] == 1 else f"{stem}v{taken[stem]}"
    return results


def _only_users(program: Program) -> dict[str, Instruction]:
    """Maps each instruction that is used exactly once, by its name, to the instruction that uses
    it."""
    return {x.name: step for step in program.instructions for x in step.operands
            if isinstance(x, Ref) and program.uses[x.name] == 1}
