"""Findings of a check, and the conclusions from them: frozen data."""

import math
from dataclasses import dataclass

from coscrew_codegen.program.values.formats import BY_NAME
from coscrew_codegen.scene.integrator import Integrator
from coscrew_codegen.scene.scene import Expectation
from coscrew_codegen.simulation.check.check_rounding import RoundedResults
from coscrew_codegen.simulation.check.contact_check import ContactsOfRun
from coscrew_codegen.simulation.check.energy_balance import Balance, Bristles
from coscrew_codegen.simulation.check.error_limits import ALLOWED, ENERGY, STRICTLY
from coscrew_codegen.simulation.check.step_advice import Error
from coscrew_codegen.simulation.loops.closure_check import Closures
from coscrew_codegen.simulation.recordings.record import Difference

SECOND_RUN = 2
"""Divisor of the step in the second run."""
THIRD_RUN = 8
"""Divisor of the step in the third run, made if energies are off, or if the second did not reduce
the defect of energy."""


@dataclass(frozen=True)
class Met:
    """An expectation and the value that was reached."""

    wanted: Expectation
    came: float  # NaN if the run stopped before
    unit: str

    @property
    def passed(self) -> bool:
        """|came - value| <= rtol |value| + atol."""
        wanted = self.wanted
        return abs(self.came - wanted.value) <= wanted.rtol * abs(wanted.value) + wanted.atol


@dataclass(frozen=True)
class AlongRun:
    """Results of the runs in one precision."""

    precision: str
    step: str  # in words
    stopped: str
    coarse: Balance  # of energy, with the given steps
    fine: Balance  # with steps smaller by SECOND_RUN
    finest: Balance | None  # with steps smaller by THIRD_RUN, if `fine` did not reduce the defect
    round_trip: float  # the largest |f(g(a)) - a| / (|a| + |f(0)|) of forward and inverse dynamics,
    # f and g, in unit roundoffs
    condition: float  # of the mass matrix, the largest along the run
    at: float  # where that is, in s
    integrator: Integrator
    length: float  # of steps in s; 0 for SciPy's
    error: Error  # of the motion, while it is known
    known: float  # time up to which motions with smaller steps agree, in s
    end: float  # of the run, in s
    smallest: float  # steps of the motion with which it was compared, in s
    resting: bool = False  # no part moves farther than a resting one may
    exact: Balance | None = None  # of that motion, if energies are off with the steps above
    double: "AlongRun | None" = None  # in single precision: the results in double
    remedy: str = ""  # settings that were tried and make a false run right
    loops: Closures | None = None  # of scenes with closed loops
    contacts: ContactsOfRun | None = None  # of scenes in which bodies touch
    bristles: Bristles | None = None  # of scenes in which friction holds, sampled at every step

    @property
    def as_double(self) -> bool:
        """True if the defect of energy is the same in double precision."""
        return bool(self.double and self.double.coarse.relative >= 0.5 * self.coarse.relative)

    @property
    def shrinks(self) -> bool:
        """True if smaller steps make the defect of energy smaller."""
        return (self.fine_helps or bool(self.finest and self.less(self.finest, 0.75**3))
                or bool(self.double and self.as_double and self.double.shrinks))

    @property
    def fine_helps(self) -> bool:
        """True if steps smaller by SECOND_RUN make it smaller."""
        return self.less(self.fine)

    @property
    def order(self) -> float:
        """The order of the defect of energy in the step; 0 if it does not shrink.  In single
        precision the order in double, if the defect is the same: rounding disturbs its own."""
        if self.double and self.as_double:
            return self.double.order
        finer, times = (self.fine, SECOND_RUN) if self.fine_helps else (self.finest, THIRD_RUN)
        if finer is None or not (finer.relative and self.less(finer)):
            return 0.0
        return math.log(self.coarse.relative / finer.relative, times)

    def less(self, other: Balance, times: float = 0.75) -> bool:
        """Returns whether the other's defect is at most `times` that of the given steps."""
        return other.relative <= times * self.coarse.relative

    @property
    def rounded(self) -> bool:
        """True if the defect is within the rounding error of energies, and not also in double."""
        return self.coarse.rounded and not self.as_double

    @property
    def rounding(self) -> bool:
        """True if the defect can be accumulated rounding: it depends neither on the step nor is it
        the same in double precision."""
        u = float(BY_NAME[self.precision].u)
        return self.rounded or (self.coarse.relative <= 1e4 * u
                                       and not (self.shrinks or self.as_double))

    @property
    def still(self) -> bool:
        """True if nothing moves, so that no energy is exchanged."""
        return self.coarse.scale == 0

    @property
    def meaningless(self) -> bool:
        """True if the rounding error of the potential energy exceeds all energy that was moved, so
        that the balance is meaningless."""
        return self.rounded and self.coarse.rounding > self.coarse.scale

    @property
    def doubtful(self) -> bool:
        """True if the defect is neither rounding nor the integrator's, which shrinks with steps."""
        return not (self.rounding or self.shrinks)

    @property
    def right(self) -> bool:
        """True if the motion is right while it is known."""
        return self.error.relative <= ALLOWED

    @property
    def resolved(self) -> bool:
        """True if the motion is known to the end."""
        return self.known >= self.end

    @property
    def balanced(self) -> bool:
        """True if energies balance, with the given steps or smaller ones; true if all parts rest.
        """
        balances = (x for x in (self.coarse, self.fine, self.finest, self.exact) if x is not None)
        return not math.isnan(self.coarse.relative) and (
            self.resting or any(x.rounded or x.relative <= ENERGY for x in balances))

    @property
    def passed(self) -> bool:
        """True if the motion is known and right, energies balance, loops stay closed, contacts
        push, and friction dissipates."""
        return (self.right and self.resolved and self.balanced
                and all(x is None or x.passed for x in (
                    self.loops, self.contacts, self.bristles)))

    @property
    def by_rounding(self) -> bool:
        """True if a motion is wrong that double precision gets right with the same steps."""
        return not self.right and bool(self.double and self.double.right)

    @property
    def strictly_passed(self) -> bool:
        """True if the motion is also within STRICTLY."""
        return self.passed and self.error.relative <= STRICTLY


@dataclass(frozen=True)
class Findings:
    """All checks of a scene."""

    met: tuple[Met, ...]
    along: tuple[AlongRun, ...]  # in double, single, or one of them
    apart: tuple[Difference, ...]  # between both
    outside: str = ""  # joints that start outside their ranges, in words
    rounding: tuple[RoundedResults, ...] = ()  # of the judged functions
    mobility: str = ""  # the freedoms that closed loops leave, in words
    contact_distances: tuple[float, ...] = ()  # between the points of each contact in both
    # precisions, the largest, in m

    @property
    def passed(self) -> bool:
        """True if all expectations are met, all runs reached their ends and were right, energies
        balance, and all certified bounds hold."""
        held = not any(x.certified and x.certified.broken for x in self.rounding)
        return held and all(x.passed for x in self.met) and all(
            x.passed and not x.stopped for x in self.along)

    @property
    def strictly_passed(self) -> bool:
        """True if motions are also within STRICTLY."""
        return self.passed and all(x.strictly_passed for x in self.along)
