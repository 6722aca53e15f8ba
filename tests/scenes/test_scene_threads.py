"""Threads that share a call's states wait between calls: several callers at once, processes that
fork, threads that cannot be started, rounding, signals; and without a race."""

import multiprocessing
import subprocess
import sys
import threading
import warnings
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen.render import render
from coscrew_codegen.simulate import lanes
from coscrew_codegen.simulate.load import Kernels, kernels_of
from tests.support.compiled.c_harness import C11, COMPILERS, STRICT, run
from tests.support.compiled.flags import SANITIZERS, has_sanitizers
from tests.support.scenes.generated_scenes import slider
from tests.support.scenes.scene_values import same_bits

DRIVER = Path(__file__).parents[1] / "support" / "compiled" / "threads_driver.c"
RACES = ("-fsanitize=thread", "-O1")
DEADLOCK = 600  # seconds, after which a process is held to wait for ever
STATES = 5000


@cache
def finds_races(compiler: str) -> bool:
    """Whether programs with this compiler's sanitizer of threads run here."""
    if not has_sanitizers(compiler):
        return False
    command = (compiler, *RACES, "-x", "c", "-", "-o", "/dev/null")
    return not subprocess.run(command, input="int main(void) { return 0; }", text=True,
                              capture_output=True).returncode


BUILDS = (*((x, ("-O2",)) for x in COMPILERS),
          *((x, SANITIZERS) for x in COMPILERS if has_sanitizers(x)),
          *((x, RACES) for x in COMPILERS if finds_races(x)))


@pytest.mark.parametrize("compiler, flags", BUILDS, ids=str)
def test_threads_keep_what_they_promise(compiler: str, flags: tuple[str, ...], tmp_path: Path):
    (tmp_path / "threads.c").write_text(render("scene/threads") + render("scene/share"))
    run((compiler, *C11, *STRICT, *flags, "-I", tmp_path, DRIVER, "-o", tmp_path / "driver",
         "-lm", "-pthread"))
    unforked = () if flags == ("-O2",) else ("unforked",)  # sanitizers know no threads of children
    assert run((tmp_path / "driver", *unforked)) == ""


@pytest.fixture(scope="module")
def kernels(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Kernels]:
    """The slider's kernels, which compute in lanes from the first state on."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
        patch.setattr(lanes, "PAYS", 1)
        made = kernels_of(slider())
        made.double.forward_dynamics(*given(0), threads=2)
        yield made


def given(seed: int) -> list[np.ndarray]:
    """Arguments of forward dynamics: t, p, q, v, tau."""
    draw = np.random.default_rng(seed)
    return [draw.uniform(0.1, 2, (STATES, *shape)) for shape in ((), (2,), (2,), (2,), (2,))]


def test_callers_at_once_share_threads(kernels: Kernels):
    function = kernels.double.forward_dynamics
    rows = [given(k) for k in range(8)]
    wanted = [function(*x) for x in rows]
    with ThreadPoolExecutor(8) as pool:
        for threads in (2, 3, 4):
            found = pool.map(lambda x, count=threads: function(*x, threads=count), 10 * rows)
            assert all(map(same_bits, found, 10 * wanted))


@pytest.mark.skipif("fork" not in multiprocessing.get_all_start_methods(), reason="nothing forks")
@pytest.mark.parametrize("computing", (False, True), ids=("waiting", "computing"))
def test_forked_processes_start_their_own(kernels: Kernels, computing: bool):
    """Whether or not another thread of the parent computes when it forks."""
    function, rows = kernels.double.forward_dynamics, given(3)
    wanted, told = function(*rows), threading.Event()

    def child() -> None:
        sys.exit(not same_bits(function(*rows, threads=3), wanted)
                 or threads_here() not in (3, None))

    def compute() -> None:
        while not told.is_set():
            function(*rows, threads=2)

    other = threading.Thread(target=compute)
    if computing:
        other.start()
    try:
        assert [exit_code(child) for _ in range(10)] == [0] * 10
        assert same_bits(function(*rows, threads=2), wanted)
    finally:
        told.set()
        if computing:
            other.join()


def threads_here() -> int | None:
    """This process's threads; None where the system does not tell."""
    here = Path("/proc/self/task")
    return len([*here.iterdir()]) if here.exists() else None


def exit_code(child: Callable[[], None]) -> int | None:
    """What a forked process exits with; None if it waits for ever."""
    process = multiprocessing.get_context("fork").Process(target=child)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # Python 3.12's, of threads
        process.start()
    process.join(DEADLOCK)
    process.kill()
    return process.exitcode
