"""Converts recordings of runs and batches to xarray's and pandas' tables, and to HTML for
notebooks."""

import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import replace
from html import escape
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING

import numpy as np

from coscrew_codegen.program.scene_functions import SceneInterface
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.checkpoint import Checkpoint
from coscrew_codegen.simulation.plan import Stop
from coscrew_codegen.simulation.recordings.recording import Recording

if TYPE_CHECKING:
    import pandas
    import xarray

_MOST_DRAWN = 20  # members of a batch


def to_xarray(recording: Recording, failed: Sequence[Stop], of: SceneInterface, start: Checkpoint
              ) -> "xarray.Dataset":
    """A variable for each column; of a batch, coordinates for causes and for parameters and state
    of each member's start.  Raises SimulateError if xarray is lacking."""
    made, batch = _needed("xarray").Dataset, recording.values.ndim > 2
    axes = ("member", "t") if batch else ("t",)
    results = {c.name: (axes, recording.values[..., i], {"units": c.unit})
               for i, c in enumerate(recording.columns)}
    places: dict[str, object] = {"t": ("t", recording.t, {"units": "s"})}
    if batch:
        causes = {x.member: x.cause for x in failed}
        members = range(len(recording.values))
        places |= {"member": list(members),
                   "cause": ("member", np.array([causes.get(i, "") for i in members], np.str_))}
        places |= {name: ("member", np.broadcast_to(x, len(members)).copy())
                   for name, x in _starts(of, start)}
    table: xarray.Dataset = made(results, places, dict(recording.provenance))
    return table


def _starts(of: SceneInterface, start: Checkpoint) -> Iterator[tuple[str, np.ndarray]]:
    """Names and values of parameters and of the state at the start, one for all members or one for
    each."""
    for i, (name, _) in enumerate(of.parameters):
        yield f"p.{name}", start.p[..., i]
    for c in of.coordinates:
        for kind, values, places in (("q0", start.q, c.q), ("v0", start.v, c.v)):
            for n, place in enumerate(places):
                yield f"{kind}.{c.joint}" + (f".{n}" if len(places) > 1 else ""), values[..., place]


def to_pandas(recording: Recording) -> "pandas.DataFrame":
    """A row for each sample; units in `attrs`.  Raises SimulateError if pandas is lacking."""
    its, values = _needed("pandas"), recording.values
    index = its.Index(recording.t, name="t")
    if values.ndim > 2:
        index = its.MultiIndex.from_product((range(len(values)), recording.t),
                                               names=("member", "t"))
    table: pandas.DataFrame = its.DataFrame(
        values.reshape(-1, values.shape[-1]), index, [c.name for c in recording.columns])
    table.attrs = {"units": {c.name: c.unit for c in recording.columns},
                   **dict(recording.provenance)}
    return table


def html(title: str, batch: Recording, failed: Sequence[Stop]) -> str:
    """A heading, a plot of a batch's first members, and the provenance."""
    from coscrew_codegen.simulation.recordings.recording_plot import plot  # imports Matplotlib

    drawn = [replace(batch, values=x) for x in batch.values[:_MOST_DRAWN]]
    with tempfile.TemporaryDirectory() as folder:
        picture = Path(folder) / "run.svg"
        plot(drawn, picture, members=True)
        text = picture.read_text(encoding="utf-8")
    shown = f", the first {_MOST_DRAWN} drawn" if len(batch.values) > len(drawn) else ""
    entries = [*batch.provenance, *((f"member {x.member}", x.cause) for x in failed)]
    rows = "".join(f"<tr><th>{escape(what)}</th><td>{escape(value)}</td></tr>"
                   for what, value in entries)
    return (f"<p>{escape(title)}{shown}</p>{text[text.index('<svg'):]}"
            f"<details><summary>origin</summary><table>{rows}</table></details>")


def _needed(name: str) -> ModuleType:
    from importlib import import_module

    try:
        return import_module(name)
    except ImportError:
        raise SimulateError(f"this needs {name}; run `pip install \"coscrew[sweep]\"`") from None
