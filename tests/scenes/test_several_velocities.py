"""Effects along each velocity of joints with several: damping, friction, springs and own inertias.

Formulas and differences have 50 digits; a planar joint is compared with slides and a hinge."""

from collections.abc import Iterator, Sequence
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from coscrew_codegen import load_scene
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.scene.effect_quantities import units_of
from coscrew_codegen.scene.mechanism.model import Body, Joint, Model
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Applied
from tests.support.each import each_precision
from tests.support.scenes.differences import INVERSE, check, values
from tests.support.scenes.effect_laws import assert_same, multiprecise
from tests.support.scenes.effect_scenes import mechanism
from tests.support.scenes.evaluation import DOUBLE, MULTIPRECISE, Evaluated, evaluator
from tests.support.scenes.generated_scenes import imported
from tests.support.scenes.kinds import Kind
from tests.support.scenes.mechanisms import (
    CATALOGUE,
    HERE,
    X,
    Y,
    Z,
    applied,
    at,
    ball,
    chain,
    free_body,
    gravity,
    inertia,
    numbers,
    scene,
)
from tests.support.scenes.scene_values import random_state
from tests.support.truth.exact import array, rotation_of

STEP, HALF = mpf(10)**-16, Fraction(1, 2)
REST = numbers("-0.5", "0.1", "0.7", "0.5")
"""A quaternion of norm 1."""


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(50):
        yield


def rotation_vector(R: np.ndarray) -> np.ndarray:
    """The rotation vector of a matrix, by its trace and its skew part."""
    angle = mpmath.acos((R[0, 0] + R[1, 1] + R[2, 2] - 1) / 2)
    part = array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    return part * (angle / (2 * mpmath.sin(angle)))


def quaternion(*numbers: int) -> list[mpf]:
    return [mpf(x) / mpmath.norm(list(map(mpf, numbers))) for x in numbers]


STILL = [mpf(x) for x in (2, -3, 5)]
SPIN = [mpf(x) / 3 for x in (4, -1, 7)]
LAWS = {
    "viscous": ({"d": 3}, lambda v: -3 * v),
    "coulomb": ({"tau_c": 2, "eps": HALF}, lambda v: -2 * mpmath.tanh(2 * v)),
    "stribeck": ({"tau_c": 1, "tau_s": 2, "v_s": HALF, "eps": HALF},
                 lambda v: -(1 + mpmath.exp(-4 * v * v)) * mpmath.tanh(2 * v)),
    "joint_drag": ({"c": 2}, lambda v: -2 * abs(v) * v)}


def test_every_effect_along_velocities_has_its_law_here() -> None:
    along = {name for name, x in CATALOGUE.items() if x.each}
    assert along == {*LAWS, "spring", "armature"}
    assert {name for name in along if CATALOGUE[name].rest} == {"spring"}


@pytest.mark.parametrize("name", LAWS)
@pytest.mark.parametrize("model, v", [(ball(), SPIN), (free_body(), [*STILL, *SPIN])],
                         ids=["ball", "free"])
def test_friction_acts_on_each_velocity(name: str, model: Model, v: Sequence[mpf]) -> None:
    given, law = LAWS[name]
    f = multiprecise(model, applied(name, "j0", **given))
    q = [*([mpf(9)] * (len(v) - 3)), *quaternion(1, 2, 3, 4)]
    wanted = [law(x) for x in v]
    power = sum(u * x for u, x in zip(wanted, v, strict=True))
    assert_same(f.components(f"effect_{name}_j0", q=q, v=v), [*wanted, power])
    assert_same([f("power", q=q, v=v)], [power])
    without = multiprecise(model)
    assert_same([a - b for a, b in zip(without("bias_torques", q=q, v=v),
                                       f("bias_torques", q=q, v=v), strict=True)], wanted)


