"""Text about a scene's functions that all languages share: order of coordinates, steps, names.

Knows functions and words; nothing of how a language writes statements.
"""

import keyword
import re
from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from math import prod

from coscrew_codegen.backends.c.c_nested import language
from coscrew_codegen.backends.nesting import NestingPlan, planned
from coscrew_codegen.backends.scene import scene_symbols
from coscrew_codegen.program import Constant, Input, Program, counts_in_words
from coscrew_codegen.program.kept_results import kept_with
from coscrew_codegen.program.scene_functions import (
    FunctionProgram,
    IntegratorStep,
    SceneFunctions,
    SceneInterface,
)
from coscrew_codegen.program.scene_functions import (
    c_name as c_name,
)
from coscrew_codegen.program.scene_functions import (
    many as many,
)
from coscrew_codegen.program.scene_functions import (
    marked as marked,
)
from coscrew_codegen.program.scene_functions import (
    signs as signs,
)
from coscrew_codegen.program.values.formats import DOUBLE, Precision
from coscrew_codegen.program.values.quantity import Argument
from coscrew_codegen.scene.joints import KINDS

_C = """auto break case char const continue default do double else enum extern float for goto if
inline int long register restrict return short signed sizeof static struct switch typedef union
unsigned void volatile while"""
_CPP = """alignas alignof and and_eq asm bitand bitor bool catch char16_t char32_t char8_t class
compl concept const_cast consteval constexpr constinit co_await co_return co_yield decltype delete
dynamic_cast explicit export false friend mutable namespace new noexcept not not_eq nullptr operator
or or_eq private protected public reinterpret_cast requires static_assert static_cast template this
thread_local throw true try typeid typename using virtual wchar_t xor xor_eq linux unix"""
_CALLED = """fabs sqrt sin cos atan2 exp tanh fma fabsf sqrtf sinf cosf atan2f expf tanhf fmaf
memcpy NAN absolute arctan2 where nan float32 float64 np errstate array zeros_like ones_like
lead out high_product rounded_shift sincos SIGNS arrays assembled components delivered merged
rounds spread"""
RESERVED = frozenset((*_C.split(), *_CPP.split(), *_CALLED.split(), *keyword.kwlist))
"""Names that no instruction may have: keywords of C, C++ and Python, and called functions."""

_NAME = re.compile("[A-Za-z][A-Za-z0-9_]*")


def count(shape: tuple[int, ...]) -> int:
    """Returns how many numbers an array of this shape has."""
    return prod(shape)


def size(argument: Argument) -> int:
    """Returns how many numbers an argument has."""
    return prod(argument.quantity.shape)


def rows(arguments: Sequence[Argument]) -> dict[str, int]:
    """The number of components in a row of each argument."""
    return {a.name: a.quantity.shape[-1] for a in arguments if a.quantity.shape}


def outputs(function: FunctionProgram) -> tuple[Argument, ...]:
    """The outputs; those with an input's name get the suffix o: q → qo."""
    taken = {a.name for a in function.program.inputs}
    return tuple(Argument(f"{a.name}o", a.quantity) if a.name in taken else a
                 for a in function.program.outputs)


def step_inputs(scene: SceneFunctions | SceneInterface, takes_tau: bool = False
                ) -> tuple[str, ...]:
    """The inputs of a step: t if forces depend on it, h, p if there are parameters, q, v, tau."""
    return (*(["t"] if scene.timed else []), "h", *(["p"] if scene.parameters else []), "q", "v",
            *(["tau"] if takes_tau else []))


def step_shapes(scene: SceneFunctions) -> dict[str, tuple[int, ...]]:
    """The shapes of a step's inputs."""
    return {"t": (), "h": (), "p": (len(scene.parameters),), "q": (scene.nq,), "v": (scene.nv,),
            "tau": (scene.nv,)}


def step_words(scene: SceneFunctions, step: IntegratorStep) -> tuple[str, ...]:
    """A step's documentation in Python, a paragraph each."""
    shapes = step_shapes(scene)
    given = ", ".join(f"{x} {shapes[x]}" for x in step_inputs(scene, step.takes_tau))
    return (f"{step.words}.  Returns q and v.",
            f"Last axes: {given} -> q {shapes['q']}, v {shapes['v']}.")


def words(function: FunctionProgram, costs: bool = True) -> tuple[str, ...]:
    """A function's documentation in Python, a paragraph each; the last what it costs."""
    given, made = (" ".join(["", ", ".join(f"{a.name} {tuple(a.quantity.shape)}" for a in side)])
                   for side in (function.inputs, outputs(function)))
    return (sentence(function.words), f"Last axes:{given.rstrip()} ->{made}.",
            *filter(None, [function.rounding]), *([cost(function)] if costs else []))


def banner_of(name: str, command: str = "") -> str:
    """The first line of a scene's files, as a comment's text; `command` makes them."""
    made = printable(command or f"coscrew generate {name}.toml")
    return f"Made by `{made}`; changes are overwritten."


