"""run: one run of a scene, or a batch of them, from Python."""

import warnings
from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

from numpy.typing import ArrayLike

from coscrew_codegen.formats import BY_NAME, DOUBLE
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulate import SimulateError, needs
from coscrew_codegen.simulate.alarm import Alarm
from coscrew_codegen.simulate.control import Controller, Driven, Law
from coscrew_codegen.simulate.load import Kernels, kernels_for
from coscrew_codegen.simulate.members import Parameters, start_of, with_parameters
from coscrew_codegen.simulate.onward import End, end_of, read, refuse
from coscrew_codegen.simulate.plan import plan
from coscrew_codegen.simulate.provenance import provenance, started
from coscrew_codegen.simulate.record import record as recording_of
from coscrew_codegen.simulate.result import Result
from coscrew_codegen.simulate.run import integrate
from coscrew_codegen.simulate.system import scene_of, system


def run(scene: Kernels | Scene | Path | str, *, p: Parameters = None,
        q0: ArrayLike | None = None, v0: ArrayLike | None = None,
        start: Result | Path | str | None = None, until: float | None = None,
        step: float | None = None, integrator: str | None = None, precision: str | None = None,
        controller: Controller | Law | int | None = None, every: float | None = None,
        record: Sequence[str] | None = None) -> Result:
    """The motion of a scene (a file, a Scene, or kernels that load_scene returned), as `coscrew
    simulate` computes it, with the same bits.

    Whatever is None is as the scene says.  p maps names of run-time parameters to values, or holds
    all of them in order; q0 and v0 are the start.  Each may have a leading axis: then the run is a
    batch, and so are the arrays of the result.  Members that diverge are listed in `failed`, their
    later samples are NaN, the others go on.

    `start` is a Result, or a recording of one run (.csv, .npz, .parquet): the run goes on from its
    end with its parameters, except for those in p, to the bit as one long run does, if that end is
    a multiple of `every`.  q0 and v0 must then be None.

    `controller` sets run-time parameters during the run: see Controller.  `every` is the time
    between samples, `record` names what to record, as in scenes.  Raises SimulateError for
    impossible settings, and the errors of reading a scene."""
    kernels, scene = _kernels(scene, integrator, precision, record)
    name = precision or scene.precision
    its, end = system(kernels, DOUBLE.name if name == "both" else name), _end(start, q0, v0)
    if end:
        its = its.at(end.p)
    its = with_parameters(its, p)
    q, v = start_of(its, q0, v0, end)
    planned = plan(its, until, step, integrator, every, begin=end.t if end else 0.0)
    if end:
        refuse(end, its, planned)
    if planned.adaptive and (q.ndim > 1 or controller is not None):
        raise SimulateError(f"integrator {planned.integrator} chooses its steps as one motion needs"
                            "; wanted an emitted integrator for batches and controllers")
    driven = wanted = None
    if controller is not None:
        wanted = controller if isinstance(controller, Controller) else Controller(controller)
        driven = Driven(wanted, its, planned, q, *((end.steps, end.p) if end else ()))
    alarm = partial(Alarm, driven=driven is not None)
    trajectory = integrate(its, planned, None, alarm, (q, v), driven,
                           end.momentum if end else None)
    if trajectory.interrupted:
        raise KeyboardInterrupt
    before = end.steps if end and not driven else 0
    given = any(x is not None for x in (q0, v0, start))
    origin = provenance(its, planned, trajectory, kernels.compiler or "none: NumPy",
                        started(planned.begin, q, v) if given else "",
                        wanted.told if wanted else "", before)
    return Result(its, planned, trajectory, recording_of(its, trajectory, origin, record), before)


def _end(start: Result | Path | str | None, q0: ArrayLike | None, v0: ArrayLike | None
         ) -> End | None:
    """The end of the run to go on from.  Raises SimulateError, TypeError."""
    if start is None:
        return None
    if q0 is not None or v0 is not None:
        raise SimulateError("start: wanted either a run to go on from, or q0 and v0; got both")
    if isinstance(start, (str, Path)):
        return read(Path(start))
    if not isinstance(start, Result):
        raise TypeError(f"start: wanted a Result or the path of a recording; got "
                        f"{type(start).__name__}")
    if start.failed:
        raise SimulateError(f"start: {start!r}; wanted one that reached its end; the first cause: "
                            f"{start.failed[0].cause}")
    return end_of(start.system, start.trajectory, start.before)


def _kernels(scene: Kernels | Scene | Path | str, integrator: str | None, precision: str | None,
             record: Sequence[str] | None) -> tuple[Kernels, Scene]:
    """The kernels, with the functions that the run needs, and their scene."""
    if precision not in (None, *BY_NAME):
        raise SimulateError(f"precision: {precision!r}; wanted one of {', '.join(BY_NAME)}")
    if isinstance(scene, Kernels):
        kernels, own = scene, scene_of(scene)
    elif isinstance(scene, (str, Path)):
        from coscrew_codegen.scene_files.toml_scene import SceneOverrides, read_scene

        own = read_scene(scene, overrides=SceneOverrides(precision))
        for line in own.model.implausible:
            warnings.warn(f"{Path(scene).name}: {line}", RuntimeWarning, stacklevel=3)
        kernels = None
    elif isinstance(scene, Scene):
        kernels, own = None, scene
    else:
        raise TypeError("run: wanted the path of a scene file, a Scene, or Kernels; got "
                        f"{type(scene).__name__}")
    name = precision or (DOUBLE.name if own.precision == "both" else own.precision)
    if name not in (kernels.precisions if kernels else own.precisions):
        raise SimulateError(f"precision: {name!r}; the scene is of {own.precisions[0]} precision "
                            "alone")
    if kernels is None:
        recording = own if record is None else replace(own, record=tuple(record))
        kernels = kernels_for(own, needs.of_run(recording, integrator), (name,))
    return kernels, own
