"""Scene files: every number is read exactly, and everything else is one clear error."""

import math
import subprocess
import sys
from fractions import Fraction as F
from pathlib import Path

import pytest

from coscrew_codegen.scene.formulas import Formula
from coscrew_codegen.scene.mechanism.model import Mimic, Parameter
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.recorded_quantities import QuantityError, coordinates, expected, recorded
from coscrew_codegen.scene.scene import Expectation, Run
from tests.support.scenes.kinds import Kind
from tests.support.scenes.reading import MODEL, applied


def test_the_model_is_exact(read):
    model = read().model
    assert [body.name for body in model.bodies] == ["upper", "tool", "slide"]
    upper, tool, slide = (body.inertia for body in model.bodies)
    assert upper.mass == F(3, 2) and upper.com == (0, 0, F(1, 4))
    assert upper.moments == (F(1, 10), F(1, 10), F(1, 100), 0, 0, 0)
    assert tool.moments == (F(2, 100), F(3, 100), F(4, 100), F(1, 1000), 0, F(-2, 1000))
    assert slide.moments == (0,) * 6
    shoulder, elbow, rail = model.joints
    assert (shoulder.parent, shoulder.kind, shoulder.axis) == ("world", Kind.REVOLUTE, (0, -1, 0))
    assert (shoulder.lower, shoulder.upper, shoulder.effort, shoulder.velocity) == (-1, 2, 8, 3)
    assert (shoulder.damping, shoulder.friction) == (F(1, 2), F(1, 10))
    assert elbow.placement.t == (0, 0, F(1, 2))
    assert elbow.placement.R == (1, 0, 0, 0, 0, -1, 0, 1, 0)
    assert rail.mimic == Mimic("elbow", F(1, 2), F(1, 8))


def test_what_is_not_given_has_defaults(read):
    scene = read()
    assert (scene.name, scene.precision, scene.record) == ("arm", "double", ("q", "v"))
    assert (scene.effects, scene.parameters, scene.expectations) == ((), (), ())
    assert scene.run == Run() and scene.every == 0.01


@pytest.mark.parametrize("stem, name", [
    ("6-joint arm", "scene_6_joint_arm"), ("int", "scene_int"), ("class", "scene_class"),
    ("numpy", "scene_numpy"), ("été", "t"), ("--", "scene"), ("a.b", "a_b"), ("_x", "x"),
    ("x" * 80, "x" * 34),
    *((name, f"scene_{name}") for name in (
        "math", "Math", "string", "time", "tgmath", "float", "features", "strings", "random", "sys",
        "tomllib", "imp", "threading"))])
def test_names_of_files_become_identifiers(read, stem, name):
    assert read(name=f"{stem}.toml").name == name


def test_outputs_run_start_and_expectations(read):
    scene = read('name = "reacher"\nprecision = "both"\n', """
[start.q]
shoulder = 0.5
[start.v]
elbow = [-1]
[outputs]
record = ["q.elbow", "energy.kinetic", "pose.tool.3"]
every = 0.25
[run]
duration = 5
integrator = "rk4"
step = 1e-4
rtol = 1e-7
atol = 1e-8
[expect]
"q.elbow" = { at = 5.0, value = -0.123, rtol = 1e-8 }
energy = [{ at = 0, value = 1, atol = 1e-3 }, { at = 1, value = 2, rtol = 1, atol = 3 }]
""")
    assert (scene.name, scene.precision) == ("reacher", "both")
    assert scene.start_q == {"shoulder": (0.5,)} and scene.start_v == {"elbow": (-1.0,)}
    assert scene.record == ("q.elbow", "energy.kinetic", "pose.tool.3") and scene.every == 0.25
    assert scene.run == Run(5.0, "rk4", 1e-4, 1e-7, 1e-8)
    assert scene.expectations == (Expectation("q.elbow", 5.0, -0.123, 1e-8, 0.0),
                                  Expectation("energy", 0.0, 1.0, 0.0, 1e-3),
                                  Expectation("energy", 1.0, 2.0, 1.0, 3.0))


