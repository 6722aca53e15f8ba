"""Run-time parameters: numbers of a scene that stay arguments of its functions."""

from dataclasses import dataclass
from fractions import Fraction


@dataclass(frozen=True)
class Parameter:
    """A number of a scene that can be changed at run time: element `index` of the argument p."""

    name: str  # as in a scene's `runtime`: tool.mass
    index: int
    value: Fraction  # the default


Scalar = Fraction | Parameter
