"""MJCF files: the model and the effects that they declare move as MuJoCo's; what no scene can have
is refused by name, or left out."""

from dataclasses import replace

import mujoco
import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.__main__ import main
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides, read_scene
from tests.support.scenes.kinds import Kind
from tests.support.scenes.mujoco_pairs import compared

ROBOT = """<mujoco><compiler angle="radian"/><option gravity="0.3 0 -9.5"/>
<default><joint damping="0.2" armature="0.03"/><geom density="800"/></default><worldbody>
<body name="trunk" pos="0 0 0.7" quat="0.9 0.1 0.2 0.3"><FREE/>
  <geom type="box" size="0.1 0.2 0.05" pos="0.02 0 0.01" euler="0.1 0.2 0.3"/>
<body name="hip" pos="0.1 0.2 0"><geom type="capsule" size="0.03" fromto="0 0 0 0.1 0 -0.2"/>
  <joint name="roll" axis="1 0 0" pos="0 0.01 0.02"/>
  <joint name="pitch" axis="0 1 0.5" ref="0.4" stiffness="5" springref="0.1" range="-1 2"
    frictionloss="0.3" limited="true" pos="0.02 0 0"/>
  <joint name="reach" type="slide" axis="0 0.6 -0.8" ref="-0.2" armature="0.5"/>
<body name="foot" pos="0 0 -0.3" euler="0.3 0.2 0.1" gravcomp="0.5">
  <geom type="sphere" size="0.05" pos="0.01 0.02 0.03"/>
  <joint name="ankle" type="ball" pos="0.01 0 0.02" stiffness="4" springref="0"/>
<body name="toe" pos="0.1 0 0"><geom type="ellipsoid" size="0.03 0.02 0.01"/>
  <joint name="bend" axis="0 1 0" pos="0 0 0.01"/></body></body></body>
<body name="tail" pos="-0.2 0 0"><geom type="cylinder" size="0.02 0.1"/>
  <joint name="swing" axis="0 0 1" ref="0.3"/>
<body name="tip" pos="-0.2 0 0"><geom type="sphere" size="0.02"/><joint name="wag" axis="0 0 1"
  ref="0.1"/></body></body>
</body></worldbody>MORE</mujoco>"""
FREE = ROBOT.replace("<FREE/>", '<joint name="root" type="free" damping="0.7" armature="0.4" '
                     'stiffness="9"/>')
FOLLOWS = '<equality><joint joint1="wag" joint2="swing" polycoef="0.2 -1.5 0 0 0"/></equality>'


@pytest.fixture
def read(tmp_path):
    def read(text=FREE, more="", name="robot.xml", scene="", **overrides):
        path = tmp_path / name
        path.write_text(text.replace("MORE", more))
        if scene:
            path = tmp_path / "scene.toml"
            path.write_text(f'model = "{name}"\n{scene}')
        return read_scene(path, overrides=SceneOverrides(**overrides))

    return read


@pytest.mark.parametrize("text", (FREE, ROBOT.replace("<FREE/>", "")), ids=("free", "fixed"))
@pytest.mark.parametrize("more", ("", FOLLOWS), ids=("", "follower"))
def test_it_moves_as_mujocos(read, tmp_path, text, more):
    """Free, ball, hinges and a slide on one body, anchors, ref, springs, armature, gravcomp; q is
    qpos.  Ten states; the bound is some hundred roundings of both programs."""
    scene = read(text, more)
    theirs = mujoco.MjModel.from_xml_path(str(tmp_path / "robot.xml"))
    worst = compared(scene, theirs)
    assert max(worst.mass_matrix, worst.bias, worst.torques) < 2e-13, worst
    assert bool(more) == ("mimic" in {x.effect.name for x in scene.effects})