def test_a_free_base_and_spherical_joints_start_at_unit_quaternions(read):
    scene = read('base = "free"\n', """
[start.q]
base = [1, 2, 3, 0.6, 0, 0.8000001, 0]
ball = [0, 0, 0, -1]
""", """
[bodies.hull]
mass = 1
inertia = [1, 1, 1]
[bodies.head]
mass = 1
inertia = [1, 1, 1]
[joints.ball]
type = "spherical"
parent = "hull"
child = "head"
""")
    base, ball = scene.model.joints
    assert (base.name, base.kind, base.parent, base.child) == ("base", Kind.FREE, "world", "hull")
    assert scene.start_q["ball"] == (0, 0, 0, -1)
    position, quaternion = scene.start_q["base"][:3], scene.start_q["base"][3:]
    assert position == (1, 2, 3)
    norm = math.sqrt(0.6**2 + 0.8000001**2)
    assert quaternion == pytest.approx((0.6 / norm, 0, 0.8000001 / norm, 0), rel=1e-15)
    assert sum(F(x)**2 for x in quaternion) - 1 < F(1, 2**51)


@pytest.mark.parametrize("origin, R", [
    ("quaternion = [0, 0, 0.7071067811865476, 0.7071067811865475]", (0, -1, 0, 1, 0, 0, 0, 0, 1)),
    ("axis = [0, 0, 3], angle = 3.14159265359", (-1, 0, 0, 0, -1, 0, 0, 0, 1)),
    ("rpy = [0, -1.5707963267949, 0]", (0, 0, -1, 0, 1, 0, 1, 0, 0)),
    ("xyz = [1, 2, 3]", (1, 0, 0, 0, 1, 0, 0, 0, 1))])
def test_rotations_of_origins(read, origin, R):
    model = MODEL.replace("origin = { xyz = [0, 0, 0.5], rpy = [1.57079632679, 0, 0] }",
                          f"origin = {{ {origin} }}")
    assert read(model=model).model.joints[1].placement.R == R


# effects

def test_inertias_may_be_symmetric_matrices(read):
    model = MODEL.replace("inertia = [0.02, 0.03, 0.04, 0.001, 0, -0.002]", """inertia = [
        [0.02, 0.001, 0], [0.001, 0.03, -0.002], [0, -0.002, 0.04]]""")
    assert model != MODEL and read(model=model).model == read().model


def test_effects_come_in_the_order_of_catalogue_and_model(read):
    scene = read(tail="""
[effects.viscous]
joints = ["rail", "shoulder"]
d = 0.1
[effects.gravity]
""")
    assert [(x.effect.name, x.on) for x in scene.effects] == [
        ("gravity", ""), ("viscous", "shoulder"), ("viscous", "rail")]
    assert applied(scene, "gravity")["", ""] == {"g": (0, 0, F(-981, 100))}


@pytest.mark.parametrize("text, values", [
    ('joints = "all"\nd = 0.1', {"shoulder": F(1, 10), "elbow": F(1, 10), "rail": F(1, 10)}),
    ('joints = "all"\nd = "model"', {"shoulder": F(1, 2), "elbow": F(1, 4)}),
    ('joints = ["elbow"]\nd = "model"', {"elbow": F(1, 4)}),
    ('d = { elbow = 0.1, shoulder = "model" }', {"shoulder": F(1, 2), "elbow": F(1, 10)}),
    ('elbow = { d = 1 }\njoints = ["shoulder"]\nd = 2', {"shoulder": 2, "elbow": 1}),
    ('[effects.viscous.elbow]\nd = 3', {"elbow": 3})])
def test_ways_to_give_joints(read, text, values):
    scene = read(tail=f"[effects.viscous]\n{text}\n")
    assert {on: x["d"] for (on, _), x in applied(scene, "viscous").items()} == values
    assert [x.on for x in scene.effects] == list(values)


def test_tables_of_parameters_share_what_is_given_once(read):
    scene = read(tail="[effects.stribeck]\ntau_c = { elbow = 1, rail = 2 }\ntau_s = 3\n")
    assert applied(scene, "stribeck") == {
        ("elbow", ""): {"tau_c": 1, "tau_s": 3, "eps": F(1, 1000)},
        ("rail", ""): {"tau_c": 2, "tau_s": 3, "eps": F(1, 1000)}}


