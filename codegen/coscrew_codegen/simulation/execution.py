"""Executes a run, from a request to its Result: for `run`, `again` and the command."""

import warnings
from dataclasses import dataclass, field, replace
from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.scene.integrators import INTEGRATOR_NAMED
from coscrew_codegen.scene.recorded_quantities import Recorded
from coscrew_codegen.simulation import SimulateError, required_functions
from coscrew_codegen.simulation.batch_inputs import Values, start_of, with_parameters
from coscrew_codegen.simulation.check.divergence_monitor import Alarm
from coscrew_codegen.simulation.check.overshoot import too_fast
from coscrew_codegen.simulation.check.step_advice import drifting, loose, remedy
from coscrew_codegen.simulation.checkpoint import Checkpoint, refuse, refuse_plan, start_at
from coscrew_codegen.simulation.control import Controller, set_by
from coscrew_codegen.simulation.controlled_run import Driven
from coscrew_codegen.simulation.plan import Plan, Trajectory, known, plan
from coscrew_codegen.simulation.progress import Progress
from coscrew_codegen.simulation.recordings.record import record
from coscrew_codegen.simulation.recordings.recording import Provenance
from coscrew_codegen.simulation.recordings.result import Result
from coscrew_codegen.simulation.run import integrate
from coscrew_codegen.simulation.system import State, System, scene_of, system


@dataclass(frozen=True)
class RunRequest:
    """Settings of a run; None means the scene's.  p holds the parameters that differ from the
    scene's, or from those of the run that it continues."""

    until: float | None = None
    step: float | None = None
    integrator: str | None = None
    every: float | None = None
    record: tuple[str, ...] | None = None
    p: Values = field(default_factory=dict)
    q0: ArrayLike | None = None
    v0: ArrayLike | None = None
    start: Checkpoint | None = None
    controller: Controller | None = None
    columns: tuple[Recorded, ...] | None = None  # of the quantities to record, if they are known


def motion(kernels: Kernels, precision: str, request: RunRequest, *, shown: bool = False,
           with_provenance: bool = True) -> Result:
    """The run in the precision of this name.  If `shown`, a terminal shows the progress; without
    `with_provenance`, the recording has no provenance.  Raises SimulateError."""
    its, state = _begun(kernels, precision, request)
    start = request.start
    if start and start.controller and not request.controller:
        warnings.warn(f"start: the run before had a controller ({start.controller}), this one has "
                      "none: its last values hold", RuntimeWarning, stacklevel=4)
    planned = plan(its, request.until, request.step, request.integrator, request.every,
                   begin=start.t if start else 0.0)
    if start:
        refuse_plan(start, its, planned)
    if planned.adaptive and (state[0].ndim > 1 or request.controller):
        raise SimulateError(f"integrator {planned.integrator} chooses its steps as one motion needs"
                            "; wanted an emitted integrator for batches and controllers")
    by = request.controller
    driven = Driven(by, its, planned, state[0], start.steps if start else 0) if by else None
    trajectory = _integrated(its, planned, state, start, driven, shown)
    if not driven and state[0].ndim == 1:
        stop = loose(its, planned, trajectory, state) if planned.adaptive else drifting(
            its, planned, trajectory, state, _momentum(its, start, state) if start else None)
        if stop:
            trajectory = replace(trajectory, stopped=stop.cause, failed=(stop,))
    if by and driven and (warning := too_fast(by, driven, its, planned, trajectory)):
        warnings.warn(warning, RuntimeWarning, stacklevel=3)
    began = start_at(its, *state, trajectory.momentum)
    if start:
        began = replace(began, t=start.t, steps=start.steps, failed=start.failed)
    origin: Provenance = ()
    if with_provenance:
        from coscrew_codegen.simulation.recordings.provenance import provenance  # slow: runs Git

        origin = provenance(its, planned, trajectory, kernels.compiler or "none: NumPy", began,
                            its.scene.record if request.record is None else request.record,
                            request.controller.described(its.scene) if request.controller else "")
    return Result(its, planned, trajectory, record(its, trajectory, origin, request.record,
                                                   request.columns), began)


def complete(kernels: Kernels, request: RunRequest) -> Kernels:
    """Returns the kernels with all functions that the run needs, if they have the step of its
    integrator; if not, the plan refuses them."""
    scene = scene_of(kernels)
    own = INTEGRATOR_NAMED[known(request.integrator or scene.run.integrator)].step_name
    if kernels.plain or (own and own not in (x.name for x in kernels.interface.signatures)):
        return kernels
    recording = scene if request.record is None else replace(scene, record=request.record)
    return kernels._with(*required_functions.of_run(recording, request.integrator,
                                                    held=request.controller is not None))


def _begun(kernels: Kernels, precision: str, request: RunRequest) -> tuple[System, State]:
    """The system and the state from which the run starts."""
    its, start = system(kernels, precision), request.start
    if start:
        refuse(start, its)
        its = its.at(start.p)
    its = with_parameters(its, request.p)
    if start and request.controller:  # its values hold until it is called again
        places = list(set_by(request.controller, its.scene))
        p = np.array(np.broadcast_arrays(its.p, start.p)[0], float)
        p[..., places] = start.p[..., places]
        its = its.at(p)
    return its, start_of(its, request.q0, request.v0, start)


def _integrated(its: System, planned: Plan, state: State, start: Checkpoint | None,
                driven: Driven | None, shown: bool) -> Trajectory:
    alarm = partial(Alarm, driven=driven is not None, remedy=remedy)
    momentum, failed = (_momentum(its, start, state), start.failed) if start else (None, ())
    if not shown:
        return integrate(its, planned, None, alarm, state, driven, momentum, failed)
    with Progress(its, planned.until) as watch:
        return integrate(its, planned, watch, alarm, state, driven, momentum, failed)


def _momentum(its: System, start: Checkpoint, state: State) -> np.ndarray | None:
    """The momentum of floating bases at t = 0 that leads to the state from which the run continues:
    that of the previous run, except for members whose new parameters change it."""
    if start.momentum is None:
        return None
    with np.errstate(all="ignore"):
        kept = start.momentum.astype(its.dtype)
        before, now = (x.kept(kept, start.t, *state) for x in (its.at(start.p), its))
        changed = np.any([(abs(a - b) > 0).any(-1) for a, b in zip(before, now, strict=True)], 0)
        if not changed.any():
            return start.momentum
        own = its.momentum(*its.kept(its.momentum(*state), -start.t, *state))
        return kept if own is None else np.where(changed[..., None, None], own, kept)
