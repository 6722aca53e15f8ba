"""Checks a scene's run against what must hold: the balance of energy, the scene's expectations, the
same motion in both precisions, forward dynamics as the inverse of inverse dynamics."""

import math
from dataclasses import dataclass, replace

import numpy as np
from tabulate import tabulate

from coscrew_codegen.dynamics.quantities import expected, recorded
from coscrew_codegen.dynamics.scene import Expectation
from coscrew_codegen.integrators import DEFAULT, named
from coscrew_codegen.simulate.balance import Balance, balance
from coscrew_codegen.simulate.outcome import Asked, gaps
from coscrew_codegen.simulate.plan import Plan, Trajectory, plan
from coscrew_codegen.simulate.progress import Progress
from coscrew_codegen.simulate.record import (
    Difference,
    accelerations,
    differences,
    largest,
    quantity,
)
from coscrew_codegen.simulate.recording import Column, Recording
from coscrew_codegen.simulate.run import integrate
from coscrew_codegen.simulate.system import System, system

ALLOWED = 1e-3
"""By how much energy may be off from the work of effects, relative to the energies moved; and
momentum of what floats free, to that of the largest speeds."""
STRICTLY = 1e-5
"""By how much energy may be off with --strict, where that is not rounding."""
_MOST_STEPS = 200_000  # samples whose energies are summed
_STATES = 1000  # along the run, at which matrices are looked at
_FINER = 2  # how much smaller steps are the second time;
_TIGHTER = 16  # or tolerances


@dataclass(frozen=True)
class Met:
    """An expectation, and what came."""

    wanted: Expectation
    came: float  # NaN if the run did not get there
    unit: str

    @property
    def passed(self) -> bool:
        """|came - value| <= rtol |value| + atol."""
        wanted = self.wanted
        return abs(self.came - wanted.value) <= wanted.rtol * abs(wanted.value) + wanted.atol


@dataclass(frozen=True)
class Along:
    """What one precision's run showed."""

    precision: str
    step: str  # in words
    stopped: str
    coarse: Balance  # of energy
    fine: Balance  # the same with smaller steps
    round_trip: float  # the largest |aba(rnea(a)) - a| / (|a| + |aba(0)|), in unit roundoffs
    condition: float  # of the mass matrix, the largest along the run
    at: float  # where that is, in s
    order: int  # of the integrator
    double: "Along | None" = None  # what double precision showed, beside single

    @property
    def as_double(self) -> bool:
        """Whether the defect of energy is that of double precision."""
        return bool(self.double and self.double.coarse.relative >= 0.5 * self.coarse.relative)

    @property
    def shrinks(self) -> bool:
        """Whether smaller steps make the defect of energy smaller."""
        return (self.fine.relative <= 0.75 * self.coarse.relative
                or self.as_double and self.double.shrinks)

    @property
    def rounding(self) -> bool:
        """Whether it is no more than rounding adds up to, and neither the step's nor that of double
        precision."""
        u = 2.0 ** (-53 if self.precision == "double" else -24)
        return self.coarse.relative <= 1e4 * u and not (self.shrinks or self.as_double)

    @property
    def doubtful(self) -> bool:
        """Whether it is neither rounding nor the integrator's, which shrinks with steps."""
        return not (self.rounding or self.shrinks)

    @property
    def true(self) -> bool:
        """Whether energy and momentum are within ALLOWED."""
        return self.coarse.relative <= ALLOWED and self.coarse.momentum <= ALLOWED

    @property
    def strictly_true(self) -> bool:
        """Whether they are within STRICTLY or rounding, and nothing is doubtful."""
        energy = self.rounding or self.coarse.relative <= STRICTLY
        return energy and self.true and not self.doubtful


@dataclass(frozen=True)
class Findings:
    """All checks of a scene."""

    met: tuple[Met, ...]
    along: tuple[Along, ...]  # double, single, or one of them
    apart: tuple[Difference, ...]  # of both

    @property
    def passed(self) -> bool:
        """Whether all expectations are met, by runs that got to their ends and kept energy and
        momentum."""
        return all(x.passed for x in self.met) and all(
            x.true and not x.stopped for x in self.along)

    @property
    def strictly_passed(self) -> bool:
        """Whether energies are also within STRICTLY, none of them doubtful."""
        return self.passed and all(x.strictly_true for x in self.along)


