"""Sweeps: many runs of a scene with varied parameters and starts, on Dask, into a folder.

    asked            the words of the command line, --grid and --sobol
    candidates       what of a scene can vary
    specification    what varies how: from it follow the values of each member, and its hash
    members          the values of member k, whoever computes them
    refusals         parameters that the scene's rules refuse, before anything starts
    batch, summary   chunks of members run at once, and what is kept of them
    alone            one member by itself, as `run` runs it
    chunk            from the number of a chunk to its Parquet file, in a worker
    cluster          workers of this machine or of a cluster; chunks in a moving window
    part, about      Parquet files and sweep.json with checksums; how they are read
    folder           the files; a lock; what is finished
    aside            damaged files, and what is in the way, are moved into damaged/
    arrays           Zarr, and the view of it by xarray; checked_store compares checksums
    axis, column, tally   counts and sums of which the page is made
    plot, page       distributions and heat maps; tables

Knows nothing of how a scene's functions are derived."""

from typing import TYPE_CHECKING

from coscrew_codegen.errors import ReportedError

if TYPE_CHECKING:
    from coscrew_codegen.sweep.arrays import opened as opened

__all__ = ["SweepError", "opened"]


class SweepError(ReportedError, ValueError):
    """The sweep is impossible; the message says what came and what was wanted."""


def __getattr__(name: str) -> object:
    """Import `opened` on first use: it needs xarray."""
    if name == "opened":
        from coscrew_codegen.sweep.arrays import opened

        return opened
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
