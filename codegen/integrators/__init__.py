"""The integrators, a file each: the only list, which commands, scenes, documents and tests ask.

A file put here is an integrator of every scene, in all languages and precisions.
"""

from coscrew_codegen.found import found
from coscrew_codegen.integrator import Adaptive, Integrator

DEFAULT = "leapfrog"


def _place(integrator: Integrator) -> tuple[bool, bool, int, str]:
    """The default first, then those that are emitted, then SciPy's; by order."""
    return integrator.name != DEFAULT, not integrator.emitted, integrator.order, integrator.name


INTEGRATORS = tuple(sorted(found(__name__, __path__, "INTEGRATOR", Integrator), key=_place))

NAMES = tuple(x.name for x in INTEGRATORS)
EMITTED = tuple(x for x in INTEGRATORS if x.emitted)
ADAPTIVE = {x.name: x.scheme for x in INTEGRATORS if isinstance(x.scheme, Adaptive)}


def named(name: str) -> Integrator:
    """The integrator of this name."""
    return next(x for x in INTEGRATORS if x.name == name)


def in_words() -> str:
    """All, with what they are good for, in one paragraph."""
    return "; ".join(f"{x.name}, of order {x.order}: {x.good_for}" for x in INTEGRATORS)
