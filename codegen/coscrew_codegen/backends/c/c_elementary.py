"""The elementary functions in C: for the library, and for scenes, which contain those that they
call."""

import re
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, replace

from coscrew_codegen.backends.c import c_lanes, c_several_of_states
from coscrew_codegen.backends.c.c_function import FunctionBody, Stored
from coscrew_codegen.backends.c.c_lanes import SEVERAL
from coscrew_codegen.backends.c.c_nested import language
from coscrew_codegen.backends.c.c_statements import WIDTH, comment_of, listed
from coscrew_codegen.backends.c.tables import two_over_pi_table
from coscrew_codegen.backends.nesting import planned
from coscrew_codegen.program import Constant, Input, Op, Program, renamed
from coscrew_codegen.program.elementary import ELEMENTARY, ERRORS, Elementary
from coscrew_codegen.program.program import in_words
from coscrew_codegen.program.values.formats import BY_NAME, DOUBLE, Precision
from coscrew_codegen.program.values.quantity import Argument
from coscrew_codegen.program.whole_cost import counts_of

_VALUE_WIDTH = 150
_BEFORE = len("static KSL_INLINED  {")  # and behind the head of a function

HEADER = "elementary"
"""The header, and the family, that holds them all."""
ERROR_HEADER = "ksl_elementary_error"
"""The header of their error functions."""
ALONE = {"sin": "sincos", "cos": "sincos", "sin_error": "sincos_error", "cos_error": "sincos_error"}
"""Results that have functions of their own, with these functions."""
_OWNER = {**ALONE, **{x: name for name, several in SEVERAL.items() for x in several}}
CALLABLE = {group: (*(name for name, of in ALONE.items() if of in {x.name for x in functions}),
                    *(x.name for x in functions))
            for group, functions in ((HEADER, ELEMENTARY), (ERROR_HEADER, ERRORS))}
"""The names that each header defines."""
_NAMES = [name for names in (*SEVERAL.values(), *CALLABLE.values()) for name in names]
_CALL = re.compile(rf"\bksl_({'|'.join(_NAMES)})(?:_lanes|_device)?f?\(")


@dataclass(frozen=True)
class ElementaryText:
    """An elementary function in a precision, as data for templates."""

    name: str  # exp, sincos
    comment: str
    head: str
    body: str
    near: Sequence[str] = ()  # head and body of the reductions of angles
    far: Sequence[str] = ()
    reduced: Sequence[str] = ()  # the names of their results
    limit: str = ""
    table: str = ""  # what `far` reads
    inlined: bool = False
    power: bool = False  # whether it is the first to call ksl_power
    alone: Collection[str] = ()  # those of its results that have a function of their own
    several: str = ""  # functions that compute it for several arguments


def called(texts: Iterable[str]) -> frozenset[str]:
    """The names of the functions that these texts call: sincos, sin, exp."""
    return frozenset(name for text in texts for name in _CALL.findall(text))


def shared(several: Iterable[Collection[str]]) -> frozenset[str]:
    """The names whose definitions all these texts need."""
    sets = [{name: _OWNER.get(name, name) for name in names} for names in several]
    needed = frozenset.intersection(*(frozenset(owners.values()) for owners in sets))
    return frozenset(name for owners in sets for name, owner in owners.items() if owner in needed)


def written(precision: Precision, names: Collection[str],
            nested: bool = False) -> list[ElementaryText]:
    """Returns the definitions of these names."""
    needed = {_OWNER.get(name, name) for name in names}
    wanted = [x for x in (*ELEMENTARY, *ERRORS) if x.name in needed]
    powers = [x for x in wanted if Op.POWER in x.kernel(BY_NAME[precision.name]).counts]
    return [replace(_written(x, precision, nested), power=x in powers[:1],
                    alone=[name for name in ALONE if name in names and _OWNER[name] == x.name],
                    several=_several(x, precision, names)) for x in wanted]


def _several(function: Elementary, precision: Precision, names: Collection[str]) -> str:
    wanted = [n for name, n in SEVERAL.get(function.name, {}).items() if name in names]
    if precision.lanes:
        return "".join(c_several_of_states.written(function, precision, n) for n in wanted)
    return c_lanes.written(function, precision, wanted) if wanted else ""


def _written(function: Elementary, precision: Precision, nested: bool) -> ElementaryText:
    numbers = BY_NAME[precision.name]  # the precision, without vectors
    kernel = function.kernel(numbers)
    comment = comment_of([f"{function.statement}.", function.comment(numbers),
                          f"{_cost(function, numbers).capitalize()}."])
    head, body = _function(f"ksl_{function.name}", function.inputs, function.outputs, kernel,
                           precision, nested)
    if not (function.near and function.far and function.limit):
        return ElementaryText(function.name, comment, head, body)
    limit = function.limit(numbers)
    near, far = function.near(numbers), function.far(numbers)
    reductions = {place: _function(f"ksl_{function.name}_{place}", program.inputs, program.outputs,
                                   program, precision, nested)
                  for place, program in (("near", near), ("far", far))}
    return ElementaryText(function.name, comment, head, body, reductions["near"], reductions["far"],
                          [a.name for a in near.outputs],
                          precision.literal(Constant(limit, limit)) + precision.suffix,
                          two_over_pi_table.in_c(numbers), function in ELEMENTARY)


def _cost(function: Elementary, precision: Precision) -> str:
    reduced = "; beyond the limit, more" if function.near else ""
    return in_words(counts_of(function, precision)) + reduced


def _function(name: str, inputs: Sequence[Argument], outputs: Sequence[Argument], program: Program,
              precision: Precision, nested: bool) -> tuple[str, str]:
    """Head and body; the first output is returned, others are pointers."""
    first, *others = outputs
    taken = {a.name for a in outputs}
    program = renamed(program, {step.name: f"{step.name}_value" if step.name in taken
                                else step.name for step in program.instructions})
    head = listed(f"{precision.c_type} {name}{precision.called}(",
                  [*(f"const {precision.c_type} {a.name}" for a in inputs),
                   *(f"{precision.c_type} *{a.name}" for a in others)], ")",
                  WIDTH - (_BEFORE if nested else 16))

    def access(x: Input) -> str:
        return program.inputs[x.argument].name

    stored = Stored(access, [first.name, *(f"*{a.name}" for a in others)], taken, first.name)
    plan = planned(program, language(program, DOUBLE), access, _VALUE_WIDTH) if nested else None
    used = plan.program if plan else program
    return head, FunctionBody(used, precision, stored, plan).text()
