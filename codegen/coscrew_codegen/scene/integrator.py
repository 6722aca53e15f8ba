"""Integrators: a name, an order, and a scheme as data.

A scheme is a Tableau (explicit Runge–Kutta), a Composition of drifts and kicks, or Adaptive (a
solver of SciPy).  Knows no dynamics and no language: `dynamics/integrator_steps.py`
turns schemes into steps.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

Row = tuple[Fraction, ...]

ONE = Fraction(1)


@dataclass(frozen=True)
class Tableau:
    """An explicit Runge–Kutta method, as Butcher writes it.

    k_i = f(t + c_i h, y + h Σ_j a_ij k_j),   y' = y + h Σ_i b_i k_i,   c_i = Σ_j a_ij.

    `a` has a row for every stage but the first.  The state is y = (φ, v), where the positions are
    q ⊕ φ.  Raises ValueError for a tableau that is not explicit, or whose b does not add up to 1.
    """

    a: tuple[Row, ...]
    b: Row

    def __post_init__(self) -> None:
        for number, row in enumerate(self.a, 1):
            if len(row) != number or not any(row):
                raise ValueError(f"stage {number + 1} of an explicit method: wanted {number} "
                                 f"weights, not all zero; got {_listed(row)}")
        if len(self.b) != len(self.a) + 1 or sum(self.b) != 1:
            raise ValueError(f"b: wanted {len(self.a) + 1} weights that add up to 1; "
                             f"got {_listed(self.b)}")

    @cached_property
    def c(self) -> Row:
        """The time of each stage as a fraction of the step; 0 for the first."""
        return (Fraction(0), *(sum(row, Fraction(0)) for row in self.a))


def tableau(*rows: str) -> Tableau:
    """A Tableau from rows of fractions, b last: tableau("1/2", "0 1") is the midpoint method."""
    *a, b = (tuple(map(Fraction, row.split())) for row in rows)
    return Tableau(tuple(a), b)


@dataclass(frozen=True)
class Drift:
    """q = q ⊕ part h v, t = t + part h."""

    part: Fraction = ONE


@dataclass(frozen=True)
class Kick:
    """v = v + part h a, with the acceleration a from the scene's function `by` at tau = 0."""

    by: str = "forward_dynamics"
    part: Fraction = ONE


@dataclass(frozen=True)
class Composition:
    """Drifts and kicks in order, each from the t, q and v that the one before has reached.

    Raises ValueError unless both the drifts and the kicks add up to one step."""

    stages: tuple[Drift | Kick, ...]
    splits: bool = False  # a step in which a limit is hit is taken in several parts
    keeps_momentum: bool = False  # of a floating base without gravity, except for rounding
    damps_bounces: bool = False  # a joint that hits a stiff limit loses its speed
    moves_states: bool = False  # those of effects move in its kicks

    def __post_init__(self) -> None:
        for kind in (Drift, Kick):
            total = sum((x.part for x in self.stages if isinstance(x, kind)), Fraction(0))
            if total != 1:
                raise ValueError(f"{kind.__name__.lower()}s: wanted parts that add up to 1; "
                                 f"they add up to {total}")


@dataclass(frozen=True)
class Adaptive:
    """SciPy's solver of this name, which chooses its steps by tolerances."""

    solver: str
    implicit: bool = False  # needs the Jacobian of the rates


Scheme = Tableau | Composition | Adaptive


@dataclass(frozen=True)
class Integrator:
    """An integrator of scenes."""

    name: str  # in scenes and commands
    order: int
    good_for: str  # and its limits
    scheme: Scheme
    equation: str = ""  # of its step, if it is emitted

    @property
    def emitted(self) -> bool:
        """True if its step is emitted as a function of the scene; if not, SciPy takes the steps."""
        return not isinstance(self.scheme, Adaptive)

    @property
    def step_name(self) -> str:
        """The name of its step function; "" if that is not emitted."""
        return f"step_{self.name.replace('-', '_')}" if self.emitted else ""

    @property
    def step_with_tau(self) -> str:
        """The name of its step function that takes torques of joints; "" if there is none."""
        return f"{self.step_name}_tau" if self.emitted else ""

    @property
    def splits(self) -> bool:
        """True if a step in which a limit is hit is taken in several parts."""
        return isinstance(self.scheme, Composition) and self.scheme.splits

    @property
    def keeps_momentum(self) -> bool:
        """True if it keeps the momentum of a floating base."""
        return isinstance(self.scheme, Composition) and self.scheme.keeps_momentum

    @property
    def damps_bounces(self) -> bool:
        """True if a joint that hits a stiff limit loses its speed."""
        return isinstance(self.scheme, Composition) and self.scheme.damps_bounces


def _listed(row: Sequence[Fraction]) -> str:
    return " ".join(map(str, row)) or "none"
