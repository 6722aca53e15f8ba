"""A scene's functions as a Python package in pure NumPy, which broadcasts over leading axes.

Components are read from the last axis as q[0], q[1], as in C; what is written in one is in the
other.
"""

from collections.abc import Iterator, Sequence
from functools import partial
from textwrap import wrap

from coscrew_codegen.formats import Precision, named
from coscrew_codegen.integrators import STEPS
from coscrew_codegen.program import NotANumber
from coscrew_codegen.quantity import Argument
from coscrew_codegen.render import render
from coscrew_codegen.scene_functions import Function, SceneFunctions
from coscrew_codegen.targets import scene_text
from coscrew_codegen.targets.c_statements import WIDTH, listed
from coscrew_codegen.targets.numpy import NUMPY_NAMES
from coscrew_codegen.targets.scene_expressions import Expressions
from coscrew_codegen.targets.scene_text import INTEGRATED, RATE, function_named
from coscrew_codegen.version import VERSION


def package(scene: SceneFunctions, banner: str) -> dict[str, str]:
    """The package's files by name."""
    about = [row for line in scene_text.order_in_words(scene)
             for row in wrap(_quoted(line), WIDTH, subsequent_indent="    ")]
    head = render(
        "scene/package.py", banner=banner, name=scene.name, about=about, version=VERSION,
        nq=scene.nq,
        nv=scene.nv, precisions=scene.precisions,
        tables=[_tuple("JOINTS", [x.joint for x in scene.coordinates]),
                _tuple("BODIES", scene.bodies), _dictionary("PARAMETERS", scene.parameters),
                _tuple("NEUTRAL_Q", scene.neutral)])
    files = {"__init__.py": head, "_arrays.py": render("scene/arrays.py", banner=banner)}
    return files | {f"{p.name}.py": _module(scene, banner, p) for p in named(scene.precisions)}


def _tuple(name: str, values: Sequence[object]) -> str:
    return listed(f"{name} = (", list(map(repr, values)), ",)" if len(values) == 1 else ")")


def _dictionary(name: str, entries: Sequence[tuple[str, float]]) -> str:
    return listed(f"{name} = {{", [f"{key!r}: {value!r}" for key, value in entries], "}")


def _module(scene: SceneFunctions, banner: str, precision: Precision) -> str:
    functions = scene.functions
    called = {op for f in functions for op in f.program.counts} & set(NUMPY_NAMES)
    names = {NUMPY_NAMES[op] for op in called} | {"errstate", precision.numpy_type}
    if any(NotANumber() in x.operands for f in functions for x in f.program.instructions):
        names.add("nan")
    if scene.steps:
        names |= {"newaxis", "zeros_like"}
    if any(f.name == scene_text.PARTS for f in scene.functions):
        names |= {"broadcast_to", "ones_like", "where"}
    return render("scene/precision.py", banner=banner, name=scene.name, precision=precision,
                  imports=listed("from numpy import (", sorted(names), ")"),
                  helpers="components, assembled, delivered"
                  f"{', arrays, spread' if scene.steps else ''}",
                  functions=[*(_function(f, precision) for f in functions),
                             *(_step(scene, name, precision) for name in scene.steps)])


def _quoted(text: str) -> str:
    """The text as a docstring holds it."""
    return scene_text.printable(text).replace("\\", "\\\\").replace('"""', '\\"\\"\\"')


def _docstring(paragraphs: Sequence[str]) -> str:
    first, *rest = ("\n    ".join(wrap(_quoted(text), WIDTH - 8)) for text in paragraphs)
    return "\n".join((first, "", *(f"    {text}" for text in rest)))


def _shape(argument: Argument) -> str:
    """(), (6,), (6, 6): the shape behind leading axes, of what no function takes as a matrix."""
    return repr(tuple(argument.quantity.shape))


def _unpacking(helper: str, arguments: Sequence[tuple[str, str]], precision: Precision) -> str:
    """The statement that checks and casts arguments, given as names and shapes."""
    names = ", ".join(name for name, _ in arguments) + ("," if len(arguments) == 1 else "")
    items = [precision.numpy_type, *(f"{name}=({name}, {shape})" for name, shape in arguments)]
    return listed(f"lead, ({names}) = {helper}(", items, ")", WIDTH - 4)


def _function(function: Function, precision: Precision) -> dict[str, str]:
    program, outputs = function.program, scene_text.outputs(function)
    expressions = Expressions(function, precision)
    lines = [_unpacking("components", [(a.name, _shape(a)) for a in program.inputs], precision),
             *expressions.lines]
    made = list(_assembled(outputs, expressions.results, precision))
    lines.append(f"return delivered(out, {made[0]})" if len(made) == 1 else
                 listed("return delivered(", ["out", *made], ")"))
    return _text(_name(function), [a.name for a in program.inputs], scene_text.words(function),
                 lines)


def _assembled(outputs: Sequence[Argument], results: Sequence[str],
               precision: Precision) -> Iterator[str]:
    """For each output the array of its components."""
    start = 0
    for output in outputs:
        parts = results[start:start + scene_text.size(output)]
        start += len(parts)
        head = f"assembled({precision.numpy_type}, lead, {_shape(output)}, ("
        yield listed(head, parts, ",))" if len(parts) == 1 else "))", WIDTH - 28)


def _text(name: str, arguments: Sequence[str], words: Sequence[str],
          lines: Sequence[str]) -> dict[str, str]:
    body = "\n".join(f"    {row}" for line in lines for row in line.split("\n"))
    return {"name": name, "arguments": ", ".join(arguments), "docstring": _docstring(words),
            "body": body}


def _step(scene: SceneFunctions, name: str, precision: Precision) -> dict[str, str]:
    step, inputs = STEPS[name], scene_text.step_inputs(scene)
    shapes = scene_text.step_shapes(scene)
    accelerated = function_named(scene, step.calls)
    body = render(
        f"scene/{step.template}.py", timed=scene_text.takes(accelerated, "t"),
        pushed=scene_text.takes(accelerated, "tau"), accelerate=partial(_call, accelerated),
        integrate=lambda **values: _call(function_named(scene, INTEGRATED), **values),
        rate=partial(_rate, scene),
        **scene_text.step_calls(scene, _call))
    lines = [_unpacking("arrays", [(x, str(shapes[x])) for x in inputs], precision),
             "q, v = spread(lead, q, v)", *body.rstrip("\n").split("\n")]
    return _text(f"step_{name}", inputs, scene_text.step_words(scene, name), lines)


def _name(function: Function) -> str:
    return f"_{function.name}" if function.internal else function.name


def _call(function: Function, **values: str) -> str:
    """A call of the function, with expressions for inputs, which else go by their own names."""
    arguments = [values.get(a.name, a.name) for a in function.program.inputs]
    return f"{_name(function)}({', '.join(arguments)})"


def _rate(scene: SceneFunctions, **values: str) -> str:
    """φ' for the speeds v; without quaternions that is v."""
    found = next((f for f in scene.functions if f.name == RATE), None)
    return values["v"] if found is None else _call(found, **values)
