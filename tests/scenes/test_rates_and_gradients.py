"""Jacobians, their rates, momenta, the Coriolis matrix and gradients of energies agree with
differences in 50 digits, with every kind of joint, followers and effects."""

from collections.abc import Callable, Iterator, Sequence

import mpmath
import pytest
from mpmath import mpf

from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.scene.joints import KINDS
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes import effect_scenes as effects
from tests.support.scenes.differences import (
    STEP,
    chain_with,
    matrix,
    scene_with,
    state,
    values,
)

BODY = "b3"
FRAMES = ("", "aligned_", "world_", "point_", "aligned_point_")
NAMES = ("coriolis_matrix", "energy_gradients", "energy", "mass_matrix", "inverse_dynamics",
         "centroidal_momentum_matrix", "centroidal_momentum_rate", "center_of_mass", "momentum",
         "center_of_mass_velocity", "center_of_mass_jacobian", "integrated")
CLOSE = mpf(10)**-25
Given = dict[str, list[mpf]]


SCENES: dict[str, Callable[[], Scene]] = {
    "effects": lambda: scene_with([x for x in effects.PLACES if x not in ("mimic", "reaction")]),
    "followers": lambda: scene_with(["gravity", "mimic", "armature"]),
    "added mass": lambda: scene_with(["gravity", "mimic", "added_mass"]),
    **{x.name: lambda x=x: chain_with(x, BODY) for x in KINDS if x.moves}}


@pytest.fixture(scope="module", params=SCENES)
def case(request: pytest.FixtureRequest) -> Iterator[tuple[Scene, SceneFunctions, Given]]:
    """A scene, its functions and a state."""
    scene = SCENES[request.param]()
    rates = tuple(f"{axes}{kind}_{BODY}" for kind in ("jacobian", "twist_rate") for axes in FRAMES)
    functions = derive(scene, (*NAMES, *rates))
    with mpmath.workdps(50):
        given = {**state(scene, functions), "r": [mpf("0.5"), mpf(-1), mpf(2)]}
        yield scene, functions, given


def moved(functions: SceneFunctions, given: Given, direction: Sequence[mpf]) -> Given:
    """The state at q ⊕ direction."""
    return {**given, "q": values(functions, "integrated", {**given, "phi": list(direction)})}


def slope(functions: SceneFunctions, given: Given, direction: Sequence[mpf],
          of: Callable[[Given], Sequence[mpf]]) -> list[mpf]:
    """The derivative of a function of the state along velocities, by central differences."""
    ends = [of(moved(functions, given, [sign * STEP * x for x in direction])) for sign in (1, -1)]
    return [(x - y) / (2 * STEP) for x, y in zip(*ends, strict=True)]


def units(count: int) -> list[list[mpf]]:
    """Unit vectors."""
    return [[mpf(int(i == j)) for i in range(count)] for j in range(count)]


def check(result: Sequence[mpf], wanted: Sequence[mpf], what: str) -> None:
    """They agree, relative to the largest."""
    result, wanted = list(result), list(wanted)
    largest = max(map(abs, wanted), default=mpf(0)) or mpf(1)
    for x, y in zip(result, wanted, strict=True):
        assert abs(x - y) <= CLOSE * max(largest, 1), what


def test_twist_rates_are_rates_of_jacobians_times_v(case: tuple[Scene, SceneFunctions, Given]
                                                     ) -> None:
    _, functions, given = case
    for axes in FRAMES:
        def twist(x: Given, name: str = f"{axes}jacobian_{BODY}") -> list[mpf]:
            J = matrix(values(functions, name, x), functions.nv)
            return list(J * mpmath.matrix(given["v"]))

        J = matrix(values(functions, f"{axes}jacobian_{BODY}", given), functions.nv)
        own = list(J * mpmath.matrix(given["a"]))
        turned = slope(functions, given, given["v"], twist)
        check(values(functions, f"{axes}twist_rate_{BODY}", given),
              [x + y for x, y in zip(own, turned, strict=True)], axes)


def test_motion_of_the_centre_of_mass(case: tuple[Scene, SceneFunctions, Given]) -> None:
    _, functions, given = case

    def centre(x: Given) -> list[mpf]:
        return values(functions, "center_of_mass", x)

    J = matrix(values(functions, "center_of_mass_jacobian", given), functions.nv)
    for j, unit in enumerate(units(functions.nv)):
        check(J[:, j], slope(functions, given, unit, centre), f"column {j}")
    check(values(functions, "center_of_mass_velocity", given), J * mpmath.matrix(given["v"]), "v")


def test_centroidal_momentum(case: tuple[Scene, SceneFunctions, Given]) -> None:
    """It is `momentum`, moved from the world's origin to the centre of mass."""
    _, functions, given = case

    def centroidal(x: Given) -> list[mpf]:
        A = matrix(values(functions, "centroidal_momentum_matrix", x), functions.nv)
        return list(A * mpmath.matrix(given["v"]))

    *p, lx, ly, lz = values(functions, "momentum", given)
    c = values(functions, "center_of_mass", given)
    wanted = [lx - c[1] * p[2] + c[2] * p[1], ly - c[2] * p[0] + c[0] * p[2],
              lz - c[0] * p[1] + c[1] * p[0]]
    check(centroidal(given), [*p, *wanted], "A v")
    A = matrix(values(functions, "centroidal_momentum_matrix", given), functions.nv)
    turned = slope(functions, given, given["v"], centroidal)
    check(values(functions, "centroidal_momentum_rate", given),
          [x + y for x, y in zip(A * mpmath.matrix(given["a"]), turned, strict=True)], "rate")


def test_coriolis_matrix(case: tuple[Scene, SceneFunctions, Given]) -> None:
    """C v are the torques of velocities, where effects take none; M' - 2 C is skew-symmetric."""
    scene, functions, given = case
    nv, v = functions.nv, mpmath.matrix(given["v"])
    C = matrix(values(functions, "coriolis_matrix", given), nv)
    rate = matrix(slope(functions, given, given["v"],
                        lambda x: values(functions, "mass_matrix", x)), nv)
    S = rate - 2 * C
    check(S + S.T, mpmath.zeros(nv), "M' - 2 C")
    if all(x.effect.name in ("gravity", "mimic", "armature", "added_mass") for x in scene.effects):
        still = [mpf(0)] * nv
        bias, holding = (values(functions, "inverse_dynamics", {**given, "v": x, "a": still})
                         for x in (given["v"], still))
        check(C * v, [x - y for x, y in zip(bias, holding, strict=True)], "C v")


def test_gradients_of_energies(case: tuple[Scene, SceneFunctions, Given]) -> None:
    _, functions, given = case
    nv = functions.nv
    result = values(functions, "energy_gradients", given)
    slopes = [slope(functions, given, unit, lambda x: values(functions, "energy", x))
              for unit in units(nv)]
    check(result[:nv], [x[0] for x in slopes], "dT_dq")
    check(result[2 * nv:], [x[1] for x in slopes], "dV_dq")
    M = matrix(values(functions, "mass_matrix", given), nv)
    check(result[nv:2 * nv], M * mpmath.matrix(given["v"]), "dT_dv")
