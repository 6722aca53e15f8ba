"""A program that forks after the slider's functions have computed in several threads, and exits
with 0 if its children have the bits of one thread, and threads of their own.  Its argument: whether
the parent is `waiting` or `computing` when it forks."""

import multiprocessing
import sys
import threading
from collections.abc import Callable
from pathlib import Path

import numpy as np

from coscrew_codegen.runtime import lanes
from coscrew_codegen.runtime.load import kernels_of
from tests.support.scenes.generated_scenes import slider
from tests.support.scenes.scene_values import same_bits

DEADLOCK = 600  # seconds, after which a process is held to wait for ever
STATES = 5000


def given(seed: int) -> list[np.ndarray]:
    """Arguments of forward dynamics: t, p, q, v, tau."""
    draw = np.random.default_rng(seed)
    return [draw.uniform(0.1, 2, (STATES, *shape)) for shape in ((), (2,), (2,), (2,), (2,))]


def main(computing: bool) -> None:
    """Fork ten times."""
    lanes.PAYS = 1
    function, rows = kernels_of(slider()).double.forward_dynamics, given(3)
    stop = threading.Event()
    wanted = function(*rows)
    assert same_bits(function(*rows, threads=2), wanted)

    def child() -> None:
        sys.exit(not same_bits(function(*rows, threads=3), wanted)
                 or threads_here() not in (3, None))

    def compute() -> None:
        while not stop.is_set():
            function(*rows, threads=2)

    other = threading.Thread(target=compute)
    if computing:
        other.start()
    try:
        assert [exit_code(child) for _ in range(10)] == [0] * 10
        assert same_bits(function(*rows, threads=2), wanted)
    finally:
        stop.set()
        if computing:
            other.join()


def threads_here() -> int | None:
    """This process's threads; None where the system does not tell."""
    here = Path("/proc/self/task")
    return len([*here.iterdir()]) if here.exists() else None


def exit_code(child: Callable[[], None]) -> int | None:
    """Exit code of a forked process; None if it waits for ever."""
    process = multiprocessing.get_context("fork").Process(target=child)
    process.start()
    process.join(DEADLOCK)
    process.kill()
    return process.exitcode


if __name__ == "__main__":
    main(sys.argv[1] == "computing")
