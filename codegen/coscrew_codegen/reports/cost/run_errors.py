"""Splits the errors of a whole run by cause: rounding, the step, and effects that are left out.

The run's own steps, computed with 40 digits, are the reference: the difference of a precision and a
tier from it is rounding, which includes that of start, step and parameters.  A run in a tier calls
all functions of its steps in that tier and rounds their results to the precision.  The change by
steps a quarter as long, also with 40 digits, is the error of the step; for an integrator of order p
it is all but 1/4^p of that error.  The change of the same steps without an effect is its share of
the model.

All are given at several times, since errors grow, in chaotic motion exponentially, until no digit
is right.  The reference stays exact longer: where a double's error is less than the motion itself,
more than 20 of 40 digits are left."""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

import gmpy2
import numpy as np
from gmpy2 import mpfr

from coscrew_codegen.accuracy.tiers import PLAIN
from coscrew_codegen.program.in_python import FLOATS
from coscrew_codegen.program.multiprecise import MULTIPRECISE, precise
from coscrew_codegen.program.scene_functions import IntegratorStep, SceneFunctions
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.reports.cost.effect_ablation import leaving_out
from coscrew_codegen.reports.cost.step_interpreter import (
    Functions,
    Numbers,
    State,
    StepRun,
    functions_on,
)
from coscrew_codegen.runtime.console import doing
from coscrew_codegen.runtime.load import Kernels, in_tier_of
from coscrew_codegen.scene.integrators import NAMES, named
from coscrew_codegen.scene.units import UNITS
from coscrew_codegen.simulation.plan import Plan, plan
from coscrew_codegen.simulation.run_summary import RunOverrides
from coscrew_codegen.simulation.system import System, system

DIGITS = 40
FINER = 4
MOST = 250_000_000
"""Instructions computed with DIGITS: some twenty seconds."""
TIMES = 64
"""Number of times, at equal intervals, at which the errors are given."""
_LEAST = 0.1
"""Fraction of the largest coordinate with its unit, or of half a turn: an error that leaves no
digit."""


@dataclass(frozen=True)
class RunError:
    """Change of a run by one cause: the largest difference of a coordinate, in m or rad
    (quaternions: of a component), at each time; inf where the run has stopped."""

    cause: str  # rounding, step, model
    of: str  # double plain, single accurate; "0.0005 s"; "without viscous"
    errors: tuple[float, ...]
    gone: float | None = None  # s: time from which no digit of a coordinate is right


@dataclass(frozen=True)
class RunErrors:
    """The errors of a run with an emitted integrator."""

    integrator: str
    step: float  # s
    until: float  # s, of the whole run
    times: tuple[float, ...]
    rows: tuple[RunError, ...]
    most: int  # most instructions with many digits, which limit the times

    @property
    def whole(self) -> bool:
        """True if the times reach to the run's end."""
        return self.times[-1] > self.until - self.step


def run_errors(kernels: Kernels, overrides: RunOverrides, tiers: Sequence[tuple[str, Precision]],
               most: int = MOST) -> RunErrors | None:
    """The errors of the run in plain and these tiers, as far as `most` instructions allow; None if
    SciPy integrates it."""
    its = system(kernels, PRECISIONS[0].name, dict(overrides.settings))
    planned = plan(its, overrides.until, overrides.step, overrides.integrator)
    if planned.integrator not in NAMES or not named(planned.integrator).emitted:
        return None
    name = named(planned.integrator).step_name
    run = _Steps(kernels, overrides, planned,
                 next(x for x in kernels.functions.steps if x.name == name))
    with precise(DIGITS), doing(f"computing the run with {DIGITS} digits"):
        marks, exact, fine = run.exactly(most)
        times = tuple(n * planned.step for n in marks)
        compared = _Compared(its, times, exact)
        rows = [compared.row("rounding", f"{p.name} {PLAIN.name}", run.compiled(p, marks))
                for p in PRECISIONS]
        rows += [compared.row("rounding", f"{p.name} {tier}", run.in_tier(tier, p, marks))
                 for tier, p in tiers]
        rows.append(compared.row("step", f"{planned.step:g} s", fine))
        rows += [replace(compared.row("model", words, states), gone=None)
                 for words, states in run.without_effects(marks)]
    return RunErrors(planned.integrator, planned.step, planned.until, times, tuple(rows), most)


