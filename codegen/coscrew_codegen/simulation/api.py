"""Python's entry points: `run` makes one run of a scene, or a batch; `again` repeats a recorded
run."""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import prod
from pathlib import Path

from numpy.typing import ArrayLike

from coscrew_codegen.program.values.formats import BY_NAME, DOUBLE
from coscrew_codegen.runtime.caller_warnings import at_callers_line
from coscrew_codegen.runtime.load import Kernels, kernels_for
from coscrew_codegen.scene.readers.model_arguments import Folders, overrides_of, refuse_given
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.recorded_quantities import recorded
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation import SimulateError, required_functions
from coscrew_codegen.simulation.batch_inputs import Parameters, values_of
from coscrew_codegen.simulation.checkpoint import Checkpoint, end_in
from coscrew_codegen.simulation.control import Controller, Law
from coscrew_codegen.simulation.execution import RunRequest, complete, motion
from coscrew_codegen.simulation.recordings.record import quantities
from coscrew_codegen.simulation.recordings.result import Result
from coscrew_codegen.simulation.replay import metadata_of
from coscrew_codegen.simulation.run_summary import outside, overspeed
from coscrew_codegen.simulation.system import scene_of


def run(scene: Kernels | Scene | Path | str, *, p: Parameters = None,
        q0: ArrayLike | None = None, v0: ArrayLike | None = None,
        start: Result | Path | str | None = None, until: float | None = None,
        step: float | None = None, integrator: str | None = None, precision: str | None = None,
        controller: Controller | Law | int | None = None, every: float | None = None,
        record: Sequence[str] | None = None, packages: Folders | None = None,
        arguments: Mapping[str, str] | None = None, leave_out: Sequence[str] | None = None
        ) -> Result:
    """Runs a scene (a file, a Scene, or kernels that load_scene returned) as `coscrew simulate`
    does, with the same bits.

    Arguments that are None have the scene's values.  p maps names of run-time parameters to values,
    or holds all of them in order; q0 and v0 are the start.  Each may have a leading axis: then the
    run is a batch, and so are the arrays of the result.  Members that diverge are listed in
    `failed`, their later samples are NaN, and the others continue.  A single run that stops early
    causes a RuntimeWarning.

    `start` is a Result, or a recording of one run (.csv, .npz, .parquet): the run continues from
    its end with its parameters, except for those in p, with the bits of one long run if that end is
    a multiple of `every`. Members that failed before stay failed.  q0 and v0 must be None.

    `controller` sets run-time parameters during the run: see Controller.  A controller that changes
    too fast for the interval of its calls causes a RuntimeWarning.  `every` is the time between
    samples, `record` names what to record, as in scenes.  `packages`, `arguments` and `leave_out`
    are for the model's file, as for `load_scene`.  Raises SimulateError for impossible settings,
    and the errors of reading a scene."""
    kernels, own = _read(scene, precision, packages, arguments, leave_out)
    name = _precision(precision, own)
    names = None if record is None else quantities(record, own)
    request = RunRequest(until, step, integrator, every, names, values_of(own, BY_NAME[name], p),
                         q0, v0, _end(start, q0, v0), _controller(controller),
                         tuple(recorded(x, own) for x in names or own.record))
    with at_callers_line():
        kernels = complete(kernels, request) if kernels else _kernels(
            own, integrator, name, request.record, request.controller is not None)
    with at_callers_line():
        result = motion(kernels, name, request)
    if start is None and (note := outside(result.system, result.q[..., 0, :])):
        warnings.warn(note, RuntimeWarning, stacklevel=2)
    if fast := overspeed(result):
        warnings.warn(fast, RuntimeWarning, stacklevel=2)
    return _warned(result)


