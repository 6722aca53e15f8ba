"""Checks a scene's run: the balance of energy, the scene's expectations, the same motion in both
precisions, forward dynamics as the inverse of inverse dynamics."""

import math
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from coscrew_codegen.program.values.formats import BY_NAME
from coscrew_codegen.runtime.lanes import one_by_one
from coscrew_codegen.scene.function_selection import CLOSED
from coscrew_codegen.scene.integrators import DEFAULT, INTEGRATOR_NAMED
from coscrew_codegen.scene.recorded_quantities import expected, recorded
from coscrew_codegen.scene.scene import Expectation
from coscrew_codegen.simulation.check import check_rounding, step_advice
from coscrew_codegen.simulation.check.contact_check import contacts_of, point_distances
from coscrew_codegen.simulation.check.divergence_monitor import Alarm
from coscrew_codegen.simulation.check.energy_balance import Balance, balance, bristles_of
from coscrew_codegen.simulation.check.findings import SECOND_RUN, THIRD_RUN, AlongRun, Findings, Met
from coscrew_codegen.simulation.check.windows import in_double
from coscrew_codegen.simulation.loops.closure_check import closures
from coscrew_codegen.simulation.loops.loop_closing import mobility
from coscrew_codegen.simulation.plan import Plan, Trajectory, plan
from coscrew_codegen.simulation.progress import Progress
from coscrew_codegen.simulation.recordings.record import (
    accelerations,
    differences,
    largest,
    quantity,
)
from coscrew_codegen.simulation.recordings.recording import Column, Recording
from coscrew_codegen.simulation.run import integrate
from coscrew_codegen.simulation.run_summary import RunOverrides, outside
from coscrew_codegen.simulation.system import System, scene_of, system

if TYPE_CHECKING:
    from coscrew_codegen.runtime.load import Kernels

_MOST_STEPS = 200_000  # most samples in the balance of energy
_STATES = 1000  # states along the run at which matrices are checked
_TIGHTER = 16  # divisor of tolerances for the second run


def check(kernels: "Kernels", overrides: RunOverrides, rounding: bool = False) -> Findings:
    """Runs the scene in its precisions, or in the selected one, with its steps and smaller ones.

    Expectations are checked in double precision, unless only single is run.  With `rounding` the
    check also covers rounding errors and certified bounds, for which it compiles functions.  Raises
    SimulateError."""
    with one_by_one():
        return _check(kernels, overrides, rounding)


def _check(kernels: "Kernels", overrides: RunOverrides, rounding: bool) -> Findings:
    scene = scene_of(kernels)
    names = (overrides.precision,) if overrides.precision in BY_NAME else scene.precisions
    runs = {name: _run(kernels, name, overrides) for name in names}
    meant = "single" if (overrides.precision or scene.precision) == "single" else "double"
    its, _, trajectory = runs[meant]
    met = tuple(_met(its, trajectory, x) for x in scene.expectations)
    along = [_along(*run) for run in runs.values()]
    if len(along) == 2:
        along[1] = replace(along[1], double=along[0])
    both = [(x, y) for x, _, y in runs.values()]
    between = differences(*(_sparse(*x) for x in both)) if len(both) == 2 else ()
    judged = check_rounding.rounding(kernels, both) if rounding else ()
    return Findings(met, tuple(along), between, outside(its, its.start()[0]), judged,
                    mobility(its), point_distances(*both) if len(both) == 2 else ())


def _run(kernels: "Kernels", precision: str, overrides: RunOverrides
         ) -> tuple[System, Plan, Trajectory]:
    """A run that is sampled at every step, or less often if no effect has power; with SciPy's
    solvers, equally densely."""
    its = system(kernels, precision, dict(overrides.settings))
    rough = plan(its, overrides.until, overrides.step, overrides.integrator)
    count = max(2, min(math.ceil(rough.until / rough.step), _MOST_STEPS))
    planned = replace(rough, every=rough.until / count,
                      also=tuple(x.at for x in its.scene.expectations))
    if its.zero("power"):
        planned = step_advice.thinned(planned)
    return its, planned, _integrated(its, planned, partial(Alarm, remedy=step_advice.remedy))


def _integrated(system: System, planned: Plan, alarm: Callable[..., Alarm] | None = None
                ) -> Trajectory:
    with Progress(system, planned.until) as watch:
        trajectory = integrate(system, planned, watch, alarm)
    if trajectory.interrupted:
        raise KeyboardInterrupt
    return trajectory


def _met(system: System, trajectory: Trajectory, wanted: Expectation) -> Met:
    component = expected(wanted.quantity, system.scene)
    near = int(np.argmin(np.abs(trajectory.t - wanted.at)))
    came = math.nan
    if abs(trajectory.t[near] - wanted.at) <= 1e-9 * max(1.0, wanted.at):
        one = _chosen(trajectory, np.array([near]))
        came = float(quantity(system, one, component)[0, 0])
    return Met(wanted, came, component.units[0])


