"""Runs the states of a chunk at once."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from coscrew_codegen.integrators import named
from coscrew_codegen.scene.recorded import recorded
from coscrew_codegen.simulate.load import Kernels
from coscrew_codegen.simulate.plan import plan
from coscrew_codegen.simulate.record import _values
from coscrew_codegen.simulate.system import system
from coscrew_codegen.sweep.specification import Conditions


@dataclass(frozen=True)
class Failure:
    """When and where a member's run ended early, and why."""

    time: float
    joint: str
    cause: str


@dataclass(frozen=True)
class Batch:
    """What members record, (number of times, number of members), by column; failed members."""

    t: np.ndarray
    recorded: Mapping[str, np.ndarray]
    failed: Mapping[int, Failure]


def run(kernels: Kernels, conditions: Conditions, p: np.ndarray, q: np.ndarray, v: np.ndarray
        ) -> Batch:
    """The runs of members with these parameters and starts, a row each."""
    c = conditions
    its = replace(system(kernels, c.precision, dict(c.settings)), p=p)
    planned = plan(its, c.until, c.step, c.integrator, c.every)
    step = getattr(its.kernels, named(c.integrator).step_name)
    kinds = [recorded(text, its.scene) for text in c.record]
    rows = {name: [] for x in kinds for name in x.names}
    failed = {}
    times = planned.samples
    q, v = its.normalized(q).astype(its.dtype), v.astype(its.dtype)
    pp = [np.asarray(p, its.dtype)] if its.functions.parameters else []

    def note(t):
        for x in kinds:
            values = _values(its, x, np.full(len(q), t), q, v)[:, list(x.places)]
            for name, column in zip(x.names, values.T, strict=True):
                rows[name].append(column.astype(its.dtype))
        bad = ~(np.isfinite(q).all(1) & np.isfinite(v).all(1))
        for k in np.flatnonzero(bad).tolist():
            if k not in failed:
                lacking = its.lacking(q[k], v[k])
                failed[k] = Failure(float(t), lacking.split(":")[0].removeprefix("joint "), lacking)

    with np.errstate(all="ignore"):
        note(0.0)
        for start, end in pairwise(times):
            count, h = planned.steps(end - start)
            for i in range(count):
                now = [start + i * h] if its.functions.timed else []
                q, v = step(*now, h, *pp, q, v)
            note(end)
    return Batch(times, {name: np.array(x) for name, x in rows.items()}, failed)
