"""`coscrew sweep` on workers that lack something, or that are interrupted while they start."""

import os
import platform
import signal
import socket
import subprocess
import sys
import time
from contextlib import suppress

import psutil
import pytest

from coscrew_codegen.__main__ import CLOSED, main
from coscrew_codegen.simulation.sweep import SweepError, cluster
from tests.support.processes import interruptible
from tests.support.sweeping import VARIED, awaited, dask, sweep

ALONE = """
import sys
sys.path[:] = [x for x in sys.path if not x.endswith(("/codegen", "/generated/python"))]
"""
"""A process that finds no package of an editable installation."""


@pytest.mark.parametrize(("environment", "largest", "message"), (
    ({}, 1000, "cannot use its disk: File too large"),
    ({"CC": "no-such-compiler"}, None, "cannot compile the scene, as this command can: no C "
     "compiler: no-such-compiler cannot be run"),
    ({"CC": "cc -include no-such-header"}, None, "cannot compile the scene, as this command can: ")
), ids=("a full disk", "no compiler", "a compiler that fails"))
def test_what_a_worker_cannot_do_is_told(environment, largest, message, scene, tmp_path, capsys):
    """Its cache is empty, and it must compile."""
    own = {"XDG_CACHE_HOME": str(tmp_path), **environment}
    with dask("scheduler", tmp_path, "--port", "0", "--host", "127.0.0.1") as scheduler:
        address = awaited(scheduler, r"Scheduler at: +(\S+)")
        with dask("worker", tmp_path, address, "--no-nanny", "--nthreads", "1", environment=own,
                  largest=largest):
            assert sweep(scene, tmp_path / "out", address) == 2
    (line,) = (x for x in capsys.readouterr().err.splitlines() if "the worker" in x)
    assert f"coscrew: the worker on {platform.node()} {message}" in line
    assert line.endswith(f"; 0 of 600 members are written into {tmp_path / 'out'}; the same "
                         "command continues")


def test_processes_that_start_say_nothing_of_an_interrupt(scene, tmp_path):
    """A terminal sends Ctrl-C to all of them, here as soon as there are two."""
    words = [sys.executable, "-m", "coscrew_codegen", "sweep", scene, *VARIED[:-1], "1e8", "--out",
             tmp_path / "out"]
    with interruptible(words, stderr=subprocess.PIPE, group=True) as process:
        unused, first = process.stderr.readline(), process.stderr.readline()
        its = psutil.Process(process.pid)
        while len(its.children()) < 2:
            time.sleep(0.01)
        os.killpg(process.pid, signal.SIGINT)
        message = process.communicate()[1]
    assert (process.returncode, first) == (130, "coscrew: 300000000 members, 0 of them written\n")
    assert unused.startswith("coscrew: not used: ")
    last = f"interrupted; 0 of 300000000 members are written into {tmp_path / 'out'}; "
    assert message == f"coscrew: {last}the same command continues\n"


def test_a_client_that_cannot_be_closed_hides_no_error(monkeypatch):
    """Closing Dask's client may fail if the scheduler is gone."""
    class Stuck:
        def close(self) -> None:
            raise RuntimeError("Cannot change state of expiring Timeout")

    monkeypatch.setattr("distributed.Client", lambda *given, **named: Stuck())
    with (pytest.raises(SweepError, match="the scheduler is gone"),
          cluster.remote("tcp://127.0.0.1:9")):
        raise SweepError("the scheduler is gone")


def test_a_reader_that_ends_is_no_folder_that_cannot_be_written(scene, tmp_path):
    words = [sys.executable, "-m", "coscrew_codegen", "sweep", scene, *VARIED, "--out",
             tmp_path / "out"]
    reader, writer = os.pipe()
    os.close(reader)
    done = subprocess.run(words, stdout=writer, stderr=subprocess.PIPE, text=True)
    os.close(writer)
    assert (done.returncode, "cannot write" in done.stderr) == (CLOSED, False), done.stderr


def test_no_more_processes_start_than_there_are_chunks(scene, tmp_path, monkeypatch):
    started = []

    def local(workers: int) -> None:
        started.append(workers)
        raise SweepError("enough")

    monkeypatch.setattr(cluster, "local", local)
    assert main(["sweep", str(scene), "--grid", "block.mass=1:7:3", "--workers", "1e6", "--out",
                 str(tmp_path / "out")]) == 2
    assert started == [1]


def test_another_cluster_of_this_machine_is_not_in_the_way(recwarn):
    """Dask's port is taken."""
    with socket.socket() as taken:
        with suppress(OSError):  # taken already
            taken.bind(("127.0.0.1", 8787))
            taken.listen()
        with cluster.local(1) as client:
            assert len(client.nthreads()) == 1
    assert not recwarn.list


def test_a_worker_without_coscrew_is_told(scene, tmp_path):
    """It is not killed by the task that it receives, which the command would await for ever."""
    (tmp_path / "sitecustomize.py").write_text(ALONE)
    with dask("scheduler", tmp_path, "--port", "0", "--host", "127.0.0.1") as scheduler:
        address = awaited(scheduler, r"Scheduler at: +(\S+)")
        with dask("worker", tmp_path, address, "--no-nanny", "--nthreads", "1",
                  environment={"PYTHONPATH": str(tmp_path)}):
            done = subprocess.run([
                sys.executable, "-m", "coscrew_codegen", "sweep", scene, *VARIED, "--scheduler",
                address, "--out", tmp_path / "out"], capture_output=True, text=True, timeout=120)
    assert done.returncode == 2
    assert ("a worker lacks what this command has: No module named 'coscrew_codegen'; install the "
            "same coscrew[sweep] on both; 0 of 600 members") in done.stderr
