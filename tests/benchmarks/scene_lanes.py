"""What a state of a Panda takes where many are computed in lanes: functions and steps from C, with
every compiler and width that this processor has, against one call after the other."""

import ctypes
import shutil
import subprocess
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from tabulate import tabulate

from coscrew_codegen.formats import PRECISIONS, Precision
from coscrew_codegen.mechanics import derive
from coscrew_codegen.native.timing import Loop, driver, pointers, timed_loops
from coscrew_codegen.scene_functions import Function, SceneFunctions
from coscrew_codegen.targets import scene_c, scene_c_many
from tests.benchmarks.words import said
from tests.support.scenes.robots import scene_of
from tests.support.scenes.tiers import states

NAMES = ("inverse_dynamics", "forward_dynamics", "mass_matrix")
STEP, STEPS = "leapfrog", 10
COMPILERS = {"gcc": "-O2", "clang": "-O1"}
WIDTHS = {"sse2": (), "avx2": ("-mavx2", "-mfma"), "avx512f": ("-march=native",)}
"""What the processor needs, and the flags."""
COMMON = ("-std=c11", "-DKSL_CONTRACT_OFF", "-ffp-contract=off", "-shared", "-fPIC")
STATES = 256  # whose rows fit into the first cache
SECONDS = 1.0  # of each comparison


def panda(*more: str) -> SceneFunctions:
    """The robot with its fingers, under gravity, with these functions besides NAMES."""
    scene = scene_of("panda_description/urdf/panda.urdf")
    return derive(replace(scene, name="panda"), (*NAMES, *more))


def written(scene: SceneFunctions, folder: Path) -> None:
    """Write the C, with loops over states, and the driver."""
    banner = "for the benchmark"
    made = scene_c.files(scene, banner) | scene_c_many.files(scene, banner)
    made["driver.c"] = driver()
    made["loops.c"] = '#include "panda_many.h"\n' + "".join(
        text for p in PRECISIONS for text in (
            *(x for name in NAMES for x in loops(scene.named(name), p)), *runs(scene, p)))
    for name, text in made.items():
        (folder / name).write_text(text)


def sizes_of(function: Function) -> list[int]:
    """How many numbers each argument has."""
    program = function.program
    return [int(np.prod(a.quantity.shape)) for a in (*program.inputs, *program.outputs)]


def loops(function: Function, p: Precision) -> Iterator[str]:
    """C that calls a function for n states: one after the other, and all at once."""
    sizes, f = sizes_of(function), p.suffix
    one = ", ".join(f"({p.c_type} *)x[{k}] + {size} * i" for k, size in enumerate(sizes))
    all_of_them = ", ".join(f"({p.c_type} *)x[{k}], {size}" for k, size in enumerate(sizes))
    for kind, call in (("one", f"for (long i = 0; i < n; i++) panda_{function.name}{f}({one});"),
                       ("many", f"panda_{function.name}_many{f}(n, {all_of_them});")):
        head = f"void {kind}_{function.name}{f}(long n, void *const *x)"
        yield f"{head};\n{head} {{ {call} }}\n"


def runs(scene: SceneFunctions, p: Precision) -> Iterator[str]:
    """The same of steps of length 0, which leave q and v as they are; a step counts as an element.
    """
    nq, nv, f = scene.nq, scene.nv, p.suffix
    q, v = (f"({p.c_type} *)x[{k}]" for k in range(2))
    one = (f"for (long i = 0; i < n / {STEPS}; i++) for (int k = 0; k < {STEPS}; k++) "
           f"panda_step_{STEP}{f}(0, {q} + {nq} * i, {v} + {nv} * i);")
    many = f"panda_run_{STEP}_many{f}(n / {STEPS}, {STEPS}, 0, {q}, {nq}, {v}, {nv});"
    for kind, call in (("one", one), ("many", many)):
        head = f"void {kind}_{STEP}{f}(long n, void *const *x)"
        yield f"{head};\n{head} {{ {call} }}\n"


def rows(scene: SceneFunctions, folder: Path, compiler: str, width: str) -> Iterator[list[str]]:
    """A line for each function and precision."""
    library = folder / f"{compiler}-{width}"
    files = ("driver.c", "loops.c", "panda.c", "panda_many.c")
    subprocess.run([compiler, *COMMON, COMPILERS[compiler], *WIDTHS[width], *files, "-o",
                    str(library), "-lm"], cwd=folder, check=True)
    opened = ctypes.CDLL(str(library))
    for name in (*NAMES, STEP):
        for p in PRECISIONS:
            arrays = _arrays(scene, name, p)
            count = STATES * (STEPS if name == STEP else 1)
            one, many = timed_loops(opened, [
                Loop(getattr(opened, f"{kind}_{name}{p.suffix}"), count, pointers(arrays))
                for kind in ("one", "many")], 1e9 * SECONDS)
            yield [name, p.name, compiler, width, f"{one.minimum:.1f}",
                   f"{many.minimum:.1f}", said(one.ratio(many))]


def _arrays(scene: SceneFunctions, name: str, p: Precision) -> list[np.ndarray]:
    """The arguments of a function, or q and v."""
    function = scene.named(NAMES[0] if name == STEP else name)
    given = [np.ascontiguousarray(x, p.numpy_type) for x in states(scene, function, STATES, p)]
    if name == STEP:
        return given[:2]
    return [*given, *(np.empty((STATES, n), p.numpy_type)
                      for n in sizes_of(function)[len(given):])]


def main() -> None:
    """Print the tables."""
    scene, words = panda(f"step_{STEP}"), Path("/proc/cpuinfo").read_text().split()
    with TemporaryDirectory() as folder:
        written(scene, Path(folder))
        table = [row for compiler in filter(shutil.which, COMPILERS) for width in WIDTHS
                 if width in words for row in rows(scene, Path(folder), compiler, width)]
    print("\nA Panda with its fingers, ns a state from C, the shortest of rounds in which both "
          "take turns; ratio: median (95 % interval)")
    heads = ("one by one", "in lanes", "one / lanes")
    print(tabulate(table, ("function", "precision", "compiler", "width", *heads),
                   disable_numparse=True))


if __name__ == "__main__":
    main()
