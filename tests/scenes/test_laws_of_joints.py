"""Laws of joints as closed loops: a sum of coordinates is a polynomial of another.

Truth is in closed form, in the rows of MuJoCo's equalities, and in followers."""

import mpmath
import mujoco
import numpy as np
import pytest

from coscrew_codegen import load_scene, run
from coscrew_codegen.__main__ import main
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides, read_scene
from tests.support.scenes.closed_loops import CAM, J, M


@pytest.fixture
def cam(tmp_path):
    path = tmp_path / "cam.toml"
    path.write_text(CAM)
    return path


def test_a_cam_moves_by_its_closed_form(cam):
    """(J + m P'²) a = τ + P' (f - m P'' v²); the law pushes the valve by m x'' - f."""
    ours = load_scene(cam, functions=["forward_dynamics", "closing_follow", "closure"]).double
    rng = np.random.default_rng(1)
    for q, v, torque, force in rng.normal(size=(5, 4)):
        slope, bend = 0.4 - 0.6 * q + 0.6 * q**2, -0.6 + 1.2 * q
        a = cam_rate(q, v, torque, force)
        along = slope * a + bend * v**2
        at = np.array([q, 0.1 + 0.4 * q - 0.3 * q**2 + 0.2 * q**3]), np.array([v, slope * v])
        mine = ours.forward_dynamics(*at, np.array([torque, force]))
        assert np.abs(mine - [a, along]).max() < 1e-9 * max(1, abs(a), abs(along))
        f = ours.closing_follow(*at, np.array([torque, force]))
        assert np.abs(f - [0, M * along - force, 0, 0, 0, 0]).max() < 1e-9 * (1 + abs(f[1]))
        phi, E = ours.closure(at[0])
        assert abs(phi[0]) < 1e-15 and np.abs(E - [-slope, 1]).max() < 1e-15


def cam_rate(q, v, torque, force):
    slope, bend = 0.4 - 0.6 * q + 0.6 * q**2, -0.6 + 1.2 * q
    return (torque + slope * (force - M * bend * v**2)) / (J + M * slope**2)


def test_joints_transmit_what_a_law_exerts(cam):
    """The valve has m x'' and the cam J a from their joints, and accelerations change with torques
    as the closed form does."""
    ours = load_scene(cam, functions=["forward_dynamics", "reaction_lift", "reaction_shaft",
                                      "forward_dynamics_derivatives"]).double
    rng = np.random.default_rng(2)
    for q, v, torque, force in rng.normal(size=(5, 4)):
        slope = 0.4 - 0.6 * q + 0.6 * q**2
        at = np.array([q, 0.1 + 0.4 * q - 0.3 * q**2 + 0.2 * q**3]), np.array([v, slope * v])
        tau = np.array([torque, force])
        a, along = ours.forward_dynamics(*at, tau)
        assert abs(ours.reaction_lift(*at, tau)[1] - M * along) < 1e-12 * (1 + abs(along))
        assert abs(ours.reaction_shaft(*at, tau)[5] - J * a) < 1e-12 * (1 + abs(a))
        by_q, by_v, by_tau = ours.forward_dynamics_derivatives(*at, tau)
        row, bend = np.array([1, slope]), -0.6 + 1.2 * q
        turned = by_q[0] @ row + by_v[0, 1] * bend * v
        wanted = float(mpmath.diff(lambda x, v=v, t=tau: cam_rate(x, v, *t), mpmath.mpf(q)))
        assert abs(turned - wanted) < 1e-11 * (1 + abs(wanted))
        wanted = np.outer(row, row) / (J + M * slope**2)
        assert np.abs(by_tau - wanted).max() < 1e-12 * wanted.max()


def test_a_run_keeps_the_law(cam):
    """Energy stays, to the error of the integrator."""
    result = run(cam)
    q, x = result.recorded["q.shaft"], result.recorded["q.lift"]
    assert np.abs(0.1 + 0.4 * q - 0.3 * q**2 + 0.2 * q**3 - x).max() < 1e-14
    energy = sum(result.recorded[f"energy.{kind}"] for kind in ("kinetic", "potential"))
    assert np.abs(energy / energy[0] - 1).max() < 1e-6
    assert result.recorded["closing.follow.1"].any()


