"""Threads that share a call's states wait between calls: several callers at once, processes that
fork, threads that cannot be started, rounding, signals; and without a race."""

import multiprocessing
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from pathlib import Path

import pytest

from coscrew_codegen.backends.render import TEMPLATES
from coscrew_codegen.runtime import lanes
from coscrew_codegen.runtime.load import Kernels, kernels_of
from tests.support.compiled.c_harness import C11, COMPILERS, STRICT, run
from tests.support.compiled.flags import SANITIZERS, has_sanitizers
from tests.support.scenes.forks import given
from tests.support.scenes.generated_scenes import slider
from tests.support.scenes.scene_values import same_bits

DRIVER = Path(__file__).parents[1] / "support" / "compiled" / "threads_driver.c"
RACES = ("-fsanitize=thread", "-O1")


@cache
def finds_races(compiler: str) -> bool:
    """Returns whether programs with this compiler's sanitizer of threads run here."""
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
    run((compiler, *C11, *STRICT, *flags, "-I", TEMPLATES, DRIVER, "-o", tmp_path / "driver",
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


def test_callers_at_once_share_threads(kernels: Kernels):
    function = kernels.double.forward_dynamics
    rows = [given(k) for k in range(8)]
    wanted = [function(*x) for x in rows]
    with ThreadPoolExecutor(8) as pool:
        for threads in (2, 3, 4):
            result = pool.map(lambda x, count=threads: function(*x, threads=count), 10 * rows)
            assert all(map(same_bits, result, 10 * wanted))


@pytest.mark.skipif("fork" not in multiprocessing.get_all_start_methods(), reason="nothing forks")
@pytest.mark.parametrize("parent", ("waiting", "computing"))
def test_forked_processes_start_their_own(kernels: Kernels, parent: str):
    """Returns whether or not another thread of the parent computes when it forks; in a process in
    which no other library has threads."""
    run((sys.executable, "-W", "ignore::DeprecationWarning", "-m", "tests.support.scenes.forks",
         parent))
