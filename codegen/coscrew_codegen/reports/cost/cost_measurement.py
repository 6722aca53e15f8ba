"""Measures a scene: errors and times of its functions in every tier and precision; their operations
and times, with and without each effect; accuracy of runs against time."""

import math
import sys
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np
from tqdm import tqdm

from coscrew_codegen.accuracy.fixed_scene import FixedFunction
from coscrew_codegen.accuracy.scene_tiers import NoFunctionsError, SceneTier, in_tier
from coscrew_codegen.accuracy.tiers import OF_SCENES, PLAIN, tier_named
from coscrew_codegen.program import counts_in_words
from coscrew_codegen.program.fixed.fixed_program import Products
from coscrew_codegen.program.flops import flops
from coscrew_codegen.program.scene_functions import FunctionProgram
from coscrew_codegen.program.values.formats import PRECISIONS
from coscrew_codegen.reports.cost import CostError
from coscrew_codegen.reports.cost.cost_request import CostRequest, present, refuse_absent
from coscrew_codegen.reports.cost.effect_ablation import SHOWN, WHOLE, Ablation, part, parts
from coscrew_codegen.reports.cost.error_states import Box, Values, box_of
from coscrew_codegen.reports.cost.function_errors import FunctionErrors, measured
from coscrew_codegen.reports.cost.loops import ELEMENTS, CompiledLoops, compiled
from coscrew_codegen.reports.cost.measured import CERTIFIED, Measured, choices
from coscrew_codegen.reports.cost.needs.answers import Answer, answer
from coscrew_codegen.reports.cost.needs.core_costs import CoreCost, on_cores
from coscrew_codegen.reports.cost.needs.cortex_m4 import CountError
from coscrew_codegen.reports.cost.needs.fixed_errors import FixedErrors
from coscrew_codegen.reports.cost.needs.need import Need, refuse_other_units
from coscrew_codegen.reports.cost.run_errors import RunErrors, run_errors
from coscrew_codegen.reports.cost.work_precision import (
    Point,
    ReferenceRun,
    reference,
    work_precision,
)
from coscrew_codegen.reports.timing.intervals import Interval
from coscrew_codegen.reports.timing.loop_timing import timed_loops
from coscrew_codegen.reports.timing.machine_load import Load, LoadWatch
from coscrew_codegen.runtime import compilation
from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.simulation.plan import Plan, Trajectory, plan
from coscrew_codegen.simulation.progress import Progress
from coscrew_codegen.simulation.recordings.record import accelerations
from coscrew_codegen.simulation.run import integrate
from coscrew_codegen.simulation.run_summary import RunOverrides
from coscrew_codegen.simulation.system import System, system

_SECONDS = 0.02  # of timing for each function of each part in each precision

Item = TypeVar("Item")


@dataclass(frozen=True)
class Row:
    """The cost of a function in a part of the scene."""

    part: str
    function: str
    words: str  # its operations by kind
    flops: int
    times: tuple[Interval, Interval]  # ns per call: double, single


@dataclass(frozen=True)
class Costs:
    """The costs of a scene on this machine."""

    scene: str
    compiler: str  # its version and flags
    rows: tuple[Row, ...]
    reference: ReferenceRun | None
    points: tuple[Point, ...]
    accuracy: tuple[tuple[FunctionErrors, ...],
                    ...] = ()  # of each function: all tiers and precisions
    runs: bool = True  # whether runs were measured, or requested
    run_errors: RunErrors | None = None
    answers: tuple[Answer, ...] = ()
    load: Load | None = None  # of the machine, while functions were timed
    cores: tuple[CoreCost, ...] = ()  # where the scene selects fixed point

    @property
    def needs(self) -> tuple[Need, ...]:
        """The requests that were answered."""
        return tuple(need for x in self.answers for need in x.needs)

    def known(self, point: Point) -> bool:
        """Returns whether a run's error exceeds the reference's, and so is known; a smaller error
        is only known to be small."""
        return self.reference is not None and point.error > self.reference.error

    def best(self, point: Point) -> bool:
        """Returns whether no other run is faster, with disjoint intervals, and as accurate."""
        return math.isfinite(point.error) and not any(
            x.time.below(point.time) and x.error <= point.error for x in self.points)