def test_what_the_file_says_is_in_the_model(read):
    scene = read()
    joints = {x.name: x for x in scene.model.joints}
    assert [x.kind for x in scene.model.joints if x.kind is not Kind.FIXED] == [
        Kind.FREE, Kind.REVOLUTE, Kind.REVOLUTE, Kind.PRISMATIC, Kind.SPHERICAL, Kind.REVOLUTE,
        Kind.REVOLUTE, Kind.REVOLUTE]
    pitch = joints["pitch"]
    assert [float(x) for x in (pitch.lower, pitch.upper, pitch.friction, pitch.damping)] == [
        -1, 2, 0.3, 0.2]
    assert {"gravity", "viscous.roll", "armature.reach", "spring.pitch",
            "wrench.gravcomp of foot"} <= {x.name for x in scene.effects}
    assert any(x.startswith("joint pitch: friction 0.3 N m is not used") for x in scene.unused)
    assert any(x.endswith("geoms may touch others in MuJoCo, and nothing here: add "
                          "[effects.contact] with mu") for x in scene.unused)


def test_bodies_and_joints_may_have_one_name_or_none(read):
    """Names that the file does not give get a _ if they are taken."""
    text = """<mujoco><worldbody><body name="arm"><joint name="arm" pos="0.1 0 0"/>
<geom size="0.1"/><body name="arm/arm"><joint/><geom size="0.1"/><body>
<joint name="joint1" axis="0 1 0"/>
<geom size="0.1"/></body></body></body></worldbody></mujoco>"""
    model = read(text).model
    assert [x.name for x in model.joints] == ["arm", "arm/fixed", "joint1_", "joint1"]
    assert [x.name for x in model.bodies] == ["arm/arm_", "arm", "arm/arm", "body3"]


def test_it_starts_where_mujoco_does(read, tmp_path):
    scene = read()
    theirs = mujoco.MjModel.from_xml_path(str(tmp_path / "robot.xml"))
    q0 = theirs.qpos0
    assert np.abs(np.array(scene.start_q["root"]) - [*q0[:3], *q0[4:7], q0[3]]).max() < 1e-15
    assert (scene.start_q["pitch"], scene.start_q["swing"]) == ((0.4,), (0.3,))


def test_a_scene_chooses_its_effects(read):
    """Effects that the file declares are reported with the text to write, until the scene has it.
    """
    messages = read(scene="[effects.gravity]\n").unused
    assert "joint pitch: spring of the model's file is not used: add [effects.spring.pitch] with " \
           "k = 5.0 and q0 = 0.1" in messages
    written = read(scene="[effects.gravity]\n[effects.spring.pitch]\nk = 2\n").unused
    assert not any("joint pitch: spring of the model's file" in x for x in written)


UNKEPT = {
    "tendons": ('<tendon><fixed name="t" stiffness="3" springlength="0 1"><joint joint="wag" '
                'coef="1"/></fixed></tendon>', "tendon 't'"),
    "actuators  ": ('<actuator><intvelocity name="i" joint="wag" kp="1" actrange="-1 1"/>'
                    "</actuator>", "actuator i"),
    "polynomials  ": ('<tendon><fixed name="t" damping="3 1"><joint joint="wag" coef="1"/></fixed>'
                      "</tendon>", "damping or stiffness of tendon 't'"),
    "actuators": ('<actuator><motor name="m" joint="ankle" armature="2"/></actuator>',
                  "actuator 'm'"),
    "polynomials   ": ('<actuator><motor name="m" joint="wag" damping="2 1"/></actuator>',
                       "damping of actuator 'm'"),
    "fluid": ('<option density="1.2" wind="1 0 0"/>', "option density"),
    "fluid ": ('<option density="1.2" viscosity="1"/>', "option density and viscosity")}
SITES = '<site name="x"/><site name="y" pos="0 0 1"/><joint name="wag"'
PATH = '<tendon><spatial name="s" {}><site site="x"/><site site="y"/><site site="z"/></spatial>' \
    "</tendon>"
