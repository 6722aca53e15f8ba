"""Loops in C over states of a scene, one call after the other and in lanes, for timing."""

import ctypes
import shutil
import subprocess
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from coscrew_codegen.backends.scene import scene_c, scene_c_many
from coscrew_codegen.program.scene_functions import FunctionProgram, SceneFunctions
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.reports.timing.buffers import aligned
from coscrew_codegen.reports.timing.loop_timing import Loop, driver, pointers

COMPILERS = {"gcc": "-O2", "clang": "-O2"}
WIDTHS = {"sse2": (), "avx2": ("-mavx2", "-mfma"), "avx512f": ("-march=native",)}
"""What the processor needs, and the flags."""
COMMON = ("-std=c11", "-DKSL_CONTRACT_OFF", "-ffp-contract=off", "-shared", "-fPIC")
STEPS = 10
BANNER = "for the benchmark"


def compilers() -> list[str]:
    """The installed compilers."""
    return [x for x in COMPILERS if shutil.which(x)]


def widths() -> list[str]:
    """The vector widths that this processor has."""
    words = Path("/proc/cpuinfo").read_text().split()
    return [x for x in WIDTHS if x in words]


@dataclass(frozen=True)
class Loops:
    """A compiled scene: `one_…` of its functions call them for n states, `many_…` in lanes."""

    scene: SceneFunctions
    library: ctypes.CDLL

    def loop(self, kind: str, name: str, p: Precision, arrays: Sequence[np.ndarray]) -> Loop:
        """The loop over all states of these arguments and results."""
        count = len(arrays[0]) * (STEPS if name.startswith("step_") else 1)
        return Loop(getattr(self.library, f"{kind}_{name}{p.suffix}"), count, pointers(arrays))

    def arguments(self, name: str, p: Precision, given: Sequence[np.ndarray]) -> list[np.ndarray]:
        """Arguments, as many of those given as a function has, and its empty results."""
        function = self.scene.named(name)
        arrays = [aligned(np.asarray(x, p.numpy_type)) for x in given[:len(function.inputs)]]
        return [*arrays, *(aligned(np.zeros((len(arrays[0]), n), p.numpy_type))
                           for n in sizes_of(function)[len(arrays):])]


def compiled(scene: SceneFunctions, names: Sequence[str], folder: Path, compiler: str,
             *flags: str, many: bool = False) -> Loops:
    """Loops of these functions; in lanes, too, if `many`."""
    files = dict(scene_c.files(scene, BANNER))
    if many:
        files |= scene_c_many.files(scene, BANNER)
    files["driver.c"] = driver()
    files["loops.c"] = f'#include "{scene.name}{"_many" * many}.h"\n' + "".join(
        text for name in names for p in PRECISIONS for text in texts(scene, name, p, many))
    for name, text in files.items():
        (folder / name).write_text(text)
    sources = [x for x in files if x.endswith(".c")]
    library = folder / "-".join((scene.name, compiler, *flags)).replace("=", "")
    subprocess.run([compiler, *COMMON, COMPILERS[compiler], *flags, *sources, "-o", str(library),
                    "-lm"], cwd=folder, check=True)
    return Loops(scene, ctypes.CDLL(str(library)))


def sizes_of(function: FunctionProgram) -> list[int]:
    """Number of components of each argument."""
    program = function.program
    return [int(np.prod(a.quantity.shape)) for a in (*program.inputs, *program.outputs)]


def texts(scene: SceneFunctions, name: str, p: Precision, many: bool) -> Iterator[str]:
    """The loops of a function, or of an integrator's steps of length 0, which leave q and v as they
    are; a step of a state counts as an element."""
    called, f = f"{scene.name}_{name}", p.suffix
    if name.startswith("step_"):
        q, v = ((f"({p.c_type} *)x[{k}]", n) for k, n in enumerate((scene.nq, scene.nv)))
        calls = [f"for (long i = 0; i < n / {STEPS}; i++) for (int k = 0; k < {STEPS}; k++) "
                 f"{called}{f}(0, {q[0]} + {q[1]} * i, {v[0]} + {v[1]} * i);",
                 f"{called.replace('_step_', '_run_')}_many{f}(n / {STEPS}, {STEPS}, 0, "
                 f"{q[0]}, {q[1]}, {v[0]}, {v[1]});"]
    else:
        arrays = [(f"({p.c_type} *)x[{k}]", n) for k, n in enumerate(sizes_of(scene.named(name)))]
        calls = [f"for (long i = 0; i < n; i++) {called}{f}("
                 f"{', '.join(f'{x} + {n} * i' for x, n in arrays)});",
                 f"{called}_many{f}(n, {', '.join(f'{x}, {n}' for x, n in arrays)});"]
    for kind, call in zip(("one", "many") if many else ("one",), calls, strict=False):
        head = f"void {kind}_{name}{f}(long n, void *const *x)"
        yield f"{head};\n{head} {{ {call} }}\n"