def check(kernels: object, asked: Asked) -> Findings:
    """Run the scene in both precisions, or the one asked for, with its steps and with smaller ones.
    Expectations are of double precision, unless the scene or `asked` is of single.  Raises
    SimulateError."""
    names = (asked.precision,) if asked.precision in ("double", "single") else ("double", "single")
    runs = {name: _run(kernels, name, asked) for name in names}
    meant = "single" if (asked.precision or kernels.scene.precision) == "single" else "double"
    its, _, trajectory = runs[meant]
    met = tuple(_met(its, trajectory, x) for x in kernels.scene.expectations)
    along = [_along(*run) for run in runs.values()]
    if len(along) == 2:
        along[1] = replace(along[1], double=along[0])
    apart = differences(*(_sparse(x, y) for x, _, y in runs.values())) if len(runs) == 2 else ()
    return Findings(met, tuple(along), apart)


def _run(kernels: object, precision: str, asked: Asked) -> tuple[System, Plan, Trajectory]:
    """A run that is sampled at every step; SciPy's as densely."""
    its = system(kernels, precision, dict(asked.settings))
    rough = plan(its, asked.until, asked.step, asked.integrator)
    count = max(2, min(math.ceil(rough.until / rough.step), _MOST_STEPS))
    planned = replace(rough, every=rough.until / count,
                      also=tuple(x.at for x in its.scene.expectations))
    return its, planned, _integrated(its, planned)


def _integrated(system: System, planned: Plan) -> Trajectory:
    with Progress(system, planned.until) as watch:
        trajectory = integrate(system, planned, watch)
    if trajectory.interrupted:
        raise KeyboardInterrupt
    return trajectory


def _met(system: System, trajectory: Trajectory, wanted: Expectation) -> Met:
    asked = expected(wanted.quantity, system.scene)
    near = int(np.argmin(np.abs(trajectory.t - wanted.at)))
    came = math.nan
    if abs(trajectory.t[near] - wanted.at) <= 1e-9 * max(1.0, wanted.at):
        one = _chosen(trajectory, np.array([near]))
        came = float(quantity(system, one, asked)[0, 0])
    return Met(wanted, came, asked.units[0])


def _along(system: System, planned: Plan, trajectory: Trajectory) -> Along:
    if planned.adaptive:
        finer = replace(planned, rtol=planned.rtol / _TIGHTER, atol=planned.atol / _TIGHTER,
                        every=planned.every / _FINER)  # or else Simpson's error would stay
        step = f"rtol {planned.rtol:.3g}"
    else:
        finer = replace(planned, step=planned.step / _FINER, every=planned.every / _FINER)
        step = f"step {planned.step:g} s"
    again = _integrated(system, finer)
    with np.errstate(all="ignore"):  # a run that stopped ends with huge numbers
        round_trip, condition, at = _matrices(system, trajectory)
    return Along(system.precision.name, step, trajectory.stopped, balance(system, trajectory),
                 balance(system, again), round_trip, condition, at,
                 named(planned.integrator).order)


def _matrices(system: System, trajectory: Trajectory) -> tuple[float, float, float]:
    """Round trip in unit roundoffs, condition of the mass matrix, and where that is largest."""
    t, q, v = (x[_some(trajectory)] for x in (trajectory.t, trajectory.q, trajectory.v))
    free = accelerations(system, t, q, v)
    size = np.abs(free).max(-1, keepdims=True, initial=1)
    other = size * np.cos(np.arange(1, free.shape[-1] + 1))
    a = (free + other).astype(system.dtype)  # other than that of the effects alone
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
    """Numbers of at most _STATES samples, the first and the last among them."""
    n = len(trajectory.t)
    return np.unique(np.linspace(0, n - 1, min(n, _STATES)).round().astype(int))


def _chosen(trajectory: Trajectory, samples: np.ndarray) -> Trajectory:
    return Trajectory(*(x[samples] for x in (trajectory.t, trajectory.q, trajectory.v)), 0, 0)


