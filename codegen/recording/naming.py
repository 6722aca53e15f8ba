"""Names of a recorded Program's instructions, given when it is known which of them are left."""

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass

from coscrew_codegen.program import Instruction, Op, Program, Ref, renamed


@dataclass(frozen=True)
class Part:
    """What instructions are for: a value, by symbol, of an owner, below a heading in the text."""

    owner: str
    symbol: str = ""
    heading: str = ""

    @property
    def stem(self) -> str:
        """What names of its steps begin with."""
        return f"{self.owner}_{self.symbol}" if self.symbol else self.owner

    @property
    def component(self) -> str:
        """As instructions have it."""
        return f"{self.heading}:{self.stem}"


def named(program: Program, parts: Mapping[str, Part], labels: Mapping[str, Part],
          known: Mapping[str, Instruction]) -> Program:
    """The program, its instructions named after what they compute.

    `parts` are those of the instructions, `labels` what some of the `known` ones hold; `known` are
    also instructions that the program was left without."""
    steps = program.instructions
    alive = {step.name for step in steps}
    names = _labelled(labels, alive, known)
    users = _only_users(program)
    taken: Counter[str] = Counter()
    for step in reversed(steps):  # so that what needs a step has its name first
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


def _labelled(labels: Mapping[str, Part], alive: set[str],
              known: Mapping[str, Instruction]) -> dict[str, str]:
    """Names of what holds values, or of what their negatives hold, by the old names."""
    found: dict[str, str] = {}
    taken: Counter[str] = Counter()
    for old, part in labels.items():
        stem = part.stem
        if old not in alive and known[old].op is Op.NEG:
            (x,) = known[old].operands
            if isinstance(x, Ref) and x.name not in labels:
                old, stem = x.name, f"{stem}n"
        if old in alive and old not in found:
            taken[stem] += 1
            found[old] = stem if taken[stem] == 1 else f"{stem}{taken[stem]}"
    return found


def _only_users(program: Program) -> dict[str, Instruction]:
    """The step that alone, and once, needs a step, by that one's name."""
    found: dict[str, Instruction] = {}
    uses = Counter(x.name for x in (*program.results, *(
        x for step in program.instructions for x in step.operands)) if isinstance(x, Ref))
    for step in program.instructions:
        for x in step.operands:
            if isinstance(x, Ref) and uses[x.name] == 1:
                found[x.name] = step
    return found
