"""Runs one member alone: writes the call of `run` that computes it with the same bits, and the
numbers that the sweep keeps of it."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from tabulate import tabulate

from coscrew_codegen.simulation.api import run
from coscrew_codegen.simulation.recordings.result import Result
from coscrew_codegen.simulation.sweep import SweepError, member_values
from coscrew_codegen.simulation.sweep.chunk import states
from coscrew_codegen.simulation.sweep.member_summary import STATISTICS, statistics
from coscrew_codegen.simulation.sweep.prepare import Prepared


@dataclass(frozen=True)
class Alone:
    """A member: its parameters, its start and conditions, as arguments of `run`."""

    p: Mapping[str, float]
    q0: tuple[float, ...]
    v0: tuple[float, ...]
    until: float
    step: float
    integrator: str
    precision: str
    every: float
    record: tuple[str, ...]

    def call(self, scene: Path, implausible: str | None) -> str:
        """The lines of Python that run it."""
        first, imported = repr(str(scene)), "run"
        if implausible:
            first, imported = f"load_scene({first}, implausible={implausible!r})", "load_scene, run"
        given = "".join(f",\n    {name}={value!r}" for name, value in vars(self).items())
        return f"from coscrew_codegen import {imported}\n\nmember = run(\n    {first}{given})"


def member(its: Prepared, number: int) -> Alone:
    """The member of this number.  Raises SweepError if there is none."""
    varied, conditions = its.specification.varied, its.specification.conditions
    if number >= varied.members:
        raise SweepError(f"--member {number}: wanted 0 to {varied.members - 1}")
    result = states(its.kernels, its.specification,
                    member_values.values(varied, range(number, number + 1)))
    p, q, v = (result[name][0].tolist() for name in ("p", "q", "v"))
    names = (name for name, _ in its.kernels.interface.parameters)
    return Alone(dict(zip(names, p, strict=True)), tuple(q), tuple(v), conditions.until,
                 conditions.step, conditions.integrator, conditions.precision, conditions.every,
                 conditions.record)


def result(its: Prepared, alone: Alone) -> Result:
    """The member's run."""
    return run(its.kernels, **vars(alone))


def text(result: Result) -> str:
    """The statistics that the sweep keeps, in all digits, or why it failed."""
    if result.failed:
        return f"failed: {result.failed[0].cause}"
    rows = []
    for column in result.recording.columns:
        kept = statistics(result.t, result.recorded[column.name][:, np.newaxis])
        rows.append((f"{column.name} [{column.unit}]", *(str(kept[x][0]) for x in STATISTICS)))
    return str(tabulate(rows, ("recorded", *STATISTICS), disable_numparse=True))