@pytest.mark.parametrize("q", [(1, 2, 3, 4), (-5, 1, 7, 5), (5, -1, -7, -5), (0, 0, 3, -4)])
def test_a_spring_turns_a_ball_back_along_the_shortest_way(q: tuple[int, ...]) -> None:
    """-k log(R0^T R), of energy k θ²/2; q and -q are one rotation."""
    own = quaternion(*q)
    f = multiprecise(ball(), applied("spring", "j0", k=7, q0=REST))
    turn = rotation_of(array([mpf(x.numerator) / x.denominator for x in REST])).T @ rotation_of(
        array(own))
    if own == quaternion(-5, 1, 7, 5) or own == quaternion(5, -1, -7, -5):
        away = array([mpf(0)] * 3)
    else:
        away = rotation_vector(turn)
    power = -7 * (away @ array(SPIN))
    assert_same(f.components("effect_spring_j0", q=own, v=SPIN),
                [*(-7 * away), power, mpf(7) / 2 * (away @ away)])


def test_a_spring_pulls_a_free_body_back() -> None:
    """-k (R^T (x - x0); log(R0^T R)), by default to the neutral coordinates."""
    own, place = quaternion(1, 2, 3, 4), [mpf(3), mpf(-1), mpf(2)]
    R = rotation_of(array(own))
    for values_given, apart, turn in (
            ({}, array(place), R),
            ({"q0": (*numbers(1, 2, -3), *REST)}, array(place) - array([1, 2, -3]), rotation_of(
                array([mpf(x.numerator) / x.denominator for x in REST])).T @ R)):
        f = multiprecise(free_body(), applied("spring", "j0", k=7, **values_given))
        away = np.concatenate([R.T @ apart, rotation_vector(turn)])
        torque = [-x for x in f("bias_torques", q=[*place, *own], v=[mpf(0)] * 6)]
        assert_same(torque, list(-7 * away))
        assert_same([f("energy", q=[*place, *own], v=[mpf(0)] * 6)[1]],
                    [mpf(7) / 2 * (away @ away)])


def test_an_armature_of_a_free_body_is_a_mass_that_does_not_fall() -> None:
    """m (v' + ω × v) and I ω' about the origin: as a ball there, of mass and moments 6, in a scene
    without gravity."""
    spare = inertia(2 + 6, moments=(7, 8, 9, 0, 0, 0))
    heavier = multiprecise(chain((Kind.FREE, Z, HERE, spare)))
    f = multiprecise(free_body(2, moments=(1, 2, 3, 0, 0, 0)), applied("armature", "j0", inertia=6))
    state = {"q": [mpf(1)] * 3 + quaternion(1, 2, 3, 4), "v": [*STILL, *SPIN]}
    a = [mpf(x) for x in (1, 2, 3, 4, 5, 6)]
    for name, given in (("inverse_dynamics", {"a": a}), ("forward_dynamics", {"tau": a}),
                        ("bias_torques", {}), ("mass_matrix", {}), ("energy", {})):
        one, other = (g(name, **state, **given) for g in (f, heavier))
        assert_same(list(one), list(other))


ACTING = (applied("viscous", "j0", d=5), applied("viscous", "j3", d=2),
          applied("spring", "j3", k=3), applied("spring", "j0", k=7, q0=(*numbers(1, 2, 3), *REST)),
          applied("armature", "j0", inertia=2), applied("armature", "j3", inertia=1),
          applied("coulomb", "j3", tau_c=2, eps=HALF), gravity())


def test_energy_changes_by_what_is_fed_in() -> None:
    f = Evaluated(scene(mechanism(), *ACTING), MULTIPRECISE)
    x = random_state(f, 1)
    a = f("forward_dynamics", **x)

    def energy(s: mpf) -> mpf:
        q = f("integrated", q=x["q"], phi=[s * v for v in x["v"]])
        return sum(f("energy", q=q, v=[v + s * y for v, y in zip(x["v"], a, strict=True)]))

    fed = f("power", **x) + sum(t * v for t, v in zip(x["tau"], x["v"], strict=True))
    assert abs((energy(STEP) - energy(-STEP)) / (2 * STEP) - fed) < mpf(10)**-21


def test_derivatives_are_differences() -> None:
    check(scene(mechanism(), *ACTING))


