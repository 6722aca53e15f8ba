"""Times of a call of a Panda's functions from C: plain, with the C library's sine and cosine, and
in the accurate and certified tiers; with every compiler, by usual flags and for this processor."""

import ctypes
import shutil
import subprocess
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from tabulate import tabulate

from coscrew_codegen.accuracy.scene_tiers import tiers_of
from coscrew_codegen.backends.scene import scene_c, scene_c_tier
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import FunctionProgram, SceneFunctions
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.reports.timing.loop_timing import Loop, driver, pointers, timed_loops
from tests.benchmarks.words import span
from tests.support.scenes.robots import scene_of
from tests.support.scenes.tiers import states

NAMES = ("inverse_dynamics", "forward_dynamics")
TIERS = ("accurate", "certified")
COMPILERS = ("gcc", "clang")
LEVELS = (("-O2",), ("-O3", "-march=native"))
COMMON = ("-std=c11", "-DKSL_CONTRACT_OFF", "-shared", "-fPIC")
STATES = 64
SECONDS = 1.0  # of each comparison

LIBM = """
#include <math.h>
#define KSL_SINCOS{F}
static inline {real} ksl_sincos{f}({real} x, {real} *c) {{ *c = cos{f}(x); return sin{f}(x); }}
""" + "".join(f"""
#define KSL_SINCOS_{n}{{F}}
static inline void ksl_sincos_{n}{{f}}({", ".join(f"{{real}} x{i}" for i in range(n))},
                                       {{real}} *s, {{real}} *c) {{{{
  {" ".join(f"s[{i}] = ksl_sincos{{f}}(x{i}, c + {i});" for i in range(n))}
}}}}
""" for n in (2, 3, 4))
"""The sines and cosines of generated C, by the C library."""


def panda() -> SceneFunctions:
    """The robot with its fingers, under gravity."""
    scene = scene_of("panda_description/urdf/panda.urdf")
    return derive(replace(scene, name="panda", tiers=TIERS), NAMES)


def written(scene: SceneFunctions, folder: Path) -> None:
    """Write the C of each tier with loops over states, and the prelude."""
    made = dict(scene_c.files(scene, "for the benchmark"))
    for tier in tiers_of(scene):
        made |= scene_c_tier.files(tier, "for the benchmark")
    holes = [{"f": p.suffix, "F": p.suffix.upper(), "real": p.c_type} for p in PRECISIONS]
    made["libm.h"] = "".join(LIBM.format(**each) for each in holes)
    made["driver.c"] = driver()
    for tier in ("", *TIERS):
        stem = f"panda{tier and f'_{tier}'}"
        made[f"{stem}_loops.c"] = "".join((*(f'#include "{x}"\n' for x in (
            f"{stem}{p.suffix}.c" for p in PRECISIONS) if x in made), *loops(scene, tier)))
    for name, text in made.items():
        (folder / name).write_text(text)


def loops(scene: SceneFunctions, tier: str) -> Iterator[str]:
    """C that calls a function in a tier for n states."""
    for function in scene.functions:
        for p in PRECISIONS:
            name = called(function, tier, p)
            given = ", ".join(f"({p.c_type} *)x[{k}] + {size} * i"
                              for k, size in enumerate(sizes_of(function, tier)))
            yield (f"void time_{name}(long n, void *const *x);\n"
                   f"void time_{name}(long n, void *const *x) {{\n"
                   f"  for (long i = 0; i < n; i++) panda_{name}({given});\n}}\n")


def called(function: FunctionProgram, tier: str, precision: Precision) -> str:
    """inverse_dynamics_accuratef"""
    return f"{function.name}{tier and f'_{tier}'}{precision.suffix}"


def sizes_of(function: FunctionProgram, tier: str) -> list[int]:
    """Number of components of each argument."""
    program = function.program
    bounds = program.outputs if tier == "certified" else ()
    return [int(np.prod(a.quantity.shape)) for a in (*program.inputs, *program.outputs, *bounds)]


def compiled(folder: Path, compiler: str, options: tuple[str, ...], *stems: str) -> ctypes.CDLL:
    """The loops in these files, and the driver."""
    path = folder / "-".join((compiler, *options)).replace("=", "")
    files = ["driver.c", *(f"{x}_loops.c" for x in stems)]
    subprocess.run([compiler, *COMMON, *options, *files, "-o", str(path), "-lm"], cwd=folder,
                   check=True)
    return ctypes.CDLL(str(path))


def rows(scene: SceneFunctions, folder: Path, compiler: str, level: tuple[str, ...]
         ) -> Iterator[tuple[str, ...]]:
    """A line for each function and precision."""
    own = compiled(folder, compiler, level, "panda", *(f"panda_{x}" for x in TIERS))
    libm = compiled(folder, compiler, (*level, "-include", "libm.h"), "panda")
    for function in scene.functions:
        for p in PRECISIONS:
            given = states(scene, function, STATES, p)
            variants = [(own, ""), (libm, ""), *((own, tier) for tier in TIERS)]
            timed = [loop(library, function, tier, p, given) for library, tier in variants]
            timings = timed_loops(own, timed, 1e9 * SECONDS)
            yield (function.name, p.name, compiler, " ".join(level), span(timings[0].time),
                   f"{timings[0].minimum:.0f}", *(span(x.ratio(timings[0])) for x in timings[1:]))


def loop(library: ctypes.CDLL, function: FunctionProgram, tier: str, precision: Precision,
         given: list[np.ndarray]) -> Loop:
    """The loop over the given states."""
    sizes = sizes_of(function, tier)[len(given):]
    results = [np.empty((STATES, size), precision.numpy_type) for size in sizes]
    arrays = [np.ascontiguousarray(x, precision.numpy_type) for x in given]
    return Loop(getattr(library, f"time_{called(function, tier, precision)}"), STATES,
                pointers([*arrays, *results]))


def main() -> None:
    """Print the table."""
    scene = panda()
    with TemporaryDirectory() as folder:
        written(scene, Path(folder))
        table = [row for compiler in filter(shutil.which, COMPILERS) for level in LEVELS
                 for row in rows(scene, Path(folder), compiler, level)]
    print("\nA Panda with its fingers, ns a call from C: median (95 % interval) of rounds in which "
          "all take turns, and the shortest;\nratios to plain in the same round: with the C "
          "library's sines, and of the tiers")
    print(tabulate(table, ("function", "precision", "compiler", "flags", "plain", "shortest",
                           "libm / plain", *(f"{tier} / plain" for tier in TIERS)),
                   disable_numparse=True))


if __name__ == "__main__":
    main()