def _along(system: System, planned: Plan, trajectory: Trajectory) -> AlongRun:
    compared = step_advice.thinned(planned)
    true = step_advice.reference(system, compared)
    coarse, finer = balance(system, trajectory), _finer(system, planned, SECOND_RUN)
    along = AlongRun(
        system.precision.name,
        f"rtol {planned.rtol:.3g}" if planned.adaptive else f"step {planned.step:g} s",
        trajectory.stopped, coarse, balance(system, finer, trajectory.t), None,
        *_matrices(system, trajectory), INTEGRATOR_NAMED[planned.integrator],
        0.0 if planned.adaptive else planned.step, step_advice.error(system, trajectory, true),
        true.until, true.end, true.step, step_advice.resting(system, true),
        loops=closures(system, trajectory, coarse.scale),
        contacts=contacts_of(system, trajectory, 0.0 if planned.adaptive else planned.step),
        bristles=bristles_of(system, trajectory, coarse.scale)
        if planned.every < 1.5 * planned.step else None)
    if trajectory.stopped:
        return along
    if not planned.adaptive and not (along.shrinks and along.balanced):
        finest = _finer(system, planned, THIRD_RUN)
        along = replace(along, finest=balance(system, finest, trajectory.t))
    if along.right and not along.balanced:
        along = replace(along, exact=_exact(system, planned, true))
    if not along.right:
        along = replace(along, remedy=step_advice.advised(system, compared, true))
    return along


def _exact(system: System, planned: Plan, true: step_advice.ReferenceStep) -> Balance:
    """The balance of energy of the motion in double precision with the smallest steps tried."""
    double = in_double(system)
    return balance(double, _integrated(double, replace(
        planned, integrator=DEFAULT, step=true.step)))


def _finer(system: System, planned: Plan, times: int) -> Trajectory:
    """The run with steps, and parts of split steps, smaller by the factor `times`, and that many
    times more samples."""
    finer = replace(planned, every=planned.every / times)  # so that Simpson's error shrinks, too
    if planned.adaptive:
        finer = replace(finer, rtol=planned.rtol / _TIGHTER, atol=planned.atol / _TIGHTER)
    else:
        finer = replace(finer, step=planned.step / times, finer=times)
    return _integrated(system, finer)


def _matrices(system: System, trajectory: Trajectory) -> tuple[float, float, float]:
    """Error of the round trip in unit roundoffs, largest condition of the mass matrix, and its
    time."""
    with np.errstate(all="ignore"):  # a run that stopped may end with huge numbers
        return _looked_at(system, trajectory)


def _looked_at(system: System, trajectory: Trajectory) -> tuple[float, float, float]:
    t, q, v = (x[_some(trajectory)] for x in (trajectory.t, trajectory.q, trajectory.v))
    free = accelerations(system, t, q, v)
    size = np.abs(free).max(-1, keepdims=True, initial=1)
    other = size * np.cos(np.arange(1, free.shape[-1] + 1))
    a = (free + other).astype(system.dtype)  # differs from the acceleration at tau = 0
    if system.has(CLOSED):  # an acceleration that the loops allow
        a = system.call("forward_dynamics", t=t, q=q, v=v, tau=system.call(
            "inverse_dynamics", t=t, q=q, v=v, a=a))
    tau = system.call("inverse_dynamics", t=t, q=q, v=v, a=a)
    again = system.call("forward_dynamics", t=t, q=q, v=v, tau=tau)
    roundoff = float(np.finfo(system.dtype).eps) / 2
    norm = np.linalg.norm
    defect = norm(again.astype(float) - a, axis=-1) / (norm(a, axis=-1) + norm(free, axis=-1))
    M = np.broadcast_to(np.asarray(system.call("mass_matrix", q=q), float),
                        (len(t), system.functions.nv, system.functions.nv))
    condition = np.linalg.cond(M)
    worst = largest(condition)
    return float(defect[largest(defect)]) / roundoff, float(condition[worst]), float(t[worst])


def _some(trajectory: Trajectory) -> np.ndarray:
    """Indices of at most _STATES samples, including the first and the last."""
    n = len(trajectory.t)
    return np.unique(np.linspace(0, n - 1, min(n, _STATES)).round().astype(int))


def _chosen(trajectory: Trajectory, samples: np.ndarray) -> Trajectory:
    return Trajectory(trajectory.t[samples], trajectory.q[samples], trajectory.v[samples], 0, 0)


def _sparse(system: System, trajectory: Trajectory) -> Recording:
    """The state and the recorded quantities, at some of the samples."""
    some = _chosen(trajectory, _some(trajectory))
    texts = dict.fromkeys(("q", "v", *system.scene.record))
    results = [recorded(text, system.scene) for text in texts]
    columns = tuple(Column(name, unit, x.quantity) for x in results
                    for name, unit in zip(x.names, x.units, strict=True))
    return Recording(some.t, columns, np.concatenate(
        [quantity(system, some, x) for x in results], 1), ())