def test_kinds_choose_their_parameters(read):
    scene = read(tail="""
[effects.motor.shoulder]
u = "8*sin(2*pi*t)"
limit = "model"
[effects.motor.elbow]
kind = "pd"
kp = 400
""")
    assert applied(scene, "motor") == {
        ("shoulder", ""): {"kind": "torque", "u": Formula("8*sin(2*pi*t)"), "kp": None, "limit": 8},
        ("elbow", ""): {"kind": "pd", "u": None, "kp": 400, "limit": None}}


def test_any_of_several_parameters_will_do(read):
    assert applied(read(tail='[effects.stop]\njoints = "all"'), "stop") == {
        ("shoulder", ""): {"lower": -1, "upper": 2}}
    assert applied(read(tail="[effects.stop.elbow]\nupper = 1"), "stop") == {
        ("elbow", ""): {"lower": None, "upper": 1}}


def test_wrenches_under_labels(read):
    scene = read(tail="""
[effects.push.tool]
force = [1, "t", 0.5]
[effects.push.gust]
body = "tool"
force = [0, 0, "sin(t)"]
point = [0.1, 0, 0]
seen_from = "upper"
""")
    assert applied(scene, "push") == {
        ("tool", ""): {"force": (1, Formula("t"), F(1, 2)), "point": (0, 0, 0),
                       "seen_from": "world"},
        ("tool", "gust"): {"force": (0, 0, Formula("sin(t)")), "point": (F(1, 10), 0, 0),
                           "seen_from": "upper"}}


def test_pairs_of_bodies(read):
    scene = read(tail='[effects.tendon.left]\nbodies = ["world", "tool"]\nk = 7\n')
    assert applied(scene, "tendon") == {("left", "left"): {"k": 7, "d": None,
                                                          "bodies": ("world", "tool")}}


def test_a_recorded_reaction_is_selected(read):
    scene = read(tail="""
[outputs]
record = ["reaction.elbow", "reaction.elbow.2"]
[expect]
"reaction.shoulder.0" = { at = 1, value = 0, atol = 1 }
""")
    assert list(applied(scene, "reaction")) == [("shoulder", ""), ("elbow", "")]
    assert read(tail="[effects.reaction]\njoints = ['elbow']\n[outputs]\n"
                     "record = ['reaction.elbow']\n").effects[0].on == "elbow"


# parameters at run time

def test_runtime_numbers_become_parameters_in_order(read):
    scene = read('runtime = ["tool.mass", "viscous.elbow.d", "gravity.g", "upper.com.z"]\n', """
[effects.gravity]
[effects.viscous]
joints = "all"
d = "model"
""")
    expected_parameters = (
        Parameter("tool.mass", 0, F(3, 10)), Parameter("viscous.elbow.d", 1, F(1, 4)),
        Parameter("gravity.g.x", 2, F(0)), Parameter("gravity.g.y", 3, F(0)),
        Parameter("gravity.g.z", 4, F(-981, 100)), Parameter("upper.com.z", 5, F(1, 4)))
    assert scene.parameters == expected_parameters
    upper, tool, _ = scene.model.bodies
    assert tool.inertia.mass == expected_parameters[0]
    assert upper.inertia.com == (0, 0, expected_parameters[5]) and upper.inertia.mass == F(3, 2)
    assert applied(scene, "viscous")["elbow", ""]["d"] == expected_parameters[1]
    assert applied(scene, "viscous")["shoulder", ""]["d"] == F(1, 2)
    assert applied(scene, "gravity")["", ""]["g"] == expected_parameters[2:5]


def test_components_of_vectors_have_letters_and_numbers(read):
    by_number = read('runtime = ["tool.com.2", "gravity.g.0"]\n', "[effects.gravity]\n")
    by_letter = read('runtime = ["tool.com.z", "gravity.g.x"]\n', "[effects.gravity]\n")
    assert by_number == by_letter
    assert [parameter.name for parameter in by_number.parameters] == ["tool.com.z", "gravity.g.x"]


