"""All scenes: each family over all rates."""

from tests.support.motions import floating, servos, springs
from tests.support.motions.drawing import RATES, Draw, Family, Wanted
from tests.support.motions.mechanism import Motion

FAMILIES: dict[str, Family] = {x.__name__: x for module in (servos, springs, floating)
                               for x in module.FAMILIES}


def drawn(family: str, number: int, seed: int = 0) -> Motion:
    """One scene of a family."""
    return FAMILIES[family](Wanted(family, number, Draw(seed, family), Draw(seed, family, number),
                                   RATES[number % len(RATES)]))
