"""What an integrator is: a name, an order, and its scheme as data.

A scheme is a Tableau (explicit Runge–Kutta methods), a Composition of drifts and kicks, or Adaptive
(SciPy's).  Knows no dynamics and no language: `mechanics/steps.py` makes steps of schemes.
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

    `a` has the rows of all stages but the first, which has none.  The state is y = (φ, v): φ moves
    q by q ⊕ φ.  Raises ValueError for a tableau that is not explicit, or whose b does not add up
    to 1."""

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
        """When each stage is, in steps; the first at 0."""
        return (Fraction(0), *(sum(row, Fraction(0)) for row in self.a))


def tableau(*rows: str) -> Tableau:
    """The Tableau of these rows of fractions, b last: tableau("1/2", "0 1") is the midpoint's."""
    *a, b = (tuple(map(Fraction, row.split())) for row in rows)
    return Tableau(tuple(a), b)


@dataclass(frozen=True)
class Drift:
    """q = q ⊕ part h v, and time goes on by part h."""

    part: Fraction = ONE


@dataclass(frozen=True)
class Kick:
    """v = v + part h a, where a comes from the function `by` of the scene; tau is 0."""

    by: str = "forward_dynamics"
    part: Fraction = ONE


@dataclass(frozen=True)
class Composition:
    """Drifts and kicks, each from where the one before left t, q and v.

    Raises ValueError unless both the drifts and the kicks add up to one step."""

    stages: tuple[Drift | Kick, ...]
    splits: bool = False  # takes a step in which limits close in parts
    keeps_momentum: bool = False  # of what floats free, but for gravity, to rounding
    damps_bounces: bool = False  # what meets a stiff limit loses its speed

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
    implicit: bool = False  # asks for the Jacobian of the rates


Scheme = Tableau | Composition | Adaptive


@dataclass(frozen=True)
class Integrator:
    """One of them."""

    name: str  # as scenes and commands call it
    order: int
    good_for: str  # and what not
    scheme: Scheme
    equation: str = ""  # of a step that is emitted

    @property
    def emitted(self) -> bool:
        """Whether its steps are functions of a scene; else SciPy's."""
        return not isinstance(self.scheme, Adaptive)

    @property
    def step_name(self) -> str:
        """The step's function; "" of those that are not emitted."""
        return f"step_{self.name.replace('-', '_')}" if self.emitted else ""

    @property
    def splits(self) -> bool:
        """Whether it takes steps in which limits close in parts."""
        return isinstance(self.scheme, Composition) and self.scheme.splits

    @property
    def keeps_momentum(self) -> bool:
        """Whether it keeps the momentum of what floats free."""
        return isinstance(self.scheme, Composition) and self.scheme.keeps_momentum

    @property
    def damps_bounces(self) -> bool:
        """Whether what meets a stiff limit loses its speed."""
        return isinstance(self.scheme, Composition) and self.scheme.damps_bounces


def _listed(row: Sequence[Fraction]) -> str:
    return " ".join(map(str, row)) or "none"
