"""Sines and cosines of several angles, which one call computes."""

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from coscrew_codegen.backends.c.c_statements import listed
from coscrew_codegen.backends.nesting import Assignment, NestingPlan
from coscrew_codegen.program import Input, Instruction, Op, Program, Ref, renamed, sine_cosine_pairs
from coscrew_codegen.program.values.formats import Precision

LANES = 4  # angles whose sines and cosines are computed at once
OF_STATES = 3  # the same on vectors of states: more do not fit into registers
TOGETHER = {Op.SIN: "sincos", Op.SIN_ERROR: "sincos_error"}
"""Operations that are computed for several angles at once."""
UNROLLED = "COSCREW_UNROLLED"
"""Stands above loops whose rounds a processor should compute at the same time: rolled, those over
the sines of twelve joints make functions up to 19 % slower."""
_INDEXED = re.compile(r"(\w+)(?:\[(\d+)\])?")


@dataclass(frozen=True)
class Together:
    """Sines and cosines that are computed by one call, or what these err by."""

    pairs: Sequence[Assignment]
    of: "Together | None" = None  # the sines and cosines whose errors these are

    @property
    def step(self) -> Instruction:
        """The first of them."""
        return self.pairs[0].step

    @property
    def names(self) -> tuple[str, ...]:
        """All names that are assigned."""
        return tuple(name for pair in self.pairs for name in pair.names)

    @property
    def arrays(self) -> list[str]:
        """The arrays in which they, or their errors, are stored: sin_q1_to_q4, cos_q1_to_q4."""
        first, last = ("".join(_INDEXED.findall(angle)[-1]) for angle in (
            self.angles[0], self.angles[-1]))
        error = "_error" * bool(self.of)
        return [f"{x}{error}_{first}_to_{last}" for x in ("sin", "cos")]

    @property
    def angles(self) -> list[str]:
        """The texts of the angles."""
        return [pair.expression.partition(",")[0] for pair in self.pairs]

    def statements(self, precision: Precision, width: int) -> str:
        """The call, and declarations of the values that it stores in arrays."""
        real, arrays = precision.c_type, self.arrays
        angles = self.angles
        given = self.of.arrays if self.of else []
        call = listed(f"ksl_{TOGETHER[self.step.op]}_{len(angles)}{precision.called}(",
                      [*angles, *given, *arrays], ");", width)
        values = (f"{array}[{n}]" for n in range(len(angles)) for array in arrays)
        return "\n".join((
            f"{real} {', '.join(f'{x}[{LANES}]' for x in arrays)};", call,
            listed(f"const {real} ", [f"{name} = {value}" for name, value in zip(
                self.names, values, strict=True)], ";", width)))


def together(assigned: Sequence[Assignment | str], precision: Precision, apart: bool = False
             ) -> Sequence[Assignment | Together | str]:
    """Moves the sines and cosines of inputs, and their errors, to the front, several together; on
    vectors without the errors, and each `apart` if that is wanted.  Headings below which nothing is
    left are left out."""
    if precision.device:
        return assigned
    pairs = [x for x in assigned if isinstance(x, Assignment) and x.cosine]
    sines = [x for x in pairs if x.step.op is Op.SIN and isinstance(x.step.operands[0], Input)]
    most = 1 if apart else OF_STATES
    first = list(_of_states(sines, most) if precision.lanes else _grouped(sines, pairs))
    moved = {pair.step.name for x in first
             for pair in (x.pairs if isinstance(x, Together) else (x,))}
    rest = [x for x in assigned if isinstance(x, str) or x.step.name not in moved]
    return [*first, *without_empty_sections(rest)]


def without_empty_sections(assigned: Sequence[Assignment | Together | str]
                           ) -> list[Assignment | Together | str]:
    """Leaves out headings below which nothing is left."""
    return [x for x, following in pairwise((*assigned, ""))
            if not (isinstance(x, str) and isinstance(following, str))]


