"""The C between Python and a scene's functions: calls for one state, and loops over many.

`call_…` takes Python objects and returns 0 unless they are arrays it can take or convert; `many_…`
takes a pointer and a stride in numbers for each input (0: the same for all states), and for each
output a pointer; `run_…` takes n steps of h in a row, from the time t on.  All work in Python
without its headers.
"""

from collections.abc import Collection
from dataclasses import replace

from coscrew_codegen.formats import DOUBLE, PRECISIONS, Precision, named
from coscrew_codegen.render import render
from coscrew_codegen.scene_functions import SceneFunctions, SceneInterface, Signature
from coscrew_codegen.scene_tiers import SceneTier
from coscrew_codegen.targets import scene_text
from coscrew_codegen.targets.scene_c_steps import begun
from coscrew_codegen.targets.scene_text import c_name
from coscrew_codegen.targets.target import Files, Target

# Times and step lengths are rounded from double, as when steps are called one by one.
_RUN = {"t": "({real})begun(t, h, (double)k)", "h": "({real})h"}


def interface(scene: SceneFunctions) -> SceneInterface:
    """The interface of the scene for its callers."""
    return SceneInterface(scene.name, scene.nq, scene.nv, scene.coordinates, scene.bodies,
                      scene.parameters, scene.neutral, scene.precisions, scene.timed,
                      callables(scene), scene.signs, scene.tiers, scene.mark)


def tier_interface(made: SceneTier) -> SceneInterface:
    """The interface of the scene's functions in a tier."""
    return replace(interface(made.first), precisions=made.plain.precisions)


def callables(scene: SceneFunctions) -> tuple[Signature, ...]:
    """All public functions, steps last."""
    found = [Signature(f.name, tuple((a.name, tuple(a.quantity.shape)) for a in f.inputs),
                  tuple((a.name, tuple(a.quantity.shape)) for a in scene_text.outputs(f)),
                  scene_text.words(f, not scene.mark), zero=f.program.zero)
             for f in scene.functions if not f.internal]
    shapes = scene_text.step_shapes(scene)
    for step in scene.steps:
        inputs = tuple((x, shapes[x]) for x in scene_text.step_inputs(scene))
        found.append(Signature(step.name, inputs, (("q", shapes["q"]), ("v", shapes["v"])),
                          scene_text.step_words(scene, step), moved=True))
    return tuple(found)


def files(scene: SceneFunctions, banner: str) -> Files:
    """arm_calls.c, which is compiled with arm.c for Python and has no banner."""
    return {f"{scene.name}_calls.c": source(scene)}


def tier_files(made: SceneTier, banner: str) -> Files:
    """arm_accurate_calls.c, in the same way."""
    return {f"{made.stem}_calls.c": _source(made.first, made.stem, made.plain.precisions)}


def source(scene: SceneFunctions) -> str:
    """The text of the file that is compiled for Python."""
    return _source(scene, scene.name, scene.precisions)


def _source(scene: SceneFunctions, stem: str, precisions: Collection[str]) -> str:
    sections = [{"precision": p, "format": p.buffer_format,
                 "other": next(x.c_type for x in PRECISIONS if x != p),
                 "functions": [_function(scene, f, p) for f in callables(scene)]}
                for p in named(precisions)]
    return render("scene/calls.c", name=stem, upper=scene.name.upper(), sections=sections,
                  products=[DOUBLE], begun=begun() if scene.timed and scene.steps else "")


def _function(scene: SceneFunctions, function: Signature, precision: Precision
              ) -> dict[str, object]:
    real, name = precision.c_type, c_name(scene, function.name, precision)
    scalars = [x for x, shape in function.read if not shape]
    read = [_array(x, shape) for x, shape in function.read if shape]
    written = [_array(x, shape) for x, shape in function.outputs]
    many = [f"const {real} *{x}, ptrdiff_t {x}_step" for x, _ in function.read]
    many += [f"{real} *{x}" for x, _ in function.outputs]
    strided = [f"{x}[k * {x}_step]" if x in scalars else f"{x} + k * {x}_step"
               for x, _ in function.read]
    strided += [f"{x} + k * {scene_text.count(shape)}" for x, shape in function.outputs]
    names = [x for x, _ in (*function.read, *function.outputs)]
    signs = scene_text.signs(scene) if "p" in names else ()
    return {
        "refused": " || ".join(f"p[{n}] {'<' if zero else '<='} 0" for n, _, zero in signs),
        "name": name, "kernel": name, "scalars": scalars, "read": read, "written": written,
        "views": len(read) + len(written),
        "call_parameters": ", ".join(f"double of_{x}" if x in scalars else f"void *of_{x}"
                                     for x in names),
        "call_arguments": ", ".join(names), "many_arguments": ", ".join(strided),
        "many_parameters": ", ".join(("ptrdiff_t n", *many)),
        "run_parameters": f"ptrdiff_t n, double t, double h, const {real} *p, {real} *q, {real} *v",
        "run_arguments": ", ".join(_RUN.get(x, x).format(real=real) for x, _ in function.inputs)
        if function.moved else "",
    }


def _array(name: str, shape: tuple[int, ...]) -> dict[str, str]:
    size = scene_text.count(shape)
    return {"name": name, "size": str(size), "room": str(max(size, 1)), "axes": str(len(shape)),
            "shape": ", ".join(map(str, shape)) or "1"}


TARGET = Target("calls of a scene", ("c", "python"), scene=files,
                tier=tier_files, generated=False)
