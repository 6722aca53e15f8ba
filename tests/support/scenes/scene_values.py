"""Draws arguments of a scene's functions, and compares their results."""

from random import Random

import mpmath
import numpy as np
from mpmath import mpf

from coscrew_codegen.program.scene_functions import Signature
from tests.support.scenes.evaluation import Evaluated

UNIT = {"double": 2.0**-53, "single": 2.0**-24}
SPECIAL = (0.0, -0.0, 1.0, -1.0, 1e-300, 1e30, 5e-324, np.inf, np.nan, 1.5)


def inputs(function: Signature, kind: str, *lead: int, special: bool = False
           ) -> list[np.ndarray]:
    """Arguments of the function, drawn for these leading axes."""
    draw = np.random.default_rng(len(function.name))
    with np.errstate(over="ignore", under="ignore"):
        return [(draw.choice(SPECIAL, (*lead, *shape)) if special else
                 draw.normal(size=(*lead, *shape))).astype(kind) for _, shape in function.inputs]


def same_bits(a: object, b: object) -> bool:
    """Returns whether arrays, or tuples of them, have the same shapes, types and bits; NaN are
    equal."""
    if isinstance(a, tuple) or isinstance(b, tuple):
        return isinstance(a, tuple) and isinstance(b, tuple) and all(map(same_bits, a, b))
    a, b = np.asarray(a), np.asarray(b)
    return (a.dtype == b.dtype and a.shape == b.shape and bool(np.all(
        (np.isnan(a) & np.isnan(b)) | ((a == b) & (np.signbit(a) == np.signbit(b))))))


def random_state(f: Evaluated[mpf], seed: int) -> dict[str, mpf | list[mpf]]:
    """q with quaternions of norm 1, v, tau, t."""
    random = Random(seed)

    def draw(n: int) -> list[mpf]:
        return [mpf(random.randint(-2000, 2000)) / 1000 for _ in range(n)]

    q = draw(f.nq)
    for c in f.coordinates:
        if c.kind in ("free", "spherical"):
            part = slice(c.q.stop - 4, c.q.stop)
            q[part] = [x / mpmath.norm(q[part]) for x in q[part]]
    return {"t": mpf("0.4"), "q": q, "v": draw(f.nv), "tau": draw(f.nv)}
