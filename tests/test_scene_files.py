"""Scene files: every number arrives exactly, and everything else is one clear error."""

import math
from fractions import Fraction as F

import pytest

from coscrew_codegen.dynamics.constants import constant
from coscrew_codegen.dynamics.formulas import Formula
from coscrew_codegen.dynamics.model import Kind, Mimic, Parameter
from coscrew_codegen.dynamics.names import did_you_mean, nearest
from coscrew_codegen.dynamics.quantities import QuantityError, coordinates, expected, recorded
from coscrew_codegen.dynamics.scene import Expectation, Run
from coscrew_codegen.scene_files.errors import SceneError
from coscrew_codegen.scene_files.toml_scene import read_scene

from .example_effects import CATALOGUE

MODEL = """
[bodies.upper]
mass = 1.5
com = [0, 0, 0.25]
inertia = [0.1, 0.1, 0.01]
[bodies.tool]
mass = 0.3
inertia = [0.02, 0.03, 0.04, 0.001, 0, -0.002]
[bodies.slide]
mass = 0.2
[joints.shoulder]
type = "revolute"
child = "upper"
axis = [0, -2, 0]
damping = 0.5
friction = 0.1
limits = { lower = -1, upper = 2, effort = 8, velocity = 3 }
[joints.elbow]
type = "continuous"
parent = "upper"
child = "tool"
axis = [1, 0, 0]
damping = 0.25
origin = { xyz = [0, 0, 0.5], rpy = [1.57079632679, 0, 0] }
[joints.rail]
type = "prismatic"
parent = "tool"
child = "slide"
axis = [0, 0, 1]
mimic = { joint = "elbow", multiplier = 0.5, offset = 0.125 }
"""


@pytest.fixture
def read(tmp_path):
    """Reads a scene with MODEL unless it brings its own."""

    def read(head="", tail="", model=MODEL, name="arm.toml"):
        path = tmp_path / name
        path.write_text(head + model + tail, encoding="utf-8")
        return read_scene(path, CATALOGUE)

    return read


def applied(scene, effect):
    return {(x.on, x.label): x.values for x in scene.effects if x.effect.name == effect}


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
    ("quaternion = [0.7071067811865476, 0, 0, 0.7071067811865475]", (0, -1, 0, 1, 0, 0, 0, 0, 1)),
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
    assert applied(scene, "tendon") == {("left", "left"): {"k": 7, "bodies": ("world", "tool")}}


def test_a_recorded_reaction_is_asked_for(read):
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
    ('["elbow.damping"]', "no number 'elbow.damping'; no effect uses it: add [effects.viscous]; of "
                          "joint 'elbow' there is none"),
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

def test_numbers_that_nothing_uses_are_told(read):
    assert read().unused == (
        "joint shoulder: damping 0.5 N m s/rad is not used: add [effects.viscous]",
        "joint shoulder: friction 0.1 N m is not used: add [effects.stribeck]",
        "joint shoulder: effort 8 N m is not used: add [effects.motor]",
        "joint shoulder: velocity 3 rad/s is not used",
        "joint shoulder: lower -1 rad is not used: add [effects.stop]",
        "joint shoulder: upper 2 rad is not used: add [effects.stop]",
        "joint elbow: damping 0.25 N m s/rad is not used: add [effects.viscous]",
        "joint rail: mimic of elbow (multiplier 0.5, offset 0.125) is not used: "
        "add [effects.mimic]")
    slides = MODEL.replace('type = "revolute"', 'type = "prismatic"')
    assert read(model=slides).unused[:6] == (
        "joint shoulder: damping 0.5 N s/m is not used: add [effects.viscous]",
        "joint shoulder: friction 0.1 N is not used: add [effects.stribeck]",
        "joint shoulder: effort 8 N is not used: add [effects.motor]",
        "joint shoulder: velocity 3 m/s is not used",
        "joint shoulder: lower -1 m is not used: add [effects.stop]",
        "joint shoulder: upper 2 m is not used: add [effects.stop]")


