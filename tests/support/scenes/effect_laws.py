"""Comparisons for tests of effects: to 45 digits, and convergence of motions to their law."""

from collections.abc import Callable, Sequence
from typing import Unpack

from mpmath import mpf

from coscrew_codegen.scene.mechanism.model import Model
from coscrew_codegen.scene.scene import Applied
from tests.support.scenes.evaluation import MULTIPRECISE, Evaluated, Given, Moving
from tests.support.scenes.mechanisms import Settings, scene

TINY = mpf(10)**-45


def multiprecise(model: Model, *effects: Applied, **settings: Unpack[Settings]) -> Evaluated[mpf]:
    return Evaluated(scene(model, *effects, **settings), MULTIPRECISE)


def assert_same(results: Sequence[mpf], wanted: Sequence[mpf]) -> None:
    """Assert that numbers agree to 45 digits of the largest of them."""
    size = max(1, *(abs(x) for x in wanted))
    assert len(results) == len(wanted)
    for x, y in zip(results, wanted, strict=True):
        assert abs(x - y) <= TINY * size, (x, y)


def assert_reaches(truth: float, run: Callable[[int], float], steps: int, order: int = 4) -> None:
    """Assert that run(n) converges to the truth as n^-order, with an error below a millionth for
    2n."""
    coarse, fine = run(steps), run(2 * steps)
    error = (fine - coarse) / (2**order - 1)
    assert abs(fine + error - float(truth)) <= abs(error) / 4, (coarse, fine, float(truth))
    assert abs(error) <= 1e-6 * max(1, abs(truth))


def moving(model: Model, *effects: Applied, q: Sequence[Given] = (0,),
           v: Sequence[Given] = (0,)) -> Moving:
    return Moving(scene(model, *effects), q, v)
