"""C of Pinocchio's functions that CasADi writes, in loops over states, as a rival (extra `peers`).

It is compiled as CasADi's users do, with contracted products.
"""

import ctypes
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from itertools import accumulate
from pathlib import Path

import numpy as np

from coscrew_codegen.reports.timing.buffers import aligned
from coscrew_codegen.reports.timing.loop_timing import Loop, pointers
from tests.benchmarks.pinocchio_loops import (
    DERIVATIVES,
    FUNCTIONS,
    OPTIMISED,
    in_their_order,
    library,
    with_joints,
)
from tests.support.scenes.robots import Robot

SOURCE = Path(__file__).with_name("casadi_code.cpp")
WAYS = ("", "_ad")
"""Suffixes of CasADi's functions: derivatives by Pinocchio's recursions, and of its dynamics by
automatic differentiation."""
ALL_DERIVATIVES = tuple((x, way) for x in DERIVATIVES for way in WAYS)
OF_HUMANOIDS = ALL_DERIVATIVES[:1]
"""Derivatives whose C compiles within minutes for 35 joints."""
LOOP = """
int {name}(const double **given, double **results, long long *iw, double *w, int memory);
void loop_{name}(long n, void *const *x);
void loop_{name}(long n, void *const *x) {{
  static double w[100000];
  for (long i = 0; i < n; i++) {{
    const double *given[] = {{{given}}};
    double *results[] = {{{results}}};
    {name}(given, results, 0, w, 0);
  }}
}}
"""


def written(robot: Robot, folder: Path, derivatives: Sequence[tuple[str, str]] = ()) -> str:
    """Write casadi.c and loops over its functions to a folder, dynamics or derivatives (function,
    way); returns the name of a missing library, or ""."""
    result = find_spec("casadi")
    if not result or not result.origin:
        return "no CasADi: pip install casadi"
    place = Path(result.origin).parent
    writer, missing = library("clang++", SOURCE, (
        "-O0", f"-I{place / 'include'}", f"-L{place}", f"-Wl,-rpath,{place}", "-lcasadi"))
    if not writer:
        return missing
    kind = (tuple(derivatives) == OF_HUMANOIDS) + bool(derivatives)
    if with_joints(robot.model, writer.write_c, f"{folder}/".encode(), ctypes.c_int(kind)):
        return "CasADi fails"
    names = [(x, x + way) for x, way in derivatives or ((x, "") for x in FUNCTIONS)]
    (folder / "casadi_loops.c").write_text("".join(
        loop_text(robot, *x) for x in dict.fromkeys((*names, ("mass_matrix", "mass_matrix")))))
    return ""


def loop_text(robot: Robot, function: str, name: str) -> str:
    """The loop over calls of CasADi's function `name`, whose results are those of `function` one
    after the other."""
    program = robot.functions.named(function).program
    given, results = ([x.quantity.size for x in side] for side in (program.inputs, program.outputs))
    before = accumulate(results[:-1], initial=0)
    return LOOP.format(
        name=name, given=", ".join(
            f"(const double *)x[{k}] + {n} * i" for k, n in enumerate(given)),
        results=", ".join(f"(double *)x[{len(given)}] + {sum(results)} * i + {first}"
                          for first in before))


@dataclass(frozen=True, eq=False)
class CasADi:
    """A robot's functions in C, at these states of ours; derivatives in one of WAYS."""

    library: ctypes.CDLL
    robot: Robot
    states: tuple[np.ndarray, ...]
    way: str = ""

    @classmethod
    def compiled(cls, robot: Robot, states: tuple[np.ndarray, ...], folder: Path, compiler: str
                 ) -> "CasADi":
        """Compiles the files that `written` wrote to the folder."""
        path = folder / f"casadi-{compiler}.so"
        subprocess.run([compiler, *OPTIMISED.split(), "-shared", "-fPIC", "casadi.c",
                        "casadi_loops.c", "-o", str(path), "-lm"], cwd=folder, check=True)
        return cls(ctypes.CDLL(str(path)), robot, states)

    def loop(self, function: str, results: np.ndarray | None = None) -> Loop:
        """The loop of a function over all states."""
        if results is None:
            results = self._results(function)
        given = in_their_order(self.robot, self.states)
        arrays = [*given[:len(self.robot.functions.named(function).inputs)], results]
        way = self.way if function in DERIVATIVES else ""
        return Loop(getattr(self.library, f"loop_{function}{way}"), len(results), pointers(arrays))

    def values(self, function: str) -> np.ndarray:
        """Its results."""
        loop = self.loop(function, results := self._results(function))
        loop.function(ctypes.c_long(len(results)), loop.arguments)
        follow = self.robot.follow
        return follow.T @ results @ follow if results.ndim > 2 else results @ follow

    def _results(self, function: str) -> np.ndarray:
        outputs = self.robot.functions.named(function).program.outputs
        shape = outputs[0].quantity.shape
        return aligned(np.zeros((len(self.states[0]), *(
            (len(outputs), *shape) if len(outputs) > 1 else shape))))
