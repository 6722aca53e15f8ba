"""Findings of a check, and the conclusions from them: frozen data."""

import math
from dataclasses import dataclass

from coscrew_codegen.formats import BY_NAME
from coscrew_codegen.integrator import Integrator
from coscrew_codegen.scene.scene import Expectation
from coscrew_codegen.simulate.balance import Balance
from coscrew_codegen.simulate.check_rounding import Rounded
from coscrew_codegen.simulate.record import Difference

ALLOWED = 1e-3
"""Allowed defect of energy, relative to the energies moved; and allowed error of the momentum of
floating bases, relative to that of the largest velocities."""
FINER = 2
"""Divisor of the step in the second run."""
FINEST = 8
"""Divisor of the step in the third run, made if the second did not reduce the defect of energy."""
STRICTLY = 1e-5
"""Allowed defect of energy with --strict, unless it is rounding."""


@dataclass(frozen=True)
class Met:
    """An expectation and the value that was reached."""

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
    """Results of the runs in one precision."""

    precision: str
    step: str  # in words
    stopped: str
    coarse: Balance  # of energy, with the given steps
    fine: Balance  # with steps smaller by FINER
    finest: Balance | None  # with steps smaller by FINEST, if `fine` did not reduce the defect
    round_trip: float  # the largest |f(g(a)) - a| / (|a| + |f(0)|) of forward and inverse dynamics,
    # f and g, in unit roundoffs
    condition: float  # of the mass matrix, the largest along the run
    at: float  # where that is, in s
    integrator: Integrator
    limits: bool  # whether the scene has limits
    speeds: tuple[float, str] = (0.0, "")  # the largest difference of a joint's velocity from that
    # with smaller steps, relative to its largest; and the joint
    part: float = math.inf  # length in s of parts of split steps, if it causes the defect of energy
    length: float = 0.0  # of steps in s; 0 for SciPy's
    double: "Along | None" = None  # in single precision: the results in double
    helps: bool | None = None  # in single precision: whether the advised step does, if it was tried

    @property
    def as_double(self) -> bool:
        """Whether the defect of energy is the same in double precision."""
        return bool(self.double and self.double.coarse.relative >= 0.5 * self.coarse.relative)

    @property
    def shrinks(self) -> bool:
        """Whether smaller steps make the defect of energy smaller."""
        return (self.fine_helps or bool(self.finest and self.less(self.finest, 0.75**3))
                or bool(self.double and self.as_double and self.double.shrinks))

    @property
    def fine_helps(self) -> bool:
        """Whether steps smaller by FINER make it smaller."""
        return self.less(self.fine)

    def less(self, other: Balance, times: float = 0.75) -> bool:
        """Whether the other's defect is at most `times` that of the given steps."""
        return other.relative <= times * self.coarse.relative

    @property
    def rounded(self) -> bool:
        """Whether the defect is within the rounding error of energies, and not also in double."""
        return self.coarse.rounded and not self.as_double

    @property
    def rounding(self) -> bool:
        """Whether the defect can be accumulated rounding: it depends neither on the step nor is it
        the same in double precision."""
        u = float(BY_NAME[self.precision].u)
        return self.rounded or (self.coarse.relative <= 1e4 * u
                                       and not (self.shrinks or self.as_double))

    @property
    def still(self) -> bool:
        """Whether nothing moves, so that no energy is exchanged."""
        return self.coarse.scale == 0

    @property
    def untold(self) -> bool:
        """Whether the rounding error of the potential energy exceeds all energy that was moved, so
        that the balance is meaningless."""
        return self.rounded and self.coarse.rounding > self.coarse.scale

    @property
    def doubtful(self) -> bool:
        """Whether the defect is neither rounding nor the integrator's, which shrinks with steps."""
        return not (self.rounding or self.shrinks)

    @property
    def true(self) -> bool:
        """Whether energy and momentum are within ALLOWED, also with smaller steps, as far as
        rounding allows a statement."""
        return self.energy and self.fine_energy and self.coarse.momentum <= ALLOWED

    @property
    def energy(self) -> bool:
        """Whether energy is within ALLOWED with the given steps."""
        return self.rounded or self.coarse.relative <= ALLOWED

    @property
    def fine_energy(self) -> bool:
        """Whether energy is within ALLOWED with steps smaller by FINER."""
        return self.fine.rounded or self.fine.relative <= ALLOWED

    @property
    def strictly_true(self) -> bool:
        """Whether energy and momentum are within STRICTLY or rounding, and nothing is doubtful."""
        energy = self.rounding or self.coarse.relative <= STRICTLY
        return energy and self.true and not self.doubtful


@dataclass(frozen=True)
class Findings:
    """All checks of a scene."""

    met: tuple[Met, ...]
    along: tuple[Along, ...]  # in double, single, or one of them
    apart: tuple[Difference, ...]  # between both
    outside: str = ""  # joints that start outside their ranges, in words
    rounding: tuple[Rounded, ...] = ()  # of the judged functions

    @property
    def passed(self) -> bool:
        """Whether all expectations are met, all runs reached their ends and kept energy and
        momentum, and all certified bounds hold."""
        held = not any(x.certified and x.certified.broken for x in self.rounding)
        return held and all(x.passed for x in self.met) and all(
            x.true and not x.stopped for x in self.along)

    @property
    def strictly_passed(self) -> bool:
        """Whether energies are also within STRICTLY and not doubtful."""
        return self.passed and all(x.strictly_true for x in self.along)