def measure(kernels: Kernels, overrides: RunOverrides, request: CostRequest) -> Costs:
    """Measures the requested costs.  `kernels` have the dynamics and all functions that a run
    needs.  Raises CostError."""
    scene = kernels.scene
    if scene is None:
        raise CostError("these kernels are of no scene file")
    names = request.of(scene)
    chosen = (part(WHOLE, scene, names),) if request.alone else parts(scene, names)
    refuse_absent(request, chosen[0])
    names = present(names, chosen[0])
    for name in names:
        refuse_other_units(request.needs, name, chosen[0].functions.named(name).units)
    try:
        using = compilation.compiler()
        tiers = _tiers(chosen[0], names, all_of_them=bool(request.needs) or any(
            tier_named(x).fixed for x in scene.tiers))
        built = tuple(_progress((compiled(x, _functions(x), using, tiers if x is chosen[0] else ())
                                 for x in chosen), "compiling", len(chosen)))
    except compilation.CompilationError as error:
        raise CostError(f"cost times C, and that cannot be compiled: {error}") from None
    states = _states(kernels, overrides)
    box = _box(kernels, overrides, states[1])
    watch = LoadWatch()
    accuracy = tuple(_progress(_accuracies(box, states[1], built[0], names, request, watch),
                               "comparing", len(names)))
    answers = tuple(answer(request.needs, rows, built[0], box) for rows in accuracy
                    if any(x.function == rows[0].function for x in request.needs))
    costs = Costs(scene.name, str(using), (), None, (), accuracy, not request.alone,
                  answers=answers, load=watch.load,
                  cores=_cores(built[0], box, names, using, accuracy))
    return costs if request.alone else _with_runs(costs, kernels, overrides, built, states, request)


def _cores(built: CompiledLoops, box: Box, names: Sequence[str], using: compilation.Compiler,
           accuracy: Sequence[Sequence[FunctionErrors]]) -> tuple[CoreCost, ...]:
    """The functions on processors without floating point.  Raises CostError."""
    def search(f: FixedFunction, products: Products) -> dict[str, float]:
        return FixedErrors(Measured(built, f.plain.name), f, products).worst(box)

    known = {(x.function, x.precision if x.tier == PLAIN.name else x.name): x
             for rows in accuracy for x in rows}
    try:
        return on_cores(built.part.scene, names, using, known, search)
    except CountError as error:
        raise CostError(f"cost counts instructions, but {error}") from None


def _with_runs(costs: Costs, kernels: Kernels, overrides: RunOverrides,
               built: Sequence[CompiledLoops],
               states: tuple[System, Trajectory], request: CostRequest) -> Costs:
    """Adds operations, effects and runs."""
    rows = tuple(_progress(_rows(built, states), "timing",
                           sum(len(_functions(x.part)) for x in built)))
    its, planned = _planned(kernels, overrides)
    truth = reference(its, planned.until, request.digits)
    points = work_precision(kernels, built[0], planned, overrides, truth) if truth else ()
    return replace(costs, rows=rows, reference=truth,
                   points=tuple(_progress(points, "integrating", None)),
                   run_errors=run_errors(kernels, overrides, [
                       (x.tier.name, p) for x in built[0].tiers for p, _ in x.in_precisions
                       if x.tier.scene and x.tier.name != CERTIFIED]))  # certified: as plain


def _tiers(of: Ablation, names: Sequence[str], all_of_them: bool) -> tuple[SceneTier, ...]:
    """Returns the functions in all tiers of both precisions except plain, and in the tiers that the
    scene selects; the remaining tiers, worthwhile only where double is software, if
    `all_of_them`."""
    some = replace(of.functions, steps=(), functions=tuple(
        f for f in of.public if f.name in names))
    results = []
    for tier in OF_SCENES:
        if names and tier != PLAIN and not tier.fixed and (
                tier.precisions == PRECISIONS or tier.name in of.scene.tiers
                or all_of_them and not tier.on_request):
            with suppress(NoFunctionsError):
                results.append(in_tier(some, tier))
    return tuple(results)