def test_gradients_of_energies_are_differences() -> None:
    made = scene(mechanism(), *ACTING)
    functions = derive(made, ("energy_gradients", "energy", "integrated"))
    x = random_state(Evaluated(made, MULTIPRECISE), 3)
    n = functions.nv

    def energies(k: int, s: mpf, by: str) -> list[mpf]:
        unit = [s * (i == k) for i in range(n)]
        q = values(functions, "integrated", {**x, "phi": unit}) if by == "q" else x["q"]
        v = [a + b for a, b in zip(x["v"], unit, strict=True)] if by == "v" else x["v"]
        return values(functions, "energy", {"q": q, "v": v})

    def slopes(by: str) -> list[list[mpf]]:
        return [[(a - b) / (2 * STEP) for a, b in zip(
            energies(k, STEP, by), energies(k, -STEP, by), strict=True)] for k in range(n)]

    along, by_v = slopes("q"), slopes("v")
    wanted = [*(y[0] for y in along), *(y[0] for y in by_v), *(y[1] for y in along)]
    result = values(functions, "energy_gradients", x)
    assert max(abs(a - b) for a, b in zip(result, wanted, strict=True)) < mpf(10)**-20


def at_rest(functions: SceneFunctions, name: str, q: list[float]) -> np.ndarray:
    """A function in double precision at q, without velocities, for a step of 0.1 s."""
    program = functions.named(name).program
    given = {"q": q, "h": [0.1]}
    with np.errstate(all="ignore"):
        return np.array(evaluator(program, DOUBLE)([
            [np.float64(x) for x in given.get(a.name, [0.0] * a.quantity.size)]
            for a in program.inputs]), float)


NEUTRAL = [0.0, 0.0, 0.0, 1.0]


@pytest.mark.parametrize("model, rest", [(ball(), NEUTRAL), (free_body(), [0.0] * 3 + NEUTRAL)],
                         ids=["ball", "free"])
def test_derivatives_at_rest_are_the_stiffness(model: Model, rest: list[float]) -> None:
    """The torque has the derivative k 1 where the angle has none."""
    functions = derive(scene(model, applied("spring", "j0", k=7)), (INVERSE,))
    n = functions.nv
    assert (at_rest(functions, INVERSE, rest)[:n * n].reshape(n, n) == 7 * np.eye(n)).all()


def test_a_step_from_rest_has_the_derivatives_of_the_midpoint_rule() -> None:
    """With s = h² k/4I: [[1 - s, h], [-h k/I, 1 - s]] / (1 + s), along each axis."""
    made = scene(ball(moments=(2, 2, 2, 0, 0, 0)), applied("spring", "j0", k=7))
    functions = derive(made, ("step_leapfrog_derivatives",))
    A = at_rest(functions, "step_leapfrog_derivatives", NEUTRAL)[7:].reshape(6, 6)
    s = 0.1**2 * 7 / 8
    wanted = np.kron(np.array([[1 - s, 0.1], [-0.1 * 7 / 2, 1 - s]]) / (1 + s), np.eye(3))
    assert np.abs(A - wanted).max() < 1e-15


def test_implicit_steps_take_damping_and_stiffness_along_velocities() -> None:
    """(M + h d + h² k) a = -bias - h k v, of a ball without a body's gyroscopic torque."""
    f = multiprecise(ball(moments=(2, 2, 2, 0, 0, 0)), applied("spring", "j0", k=700),
                     applied("viscous", "j0", d=9))
    h, q = mpf("0.3"), quaternion(1, 2, 3, 4)
    away = rotation_vector(rotation_of(array(q)))
    wanted = [(-700 * x - 9 * v - h * 700 * v) / (2 + h * 9 + h * h * 700)
              for x, v in zip(away, SPIN, strict=True)]
    assert_same(f("implicit_acceleration", h=h, q=q, v=SPIN), wanted)


def planar() -> Model:
    full = (3, 4, 5, HALF, Fraction(1, 3), Fraction(-1, 4))
    return chain((Kind.REVOLUTE, X, HERE, inertia(2, (1, 0, 1), full)),
                 (Kind.PLANAR, Z, at(1, 0, HALF), inertia(2, (0, HALF, 1), full)))