@dataclass(frozen=True)
class _Steps:
    """Runs the steps in each of the compared ways."""

    kernels: Kernels
    overrides: RunOverrides
    planned: Plan
    step: IntegratorStep

    @property
    def scene(self) -> SceneFunctions:
        return self.kernels.functions

    def exactly(self, most: int) -> tuple[list[int], list[State], list[State]]:
        """Returns numbers of steps, and the states after them; the same with steps a quarter as
        long."""
        h, start = self.planned.step, self._system(PRECISIONS[0]).start()
        each = sum(len(self.scene.named(x.function).program.instructions) for x in self.step.calls)
        count = max(1, min(math.ceil(self.planned.until / h), most // ((1 + FINER) * each)))
        marks = sorted({-(-count * n // TIMES) for n in range(1, TIMES + 1)})
        functions = functions_on(self.scene, self.step, MULTIPRECISE)
        coarse, fine = (self._run(self.scene, self.step, functions, mpfr) for _ in range(2))
        results = []
        for mark, *states in zip(
                marks, coarse.states(start, mpfr(h), marks),
                fine.states(start, mpfr(h) / FINER, [FINER * n for n in marks]), strict=True):
            results.append((mark, *states))
            if coarse.instructions + fine.instructions >= most:  # steps that are split take more
                break
        counts, exact, finer = zip(*results, strict=True)
        return list(counts), list(exact), list(finer)

    def compiled(self, precision: Precision, marks: Sequence[int]) -> list[State]:
        """Runs the compiled steps."""
        its, states = self._system(precision), list[State]()
        run, h = its.stepper(self.step.name), self.planned.step
        q, v = its.start()
        with np.errstate(all="ignore"):
            for before, after in zip((0, *marks), marks, strict=False):
                q, v = run(after - before, before * h, h, np.array(q), np.array(v))
                states.append((list(q), list(v)))
        return states

    def in_tier(self, tier: str, precision: Precision, marks: Sequence[int]) -> list[State]:
        """Runs the functions that the steps call, each in this tier."""
        names = tuple(sorted({x.function for x in self.step.calls}))
        part = replace(self.scene, steps=(), functions=tuple(
            replace(self.scene.named(x), internal=False) for x in names))
        made = getattr(in_tier_of(self.kernels, tier, part), precision.name)
        functions = {x: _on_numbers(part, x, getattr(made, x), precision) for x in names}
        with np.errstate(all="ignore"):
            run = self._run(self.scene, self.step, functions,
                            np.dtype(precision.numpy_type).type)
            return [*run.states(self._system(precision).start(), self.planned.step, marks)]

    def without_effects(self, marks: Sequence[int]) -> Iterator[tuple[str, list[State]]]:
        """Runs without each effect, and without any: yields words, and the states."""
        its = self._system(PRECISIONS[0])
        for words, scene in leaving_out(its.scene, (self.step.name,)):
            step = next(x for x in scene.steps if x.name == self.step.name)
            run = self._run(scene, step, functions_on(scene, step, FLOATS), float)
            with np.errstate(all="ignore"):
                yield words, [*run.states(its.start(), self.planned.step, marks)]

    def _run(self, scene: SceneFunctions, step: IntegratorStep, functions: Functions,
             number: Callable[..., object]) -> StepRun:
        values = zip((x for x, _ in self.scene.parameters), self._system(PRECISIONS[0]).p,
                     strict=True)
        return StepRun(scene, step, functions, number, dict(values))

    def _system(self, precision: Precision) -> System:
        return system(self.kernels, precision.name, dict(self.overrides.settings))


def _on_numbers(scene: SceneFunctions, name: str, function: Callable[..., object],
                precision: Precision) -> Callable[[Sequence[Numbers]], Numbers]:
    """Converts a function on arrays to one on the components of its inputs."""
    kind = np.dtype(precision.numpy_type)
    shapes = [a.quantity.shape for a in scene.named(name).program.inputs]

    def called(given: Sequence[Numbers]) -> Numbers:
        result = function(*[np.array(x, kind).reshape(shape) if shape else float(x[0])
                            for x, shape in zip(given, shapes, strict=True)])
        return np.concatenate([x.ravel() for x in result]) if isinstance(result, tuple) else (
            np.asarray(result).ravel())

    return called


class _Compared:
    """Differences from a run with many digits."""

    def __init__(self, its: System, times: Sequence[float], exact: Sequence[State]):
        self._system, self._times, self._exact = its, times, [list(q) for q, _ in exact]
        units = [unit for c in its.functions.coordinates for unit in UNITS["q"][c.kind]]
        units += [unit for _, unit in its.functions.states]
        largest = np.abs(np.array(self._exact, float)).max(axis=0)
        self._sizes = np.array([min(math.pi if unit == "rad" else math.inf, max(
            x for x, other in zip(largest, units, strict=True) if other == unit))
            for unit in units])

    def row(self, cause: str, of: str, states: Sequence[State]) -> RunError:
        """The largest differences of a coordinate at all times."""
        apart = np.array([self._apart(x, y) for x, (y, _) in zip(self._exact, states, strict=True)])
        gone = np.any(apart > _LEAST * self._sizes, axis=1)
        return RunError(cause, of, tuple(apart.max(axis=1).tolist()),
                        self._times[int(np.argmax(gone))] if gone.any() else None)

    def _apart(self, exact: Numbers, result: Numbers) -> list[float]:
        """Returns the difference of each coordinate; q and -q of a quaternion are the same."""
        other = [x if isinstance(x, mpfr) else mpfr(float(x)) for x in result]
        for places in self._system.quaternions:
            if sum(x * y for x, y in zip(exact[places], other[places], strict=True)) < 0:
                other[places] = [-x for x in other[places]]
        apart = (abs(x - y) for x, y in zip(exact, other, strict=True))
        return [float(x) if gmpy2.is_finite(x) else math.inf for x in apart]

