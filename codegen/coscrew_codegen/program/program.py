"""Program: a kernel with its order of evaluation, one rounding an instruction.

A Program knows neither SymPy, nor its scalar type, nor a language: it is evaluated in double or
single precision, on NumPy arrays, on exact rationals or on symbols alike.
"""

from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, fields, replace
from fractions import Fraction
from functools import cached_property
from itertools import groupby
from typing import NamedTuple

from coscrew_codegen.program.ops import ERROR_OF, Op
from coscrew_codegen.program.tables import TableColumn
from coscrew_codegen.program.values.quantity import Argument


class Input(NamedTuple):
    """Component `index` (row by row) of the input number `argument`."""

    argument: int
    index: int  # type: ignore[assignment]  # of the component; hides tuple.index()


@dataclass(frozen=True)
class Constant:
    """A number; a threshold may differ between the precisions."""

    double: Fraction
    single: Fraction
    name: str = field(default="", compare=False)  # its name in text, if any
    tail: Fraction = Fraction(0)  # a last coefficient's margin for truncated terms

    def __hash__(self) -> int:
        return self._hash

    @cached_property
    def _hash(self) -> int:
        """The hash, computed once: hashing a fraction takes a modular power."""
        return hash((self.double, self.single))


ZERO, ONE = (Constant(Fraction(x), Fraction(x)) for x in (0, 1))


def constant(value: Fraction) -> Constant:
    """A number that is the same in both precisions.  0 is always ZERO itself."""
    return Constant(value, value) if value else ZERO


class Ref(NamedTuple):
    """The result of an earlier instruction."""

    name: str


@dataclass(frozen=True)
class NotANumber:
    """NaN, for results that are undefined."""


Operand = Input | Constant | NotANumber | Ref | TableColumn


def name_of(x: Operand) -> str:
    """The name of the instruction whose result it is; empty for an input or a constant."""
    return x.name if isinstance(x, Ref) else ""


class Instruction(NamedTuple):
    """name = op(operands), a step towards `component`; the last step has its name."""

    name: str
    op: Op
    operands: tuple[Operand, ...]
    component: str


def is_rounded(x: Operand) -> bool:
    """Returns whether the operand is a constant that is not a binary fraction, and so is rounded.
    """
    denominator = x.double.denominator if isinstance(x, Constant) else 1
    return bool(denominator & (denominator - 1))


def scales(step: Instruction) -> bool:
    """Returns whether this is a product with a constant power of two: exact barring over- and
    underflow."""
    if step.op is not Op.MUL:
        return False
    a, b = step.operands  # most are no constants: without a generator this is a third of the time
    return (isinstance(a, Constant) and _is_exact_power(a)
            or isinstance(b, Constant) and _is_exact_power(b))


def _is_exact_power(x: Constant) -> bool:
    return x.double == x.single and is_power_of_two(x)


def is_power_of_two(x: Constant) -> bool:
    """Returns whether the constant is one in both precisions."""
    return all(value > 0 and all(n & (n - 1) == 0 for n in value.as_integer_ratio())
               for value in (x.double, x.single))


@dataclass(frozen=True)
class Program:
    """inputs → instructions, in order → outputs."""

    name: str
    inputs: tuple[Argument, ...]
    outputs: tuple[Argument, ...]
    instructions: tuple[Instruction, ...]
    results: tuple[Operand, ...]  # every component of every output, row by row
    wide: bool = False  # computed in double though arguments are single, results rounded to single
    fine: "Program | None" = field(default=None, compare=False)
    """The same for twice the digits, if that takes other formulas: longer series, say."""

    def __hash__(self) -> int:
        return self._hash

    @cached_property
    def _hash(self) -> int:
        """The hash, computed once: caches need it often."""
        return hash((self.name, self.instructions, self.results, self.wide))

    def __getstate__(self) -> Mapping[str, object]:
        """Returns what is pickled: the fields alone; a hash kept with them would be wrong in other
        processes."""
        return {x.name: getattr(self, x.name) for x in fields(self)}

    @cached_property
    def uses(self) -> Mapping[str, int]:
        """Counts the uses of each instruction by others and by results; 0 for other names."""
        return Counter([x.name for step in self.instructions for x in step.operands
                        if isinstance(x, Ref)]
                       + [x.name for x in self.results if isinstance(x, Ref)])

    @property
    def counts(self) -> Mapping[Op, int]:
        """Number of instructions of each kind."""
        return Counter(instruction.op for instruction in self.instructions)

    @property
    def zero(self) -> bool:
        """True if all results are zero whatever the inputs."""
        return all(isinstance(x, Constant) and not (x.double or x.single) for x in self.results)

    def used_inputs(self) -> frozenset[Input]:
        """The input components that instructions or results use."""
        operands = [x for instruction in self.instructions for x in instruction.operands]
        return frozenset(x for x in (*operands, *self.results) if isinstance(x, Input))