IN_JOINTS = {
    "tendons  ": (PATH.format('damping="1"'), '<joint name="wag"', SITES.replace(
        "<joint", '<site name="z"/><joint'), "tendon 's'"),
    "equalities": (PATH.format("") + '<equality><tendon name="e" tendon1="s"/></equality>',
                   '<joint name="wag"', SITES.replace("<joint", '<site name="z"/><joint'),
                   "equality tendon 'e'"),
    "polynomials": ("", 'name="wag"', 'name="wag" damping="1 2"',
                    "damping or stiffness of joint 'wag'")}


@pytest.mark.parametrize(("group", "more", "old", "new", "element"), (
    *((x.strip(), y[0], "a", "a", y[1]) for x, y in UNKEPT.items()),
    *((x.strip(), *y) for x, y in IN_JOINTS.items())))
def test_what_no_scene_has_is_refused_or_left_out(read, group, more, old, new, element):
    text = FREE.replace(old, new)
    with pytest.raises(SceneError) as caught:
        read(text, more)
    assert f"robot.xml: {element}: " in str(caught.value)
    assert str(caught.value).endswith(f'leave_out = ["{group}"] in the scene, or --leave-out '
                                      f"{group}, leaves it out")
    messages = read(text, more, leave_out=(group,)).unused
    assert f"{element}: left out ({group})" in messages
    scene = read(text, more, scene=f'leave_out = ["{group}"]\n[effects.gravity]\n')
    assert f"{element}: left out ({group})" in scene.unused


def test_an_unnamed_free_joint_has_the_name_of_its_body(read):
    """The name is that of `base = "free"` for other models; named joints keep theirs."""
    text = ROBOT.replace("<FREE/>", "<freejoint/>").replace('name="wag"', "")
    assert [x.name for x in read(text).model.joints if x.kind.moves] == [
        "trunk", "roll", "pitch", "reach", "ankle", "bend", "swing", "joint7"]
    names = [x.name for x in read(text.replace('"roll"', '"trunk"')).model.joints if x.kind.moves]
    assert names[:2] == ["trunk_", "trunk"]


def test_wind_without_a_fluid_pushes_nothing(read):
    """Wind makes no passive forces in MuJoCo without a density or viscosity."""
    text = FREE.replace("<worldbody>", '<option wind="30 0 0"/><worldbody>', 1)
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    assert model.opt.wind[0] == 30 and not data.qfrc_fluid.any()
    assert "option wind: pushes nothing, in MuJoCo either, without density or viscosity of a " \
           "fluid, and is not used" in read(text).unused


DRIVES = """<tendon><fixed name="both"><joint joint="roll" coef="0.5"/><joint joint="reach"
coef="-2"/></fixed></tendon><actuator>
<motor name="m" joint="roll" gear="50" forcerange="-2 2" forcelimited="true"/>
<position name="p" joint="wag" kp="7" kv="0.5" gear="2"/>
<velocity name="swing" joint="swing" kv="3"/>
<general name="limit" joint="bend" gear="3" gainprm="4" biastype="affine" biasprm="1 -2 -3"
  ctrlrange="0.5 2" ctrllimited="true"/>
<position name="cable" tendon="both" kp="20" forcerange="-5 5" forcelimited="true"/></actuator>"""
IDLE = """<actuator><general name="x" joint="bend" dyntype="filter" dynprm="0.1"/>
<damper name="d" joint="wag" kv="2" ctrlrange="0 1"/><motor name="b" joint="ankle"/></actuator>"""


def test_actuators_act_if_the_file_is_alone(read):
    scene = read(more=DRIVES)
    own = {x.name: x for x in scene.effects if x.effect.name == "actuator"}
    assert {name: [(x.joint, float(x.weight)) for x in y.terms] for name, y in own.items()} == {
        "actuator.m": [("roll", 50)], "actuator.p": [("wag", 2)], "actuator.swing": [],
        "actuator.limit_": [("bend", 3)], "actuator.cable": [("roll", 0.5), ("reach", -2)]}
    assert [(x.name, float(x.value)) for x in scene.parameters] == [
        ("actuator.m.torque", 0), ("actuator.p.target", 0), ("actuator.swing.target_v", 0),
        ("actuator.limit_.torque", 3), ("actuator.cable.target", 0)]
    assert "actuator limit: torque = 4 ctrl + 1" in scene.unused


