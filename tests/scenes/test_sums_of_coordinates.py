"""Effects on weighted sums of joints' coordinates, as tendons and differential drives have them.

MuJoCo's fixed tendons, closed forms and differences in 50 digits are the truth."""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from pathlib import Path

import mpmath
import mujoco
import numpy as np
import pytest
from mpmath import mpf

from coscrew_codegen import load_scene, run
from coscrew_codegen.dynamics import derive
from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.scene.effect_quantities import units_of
from coscrew_codegen.scene.mechanism.loop import WeightedCoordinate
from coscrew_codegen.scene.mechanism.model import HERE, WORLD, Body, Joint, Model
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Applied
from tests.support.each import each_precision
from tests.support.scenes.differences import check
from tests.support.scenes.effect_laws import assert_same, multiprecise
from tests.support.scenes.effect_scenes import mechanism
from tests.support.scenes.generated_scenes import imported
from tests.support.scenes.kinds import Kind
from tests.support.scenes.mechanisms import (
    X,
    applied,
    at,
    chain_of_three,
    gravity,
    inertia,
    scene,
)
from tests.support.scenes.scene_values import random_state

STEP, HALF = mpf(10)**-16, Fraction(1, 2)


def term(joint: str, weight: object, coordinate: int = 0) -> WeightedCoordinate:
    return WeightedCoordinate(joint, coordinate, Fraction(weight))


TWO = (term("j0", 2), term("j1", -3))


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(50):
        yield


def on_sum(name: str, *terms: WeightedCoordinate, **values: object) -> Applied:
    made = applied(name, "s", **values)
    return Applied(made.effect, "s", made.values, "s", terms)


def sliders() -> Model:
    """Masses of 2 and 5 kg, each on a line fixed to the world."""
    return Model("sliders", (Body("b0", inertia(2)), Body("b1", inertia(5))),
                 (Joint("j0", Kind.PRISMATIC, WORLD, "b0", HERE, X),
                  Joint("j1", Kind.PRISMATIC, WORLD, "b1", at(0, 1, 0), X)))


def test_a_spring_and_a_damper_on_a_sum_act_by_the_weights() -> None:
    """u = -k (2 q0 - 3 q1 - c) - d (2 v0 - 3 v1): torques 2 u and -3 u, energy k (…)²/2."""
    f = multiprecise(sliders(), on_sum("spring", *TWO, k=7, q0=HALF), on_sum("viscous", *TWO, d=4))
    q, v = [mpf("0.3"), mpf("-1.1")], [mpf(3), mpf("0.2")]
    away, rate = 2 * q[0] - 3 * q[1] - mpf("0.5"), 2 * v[0] - 3 * v[1]
    u = -7 * away - 4 * rate
    assert_same(f("bias_torques", q=q, v=v), [-2 * u, 3 * u])
    assert_same(f("forward_dynamics", q=q, v=v, tau=[1, 2]), [(1 + 2 * u) / 2, (2 - 3 * u) / 5])
    assert_same(f("energy", q=q, v=v), [mpf(2) / 2 * v[0]**2 + mpf(5) / 2 * v[1]**2,
                                        mpf(7) / 2 * away**2])
    assert_same([f("power", q=q, v=v)], [-4 * rate**2])
    assert_same(f.components("effect_spring_s", q=q, v=v), [
        -7 * away, -7 * away * rate, mpf(7) / 2 * away**2])
    assert_same(f.components("effect_viscous_s", q=q, v=v), [-4 * rate, -4 * rate**2])


@pytest.mark.parametrize("terms", [TWO, TWO[:1]], ids=["two", "one"])
def test_implicit_steps_take_slopes_along_the_sum(terms: Sequence[WeightedCoordinate]) -> None:
    """(M + (h d + h² k) e e^T) a = e (u - h k e·v)."""
    f = multiprecise(sliders(), on_sum("spring", *terms, k=700), on_sum("viscous", *terms, d=90))
    h, q, v = mpf("0.3"), [mpf("0.3"), mpf("-1.1")], [mpf(3), mpf("0.2")]
    e = mpmath.matrix([2, -3 if len(terms) > 1 else 0])
    s, rate = (sum(a * b for a, b in zip(e, x, strict=True)) for x in (q, v))
    M = mpmath.matrix([[2, 0], [0, 5]]) + (h * 90 + h**2 * 700) * (e * e.T)
    wanted = mpmath.lu_solve(M, e * (-700 * s - 90 * rate - h * 700 * rate))
    assert_same(f("implicit_acceleration", h=h, q=q, v=v), list(wanted))