def test_a_linear_law_is_a_follower(cam, tmp_path):
    line = CAM.replace("[0.1, 0.4, -0.3, 0.2]", "[0.1, 0.4]")
    mimic = tmp_path / "mimic.toml"
    mimic.write_text(line[:line.index("[loops")].replace("axis = [0, 1, 0] }", "axis = [0, 1, 0], "
                     'mimic = { joint = "shaft", multiplier = 0.4, offset = 0.1 } }')
                     + "[effects.mimic]\n")
    cam.write_text(line)
    theirs = load_scene(mimic, functions=["forward_dynamics"]).double
    ours = load_scene(cam, functions=["forward_dynamics"]).double
    (a,) = theirs.forward_dynamics([0.3], [0.7], [2.0 + 0.4 * 3])
    assert np.abs(ours.forward_dynamics([0.3, 0.22], [0.7, 0.28], [2.0, 3]) - [a, 0.4 * a]
                  ).max() < 1e-9


ROBOT = """<mujoco><compiler angle="radian"/><worldbody>
<body><joint name="j1" axis="0 1 0" ref="0.3"/><geom size="0.1" pos="0.2 0 0"/>
<body pos="0 0 -0.5"><joint name="j2" axis="1 0 0" ref="-0.1"/><geom size="0.1" pos="0.1 0.2 0"/>
</body><body pos="0 0.2 -0.5"><joint name="j3" axis="0 1 0"/><geom size="0.1" pos="0.1 0 0"/></body>
</body><body><joint name="j4" type="slide" axis="0 1 0" ref="0.4"/><geom size="0.1"/></body>
</worldbody><tendon><fixed name="t"><joint joint="j2" coef="1"/><joint joint="j3" coef="-0.5"/>
</fixed><fixed name="u"><joint joint="j4" coef="2"/></fixed></tendon><equality>
<joint name="cam" joint1="j1" joint2="j2" polycoef="0.1 0.5 0.3 -0.2 0.1"/>
<joint joint1="j4" polycoef="0.2 0 0 0 0"/>
<tendon name="drive" tendon1="u" tendon2="t" polycoef="0.3 1 0 0.5 0"/>
<joint name="line" joint1="j3" joint2="j2"/><joint name="second" joint1="j3" joint2="j1"/>
<tendon name="idle" tendon1="u" active="false"/></equality></mujoco>"""


@pytest.fixture
def robot(tmp_path):
    path = tmp_path / "robot.xml"
    path.write_text(ROBOT)
    return path


def test_rows_are_mujocos(robot):
    """A quartic of joints with `ref`, a joint that is held, tendons, and the second law of a
    joint, which already follows."""
    scene = read_scene(robot)
    assert [x.name for x in scene.model.loops] == ["cam", "equality1", "drive", "second"]
    assert [x.kind.units for x in scene.model.loops] == [("rad",), ("m",), ("m",), ("rad",)]
    ours = load_scene(scene, functions=["closure"]).double
    model = mujoco.MjModel.from_xml_path(str(robot))
    data, rng = mujoco.MjData(model), np.random.default_rng(3)
    follower = model.joint("j3").qposadr[0]
    for _ in range(3):
        data.qpos[:] = rng.normal(size=4)
        data.qpos[follower] = data.qpos[1] + 0.1
        mujoco.mj_forward(model, data)
        rows = data.efc_type == int(mujoco.mjtConstraint.mjCNSTR_EQUALITY)
        kept = [0, 1, 2, 4]  # without the line, by which the joint follows
        E = data.efc_J.reshape(-1, 4)[rows][kept]
        E = np.delete(E, follower, 1) + np.outer(E[:, follower], [0, 1, 0])
        phi, mine = ours.closure(np.delete(data.qpos, follower))
        assert np.abs(phi - data.efc_pos[rows][kept]).max() < 1e-15 * 10
        assert np.abs(mine - E).max() < 1e-15 * 10