def again(scene: Kernels | Scene | Path | str, recording: Result | Path | str, *,
          controller: Controller | Law | int | None = None, packages: Folders | None = None,
          arguments: Mapping[str, str] | None = None, leave_out: Sequence[str] | None = None
          ) -> Result:
    """Repeats the run that made a recording (.csv, .npz, .parquet) or a Result: with the same bits
    and, when written, the same bytes.

    All settings are the recording's, except for the controller, and what says how the model's file
    is read, which must be given again, and rtol and atol, which are the scene's.  Raises
    SimulateError for another scene or controller."""
    past = metadata_of(recording)
    kernels, own = _read(scene, past.precision, packages, arguments, leave_out)
    by = _controller(controller)
    past.refuse(own, by)
    request = past.request(by)
    with at_callers_line():
        kernels = complete(kernels, request) if kernels else _kernels(
            own, past.integrator, past.precision, past.record, by is not None)
    with at_callers_line():
        result = motion(kernels, past.precision, request)
    return _warned(result)


def _warned(result: Result) -> Result:
    """The result; warns if it is a run that stopped, raises KeyboardInterrupt again."""
    if result.trajectory.interrupted:
        raise KeyboardInterrupt
    if result.trajectory.stopped:
        warnings.warn(f"the run stopped: {result.trajectory.stopped}", RuntimeWarning, stacklevel=3)
    return result


def _end(start: Result | Path | str | None, q0: ArrayLike | None, v0: ArrayLike | None
         ) -> Checkpoint | None:
    """The end of the run that this one continues.  Raises SimulateError, TypeError."""
    if start is None:
        return None
    if q0 is not None or v0 is not None:
        raise SimulateError("start: wanted either a run to continue, or q0 and v0; got both")
    if isinstance(start, (str, Path)):
        return end_in(Path(start))
    if not isinstance(start, Result):
        raise TypeError(f"start: wanted a Result or the path of a recording; got "
                        f"{type(start).__name__}")
    if start.failed and len(start.failed) == max(1, prod(start.q.shape[:-2])):
        raise SimulateError(f"start: {start!r}; wanted one that reached its end; the first cause: "
                            f"{start.failed[0].cause}")
    return start.end


def _controller(given: Controller | Law | int | None) -> Controller | None:
    return given if given is None or isinstance(given, Controller) else Controller(given)


def _precision(precision: str | None, scene: Scene) -> str:
    """The name of the precision of a run."""
    name = precision or scene.precision
    return DOUBLE.name if name == "both" else name


def _read(scene: Kernels | Scene | Path | str, precision: str | None, packages: Folders | None,
          arguments: Mapping[str, str] | None, leave_out: Sequence[str] | None
          ) -> tuple[Kernels | None, Scene]:
    """The kernels, if they are given, and the scene."""
    if precision not in (None, *BY_NAME):
        raise SimulateError(f"precision: {precision!r}; wanted one of {', '.join(BY_NAME)}")
    if isinstance(scene, Kernels | Scene):
        refuse_given("run", packages=packages, arguments=arguments, leave_out=leave_out)
    if isinstance(scene, Kernels):
        kernels, own = scene, scene_of(scene)
    elif isinstance(scene, (str, Path)):
        kernels, own = None, read_scene(scene, overrides=replace(
            overrides_of(packages, arguments, leave_out), precision=precision))
        for line in own.model.implausible:
            warnings.warn(f"{Path(scene).name}: {line}", RuntimeWarning, stacklevel=3)
    elif isinstance(scene, Scene):
        kernels, own = None, scene
    else:
        raise TypeError("run: wanted the path of a scene file, a Scene, or Kernels; got "
                        f"{type(scene).__name__}")
    if not all(_precision(precision, own) in x.precisions for x in (kernels, own) if x):
        raise SimulateError(f"precision: {_precision(precision, own)!r}; the scene is of "
                            f"{own.precisions[0]} precision alone")
    return kernels, own


def _kernels(own: Scene, integrator: str | None, precision: str, record: tuple[str, ...] | None,
             held: bool) -> Kernels:
    """The kernels of the functions that the run needs."""
    recording = own if record is None else replace(own, record=record)
    return kernels_for(own, required_functions.of_run(recording, integrator, held=held),
                       (precision,))
