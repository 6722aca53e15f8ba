"""Errors of a whole run, told apart: of rounding, of the step, and of effects that are left out.

The run's own steps, computed with 40 digits, are the reference: what double or single precision
differs from it is rounding, of start, step and parameters, too.  Steps have no tier: they are
plain.  What steps a quarter as long change, also with 40 digits, is the error of the step; of an
integrator of order p all but 1/4^p of it.  What the same steps do without an effect is its share of
the model.  All are given at several times, since they grow, in chaotic motion without limit.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import mpmath
import numpy as np
from mpmath import mpf

from coscrew_codegen.cost.leaving_out import leaving_out
from coscrew_codegen.formats import PRECISIONS
from coscrew_codegen.integrators import NAMES, named
from coscrew_codegen.program.interpreter import Arithmetic, by_operation, exactly, interpreter
from coscrew_codegen.program.multiprecise import MULTIPRECISE
from coscrew_codegen.scene_functions import Call, SceneFunctions, Split, Step
from coscrew_codegen.simulate.load import Kernels
from coscrew_codegen.simulate.outcome import RunOverrides
from coscrew_codegen.simulate.plan import plan
from coscrew_codegen.simulate.system import System, system

DIGITS = 40
FINER = 4
MOST = 4_000_000
"""Instructions computed with DIGITS: some ten seconds."""
_PARTS = (8, 4, 2, 1)  # the errors are given after one in 8, 4, 2 and 1 of the steps

Number: TypeAlias = Any  # of mpmath, or a double
Numbers = Sequence[Number]
State = tuple[Numbers, Numbers]
DOUBLES: Arithmetic[Number] = by_operation(
    lambda x: np.float64(float(x.double)), exactly(np), np.float64(np.nan))


@dataclass(frozen=True)
class RunError:
    """What a cause changes in a run: the largest difference of a coordinate, in m or rad
    (quaternions: of a component), at each time; inf where the run has stopped."""

    cause: str  # rounding, step, model
    of: str  # double, single; "0.0005 s"; "without viscous"
    errors: tuple[float, ...]


@dataclass(frozen=True)
class RunErrors:
    """The errors of a run with an emitted integrator, over its first steps."""

    integrator: str
    step: float  # s
    until: float  # s, of the whole run
    times: tuple[float, ...]
    rows: tuple[RunError, ...]


def run_errors(kernels: Kernels, overrides: RunOverrides, most: int = MOST) -> RunErrors | None:
    """The errors of the run, as far as `most` instructions allow; None if SciPy integrates it."""
    its = [system(kernels, p.name, dict(overrides.settings)) for p in PRECISIONS]
    planned = plan(its[0], overrides.until, overrides.step, overrides.integrator)
    if planned.integrator not in NAMES or not named(planned.integrator).emitted:
        return None
    whole = kernels.functions
    name, h = named(planned.integrator).step_name, planned.step
    step = next(x for x in whole.steps if x.name == name)
    each = sum(len(whole.named(call.function).program.instructions) for call in step.calls)
    count = max(1, min(math.ceil(planned.until / h), most // ((1 + FINER) * each)))
    marks = sorted({max(1, count // n) for n in _PARTS})
    start, p = its[0].start(), dict(zip(
        (x for x, _ in whole.parameters), its[0].p, strict=True))
    with mpmath.workdps(DIGITS):
        run = _Run(whole, step, MULTIPRECISE, lambda x: mpf(float(x)), p)
        exact = run.states(start, mpf(h), marks)
        fine = run.states(start, mpf(h) / FINER, [FINER * n for n in marks])
        rows = [RunError("rounding", x.precision.name, _apart(
            x, exact, _compiled(x, name, h, marks))) for x in its]
        rows += [RunError("step", f"{h:g} s", _apart(its[0], exact, fine))]
    for words, functions in leaving_out(its[0].scene, (name,)):
        of = _Run(functions, next(x for x in functions.steps if x.name == name), DOUBLES,
                  np.float64, p)
        with np.errstate(all="ignore"):
            rows += [RunError("model", words, _apart(
                its[0], exact, of.states(start, np.float64(h), marks)))]
    return RunErrors(planned.integrator, h, planned.until, tuple(n * h for n in marks),
                     tuple(rows))


@dataclass(frozen=True)
class _Run:
    """A scene's steps on some kind of numbers."""

    scene: SceneFunctions
    step: Step
    arithmetic: Arithmetic[Number]
    number: Callable[[float], Number]
    p: Mapping[str, float]  # values of parameters, by name

    def states(self, start: tuple[np.ndarray, np.ndarray], h: Number, marks: Sequence[int]
               ) -> list[State]:
        """(q, v) after these numbers of steps."""
        functions = {x.function: interpreter(self.scene.named(x.function).program, self.arithmetic)
                     for x in self.step.calls}
        q, v = ([self.number(x) for x in part] for part in start)
        known: dict[str, Numbers] = {
            "h": [h], "p": [self.number(self.p[x]) for x, _ in self.scene.parameters],
            "q": q, "v": v, **{x: [self.number(0)] * len(v) for x in self.step.zeros}}
        found = []
        for n in range(marks[-1]):
            values = {**known, "t": [h * n]}
            for part in self.step.body:
                self._do(part, functions, values)
            known |= {"q": values["q"], "v": values["v"]}
            if n + 1 in marks:
                found.append((values["q"], values["v"]))
        return found

    def _do(self, part: Call | Split, functions: Mapping[str, Callable[..., list[Number]]],
            values: dict[str, Numbers]) -> None:
        if isinstance(part, Call):
            program, given = self.scene.named(part.function).program, dict(part.given)
            results = functions[part.function](
                [values[given.get(a.name, a.name)] for a in program.inputs])
            for name, a in zip(part.results, program.outputs, strict=True):
                values[name], results = results[:a.quantity.size], results[a.quantity.size:]
            return
        (test,), (count, length) = part.test.results, part.parts.results
        self._do(part.test, functions, values)
        values |= {count: [self.number(1)], length: values["h"]}
        if values[test][0]:
            self._do(part.parts, functions, values)
        times = values[count][0]
        for _ in range(int(times) if times == times else 0):  # NaN: the run has stopped
            for call in part.calls:
                self._do(call, functions, values)


def _compiled(its: System, name: str, h: float, marks: Sequence[int]) -> list[State]:
    """(q, v) after these numbers of compiled steps."""
    run, found = its.stepper(name), list[State]()
    q, v = its.start()
    with np.errstate(all="ignore"):
        for before, after in zip((0, *marks), marks, strict=False):
            q, v = run(after - before, before * h, h, np.array(q), np.array(v))
            found.append((list(q), list(v)))
    return found


def _apart(its: System, exact: Sequence[State], found: Sequence[State]) -> tuple[float, ...]:
    """The largest difference of a coordinate; q and -q of a quaternion are the same."""
    return tuple(_difference(its, x, y) for (x, _), (y, _) in zip(exact, found, strict=True))


def _difference(its: System, exact: Numbers, found: Numbers) -> float:
    other = [x if isinstance(x, mpf) else mpf(float(x)) for x in found]
    with mpmath.workdps(DIGITS):
        for places in its.quaternions:
            if sum(x * y for x, y in zip(exact[places], other[places], strict=True)) < 0:
                other[places] = [-x for x in other[places]]
        worst = max((abs(x - y) for x, y in zip(exact, other, strict=True)), default=mpf(0))
    return float(worst) if mpmath.isfinite(worst) else math.inf