CIRCLE = """<joint joint1="j1" joint2="j2"/><joint joint1="j2" joint2="j1" polycoef="0 2 0 0 0"/>
<tendon tendon1="u" tendon2="v"/><joint name="equality1" joint1="j3" joint2="j4"/>
<joint joint1="j3" polycoef="0 0 0 0 0"/></equality>"""


def test_circles_and_names_are_resolved(robot, tmp_path):
    """A joint does not follow itself; a coordinate may be on both sides; names are other than those
    that the file gives."""
    start, _ = ROBOT.split("<equality>")
    more = '<fixed name="v"><joint joint="j4" coef="1"/><joint joint="j2" coef="1"/></fixed>'
    robot.write_text(f"{start.replace('</tendon>', f'{more}</tendon>')}<equality>{CIRCLE}</mujoco>")
    scene = read_scene(robot)
    assert {x.name: x.mimic.joint for x in scene.model.joints if x.mimic} == {
        "j1": "j2", "j3": "j4"}
    assert [x.name for x in scene.model.loops] == ["equality1_", "equality2", "equality4"]
    written = tmp_path / "robot.toml"
    assert main(["import", str(robot), "-o", str(written)]) == 0
    assert read_scene(written).model.loops == scene.model.loops


def test_import_writes_them(robot, tmp_path):
    written = tmp_path / "robot.toml"
    assert main(["import", str(robot), "-o", str(written)]) == 0
    assert read_scene(written).model.loops == read_scene(robot).model.loops
    assert """[loops.drive]
kind = "law"
joints = { j4 = 2 }
leaders = { j2 = 1, j3 = -0.5 }
""" in written.read_text()


def test_they_are_left_out_with_the_loops(robot):
    scene = read_scene(robot, overrides=SceneOverrides(leave_out=("loops",)))
    assert not scene.model.loops
    assert "equality joint 'cam': left out (loops)" in scene.unused


def test_an_attached_model_brings_its_laws(cam, tmp_path):
    (tmp_path / "base.toml").write_text("""[bodies]
base = { mass = 1, inertia = [1, 1, 1] }
[joints]
root = { type = "prismatic", child = "base", axis = [1, 0, 0] }
[attach.left]
model = "robot.xml"
to = "base"
""")
    (tmp_path / "robot.xml").write_text(ROBOT)
    scene = read_scene(tmp_path / "base.toml")
    law = scene.model.loops[0].law
    assert law and [x.joint for x in law.terms] == ["left_j1", "left_j2"]
    q = np.array([0.1, 0.2, 0.4])
    alone = load_scene(tmp_path / "robot.xml", functions=["closure"]).double.closure(q)
    here = load_scene(scene, functions=["closure"]).double.closure(
        np.array([3.0, 0.1, 0.2, 0.2 + 0.1, 0.4]))
    assert here[0][0] == alone[0][0]


@pytest.mark.parametrize(("old", "new", "words"), (
    ('joints = { lift = 1 }\n', "", "joints: missing; wanted weights by joint, as { elbow = 1 }"),
    ("{ lift = 1 }", "{ lifts = 1 }", "no joint that moves 'lifts'; did you mean 'lift'?"),
    ("[0.1, 0.4, -0.3, 0.2]", "[]", "wanted 1 to 10 numbers, [c0, c1, …]"),
    ("leaders = { shaft = 1 }\n", "", "wanted one number, [c0], or leaders"),
    ("joints = {", 'bodies = ["cam", "valve"]\njoints = {', "bodies: is for other loops; a law has "
     "joints, leaders, polynomial"),
    ('kind = "law"', 'kind = "point"\nbodies = ["cam", "valve"]', "joints: is for loops of kind "
     "law; this one is of kind point")))
def test_wrong_laws_are_refused(cam, old, new, words):
    assert old in CAM
    cam.write_text(CAM.replace(old, new))
    with pytest.raises(SceneError) as caught:
        read_scene(cam)
    assert words in str(caught.value), caught.value
