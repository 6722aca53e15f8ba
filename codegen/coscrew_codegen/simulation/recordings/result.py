"""Result of `run`: one run or a batch, as arrays, tables, plots and files."""

from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from coscrew_codegen.backends.html.framed_page import FramedPage
from coscrew_codegen.scene.names import or_mean
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.checkpoint import Checkpoint, end_of
from coscrew_codegen.simulation.plan import Plan, Stop, Trajectory
from coscrew_codegen.simulation.recordings import recording_writer
from coscrew_codegen.simulation.recordings.recording import Provenance, Recording
from coscrew_codegen.simulation.system import System

if TYPE_CHECKING:
    import pandas
    import xarray


class Columns(dict[str, np.ndarray]):
    """Recorded numbers by the names of columns."""

    def __missing__(self, name: str) -> np.ndarray:
        """Raises KeyError, with the columns of a vector of this name or the nearest name."""
        parts = [x for x in self if x.startswith(f"{name}.")]
        raise KeyError(f"{name}: its columns are {', '.join(parts)}" if parts else
                       f"{name!r} is no recorded column (record=[…] of a run adds quantities)"
                       f"{or_mean(name, self)}")


@dataclass(frozen=True, repr=False)
class Result:
    """A run, or a batch of them with a leading axis of members."""

    system: System
    plan: Plan
    trajectory: Trajectory
    recording: Recording
    start: Checkpoint

    @property
    def t(self) -> np.ndarray:
        """Times of samples, in s.  (n)."""
        return self.trajectory.t

    @property
    def q(self) -> np.ndarray:
        """Coordinates.  (…, n, nq)."""
        return self.trajectory.q

    @property
    def v(self) -> np.ndarray:
        """Velocities.  (…, n, nv)."""
        return self.trajectory.v

    @cached_property
    def recorded(self) -> Columns:
        """Recorded numbers, by the names of columns.  Each (…, n)."""
        return Columns((c.name, self.recording.values[..., i])
                       for i, c in enumerate(self.recording.columns))

    @property
    def failed(self) -> tuple[Stop, ...]:
        """(member, t, joint, cause) of each run that stopped before the end."""
        return self.trajectory.failed

    @property
    def end(self) -> Checkpoint:
        """The end, from which another run can continue."""
        controller = dict(self.provenance).get("controller", "")
        return replace(end_of(self.system, self.trajectory, self.start), controller=controller)

    @property
    def provenance(self) -> Provenance:
        """Origin of the numbers: pairs (name, value)."""
        return self.recording.provenance

    def __repr__(self) -> str:
        members = f"{len(self.q)} runs" if self.q.ndim > 2 else "run"
        stopped = f", {len(self.failed)} stopped" if self.failed else ""
        return (f"<{members} of {self.system.scene.name} to t = {self.t[-1]:g} s: "
                f"{len(self.t)} samples{stopped}>")

    def member(self, i: int) -> Recording:
        """Returns the recording of a member of a batch."""
        if self.q.ndim < 3:
            raise SimulateError("member: this is one run; wanted a batch")
        return replace(self.recording, values=self.recording.values[i])

    def to_xarray(self) -> "xarray.Dataset":
        """Returns the recorded numbers as a Dataset: columns with units, over t, and over `member`
        in a batch; there `cause` says why a member stopped, and p.…, q0.… and v0.… hold the start.
        Provenance is in `attrs`. Needs xarray."""
        from coscrew_codegen.simulation.recordings.data_frames import to_xarray

        return to_xarray(self.recording, self.failed, self.system.functions, self.start)

    def to_pandas(self) -> "pandas.DataFrame":
        """Returns the recorded numbers as a table: a row for each t, or each member and t.  Needs
        pandas."""
        from coscrew_codegen.simulation.recordings.data_frames import to_pandas

        return to_pandas(self.recording)

    def _repr_html_(self) -> str:
        """The page that plays the run back, for notebooks; of a batch, a plot with the provenance.
        """
        if self.q.ndim < 3:
            return self.show()._repr_html_()
        from coscrew_codegen.simulation.recordings.data_frames import html

        return html(repr(self), self.recording, self.failed)

    def view(self, path: Path | str, *besides: "Result") -> None:
        """Writes a file that plays the run back in 3D, with others of the same model as ghosts: a
        page (.html), or a recording of Rerun (.rrd) or of Foxglove (.mcap).  Raises SimulateError.
        """
        from coscrew_codegen.simulation.view.view_files import FORMATS, view

        recording_writer.check_target(Path(path), tuple(FORMATS))
        view(_single(path, self, *besides), [Path(path)])

    def show(self, *besides: "Result") -> FramedPage:
        """Returns the page that plays the run back in 3D, as notebooks show it, with others of the
        same model as ghosts.  Raises SimulateError."""
        from coscrew_codegen.simulation.view.page_text import page

        return FramedPage(page(_single("show", self, *besides)))

    def write(self, path: Path | str) -> None:
        """Writes the recording, as `coscrew simulate --output` does.  Raises SimulateError."""
        if self.q.ndim > 2:
            raise SimulateError(f"{path}: wanted one run; got a batch of {len(self.q)}, which "
                                "to_xarray() puts into one table")
        recording_writer.check_target(Path(path), tuple(recording_writer.FORMATS))
        recording_writer.write(self.recording, Path(path))


def _single(argument: Path | str, *results: Result) -> list[Result]:
    """The results with the poses of all bodies.  Raises SimulateError for a batch."""
    from coscrew_codegen.simulation.view.playback import with_poses

    if any(x.q.ndim > 2 for x in results):
        raise SimulateError(f"{argument}: wanted one run; got a batch")
    return [*map(with_poses, results)]