def slides() -> Model:
    """The planar joint as two slides and a hinge."""
    whole = planar()
    arm, joint = whole.joints
    kinds = (Kind.PRISMATIC, Kind.PRISMATIC, Kind.REVOLUTE)
    names = ("b0", "m0", "m1", "b1")
    return Model("slides", (*whole.bodies, Body("m0"), Body("m1")), (arm, *(
        Joint(f"s{n}", kind, names[n], names[n + 1], joint.placement if n == 0 else HERE, axis)
        for n, (kind, axis) in enumerate(zip(kinds, (X, Y, Z), strict=True)))))


def test_on_a_planar_joint_they_are_those_of_slides_and_a_hinge() -> None:
    """In all functions; the default integrator weighs damping by the inertia along each velocity,
    which in a chain is that beyond the other joints, and is compared without."""
    given: dict[str, dict[str, object]] = {
        "viscous": {"d": 3}, "armature": {"inertia": 2}, "joint_drag": {"c": 2},
        "coulomb": {"tau_c": 2, "eps": HALF}, "spring": {"k": 70, "q0": numbers(1, 2, "0.3")}}
    for names, more in ((given, ()), (("armature", "spring"), ("midpoint_acceleration",))):
        whole = [applied(name, "j1", **given[name]) for name in names]
        single = [applied(name, f"s{n}", **{x: y[n] if isinstance(y, tuple) else y
                                            for x, y in given[name].items()})
                  for name in names for n in range(3)]
        f, g = multiprecise(planar(), gravity(), *whole), multiprecise(slides(), gravity(), *single)
        x = {**random_state(f, 2), "h": mpf(1) / 8}
        for name in ("inverse_dynamics", "forward_dynamics", "mass_matrix", "bias_torques",
                     "energy", "implicit_acceleration", *more):
            one, other = (y(name, a=x["tau"], **x) for y in (f, g))
            assert_same(list(one), list(other))


def test_quantities_have_a_number_for_each_velocity() -> None:
    made = scene(planar(), applied("viscous", "j1", d=3))
    assert units_of(made.effects[0], made) == {"torque": ("N", "N", "N m"), "power": ("W",)}


def test_a_floating_base_that_is_held_keeps_no_momentum() -> None:
    for acting, free in (((), True), ((applied("viscous", "j0", d=1),), False),
                         ((applied("armature", "j0", inertia=1),), False),
                         ((applied("viscous", "j0", d=0),), True),
                         ((applied("viscous", "j1", d=1),), True)):
        names = [x.name for x in derive(scene(mechanism(), *acting)).functions]
        assert ("free_momentum" in names) is free


# scene files, precisions and tiers

TEXT = """
[bodies]
hull = { mass = 2, com = [0.1, 0.2, 0.3], inertia = [0.5, 0.6, 0.7] }
hand = { mass = 1, com = [0, 0.1, 0.2], inertia = [0.1, 0.2, 0.25] }
[joints]
base = { type = "free", child = "hull", damping = 0.5 }
wrist = { type = "spherical", parent = "hull", child = "hand", origin = { xyz = [0.5, 0, 0] } }
[effects.gravity]
[effects.viscous]
joints = "all"
d = "model"
[effects.armature.wrist]
inertia = 0.2
[effects.spring.wrist]
k = 30
q0 = [0, 0.6, 0, 0.8]
[effects.spring.base]
k = 20
"""
CALLED = ("inverse_dynamics", "forward_dynamics", "mass_matrix", "energy", "power", INVERSE)


@pytest.fixture(scope="module")
def kernels(tmp_path_factory: pytest.TempPathFactory) -> Kernels:
    path = tmp_path_factory.mktemp("held") / "held.toml"
    path.write_text(TEXT)
    return load_scene(path, functions=CALLED, tiers=["accurate", "certified"])


def arguments(kernels: Kernels, name: str, kind: type) -> list[np.ndarray]:
    rng, sizes = np.random.default_rng(4), {"q": 11}
    results = []
    for given in kernels.functions.named(name).inputs:
        x = rng.uniform(-1, 1, sizes.get(given.name, 9))
        if given.name == "q":
            for k in (3, 7):
                x[k:k + 4] /= np.linalg.norm(x[k:k + 4])
        results.append(x.astype(kind))
    return results


