"""Derivatives of inverse and forward dynamics with every effect and kind of joint: the recursion
agrees with differentiation of the torques' Program, and both with differences in 50 digits."""

from collections.abc import Sequence
from fractions import Fraction

import mpmath
import pytest
from mpmath import mpf

from coscrew_codegen.dynamics import derive, dynamics_derivatives
from coscrew_codegen.scene.joints import KINDS
from coscrew_codegen.scene.mechanism.joint_kind import JointKind
from tests.support.scenes import mechanisms as m
from tests.support.scenes.differences import (
    ACTING,
    FORWARD,
    INVERSE,
    chain_with,
    check,
    scene_with,
    state,
    values,
)


@pytest.mark.parametrize("names", [("gravity",), ACTING], ids=["gravity", "all"])
def test_they_are_differences_in_50_digits(names: Sequence[str]) -> None:
    check(scene_with(names))


@pytest.mark.parametrize("kind", [x for x in KINDS if x.moves], ids=lambda x: x.name)
def test_every_kind_of_joint(kind: JointKind) -> None:
    check(chain_with(kind))


def test_recursion_and_differentiation_agree(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = scene_with(ACTING)
    recursion = derive(scene, (INVERSE,))
    monkeypatch.setattr(dynamics_derivatives.rnea_derivatives, "constant_screws",
                        lambda motion: False)
    with mpmath.workdps(50):
        given = state(scene, recursion)
        one, other = (values(x, INVERSE, given) for x in (recursion, derive(scene, (INVERSE,))))
        assert max(abs(x - y) for x, y in zip(one, other, strict=True)) <= mpf(10)**-40 * max(
            map(abs, other))


def test_of_a_pendulum() -> None:
    """tau = m l² a + m g l sin q, with g = 10 m/s²."""
    scene = m.scene(m.pendulum(2, Fraction(1, 2)), m.gravity(0, 0, -10))
    functions = derive(scene, (INVERSE, FORWARD))
    given = {"q": [mpf(1)], "v": [mpf(2)], "a": [mpf(3)], "tau": [mpf(4)]}
    stiff, mass = 10 * mpmath.cos(1), mpf("0.5")
    for name, wanted in ((INVERSE, (stiff, 0, mass)), (FORWARD, (-stiff / mass, 0, 1 / mass))):
        for x, y in zip(values(functions, name, given), wanted, strict=True):
            assert abs(x - y) <= mpf(10)**-13