def test_numbers_in_use_are_not_told(read):
    scene = read(tail="""
[effects.viscous]
d = { shoulder = "model", elbow = 0.1 }
[effects.mimic]
[effects.stop.shoulder]
upper = 1
""")
    assert scene.unused == (
        "joint shoulder: friction 0.1 N m is not used: add [effects.stribeck]",
        "joint shoulder: effort 8 N m is not used: add [effects.motor]",
        "joint shoulder: velocity 3 rad/s is not used",
        "joint shoulder: upper 2 rad is not used: add [effects.stop]",
        "joint elbow: damping 0.25 N m s/rad is not used: add [effects.viscous]")


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


# errors

@pytest.mark.parametrize("head, tail, where, words", [
    ('percision = "double"\n', "", "percision", "did you mean 'precision'?"),
    ('precision = "half"\n', "", "precision", "wanted one of double, single, both"),
    ("precision = 64\n", "", "precision", "the number 64; wanted text"),
    ('base = "floating"\n', "", "base", "wanted one of fixed, free"),
    ('base = "free"\n', "", "base", "the root is the world"),
    ('name = "6dof"\n', "", "name", "scene_6dof"), ('name = "while"\n', "", "name", "word of C"),
    ('name = "math"\n', "", "name", "scene_math"),
    ('name = ""\n', "", "name", "identifier"), ('name = true\n', "", "name", "the boolean true"),
    ('model = "arm.urdf"\n', "", "bodies", "wanted one of both"),
    ("", "[effects.gravty]", "effects.gravty", "did you mean 'gravity'?"),
    ("", "[effects.gravity]\ng = 9.81", "effects.gravity.g", "a list of 3 numbers"),
    ("", "[effects.gravity]\ng = [0, 0, 't']", "effects.gravity.g", "depends on t"),
    ("", "[start]\nq.elbow = '2*t'", "start.q.elbow", "depends on t; wanted a constant"),
    ("", "[start]\nq.elbow = 'exp(-(1e300**100*1e300))'", "start.q.elbow", "out of range"),
    ("", "[effects.gravity]\ng = [0, 0, nan]", "effects.gravity.g", "not finite"),
    ("", "[effects.gravity]\ng = [0, 0, -inf]", "effects.gravity.g", "not finite"),
    ("", "[effects.gravity]\nG = [0, 0, 1]", "effects.gravity.G", "did you mean 'g'?"),
    ("", "[effects.gravity]\ng = [0, 0]", "effects.gravity.g", "a list of 2"),
    ("", "[effects]\ngravity = true", "effects.gravity", "the boolean true; wanted a table"),
    ("", "[effects.viscous]\nd = 0.1", "effects.viscous.joints", "missing"),
    ("", "[effects.viscous]", "effects.viscous.joints", "missing"),
    ("", "[effects.viscous]\njoints = 'all'", "effects.viscous.d",
     "missing; wanted damping in N m"),
    ("", "[effects.viscous]\njoints = ['elbw']\nd = 1", "effects.viscous.joints",
     "no joint 'elbw'; did you mean 'elbow'?"),
    ("", "[effects.viscous]\njoints = []\nd = 1", "effects.viscous.joints", "empty list"),
    ("", "[effects.viscous]\njoints = 'elbow'\nd = 1", "effects.viscous.joints",
     "the text 'elbow'"),
    ("", "[effects.viscous]\njoints = ['elbow', 'elbow']\nd = 1", "effects.viscous.joints",
     "twice"),
    ("", "[effects.viscous]\njoints = ['rail']\nd = 'model'", "effects.viscous.d",
     "no damping for joint 'rail'"),
    ("", "[effects.viscous]\nd = { rail = 'model' }", "effects.viscous.d", "joint 'rail'"),
    ("", "[effects.viscous]\nd = { raill = 1 }", "effects.viscous.d.raill", "did you mean 'rail'?"),
    ("", "[effects.viscous]\njoints = ['elbow']\nd = { rail = 1, elbow = 1 }",
     "effects.viscous.d.rail", "not among the joints"),
    ("", "[effects.viscous]\njoints = 'all'\nd = { rail = 1 }", "effects.viscous.d.shoulder",
     "missing"),
    ("", "[effects.viscous]\njoints = 'all'\nd = true", "effects.viscous.d", "the boolean true"),
    ("", "[effects.viscous]\njoints = 'all'\nd = 'modle'", "effects.viscous.d", "or \"model\""),
    ("", "[effects.viscous]\njoints = 'all'\nd = -1", "effects.viscous.d", "wanted 0 or more"),
    ("", "[effects.viscous]\njoints = 'all'\nd = 1e999", "effects.viscous.d", "out of range"),
    ("", "[effects.viscous]\njoints = 'all'\nd = 1979-05-27", "effects.viscous.d", "the time"),
    ("", "[effects.viscous.elbow]\nd = 1\n[effects.viscous]\njoints = 'all'\nd = 1",
     "effects.viscous.elbow", "given twice"),
    ("", "[effects.viscous.elbw]\nd = 1", "effects.viscous.elbw", "did you mean 'elbow'?"),
    ("", "[effects.viscous.elbow]\nD = 1", "effects.viscous.elbow.D", "did you mean 'd'?"),
    ("", "[effects.viscous]\ndamp = 1", "effects.viscous.damp",
     "unknown key; wanted one of d, elbow, joints, rail, shoulder"),
    ("", "[effects.viscous]\njoints = 'all'\ndd = 1", "effects.viscous.dd",
     "unknown key; did you mean 'd'?"),
    ("", "[effects.viscous]\njoints = 'all'\ndd = { elbow = 1 }", "effects.viscous.dd",
     "did you mean 'd'?"),
    ("", "[effects.stribeck]\ntau_c = { elbow = 1, rail = 2 }\ntau_s = { elbow = 1 }",
     "effects.stribeck.tau_s.rail", "missing"),
    ("", "[effects.stribeck.elbow]\ntau_c = 1\ntau_s = 1\neps = 0", "effects.stribeck.elbow.eps",
     "positive"),
    ("", "[effects.motor.elbow]\nu = 'sinn(t)'", "effects.motor.elbow.u", "did you mean 'sin'?"),
    ("", "[effects.motor.elbow]\nu = '1/t'", "effects.motor.elbow.u", "not finite at t = 0"),
    ("", "[effects.motor.elbow]\nu = [1]", "effects.motor.elbow.u", "a function of t"),
    ("", "[effects.motor.elbow]\nkind = 'dc'", "effects.motor.elbow.kind", "torque, pd"),
    ("", "[effects.motor.elbow]\nu = 1\nkp = 2", "effects.motor.elbow.kp", "is for kind = 'pd'"),
    ("", "[effects.motor.elbow]\nkind = 'pd'", "effects.motor.elbow.kp", "missing"),
    ("", "[effects.stop.elbow]", "effects.stop.elbow.lower", "missing; wanted lower or upper"),
    ("", "[effects.push.tol]\nforce = [0, 0, 0]", "effects.push.tol", "did you mean 'tool'?"),
    ("", "[effects.push.gust]\nbody = 'tol'\nforce = [0, 0, 0]", "effects.push.gust.body",
     "'tool'"),
    ("", "[effects.push.tool]\nforce = [0, 0]", "effects.push.tool.force", "a list of 2"),
    ("", "[effects.push.tool]\nforce = [0, 0, 't+']", "effects.push.tool.force", "cannot be read"),
    ("", "[effects.tendon]", "effects.tendon", "is empty"),
    ("", "[effects.tendon]\nk = 1", "effects.tendon.k", "under a label"),
    ("", "[effects.tendon.a]\nk = 1", "effects.tendon.a.bodies", "missing"),
    ("", "[effects.tendon.a]\nk = 1\nbodies = ['tool']", "effects.tendon.a.bodies", "a list of 1"),
    ("", "[effects.tendon.a]\nk = 1\nbodies = ['tool', 'tool']", "effects.tendon.a.bodies",
     "twice"),
    ("", "[effects.tendon.a]\nk = 1\nbodies = ['tool', 'uper']", "effects.tendon.a.bodies",
     "'upper'"),
    ("", "[effects.mimic]\nx = 1", "effects.mimic.x", "unknown key"),
    ("", "[start]\nq.elbw = 1", "start.q.elbw", "did you mean 'elbow'?"),
    ("", "[start]\np = 1", "start.p", "unknown key"),
    ("", "[start]\nq.elbow = [1, 2]", "start.q.elbow", "a list of 2"),
    ("", "[start]\nq.elbow = true", "start.q.elbow", "the boolean"),
    ("", "[effects.mimic]\n[start]\nq.rail = 1", "start.q.rail", "follows joint 'elbow'"),
    ("", "[outputs]\nrecord = ['q', 'q']", "outputs.record", "occurs twice"),
    ("", "[outputs]\nrecord = ['w']", "outputs.record", "no quantity"),
    ("", "[outputs]\nevery = 0", "outputs.every", "positive"),
    ("", "[outputs]\nevry = 1", "outputs.evry", "did you mean 'every'?"),
    ("", "[run]\nintegrator = 'euler'", "run.integrator", "did you mean"),
    ("", "[run]\nstep = -1", "run.step", "positive"),
    ("", "[run]\nduration = 1e-4", "run.step", "longer than the duration"),
    ("", "[run]\nduration = inf", "run.duration", "not finite"),
    ("", "[run]\ndt = 1", "run.dt", "unknown key"),
    ("", "[expect]\n'q' = { at = 1, value = 1, rtol = 1 }", "expect.q", "3 components"),
    ("", "[expect]\n'q.elbow' = 3", "expect.'q.elbow'", "wanted a table"),
    ("", "[expect]\nenergy = { value = 1, rtol = 1 }", "expect.energy.at", "missing"),
    ("", "[expect]\nenergy = { at = 1, rtol = 1 }", "expect.energy.value", "missing"),
    ("", "[expect]\nenergy = { at = 1, value = 1 }", "expect.energy.rtol", "a tolerance"),
    ("", "[expect]\nenergy = { at = 2, value = 1, rtol = 1 }", "expect.energy.at", "after the end"),
    ("", "[expect]\nenergy = { at = -1, value = 1, rtol = 1 }", "expect.energy.at", "0 or more"),
])
def test_errors_name_file_key_and_what_was_wanted(read, head, tail, where, words):
    with pytest.raises(SceneError) as caught:
        read(head, tail)
    assert caught.value.where == where
    assert words in str(caught.value) and "\n" not in str(caught.value)
    assert caught.value.file.endswith("arm.toml")


