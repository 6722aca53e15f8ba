"""Runs the members of a chunk at once, with the bits that each alone would have."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import cast

import numpy as np

from coscrew_codegen.integrators import named
from coscrew_codegen.scene.recorded import Recorded, recorded
from coscrew_codegen.simulate.load import Kernels
from coscrew_codegen.simulate.plan import plan
from coscrew_codegen.simulate.record import _values
from coscrew_codegen.simulate.run import _KEPT
from coscrew_codegen.simulate.system import State, System, system
from coscrew_codegen.sweep.specification import Conditions


@dataclass(frozen=True)
class Failure:
    """When and where a member's run ended early, and why."""

    t: float
    joint: str
    cause: str


@dataclass(frozen=True)
class Batch:
    """What members record, (times, members), by column; and those that failed, by their place."""

    t: np.ndarray
    recorded: Mapping[str, np.ndarray]
    failed: Mapping[int, Failure]


@dataclass
class _Samples:
    """Samples so far."""

    system: System
    wanted: Sequence[Recorded]
    columns: dict[str, list[np.ndarray]] = field(default_factory=dict)
    failed: dict[int, Failure] = field(default_factory=dict)

    def add(self, t: float, q: np.ndarray, v: np.ndarray) -> None:
        """The states at t."""
        for x in self.wanted:
            values = _values(self.system, x, np.full(len(q), t), q, v)[:, list(x.places)]
            for name, column in zip(x.names, values.T, strict=True):
                self.columns.setdefault(name, []).append(column.astype(self.system.dtype))
        lost = ~(np.isfinite(q).all(1) & np.isfinite(v).all(1))
        for k in np.flatnonzero(lost).tolist():
            if k not in self.failed:
                what = self.system.lacking(q[k], v[k])
                joint = what.removeprefix("joint ").partition(": ")[0]
                self.failed[k] = Failure(t, joint, f"not finite at t = {t:.9g} s or before: {what}")


def run(kernels: Kernels, conditions: Conditions, p: np.ndarray, q: np.ndarray, v: np.ndarray
        ) -> Batch:
    """The runs of members with these parameters and starts, a row each."""
    plain = system(kernels, conditions.precision, dict(conditions.settings))
    its = replace(plain, p=cast("tuple[float, ...]", p))
    planned = plan(its, conditions.until, conditions.step, conditions.integrator, conditions.every)
    samples = _Samples(its, [recorded(text, its.scene) for text in conditions.record])
    with np.errstate(all="ignore"):
        q, v = its.normalized(q).astype(its.dtype), v.astype(its.dtype)
        advance = _advance(its, conditions.integrator, q, v)
        samples.add(0.0, q, v)
        for start, end in pairwise(planned.samples.tolist()):
            q, v = advance(*planned.steps(end - start), start, q, v)
            samples.add(end, q, v)
    columns = {name: np.array(rows) for name, rows in samples.columns.items()}
    return Batch(planned.samples, columns, samples.failed)


def _advance(its: System, name: str, q: np.ndarray, v: np.ndarray
             ) -> Callable[[int, float, float, np.ndarray, np.ndarray], State]:
    """(number, length of steps, t, q, v) -> q and v after them, as `simulate` takes them."""
    integrator = named(name)
    step = its.stepper(integrator.step_name)
    if not (integrator.keeps_momentum and its.has("free_momentum")):
        return lambda count, h, t, q, v: step(count, t, h, q, v)
    c = its.call("free_momentum", q=q, v=v)

    def advance(count: int, h: float, t: float, q: np.ndarray, v: np.ndarray) -> State:
        for i in range(0, count, _KEPT):
            more = min(_KEPT, count - i)
            q, v = step(more, t + i * h, h, q, v)
            v = its.call("with_free_momentum", t=t + (i + more) * h, q=q, v=v, c=c)
        return q, v

    return advance
