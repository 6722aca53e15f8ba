"""Measures a scene: operations and times of its functions, with and without each effect; accuracy
against time."""

import sys
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np
from tqdm import tqdm

from coscrew_codegen.cost import CostError
from coscrew_codegen.cost.leaving_out import SHOWN, WHOLE, Part, parts
from coscrew_codegen.cost.loops import ELEMENTS, Compiled, compiled
from coscrew_codegen.cost.rounding import UNITS, Rounding, Variant, measured, variants
from coscrew_codegen.cost.states import Values, box_of
from coscrew_codegen.cost.work_precision import Point, Reference, reference, work_precision
from coscrew_codegen.formats import PRECISIONS
from coscrew_codegen.native.intervals import Interval
from coscrew_codegen.native.timing import timed_loops
from coscrew_codegen.program import counts_in_words
from coscrew_codegen.program.flops import flops
from coscrew_codegen.scene_functions import Function
from coscrew_codegen.scene_tiers import SceneTier, in_tier
from coscrew_codegen.simulate import native
from coscrew_codegen.simulate.load import Kernels, kernels_for
from coscrew_codegen.simulate.outcome import RunOverrides
from coscrew_codegen.simulate.plan import Trajectory, plan
from coscrew_codegen.simulate.progress import Progress
from coscrew_codegen.simulate.record import accelerations
from coscrew_codegen.simulate.run import integrate
from coscrew_codegen.simulate.system import System, scene_of, system
from coscrew_codegen.tiers import PLAIN, tier_named

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
    reference: Reference | None
    points: tuple[Point, ...]
    roundings: tuple[Rounding, ...] = ()

    def known(self, point: Point) -> bool:
        """Whether a run's error exceeds the reference's; if not, it is only known to be small."""
        return self.reference is not None and point.error > self.reference.error


def measure(kernels: Kernels, overrides: RunOverrides, digits: int | None) -> Costs:
    """Measure; with `digits`, the reference is computed with so many.  Raises CostError."""
    scene = kernels.scene
    if scene is None:
        raise CostError("these kernels are of no scene file")
    try:
        using = native.compiler()
        chosen = parts(scene)
        tiers = _tiers(chosen[0])
        built = tuple(_progress((compiled(x, _functions(x), using, tiers if x is chosen[0] else ())
                                 for x in chosen), "compiling", len(chosen)))
    except native.CompilationError as error:
        raise CostError(f"cost times C, and that cannot be compiled: {error}") from None
    states = _states(kernels, overrides)
    rows = tuple(_progress(_rows(built, states), "timing",
                           sum(len(_functions(x.part)) for x in built)))
    its = system(kernels, "double", dict(overrides.settings))
    planned = plan(its, overrides.until, overrides.step, overrides.integrator)
    truth = reference(its, planned.until, digits)
    points = work_precision(kernels, built[0], planned, overrides, truth) if truth else ()
    roundings = _roundings(kernels, overrides, states[1], built[0])
    return Costs(scene.name, str(using), rows, truth,
                 tuple(_progress(points, "integrating", None)), roundings)


def _tiers(part: Part) -> tuple[SceneTier, ...]:
    """The accurate tier of the functions whose rounding is measured."""
    some = replace(part.functions, steps=(), functions=tuple(
        f for f in part.public if f.name in UNITS))
    return (in_tier(some, tier_named("accurate")),)


def _roundings(kernels: Kernels, overrides: RunOverrides, run: Trajectory, built: Compiled
               ) -> tuple[Rounding, ...]:
    """Errors of rounding, in plain functions and in those of the accurate tier."""
    scene = replace(scene_of(kernels), tiers=("accurate",))
    found = variants(kernels_for(scene, tuple(UNITS)), dict(overrides.settings))
    functions = {f.name: f for f in built.part.public}

    def timed(name: str, chosen: Sequence[Variant], states: Values) -> list[Interval]:
        some = {**states, "p": np.tile(np.array(found[0].system.p), (len(states["t"]), 1))}
        inputs = [np.resize(some[a.name], (ELEMENTS, *some[a.name].shape[1:]))
                  for a in functions[name].program.inputs]
        loops = [built.loop(functions[name], x.system.precision, inputs,
                            "" if x.tier == PLAIN.name else x.tier) for x in chosen]
        return [x.time for x in timed_loops(built.library, loops, 1e9 * _SECONDS * len(loops))]

    box = box_of(found[0].system, float(run.t[-1]))
    return tuple(measured(found, box, run, timed))


def _functions(part: Part) -> tuple[Function, ...]:
    """All functions of the whole scene; of its other parts, the functions shown for each effect."""
    return tuple(f for f in part.public if part.words == WHOLE or f.name in SHOWN)


def _states(kernels: Kernels, overrides: RunOverrides) -> tuple[System, Trajectory]:
    """A run of the scene, from whose samples the inputs of timed functions are taken."""
    its = system(kernels, "double", dict(overrides.settings))
    until = plan(its, overrides.until, overrides.step, overrides.integrator).until
    planned = plan(its, overrides.until, overrides.step, overrides.integrator,
                   every=until / (ELEMENTS - 1))
    with Progress(its, until) as watch:
        trajectory = integrate(its, planned, watch)
    if trajectory.interrupted:
        raise KeyboardInterrupt
    return its, trajectory


def _rows(built: Sequence[Compiled], states: tuple[System, Trajectory]) -> Iterator[Row]:
    """Each function of the whole scene and the same function of the other parts, timed in turn, in
    both precisions."""
    for name in (f.name for f in _functions(built[0].part)):
        chosen = [(x, f) for x in built for f in _functions(x.part) if f.name == name]
        loops = [x.loop(f, precision, _inputs(f, *states))
                 for x, f in chosen for precision in PRECISIONS]
        times = [x.time for x in timed_loops(built[0].library, loops, 1e9 * _SECONDS * len(loops))]
        for (x, f), double, single in zip(chosen, times[::2], times[1::2], strict=True):
            yield Row(x.part.words, f.name, counts_in_words(f.program), flops(f.program),
                      (double, single))


def _inputs(function: Function, its: System, trajectory: Trajectory) -> list[np.ndarray]:
    """ELEMENTS of each of the function's inputs, from the run."""
    chosen = np.resize(np.arange(len(trajectory.t)), ELEMENTS)
    t, q, v = (x[chosen] for x in (trajectory.t, trajectory.q, trajectory.v))
    values = {"t": t, "p": np.tile(np.array(its.p), (ELEMENTS, 1)), "q": q, "v": v,
              "a": accelerations(its, t, q, v), "tau": np.zeros_like(v), "phi": 1e-3 * v,
              "h": np.full(ELEMENTS, 1e-3)}
    if its.has("free_momentum"):
        values["c"] = np.asarray(its.call("free_momentum", q=q, v=v))
    return [values[a.name] for a in function.program.inputs]


def _progress(items: Iterable[Item], what: str, total: int | None) -> Iterator[Item]:
    """The items, with a progress bar on standard error if that is a terminal."""
    yield from tqdm(items, what, total, leave=False, disable=None, file=sys.stderr)
