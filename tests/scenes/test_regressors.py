"""The torques are linear in inertias and numbers of effects, as their regressor says; base
parameters are the fewest combinations of these that determine the torques."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from coscrew_codegen.algebra.recording.numbers import less, where
from coscrew_codegen.dynamics import derive
from coscrew_codegen.dynamics.derivation import Derivation
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.scene.effect import (
    CoordinateState,
    Effect,
    ParameterOf,
    Place,
    Torque,
    Values,
)
from coscrew_codegen.scene.joints import KINDS
from coscrew_codegen.scene.mechanism.model import Inertia
from coscrew_codegen.scene.scene import Applied, Scene, Setting
from tests.support.scenes import effect_scenes as effects
from tests.support.scenes import mechanisms as m
from tests.support.scenes.differences import chain_with, matrix, scene_with, state, values
from tests.support.scenes.kinds import Kind

INVERSE, REGRESSOR, BASE = "inverse_dynamics", "torque_regressor", "base_regressor"
NAMES = (INVERSE, REGRESSOR, BASE, "linear_parameters", "base_parameters")
LINEAR = [x for x in effects.PLACES if x not in ("mimic", "reaction", "field")]
SCENES: dict[str, Callable[[], Scene]] = {
    "effects": lambda: scene_with(LINEAR),
    "followers": lambda: scene_with(["gravity", "mimic", "armature", "viscous"]),
    "without effects": lambda: scene_with([]),
    **{x.name: lambda x=x: chain_with(x) for x in KINDS if x.moves}}
each_scene = pytest.mark.parametrize("name", SCENES)


def heavier(scene: Scene, chosen: tuple[str, ...]) -> Scene:
    """The scene with other inertias, and with other numbers of these names."""
    bodies = tuple(replace(x, inertia=Inertia(
        x.inertia.mass * 3, tuple(c + 1 for c in x.inertia.com),
        tuple(i * 5 for i in x.inertia.moments))) if x.inertia else x for x in scene.model.bodies)
    return replace(scene, model=replace(scene.model, bodies=bodies),
                   effects=tuple(_changed(x, chosen) for x in scene.effects))


def _changed(applied: Applied, chosen: tuple[str, ...]) -> Applied:
    """The effect with 7 times its numbers of these names."""
    def times(name: str, x: object) -> object:
        if isinstance(x, tuple):
            return tuple(times(f"{name}.{'xyz'[k] if k < 3 else k}", y) for k, y in enumerate(x))
        return x * 7 if f"{applied.name}.{name}" in chosen else x

    given: Mapping[str, Setting] = {k: times(k, x) for k, x in applied.values.items()}
    return replace(applied, values=given)


def parts(functions: SceneFunctions, name: str, given: dict[str, list[mpf]]
          ) -> tuple[mpmath.matrix, list[mpf]]:
    """(Y, tau0)."""
    results, nv = values(functions, name, given), functions.nv
    return matrix(results[:-nv], (len(results) - nv) // nv), results[-nv:]


@each_scene
def test_torques_are_linear_in_parameters(name: str) -> None:
    """Y and tau0 of one scene, with the parameters of another, give the torques of the other."""
    scene = SCENES[name]()
    other = heavier(scene, Derivation(scene).linear.names)
    one, two = derive(scene, NAMES), derive(other, NAMES)
    with mpmath.workdps(50):
        given = state(scene, one)
        Y, rest = parts(one, REGRESSOR, given)
        Yb, of_base = parts(one, BASE, given)
        assert of_base == rest
        for functions in (one, two):
            wanted = mpmath.matrix(values(functions, INVERSE, given))
            pi, beta = (mpmath.matrix(values(functions, x, given))
                        for x in ("linear_parameters", "base_parameters"))
            size = max(map(abs, wanted))
            assert mpmath.mnorm(Y * pi + mpmath.matrix(rest) - wanted, "inf") <= size * mpf(10)**-40
            if functions is one:
                assert mpmath.mnorm(Yb * beta + mpmath.matrix(rest) - wanted,
                                    "inf") <= size * mpf(10)**-25


@each_scene
def test_base_has_the_rank_of_the_regressor(name: str) -> None:
    """By singular values, at states that the elimination has not seen."""
    scene = SCENES[name]()
    its = Derivation(scene)
    functions, base = derive(scene, NAMES), its.linear.base
    rows = []
    for seed in range(30):
        with mpmath.workdps(20):
            Y, _ = parts(functions, REGRESSOR, state(scene, functions, seed))
            rows += np.array(Y.tolist(), float).tolist()
    A = np.array(rows)
    A = A[:, A.any(0)] / np.abs(A[:, A.any(0)]).max(0)
    singular = np.linalg.svd(A, compute_uv=False)
    rank = len(base.places)
    assert singular[rank - 1] > 1e-7 * singular[0]
    assert rank == len(singular) or singular[rank] < 1e-12 * singular[0]


def test_numbers_of_effects_that_torques_are_linear_in() -> None:
    """No number of a limited torque is, no distance, and no speed at which friction fades."""
    assert Derivation(scene_with(LINEAR)).linear.names[40:] == (
        "actuator.j2.voltage", "actuator.j2.ke",
        *(f"added_mass.b3.{what}.{axis}" for what in ("mass", "inertia") for axis in "xyz"),
        *(f"added_mass.b0.inertia.{axis}" for axis in "xyz"),
        "armature.j1.inertia", "armature.j2.rotor",
        "buoyancy.b2.rho", "coulomb.j1.tau_c", "drag.b3.rho", "drag.b0.b", "joint_drag.j1.c",
        "joint_drag.j2.c", "limit.j1.k", "limit.j2.k", "speed_limit.j2.d", "spring.j1.k",
        "spring_damper.a.k", "spring_damper.a.d", "spring_damper.b.k", "spring_damper.c.d",
        "stribeck.j2.tau_c", "stribeck.j2.tau_s", "viscous.j1.d", "viscous.j2.d",
        "wrench.b3.force.y", "wrench.b3.torque.y", "wrench.b2.force.y", "wrench.b2.point.y")


def test_base_of_a_double_pendulum() -> None:
    """In the plane: moments of inertia about both axes, and first moments in the plane."""
    own = m.inertia(1, (1, 0, 1), (3, 4, 5, 0, 0, 0))
    scene = m.scene(m.chain((Kind.REVOLUTE, m.Y, m.HERE, own),
                            (Kind.REVOLUTE, m.Y, m.at(2, 0, 0), own)), m.gravity(0, 0, -9))
    assert Derivation(scene).linear.base_names == (
        "b0.mx + 2 b1.m", "b0.mz", "b0.Iyy + 4 b1.m", "b1.mx", "b1.mz", "b1.Iyy")


def test_base_of_a_slider_is_its_mass() -> None:
    base = Derivation(m.scene(m.slider(), m.gravity(-9, 0, 0))).linear.base
    assert base.combinations == (((0, Fraction(1)),),)


def test_a_number_on_which_a_choice_depends_is_no_column() -> None:
    """Though its slope is constant wherever there is one."""
    def law(x: CoordinateState, y: Values) -> Torque:
        return Torque(y["k"] * x.v + y["at"] * x.v + where(less(x.q, y["at"]), 0, 1))

    odd = Effect("odd", "jumps", "tau", Place.JOINT, (
        ParameterOf("k", "N m s/rad", "damping"), ParameterOf("at", "rad", "place")),
        joint_torque=law)
    scene = m.scene(m.pendulum(), Applied(odd, "j0", {"k": Fraction(1), "at": Fraction(2)}))
    assert Derivation(scene).linear.names[10:] == ("odd.j0.k",)
