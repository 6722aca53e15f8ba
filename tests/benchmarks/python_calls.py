"""What many states of a Panda take from Python: against the same rows from C, in results that are
made or given and from columns of wider arrays; and in two threads.  One state: dynamics.py."""

import ctypes
from collections.abc import Callable, Iterator

import numpy as np
from tabulate import tabulate

from coscrew_codegen.formats import PRECISIONS, Precision
from coscrew_codegen.native.timing import Timing, timed_calls
from coscrew_codegen.scene_functions import Function, SceneFunctions
from coscrew_codegen.simulate import lanes
from coscrew_codegen.simulate.load import Kernels, kernels_of
from coscrew_codegen.targets.scene_text import c_name, many
from tests.benchmarks.scene_lanes import panda
from tests.benchmarks.words import said
from tests.support.scenes.tiers import states

BATCH = 4096
LARGE = 100_000  # for threads
SECONDS = 2.0  # of each comparison


def of_batch(scene: SceneFunctions, kernels: Kernels) -> Iterator[list[str]]:
    """A line for each function and precision: ratios to C."""
    for function in scene.functions:
        for p in PRECISIONS:
            call = getattr(getattr(kernels, p.name), function.name)
            given = [np.ascontiguousarray(x, p.numpy_type)
                     for x in states(scene, function, BATCH, p)]
            call(*given, out=(out := np.empty_like(call(*given))))
            inside = [np.pad(x, ((0, 0), (1, 3)))[:, 1:-3] for x in given]
            c, *python = timed_calls([
                in_c(kernels, function, p, [*given, out]), lambda: call(*given),
                lambda: call(*given, out=out), lambda: call(*inside)], 1e9 * SECONDS)
            yield [function.name, p.name, f"{c.minimum / BATCH:.1f}", *(
                text for x in python for text in (least(x, c), said(x.ratio(c))))]


def in_c(kernels: Kernels, function: Function, precision: Precision, arrays: list[np.ndarray]
         ) -> Callable[[], object]:
    """The call of the function in lanes by itself."""
    found = kernels._lanes.function(c_name(many(kernels.interface), function.name, precision), 0)
    assert found
    words = [ctypes.c_ssize_t(x) for array in arrays for x in (array.ctypes.data, array[0].size)]
    return lambda: found(ctypes.c_ssize_t(BATCH), *words)


def in_threads(scene: SceneFunctions, kernels: Kernels) -> Iterator[list[str]]:
    """A line for each function and precision: one thread to two."""
    for function in scene.functions:
        for p in PRECISIONS:
            call = getattr(getattr(kernels, p.name), function.name)
            given = [np.asarray(x, p.numpy_type) for x in states(scene, function, LARGE, p)]
            out = np.empty_like(call(*given))
            one, two = timed_calls([lambda: call(*given, out=out),
                                    lambda: call(*given, out=out, threads=2)], 1e9 * SECONDS)
            yield [function.name, p.name, f"{one.minimum / LARGE:.1f}", least(one, two),
                   said(one.ratio(two))]


def least(x: Timing, y: Timing) -> str:
    """The ratio of the shortest."""
    return f"{x.minimum / y.minimum:.2f}"


def main() -> None:
    """Print the tables."""
    scene = panda()
    kernels = kernels_of(scene)
    kernels._lanes._met = lanes.PAYS
    heads = [f"{x}{of}" for x in ("made", "out=", "columns") for of in (" / C", "")]
    print(f"\n{BATCH} states of a Panda with its fingers from Python: ns a state from C; ratios of "
          "the shortest to that, and medians (95 % interval) in rounds in which all take turns")
    print(tabulate(of_batch(scene, kernels), ("function", "precision", "C", *heads),
                   disable_numparse=True))
    print(f"\n{LARGE} states: ns a state, and one thread / two, of the shortest and in rounds")
    print(tabulate(in_threads(scene, kernels),
                   ("function", "precision", "one", "one / two", ""), disable_numparse=True))


if __name__ == "__main__":
    main()
