"""A scene in fixed point of many states as C: arm_fixed_many.h; arm_fixed_many.c with full
products and arm_fixed_high_many.c with high ones.

The Programs of arm_fixed.c, on vectors with an integer of each of several states, as many as a
register holds.  Loops over the functions of one state where the compiler or the processor has no
such vectors.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from coscrew_codegen.accuracy.fixed_scene import FixedFunction, FixedScene
from coscrew_codegen.algebra.recording.gc_pause import uncollected
from coscrew_codegen.backends.c.c_function import CFunction
from coscrew_codegen.backends.c.c_statements import comment_of
from coscrew_codegen.backends.fixed import c_integers, scene_c_fixed_runtime
from coscrew_codegen.backends.fixed.c_integers import IN_LANES, INTEGERS
from coscrew_codegen.backends.fixed.scene_c_fixed import MARK, TITLES, body, c_name
from coscrew_codegen.backends.render import render
from coscrew_codegen.backends.scene import scene_c_arguments as arguments
from coscrew_codegen.backends.scene import scene_text
from coscrew_codegen.backends.scene.scene_c_lanes import VectorArray
from coscrew_codegen.backends.target import Files, Target
from coscrew_codegen.program.fixed import fixed_sine
from coscrew_codegen.program.fixed.fixed_program import Products


@dataclass(frozen=True)
class _FixedSection:
    """The public functions: what the templates for many states need."""

    functions: Sequence[dict[str, object]]
    vector: str = IN_LANES.c_type
    wide: str = ""


@uncollected()
def files(made: FixedScene, banner: str) -> Files:
    """All files, and coscrew_fixed.h."""
    name = f"{made.stem}_many"
    public = {x: [_many(made, f, x) for f in made.functions] for x in Products}
    kernel = c_integers.body(fixed_sine.kernel(), lambda x: "r", [
        f"{IN_LANES.c_type} {x}" for x in "sc"], {}, 90, IN_LANES)
    return {
        f"{name}.h": render(
            "scene/many.h", banner=banner, of=made.stem, guard=name.upper(),
            about=comment_of([*_about(made)]),
            sections=[_FixedSection([f for functions in public.values() for f in functions])]),
        **{f"{made.stem}{MARK[x]}_many.c": render(
            "scene/fixed_many.c", banner=banner, name=name, title=f"The functions of {name}.h "
            f"with {TITLES[x]}: those of {made.stem}{MARK[x]}.c on vectors.",
            section=_FixedSection(functions), kernels=[_kernel(made, f, x) for f in made.functions],
            sine=kernel, half_pi=fixed_sine.HALF_PI, two_over_pi=fixed_sine.TWO_OVER_PI,
            fingerprint=scene_c_fixed_runtime.fingerprint()) for x, functions in public.items()},
        **scene_c_fixed_runtime.files()}


def _about(made: FixedScene) -> tuple[str, ...]:
    return (f"{made.stem}: its functions of n states.",
            f"The bits are those of {made.stem}.h's functions.  Row k of an argument begins k "
            "strides behind the first: a stride counts integers, and 0 says that all states share "
            "one row.  n may be 0.  An output may be an input with the same stride, not 0; else it "
            "must overlap neither inputs nor other outputs, which is not checked.  No heap, no "
            "state: all functions are thread-safe.",
            "As many states as a register holds are computed at a time: compile for your processor "
            "(-march=native, or the oldest one that must run it; of x86 those with AVX2 are the "
            f"first that gain much).  Link with {made.stem}.c and {made.stem}_high.c.")


def _lanes_name(made: FixedScene, f: FixedFunction, products: Products) -> str:
    return f"{c_name(made, f, products)}{IN_LANES.lanes}"


def _kernel(made: FixedScene, f: FixedFunction, products: Products) -> CFunction:
    """The function of as many states as a vector has."""
    parameters = [*(arguments.read(a, IN_LANES) for a in f.plain.inputs),
                  *(arguments.written(a, IN_LANES) for a in scene_text.outputs(f.plain))]
    return CFunction(c_name(made, f, products), "", arguments.head(
        _lanes_name(made, f, products), parameters, "static"), body(f, products, IN_LANES))


def _many(made: FixedScene, f: FixedFunction, products: Products) -> dict[str, object]:
    """The function of n states: what a template needs."""
    of, outputs = c_name(made, f, products), scene_text.outputs(f.plain)
    read, written = ([VectorArray(a.name, a.quantity.size) for a in x]
                     for x in (f.plain.inputs, outputs))
    parameters = [text for qualified, arrays in (("const ", read), ("", written)) for x in arrays
                  for text in (f"{qualified}{INTEGERS.c_type} *{x.name}",
                               f"ptrdiff_t {x.name}_stride")]
    scalars = [a.name for a in f.plain.inputs if not a.quantity.shape]
    passed = [(f"{x.name}[k * {x.name}_stride]", f"*{x.name}_states") if x.name in scalars else
              (f"{x.name} + k * {x.name}_stride", f"{x.name}_states") for x in (*read, *written)]
    single, kernel = (", ".join(x) for x in zip(*passed, strict=True))
    return {
        "name": f.plain.name, "internal": False, "comment": comment_of([f"{of} of n states."]),
        "head": arguments.head(f"{of}_many", ["ptrdiff_t n", *parameters]), "read": read,
        "written": written, "plain": "", "repeated": False,
        "rooms": ", ".join(f"{x.name}_states[{x.size}]" for x in (*read, *written)),
        "single": f"{of}({single});", "kernel": f"{_lanes_name(made, f, products)}({kernel});"}


TARGET = Target("many states of a scene in fixed point in C", ("c",), many_fixed=files)