def _sparse(system: System, trajectory: Trajectory) -> Recording:
    """The state and what the scene records, at some of the samples."""
    some = _chosen(trajectory, _some(trajectory))
    texts = dict.fromkeys(("q", "v", *system.scene.record))
    asked = [recorded(text, system.scene) for text in texts]
    columns = tuple(Column(name, unit, x.quantity) for x in asked
                    for name, unit in zip(x.names, x.units, strict=True))
    return Recording(some.t, columns, np.concatenate(
        [quantity(system, some, x) for x in asked], 1), ())


def table(findings: Findings) -> str:
    """The findings as text."""
    parts = [_expectations(findings.met)] if findings.met else []
    parts += [_checks(findings.along)]
    parts += [gaps(findings.apart)] if findings.apart else []
    parts += [f"{x.precision}: {x.stopped}" for x in findings.along if x.stopped]
    parts += [f"FALSE: {x.precision}: {_false(x)}" for x in findings.along
              if not (x.true or x.stopped)]
    return "\n\n".join(parts)


def _expectations(met: tuple[Met, ...]) -> str:
    rows = [("pass" if x.passed else "FAIL", x.wanted.quantity, x.wanted.at, x.wanted.value, x.came,
             abs(x.came - x.wanted.value), x.wanted.rtol * abs(x.wanted.value) + x.wanted.atol,
             x.unit) for x in met]
    return tabulate(rows, ("", "expected", "at t, s", "value", "came", "apart", "allowed", "unit"),
                    floatfmt=("", "", "g", ".12g", ".12g", ".2g", ".2g", ""))


def _checks(along: tuple[Along, ...]) -> str:
    rows = [("energy off by, from the work of effects, relative, at most",
             *(f"{x.coarse.relative:.2g}" for x in along)),
            ("the same with " + " or ".join(dict.fromkeys(_finer(x) for x in along)),
             *(f"{x.fine.relative:.2g}" for x in along)),
            ("it is", *(_verdict(x) for x in along)),
            *([("momentum of what floats free off by, relative, at most",
                *(f"{x.coarse.momentum:.2g}" for x in along))]
              if any(x.coarse.momentum for x in along) else []),
            ("|aba(rnea(a)) - a| / (|a| + |aba(0)|), at most, in u",
             *(f"{x.round_trip:.3g}" for x in along)),
            ("condition of the mass matrix (SI units), at most",
             *(f"{x.condition:.3g}" for x in along)),
            ("where that is, t in s", *(f"{x.at:g}" for x in along))]
    return tabulate(rows, ("", *(f"{x.precision}, {x.step}" for x in along)), disable_numparse=True,
                    colalign=("left", *("right" for _ in along)))


def _false(along: Along) -> str:
    """What is off by more than is allowed, why, and what helps."""
    what, off = (("energy", along.coarse.relative) if not along.coarse.relative <= ALLOWED
                 else ("momentum", along.coarse.momentum))
    said = f"{what} is off by {off:.2g}, allowed is {ALLOWED:g}"
    if along.doubtful:
        return f"{said}, and smaller steps do not help: what the scene asks is not resolved"
    if along.step.startswith("rtol"):
        return f"{said}; take a smaller rtol"
    smaller = (0.5 * ALLOWED / off)**(1 / along.order)
    other = "" if along.order > 1 else f", or integrator {DEFAULT}"
    return f"{said}: the step is too large; take one {smaller:.1g} times as long{other}"


def _finer(along: Along) -> str:
    return "a sixteenth of the tolerance" if along.step.startswith("rtol") else "half the step"


def _verdict(along: Along) -> str:
    """What the defect of energy is."""
    if along.doubtful:
        return "DOUBTFUL: it does not shrink"
    if along.rounding:
        return "rounding"
    if along.step.startswith("rtol"):
        return "the integrator's: it shrinks"
    if along.fine.relative > 0.75 * along.coarse.relative:
        return "the integrator's, as in double"
    order = math.log(along.coarse.relative / along.fine.relative, _FINER)
    return f"the integrator's, of order {order:.1f}"
