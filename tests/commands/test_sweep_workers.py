"""`coscrew sweep` on workers that lack something: one error says what, and which worker."""

import platform
from pathlib import Path

import pytest

from tests.support.scenes.simulated import scene_file
from tests.support.scenes.sweeps import SLIDER
from tests.support.sweeping import awaited, dask, sweep

ALONE = """
import sys
sys.meta_path[:] = [x for x in sys.meta_path if "editable" not in repr(x)]
"""
"""A process that finds no package of an editable installation."""


@pytest.fixture(scope="module")
def scene(tmp_path_factory) -> Path:
    return scene_file(tmp_path_factory.mktemp("scene"), SLIDER, "slider")


@pytest.mark.parametrize(("environment", "largest", "said"), (
    ({}, 1000, "cannot use its disk: File too large"),
    ({"CC": "no-such-compiler"}, None, "cannot compile the scene, as this command can: no C "
     "compiler: no-such-compiler cannot be run"),
    ({"CC": "cc -include no-such-header"}, None, "cannot compile the scene, as this command can: ")
), ids=("a full disk", "no compiler", "a compiler that fails"))
def test_what_a_worker_cannot_do_is_told(environment, largest, said, scene, tmp_path, capsys):
    """Its cache is empty, and it must compile."""
    own = {"XDG_CACHE_HOME": str(tmp_path), **environment}
    with dask("scheduler", tmp_path, "--port", "0", "--host", "127.0.0.1") as scheduler:
        address = awaited(scheduler, r"Scheduler at: +(\S+)")
        with dask("worker", tmp_path, address, "--no-nanny", "--nthreads", "1", environment=own,
                  largest=largest):
            assert sweep(scene, tmp_path / "out", address) == 2
    (line,) = (x for x in capsys.readouterr().err.splitlines() if "the worker" in x)
    assert f"coscrew: the worker on {platform.node()} {said}" in line
    assert line.endswith("; 0 of 600 members are written, and the same command goes on")


def test_a_worker_without_coscrew_is_told(scene, tmp_path, capsys):
    """It is not killed by what it receives, which the command would await for ever."""
    (tmp_path / "sitecustomize.py").write_text(ALONE)
    with dask("scheduler", tmp_path, "--port", "0", "--host", "127.0.0.1") as scheduler:
        address = awaited(scheduler, r"Scheduler at: +(\S+)")
        with dask("worker", tmp_path, address, "--no-nanny", "--nthreads", "1",
                  environment={"PYTHONPATH": str(tmp_path)}):
            assert sweep(scene, tmp_path / "out", address) == 2
    assert ("a worker lacks what this command has: No module named 'coscrew_codegen'; install the "
            "same coscrew[sweep] on both; 0 of 600 members") in capsys.readouterr().err
