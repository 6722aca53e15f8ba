"""Times of many states of a Panda from Python: against the same rows from C, in results that are
made or given and from columns of wider arrays, and against a loop of calls of Pinocchio; and in two
threads.  One state: dynamics.py."""

import ctypes
from collections.abc import Callable, Iterator

import numpy as np
import pinocchio as pin
from tabulate import tabulate

from coscrew_codegen.backends.scene.scene_text import c_name, many
from coscrew_codegen.program.scene_functions import FunctionProgram, SceneFunctions
from coscrew_codegen.program.values.formats import DOUBLE, PRECISIONS, Precision
from coscrew_codegen.reports.timing.loop_timing import Timing, timed_calls
from coscrew_codegen.runtime import lanes
from coscrew_codegen.runtime.load import Kernels, kernels_of
from tests.benchmarks.bars import Bar, show
from tests.benchmarks.pinocchio_loops import robot_named
from tests.benchmarks.words import span
from tests.support.scenes.robots import Robot
from tests.support.scenes.tiers import states

BATCH = 4096
FROM_PYTHON, LOOP, THREADS = 1.15, 60, 1.9
"""Python's time / C's, at most; a loop of Pinocchio's calls / ours; one thread's time / two's."""
LARGE = 100_000  # for threads
SECONDS = 2.0  # of each comparison


def of_batch(robot: Robot, kernels: Kernels) -> Iterator[tuple[list[str], list[Bar]]]:
    """A line for each function and precision: ratios to C and to Pinocchio, and bars."""
    scene = robot.functions
    for function in scene.functions:
        for p in PRECISIONS:
            call = getattr(getattr(kernels, p.name), function.name)
            given = [np.ascontiguousarray(x, p.numpy_type)
                     for x in states(scene, function, BATCH, p)]
            call(*given, out=(out := np.empty_like(call(*given))))
            inside = [np.pad(x, ((0, 0), (1, 3)))[:, 1:-3] for x in given]
            calls = [in_c(kernels, function, p, [*given, out]), lambda: call(*given),
                     lambda: call(*given, out=out), lambda: call(*inside)]
            if p is DOUBLE:
                calls.append(loop_of_calls(robot, function.name, given))
            c, made, *rest = timed_calls(calls, 1e9 * SECONDS)
            what, others = f"{function.name}, {p.name}", rest[2:]
            yield ([function.name, p.name, f"{c.minimum / BATCH:.1f}", *(
                text for x in (made, *rest[:2]) for text in (least(x, c), span(x.ratio(c)))),
                *(span(x.ratio(made)) for x in others)],
                [Bar(f"{BATCH} states from Python / from C: {what}", FROM_PYTHON, made.ratio(c),
                     most=True),
                 *(Bar(f"{BATCH} states from Python: loop of pin / {what}", LOOP, x.ratio(made))
                   for x in others)])


def in_c(kernels: Kernels, function: FunctionProgram, precision: Precision, arrays: list[np.ndarray]
         ) -> Callable[[], object]:
    """The call of the function in lanes by itself."""
    result = kernels._lanes.function(c_name(many(kernels.interface), function.name, precision), 0)
    assert result
    words = [ctypes.c_ssize_t(x) for array in arrays for x in (array.ctypes.data, array[0].size)]
    return lambda: result(ctypes.c_ssize_t(BATCH), *words)


def loop_of_calls(robot: Robot, name: str, given: list[np.ndarray]) -> Callable[[], object]:
    """A loop of calls of Pinocchio's wheel over the same states, which keeps no results."""
    model, function = robot.model, {"inverse_dynamics": pin.rnea, "forward_dynamics": pin.aba,
                                    "mass_matrix": pin.crba}[name]
    data = model.createData()
    rows = list(zip([robot.theirs(q) for q in given[0]],
                    *([robot.follow @ x for x in rows] for rows in given[1:]), strict=True))

    def run() -> None:
        for row in rows:
            function(model, data, *row)

    return run


def in_threads(scene: SceneFunctions, kernels: Kernels) -> Iterator[tuple[list[str], Bar]]:
    """A line for each function and precision: one thread to two, and the bar."""
    for function in scene.functions:
        for p in PRECISIONS:
            call = getattr(getattr(kernels, p.name), function.name)
            given = [np.asarray(x, p.numpy_type) for x in states(scene, function, LARGE, p)]
            out = np.empty_like(call(*given))
            one, two = timed_calls([lambda: call(*given, out=out),
                                    lambda: call(*given, out=out, threads=2)], 1e9 * SECONDS)
            ratio = one.ratio(two)
            yield ([function.name, p.name, f"{one.minimum / LARGE:.1f}", least(one, two),
                    span(ratio)],
                   Bar(f"{LARGE} states: one thread / two, {function.name}, {p.name}", THREADS,
                       ratio))


def least(x: Timing, y: Timing) -> str:
    """The ratio of the shortest."""
    return f"{x.minimum / y.minimum:.2f}"


def main() -> list[Bar]:
    """Print the tables."""
    robot = robot_named("panda7")
    kernels = kernels_of(robot.functions)
    kernels._lanes._met = lanes.PAYS
    heads = [f"{x}{of}" for x in ("made", "out=", "columns") for of in (" / C", "")]
    print(f"\n{BATCH} states of a Panda from Python: ns a state from C; ratios of the shortest to "
          "that, and medians (95 % interval) in rounds in which all take turns")
    results = list(of_batch(robot, kernels))
    print(tabulate([row for row, _ in results],
                   ("function", "precision", "C", *heads, "loop of pin / made"),
                   disable_numparse=True))
    print(f"\n{LARGE} states: ns a state, and one thread / two, of the shortest and in rounds")
    threads = list(in_threads(robot.functions, kernels))
    print(tabulate([row for row, _ in threads],
                   ("function", "precision", "one", "one / two", ""), disable_numparse=True))
    return [bar for _, bars in results for bar in bars] + [bar for _, bar in threads]


if __name__ == "__main__":
    show(main())
