"""Times of a state of a Panda's inverse dynamics in fixed point, where many are computed in lanes,
against one call after the other, and beside lanes of floating point."""

import ctypes
import subprocess
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from tabulate import tabulate

from coscrew_codegen.accuracy.fixed_scene import FixedScene
from coscrew_codegen.backends.fixed import scene_c_fixed_many
from coscrew_codegen.backends.fixed.c_integers import INTEGERS
from coscrew_codegen.backends.fixed.scene_c_fixed import c_name
from coscrew_codegen.backends.scene import scene_c, scene_c_many
from coscrew_codegen.program.fixed.fixed_program import Products
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE
from coscrew_codegen.reports.timing.buffers import aligned
from coscrew_codegen.reports.timing.loop_timing import Loop, driver, pointers, timed_loops
from tests.benchmarks.scene_loops import BANNER, COMMON, COMPILERS, WIDTHS, compilers, widths
from tests.benchmarks.words import span
from tests.support.scenes import fixed_point as fx
from tests.support.scenes import fixed_robots

STATES = 256
SECONDS = 0.5  # of each comparison
JOINTS = 7


def calls(made: FixedScene) -> dict[str, tuple[str, str]]:
    """The C function and the type of its numbers, by a name for each loop."""
    plain = f"{made.plain.name}_inverse_dynamics"
    names = {x: c_name(made, made.functions[0], x) for x in Products}
    return {**{x.value: (name, INTEGERS.c_type) for x, name in names.items()},
            **{p.name: (f"{plain}{p.suffix}", p.c_type) for p in (SINGLE, DOUBLE)}}


def compiled(made: FixedScene, folder: Path, compiler: str, *flags: str) -> ctypes.CDLL:
    """Loops over states: `one_full`, `many_full` and so on."""
    name = made.plain.name
    files = {**scene_c.files(made.plain, BANNER), **scene_c_many.files(made.plain, BANNER),
             **scene_c_fixed_many.files(made, BANNER), "driver.c": driver()}
    text = f'#include "{name}_many.h"\n#include "{made.stem}_many.h"\n'
    for kind, (function, number) in calls(made).items():
        many = function.replace(f"{name}_inverse_dynamicsf", f"{name}_inverse_dynamics_manyf")
        many = many if many != function else f"{function}_many"
        arrays = [f"({number} *)x[{k}]" for k in range(4)]
        one = ", ".join(f"{x} + {JOINTS} * i" for x in arrays)
        lanes = ", ".join(f"{x}, {JOINTS}" for x in arrays)
        for what, call in (("one", f"for (long i = 0; i < n; i++) {function}({one});"),
                           ("many", f"{many}(n, {lanes});")):
            head = f"void {what}_{kind}(long n, void *const *x)"
            text += f"{head};\n{head} {{ {call} }}\n"
    files["loops.c"] = text
    fx.written(made, folder)
    for path, content in files.items():
        (folder / path).write_text(content)
    sources = [*(x for x in files if x.endswith(".c")),
               *(f"{made.stem}{mark}.c" for mark in fx.MARKS.values())]
    library = folder / "-".join((compiler, *flags)).replace("=", "")
    subprocess.run([compiler, *COMMON, COMPILERS[compiler], *flags, *sources, "-o", str(library),
                    "-lm"], cwd=folder, check=True)
    return ctypes.CDLL(str(library))


def rows(made: FixedScene, library: ctypes.CDLL) -> Iterator[list[str]]:
    """A line for each kind of number."""
    states = fx.states(made.functions[0], STATES, 1)
    for kind, (_, number) in calls(made).items():
        dtype = {"int32_t": np.int32, "float": np.float32}.get(number, np.float64)
        given = [np.stack(parts, -1) for parts in states] if number == "int32_t" else [
            np.stack([x / 2.0**v.bits for x, v in zip(parts, values, strict=True)], -1)
            for parts, values in zip(states, made.functions[0].inputs, strict=True)]
        arrays = [aligned(x.astype(dtype)) for x in (*given, np.zeros((STATES, JOINTS)))]
        one, many = timed_loops(library, [
            Loop(getattr(library, f"{what}_{kind}"), STATES, pointers(arrays))
            for what in ("one", "many")], 1e9 * SECONDS)
        yield [kind, f"{one.minimum:.1f}", f"{many.minimum:.1f}", span(one.ratio(many))]


def main() -> None:
    """Print the table."""
    made, table = fixed_robots.fixed("Panda", ("inverse_dynamics",)), []
    with TemporaryDirectory() as folder:
        for compiler in compilers():
            for width in widths():
                library = compiled(made, Path(folder), compiler, *WIDTHS[width])
                table += [[compiler, width, *row] for row in rows(made, library)]
    print("\nA Panda's inverse dynamics, ns a state from C, the shortest of rounds in which both "
          "take turns; ratio: median (95 % interval)")
    print(tabulate(table, ("compiler", "registers", "numbers", "one after the other", "in lanes",
                           "ratio"), disable_numparse=True))


if __name__ == "__main__":
    main()