def test_their_torques_are_mujocos(read, tmp_path):
    """The difference that they make is qfrc_actuator, also where it saturates."""
    scene = read(more=DRIVES)
    others = tuple(x for x in scene.effects if x.effect.name != "actuator")
    driven, passive = (load_scene(x, functions=["inverse_dynamics"]) for x in (
        scene, replace(scene, effects=others, parameters=())))
    theirs = mujoco.MjModel.from_xml_path(str(tmp_path / "robot.xml"))
    data, rng, saturated = mujoco.MjData(theirs), np.random.default_rng(2), 0
    parts = driven.interface.coordinates
    for _ in range(10):
        data.qpos[:], data.qvel[:] = rng.normal(size=theirs.nq), rng.normal(size=theirs.nv)
        ctrl = rng.normal(size=theirs.nu) + [1, 0, 0, 1, 0]
        data.ctrl[:] = ctrl
        mujoco.mj_forward(theirs, data)
        p = [*ctrl[:3], 4 * np.clip(ctrl[3], 0.5, 2) + 1, ctrl[4]]
        q, v = np.array(driven.neutral_q), np.zeros(driven.NV)
        for c in parts:
            if len(c.q) == 1:
                q[c.q.start] = data.qpos[theirs.joint(c.joint).qposadr[0]]
                v[c.v.start] = data.qvel[theirs.joint(c.joint).dofadr[0]]
        a = np.zeros_like(v)
        mine = passive.double.inverse_dynamics(q, v, a) - driven.double.inverse_dynamics(p, q, v, a)
        wanted = np.zeros_like(v)
        for c in parts:
            wanted[c.v.start:c.v.stop] = data.qfrc_actuator[
                theirs.joint(c.joint).dofadr[0]:][:len(c.v)]
        assert np.abs(mine - wanted).max() < 1e-13 * max(np.abs(wanted).max(), 100)
        saturated += abs(data.actuator_force[0]) == 2
    assert 0 < saturated < 10


def test_ranges_of_ctrl_limit_motors_and_are_told_of_others(read, tmp_path):
    """A motor's, the same in both directions, limits its force: the smaller of both limits counts.
    """
    scene = read(more="""<actuator><motor name="a" joint="roll" gear="50" ctrlrange="-0.5 0.5"/>
<motor name="b" joint="wag" ctrlrange="-3 3" forcerange="-2 2"/>
<motor name="c" joint="bend" ctrlrange="-1 2"/>
<position name="d" joint="swing" kp="7" ctrlrange="-1 1"/></actuator>""")
    limits = {x.name: x.values.get("limit") for x in scene.effects if x.effect.name == "actuator"}
    assert limits == {"actuator.a": 0.5, "actuator.wag": 2, "actuator.bend": None,
                      "actuator.swing": None}
    held = "actuator {}: ctrl is held between -1 and {} in MuJoCo, and not here"
    assert [x for x in scene.unused if "ctrl" in x] == [held.format("c", 2), held.format("d", 1)]
    kernels = load_scene(scene, functions=["inverse_dynamics"])
    theirs = mujoco.MjModel.from_xml_path(str(tmp_path / "robot.xml"))
    data, q = mujoco.MjData(theirs), np.array(kernels.neutral_q)
    mujoco.mj_forward(theirs, data)
    zero = np.zeros(kernels.NV)
    places = {c.joint: c.v.start for c in kernels.interface.coordinates}
    for ctrl in (0.1, -0.2, 1.0, -5.0):
        data.ctrl[:2] = ctrl
        mujoco.mj_fwdActuation(theirs, data)
        mine = kernels.double.inverse_dynamics([0, 0, 0, 0], q, zero, zero) \
            - kernels.double.inverse_dynamics([ctrl, ctrl, 0, 0], q, zero, zero)
        for joint in ("roll", "wag"):
            wanted = data.qfrc_actuator[theirs.joint(joint).dofadr[0]]
            assert mine[places[joint]] == pytest.approx(wanted, abs=1e-12)


