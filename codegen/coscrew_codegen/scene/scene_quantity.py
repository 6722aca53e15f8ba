"""Quantities that are recorded from results of functions."""

from dataclasses import dataclass
from enum import Enum


class Of(Enum):
    """Owner of a recorded quantity."""

    SCENE = ""
    BODY = "body"
    JOINT = "joint"
    LOOP = "loop"


@dataclass(frozen=True)
class SceneQuantity:
    """Quantity recorded from a function's results: `name`, or `name.BODY`, `name.JOINT`.

    Each component is the sum of the results at its `places`; without places, every result is a
    component.  For a function of all bodies, places count from the body's own results."""

    name: str
    of: Of = Of.SCENE
    components: tuple[str, ...] = ()  # names in place of numbers
    places: tuple[tuple[int, ...], ...] = ()
    expected: str = ""  # the component that an expectation without one refers to

    @property
    def written(self) -> str:
        """pose.BODY."""
        return f"{self.name}.{self.of.value.upper()}" if self.of.value else self.name
