"""A scene in fixed point for CUDA: arm_fixed.cuh, for host and device, which needs coscrew_fixed.h
alone.

The functions are those of arm_fixed.c and arm_fixed_high.c: no flag of a compiler changes integers.
A thread computes a state.
"""

from dataclasses import replace

from coscrew_codegen.accuracy.fixed_scene import FixedFunction, FixedScene
from coscrew_codegen.algebra.recording.gc_pause import uncollected
from coscrew_codegen.backends.c.c_statements import comment_of
from coscrew_codegen.backends.cuda.cuda_kernels import CudaKernel, Taken
from coscrew_codegen.backends.fixed import scene_c_fixed, scene_c_fixed_runtime
from coscrew_codegen.backends.fixed.c_integers import INTEGERS
from coscrew_codegen.backends.fixed.scene_c_fixed import MARK
from coscrew_codegen.backends.render import render
from coscrew_codegen.backends.scene import scene_text
from coscrew_codegen.backends.target import Files, Target
from coscrew_codegen.program.fixed.fixed_program import Products


@uncollected()
def files(made: FixedScene, banner: str) -> Files:
    """arm_fixed.cuh and coscrew_fixed.h.  Raises ValueError for names that C cannot use."""
    scene_text.check_names(made.plain)
    made_of = kernels(made)
    return {f"{made.stem}.cuh": render(
        "cuda/scene_fixed.cuh", banner=banner, about=comment_of([*_about(made)]),
        guard=made.stem.upper(), formats=scene_c_fixed.formats(made),
        names=scene_c_fixed.legend(x.body for x in made_of), kernels=made_of,
        fingerprint=scene_c_fixed_runtime.fingerprint()), **scene_c_fixed_runtime.files()}


def kernels(made: FixedScene) -> list[CudaKernel]:
    """The kernels of all functions."""
    return [_kernel(made, f, x) for x in Products for f in made.functions]


def _kernel(made: FixedScene, f: FixedFunction, products: Products) -> CudaKernel:
    """The function of one state, and its kernel."""
    taken = [*(Taken(a.name, INTEGERS.c_type, a.quantity.size, "const ", not a.quantity.shape)
               for a in f.plain.inputs),
             *(Taken(a.name, INTEGERS.c_type, a.quantity.size)
               for a in scene_text.outputs(f.plain))]
    words = (f"{scene_c_fixed.c_name(made, f, products)} of one state, and of n, one a thread.  "
             f"{scene_c_fixed.bounds_in_words(f, f.programs[products].results)}")
    return CudaKernel(replace(made.plain, mark=f"{made.tier.mark}{MARK[products]}"), f.plain.name,
                      INTEGERS, words, (), taken, scene_c_fixed.body(f, products))


def _about(made: FixedScene) -> list[str]:
    return [
        f"{made.stem}: dynamics of a scene in fixed point, for CUDA and C++11.",
        f"On the device, as on the host, the bits are those of {made.stem}.h's functions, whose "
        "formats these are.  Outside the ranges results are wrong without notice.",
        "…_device computes one state, on host or device.  …_kernel computes n states, one a "
        "thread, with any number of blocks; …_launch starts it.  Row k of an argument begins k "
        "strides behind the first: a stride counts integers, and 0 says that all states share one "
        "row.  An output may be an input with the same stride, not 0; else it must overlap "
        "neither inputs nor other outputs, which is not checked.  A launch takes at most KSL_BLOCK "
        "threads a block: 128, unless it is defined."]


TARGET = Target("scene in fixed point for CUDA", ("c",), cuda_fixed=files)
