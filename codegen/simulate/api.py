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
from coscrew_codegen.simulate.plan import plan
from coscrew_codegen.simulate.provenance import provenance
from coscrew_codegen.simulate.record import record as recording_of
from coscrew_codegen.simulate.result import Result
from coscrew_codegen.simulate.run import integrate
from coscrew_codegen.simulate.system import scene_of, system


def run(scene: Kernels | Scene | Path | str, *, p: Parameters = None,
        q0: ArrayLike | None = None, v0: ArrayLike | None = None, until: float | None = None,
        step: float | None = None, integrator: str | None = None, precision: str | None = None,
        controller: Controller | Law | int | None = None, every: float | None = None,
        record: Sequence[str] | None = None) -> Result:
    """The motion of a scene (a file, a Scene, or kernels that load_scene returned), as `coscrew
    simulate` computes it, with the same bits.

    Whatever is None is as the scene says.  p maps names of run-time parameters to values, or holds
    all of them in order; q0 and v0 are the start.  Each may have a leading axis: then the run is a
    batch, and so are the arrays of the result.  Members that diverge are listed in `failed`, their
    later samples are NaN, the others go on.

    `controller` sets run-time parameters during the run: see Controller.  `every` is the time
    between samples, `record` names what to record, as in scenes.  Raises SimulateError for
    impossible settings, and the errors of reading a scene."""
    kernels, scene = _kernels(scene, integrator, precision, record)
    name = precision or scene.precision
    its = with_parameters(system(kernels, DOUBLE.name if name == "both" else name), p)
    q, v = start_of(its, q0, v0)
    planned = plan(its, until, step, integrator, every)
    if planned.adaptive and (q.ndim > 1 or controller is not None):
        raise SimulateError(f"integrator {planned.integrator} chooses its steps as one motion needs"
                            "; wanted an emitted integrator for batches and controllers")
    driven = None
    if controller is not None:
        wanted = controller if isinstance(controller, Controller) else Controller(controller)
        driven = Driven(wanted, its, planned, q)
    alarm = partial(Alarm, driven=driven is not None)
    trajectory = integrate(its, planned, None, alarm, (q, v), driven)
    if trajectory.interrupted:
        raise KeyboardInterrupt
    origin = provenance(its, planned, trajectory, kernels.compiler or "none: NumPy")
    return Result(its, planned, trajectory, recording_of(its, trajectory, origin, record))


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
