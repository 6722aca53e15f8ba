"""Compiles C loops over a scene's functions for timing, beside the runs that simulations use."""

import ctypes
import time
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from coscrew_codegen.accuracy.scene_tiers import SceneTier
from coscrew_codegen.accuracy.tiers import PLAIN
from coscrew_codegen.backends.python_extension import scene_calls
from coscrew_codegen.backends.python_extension.scene_calls import BINDING, binding_units
from coscrew_codegen.backends.render import render
from coscrew_codegen.backends.scene import scene_c, scene_c_tier
from coscrew_codegen.backends.scene.scene_text import banner_of, c_name, outputs, size
from coscrew_codegen.program.scene_functions import FunctionProgram, IntegratorStep, SceneFunctions
from coscrew_codegen.program.values.formats import PRECISIONS, Precision, named
from coscrew_codegen.reports.cost.effect_ablation import WHOLE, Ablation
from coscrew_codegen.reports.timing.buffers import aligned
from coscrew_codegen.reports.timing.loop_timing import Loop, driver, pointers
from coscrew_codegen.runtime.compilation import Compiler, library

ELEMENTS = 64  # states of a loop: few enough for the first-level cache
State = tuple[np.ndarray, np.ndarray]


@dataclass(frozen=True)
class CompiledLoops:
    """The library of a part of a scene: its functions, and those of these tiers."""

    part: Ablation
    library: ctypes.PyDLL
    tiers: tuple[SceneTier, ...] = ()

    def loop(self, name: str, precision: Precision, inputs: Sequence[np.ndarray],
             tier: str = PLAIN.name) -> Loop:
        """A function's loop over a row of each of `inputs` at a time."""
        return self._loop(name, precision, inputs, tier)[0]

    def values(self, name: str, precision: Precision, inputs: Sequence[np.ndarray],
               tier: str = PLAIN.name) -> list[np.ndarray]:
        """The results of the timed loop: a row of numbers for each row of the inputs."""
        loop, made = self._loop(name, precision, inputs, tier)
        loop.function(ctypes.c_long(loop.n), loop.arguments)
        return made

    def _loop(self, name: str, precision: Precision, inputs: Sequence[np.ndarray], tier: str
              ) -> tuple[Loop, list[np.ndarray]]:
        scene = next((x.first for x in self.tiers if x.tier.name == tier), self.part.functions)
        count = len(inputs[0])
        given = [aligned(np.asarray(x, precision.numpy_type)) for x in inputs]
        made = [aligned(np.zeros((count, size(a)), precision.numpy_type))
                for a in outputs(scene.named(name))]
        function = getattr(self.library, _loop(name, precision, scene.mark))
        return Loop(function, count, pointers((*given, *made))), made

    def run(self, step: IntegratorStep, precision: Precision, steps: int, h: float,
            p: Sequence[float],
            start: State) -> tuple[np.ndarray, np.ndarray, float]:
        """q and v after `steps` steps of h from `start` at t = 0, and the processor time in s (time
        of other processes does not count)."""
        q, v = (np.array(x, precision.numpy_type) for x in start)
        parameters = np.array([*p, 0], precision.numpy_type)
        function = getattr(self.library,
                           f"run_{c_name(self.part.functions, step.name, precision)}")
        arguments = [ctypes.c_void_p(x.ctypes.data) for x in (parameters, q, v)]
        began = time.thread_time()
        function(ctypes.c_ssize_t(steps), ctypes.c_double(0), ctypes.c_double(h), *arguments)
        return q, v, time.thread_time() - began


def compiled(part: Ablation, functions: Sequence[FunctionProgram], compiler: Compiler,
             tiers: Sequence[SceneTier] = ()) -> CompiledLoops:
    """A part's loops over these functions, and over all of these tiers, compiled as load_scene
    does.  Raises CompilationError."""
    banner = banner_of(part.functions.name)
    scene, calls = (x(part.functions, banner) for x in (scene_c.files, scene_calls.files))
    files = {**scene, **calls, "loops.c": text(part, functions, tiers), "driver.c": driver()}
    made = dict(calls if part.words == WHOLE else scene)  # only the whole scene runs
    for tier in tiers:
        made |= scene_c_tier.files(tier, banner)
    units: dict[str, tuple[str, ...]] = {
        x: (x,) for x in (*made, "loops.c", "driver.c") if x.endswith(".c") and x != BINDING}
    if BINDING in made:
        units |= binding_units(named(part.functions.precisions))
    files |= made
    return CompiledLoops(part, library(units, files, compiler).opened, tuple(tiers))


def text(part: Ablation, functions: Sequence[FunctionProgram],
         tiers: Sequence[SceneTier] = ()) -> str:
    """The C text of the loops."""
    chosen = [(part.functions, functions, PRECISIONS), *(
        (x.first, x.first.functions, [p for p, _ in x.in_precisions]) for x in tiers)]
    loops = [{"name": _loop(f.name, precision, scene.mark), **over_states(scene, f, precision)}
             for scene, some, precisions in chosen for f in some for precision in precisions]
    return render("cost/loops.c", headers=[part.functions.name, *(x.stem for x in tiers)],
                  loops=loops)


def _loop(function: str, precision: Precision, tier: str) -> str:
    return "_".join(filter(None, ("coscrew_loop", function, tier))) + precision.suffix


def over_states(scene: SceneFunctions, function: FunctionProgram, precision: Precision
                ) -> dict[str, object]:
    """The declarations of the loop's arrays, a row an element, and the call for row i."""
    declared, passed = [], []
    arguments = [*((a, "const ") for a in function.program.inputs),
                 *((a, "") for a in outputs(function))]
    for number, (a, const) in enumerate(arguments):
        row = f"(*{a.name})[{max(size(a), 1)}]" if a.quantity.shape else f"*{a.name}"
        declared.append(f"{const}{precision.c_type} {row} = arguments[{number}];")
        passed.append(f"{a.name}[i]" if a.quantity.shape or const else f"&{a.name}[i]")
    call = f"{c_name(scene, function.name, precision)}({', '.join(passed)});"
    return {"pointers": declared, "call": call}