@pytest.mark.parametrize("old, new, where, words", [
    ("mass = 1.5", "mass = 0", "bodies.upper.mass", "positive"),
    ("mass = 1.5", "mas = 1.5", "bodies.upper.mas", "did you mean 'mass'?"),
    ("mass = 1.5\n", "", "bodies.upper.mass", "missing"),
    ('type = "continuous"', 'typ = "continuous"', "joints.elbow.typ", "did you mean 'type'?"),
    ("inertia = [0.1, 0.1, 0.01]", "inertia = 3", "bodies.upper.inertia",
     "the number 3; wanted a list of 3 or 6 numbers: xx, yy, zz, xy, xz, yz; or a symmetric"),
    ("inertia = [0.1, 0.1, 0.01]", "inertia = [[1, 0, 0], [0, 1, 0]]", "bodies.upper.inertia",
     "a list of 2 with lists in it; wanted a list of 3 or 6 numbers"),
    ("inertia = [0.1, 0.1, 0.01]", "inertia = [[1, 0, 0], [0, 1, 0], 1]", "bodies.upper.inertia",
     "a list of 3 with lists in it"),
    ("inertia = [0.1, 0.1, 0.01]",
     "inertia = [[1, 0, 0.1], [0, 1, 0], [0.10000000000000001, 0, 1]]",
     "bodies.upper.inertia", "xz is 0.1"),
    ("inertia = [0.1, 0.1, 0.01]", "inertia = [1, 2]", "bodies.upper.inertia", "a list of 2"),
    ("inertia = [0.1, 0.1, 0.01]", "inertia = [1, 1, 2.1]", "body 'upper'", "the sum of the other"),
    ("inertia = [0.1, 0.1, 0.01]", "inertia = [1, 1, -1]", "body 'upper'", "positive definite"),
    ("[bodies.slide]", "[bodies.world]", "bodies.world", "another"),
    ('child = "tool"', 'child = "tol"', "joint 'elbow'", "did you mean 'tool'?"),
    ('child = "tool"', 'child = "upper"', "joint 'elbow'", "same body"),
    ('child = "slide"', 'child = "upper"', "body 'upper'", "two joints, 'shoulder' and 'rail'"),
    ('parent = "upper"', 'parent = "slide"', "joint 'elbow'", "loop"),
    ('type = "continuous"', 'type = "hinge"', "joints.elbow.type", "did you mean 'revolute'?"),
    ('type = "continuous"', 'type = "floating"', "joints.elbow.type", "did you mean 'free'?"),
    ('type = "continuous"', 'type = "slider"', "joints.elbow.type", "did you mean 'prismatic'?"),
    ('type = "continuous"', 'type = "weld"', "joints.elbow.type", "did you mean 'fixed'?"),
    ('type = "continuous"', 'type = "ball"', "joints.elbow.type", "did you mean 'spherical'?"),
    ('type = "continuous"', 'type = "spherical"', "joints.elbow.axis", "'elbow' is spherical"),
    ("axis = [1, 0, 0]", "axis = [0, 0, 0]", "joints.elbow.axis", "is zero"),
    ("axis = [1, 0, 0]\n", "", "joints.elbow.axis", "missing"),
    ("lower = -1", "lower = 3", "joints.shoulder.limits.lower", "above upper"),
    ("effort = 8", "effort = -8", "joints.shoulder.limits.effort", "0 or more"),
    ("damping = 0.5", "damping = -0.5", "joints.shoulder.damping", "0 or more"),
    ('joint = "elbow"', 'joint = "elbo"', "joint 'rail'", "did you mean 'elbow'?"),
    ('joint = "elbow"', 'joint = "rail"', "joint 'rail'", "mimics itself"),
    ("rpy = [1.57079632679, 0, 0]", "quaternion = [0.9, 0, 0, 0]", "joints.elbow.origin.quaternion",
     "norm 0.9; wanted 1"),
    ("rpy = [1.57079632679, 0, 0]", "quaternion = [1, 1, 0, 0]", "joints.elbow.origin.quaternion",
     "norm 1.41421356"),
    ("rpy = [1.57079632679, 0, 0]", "angle = 1", "joints.elbow.origin.axis", "missing"),
    ("rpy = [1.57079632679, 0, 0]", "rpy = [0, 0, 0], axis = [0, 0, 1], angle = 1",
     "joints.elbow.origin.axis", "given by rpy already"),
    ("mass = 0.2", "", "joint 'rail' of model 'arm'", "nor what moves on that has a mass"),
])
def test_errors_of_models_name_their_element(read, old, new, where, words):
    assert old in MODEL
    with pytest.raises(SceneError) as caught:
        read(model=MODEL.replace(old, new, 1))
    assert caught.value.where == where
    assert words in str(caught.value)


