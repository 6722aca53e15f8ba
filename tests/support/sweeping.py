"""Sweeps on the workers of a Dask cluster whose processes tests start, stop and impair."""

import logging
import os
import re
import resource
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import IO, cast

import pyarrow
import pyarrow.dataset
import pytest
from distributed import LocalCluster

from coscrew_codegen.__main__ import main
from coscrew_codegen.cli import sweep_command
from coscrew_codegen.simulation.sweep.files.folder import Folder

VARIED = ("--grid", "block.mass=1:7:3", "--sobol", "start.?.slide=limits", "--samples", "200")


def processes(count: int) -> LocalCluster:
    """Starts so many workers."""
    return LocalCluster(n_workers=count, threads_per_worker=1, dashboard_address=None,
                        silence_logs=logging.CRITICAL)


def sweep(scene: Path, out: Path, workers: LocalCluster | str, *words: str) -> int:
    """The command's exit status; without arrays, tables and page, which take seconds."""
    address = workers if isinstance(workers, str) else workers.scheduler_address
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sweep_command, "_report", lambda *_: 0)
        return main(["sweep", str(scene), *(words or VARIED), "--scheduler", address, "--out",
                     str(out)])


def table(out: Path) -> pyarrow.Table:
    """All members of a sweep, as other programs read them."""
    return pyarrow.dataset.dataset(out / "members").to_table()


@contextmanager
def after(chunks: int, do: Callable[[], object]) -> Iterator[None]:
    """Call `do` when so many chunks have been written."""
    write, count = Folder.write, 0

    def counting(self: Folder, number: int, content: bytes) -> None:
        nonlocal count
        write(self, number, content)
        count += 1
        if count == chunks:
            do()

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Folder, "write", counting)
        yield


@contextmanager
def dask(program: str, folder: Path, *words: str, environment: Mapping[str, str] | None = None,
         largest: int | None = None) -> Iterator["subprocess.Popen[str]"]:
    """A scheduler or worker as a process of its own, with further variables of the environment;
    it cannot write files of more than `largest` bytes."""
    def limited() -> None:
        if largest:
            resource.setrlimit(resource.RLIMIT_FSIZE, (largest, largest))

    # Python would leave compiled modules of a few bytes beside its sources
    own = {"PYTHONDONTWRITEBYTECODE": "1"} if largest else {}
    command = [sys.executable, "-m", f"distributed.cli.dask_{program}", *words, "--no-dashboard"]
    process = subprocess.Popen(command, cwd=folder, stderr=subprocess.PIPE, text=True,
                               env={**os.environ, **own, **(environment or {})}, preexec_fn=limited)
    try:
        yield process
    finally:
        process.kill()
        process.wait()
        cast("IO[str]", process.stderr).close()


def awaited(process: "subprocess.Popen[str]", pattern: str) -> str:
    """Waits for output of the process that matches the pattern, and returns it."""
    for line in cast("IO[str]", process.stderr):
        if match := re.search(pattern, line):
            return match[1]
    raise AssertionError(f"{pattern} was not said")
