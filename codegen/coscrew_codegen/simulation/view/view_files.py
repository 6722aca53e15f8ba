"""Writes playbacks as files, in the format of their names' endings."""

from collections.abc import Callable, Sequence
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.recordings.recording_reader import columns_of
from coscrew_codegen.simulation.recordings.recording_writer import check_target, delivered

if TYPE_CHECKING:  # which take long to import
    from coscrew_codegen.simulation.recordings.result import Result
    from coscrew_codegen.simulation.view.playback import Playback

FORMATS = {".html": "page_text", ".rrd": "rerun_file", ".mcap": "mcap_file"}
"""Module of each ending, whose `write` takes a playback and a path."""


def view(results: "Sequence[Result]", paths: Sequence[Path], recordings: Sequence[Path] = ()
         ) -> str:
    """Write files that show the first result, with the others and recordings of the same model as
    ghosts; returns what they lack, "" if nothing.  Raises SimulateError."""
    from coscrew_codegen.simulation.view.page_runs import run_in
    from coscrew_codegen.simulation.view.playback import playback

    shown = playback(results, [run_in(x, results[0].system) for x in recordings])
    for path in paths:
        with delivered(path) as temporary:
            _writer(path)(shown, temporary)
    return shown.lacks


def sorted_files(files: Sequence[Path]) -> tuple[list[Path], list[Path]]:
    """The files of `--view` to write, and the recordings to show in them.  Raises SimulateError if
    one cannot be written or read."""
    written = [x for x in files if x.suffix in FORMATS]
    recordings = [x for x in files if x not in written]
    if recordings and not written:
        names = " ".join(map(str, recordings))
        raise SimulateError(f"--view: {names}: these are recordings to show; wanted, before them, "
                            f"a file to write: --view run.html {names}")
    for path in written:
        check_target(path, tuple(FORMATS))
    for path in recordings:
        columns_of(path, "--view")
    return written, recordings


def _writer(path: Path) -> "Callable[[Playback, Path], None]":
    module = import_module(f"{__name__.rpartition('.')[0]}.{FORMATS[path.suffix]}")
    write: Callable[[Playback, Path], None] = module.write
    return write