def test_one_term_is_an_effect_on_the_joint() -> None:
    """u(w q) w: a spring w² k, with rest q0/w, and so on, in every function."""
    single = (on_sum("spring", TWO[0], k=7, q0=1), on_sum("viscous", TWO[0], d=3))
    joint = (applied("spring", "j0", k=28, q0=HALF), applied("viscous", "j0", d=12))
    f, g = (multiprecise(chain_of_three(), gravity(), *x) for x in (single, joint))
    x = {**random_state(f, 2), "h": mpf(1) / 8}
    for name in ("inverse_dynamics", "forward_dynamics", "bias_torques", "energy", "power",
                 "implicit_acceleration", "midpoint_acceleration"):
        one, other = (y(name, a=x["tau"], **x) for y in (f, g))
        if name == "power":
            one, other = [one], [other]
        assert_same(list(one), list(other))


ACTING = (gravity(), on_sum("spring", term("j1", 2), term("j2", HALF), k=7),
          on_sum("viscous", term("j1", 2), term("j2", HALF), d=3),
          on_sum("actuator", term("j1", 1), term("j2", -1), kind="pd", kp=5, kd=2, target=1),
          on_sum("limit", term("j1", 1), term("j2", 1), upper=-9, k=4, alpha=HALF),
          applied("viscous", "j3", d=1))


ROTOR = on_sum("armature", term("j1", 2), term("j2", HALF), rotor=HALF, gear=3)


@pytest.mark.parametrize("acting", [ACTING, (*ACTING, ROTOR)], ids=["massless", "with a rotor"])
def test_energy_changes_by_what_is_fed_in(acting: Sequence[Applied]) -> None:
    f = multiprecise(mechanism(), *acting)
    x = random_state(f, 1)
    a = f("forward_dynamics", **x)

    def energy(s: mpf) -> mpf:
        q = f("integrated", q=x["q"], phi=[s * v for v in x["v"]])
        return sum(f("energy", q=q, v=[v + s * y for v, y in zip(x["v"], a, strict=True)]))

    fed = f("power", **x) + sum(t * v for t, v in zip(x["tau"], x["v"], strict=True))
    assert abs((energy(STEP) - energy(-STEP)) / (2 * STEP) - fed) < mpf(10)**-20


@pytest.mark.parametrize("more", [(), (ROTOR,)], ids=["massless", "with a rotor"])
def test_derivatives_are_differences(more: Sequence[Applied]) -> None:
    check(scene(mechanism(), *ACTING, *more))


def test_a_rotor_on_a_sum_adds_a_term_to_the_mass_matrix() -> None:
    """M = diag(2, 5) + I e e^T with I = 9 rotor and e = (2, -3)."""
    rotor, h = on_sum("armature", *TWO, rotor=HALF, gear=3), mpf("0.3")
    f = multiprecise(sliders(), rotor, on_sum("spring", *TWO, k=700), on_sum("viscous", *TWO, d=90))
    q, v, a = [mpf("0.3"), mpf("-1.1")], [mpf(3), mpf("0.2")], [mpf(-2), mpf(7)]
    e, I = mpmath.matrix([2, -3]), mpf("4.5")
    s, rate, faster = (sum(x * y for x, y in zip(e, z, strict=True)) for z in (q, v, a))
    M, u = mpmath.matrix([[2, 0], [0, 5]]) + I * (e * e.T), -700 * s - 90 * rate
    assert_same(f("mass_matrix", q=q), list(M))
    assert_same(f("inverse_dynamics", q=q, v=v, a=a), list(M * mpmath.matrix(a) - e * u))
    assert_same(f("forward_dynamics", q=q, v=v, tau=[1, 2]), list(
        mpmath.lu_solve(M, mpmath.matrix([1, 2]) + e * u)))
    assert_same(f("energy", q=q, v=v)[:1], [(2 * v[0]**2 + 5 * v[1]**2 + I * rate**2) / 2])
    assert_same(f.components("effect_armature_s", q=q, v=v), [I * rate**2 / 2])
    implicit = mpmath.lu_solve(M + (h * 90 + h**2 * 700) * (e * e.T), e * (u - h * 700 * rate))
    assert_same(f("implicit_acceleration", h=h, q=q, v=v), list(implicit))