def test_an_orphan_is_named(read):
    with pytest.raises(SceneError, match="body 'lost': no joint moves it"):
        read(tail="[bodies.lost]\nmass = 1\n")


def test_a_point_on_its_own_axis_resists_nothing(read):
    model = """
[bodies.bead]
mass = 1
com = [0, 0, 1]
[joints.pin]
type = "revolute"
child = "bead"
axis = [0, 0, 1]
"""
    with pytest.raises(SceneError, match="no inertia against its motion"):
        read(model=model)
    assert read(model=model, tail="[effects.rotor.pin]\ninertia = 1").effects
    assert read(model=model.replace("axis = [0, 0, 1]", "axis = [0, 1, 0]"))
    with pytest.raises(SceneError, match="no inertia against its motion"):
        read(model=model.replace("[0, 0, 1]", "[-0.48, 0.6, 0.64]"))


def test_without_a_joint_that_moves_there_is_no_scene(read):
    body = "[bodies.brick]\nmass = 1\ninertia = [1, 1, 1]\n"
    with pytest.raises(SceneError, match='base = "free"'):
        read(model=body)
    assert read('base = "free"\n', model=body).model.joints[0].kind is Kind.FREE


def test_reading_twice_gives_the_same(read):
    text = '[effects.viscous]\njoints = "all"\nd = "model"\n[effects.gravity]\n'
    assert read(tail=text) == read(tail=text)


