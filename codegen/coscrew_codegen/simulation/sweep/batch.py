"""Runs the members of a chunk at once, as `coscrew simulate` runs each: with the same loop, the
same bits, and the same reasons for an early end."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.scene.recorded_quantities import recorded
from coscrew_codegen.simulation.batch_inputs import normalize_quaternions
from coscrew_codegen.simulation.check.divergence_monitor import Alarm
from coscrew_codegen.simulation.plan import Stop, plan
from coscrew_codegen.simulation.recordings.record import quantity
from coscrew_codegen.simulation.run import integrate
from coscrew_codegen.simulation.sweep.specification import Conditions
from coscrew_codegen.simulation.system import system


@dataclass(frozen=True)
class Batch:
    """Recorded numbers of members, (times, members), by column; and the members that failed, by
    their place."""

    t: np.ndarray
    recorded: Mapping[str, np.ndarray]
    failed: Mapping[int, Stop]


def run(kernels: Kernels, conditions: Conditions, p: np.ndarray, q: np.ndarray, v: np.ndarray
        ) -> Batch:
    """Runs the members with these parameters and starts, one row for each."""
    its = system(kernels, conditions.precision, dict(conditions.settings)).at(p)
    planned = plan(its, conditions.until, conditions.step, conditions.integrator, conditions.every)
    start = normalize_quaternions(its, q).astype(its.dtype), v.astype(its.dtype)
    trajectory = integrate(its, planned, None, Alarm, start)
    if trajectory.interrupted:
        raise KeyboardInterrupt
    columns: dict[str, np.ndarray] = {}
    for x in (recorded(text, its.scene) for text in conditions.record):
        values = quantity(its, trajectory, x)
        columns |= {name: np.ascontiguousarray(values[..., i].T) for i, name in enumerate(x.names)}
    return Batch(trajectory.t, columns, {x.member: x for x in trajectory.failed})
