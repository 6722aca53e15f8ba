"""Attacks the certified bounds of scenes' functions in double and single precision.

`python -m tests.certified_attack [--outputs N] [--scene NAME …]`, or `make attack`, judges compiled
functions at random and hard states in numbers of 113 bits (quad.py), moved free joints in MPFR
(free_motion.py), and prints the largest error / bound, which is just below 1, since bounds are
errors to several digits.
"""

import argparse
import os
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from tabulate import tabulate

from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import FunctionProgram, SceneFunctions
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.runtime.load import Kernels, kernels_of
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.scenes.tiers import flat
from tests.support.truth import free_motion, quad

FUNCTIONS = ("inverse_dynamics", "forward_dynamics", "mass_matrix", "energy", "body_poses",
             "body_twists")
EXAMPLES = Path(__file__).parents[1] / "examples/scenes"
SCENES = tuple(sorted(path.stem for path in EXAMPLES.glob("*.toml")))
ARMS = ("ur5", "panda")
BATCH = 2000  # states
LIMITS = {"double": (-1074, 340), "single": (-149, 40)}
"""Exponents of hard numbers: from the least subnormal one to those whose cubes overflow."""
Array = NDArray[np.float64]


@dataclass(frozen=True)
class Found:
    """Counts for a function in a precision: outputs with a statement and without, broken bounds,
    and the largest error / bound."""

    outputs: int = 0
    silent: int = 0
    broken: int = 0
    worst: float = 0

    @property
    def in_words(self) -> str:
        """The largest error / bound, so near to 1 that its distance is shown."""
        return f"1 - {1 - self.worst:.1e}" if self.worst < 1 else f"{self.worst:.6g}"

    def __add__(self, other: "Found") -> "Found":
        return Found(self.outputs + other.outputs, self.silent + other.silent,
                     self.broken + other.broken, max(self.worst, other.worst))


def kernels(name: str, functions: tuple[str, ...] = FUNCTIONS) -> Kernels:
    """A scene's functions with the certified tier."""
    if name in ARMS:  # these come with Pinocchio
        from tests.benchmarks.certified_scenes import ROBOTS
        from tests.support.scenes.robots import scene_of

        scene = scene_of(*ROBOTS[name])
    else:
        scene = read_scene(EXAMPLES / f"{name}.toml")
    derived = derive(scene, functions)
    return kernels_of(replace(derived, name=name, tiers=("certified",)))


def drawn(rng: np.random.Generator, scene: SceneFunctions, function: FunctionProgram, count: int,
          precision: Precision) -> list[NDArray[np.floating]]:
    """Arguments: half of them ordinary with speeds of every size; the others hard, numbers of all
    sizes, zeros, equal ones and multiples of π / 2.  Quaternions have norm 1."""
    low, high = LIMITS[precision.name]
    hard = rng.random(count) < 0.5
    scale = np.where(hard, np.exp2(rng.integers(low, high, count)), 10**rng.uniform(-6, 3, count))
    results = []
    for a in function.program.inputs:
        x = rng.uniform(-3, 3, (count, a.quantity.size))
        if a.name == "p":
            x = np.array([value for _, value in scene.parameters]) * (1 + abs(x) / 16)
        else:
            turned = a.name == "q" and rng.random() < 0.8
            x = _hard(rng, x, hard) * (1 if turned else scale[:, None])
        if a.name == "q":
            for c in scene.coordinates:
                if c.kind in ("free", "spherical"):
                    part = rng.normal(size=(count, 4))
                    x[:, c.q.stop - 4:c.q.stop] = part / np.linalg.norm(part, axis=1)[:, None]
        x = abs(x) if a.name in ("t", "h") else x
        results.append(x.reshape(count, *a.quantity.shape).astype(precision.numpy_type))
    return results


def _hard(rng: np.random.Generator, x: Array, hard: NDArray[np.bool_]) -> Array:
    """The rows that are hard with zeros, numbers twice, ones, and multiples of π / 2."""
    kind = rng.integers(0, 12, x.shape)
    chosen = (kind == 0, kind == 1, kind == 2, kind == 3)
    special = np.select(chosen, (0, np.roll(x, 1, axis=1), 1, np.pi / 2 * np.rint(x)), x)
    return np.where(hard[:, None], special, x)