def test_a_rotor_on_one_term_is_that_of_the_joint() -> None:
    single = on_sum("armature", TWO[0], inertia=7), on_sum("viscous", TWO[0], d=3)
    joint = applied("armature", "j0", inertia=28), applied("viscous", "j0", d=12)
    f, g = (multiprecise(chain_of_three(), gravity(), *x) for x in (single, joint))
    x = {**random_state(f, 2), "h": mpf(1) / 8}
    for name in ("inverse_dynamics", "mass_matrix", "forward_dynamics", "energy",
                 "implicit_acceleration", "midpoint_acceleration"):
        one, other = (y(name, a=x["tau"], **x) for y in (f, g))
        assert_same(list(one), list(other))


def test_a_rotor_counts_for_the_leader_of_a_follower() -> None:
    """q_k = -3/2 q_0: the sum of q_k and q_1 has the weights -3/2 and 1."""
    terms, same = (term("k", 1), term("j1", 1)), (term("j0", Fraction(-3, 2)), term("j1", 1))
    f, g = (multiprecise(chain_of_three(), gravity(), applied("mimic"), on_sum(
        "armature", *x, inertia=2)) for x in (terms, same))
    x = random_state(f, 2)
    for name in ("inverse_dynamics", "mass_matrix", "forward_dynamics", "energy"):
        one, other = (y(name, a=x["tau"], **x) for y in (f, g))
        assert_same(list(one), list(other))


MASSLESS = """bodies = { a = {}, b = { mass = 1, com = [1, 0, 0], inertia = [0.1, 0.2, 0.2] } }
[joints]
motor = { type = "continuous", child = "a", axis = [0, 0, 1] }
crank = { type = "continuous", child = "b", axis = [0, 0, 1] }
[effects.armature.drive]
joints = { motor = 1, crank = -2 }
inertia = 0
"""


def test_a_rotor_on_a_sum_holds_a_joint_without_mass(tmp_path: Path) -> None:
    """Without it the mass matrix is singular."""
    path = tmp_path / "motor.toml"
    path.write_text(MASSLESS)
    with pytest.warns(RuntimeWarning, match="joint 'motor' moves nothing that has a mass"):
        load_scene(path)
    path.write_text(MASSLESS.replace("inertia = 0\n", "inertia = 0.3\n"))
    a = load_scene(path, functions=["forward_dynamics"]).double.forward_dynamics(
        [0, 0], [0, 0], [1.0, 0])
    # rotor: 0.3 (a0 - 2 a1) = 1; crank: 1.2 a1 - 0.6 (a0 - 2 a1) = 0
    assert np.abs(a - [1 / 0.3 + 2 * 2 / 1.2, 2 / 1.2]).max() < 1e-14


def test_a_followers_weight_counts_for_its_leader() -> None:
    """In chain_of_three k follows j0 by -3/2: q_k + q_1 is the sum of -3/2 q_0 and q_1."""
    terms = term("k", 1), term("j1", 1)
    same = term("j0", Fraction(-3, 2)), term("j1", 1)
    f, g = (multiprecise(chain_of_three(), gravity(), applied("mimic"), on_sum("spring", *x, k=9),
                         on_sum("viscous", *x, d=2)) for x in (terms, same))
    x = {**random_state(f, 2), "h": mpf(1) / 8}
    for name in ("inverse_dynamics", "forward_dynamics", "energy", "implicit_acceleration",
                 "midpoint_acceleration"):
        one, other = (y(name, a=x["tau"], **x) for y in (f, g))
        assert_same(list(one), list(other))


def test_a_floating_base_stays_free() -> None:
    """Sums act within the tree."""
    assert "free_momentum" in [x.name for x in derive(scene(mechanism(), ACTING[1])).functions]


# files

