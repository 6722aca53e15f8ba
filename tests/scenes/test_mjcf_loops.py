"""Equalities of MuJoCo that close loops, as closed loops: accelerations are those of MuJoCo's mass
matrix, bias and constraint rows, solved exactly."""

import mujoco
import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.__main__ import main
from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides, read_scene

ROBOT = """<mujoco><option jacobian="dense"><flag contact="disable"/></option><worldbody>
<site name="peg" pos="0.3 0.2 0.6" quat="1 0.2 -0.3 0.1"/>
<body name="a" pos="0 0 0.5" euler="0 0 20"><joint name="a" axis="0 1 0.2"/><joint name="aa"
 axis="1 0 0" pos="0 0.1 0"/><geom size="0.1" pos="0.1 0 -0.2" mass="2"/>
<body name="b" pos="0.2 0 -0.5"><joint name="b" axis="0.1 1 0"/>
<geom type="box" size="0.1 0.2 0.05" pos="0 0.1 -0.1" mass="1"/>
<body name="b2" pos="0.1 0 0" euler="10 20 30"><geom size="0.05" mass="0.3"/>
<site name="grip" pos="0.1 0 0.2" euler="30 0 10"/></body></body></body>
<body name="c" pos="0.5 0 0.5"><joint name="c" axis="0 1 0"/><joint name="cc" axis="0.3 0 1"/>
<geom size="0.1" pos="0 0.1 -0.3" mass="1.5"/></body>
<body name="d" pos="0 0.4 0.4" euler="0 40 0"><freejoint name="d"/>
<geom type="box" size="0.1 0.2 0.3" mass="1"/><site name="hole" euler="0 0 50"/></body>
</worldbody>EQUALITY</mujoco>"""
CLOSED = {
    "connect": '<connect name="pin" body1="b" body2="c" anchor="0.1 0.05 -0.2"/>',
    "connect to the world": '<connect body1="b" anchor="0 0 -0.2"/>',
    "weld": '<weld name="glue" body1="b2" body2="d" anchor="0.1 0.2 0.3"/>',
    "weld to the world": '<weld name="glue" body1="d"/>',
    "weld without torque": '<weld name="glue" body1="b2" body2="d" torquescale="0"/>',
    "two": '<connect body1="b" body2="c" anchor="0 0 -0.2"/><weld body1="d" body2="c"/>'}


def read(folder, equality: str, **overrides):
    path = folder / "robot.xml"
    path.write_text(ROBOT.replace("EQUALITY", f"<equality>{equality}</equality>"))
    return read_scene(path, overrides=SceneOverrides(**overrides))


@pytest.mark.parametrize("equality", CLOSED.values(), ids=CLOSED)
def test_accelerations_are_those_of_mujocos_rows(tmp_path, equality):
    """At rest, where MuJoCo's loops are closed: M a + bias = E^T λ and E a = 0.  The free body's
    velocities are in its own axes here."""
    kernels = load_scene(read(tmp_path, equality), functions=["forward_dynamics", "closure"])
    theirs = mujoco.MjModel.from_xml_path(str(tmp_path / "robot.xml"))
    data, q = mujoco.MjData(theirs), np.array(kernels.neutral_q)
    mujoco.mj_forward(theirs, data)
    M, E = np.zeros((theirs.nv, theirs.nv)), data.efc_J.reshape(-1, theirs.nv)
    mujoco.mj_fullM(theirs, data, M)
    turn, order = np.eye(theirs.nv), []
    for c in kernels.interface.coordinates:
        at, x = theirs.joint(c.joint).dofadr[0], data.qpos[theirs.joint(c.joint).qposadr[0]:]
        order += range(at, at + len(c.v))
        q[c.q.start:c.q.stop] = [*x[:3], *x[4:7], x[3]] if len(c.q) == 7 else x[:1]
        if len(c.q) == 7:
            turn[at:at + 3, at:at + 3] = data.body(c.joint).xmat.reshape(3, 3)
    W = E @ np.linalg.solve(M, E.T)
    free = np.linalg.solve(M, -data.qfrc_bias)
    wanted = free - np.linalg.solve(M, E.T @ np.linalg.lstsq(W, E @ free, rcond=1e-10)[0])
    zero = np.zeros(theirs.nv)
    mine = kernels.double.forward_dynamics(q, zero, zero)
    assert mine == pytest.approx((turn.T @ wanted)[order], abs=1e-7 * np.abs(wanted).max())
    assert np.abs(wanted - free).max() > 0.1
    phi, rows = kernels.double.closure(q)[:2]
    assert np.abs(phi).max() < 1e-12 and np.linalg.matrix_rank(rows, 1e-9) == np.linalg.matrix_rank(
        E, 1e-9)


