"""Requests of an accuracy that suffices: `inverse_dynamics=1e-3`, in the function's unit."""

import math
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass

from coscrew_codegen.reports.cost import CostError
from coscrew_codegen.scene.names import did_you_mean
from coscrew_codegen.scene.patterns import is_pattern
from coscrew_codegen.simulation.result_units import written

EXAMPLE = 'wanted FUNCTION=NUMBER, as inverse_dynamics=1e-3 or "inverse_dynamics=1e-3 N m"'


@dataclass(frozen=True)
class Need:
    """The largest error of a function's results that is acceptable: of all components, or of those
    with this unit."""

    function: str
    within: float
    unit: str = ""

    def concerns(self, unit: str) -> bool:
        """Returns whether components with this unit are meant."""
        return self.unit in ("", written(unit), unit)

    def named(self, units: Iterable[str]) -> str:
        """The number and its unit, or the units of these components."""
        of = self.unit or " or ".join(dict.fromkeys(map(written, units)))
        return f"{self.within:g}" if of == "1" else f"{self.within:g} {of}"

    def __str__(self) -> str:
        return f"{self.function}={' '.join(filter(None, (f'{self.within:g}', self.unit)))}"


def read(text: str) -> Need:
    """The request in words.  Raises ValueError."""
    name, _, value = text.partition("=")
    number, _, unit = value.strip().partition(" ")
    try:
        within = float(number)
    except ValueError:
        within = math.nan
    if not name.strip() or not 0 < within < math.inf:
        raise ValueError(f"{EXAMPLE}; got {text!r}")
    return Need(name.strip(), within, unit.strip())


def refuse_unknown(needs: Sequence[Need], functions: Collection[str]) -> None:
    """Raises CostError for a name that is none of these functions."""
    for need in needs:
        if is_pattern(need.function) or need.function not in functions:
            raise CostError(f"--need {need}: {need.function!r} is no function of this scene; "
                            f"{did_you_mean(need.function, functions)}")


def refuse_other_units(needs: Sequence[Need], function: str, units: Collection[str]) -> None:
    """Raises CostError for a unit that no component of the function has."""
    for need in needs:
        if need.function == function and not any(map(need.concerns, units)):
            raise CostError(f"--need {need}: {function} has no result in {need.unit!r}; "
                            f"{did_you_mean(need.unit, {*map(written, units)})}")
