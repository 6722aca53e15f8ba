"""Numbers of scenes that stay arguments of the kernels."""

from dataclasses import dataclass
from fractions import Fraction


@dataclass(frozen=True)
class Parameter:
    """A number that stays an argument of the kernels: element `index` of their argument p."""

    name: str  # as in a scene's `runtime`: tool.mass
    index: int
    value: Fraction  # where nothing else is given


Scalar = Fraction | Parameter