def test_warnings_of_mujoco_are_notices_and_no_file(read, tmp_path, monkeypatch, capfd):
    """Each once; MuJoCo warns as before afterwards."""
    monkeypatch.chdir(tmp_path)
    before, texts = mujoco.get_mju_user_warning(), []
    mujoco.set_mju_user_warning(texts.append)
    try:
        scene = read(FREE.replace(
            ">", '><compiler settotalmass="3"/>', 1))
        assert mujoco.get_mju_user_warning() == texts.append
    finally:
        mujoco.set_mju_user_warning(before)
    (notice,) = (x for x in scene.unused if "MuJoCo warns" in x)
    assert "'settotalmass' is deprecated" in notice
    assert not texts and not (tmp_path / "MUJOCO_LOG.TXT").exists()
    assert "deprecated" not in "".join(capfd.readouterr())


def test_a_scene_is_told_what_drives_to_write(read):
    notices = [x for x in read(more=DRIVES, scene="[effects.gravity]").unused if "actuator of" in x]
    assert notices[0] == (
        "effect m: actuator of the model's file is not used: add [effects.actuator.m] with joints "
        '= { roll = 50.0 }, kind = "torque", torque = 0 and limit = 2.0')
    assert "add [effects.actuator.swing] with kind" in notices[2] and len(notices) == 5


def test_actuators_that_exert_nothing_by_themselves_are_reported(read):
    """A filter, a damper whose control multiplies, a motor on a ball; a servo with a state of its
    own is refused."""
    messages = read(more=IDLE).unused
    for name in "xdb":
        assert f"actuator {name}: is not used, and no effect does the same" in messages
    off = DRIVES.replace("<tendon>", '<option><flag actuation="disable"/></option><tendon>')
    assert "actuator p: is switched off in MuJoCo" in read(more=off).unused


CABLES = """<tendon><spatial name="s" stiffness="300" damping="2" springlength="0.1" range="0 1"
limited="true" frictionloss="0.1"><site site="x"/><site site="z"/></spatial><spatial name="w"
damping="3"><site site="z"/><site site="world"/></spatial><spatial name="rigid" stiffness="3"><site
site="x"/><site site="y"/></spatial></tendon>"""


def test_tendons_between_two_sites_are_springs_and_dampers(read, tmp_path):
    text = ROBOT.replace("<FREE/>", "").replace('<joint name="wag"', SITES).replace(
        '<joint name="swing"', '<site name="z" pos="0.1 0.2 0.3"/><joint name="swing"').replace(
        "<worldbody>", '<worldbody><site name="world" pos="1 2 3"/>')
    scene = read(text, CABLES)
    assert [x.name for x in scene.effects if x.effect.pair_force] == [
        "spring_damper.s", "spring_damper.w"]
    worst = compared(scene, mujoco.MjModel.from_xml_path(str(tmp_path / "robot.xml")))
    assert max(worst.mass_matrix, worst.bias, worst.torques) < 2e-13, worst
    for what in ("friction", "range"):
        assert f"tendon s: its {what} is used by no effect" in scene.unused


ROTORS = """<tendon><fixed name="t" armature="0.4"><joint joint="roll" coef="0.7"/><joint
joint="reach" coef="-2"/></fixed></tendon><actuator><motor joint="wag" gear="3" armature="0.2"
damping="0.5"/><motor name="t" tendon="t" gear="2" armature="0.1" damping="0.6"/></actuator>"""


def test_armature_of_tendons_and_actuators_is_inertia_of_sums(read, tmp_path):
    """The joints are in one chain: MuJoCo's mass matrix has no place for terms of two branches."""
    scene = read(more=ROTORS)
    assert {"armature.t", "armature.rotor of t", "viscous.rotor of actuator0"} <= {
        x.name for x in scene.effects}
    worst = compared(scene, mujoco.MjModel.from_xml_path(str(tmp_path / "robot.xml")))
    assert max(worst.mass_matrix, worst.bias, worst.torques) < 2e-13, worst