TEXT = """
[bodies]
hull = { mass = 2, com = [0.1, 0.2, 0.3], inertia = [0.5, 0.6, 0.7] }
arm = { mass = 1, com = [0, 0.1, 0.2], inertia = [0.1, 0.2, 0.25] }
tip = { mass = 0.5, com = [0.3, 0, 0], inertia = [0.03, 0.04, 0.05] }
[joints]
table = { type = "planar", child = "hull", axis = [0, 0, 1] }
elbow = { type = "revolute", parent = "hull", child = "arm", axis = [0, 1, 0] }
wrist = { type = "revolute", parent = "arm", child = "tip", axis = [0, 1, 0], \
origin = { xyz = [0.4, 0, 0] } }
[effects.gravity]
[effects.spring.cable]
joints = { wrist = -0.5, elbow = 1 }
k = 30
q0 = 0.2
[effects.viscous.cable]
joints = { elbow = 1, wrist = -0.5 }
d = 2
[effects.actuator.drive]
joints = { "table.2" = 0.5, elbow = 0.25 }
kind = "torque"
torque = "sin(5*t)"
limit = 0.8
[effects.limit.stop]
joints = { "table.0" = 1, "table.1" = 1 }
upper = 0.01
k = 1e3
[outputs]
record = ["q", "energy", "spring.cable.torque", "actuator.drive.saturated"]
[run]
duration = 0.5
[start.v]
table = [0.3, 0.1, 0]
"""


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory):
    path = tmp_path_factory.mktemp("sums") / "sums.toml"
    path.write_text(TEXT)
    return path


CALLED = ("inverse_dynamics", "forward_dynamics", "energy", "effect_spring_cable",
          "midpoint_acceleration", "closing_contacts", "parts")


@pytest.fixture(scope="module")
def kernels(path) -> Kernels:
    return load_scene(path, functions=["default", *CALLED[:4]], tiers=["accurate"])


def test_files_have_them_under_a_label(kernels):
    made = kernels.scene
    assert {x.name: x.terms for x in made.effects if x.terms}["spring.cable"] == (
        term("elbow", 1), term("wrist", -HALF))
    own = {x.name: x for x in made.effects}
    assert units_of(own["spring.cable"], made)["torque"] == ("N m",)
    assert units_of(own["limit.stop"], made)["torque"] == ("N",)
    assert own["actuator.drive"].terms[0] == term("table", HALF, 2)


@each_precision
def test_c_and_numpy_compute_the_same_bits(kernels, tmp_path, precision):
    twin, rng = getattr(imported(kernels.functions, tmp_path), precision.name), \
        np.random.default_rng(3)
    for name in ("inverse_dynamics", "forward_dynamics", "energy", "effect_spring_cable"):
        given = [rng.uniform(-1, 1, () if x.name == "t" else 5).astype(precision.numpy_type)
                 for x in kernels.functions.named(name).inputs]
        one, other = (getattr(x, name)(*given)
                      for x in (getattr(kernels, precision.name), twin))
        assert np.asarray(one).tobytes() == np.asarray(other).tobytes(), name


def test_a_run_records_them_and_keeps_the_energy_of_what_does_not_dissipate(path):
    result = run(path)
    q = {name: result.recorded[f"q.{name}"] for name in ("elbow", "wrist")}
    torque = -30 * (q["elbow"] - q["wrist"] / 2 - 0.2)
    assert np.abs(result.recorded["spring.cable.torque"] - torque).max() < 1e-14 * 30
    assert set(result.recorded["actuator.drive.saturated"]) == {0.0, 1.0}
    reached = result.recorded["q.table.0"] + result.recorded["q.table.1"]
    assert 0.01 < reached.max() < 0.1 and reached[-1] < 0.01  # it bounced


MJCF = """<mujoco><option gravity="0 0 -9.8"/><compiler angle="radian"/><worldbody>
<body name="a" pos="0 0 1"><joint name="one" axis="0 1 0"/><geom size="0.1" pos="0.2 0 0"/>
<body name="b" pos="0.4 0 0"><joint name="two" axis="0 1 0"/><geom size="0.1" pos="0.2 0.1 0"/>
<body name="c" pos="0.4 0 0"><joint name="three" type="slide" axis="1 0 0"/><geom size="0.1"/>
</body></body></body></worldbody><tendon><fixed name="t" stiffness="40" damping="3"
springlength="0.3"><joint joint="one" coef="0.7"/><joint joint="three" coef="-2"/></fixed></tendon>
</mujoco>"""