def has_rounded_constants(program: Program) -> bool:
    """Returns whether the program computes with constants that are rounded."""
    return any(is_rounded(x) for step in program.instructions if step.op.rounds
               for x in step.operands)


def without_dead_steps(program: Program) -> Program:
    """The program without instructions that no result depends on."""
    used = {x.name for x in program.results if isinstance(x, Ref)}
    kept: list[Instruction] = []
    for step in reversed(program.instructions):
        if step.name in used:
            kept.append(step)
            used.update([x.name for x in step.operands if isinstance(x, Ref)])
    return replace(program, instructions=tuple(reversed(kept)))


def renamed(program: Program, names: Mapping[str, str]) -> Program:
    """The program with other names of its instructions."""
    others = {old: Ref(new) for old, new in names.items()}

    def changed(operands: tuple[Operand, ...]) -> tuple[Operand, ...]:
        return tuple([others[x.name] if isinstance(x, Ref) else x for x in operands])

    steps = tuple([Instruction(names[name], op, changed(operands), component)
                   for name, op, operands, component in program.instructions])
    return replace(program, instructions=steps, results=changed(program.results))


def with_constants(program: Program, other: Callable[[Constant], Constant]) -> Program:
    """The program with other constants."""
    def changed(operands: tuple[Operand, ...]) -> tuple[Operand, ...]:
        return tuple([other(x) if isinstance(x, Constant) else x for x in operands])

    steps = tuple([Instruction(name, op, changed(operands), component)
                   for name, op, operands, component in program.instructions])
    return replace(program, instructions=steps, results=changed(program.results))


def sine_cosine_pairs(program: Program) -> dict[str, tuple[Instruction, Instruction]]:
    """Sine and cosine of the same operand, and their errors, which languages compute together, by
    the names of both."""
    circular = {Op.SIN, Op.COS, Op.SIN_ERROR, Op.COS_ERROR}
    results = {(step.op, step.operands): step for step in program.instructions
               if step.op in circular}
    pairs = [(sine, results[Op.COS, x]) for (op, x), sine in results.items()
             if op is Op.SIN and (Op.COS, x) in results]
    for sine, cosine in tuple(pairs):
        errors = [results.get((ERROR_OF[step.op], (*step.operands, Ref(step.name))))
                  for step in (sine, cosine)]
        if errors[0] and errors[1]:
            pairs.append((errors[0], errors[1]))
    return {step.name: pair for pair in pairs for step in pair}


def operands_of_pair(sine: Instruction, cosine: Instruction) -> tuple[Operand, ...]:
    """Operands of the function that computes both: those of either, without repetition."""
    return tuple(dict.fromkeys((*sine.operands, *cosine.operands)))


def by_component(program: Program) -> Iterator[tuple[Instruction, ...]]:
    """Consecutive instructions of the same component, as groups: one line of text each."""
    for _, steps in groupby(program.instructions, key=lambda step: step.component):
        yield tuple(steps)


def counts_in_words(program: Program) -> str:
    """'24 mul, 18 add': operations by kind, a subtraction counted as an addition."""
    return in_words(program.counts)


def in_words(numbers: Mapping[Op, int]) -> str:
    """Writes counts as '24 mul, 18 add'."""
    counts = Counter(numbers)
    counts[Op.ADD] += counts.pop(Op.SUB, 0)
    counts[Op.MUL] += counts.pop(Op.SCALE, 0)
    for op in (Op.EXACT_ADD, Op.EXACT_SUB):
        counts[Op.ADD] += counts.pop(op, 0)
    order = (Op.MUL, Op.HIGH_PRODUCT, Op.WIDE_PRODUCT, Op.ADD, Op.ROUNDED_SHIFT,
             Op.PRODUCT_ERROR, Op.PRODUCT_REST, Op.DIV, Op.SQRT, Op.SIN, Op.COS, Op.ATAN2,
             Op.EXP, Op.TANH, *ERROR_OF.values(), Op.POWER, Op.TWO_OVER_PI, Op.NEG, Op.ABS,
             Op.COPYSIGN, Op.LESS, Op.EQUAL, Op.SELECT, Op.INDEX, Op.GATHER)
    words = [f"{counts[op]} {op.value}" for op in order if counts[op]]
    return ", ".join(words) if words else "no arithmetic"