@pytest.mark.parametrize("runtime, words", [
    ('["tool.mas"]', "did you mean 'tool.mass'?"), ('["tool"]', "did you mean 'tool.com'?"),
    ('["tool.mass", "tool.mass"]', "'tool.mass' occurs twice"),
    ('["tool.com", "tool.com.x"]', "'tool.com.x' occurs twice"),
    ('["elbow.damping"]', "no number 'elbow.damping'; no effect uses it: add [effects.viscous] "
     "with joints = \"all\" and d = \"model\"; of joint 'elbow' there is none"),
    ('["shoulder.velocity"]', "no effect uses it; of joint 'shoulder' there is none"),
    ('["tool.weight"]', "no number 'tool.weight'; of body 'tool' there are tool.mass, tool.com, "
                        "tool.inertia"),
    ('["tool.com.3"]', "no number 'tool.com.3'; did you mean 'tool.com'?"),
    ('["tool.com.x", "tool.com.0"]', "'tool.com.x' occurs twice"),
    ('["motor.shoulder.u"]', "is a formula"), ('["motor.shoulder.kp"]', "is not given"),
    ('["motor.shoulder.kind"]', "is a word"), ('["shoulder.damping"]', "no number"),
    ('"tool.mass"', "wanted a list of texts"), ("[1]", "wanted text")])
def test_runtime_must_name_numbers(read, runtime, words):
    with pytest.raises(SceneError, match=r"arm.toml: runtime: ") as caught:
        read(f"runtime = {runtime}\n", '[effects.motor.shoulder]\nu = "t"\n')
    assert words in str(caught.value)


# what is not used

DAMPED = 'add [effects.viscous] with joints = "all" and d = "model"'
RUBBED = 'add [effects.stribeck] with joints = "all", tau_c = "model" and tau_s = 1'
DRIVEN = 'add [effects.motor] with joints = "all", u = 0 and limit = "model"'
STOPPED = 'add [effects.stop] with joints = "all"'


def test_numbers_that_nothing_uses_are_told(read):
    assert read().unused == (
        f"joint shoulder: damping 0.5 N m s/rad is not used: {DAMPED}",
        f"joint shoulder: friction 0.1 N m is not used: {RUBBED}",
        f"joint shoulder: effort 8 N m is not used: {DRIVEN}",
        "joint shoulder: velocity 3 rad/s is used by no effect",
        f"joint shoulder: lower -1 rad is not used: {STOPPED}",
        f"joint shoulder: upper 2 rad is not used: {STOPPED}",
        f"joint elbow: damping 0.25 N m s/rad is not used: {DAMPED}",
        "joint rail: mimic of elbow (multiplier 0.5, offset 0.125) is not used: "
        "add [effects.mimic]")
    slides = MODEL.replace('type = "revolute"', 'type = "prismatic"')
    assert read(model=slides).unused[:6] == (
        f"joint shoulder: damping 0.5 N s/m is not used: {DAMPED}",
        f"joint shoulder: friction 0.1 N is not used: {RUBBED}",
        f"joint shoulder: effort 8 N is not used: {DRIVEN}",
        "joint shoulder: velocity 3 m/s is used by no effect",
        f"joint shoulder: lower -1 m is not used: {STOPPED}",
        f"joint shoulder: upper 2 m is not used: {STOPPED}")


def test_numbers_in_use_are_not_told(read):
    scene = read(tail="""
[effects.viscous]
d = { shoulder = "model", elbow = 0.1 }
[effects.mimic]
[effects.stop.shoulder]
upper = 1
""")
    assert scene.unused == (
        f"joint shoulder: friction 0.1 N m is not used: {RUBBED}",
        f"joint shoulder: effort 8 N m is not used: {DRIVEN}",
        "joint shoulder: velocity 3 rad/s is used by no effect",
        "joint shoulder: upper 2 rad is not used: [effects.stop] has its own upper",
        "joint elbow: damping 0.25 N m s/rad is not used: [effects.viscous] has its own d")


@pytest.mark.parametrize("limit, remedy", [
    ("", 'say limit = "model" in [effects.motor]'),
    ("limit = 3", "[effects.motor] has its own limit"), ('limit = "model"', None)])