@pytest.mark.parametrize("text, words", [
    ("[joints\n", "Expected ']' at the end of a table declaration (at line 1, column 8); wanted"),
    ("a = 1\n" * 2, "Cannot overwrite a value (at line 2, column 6); wanted a TOML file"),
    (f"[{'k' * 2000}]\n" * 2, "(at line 2, column 2002); wanted a TOML file")])
def test_what_is_no_toml_is_told_with_line_and_column(read, text, words):
    with pytest.raises(SceneError) as caught:
        read(model=text)
    assert words in str(caught.value) and len(caught.value.problem) < 350


@pytest.mark.parametrize("came, known, near", [
    ("elbw", ("elbow", "shoulder"), "elbow"), ("Elbow", ("elbow", "shoulder"), "elbow"),
    ("foo", ("coulomb", "drag", "gravity", "viscous"), None),
    ("half", ("both", "double", "single"), None), ("omega", ("max", "min"), None),
    ("heaviside", ("abs", "cos", "sin", "t"), None),
    ("euler", ("rk4", "semi-implicit-euler", "linear-implicit-euler"), "semi-implicit-euler"),
    ("floating", ("continuous", "fixed", "free"), "free"), ("free", ("fixed", "floating"),
                                                             "floating"),
    ("weld", ("revolute", "fixed"), "fixed"), ("hinge", ("hinge1", "elbow"), "hinge1"),
    ("dd", ("d", "joints"), "d"), ("x", (), None)])