def _of_states(sines: Sequence[Assignment], most: int) -> Iterator[Assignment | Together]:
    """Calls of nearly as many each, and at most of so many."""
    calls = -(-len(sines) // most)
    for n in range(calls):
        share = sines[len(sines) * n // calls:len(sines) * (n + 1) // calls]
        yield Together(share) if len(share) > 1 else share[0]


def _grouped(sines: Sequence[Assignment], pairs: Sequence[Assignment]) -> Iterator[Together]:
    """Calls of as many sines and cosines as one call computes; after each that of their errors, if
    all of these are among the pairs."""
    errors = {x.step.operands[1]: x for x in pairs if x.step.op is Op.SIN_ERROR}
    for result in (sines[n:n + LANES] for n in range(0, len(sines), LANES)):
        if len(result) > 1:
            yield (group := Together(result))
            own = [errors[Ref(x.step.name)] for x in result if Ref(x.step.name) in errors]
            if len(own) == len(result):
                yield Together(own, group)


@dataclass(frozen=True)
class AngleArrays:
    """Sines and cosines of neighbouring elements of an argument, in two arrays with its indices:
    sin_q[3] is that of q[3]."""

    argument: str
    first: int
    count: int

    @property
    def names(self) -> tuple[str, str]:
        """The arrays."""
        return f"sin_{self.argument}", f"cos_{self.argument}"

    def hold(self, name: str) -> bool:
        """True if a name is that of an element."""
        return name.startswith(tuple(f"{x}[" for x in self.names))

    def statements(self, precision: Precision, access: Callable[[int], str]) -> Iterator[str]:
        """Declares and fills the arrays, four angles at a time."""
        whole, rest = divmod(self.count, LANES)
        last = self.first + whole * LANES
        size = last + LANES if rest > 1 else last + rest  # calls write four numbers
        yield f"{precision.c_type} {', '.join(f'{x}[{size}]' for x in self.names)};"
        if whole > 1:
            angles = ", ".join(access(self.first).replace(f"[{self.first}]", f"[i{more}]")
                               for more in ("", *(f" + {n}" for n in range(1, LANES))))
            into = ", ".join(f"&{x}[i]" for x in self.names)
            yield (f"{UNROLLED}\nfor (int i = {self.first}; i < {last}; i += {LANES}) {{\n"
                   f"  ksl_sincos_{LANES}{precision.called}({angles}, {into});\n}}")
        elif whole:
            yield self._call(self.first, LANES, precision, access)
        if rest:
            yield self._call(last, rest, precision, access)

    def _call(self, begin: int, count: int, precision: Precision, access: Callable[[int], str]
              ) -> str:
        sine, cosine = (f"{x}[{begin}]" for x in self.names)
        angles = ", ".join(access(begin + n) for n in range(count))
        if count == 1:
            return f"{sine} = ksl_sincos{precision.called}({angles}, &{cosine});"
        return f"ksl_sincos_{count}{precision.called}({angles}, &{sine}, &{cosine});"


def angle_arrays(program: Program) -> AngleArrays | None:
    """The arrays of a program's sines and cosines; None if these are not of several neighbouring
    elements of one argument, or if their errors are computed, too."""
    if any(step.op is Op.SIN_ERROR for step in program.instructions):
        return None
    places = sorted({(x.argument, x.index) for x in _angles(program)})
    if len(places) < 2 or len({argument for argument, _ in places}) > 1:
        return None
    (argument, first), (_, last) = places[0], places[-1]
    name = program.inputs[argument].name
    taken = {f"sin_{name}", f"cos_{name}"} & {step.name for step in program.instructions}
    if last - first >= len(places) or taken:
        return None
    return AngleArrays(name, first, len(places))


def _angles(program: Program) -> Iterator[Input]:
    """Elements of arguments whose sine and cosine are both computed."""
    for sine, _ in sine_cosine_pairs(program).values():
        x = sine.operands[0]
        if sine.op is Op.SIN and isinstance(x, Input) and program.inputs[x.argument].quantity.shape:
            yield x


def in_arrays(plan: NestingPlan, arrays: AngleArrays) -> NestingPlan:
    """The plan with elements of the arrays instead of names of sines and cosines."""
    names = {step.name: step.name for step in plan.program.instructions}
    for pair in sine_cosine_pairs(plan.program).values():
        x = pair[0].operands[0]
        if isinstance(x, Input) and plan.program.inputs[x.argument].name == arrays.argument:
            names |= {step.name: f"{array}[{x.index}]"
                      for step, array in zip(pair, arrays.names, strict=True)}
    return NestingPlan(renamed(plan.program, names), frozenset(names[x] for x in plan.assigned),
                       plan.constants)