def test_sites_are_welded_frame_on_frame(tmp_path):
    """The poses of both sites coincide where the closure is zero."""
    scene = read(tmp_path, '<weld name="fit" site1="hole" site2="grip"/>')
    (loop,) = scene.model.loops
    assert (loop.name, loop.kind.name, loop.bodies) == ("fit", "frame", ("fit/first", "fit/second"))
    parents = {x.child: x.parent for x in scene.model.joints}
    assert [parents[x] for x in loop.bodies] == ["d", "b2"]
    kernels = load_scene(scene, functions=["body_poses", "with_closed_loops"])
    zero = np.zeros(kernels.NV)
    q, _ = kernels.double.with_closed_loops(kernels.neutral_q, zero)[:2]
    for _ in range(20):
        q, _ = kernels.double.with_closed_loops(q, zero)[:2]
    poses = dict(zip(kernels.bodies, kernels.double.body_poses(q), strict=True))
    theirs = mujoco.MjModel.from_xml_path(str(tmp_path / "robot.xml"))
    for body, site in (("d", "hole"), ("b2", "grip")):
        at = theirs.site(site)
        R = np.zeros(9)
        mujoco.mju_quat2Mat(R, at.quat)
        D = poses[body]
        own = np.column_stack((D[:, :3] @ R.reshape(3, 3), D[:, :3] @ at.pos + D[:, 3]))
        assert own == pytest.approx(poses[f"fit/{'first' if body == 'd' else 'second'}"], abs=1e-12)
    assert poses["fit/first"] == pytest.approx(poses["fit/second"], abs=1e-9)


def test_loops_are_left_out_on_demand_and_where_nothing_moves(tmp_path):
    scene = read(tmp_path, CLOSED["weld"], leave_out=("loops",))
    assert not scene.model.loops
    assert "equality weld 'glue': left out (loops)" in scene.unused
    scene = read(tmp_path, '<weld name="idle" body1="b" body2="b2"/>')
    assert not scene.model.loops
    assert ("equality 'idle': holds bodies that cannot move against each other, and is not used"
            in scene.unused)


@pytest.mark.parametrize("equality", (CLOSED["connect"], CLOSED["weld"]), ids=("point", "frame"))
def test_imported_loops_are_the_same(tmp_path, equality):
    scene = read(tmp_path, equality)
    assert main(["import", str(tmp_path / "robot.xml"), "-o", str(tmp_path / "plain.toml")]) == 0
    plain = read_scene(tmp_path / "plain.toml")
    assert plain.model.loops == scene.model.loops and len(plain.model.loops) == 1


def test_loops_of_attached_models_have_the_new_names(tmp_path):
    read(tmp_path, CLOSED["connect"] + CLOSED["connect to the world"])
    (tmp_path / "both.toml").write_text("""[bodies.ball]
mass = 1
com = [0, 0, 0]
inertia = [1, 1, 1]
[joints.ball]
type = "revolute"
axis = [0, 0, 1]
child = "ball"
[attach.tool]
model = "robot.xml"
to = "ball"
prefix = "t_"
place = { xyz = [1, 0, 0] }
[effects.gravity]
""")
    with pytest.raises(ValueError, match="lets its root float"):
        read_scene(tmp_path / "both.toml")
    (tmp_path / "robot.xml").write_text((tmp_path / "robot.xml").read_text().replace(
        '<freejoint name="d"/>', '<joint name="d"/>'))
    pin, ground = read_scene(tmp_path / "both.toml").model.loops
    assert (pin.name, pin.bodies) == ("t_pin", ("t_b", "t_c"))
    assert (ground.name, ground.bodies) == ("t_equality1", ("t_b", "ball"))
    assert float(ground.second.point[0]) == pytest.approx(1 + mujoco.MjModel.from_xml_path(
        str(tmp_path / "robot.xml")).eq_data[1][3])
