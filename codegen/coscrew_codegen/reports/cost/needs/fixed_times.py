"""Times of a scene's functions in fixed point on this machine."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from coscrew_codegen.accuracy.fixed_scene import FixedScene
from coscrew_codegen.backends.fixed.c_integers import INTEGERS
from coscrew_codegen.backends.fixed.scene_c_fixed import MARK
from coscrew_codegen.backends.render import render
from coscrew_codegen.program.fixed.fixed_program import Products
from coscrew_codegen.reports.cost.loops import ELEMENTS, over_states
from coscrew_codegen.reports.timing.buffers import aligned
from coscrew_codegen.reports.timing.intervals import Interval
from coscrew_codegen.reports.timing.loop_timing import Loop, driver, pointers, timed_loops
from coscrew_codegen.runtime.compilation import Compiler, library

FORMATS = {Products.FULL: INTEGERS.name, Products.HIGH: f"{INTEGERS.name} (high)"}
"""Names of the formats in tables."""
_SECONDS = 0.02  # of each function


def fixed_times(made: FixedScene, files: Mapping[str, str], compiler: Compiler
                ) -> dict[tuple[str, str], Interval]:
    """The time of a call in ns, by function and format.  Raises CompilationError."""
    loops = {(f.plain.name, x): f"coscrew_loop_{f.plain.name}{MARK[x]}"
             for x in Products for f in made.functions}
    text = render("cost/loops.c", headers=[made.stem], loops=[
        {"name": loops[f.plain.name, x], **over_states(
            replace(made.plain, mark=f"{made.tier.mark}{MARK[x]}"), f.plain, INTEGERS)}
        for x in Products for f in made.functions])
    of_integers = {name: content for name, content in files.items() if INTEGERS.name in name}
    sources = {**of_integers, "loops.c": text, "driver.c": driver()}
    names = [x for x in sources if x.endswith(".c") and not x.endswith("_double.c")]
    opened = library({x: (x,) for x in names}, sources, compiler).opened
    draw, timed = np.random.default_rng(1), []
    for f in made.functions:
        given = [np.stack([draw.integers(-int(x.largest), int(x.largest) + 1, ELEMENTS)
                           for x in values], -1).astype(np.int32) for values in f.inputs]
        results = [np.zeros((ELEMENTS, a.quantity.size), np.int32)
                   for a in f.plain.program.outputs]
        arrays = [aligned(x) for x in (*given, *results)]
        timed += [Loop(getattr(opened, loops[f.plain.name, x]), ELEMENTS, pointers(arrays))
                  for x in Products]
    times = timed_loops(opened, timed, 1e9 * _SECONDS * len(timed))
    keys = [(f.plain.name, FORMATS[x])
            for f in made.functions for x in Products]
    return {key: x.time for key, x in zip(keys, times, strict=True)}