@each_precision
def test_c_and_numpy_compute_the_same_bits(kernels, tmp_path, precision):
    twin = getattr(imported(kernels.functions, tmp_path), precision.name)
    for name in CALLED:
        given = arguments(kernels, name, precision.numpy_type)
        one = getattr(getattr(kernels, precision.name), name)(*given)
        assert np.asarray(one).tobytes() == np.asarray(getattr(twin, name)(*given)).tobytes(), name


@pytest.mark.parametrize("tier", ("plain", "accurate", "certified"))
@each_precision
def test_tiers_keep_their_promises(kernels, precision, tier):
    """Against 50 digits of the plain Program at the same numbers."""
    f = Evaluated(kernels.scene, MULTIPRECISE)
    q, v, a = arguments(kernels, "inverse_dynamics", precision.numpy_type)
    wanted = f("inverse_dynamics", **{name: [mpf(float(x)) for x in y]
                                      for name, y in (("q", q), ("v", v), ("a", a))})
    of = kernels if tier == "plain" else getattr(kernels, tier)
    result = getattr(of, precision.name).inverse_dynamics(q, v, a)
    values, bounds = result if tier == "certified" else (result, [None] * len(wanted))
    u, largest = float(precision.u), max(map(abs, wanted))
    for x, y, bound in zip(values, wanted, bounds, strict=True):
        most = {"plain": 32, "accurate": 2}.get(tier, 0) * u * largest if bound is None else bound
        assert abs(mpf(float(x)) - y) <= most <= 1e3 * u * largest


def test_all_takes_the_models_numbers_of_every_joint(kernels):
    assert [x.name for x in kernels.scene.effects] == [
        "armature.wrist", "gravity", "spring.base", "spring.wrist", "viscous.base"]
    wrist = next(x for x in kernels.scene.effects if x.name == "spring.wrist")
    assert isinstance(wrist, Applied) and wrist.values["q0"] == numbers(0, "0.6", 0, "0.8")


@pytest.mark.parametrize("old, new, message", [
    ("q0 = [0, 0.6, 0, 0.8]", "q0 = 0.5", "effects.spring.wrist.q0: "),
    ("q0 = [0, 0.6, 0, 0.8]", "q0 = [0, 1, 0]", "effects.spring.wrist.q0: "),
    ("q0 = [0, 0.6, 0, 0.8]", "q0 = [0, 1, 0, 1]", "effects.spring.wrist.q0: "),
    ("[effects.gravity]", "[effects.actuator.wrist]\ntau = 1", "actuator cannot act on joint "
     "'wrist', which is spherical"),
    ("[effects.gravity]", "[effects.limit.wrist]\nk = 1\nlower = 0.1", "wanted upper alone"),
    ("[effects.gravity]", 'runtime = ["spring.wrist.q0"]\n[effects.gravity]',
     "'spring.wrist.q0' is the coordinates of a joint; wanted a number")])
def test_wrong_tables_are_refused(tmp_path, old, new, message):
    assert old in TEXT
    text = TEXT.replace(old, new)
    if "runtime" in new:
        text = new.partition("\n")[0] + "\n" + TEXT
    path = tmp_path / "held.toml"
    path.write_text(text)
    with pytest.raises(SceneError) as caught:
        read_scene(path)
    assert message in str(caught.value)


def test_a_pattern_means_joints_with_one_coordinate_if_it_matches_any(tmp_path):
    path = tmp_path / "held.toml"
    flap = 'flap = { type = "revolute", axis = [1, 0, 0], parent = "hand", child = "tip" }\n'
    hinge = TEXT.replace("[effects.gravity]",
                         flap + '[effects.coulomb]\njoints = ["*"]\ntau_c = 1\neps = 1')
    path.write_text(hinge.replace("[joints]", "tip = { mass = 1, inertia = [1, 1, 1] }\n[joints]"))
    assert [x.on for x in read_scene(path).effects if x.effect.name == "coulomb"] == ["flap"]
    path.write_text(path.read_text().replace('["*"]', '["w*"]'))
    assert [x.on for x in read_scene(path).effects if x.effect.name == "coulomb"] == ["wrist"]



