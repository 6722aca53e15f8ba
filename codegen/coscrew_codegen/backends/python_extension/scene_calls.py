"""The C between Python and a scene's functions: callables that take arrays, of one state or many.

`new_…` makes a Python function in C from a tuple, whose items templates/runtime/calls/objects.h
names.  The function calls the first of these with its arguments unless it can take them.  `many_…`
takes n states: a pointer to each input and the numbers from one row to the next (0: all share one
row), and likewise each output; it shares them among threads, which call `lanes_…`, the function of
many states, where that has been set.  `run_…` takes n steps of h in a row, from the time t on, and
`finer_…`, where steps may be split, in parts as short as those of a longer step; `drive_double`
takes them of many states, and calls a controller in between.  All work in Python without its
headers.
"""

from collections.abc import Collection, Iterable, Iterator
from dataclasses import replace

from coscrew_codegen.accuracy.scene_tiers import SceneTier
from coscrew_codegen.backends.render import render, runtime
from coscrew_codegen.backends.scene import scene_text
from coscrew_codegen.backends.scene.scene_c_steps import begun
from coscrew_codegen.backends.scene.scene_text import c_name
from coscrew_codegen.backends.target import Files, Target
from coscrew_codegen.program.scene_functions import (
    SceneFunctions,
    SceneInterface,
    Signature,
    Split,
)
from coscrew_codegen.program.values.formats import SINGLE, Precision, named

BINDING = "calls/binding.c"
"""The calls of functions of any scene, as calls/function.h describes them."""

# Times and step lengths are rounded from double, as when steps are called one by one.
_RUN = {"t": "({real})begun(t, h, (double)k)", "h": "({real})h"}


def interface(scene: SceneFunctions) -> SceneInterface:
    """The interface of the scene for its callers."""
    return SceneInterface(scene.name, scene.nq, scene.nv, scene.coordinates, scene.bodies,
                      scene.parameters, scene.neutral, scene.precisions, scene.timed,
                      callables(scene), scene.signs, scene.tiers, scene.mark, scene.states)


def tier_interface(made: SceneTier) -> SceneInterface:
    """The interface of the scene's functions in a tier."""
    return replace(interface(made.first), precisions=made.plain.precisions)


def callables(scene: SceneFunctions) -> tuple[Signature, ...]:
    """All public functions, steps last."""
    signatures = [Signature(f.name, tuple((a.name, tuple(a.quantity.shape)) for a in f.inputs),
                  tuple((a.name, tuple(a.quantity.shape)) for a in scene_text.outputs(f)),
                  scene_text.words(f, not scene.mark), zero=f.program.zero)
                  for f in scene.functions if not f.internal]
    shapes = scene_text.step_shapes(scene)
    for step in scene.steps:
        inputs = tuple((x, shapes[x]) for x in scene_text.step_inputs(scene, step.takes_tau))
        signatures.append(Signature(step.name, inputs, (("q", shapes["q"]), ("v", shapes["v"])),
                          scene_text.step_words(scene, step), moved=True))
    return tuple(signatures)


def files(scene: SceneFunctions, banner: str) -> Files:
    """arm_calls.c, which is compiled with arm.c for Python and has no banner, and the headers that
    it includes."""
    return {f"{scene.name}_calls.c": source(scene), **_binding()}


def tier_files(made: SceneTier, banner: str) -> Files:
    """arm_accurate_calls.c, in the same way."""
    return {f"{made.stem}_calls.c": _source(made.first, made.stem, made.plain.precisions),
            **_binding()}


def _binding() -> Files:
    """The text that is the same for all scenes."""
    return {**runtime("runtime/calls/*.c"), **runtime("runtime/calls/*.h")}


def binding_units(precisions: Iterable[Precision]) -> dict[str, tuple[str, ...]]:
    """The binding's objects: source and flags of each."""
    return {f"calls_{p.name}": (BINDING, f"-DSINGLE_PRECISION={int(p is SINGLE)}")
            for p in precisions}


def source(scene: SceneFunctions) -> str:
    """The text of the file that is compiled for Python."""
    return _source(scene, scene.name, scene.precisions)


