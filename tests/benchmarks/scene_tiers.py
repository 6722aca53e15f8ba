"""Cost of accuracy in a scene: its functions in every tier it has, over arrays of states."""

import time
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
from tabulate import tabulate

from coscrew_codegen import load_scene
from coscrew_codegen.program.values.formats import PRECISIONS
from coscrew_codegen.scene.function_selection import known_tiers, tiers_in_ranges, tiers_on_request
from tests.support.scenes.tiers import states

SCENE = Path(__file__).parents[2] / "examples" / "scenes" / "arm6.toml"
NAMES = ("inverse_dynamics", "forward_dynamics", "mass_matrix", "body_poses")
STATES, ROUNDS = 1000, 100
TIERS = tuple(name for name in known_tiers()
              if name not in (*tiers_on_request(), *tiers_in_ranges()))


def shortest(calls: list[Callable[[], object]]) -> list[float]:
    """The shortest time of each call in ns per state, in rounds in which they take turns."""
    result = [np.inf] * len(calls)
    for _ in range(ROUNDS):
        for k, call in enumerate(calls):
            began = time.perf_counter_ns()
            call()
            result[k] = min(result[k], (time.perf_counter_ns() - began) / STATES)
    return result


def rows() -> Iterator[tuple[str, ...]]:
    """A line for each function, precision and tier: its time, and the ratio to plain's."""
    kernels = load_scene(SCENE, tiers=TIERS, functions=NAMES)
    tiers = {"plain": kernels, **{name: getattr(kernels, name) for name in TIERS[1:]}}
    for function in kernels.functions.functions:
        for p in PRECISIONS:
            given = states(kernels.functions, function, STATES, p)
            calls = {name: getattr(getattr(x, p.name), function.name)
                     for name, x in tiers.items() if function.name in getattr(x, p.name)}
            times = shortest([lambda f=f, x=given: f(*x) for f in calls.values()])
            for name, ns in zip(calls, times, strict=True):
                yield function.name, p.name, name, f"{ns:.0f}", f"{ns / times[0]:.2f}"


def main() -> None:
    """Print the table."""
    print(f"\n{SCENE.name}, arrays of {STATES} states: shortest of {ROUNDS} times")
    print(tabulate(rows(), ("function", "precision", "tier", "ns", "ratio"), disable_numparse=True))


if __name__ == "__main__":
    main()