def check_names(scene: SceneFunctions) -> None:
    """Raise ValueError for names that are not valid variables or occur twice in a function, and for
    scene names that C and Python cannot use."""
    name = scene.name
    if not (name.isascii() and name.isidentifier()) or keyword.iskeyword(name):
        raise ValueError(f"scene {name!r}: a name that C and Python can import is wanted")
    for function in scene.functions:
        _check(function)


def _check(function: FunctionProgram) -> None:
    program = function.program
    arguments = {a.name for a in (*program.inputs, *outputs(function))}
    seen = set(arguments)
    for name in (function.name, *arguments, *(step.name for step in program.instructions)):
        if not _NAME.fullmatch(name) or name in RESERVED:
            raise ValueError(f"{function.name}: {name!r} cannot be a name in C and Python")
    for step in program.instructions:
        if step.name in seen:
            raise ValueError(f"{function.name}: the name {step.name!r} is given twice")
        seen.add(step.name)


VALUE_WIDTH = 150
"""Characters of a value in double precision, at most: two lines."""


def plans(scene: SceneFunctions) -> list[NestingPlan]:
    """Plans the assignments of each function: the same in all languages and precisions."""
    return [_planned(f.program) for f in scene.functions]


@kept_with
def _planned(program: Program) -> NestingPlan:
    return planned(program, language(program, DOUBLE), access(program), VALUE_WIDTH)


def access(program: Program) -> Callable[[Input], str]:
    """The text with which a function reads an input: q[1], t."""
    def written(operand: Input) -> str:
        argument = program.inputs[operand.argument]
        return f"{argument.name}[{operand.index}]" if argument.quantity.shape else argument.name
    return written


def working(programs: Iterable[Program], precision: Precision) -> Precision:
    """The precision in which functions of this precision compute."""
    return precision.computing(any(program.wide for program in programs))


def legend(plans: Sequence[NestingPlan], bodies: Sequence[str]) -> tuple[str, ...]:
    """Paragraphs that explain the names in these bodies of functions."""
    written = {word for body in bodies for word in re.findall(r"\w+", body)}
    return scene_symbols.legend(sorted(written.intersection(
        name for plan in plans for name in (*plan.assigned, *plan.constants))))


def literal(value: float, precision: Precision) -> str:
    """The shortest decimal that rounds to the value in this precision."""
    return precision.literal(Constant(Fraction(value), Fraction(value)))


def printable(text: str) -> str:
    """The text for comments: it neither ends nor opens one, and holds no control characters."""
    clean = "".join(c if c.isprintable() else " " for c in text)
    return clean.replace("*/", "* /").replace("/*", "/ *").replace("??", "? ?")


def sentence(words: str) -> str:
    """The words with one full stop."""
    return words.rstrip(". ") + "."


def cost(function: FunctionProgram) -> str:
    """'24 mul, 18 add.'"""
    plain = ", and the plain function" if function.plain else ""
    return f"{counts_in_words(function.program).capitalize()}{plain}."


def order_in_words(scene: SceneFunctions) -> list[str]:
    """Order of q and v joint by joint, units by kind of joint, bodies, parameters: paragraphs."""
    rows = [(_places("q", x.q), _places("v", x.v), x.kind, printable(x.joint))
            for x in scene.coordinates]
    widths = [max(len(row[i]) for row in rows) for i in range(3)] if rows else []
    table = ["  " + "  ".join((*map(str.ljust, row[:3], widths), row[3])) for row in rows]
    kinds = [f"  {kind.name}: {kind.state_in_words}." for kind in KINDS
             if any(x.kind == kind.name for x in scene.coordinates)]
    bodies = ", ".join(f"{n} {printable(name)}" for n, name in enumerate(scene.bodies))
    rules = {name: f" ({sign.rule})" for name, sign in scene.signs}
    parameters = ", ".join(f"{n} {printable(name)} = {value!r}{rules.get(name, '')}"
                           for n, (name, value) in enumerate(scene.parameters))
    return ["Coordinates q and velocities v, joint by joint:", *table, *kinds,
            *_states_in_words(scene),
            *([f"Bodies, in the order of body_poses: {bodies}."] if bodies else []),
            *([f"Parameters p: {parameters}."] if parameters else [])]


def _states_in_words(scene: SceneFunctions) -> list[str]:
    """The end of q: states of effects, with their units."""
    first = scene.nq - len(scene.states)
    listed = ", ".join(f"q {first + n} {printable(name)} in {unit}"
                       for n, (name, unit) in enumerate(scene.states))
    return [f"States of effects, at the end of q: {listed}."] if listed else []


def _places(name: str, places: range) -> str:
    last = f"-{places.stop - 1}" if len(places) > 1 else ""
    return f"{name} {places.start}{last}"
