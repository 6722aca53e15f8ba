"""A scene's functions as a Python package in pure NumPy, which broadcasts over leading axes.

Components are read from the last axis as q[0], q[1], as in C; what is written in one is in the
other.
"""

import re
from collections.abc import Iterator, Sequence
from textwrap import wrap

from coscrew_codegen.accuracy.scene_tiers import SceneTier
from coscrew_codegen.algebra.recording.gc_pause import uncollected
from coscrew_codegen.backends.c.c_statements import WIDTH, listed
from coscrew_codegen.backends.nesting import NestingPlan
from coscrew_codegen.backends.numpy import numpy_elementary, numpy_tables
from coscrew_codegen.backends.numpy.numpy_operations import (
    EXACT,
    NUMPY_NAMES,
    exactly_in,
    language,
    statement,
)
from coscrew_codegen.backends.numpy.scene_python_steps import python_name, step_lines
from coscrew_codegen.backends.render import render
from coscrew_codegen.backends.scene import scene_text
from coscrew_codegen.backends.target import Files, Target
from coscrew_codegen.backends.version import VERSION
from coscrew_codegen.program import NotANumber
from coscrew_codegen.program.elementary.elementary_calls import called
from coscrew_codegen.program.scene_functions import (
    FunctionProgram,
    IntegratorStep,
    SceneFunctions,
    Split,
)
from coscrew_codegen.program.values.formats import Precision, named
from coscrew_codegen.program.values.quantity import Argument

_SIGNS = "# Of parameters with a sign: index in p, name, whether it may be zero."
_ELEMENTARY = re.compile(r"\b((?:sincos|sin|cos|exp|tanh|atan2)(?:_error)?)\(")


@uncollected()
def files(scene: SceneFunctions, banner: str) -> Files:
    """The package arm/.  Raises ValueError for names that cannot be used in Python."""
    scene_text.check_names(scene)
    about = [row for line in scene_text.order_in_words(scene)
             for row in wrap(_quoted(line), WIDTH, subsequent_indent="    ")]
    signs = scene_text.signs(scene)
    head = render(
        "scene/package.py", banner=banner, name=scene.name, about=about, version=VERSION,
        nq=scene.nq, nv=scene.nv, precisions=scene.precisions,
        modules=(*scene.precisions, *scene.tiers),
        tables=[_tuple("JOINTS", [x.joint for x in scene.coordinates]),
                _tuple("BODIES", scene.bodies), _dictionary("PARAMETERS", scene.parameters),
                _tuple("NEUTRAL_Q", scene.neutral),
                *([_SIGNS, _tuple("SIGNS", signs)] if signs else [])])
    plans = scene_text.plans(scene)
    modules = {"__init__": head, "_arrays": render("scene/arrays.py", banner=banner),
               **{p.name: _module(scene, plans, banner, p) for p in named(scene.precisions)},
               **_shared(scene.functions, named(scene.precisions), banner)}
    return {f"{scene.name}/{name}.py": text for name, text in modules.items()}


@uncollected()
def tier_files(made: SceneTier, banner: str) -> Files:
    """The package arm/accurate/."""
    functions = [f for _, scene in made.in_precisions for f in scene.functions]
    working = named({scene_text.working([f.program for f in scene.functions], p).name
                     for p, scene in made.in_precisions})
    modules = {
        "__init__": render("scene/tier.py", banner=banner, name=made.plain.name,
                           tier=made.tier.name,
                           about="\n\n".join(filter(None, (made.tier.title, made.tier.promise))),
                           precisions=made.plain.precisions),
        **{p.name: _module(scene, scene_text.plans(scene), banner, p)
           for p, scene in made.in_precisions},
        **_shared(functions, working, banner)}
    if any(f.program.wide or op in f.program.counts for f in functions for op in EXACT):
        modules["_exact"] = render("scene/exact.py", banner=banner)
    return {f"{made.plain.name}/{made.tier.mark}/{name}.py": text
            for name, text in modules.items()}


def _shared(functions: Sequence[FunctionProgram], precisions: Sequence[Precision], banner: str
            ) -> Files:
    """The modules of the elementary functions that these functions call, and of their tables."""
    programs = [f.program for f in functions]
    names, tables = called(programs), numpy_tables.names(programs)
    return {f"_elementary_{p.name}": numpy_elementary.module(p, names, banner)
            for p in precisions if names} | {
        f"_tables_{p.name}": numpy_tables.module(programs, p, banner)
        for p in precisions if tables}


def _tuple(name: str, values: Sequence[object]) -> str:
    return listed(f"{name} = (", list(map(repr, values)), ",)" if len(values) == 1 else ")")


def _dictionary(name: str, entries: Sequence[tuple[str, float]]) -> str:
    return listed(f"{name} = {{", [f"{key!r}: {value!r}" for key, value in entries], "}")