def test_they_are_mujocos_fixed_tendons(tmp_path):
    """Bias of MuJoCo less its passive forces, to some roundings."""
    text = """model = "robot.xml"
[effects.gravity]
g = [0, 0, -9.8]
[effects.spring.t]
joints = { one = 0.7, three = -2 }
k = 40
q0 = 0.3
[effects.viscous.t]
joints = { one = 0.7, three = -2 }
d = 3
"""
    (tmp_path / "robot.xml").write_text(MJCF)
    (tmp_path / "scene.toml").write_text(text)
    ours = load_scene(tmp_path / "scene.toml", functions=["inverse_dynamics"]).double
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "robot.xml"))
    data, rng = mujoco.MjData(model), np.random.default_rng(5)
    for _ in range(5):
        data.qpos[:], data.qvel[:] = rng.normal(size=(2, 3))
        mujoco.mj_forward(model, data)
        wanted = data.qfrc_bias - data.qfrc_passive
        mine = ours.inverse_dynamics(data.qpos, data.qvel, np.zeros(3))
        assert np.abs(mine - wanted).max() < 1e-13 * np.abs(wanted).max()


SPRING = "[effects.spring.cable]\njoints = { wrist = -0.5, elbow = 1 }"


@pytest.mark.parametrize("old, new, message", [
    (SPRING, "[effects.spring.cable]\njoints = {}", "spring.cable.joints: an empty table; wanted "
     "weights by joint, as { elbow = 1 }"),
    (SPRING, "[effects.spring.elbow]\njoints = { wrist = 1 }", "spring.elbow.joints: 'elbow' is "
     "itself a joint; wanted another label for a sum"),
    (SPRING, "[effects.spring.k]\njoints = { wrist = 1 }", "spring.k: 'k' is a parameter; wanted "
     "another label"),
    ("elbow = 1 }\nk", "elbow = 0 }\nk", "elbow: 0; wanted another weight, or no such joint"),
    ("elbow = 1 }\nk", "elbo = 1 }\nk", "no joint that moves 'elbo'; did you mean 'elbow'?"),
    ("elbow = 1 }\nk", "table = 1 }\nk", "table: is planar; wanted one of its coordinates, table.0 "
     "to table.2"),
    ("elbow = 1 }\nk", '"table.3" = 1 }\nk', "is planar; wanted one of its coordinates, table.0 "
     "to table.2"),
    ('type = "planar", child = "hull", axis = [0, 0, 1]', 'type = "free", child = "hull"',
     "is free, and a quaternion is in no sum; wanted joints whose coordinates are angles and "
     "lengths"),
    ("[effects.viscous.cable]", "[effects.reaction.cable]",
     "reaction acts on joints, not on a sum of their coordinates; wanted a table for each joint"),
    ('torque = "sin(5*t)"', 'torque = "sin(5*t)"\ngravity_compensation = true', "actuator.drive "
     "acts on a sum of coordinates, which no torque holds; wanted no gravity_compensation there")])
def test_wrong_sums_are_refused(tmp_path, old, new, message):
    assert old in TEXT
    text = TEXT.replace(old, new)
    if "free" in new:
        text = text.replace("table = [0.3, 0.1, 0]", "")
    (tmp_path / "sums.toml").write_text(text)
    with pytest.raises(SceneError) as caught:
        read_scene(tmp_path / "sums.toml")
    assert message in str(caught.value)


ROTOR_FILE = MJCF.replace('stiffness="40" damping="3"\nspringlength="0.3"', 'armature="5"').replace(
    'name="one"', 'name="one" damping="2"').replace('name="two"', 'name="two" stiffness="7"')


def test_derivatives_of_steps_with_a_rotor_on_a_sum_are_differences(tmp_path):
    """Damped and elastic at joints, so that the equations of the step are differentiated as a
    whole."""
    (tmp_path / "robot.xml").write_text(ROTOR_FILE)
    ours = load_scene(tmp_path / "robot.xml", functions=["default", "step_leapfrog_derivatives"])
    rng, h, eps = np.random.default_rng(2), 0.05, 1e-6
    x = rng.normal(size=6)
    moved = x + eps * np.vstack([np.eye(6), -np.eye(6)])
    ends = np.hstack(ours.double.step_leapfrog(h, moved[:, :3], moved[:, 3:]))
    A = ours.double.step_leapfrog_derivatives(h, x[:3], x[3:])[-1]
    differences = ((ends[:6] - ends[6:]) / (2 * eps)).T
    assert np.abs(A - differences).max() < 1e-8 * np.abs(A).max()