@pytest.mark.parametrize("table", ["[effects.motor.shoulder]", "[effects.motor]\njoints = 'all'"])
def test_what_an_effect_that_is_there_lacks_is_told(read, table, limit, remedy):
    model = MODEL.replace('type = "continuous"', 'type = "revolute"')
    message = [x for x in read(model=model, tail=f"{table}\nu = 1\n{limit}\n").unused
               if "joint shoulder: effort" in x]
    assert message == ([f"joint shoulder: effort 8 N m is not used: {remedy}"] if remedy else [])


# quantities

def test_places_and_units_of_quantities(read):
    scene = read()
    assert recorded("q", scene).names == ("q.shoulder", "q.elbow", "q.rail")
    assert recorded("v", scene).units == ("rad/s", "rad/s", "m/s")
    assert recorded("a.rail", scene).places == (2,) and recorded("a.rail.0", scene).places == (2,)
    assert recorded("energy", scene).names == ("energy.kinetic", "energy.potential", "energy.total")
    assert recorded("energy.1", scene).names == ("energy.potential",)
    assert recorded("power", scene).names == ("power",)
    pose = recorded("pose.tool", scene)
    assert pose.places == tuple(range(12)) and pose.units[3:5] == ("m", "1")
    assert recorded("twist.tool.3", scene).units == ("rad/s",)
    assert recorded("reaction.elbow.2", scene).names == ("reaction.elbow.2",)
    assert expected("energy", scene).names == ("energy.total",)
    for name, number in zip("xyz", "012", strict=True):
        assert (recorded(f"position.tool.{name}", scene).places
                == recorded(f"position.tool.{number}", scene).places == (int(number),))
    assert recorded("position.tool.y", scene).names == ("position.tool.1",)
    with pytest.raises(QuantityError, match="3 components"):
        expected("q", scene)


def test_followers_have_no_coordinates(read):
    scene = read(tail="[effects.mimic]\n")
    assert [joint.name for joint, _, _ in coordinates(scene)] == ["shoulder", "elbow"]
    assert recorded("q", scene).names == ("q.shoulder", "q.elbow")
    with pytest.raises(QuantityError, match="follows another"):
        recorded("q.rail", scene)


@pytest.mark.parametrize("text, words", [
    ("qd", "wanted one of q, v, a"), ("q.elbw", "did you mean 'elbow'?"), ("q.", "lacks its joint"),
    ("q.elbow.1", "no component '1'"), ("pose", "lacks its body"), ("pose.tool.12", "0 to 11"),
    ("pose.tol", "did you mean 'tool'?"), ("energy.kinetc", "kinetic, potential, total"),
    ("reaction.world", "no joint"), ("", "no quantity"), ("q.elbow.", "component"),
    ("pose.tool.-1", "component"), ("momentum.6", "0 to 5"), ("momentum.x", "0 to 5"),
    ("energy.x", "kinetic"),
    ("position.tool.w", "0 to 2, or x, y, z"), ("position.tol.x", "did you mean 'tool'?"),
    ("q.elbow.0.0", "no joint")])
def test_other_texts_are_no_quantities(read, text, words):
    scene = read()
    with pytest.raises(QuantityError) as caught:
        recorded(text, scene)
    assert words in str(caught.value)


def test_readers_of_files_know_no_dynamics():
    """Reading a scene file imports readers, the scene's own classes, the lists of effects and
    integrators and what these import; no derivation, no target, no SymPy."""
    program = ("import sys; from pathlib import Path; "
               "from coscrew_codegen.scene.readers.toml.toml_scene import read_scene; "
               "read_scene(Path('examples/scenes/quadruped.toml')); print(*sys.modules)")
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True,
                          check=True, cwd=Path(__file__).parents[2])
    loaded = set(done.stdout.split())
    ours = {x.split(".")[1] for x in loaded if x.startswith("coscrew_codegen.")}
    assert ours <= {"scene", "program", "algebra"}
    assert not loaded & {"coscrew_codegen.algebra.recording.recorder", "sympy", "numpy"}
