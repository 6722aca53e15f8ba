"""Sweeps: many runs of a scene with varied parameters and starts, on Dask, into a folder.

    sweep_options    the words of the command line, --grid and --sobol
    candidates       the inputs of a scene that can vary
    specification    the varied inputs: they determine the values of each member, and the hash
    member_values    the values of member k, the same wherever they are computed
    refusals         parameters that the scene's rules refuse, before anything starts
    batch, member_summary   chunks of members run at once, and the numbers kept of them
    single_member    one member alone, as `run` runs it
    chunk            from the number of a chunk to its Parquet file, in a worker
    cluster          workers of this machine or of a cluster; chunks in a moving window
    files/           Parquet files, Zarr and sweep.json with checksums; damaged ones move aside
    statistics/      counts and sums over the members; distributions, heat maps, the page

Knows nothing of how a scene's functions are derived."""

from pathlib import Path
from typing import TYPE_CHECKING

from coscrew_codegen.backends.html.framed_page import FramedPage
from coscrew_codegen.program.reported_error import ReportedError

if TYPE_CHECKING:
    from coscrew_codegen.simulation.sweep.files.zarr_store import opened as opened

__all__ = ["SweepError", "opened", "summary"]


class SweepError(ReportedError, ValueError):
    """The sweep is impossible; the message says what came and what was wanted."""


def summary(folder: Path | str) -> FramedPage:
    """The page that `coscrew sweep` wrote into this folder, for notebooks.  Raises SweepError."""
    if not (page := Path(folder) / "summary.html").is_file():
        raise SweepError(f"{folder}: there is no summary.html; wanted the folder of a finished "
                         "sweep (`coscrew sweep … --out FOLDER` finishes it)")
    return FramedPage(page.read_text(encoding="utf-8"))


def __getattr__(name: str) -> object:
    """Import `opened` on first use: it needs xarray."""
    if name == "opened":
        from coscrew_codegen.simulation.sweep.files.zarr_store import opened

        return opened
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
