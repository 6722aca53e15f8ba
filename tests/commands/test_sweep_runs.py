"""`coscrew sweep` on real workers: its files; killed workers, a lost scheduler, a full disk, two
sweeps into one folder, Ctrl-C: no written file is lost, and the same command continues."""

import json
import os
import re
import resource
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import replace
from pathlib import Path

import numpy as np
import pyarrow.parquet
import pytest
from distributed import Client, LocalCluster, WorkerPlugin

from coscrew_codegen.__main__ import main
from coscrew_codegen.cli import command_line, sweep_command
from coscrew_codegen.simulation.sweep import SweepError, chunk, cluster, opened
from tests.support.processes import interruptible
from tests.support.sweeping import VARIED, after, awaited, dask, processes, sweep, table

CHUNKS, MEMBERS = 10, 600

pytestmark = pytest.mark.usefixtures("small_chunks")


@pytest.fixture(scope="module")
def workers() -> Iterator[LocalCluster]:
    """Two processes."""
    with processes(2) as result:
        yield result


@pytest.fixture(scope="module")
def whole(scene, tmp_path_factory) -> Path:
    """The folder of a sweep by processes of the command's own."""
    out = tmp_path_factory.mktemp("sweeps") / "whole"
    assert main(["sweep", str(scene), *VARIED, "--workers", "1", "--out", str(out)]) == 0
    return out


def test_the_dataset_is_of_all_members_with_provenance(whole):
    result = table(whole)
    assert sorted(x.name for x in whole.iterdir()) == [
        ".lock", "members", "summary.html", "sweep.json", "sweep.zarr", "sweep.zarr.sha256"]
    assert len(list((whole / "members").iterdir())) == CHUNKS
    assert result["member"].to_pylist() == list(range(MEMBERS))
    description = json.loads((whole / "sweep.json").read_text())
    inside = json.loads(result.schema.metadata[b"coscrew"])
    assert inside == description["provenance"] and inside["sweep sha256"] == description["sha256"]
    assert {"scene sha256", "compiler", "coscrew", "numpy", "scipy"} <= set(inside)
    assert description["specification"]["varied"]["seed"] == 0


def test_xarray_sees_grids_as_dimensions(whole):
    result, rows = opened(whole), table(whole)
    assert dict(result.sizes) == {"sample": 200, "block.mass": 3}
    assert result["block.mass"].values.tolist() == [1, 4, 7]
    for name in ("q.slide.final", "v.slide.mean", "member"):
        assert np.array_equal(result[name].values.ravel(), rows[name].to_numpy())
    assert np.array_equal(result["start.q.slide"].values, rows["start.q.slide"].to_numpy()[::3])
    one = result["q.slide.final"].sel({"block.mass": 4})
    assert np.array_equal(one.values, rows["q.slide.final"].to_numpy()[1::3])
    assert one.attrs["units"] == "m" and not result["failed"].values.any()
    assert result["block.mass"].attrs["units"] == "kg"
    assert result["start.q.slide"].attrs["units"] == "m"
    assert result.attrs["coscrew"] == json.loads((whole / "sweep.json").read_text())["provenance"]


def test_the_page_is_self_contained_and_shows_what_explains_the_motion(whole):
    text = (whole / "summary.html").read_text("utf-8")
    assert text.count("<figure><svg ") == 10  # of each column: distribution, three axes, two
    assert not re.findall(r"(?:src|href)=\"(?!data:|#)", text)
    assert "block.mass: a grid of 3 from 1 to 7 kg" in text
    assert "start.q.slide: sampled from -20 to 200 m" in text
    (row,) = re.findall(r"q\.slide \[m\] *</td><td> *final *</td>(.*?)</tr>", text)
    shares = [int(x) for x in re.findall(r"(\d+) %", row)]
    assert shares[1] > 95 > 5 > shares[0]  # start.q.slide; the mass


def test_a_killed_worker_is_replaced_and_its_chunk_repeated(scene, workers, whole, tmp_path):
    with Client(workers) as client:
        client.register_plugin(Killing(str(tmp_path / "killed")), name="killing")
        try:
            assert sweep(scene, tmp_path / "out", workers) == 0
        finally:
            client.unregister_worker_plugin("killing")
    assert (tmp_path / "killed").exists()
    assert table(tmp_path / "out").equals(table(whole))


class Killing(WorkerPlugin):
    """Kills the first worker that begins a chunk, as the system does when memory is full."""

    def __init__(self, mark: str):
        self.mark = mark

    def setup(self, worker: object) -> None:
        pass

    def transition(self, key: object, start: str, finish: str, **others: object) -> None:
        if finish == "executing" and str(key).startswith("coscrew-"):
            try:
                os.close(os.open(self.mark, os.O_CREAT | os.O_EXCL))
            except FileExistsError:
                return
            os.kill(os.getpid(), signal.SIGKILL)


def test_a_lost_scheduler_ends_the_command_and_another_goes_on(scene, workers, whole, tmp_path,
                                                               monkeypatch, capsys):
    monkeypatch.setattr(cluster, "_PATIENCE", "1s")
    with dask("scheduler", tmp_path, "--port", "0", "--host", "127.0.0.1") as scheduler:
        address = awaited(scheduler, r"Scheduler at: +(\S+)")
        with (dask("worker", tmp_path, address, "--no-nanny", "--nthreads", "1"),
              after(2, lambda: (scheduler.kill(), scheduler.wait()))):
            assert sweep(scene, tmp_path / "out", address) == 2
    output = capsys.readouterr().err
    assert "the scheduler is gone; 128 of 600 members are written into " in output
    before = kept(tmp_path / "out")
    assert sweep(scene, tmp_path / "out", workers) == 0
    assert "600 members, 128 of them written" in capsys.readouterr().err
    assert before == {name: x for name, x in kept(tmp_path / "out").items() if name in before}
    assert table(tmp_path / "out").equals(table(whole))
    assert sweep(scene, tmp_path / "none", "tcp://127.0.0.1:9") == 2
    assert "--scheduler tcp://127.0.0.1:9: " in capsys.readouterr().err


