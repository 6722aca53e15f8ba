"""Preparation of a sweep: from a scene and options to a specification and compiled kernels, or one
clear error."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from coscrew_codegen.backends.version import VERSION
from coscrew_codegen.program.values.formats import BY_NAME, DOUBLE
from coscrew_codegen.runtime.load import Kernels, kernels_for
from coscrew_codegen.scene.integrators import INTEGRATOR_NAMED
from coscrew_codegen.scene.recorded_quantities import QuantityError, quantities_of, recorded
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation import required_functions
from coscrew_codegen.simulation.plan import Plan, plan
from coscrew_codegen.simulation.run_summary import RunOverrides
from coscrew_codegen.simulation.sweep import SweepError
from coscrew_codegen.simulation.sweep.refusals import refuse
from coscrew_codegen.simulation.sweep.specification import Conditions, Specification, varied
from coscrew_codegen.simulation.sweep.sweep_options import GridOption, SobolOption
from coscrew_codegen.simulation.system import system

_MEMBERS = 64, 16384  # least and most in a chunk: lanes are filled
_PARTS = 64  # chunks of a small sweep, so that workers share it
_STEPS = 1_000_000, 50_000_000  # least and most of a chunk: 50 ms of work and some seconds
_BYTES = 128_000_000  # most of a chunk's samples


@dataclass(frozen=True)
class SweepRequest:
    """The options that define the sweep."""

    grids: Sequence[GridOption]
    sobols: Sequence[SobolOption]
    samples: int | None
    seed: int | None
    record: Sequence[str]
    series: bool
    overrides: RunOverrides


@dataclass(frozen=True)
class Prepared:
    """A sweep that can start."""

    kernels: Kernels
    scene: Scene
    specification: Specification
    plan: Plan


def prepared(read: Scene, request: SweepRequest) -> Prepared:
    """The sweep.  Raises SweepError, SimulateError."""
    overrides = request.overrides
    if overrides.precision == "both":
        raise SweepError(f"--precision both: a sweep runs in one; wanted {' or '.join(BY_NAME)}")
    own = read.precision if read.precision in BY_NAME else DOUBLE.name
    precision = overrides.precision or own
    settings = dict(overrides.settings)
    scene = _recording(read, tuple(request.record))
    vary = varied(scene, settings, request.grids, request.sobols, request.samples, request.seed)
    refuse(scene, settings, vary, BY_NAME[precision])
    kernels = kernels_for(scene, required_functions.of_run(scene, overrides.integrator),
                          (precision,))
    its = system(kernels, precision, settings)
    planned = plan(its, overrides.until, overrides.step, overrides.integrator)
    if not INTEGRATOR_NAMED[planned.integrator].emitted:
        raise SweepError(f"integrator {planned.integrator}: chooses its steps in each run; a sweep "
                         "wants an emitted one, such as --integrator leapfrog")
    conditions = Conditions(tuple(sorted(settings.items())), planned.until, planned.step,
                            planned.integrator, planned.every, precision, scene.record,
                            request.series)
    chunk = _chunk(vary.members, scene, planned)
    specification = Specification(scene.name, read.content_hash, VERSION, vary, conditions, chunk)
    return Prepared(kernels, scene, specification, planned)


def _recording(scene: Scene, record: tuple[str, ...]) -> Scene:
    """The scene with these quantities instead of its own, each once."""
    try:
        names = quantities_of(record or scene.record, scene)
    except QuantityError as error:
        raise SweepError(f"--record {error}") from None
    return replace(scene, record=tuple(dict.fromkeys(names)))


def _chunk(members: int, scene: Scene, planned: Plan) -> int:
    """Number of members in a chunk: a function of the sweep alone, so that any machine can continue
    it."""
    samples, steps = len(planned.samples), max(1, round(planned.until / planned.step))
    numbers = sum(len(recorded(text, scene).names) for text in ("q", "v", *scene.record))
    least, most = (sorted((_MEMBERS[0], count // steps, _MEMBERS[1]))[1] for count in _STEPS)
    fitting = max(1, _BYTES // (8 * samples * numbers))
    return min(max(least, -(-members // _PARTS)), most, fitting)
