"""Planar and universal joints equal Pinocchio's planar joint, whose velocities are in the body's
axes, and MuJoCo's slides and hinges on one body."""

from pathlib import Path

import mujoco
import numpy as np
import pinocchio as pin
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.runtime.load import Kernels

FUNCTIONS = ["inverse_dynamics", "forward_dynamics", "mass_matrix", "bias_torques", "body_poses"]
URDF = """<robot name="r">
<link name="base"/>
<link name="a"><inertial><origin xyz="0.1 0.02 0.3" rpy="0.1 0.2 0.3"/><mass value="2"/>
<inertia ixx="0.02" iyy="0.03" izz="0.04" ixy="0.001" ixz="0.002" iyz="-0.001"/></inertial></link>
<link name="b"><inertial><origin xyz="0.1 0.02 0.3" rpy="0.1 0.2 0.3"/><mass value="2"/>
<inertia ixx="0.02" iyy="0.03" izz="0.04" ixy="0.001" ixz="0.002" iyz="-0.001"/></inertial></link>
<joint name="j1" type="revolute"><parent link="base"/><child link="a"/>
<origin xyz="0.1 0 1" rpy="0.3 0.4 0.5"/><axis xyz="0 1 0"/>
<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
<joint name="j2" type="planar"><parent link="a"/><child link="b"/>
<origin xyz="0.1 0 1" rpy="0.3 0.4 0.5"/><axis xyz="AXIS"/></joint>
</robot>
"""
AXES = {"0 0 1": np.eye(3), "1 0 0": np.roll(np.eye(3), 1, 0), "0 1 0": np.roll(np.eye(3), 2, 0)}
"""Normals, and the columns x, y, normal in the joint's axes."""


@pytest.fixture(params=AXES)
def case(request, tmp_path: Path) -> tuple[Kernels, "pin.Model", np.ndarray]:
    """Ours; Pinocchio's, whose normal is z, with the joint's frame turned; by how much."""
    (tmp_path / "r.urdf").write_text(URDF.replace("AXIS", request.param))
    (tmp_path / "r.toml").write_text('model = "r.urdf"\n[effects.gravity]\n')
    model, turn = pin.buildModelFromUrdf(str(tmp_path / "r.urdf")), AXES[request.param]
    turned = pin.SE3(turn, np.zeros(3))
    model.jointPlacements[2] = model.jointPlacements[2] * turned
    model.inertias[2] = turned.inverse().act(model.inertias[2])
    return load_scene(tmp_path / "r.toml", functions=FUNCTIONS), model, turn


def body_axes(angle: float) -> np.ndarray:
    """Pinocchio's velocities by ours: those of the plane turned back."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[1, 0, 0, 0], [0, c, s, 0], [0, -s, c, 0], [0, 0, 0, 1]])


def rate(angle: float, speed: float) -> np.ndarray:
    """The rate of that matrix."""
    c, s = speed * np.cos(angle), speed * np.sin(angle)
    return np.array([[0, 0, 0, 0], [0, -s, c, 0], [0, -c, -s, 0], [0, 0, 0, 0]])


def near(result, wanted, within=1e-13):
    size = max(1.0, np.abs(wanted).max())
    assert np.abs(np.asarray(result) - wanted).max() <= within * size, (result, wanted)


def test_pinocchio_s_planar_joint_moves_alike(case):
    ours, model, _ = case
    data, rng = model.createData(), np.random.default_rng(3)
    for q, v, a in rng.uniform(-2, 2, (16, 3, 4)):
        T = body_axes(q[3])
        x = np.array([*q[:3], np.cos(q[3]), np.sin(q[3])])
        w, dw = T @ v, T @ a + rate(q[3], v[3]) @ v
        tau = T.T @ pin.rnea(model, data, x, w, dw)
        near(ours.double.inverse_dynamics(q, v, a), tau)
        near(ours.double.forward_dynamics(q, v, tau), a, 1e-11)
        near(ours.single.inverse_dynamics(*np.float32([q, v, a])), tau, 1e-5)
        M = pin.crba(model, data, x)
        near(ours.double.mass_matrix(q), T.T @ (np.triu(M) + np.triu(M, 1).T) @ T)
        near(ours.double.bias_torques(q, v),
             T.T @ pin.rnea(model, data, x, w, rate(q[3], v[3]) @ v))


def test_pinocchio_s_frames_are_ours(case):
    ours, model, turn = case
    data, q = model.createData(), np.array([0.4, 0.3, -0.2, 0.7])
    pin.framesForwardKinematics(model, data,
                                np.array([*q[:3], np.cos(q[3]), np.sin(q[3])]))
    near(ours.double.body_poses(q)[-1], np.c_[data.oMi[2].rotation @ turn.T,
                                              data.oMi[2].translation])


SCENE = """
[bodies]
puck = { mass = 2, com = [0.2, -0.1, 0.3], inertia = [0.5, 0.6, 0.7, 0.05, -0.1, 0.02] }
arm = { mass = 1.5, com = [-0.3, 0.1, 0.2], inertia = [0.4, 0.3, 0.5, 0, 0.1, 0.05] }
[joints]
table = { type = "planar", child = "puck", axis = [0, 0, 1], origin = { xyz = [0, 0, 1] } }
wrist = { type = "universal", parent = "puck", child = "arm", axis = [0.6, 0.8, 0], \
axis2 = [0, 0, 1], origin = { xyz = [0, 0.3, 0.2] } }
[effects.gravity]
g = [1, 2, -9]
"""
MJCF = """<mujoco><option gravity="1 2 -9"/><worldbody><body pos="0 0 1">
<joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 1 0"/><joint axis="0 0 1"/>
<inertial mass="2" pos="0.2 -0.1 0.3" fullinertia="0.5 0.6 0.7 0.05 -0.1 0.02"/>
<body pos="0 0.3 0.2"><joint axis="0.6 0.8 0"/><joint axis="0 0 1"/>
<inertial mass="1.5" pos="-0.3 0.1 0.2" fullinertia="0.4 0.3 0.5 0 0.1 0.05"/></body></body>
</worldbody></mujoco>"""


def test_mujoco_s_slides_and_hinges_move_alike(tmp_path):
    (tmp_path / "mj.toml").write_text(SCENE)
    ours, model = load_scene(tmp_path / "mj.toml", functions=FUNCTIONS), \
        mujoco.MjModel.from_xml_string(MJCF)
    data, rng = mujoco.MjData(model), np.random.default_rng(4)
    for q, v, a in rng.uniform(-2, 2, (16, 3, 5)):
        data.qpos[:], data.qvel[:], data.qacc[:] = q, v, a
        mujoco.mj_inverse(model, data)
        near(ours.double.inverse_dynamics(q, v, a), data.qfrc_inverse, 1e-12)
        mujoco.mj_forward(model, data)
        M = np.zeros((5, 5))
        mujoco.mj_fullM(model, data, M)
        near(ours.double.mass_matrix(q), M, 1e-12)
        near(ours.double.bias_torques(q, v), data.qfrc_bias, 1e-12)