def _source(scene: SceneFunctions, stem: str, precisions: Collection[str]) -> str:
    signatures = callables(scene)
    driven = bool(scene.steps and scene.parameters)
    state = {"STATE_Q": scene.nq, "STATE_V": scene.nv, "STATE_P": len(scene.parameters)}
    splits = any(isinstance(x, Split) for step in scene.steps for x in step.body)
    sections = [{"precision": p, "single": int(p is SINGLE), **_lanes_of_runs(scene, p),
                 "binding": "finer" if splits else "function",
                 "functions": [_function(scene, f, p) for f in signatures]}
                for p in named(precisions)]
    return render("scene/calls.c", name=stem, upper=scene.name.upper(), sections=sections,
                  sizes=state if driven else {}, driven=driven,
                  begun=begun() if driven or (scene.timed and scene.steps) else "")


def _lanes_of_runs(scene: SceneFunctions, precision: Precision) -> dict[str, str]:
    """The parameters of a function of many steps of many states, arm_run_rk4_many, and arguments of
    contiguous rows."""
    real, rows = precision.c_type, {"p": len(scene.parameters), "q": scene.nq, "v": scene.nv}
    parameters, arguments = ["ptrdiff_t", "ptrdiff_t"], ["states", "n"]
    for name in scene_text.step_inputs(scene):
        const = "const " if name == "p" else ""
        parameters += [f"{const}{real} *", "ptrdiff_t"] if name in rows else ["double"]
        arguments += [name, str(rows[name])] if name in rows else [name]
    return {"several_parameters": ", ".join(parameters), "several_arguments": ", ".join(arguments)}


def _function(scene: SceneFunctions, function: Signature, precision: Precision
              ) -> dict[str, object]:
    real, name = precision.c_type, c_name(scene, function.name, precision)
    inputs = [x for x, _ in function.inputs]
    passed = list(_of_states(function))
    lanes = [f"{'' if written else 'const '}{real} *, ptrdiff_t"
             for _, _, written in function.arguments]
    refused = [f"p[{n}] {'<' if zero else '<='} 0" for n, _, zero in scene_text.signs(scene)]
    return {
        "name": name, "kernel": name, "python": function.name,
        "refused": " || ".join(refused if "p" in inputs else ()),
        "p": inputs.index("p") if "p" in inputs else -1,
        "inputs": len(inputs),
        "numbers": max(sum(scene_text.count(shape) for _, shape in function.inputs), 1),
        "takes": [_array(shape) for _, shape in function.inputs],
        "results": [{**_array(shape), "moved": inputs.index(x)
                     if function.moved and x in inputs else -1} for x, shape in function.outputs],
        "lanes_parameters": ", ".join(("ptrdiff_t", *lanes)),
        "lanes_arguments": ", ".join(("n", *map(", ".join, passed))),
        "many_arguments": ", ".join(
            f"{rows} + k * {step}" if shape or written else f"{rows}[k * {step}]"
            for (rows, step), (_, shape, written) in zip(passed, function.arguments, strict=True)),
        "run_parameters": f"ptrdiff_t n, double t, double h, const {real} *p, {real} *q, {real} *v",
        "run_arguments": ", ".join(_RUN.get(x, x).format(real=real) for x in inputs)
        if function.repeats else "",
        "split": _split(scene, function.name, precision) if function.repeats else "",
    }


def _split(scene: SceneFunctions, step: str, precision: Precision) -> str:
    """The functions that say into how many parts a step is split: whether it is, and their number;
    "" if it never is, or they are not public."""
    public = {f.name for f in scene.functions if not f.internal}
    split = next((x for of in scene.steps if of.name == step for x in of.body
                  if isinstance(x, Split) and {y.function for y in x.first} <= public), None)
    return ", ".join(f"&about_{c_name(scene, x.function, precision)}" if x else "NULL"
                     for x in (split.test, split.parts)) if split else ""


def _of_states(function: Signature) -> Iterator[tuple[str, str]]:
    """The pointer of each argument in C and its stride."""
    inputs, outputs = ([x for x, _ in of] for of in (function.inputs, function.outputs))
    for name, _, written in function.arguments:
        yield (f"y[{outputs.index(name)}]", f"places[{outputs.index(name)}]") if written else (
            f"x[{inputs.index(name)}]", f"steps[{inputs.index(name)}]")


def _array(shape: tuple[int, ...]) -> dict[str, object]:
    """The numbers of an input or a result, and its axes."""
    return {"size": scene_text.count(shape), "axes": len(shape),
            "shape": ", ".join(map(str, shape)) or "1"}


TARGET = Target("calls of a scene", ("c", "python"), scene=files,
                tier=tier_files, generated=False)
