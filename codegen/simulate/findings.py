"""Findings of a check, and what they amount to: frozen data."""

import math
from dataclasses import dataclass

from coscrew_codegen.formats import BY_NAME
from coscrew_codegen.integrator import Integrator
from coscrew_codegen.scene.scene import Expectation
from coscrew_codegen.simulate.balance import Balance
from coscrew_codegen.simulate.record import Difference

ALLOWED = 1e-3
"""By how much energy may be off from the work of effects, relative to the energies moved; and
momentum of what floats free, to that of the largest speeds."""
FINER = 2
"""How much smaller steps are the second time,"""
FINEST = 8
"""and a third time, if these did not help where energy is off."""
STRICTLY = 1e-5
"""By how much energy may be off with --strict, where that is not rounding."""


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
    finest: Balance | None  # with much smaller ones, where these did not help and energy is off
    round_trip: float  # the largest |aba(rnea(a)) - a| / (|a| + |aba(0)|), in unit roundoffs
    condition: float  # of the mass matrix, the largest along the run
    at: float  # where that is, in s
    integrator: Integrator
    limits: bool  # whether the scene has limits
    speeds: tuple[float, str] = (0.0, "")  # by how much a joint's speed differs from that with
    # smaller steps, of its largest, at most, and which joint's
    part: float = math.inf  # of steps in which limits close, in s, if energy is off for its length
    double: "Along | None" = None  # what double precision showed, beside single

    @property
    def as_double(self) -> bool:
        """Whether the defect of energy is that of double precision."""
        return bool(self.double and self.double.coarse.relative >= 0.5 * self.coarse.relative)

    @property
    def shrinks(self) -> bool:
        """Whether smaller steps make the defect of energy smaller."""
        return (self.fine_helps or bool(self.finest and self.less(self.finest, 0.75**3))
                or bool(self.double and self.as_double and self.double.shrinks))

    @property
    def fine_helps(self) -> bool:
        """Whether the first that are smaller do."""
        return self.less(self.fine)

    def less(self, other: Balance, times: float = 0.75) -> bool:
        """Whether the other's defect is at most this part of that of the steps asked for."""
        return other.relative <= times * self.coarse.relative

    @property
    def rounded(self) -> bool:
        """Whether it is no more than rounding of energies, and not that of double precision."""
        return self.coarse.rounded and not self.as_double

    @property
    def rounding(self) -> bool:
        """Whether it is no more than rounding adds up to, and neither the step's nor that of double
        precision."""
        u = float(BY_NAME[self.precision].u)
        return self.rounded or (self.coarse.relative <= 1e4 * u
                                       and not (self.shrinks or self.as_double))

    @property
    def untold(self) -> bool:
        """Whether rounding of the potential energy is more than all energy that was moved, so that
        energies tell nothing."""
        return self.rounded and self.coarse.rounding > self.coarse.scale

    @property
    def doubtful(self) -> bool:
        """Whether it is neither rounding nor the integrator's, which shrinks with steps."""
        return not (self.rounding or self.shrinks)

    @property
    def true(self) -> bool:
        """Whether energy and momentum are within ALLOWED, with smaller steps as well, as far as
        rounding lets energies tell."""
        return self.energy and self.fine_energy and self.coarse.momentum <= ALLOWED

    @property
    def energy(self) -> bool:
        """Whether energy is, with the steps asked for,"""
        return self.rounded or self.coarse.relative <= ALLOWED

    @property
    def fine_energy(self) -> bool:
        """and with the first that are smaller."""
        return self.fine.rounded or self.fine.relative <= ALLOWED

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
    outside: str = ""  # joints that start outside their ranges, in words

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