def attacked(scene: SceneFunctions, function: FunctionProgram, certified: object, judge: quad.Judge,
             precision: Precision, count: int, seed: int) -> Found:
    """A batch of states."""
    rng = np.random.default_rng([seed, precision.bytes, *function.name.encode()])
    given = drawn(rng, scene, function, count, precision)
    results, bounds = (flat(x, count).astype(float) for x in _halves(certified(*given)))
    with np.errstate(all="ignore"):
        stated = np.isfinite(bounds)
        ratios = judge(flat(tuple(given), count), results, np.where(stated, bounds, 0))
    ratios = ratios[stated]
    return Found(ratios.size, int((~stated).sum()), int((~(ratios <= 1)).sum()),
                 float(np.max(ratios, initial=0)))


def _halves(results: tuple[object, ...]) -> tuple[tuple[object, ...], tuple[object, ...]]:
    """Results and bounds."""
    return results[:len(results) // 2], results[len(results) // 2:]


def of_scene(plain: Kernels, outputs: int, folder: Path, processes: int
             ) -> Iterator[tuple[str, str, Found]]:
    """Attacks each function in each precision, on at least so many outputs."""
    for function in plain.functions.functions:
        if function.internal or not function.program.instructions:
            continue
        judge = quad.judge(function.program, folder)
        states = -(-outputs // len(function.program.results))
        batches = [min(BATCH, states - n) for n in range(0, states, BATCH)]
        for p in PRECISIONS:
            certified = getattr(getattr(plain.certified, p.name), function.name)
            with ThreadPoolExecutor(processes) as pool:
                parts = pool.map(partial(attacked, plain.functions, function, certified, judge, p),
                                 batches, range(len(batches)))
                yield function.name, p.name, sum(parts, Found())


def of_free_joint(outputs: int, seed: int = 0) -> Iterator[tuple[str, str, Found]]:
    """Attacks moved free joints, on about so many outputs of each precision."""
    plain = kernels("wingnut", ("integrated",))
    for p in PRECISIONS:
        kernel, result = getattr(plain.certified, p.name).integrated, Found()
        rng = np.random.default_rng([seed, p.bytes])
        for start in range(0, outputs, 7 * BATCH):
            count = min(BATCH, -(-(outputs - start) // 7))
            given = free_motion.drawn(rng, count, np.dtype(p.numpy_type).type)
            with np.errstate(all="ignore"):
                results, bounds = kernel(*given)
            ratios = free_motion.ratios(given, results, bounds)
            result += Found(ratios.size, results.size - ratios.size, int((~(ratios <= 1)).sum()),
                            float(np.max(ratios, initial=0)))
        yield "integrated", p.name, result


def main() -> None:
    """Print the table and its sum."""
    parser = argparse.ArgumentParser(description="Attack certified bounds of scenes' functions.")
    parser.add_argument("--outputs", type=int, default=150_000,
                        help="at least, per function and precision")
    parser.add_argument("--scene", nargs="+", default=[*SCENES, *ARMS], choices=[*SCENES, *ARMS])
    parser.add_argument("--processes", type=int, default=os.cpu_count())
    options = parser.parse_args()
    table, total = [], Found()
    for name in (*options.scene, "free joint"):
        with tempfile.TemporaryDirectory() as folder:
            result = of_free_joint(5 * options.outputs) if name == "free joint" else of_scene(
                kernels(name), options.outputs, Path(folder), options.processes)
            for function, precision, x in result:
                table.append((name, function, precision, x.outputs, x.silent, x.in_words,
                              x.broken))
                total += x
    print(tabulate(table, ("scene", "function", "precision", "outputs", "no statement",
                           "error / bound", "broken"), disable_numparse=True))
    print(f"{total.outputs} outputs with a statement, {total.silent} without; "
          f"{total.broken} bounds broken; worst error / bound {total.in_words}")


if __name__ == "__main__":
    main()
