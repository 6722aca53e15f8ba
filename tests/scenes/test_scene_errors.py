"""An error in a scene file is one clear message: file, key, the value that came, the value wanted.
"""

import math
from fractions import Fraction as F

import pytest

from coscrew_codegen.scene.constants import LENGTH, constant
from coscrew_codegen.scene.formulas import FormulaError
from coscrew_codegen.scene.mechanism.inertia_checks import why_singular
from coscrew_codegen.scene.names import did_you_mean, nearest
from coscrew_codegen.scene.readers.scene_error import SceneError
from tests.support.scenes.kinds import Kind
from tests.support.scenes.reading import MODEL, applied


@pytest.mark.parametrize("head, tail, where, words", [
    ('percision = "double"\n', "", "percision", "did you mean 'precision'?"),
    ('precision = "half"\n', "", "precision", "wanted one of double, single, both"),
    ("precision = 64\n", "", "precision", "the number 64; wanted text"),
    ('base = "floating"\n', "", "base", "wanted one of fixed, free"),
    ('base = "free"\n', "", "base", "the root is the world"),
    ('name = "6dof"\n', "", "name", "scene_6dof"), ('name = "while"\n', "", "name", "word of C"),
    ('name = "math"\n', "", "name", "scene_math"),
    ('name = ""\n', "", "name", "identifier"), ('name = true\n', "", "name", "the boolean true"),
    ('model = "arm.urdf"\n', "", "model", "there is no such file"),
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
    ("", "[effects.viscous.all]\nd = 1", "effects.viscous.all",
     "no joint 'all'; wanted joints = \"all\" or a list of names in [effects.viscous] itself"),
    ("", "[effects.viscous.two]\njoints = ['elbow', 'rail']\nd = 1", "effects.viscous.two",
     "or a list of names in [effects.viscous] itself"),
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
    ("", "[effects.viscous]\njoints = 'all'\nd = '2'", "effects.viscous.d",
     "the text '2'; wanted a number without quotes, a constant formula, or \"model\""),
    ("", "[effects.viscous]\njoints = 'all'\nd = 'modle'", "effects.viscous.d", "or \"model\""),
    ("", "[effects.viscous]\njoints = 'all'\nd = -1", "effects.viscous.d", "wanted 0 or more"),
    ("", "[effects.viscous]\njoints = 'all'\nd = 1e999", "effects.viscous.d", "out of range"),
    ("", "[effects.viscous]\njoints = 'all'\nd = 1979-05-27", "effects.viscous.d", "the time"),
    ("", "[effects.viscous.elbow]\nd = 1\n[effects.viscous]\njoints = ['elbow']\nd = 1",
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
    ("", "[effects.motor.elbow]\nu = '-0.5'", "effects.motor.elbow.u",
     "the text '-0.5'; wanted the number, without quotes"),
    ("", "[start]\nq.elbow = ' +1e-3 '", "start.q.elbow", "wanted the number, without quotes"),
    ("", "[start]\nq.elbow = '(2)'", "start.q.elbow", "wanted the number, without quotes"),
    ("", "[start]\nq.elbow = '0x10'", "start.q.elbow", "unexpected"),
    ("", "[run]\nstep = '1e-3'", "run.step", "the text '1e-3'; wanted the number, without quotes"),
    ("", "[effects.gravity]\ng = [0, 0, '-9.81']", "effects.gravity.g", "without quotes"),
    ("", "[effects.push.tool]\nforce = [0, 0, '3']", "effects.push.tool.force", "without quotes"),
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
    ("", "[effects.tendon.a]\nbodies = ['world', 'tool']\n", "effects.tendon.a.k",
     "missing; wanted k or d"),
    ("", "[effects.mimic]\nx = 1", "effects.mimic.x", "unknown key"),
    ("", "[start]\nq.elbw = 1", "start.q.elbw", "did you mean 'elbow'?"),
    ("", "[start]\np = 1", "start.p", "unknown key"),
    ("", "[start]\nq.elbow = [1, 2]", "start.q.elbow", "a list of 2"),
    ("", "[start]\nq.elbow = true", "start.q.elbow", "the boolean"),
    ("", "[effects.mimic]\n[start]\nq.rail = 1", "start.q.rail", "follows joint 'elbow'"),
    ("", "[outputs]\nrecord = ['q', 'q']", "outputs.record", "occurs twice"),
    ("", "[outputs]\nrecord = []", "outputs.record", "an empty list; wanted quantities"),
    ("", "[effects.stop.elbow]\nlower = 2\nupper = 1", "effects.stop.elbow.lower",
     "2 is above upper, 1"),
    ("", "[outputs]\nrecord = ['w']", "outputs.record", "no quantity"),
    ("", "[outputs]\nevery = 0", "outputs.every", "positive"),
    ("", "[outputs]\nevry = 1", "outputs.evry", "did you mean 'every'?"),
    ("", "[run]\nintegrator = 'euler'", "run.integrator", "did you mean"),
    ("", "[run]\nstep = -1", "run.step", "positive"),
    ("", "[run]\nduration = 1e-4", "run.step", "longer than the duration"),
    ("", "[run]\nduration = inf", "run.duration", "not finite"),
    ("", "[run]\ndt = 1", "run.dt", "unknown key"),
    ("", '[run]\nrecord = ["q"]', "run.record", "unknown key; [outputs] has it"),
    ("", "[outputs]\nduration = 1", "outputs.duration", "unknown key; [run] has it"),
    ("", "[expect]\nq.elbow = { at = 1, value = 1, rtol = 1 }", "expect.q",
     '; keys with a dot take quotes: "q.elbow" = …'),
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


def test_an_effect_that_lets_nothing_follow_is_refused(read):
    follows = 'mimic = { joint = "elbow", multiplier = 0.5, offset = 0.125 }\n'
    assert follows in MODEL
    with pytest.raises(SceneError, match="no joint of the model follows another"):
        read(model=MODEL.replace(follows, ""), tail="[effects.mimic]\n")


@pytest.mark.parametrize("old, new, where, words", [
    ("mass = 1.5", "mass = 0", "bodies.upper.mass", "positive"),
    ("mass = 1.5", "mass = '1.5'", "bodies.upper.mass",
     "the text '1.5'; wanted the number, without quotes"),
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
    assert "what joint 'pin' moves has no inertia" in why_singular(read(model=model))
    assert not why_singular(read(model=model, tail="[effects.rotor.pin]\ninertia = 1"))
    assert not why_singular(read(model=model.replace("axis = [0, 0, 1]", "axis = [0, 1, 0]")))
    assert why_singular(read(model=model.replace("[0, 0, 1]", "[-0.48, 0.6, 0.64]")))


def test_a_joint_that_moves_no_mass_is_named(read):
    model = MODEL.replace("mass = 0.2", "")
    assert "joint 'rail' moves nothing that has a mass" in why_singular(read(model=model))


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


def test_constants_have_at_most_a_hundred_characters():
    longest = "1" * 48 + "+" + "2" * (LENGTH - 49)
    assert len(longest) == LENGTH == 100
    assert constant(longest) == int("1" * 48) + int("2" * 51)
    with pytest.raises(FormulaError, match="^formula of 101 characters; wanted at most 100$"):
        constant(f"{longest} ")
