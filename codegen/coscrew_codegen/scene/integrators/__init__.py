"""The integrators, one per module: the list that commands, scenes, documentation and tests use.

A module put here adds an integrator to every scene, in all languages and precisions.
"""

from coscrew_codegen.program.plugins import discover
from coscrew_codegen.scene.integrator import Adaptive, Integrator

DEFAULT = "leapfrog"


def _place(integrator: Integrator) -> tuple[bool, bool, int, str]:
    """Sort key: the default first, then emitted ones, then SciPy's; each group by order."""
    return integrator.name != DEFAULT, not integrator.emitted, integrator.order, integrator.name


INTEGRATORS = tuple(sorted(discover(__name__, __path__, "INTEGRATOR", Integrator), key=_place))

INTEGRATOR_NAMED = {x.name: x for x in INTEGRATORS}
NAMES = tuple(INTEGRATOR_NAMED)
EMITTED = tuple(x for x in INTEGRATORS if x.emitted)
ADAPTIVE = {x.name: x.scheme for x in INTEGRATORS if isinstance(x.scheme, Adaptive)}


def named(name: str) -> Integrator:
    """The integrator of this name."""
    return INTEGRATOR_NAMED[name]


def in_words() -> str:
    """Describes all integrators and their uses in one paragraph."""
    return "; ".join(f"{x.name}, of order {x.order}: {x.good_for}" for x in INTEGRATORS)
