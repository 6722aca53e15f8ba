"""Scenes in double and in single precision differ from themselves at 50 digits by no more than a
running error bound."""

from collections.abc import Iterator
from functools import cache

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from coscrew_codegen.dynamics import derive
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes.effect_scenes import PLACES, arm, effects, mechanism
from tests.support.scenes.evaluation import DOUBLE, MULTIPRECISE, SINGLE, Evaluated, Numbers
from tests.support.scenes.mechanisms import applied, chain_of_three, gravity, scene
from tests.support.scenes.running_error import bounded
from tests.support.scenes.scene_values import random_state

PRECISIONS = {"double": (DOUBLE, np.float64, 2.0**-53), "single": (SINGLE, np.float32, 2.0**-24)}
SMOOTH = tuple(x for x in PLACES if x not in ("limit", "speed_limit"))
"""Effects without an end at which a rounding might touch them."""
SCENES: dict[str, Scene] = {
    "bare": scene(mechanism()), "falling": scene(mechanism(), gravity()),
    "all effects": scene(mechanism(), *effects(*SMOOTH)), "arm": scene(arm(), *effects(*SMOOTH)),
    "followers": scene(chain_of_three(), gravity(), applied("mimic"))}
FUNCTIONS = ("inverse_dynamics", "forward_dynamics", "mass_matrix", "bias_torques", "energy",
             "momentum", "body_poses", "body_twists", "implicit_acceleration")
"""All but `integrated`, whose exponential recovers what it rounds off: such an analysis does not
see that; the library's own tests bound its error."""


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(50):
        yield


def state_of(f: Evaluated, seed: int, number: type) -> dict[str, object]:
    """Random inputs of all functions, numbers of this precision."""
    state = random_state(f, seed)
    state |= {"a": state["tau"][::-1], "phi": state["v"][::-1], "h": mpf(1) / 8}
    return {key: [number(float(y)) for y in x] if isinstance(x, list) else number(float(x))
            for key, x in state.items()}


derived = cache(lambda name: derive(SCENES[name], FUNCTIONS))


def evaluated(name: str, numbers: Numbers = MULTIPRECISE) -> Evaluated:
    return Evaluated(SCENES[name], numbers, derived(name))


@pytest.mark.parametrize("precision", PRECISIONS)
@pytest.mark.parametrize("name", SCENES)
def test_results_are_within_their_running_error_bounds(name: str, precision: str) -> None:
    """The bound is below 2^17 units of the largest result, so that it says something."""
    numbers, number, u = PRECISIONS[precision]
    f, bound = (evaluated(name, x) for x in (numbers, bounded(precision, mpf(u))))
    for seed in range(3):
        state = state_of(f, seed, number)
        for function in FUNCTIONS:
            result = f(function, **state)
            truth = bound(function, **state)
            size = max(abs(x.exact) for x in truth)
            for x, y in zip(result, truth, strict=True):
                assert isinstance(x, number)
                assert abs(mpf(float(x)) - y.exact) <= y.error, (function, float(x).hex())
                assert y.error <= 2**17 * u * size


@pytest.mark.parametrize("name", SCENES)
def test_forward_dynamics_inverts_inverse_dynamics(name: str) -> None:
    f = evaluated(name)
    for seed in range(3):
        state = state_of(f, seed, np.float64)
        state["tau"] = f("inverse_dynamics", **state)
        for x, y in zip(f("forward_dynamics", **state), state["a"], strict=True):
            assert abs(x - mpf(y)) <= mpf(10)**-40