def _module(scene: SceneFunctions, plans: Sequence[NestingPlan], banner: str, precision: Precision
            ) -> str:
    functions = scene.functions
    working = scene_text.working([f.program for f in functions], precision)
    counted = {op for f in functions for op in f.program.counts}
    names = {NUMPY_NAMES[op] for op in counted & set(NUMPY_NAMES)}
    names |= {"errstate", precision.numpy_type, working.numpy_type}
    if any(isinstance(x, NotANumber) for f in functions for step in f.program.instructions
           for x in step.operands):
        names.add("nan")
    names |= {"zeros_like"} if any(step.zeros for step in scene.steps) else set()
    splits = [x for step in scene.steps for x in step.body if isinstance(x, Split)]
    names |= {"ones_like"} if any(x.test for x in splits) else set()
    helpers = ["components", "assembled", "delivered",
               *(["arrays", "spread"] if scene.steps else []),
               *(["rounds", "merged"] if splits else [])]
    made = [*(_function(scene, f, plan, precision)
              for f, plan in zip(functions, plans, strict=True)),
            *(_step(scene, step, precision) for step in scene.steps)]
    elementary = sorted({name for x in made for name in _ELEMENTARY.findall(x["body"])})
    legend = scene_text.legend(plans, [x["body"] for x in made])
    exact = sorted({name for op, name in exactly_in(working).items() if op in counted})
    exact += ["widened"] if working != precision else []
    return render("scene/precision.py", banner=banner, name=scene.name, precision=precision,
                  title=f"{scene.name} in {precision.name} precision"
                        f"{scene.mark and f', {scene.mark} tier'}.",
                  parent=".." if scene.mark else ".", working=working,
                  plain=any(f.computed for f in functions), exact=", ".join(exact),
                  signs=bool(scene.signs),
                  names=[row for words in legend
                         for row in wrap(words, WIDTH, subsequent_indent="    ")],
                  imports=listed("from numpy import (", sorted(names), ")"),
                  helpers=", ".join(helpers), elementary=", ".join(elementary),
                  tables=", ".join(numpy_tables.names(f.program for f in functions)),
                  functions=made)


def _quoted(text: str) -> str:
    """The text escaped for a docstring."""
    return scene_text.printable(text).replace("\\", "\\\\").replace('"""', '\\"\\"\\"')


def _docstring(paragraphs: Sequence[str]) -> str:
    first, *rest = ("\n    ".join(wrap(_quoted(text), WIDTH - 8)) for text in paragraphs)
    return "\n".join((first, "", *(f"    {text}" for text in rest)))


def _shape(argument: Argument) -> str:
    """(), (6,), (6, 6): the shape after leading axes."""
    return repr(tuple(argument.quantity.shape))


def _unpacking(helper: str, arguments: Sequence[tuple[str, str]], precision: Precision,
               signed: bool) -> str:
    """The statement that checks and casts arguments, given as names and shapes; if `signed`, also
    the signs of p."""
    names = ", ".join(name for name, _ in arguments) + ("," if len(arguments) == 1 else "")
    items = [precision.numpy_type, *(
        f"{name}=({name}, {shape}{', SIGNS' if signed and name == 'p' else ''})"
        for name, shape in arguments)]
    return listed(f"lead, ({names}) = {helper}(", items, ")", WIDTH - 4)


def _function(scene: SceneFunctions, function: FunctionProgram, plan: NestingPlan,
              precision: Precision
              ) -> dict[str, str]:
    program, outputs = plan.program, scene_text.outputs(function)
    headings = {number: scene_text.printable(words) for number, words in function.headings}
    working = scene_text.working([program], precision)
    expressions = plan.printed(language(working.numpy_type, working.literal),
                               scene_text.access(program), headings)
    given, taken = [a.name for a in function.inputs], [a.name for a in program.inputs]
    lines = [*_plain_results(function),
             _unpacking("components", [(a.name, _shape(a)) for a in program.inputs],
                        precision, bool(scene.signs) and not function.internal),
             *([_widened(taken)] if program.wide and taken else []),
             *map(statement, expressions.assigned)]
    made = list(_assembled(outputs, expressions.results, precision))
    lines.append(f"return delivered(out, {made[0]})" if len(made) == 1 else
                 listed("return delivered(", ["out", *made], ")", WIDTH - 4))
    return _text(python_name(function), given, scene_text.words(function), lines)


def _plain_results(function: FunctionProgram) -> Iterator[str]:
    """The statement that computes what the program takes of the plain function."""
    if function.computed:
        names = ", ".join(a.name for a in function.computed)
        yield f"{names} = plain.{function.name}({', '.join(a.name for a in function.inputs)})"


def _widened(names: Sequence[str]) -> str:
    """The statement that converts components to double."""
    pairs = [", ".join(names), f"widened({', '.join(names)})"]
    return f"{pairs[0]}{',' if len(names) == 1 else ''} = {pairs[1]}"


def _assembled(outputs: Sequence[Argument], results: Sequence[str],
               precision: Precision) -> Iterator[str]:
    """Yields for each output the expression for the array of its components."""
    start = 0
    for output in outputs:
        parts = results[start:start + scene_text.size(output)]
        start += len(parts)
        head = f"assembled({precision.numpy_type}, lead, {_shape(output)}, ("
        yield listed(head, parts, ",))" if len(parts) == 1 else "))", WIDTH - 28)


def _text(name: str, arguments: Sequence[str], words: Sequence[str],
          lines: Sequence[str]) -> dict[str, str]:
    body = "\n".join(f"    {row}" for line in lines for row in line.split("\n"))
    return {"name": name, "arguments": ", ".join((*arguments, "*", "out=None")),
            "docstring": _docstring(words), "body": body}


def _step(scene: SceneFunctions, step: IntegratorStep, precision: Precision) -> dict[str, str]:
    inputs = scene_text.step_inputs(scene, step.takes_tau)
    shapes = scene_text.step_shapes(scene)
    lines = [_unpacking("arrays", [(x, str(shapes[x])) for x in inputs], precision,
                        bool(scene.signs)),
             "q, v = spread(lead, q, v)", *step_lines(scene, step)]
    return _text(step.name, inputs, scene_text.step_words(scene, step), lines)


TARGET = Target("scene in Python", ("python",), scene=files, tier=tier_files)