def kept(out: Path) -> dict[str, tuple[int, int]]:
    """The files of chunks, and which they are."""
    return {x.name: (x.stat().st_ino, x.stat().st_mtime_ns)
            for x in sorted((out / "members").iterdir())}


def test_a_full_disk_ends_the_command_and_leaves_no_half_file(scene, workers, whole, tmp_path,
                                                              capsys):
    out = tmp_path / "out"
    with file_size() as limited, after(3, limited):
        assert sweep(scene, out, workers) == 2
    output = capsys.readouterr().err
    assert re.search(rf"cannot write {out}/members/part-0000000\d.parquet: File too large; 192 of "
                     "600 members are written", output)
    assert len(kept(out)) == 3 and not list(out.rglob(".*.part"))
    for path in (out / "members").iterdir():
        assert pyarrow.parquet.read_metadata(path).num_rows == 64
    assert sweep(scene, out, workers) == 0
    assert table(out).equals(table(whole))


@contextmanager
def file_size():
    """Yields a function after which this process cannot write files of more than 1000 bytes."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    try:
        yield lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (1000, before[1]))
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


HOLDS = """
import sys
from pathlib import Path
from coscrew_codegen.simulation.sweep.files.lock import held
with held(Path(sys.argv[1]), wait=True) as mine:
    print(mine, flush=True)
    sys.stdin.read()
"""


def test_two_sweeps_into_one_folder(scene, workers, whole, tmp_path, capsys):
    out = tmp_path / "out"
    out.mkdir()
    with subprocess.Popen([sys.executable, "-c", HOLDS, str(out / ".lock")], text=True,
                          stdin=subprocess.PIPE, stdout=subprocess.PIPE) as other:
        assert other.stdout.readline() == "True\n"
        assert sweep(scene, out, workers) == 2
        assert "out: another sweep is running into this folder" in capsys.readouterr().err
        assert [x.name for x in out.iterdir()] == [".lock"]
        other.kill()
    assert sweep(scene, out, workers) == 0  # the lock ended with its process
    assert table(out).equals(table(whole))


def test_a_folder_of_another_sweep_or_of_other_files_is_refused(scene, workers, whole, tmp_path,
                                                                capsys):
    before = kept(whole)
    assert sweep(scene, whole, workers, *VARIED[:-1], "201") == 2
    output = capsys.readouterr().err
    assert "holds another sweep" in output and "they differ in samples (200, 201)" in output
    assert kept(whole) == before
    (tmp_path / "thesis.tex").touch()
    assert sweep(scene, tmp_path, workers) == 2
    assert "holds thesis.tex, and no sweep" in capsys.readouterr().err
    assert [x.name for x in tmp_path.iterdir()] == ["thesis.tex"]


def test_the_same_command_on_a_finished_sweep_computes_nothing(scene, whole, capsys):
    """It asks no scheduler."""
    before = kept(whole)
    assert sweep(scene, whole, "tcp://127.0.0.1:9") == 0
    assert "600 members, 600 of them written" in capsys.readouterr().err
    assert kept(whole) == before


def test_an_interrupt_says_what_is_written(scene, tmp_path):
    out = tmp_path / "out"
    words = [sys.executable, "-m", "coscrew_codegen", "sweep", scene, *VARIED[:-1], "1e8",
             "--workers", "1", "--out", out]
    with interruptible(words, stderr=subprocess.PIPE) as process:
        while not list(out.glob("members/part*")) and process.poll() is None:
            with suppress(subprocess.TimeoutExpired):
                process.wait(0.05)
        process.send_signal(signal.SIGINT)
        message = process.communicate()[1]
    assert process.returncode == 130
    (count,) = re.findall(r"interrupted; (\d+) of 300000000 members are written", message)
    rows = [pyarrow.parquet.read_metadata(x).num_rows for x in (out / "members").iterdir()]
    assert sum(rows) == int(count) and "Traceback" not in message


def test_chunks_are_submitted_in_a_moving_window(workers, scene, whole):
    """At most the requested number is in flight, however many chunks there are."""
    options = command_line._parser("sweep").parse_args(["sweep", str(scene), *VARIED, "--out", "x"])
    its, drawn = sweep_command._prepared(options), 0
    job = chunk.Job.of(its.kernels, its.specification)

    def numbers() -> Iterator[int]:
        nonlocal drawn
        for n in range(10**12):
            drawn += 1
            yield n % CHUNKS

    with Client(workers) as client:
        for n, _ in enumerate(cluster.finished(client, job, numbers(), lambda: 5)):
            assert drawn - n <= 5
            if n == 30:
                break


def test_an_error_of_a_worker_is_told(workers, scene, tmp_path, capsys, monkeypatch):
    of = chunk.Job.of
    monkeypatch.setattr(chunk.Job, "of", lambda *its: replace(of(*its), generator="other"))
    assert sweep(scene, tmp_path / "out", workers) == 2
    text = capsys.readouterr().err
    assert "has another version of coscrew than this command" in text and "0 of 600 members" in text
    assert SweepError.__name__ not in text