def _box(kernels: Kernels, overrides: RunOverrides, run: Trajectory) -> Box:
    """The limits between which states are drawn, at parameters of single precision."""
    known = dict(kernels.interface.parameters) | dict(overrides.settings)
    its = system(kernels, "double", {x: float(np.float32(y)) for x, y in known.items()})
    return box_of(its, float(run.t[-1]), _planned(kernels, overrides)[1].step)


def _accuracies(box: Box, run: Trajectory, built: CompiledLoops, names: Sequence[str],
                request: CostRequest, watch: LoadWatch) -> Iterator[tuple[FunctionErrors, ...]]:
    """Errors and times of these functions."""

    def timed(name: str, states: Values) -> list[Interval]:
        inputs = [np.resize(states[a.name], (ELEMENTS, *states[a.name].shape[1:]))
                  for a in built.part.functions.named(name).program.inputs]
        loops = [built.loop(name, x.precision, inputs, x.tier) for x in choices(built, name)]
        with watch.timing():
            return [x.time for x in timed_loops(built.library, loops, 1e9 * _SECONDS * len(loops))]

    for rows in measured(built, names, box, run, request.counts, timed):
        yield tuple(replace(x, emitted=x.precision in request.emitted) for x in rows)


def _functions(of: Ablation) -> tuple[FunctionProgram, ...]:
    """All functions of the whole scene; of its other parts, the functions shown for each effect."""
    return tuple(f for f in of.public if of.words == WHOLE or f.name in SHOWN)


def _planned(kernels: Kernels, overrides: RunOverrides, every: float | None = None
             ) -> tuple[System, Plan]:
    its = system(kernels, "double", dict(overrides.settings))
    return its, plan(its, overrides.until, overrides.step, overrides.integrator, every)


def _states(kernels: Kernels, overrides: RunOverrides) -> tuple[System, Trajectory]:
    """A run of the scene, from whose samples the inputs of timed functions are taken."""
    until = _planned(kernels, overrides)[1].until
    its, planned = _planned(kernels, overrides, until / (ELEMENTS - 1))
    with Progress(its, until) as watch:
        trajectory = integrate(its, planned, watch)
    if trajectory.interrupted:
        raise KeyboardInterrupt
    return its, trajectory


def _rows(built: Sequence[CompiledLoops], states: tuple[System, Trajectory]) -> Iterator[Row]:
    """Times each function of the whole scene and the same function of the other parts, in turn, in
    both precisions."""
    for name in (f.name for f in _functions(built[0].part)):
        chosen = [(x, f) for x in built for f in _functions(x.part) if f.name == name]
        loops = [x.loop(name, precision, _inputs(f, *states))
                 for x, f in chosen for precision in PRECISIONS]
        times = [x.time for x in timed_loops(built[0].library, loops, 1e9 * _SECONDS * len(loops))]
        for (x, f), double, single in zip(chosen, times[::2], times[1::2], strict=True):
            yield Row(x.part.words, f.name, counts_in_words(f.program), flops(f.program),
                      (double, single))


def _inputs(function: FunctionProgram, its: System, trajectory: Trajectory) -> list[np.ndarray]:
    """ELEMENTS of each of the function's inputs, from the run."""
    chosen = np.resize(np.arange(len(trajectory.t)), ELEMENTS)
    t, q, v = (x[chosen] for x in (trajectory.t, trajectory.q, trajectory.v))
    values = {"t": t, "p": np.tile(np.array(its.p), (ELEMENTS, 1)), "q": q, "v": v,
              "a": accelerations(its, t, q, v), "tau": np.zeros_like(v), "phi": 1e-3 * v,
              "h": np.full(ELEMENTS, 1e-3), "r": np.full((ELEMENTS, 3), its.scene.model.length),
              "q1": np.roll(q, 1, axis=0)}
    if its.has("free_momentum"):
        values["c"] = np.asarray(its.call("free_momentum", q=q, v=v))
    return [values[a.name] if a.name in values else np.ones((ELEMENTS, *a.quantity.shape))
            for a in function.program.inputs]  # directions and weights of derivatives


def _progress(items: Iterable[Item], what: str, total: int | None) -> Iterator[Item]:
    """The items, with a progress bar on standard error if that is a terminal."""
    yield from tqdm(items, what, total, leave=False, disable=None, file=sys.stderr)