def test_tendons_act_on_sums_of_coordinates(read, tmp_path):
    """Spring and damper as MuJoCo's; its friction and range are told."""
    more = """<tendon><fixed name="t" stiffness="30" damping="2" springlength="0.4" range="-1 2"
limited="true" frictionloss="0.5"><joint joint="roll" coef="0.7"/><joint joint="reach" coef="-2"/>
</fixed></tendon>"""
    scene = read(more=more)
    assert {"spring.t", "viscous.t"} <= {x.name for x in scene.effects}
    worst = compared(scene, mujoco.MjModel.from_xml_path(str(tmp_path / "robot.xml")))
    assert max(worst.mass_matrix, worst.bias, worst.torques) < 2e-13, worst
    joints = "joints = { roll = 0.7, reach = -2.0 }"
    assert ("effect t: coulomb of the model's file is not used: add [effects.coulomb.t] with "
            f"{joints}, tau_c = 0.5 and eps = 0.01") in scene.unused
    assert ("effect t: limit of the model's file is not used: add [effects.limit.t] with "
            f"{joints}, lower = -1.0, upper = 2.0 and k = 1e4") in scene.unused


@pytest.mark.parametrize(("text", "words"), (
    ("<mujoco><worldbody><body/></worldbody></mujoco>", "has no joint that moves"),
    ("<mujoco><worldbody><bod/></worldbody></mujoco>", "robot.xml: MuJoCo says: XML Error: Sch"),
    ("<mujoco", "robot.xml: MuJoCo says: "), ("<robot/>", "is a URDF with another suffix; rename "
                                                          "it to robot.urdf"),
    ("<sdf/>", "is SDF, the format of Gazebo; wanted a name that ends in .sdf"),
    ("<part/>", "the root is <part>; wanted <mujoco>, or another suffix"),
    ("text", "the root is <>; wanted <mujoco>")))
def test_errors_are_told_on_one_line(read, text, words):
    with pytest.raises(SceneError, match="robot.xml: ") as caught:
        read(text)
    assert words in str(caught.value) and "\n" not in str(caught.value)


def test_leave_out_is_for_what_it_names(read, tmp_path, capsys):
    with pytest.raises(SceneError, match="leave_out: 'tendon'; did you mean 'tendons'?"):
        read(leave_out=("tendon",))
    (tmp_path / "a.urdf").write_text("<robot/>")
    with pytest.raises(SceneError, match="leave_out: 'tendons'; URDF has nothing to leave out"):
        read_scene(tmp_path / "a.urdf", overrides=SceneOverrides(leave_out=("tendons",)))
    read(more=UNKEPT["tendons"][0], leave_out=("tendons",))
    words = ["generate", str(tmp_path / "robot.xml"), "--functions", "energy", "--leave-out",
             "tendons", "-o", str(tmp_path / "out")]
    assert main(words) == 0, capsys.readouterr().err
    assert main([*words[:4], *words[-2:]]) == 2
    assert "--leave-out tendons, leaves it out" in capsys.readouterr().err


def test_shapes_and_keyframes_are_reported_until_a_scene_takes_them(read):
    """A scene with contact says nothing of shapes."""
    text = """<mujoco><worldbody><body name="b" pos="0 0 1"><freejoint name="f"/><geom size="0.1"/>
</body></worldbody><keyframe><key name="home" qpos="0 0 2 1 0 0 0"/><key/></keyframe></mujoco>"""
    lines = read(text, scene="[effects.gravity]\n").unused
    assert ("1 geom may touch others in MuJoCo, and nothing here: add [effects.contact] with mu"
            in lines)
    assert "keyframes home, 1: not used; [start.q] of a scene sets a start" in lines
    lines = read(text, scene="[effects.gravity]\n[effects.contact]\nmu = 0.5\n").unused
    assert [x for x in lines if "key" not in x] == []
