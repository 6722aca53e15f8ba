"""Reads from a recording the settings of the run that made it: everything needed to repeat it."""

import json
import re
import warnings
from dataclasses import dataclass
from pathlib import Path

from coscrew_codegen.backends import version
from coscrew_codegen.program.values.formats import BY_NAME
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.checkpoint import START, Checkpoint, checkpoint_in
from coscrew_codegen.simulation.control import Controller
from coscrew_codegen.simulation.execution import RunRequest
from coscrew_codegen.simulation.plan import known, seconds
from coscrew_codegen.simulation.recordings.provenance import ASKED
from coscrew_codegen.simulation.recordings.record import quantities
from coscrew_codegen.simulation.recordings.recording_reader import provenance_of
from coscrew_codegen.simulation.recordings.result import Result


@dataclass(frozen=True)
class RunMetadata:
    """The settings of a recorded run, and its start."""

    precision: str
    until: float
    step: float
    integrator: str
    every: float
    record: tuple[str, ...]
    start: Checkpoint
    scene: str  # its sha256
    controller: str  # its description in provenance
    coscrew: str

    def request(self, controller: Controller | None = None) -> RunRequest:
        """Returns the settings, with the controller, which the recording does not hold."""
        return RunRequest(self.until, self.step, self.integrator, self.every, self.record,
                          start=self.start, controller=controller)

    def refuse(self, scene: Scene, controller: Controller | None) -> None:
        """Raises SimulateError if this scene or controller gives another run; warns if another
        version of coscrew made the recording."""
        if scene.motion_hash != self.scene:
            raise SimulateError(f"again: the recording is of another scene than {scene.name}, or "
                                "the scene has changed since; wanted the scene as it was")
        given = controller.described(scene) if controller else ""
        if given != self.controller:
            raise SimulateError(f"again: controller: wanted {_short(self.controller) or 'none'}; "
                                f"got {_short(given) or 'none'}")
        if self.coscrew != version.described():
            warnings.warn(f"again: the recording is of coscrew {self.coscrew}; this is "
                          f"{version.described()}", RuntimeWarning, stacklevel=3)


def metadata_of(recording: Result | Path | str) -> RunMetadata:
    """Reads the settings from a recording or a Result.  Raises SimulateError, TypeError."""
    if isinstance(recording, Result):
        return _of(dict(recording.provenance), recording.start, "again: the Result")
    if not isinstance(recording, (str, Path)):
        raise TypeError("again: wanted the path of a recording, or a Result; got "
                        f"{type(recording).__name__}")
    path = Path(recording)
    lines = provenance_of(path, "again")
    if START not in lines or ASKED not in lines:
        raise SimulateError(f"again: {path} does not contain the start and the settings of a run; "
                            "wanted a recording of coscrew 0.2.0 or later")
    return _of(lines, checkpoint_in(lines, START, f"again: {path}: its start"), f"again: {path}")


def _short(controller: str) -> str:
    """Returns the provenance's sentence on a controller, with the first digits of the hash alone.
    """
    return re.sub(r"(sha256 .{8}).+", r"\1…", controller)


def _of(lines: dict[str, str], start: Checkpoint, prefix: str) -> RunMetadata:
    names = ("until", "step", "every", "integrator", "record")
    try:
        given, precision = json.loads(lines[ASKED]), lines["precision"]
        settings = {name: given[name] for name in names}
        if precision not in BY_NAME:
            raise ValueError
    except (ValueError, TypeError, KeyError, RecursionError):
        raise SimulateError(f"{prefix}: its settings are not as coscrew writes them") from None
    try:
        until, step, every = (seconds(name, settings[name]) for name in names[:3])
        integrator, record = known(settings["integrator"]), quantities(settings["record"])
    except SimulateError as error:
        raise SimulateError(f"{prefix}: {error}") from None
    return RunMetadata(precision, until, step, integrator, every, record, start,
                       lines.get("scene sha256", ""), lines.get("controller", ""),
                       lines.get("coscrew", ""))
