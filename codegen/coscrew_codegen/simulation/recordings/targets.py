"""Targets of positions: the formulas that actuators follow, beside the recorded coordinates."""

from collections.abc import Mapping, Sequence

import numpy as np

from coscrew_codegen.program.values.parameter import Parameter
from coscrew_codegen.scene.formulas import Formula
from coscrew_codegen.scene.scene import Setting
from coscrew_codegen.simulation.recordings.recording import Recording
from coscrew_codegen.simulation.system import System

_TARGET = "target"  # the parameter of effects


def targets(system: System, recording: Recording) -> Mapping[str, np.ndarray]:
    """The targets of recorded coordinates over time, by the columns' names; none of a run that
    Python controls, where targets may have changed."""
    if dict(recording.provenance).get("controller"):
        return {}
    recorded = {c.name for c in recording.columns}
    return {name: _over_time(applied.values[_TARGET], recording.t, system.p)
            for applied in system.scene.effects
            if applied.values.get(_TARGET) is not None
            and (name := f"q.{applied.on}") in recorded}


def _over_time(given: Setting, t: np.ndarray, p: Sequence[float] | np.ndarray) -> np.ndarray:
    if isinstance(given, Formula):
        return np.array([given.at(time) for time in t.tolist()])
    value = p[given.index] if isinstance(given, Parameter) else given
    return np.full(len(t), float(value))  # type: ignore[arg-type]  # a target is a number