def test_suggestions_are_alike(came, known, near):
    assert nearest(came, known) == near
    assert (f"did you mean {near!r}?" == did_you_mean(came, known)) == (near is not None)


def test_without_likeness_what_there_is_is_listed():
    assert did_you_mean("foo", ("viscous", "drag")) == "wanted one of drag, viscous"
    many = tuple(f"joint{i}" for i in range(21))
    assert did_you_mean("xyz", many) == "none of the 21 there are is like it"
    assert did_you_mean("xyz", ()) == "there are none"


def test_numbers_may_be_constant_formulas(read):
    """Rational ones exactly, others to 50 digits; right angles are right."""
    model = MODEL.replace("rpy = [1.57079632679, 0, 0]", 'rpy = ["pi/2", 0, 0]').replace(
        "lower = -1", 'lower = "-0.1*3"')
    scene = read(model=model, tail='[effects.viscous.elbow]\nd = "1/3"\n[start.q]\n'
                                   'shoulder = "pi/2"\nelbow = ["sin(pi)"]\n')
    shoulder, elbow, _ = scene.model.joints
    assert shoulder.lower == F(-3, 10)
    assert elbow.placement.R == (1, 0, 0, 0, 0, -1, 0, 1, 0)
    assert applied(scene, "viscous")["elbow", ""]["d"] == F(1, 3)
    assert scene.start_q == {"shoulder": (math.pi / 2,), "elbow": (0.0,)}
    assert 0 < abs(constant("sqrt(0.5)")**2 - F(1, 2)) < F(1, 10**49)
    assert constant("sqrt(2)**2 - 2") == 0
