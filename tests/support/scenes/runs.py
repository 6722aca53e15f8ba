"""Compares runs of scenes with reference values, and bounds their errors in both precisions.

The figures of one quantity ("v", "pose") form a vector, whose error is that of its worst component.
Each run is compared with one of finer steps (half as long; tolerances a thousandth as large), whose
error may be

    |coarse - fine| + 2 n u A.

The first term: methods of order 1 and above at least halve the error.  The second: each of the n
steps rounds every component s of the state by at most u max |s|, and by as much again in its own
arithmetic; by the end such errors grow to A = Σ |∂x/∂s| max |s|, with the derivatives at the start.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.scene.recorded_quantities import expected
from coscrew_codegen.simulation.plan import Plan, Trajectory
from coscrew_codegen.simulation.recordings.record import quantity
from coscrew_codegen.simulation.run import integrate
from coscrew_codegen.simulation.system import System, system
from tests.references.figures import Figure

ROUNDOFF = {"double": 2.0**-53, "single": 2.0**-24}
NUDGE = 1e-6  # relative change of the start for the derivatives
FINER = {"rk4": 2, "dop853": 1000}


@dataclass(frozen=True)
class Compared:
    """One quantity's largest error over the figures, and its bound."""

    quantity: str
    error: float
    integration: float  # |coarse - fine|
    rounding: float  # 2 n u A

    @property
    def bound(self) -> float:
        """The bound on the error."""
        return self.integration + self.rounding


def compared(kernels: Kernels, figures: Sequence[Figure], precision: str, integrator: str,
             step: float) -> tuple[Compared, ...]:
    """Quantity by quantity; `step` is the coarse run's step, or its tolerance."""
    its = system(kernels, precision)
    coarse, _ = values(its, figures, integrator, step)
    fine, trajectory = values(its, figures, integrator, step / FINER[integrator])
    rounding = 2 * trajectory.steps * ROUNDOFF[precision] * _growth(kernels, figures, trajectory)
    exact = np.array([float(x.value) for x in figures])
    return tuple(Compared(name, *(float(np.max(np.abs(x[these]))) for x in (
        fine - exact, coarse - fine, rounding))) for name, these in _groups(figures).items())


def values(its: System, figures: Sequence[Figure], integrator: str, step: float,
           start: tuple[np.ndarray, np.ndarray] | None = None) -> tuple[np.ndarray, Trajectory]:
    """The quantities of the figures, at their times.  (len(figures))."""
    times = sorted({float(x.at) for x in figures})
    planned = Plan(times[-1], times[-1], integrator, step, step, step, tuple(times[:-1]))
    trajectory = integrate(its if start is None else _started(its, *start), planned)
    assert not trajectory.stopped, trajectory.stopped
    results = [quantity(its, _at(trajectory, float(x.at)), expected(x.quantity, its.scene))[0, 0]
               for x in figures]
    return np.array(results, float), trajectory


def _at(trajectory: Trajectory, time: float) -> Trajectory:
    near = int(np.argmin(np.abs(trajectory.t - time)))
    assert abs(trajectory.t[near] - time) < 1e-9
    t, q, v = (x[near:near + 1] for x in (trajectory.t, trajectory.q, trajectory.v))
    return Trajectory(t, q, v, 0, 0)


def _started(its: System, q: np.ndarray, v: np.ndarray) -> System:
    """The system with this start."""
    places = its.functions.coordinates
    return replace(its, scene=replace(
        its.scene, start_q={c.joint: tuple(q[c.q.start:c.q.stop]) for c in places},
        start_v={c.joint: tuple(v[c.v.start:c.v.stop]) for c in places}))


def _growth(kernels: Kernels, figures: Sequence[Figure], along: Trajectory) -> np.ndarray:
    """A of each figure, by runs in double precision from starts moved one component at a time."""
    its = system(kernels, "double")
    q, v = its.start()
    step = its.scene.run.step
    plain, _ = values(its, figures, "rk4", step)
    total = np.zeros(len(figures))
    for state, others in ((q, along.q), (v, along.v)):
        for i, largest in enumerate(np.max(np.abs(others), axis=0).astype(float)):
            if not largest:
                continue
            before, state[i] = state[i], state[i] + NUDGE * largest
            moved, _ = values(its, figures, "rk4", step, (q, v))
            state[i] = before
            total += np.abs(moved - plain) / NUDGE
    return total


def _groups(figures: Sequence[Figure]) -> dict[str, list[int]]:
    """Places of the figures by the first word of their quantity."""
    results: dict[str, list[int]] = {}
    for i, x in enumerate(figures):
        results.setdefault(x.quantity.partition(".")[0], []).append(i)
    return results
