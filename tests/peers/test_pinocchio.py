"""Every function of a scene equals Pinocchio's, on real robots in random states.

Robots are read from the same URDF files.  Coordinates that follow others are projected out
of Pinocchio's full model.
"""

import numpy as np
import pinocchio as pin
import pytest

from coscrew_codegen.program import Op
from coscrew_codegen.scene.identifiers import identifiers
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.scenes import evaluation
from tests.support.scenes.robots import Robot, model_of, paired, path_of, robot, scene_of

STATES = 8
DOUBLE, SINGLE = 2.0**-53, 2.0**-24

# file, whether its base is free, whether followers follow
ROBOTS = (
    ("ur_description/urdf/ur5_robot.urdf", False, False),
    ("panda_description/urdf/panda.urdf", False, True),
    ("kinova_description/robots/kinova.urdf", False, False),
    ("xarm_description/urdf/xarm7.urdf", False, False),
    ("allegro_hand_description/urdf/allegro_left_hand.urdf", False, False),
    ("tiago_description/robots/tiago.urdf", False, False),
    ("baxter_description/urdf/baxter.urdf", False, False),
    ("double_pendulum_description/urdf/double_pendulum.urdf", False, False),
    ("finger_edu_description/robots/finger_edu.urdf", False, False),
    ("solo_description/robots/solo12.urdf", True, False),
    ("anymal_b_simple_description/robots/anymal.urdf", True, False),
    ("go2_description/urdf/go2.urdf", True, False),
    ("bolt_description/robots/bolt.urdf", True, False),
    ("g1_description/urdf/g1_29dof_rev_1_0.urdf", True, False),
    ("talos_data/robots/talos_reduced.urdf", True, False),
    ("simple_humanoid_description/urdf/simple_humanoid.urdf", True, False),
    ("pr2_description/urdf/pr2.urdf", False, True),
    ("alexander_description/urdf/alexander_v1.lowerBodyOnly.urdf", True, False),
)


ALL = pytest.mark.parametrize("file, free, mimics", ROBOTS,
                              ids=[r[0].split("/")[-1] for r in ROBOTS])


def _ours(x: Robot, name: str, *arguments: np.ndarray, dtype=np.float64) -> np.ndarray:
    program = next(f.program for f in x.functions.functions if f.name == name)
    numbers = evaluation.SINGLE if dtype == np.float32 else evaluation.DOUBLE
    columns = [list(a.astype(dtype).T) for a in arguments]
    result = evaluation.evaluator(program, numbers)(columns)
    return np.stack([np.broadcast_to(np.asarray(x, dtype), STATES) for x in result], -1)


def _error(result: np.ndarray, wanted: np.ndarray) -> float:
    """The largest difference, relative to the largest number."""
    wanted = np.reshape(wanted, -1)
    return float(np.abs(np.reshape(result, -1) - wanted).max() / max(np.abs(wanted).max(), 1e-300))


@ALL
def test_inverse_dynamics_is_pinocchios(file, free, mimics):
    x = robot(file, free, mimics)
    q, v, a = x.states(STATES)
    result = _ours(x, "inverse_dynamics", q, v, a)
    data = x.model.createData()
    for k in range(STATES):
        wanted = x.follow.T @ pin.rnea(x.model, data, x.theirs(q[k]), x.follow @ v[k],
                                       x.follow @ a[k])
        assert _error(result[k], wanted) <= 1e-12


def test_inverse_dynamics_are_pinocchios_where_hands_are_massless():
    """The mass matrix is singular: joints of the fingers move nothing."""
    file = "romeo_description/urdf/romeo.urdf"
    x = paired(scene_of(file), model_of(file, False), ("inverse_dynamics", "mass_matrix"))
    q, v, a = x.states(STATES)
    result, masses, data = _ours(x, "inverse_dynamics", q, v, a), _ours(x, "mass_matrix", q), \
        x.model.createData()
    for k in range(STATES):
        wanted = pin.rnea(x.model, data, x.theirs(q[k]), x.follow @ v[k], x.follow @ a[k])
        assert _error(result[k], x.follow.T @ wanted) <= 1e-12
        upper = np.triu(pin.crba(x.model, data, x.theirs(q[k])))
        assert _error(masses[k], x.follow.T @ (upper + np.triu(upper, 1).T) @ x.follow) <= 1e-12
        assert np.linalg.matrix_rank(masses[k].reshape(x.model.nv, -1)) == x.model.nv - 24


def test_a_payload_on_an_arm_is_pinocchios(tmp_path):
    """[attach.payload] on a UR5's flange, beside appendBodyToJoint."""
    file = "ur_description/urdf/ur5_robot.urdf"
    (tmp_path / "ur5.urdf").write_text(path_of(file).read_text())
    (tmp_path / "loaded.toml").write_text("""
model = "ur5.urdf"
[attach.payload]
to = "tool0"
place = { xyz = [0.02, -0.01, 0.1], rpy = [0.3, -0.2, 1.1] }
mass = 3.5
com = [0.01, 0.02, 0.05]
inertia = [0.02, 0.03, 0.04, 0.001, -0.002, 0.003]
[effects.gravity]
g = [0, 0, -9.81]
""")
    theirs = model_of(file, False)
    flange = theirs.frames[theirs.getFrameId("tool0")]
    payload = pin.Inertia(3.5, np.array([0.01, 0.02, 0.05]), np.array(
        [[0.02, 0.001, -0.002], [0.001, 0.03, 0.003], [-0.002, 0.003, 0.04]]))
    place = pin.SE3(pin.rpy.rpyToMatrix(0.3, -0.2, 1.1), np.array([0.02, -0.01, 0.1]))
    theirs.appendBodyToJoint(flange.parentJoint, payload, flange.placement * place)
    names = ("inverse_dynamics", "forward_dynamics", "mass_matrix")
    x = paired(read_scene(tmp_path / "loaded.toml"), theirs, names)
    q, v, a = x.states(STATES)
    got = {name: _ours(x, name, q, *([] if name == "mass_matrix" else [v, a])) for name in names}
    data = theirs.createData()
    for k in range(STATES):
        at = x.theirs(q[k])
        upper = np.triu(pin.crba(theirs, data, at))
        M = upper + np.triu(upper, 1).T
        assert _error(got["mass_matrix"][k], M) <= 1e-14
        assert _error(got["inverse_dynamics"][k], pin.rnea(theirs, data, at, v[k], a[k])) <= 1e-14
        assert _error(got["forward_dynamics"][k], pin.aba(theirs, data, at, v[k], a[k])) <= \
            DOUBLE * np.linalg.cond(M)


@ALL
def test_mass_matrix_and_forward_dynamics_are_pinocchios(file, free, mimics):
    x = robot(file, free, mimics)
    q, v, tau = x.states(STATES, 1)
    masses = _ours(x, "mass_matrix", q)
    result = _ours(x, "forward_dynamics", q, v, tau)
    data = x.model.createData()
    for k in range(STATES):
        theirs = x.theirs(q[k])
        upper = np.triu(pin.crba(x.model, data, theirs))
        M = x.follow.T @ (upper + np.triu(upper, 1).T) @ x.follow
        assert _error(masses[k], M) <= 1e-12
        bias = x.follow.T @ pin.nle(x.model, data, theirs, x.follow @ v[k])
        wanted = np.linalg.solve(M, tau[k] - bias)
        if not mimics:
            wanted = x.follow.T @ pin.aba(x.model, data, theirs, x.follow @ v[k],
                                          x.follow @ tau[k])
        assert _error(result[k], wanted) <= max(1e-12, DOUBLE * np.linalg.cond(M))


@ALL
def test_single_precision_is_within_its_condition(file, free, mimics):
    """The error of single precision, from states that single precision can hold: RNEA within 100 u
    of the largest torque, ABA within 100 u |M^-1| (|tau| + |bias|)."""
    x = robot(file, free, mimics)
    q, v, a = (y.astype(np.float32).astype(np.float64) for y in x.states(STATES, 2))
    exact = _ours(x, "inverse_dynamics", q, v, a)
    result = _ours(x, "inverse_dynamics", q, v, a, dtype=np.float32)
    assert result.dtype == np.float32
    assert _error(result, exact) <= 100 * SINGLE
    tau = exact.astype(np.float32).astype(np.float64)
    exact = _ours(x, "forward_dynamics", q, v, tau)
    result = _ours(x, "forward_dynamics", q, v, tau, dtype=np.float32)
    masses = _ours(x, "mass_matrix", q).reshape(STATES, x.functions.nv, -1)
    bias = _ours(x, "bias_torques", q, v)
    for k in range(STATES):
        torque = np.abs(tau[k]).max() + np.abs(bias[k]).max()
        scale = np.abs(np.linalg.inv(masses[k])).sum(1).max() * torque
        assert np.abs(result[k] - exact[k]).max() <= 100 * SINGLE * scale


@ALL
def test_energies_poses_twists_and_jacobians_are_pinocchios(file, free, mimics):
    x = robot(file, free, mimics)
    q, v, _ = x.states(STATES, 3)
    energy = _ours(x, "energy", q, v)
    poses = _ours(x, "body_poses", q).reshape(STATES, -1, 12)
    twists = _ours(x, "body_twists", q, v).reshape(STATES, -1, 6)
    data = x.model.createData()
    names = dict(zip(x.functions.bodies, identifiers(x.functions.bodies), strict=True))
    jacobians = {f.name: _ours(x, f.name, q) for f in x.functions.functions
                 if f.name.startswith("jacobian_")}
    compared = 0
    for k in range(STATES):
        theirs = x.theirs(q[k])
        pin.computeJointJacobians(x.model, data, theirs)
        kinetic = pin.computeKineticEnergy(x.model, data, theirs, x.follow @ v[k])
        potential = pin.computePotentialEnergy(x.model, data, theirs)
        assert _error(energy[k], np.array([kinetic, potential])) <= 1e-12
        pin.framesForwardKinematics(x.model, data, theirs)
        for number, (body, name) in enumerate(names.items()):
            if not x.model.existBodyName(body):
                continue
            frame = x.model.getFrameId(body, pin.BODY)
            J = pin.getFrameJacobian(x.model, data, frame, pin.LOCAL) @ x.follow
            assert _error(poses[k, number], data.oMf[frame].homogeneous[:3]) <= 1e-12
            scale = max(np.abs(J).max(), 1) * np.abs(v[k]).max()
            assert np.abs(twists[k, number] - J @ v[k]).max() <= 1e-12 * scale
            if f"jacobian_{name}" in jacobians:
                assert _error(jacobians[f"jacobian_{name}"][k], J) <= 1e-12
                compared += 1
    assert compared >= STATES


@pytest.mark.parametrize("file, inverse, forward, turns", (
    ("ur_description/urdf/ur5_robot.urdf", 460, 940, 6),
    ("panda_description/urdf/panda.urdf", 900, 1820, 7)))
def test_constants_fold_to_few_operations(file, inverse, forward, turns):
    """Right angles cost nothing, and the articulated inertia beyond a free joint is zero along its
    axis."""
    programs = {f.name: f.program for f in robot(file, False, False).functions.functions}
    for name, most in (("inverse_dynamics", inverse), ("forward_dynamics", forward)):
        counts = programs[name].counts
        sines = counts[Op.SIN]
        assert sines <= turns and sum(counts.values()) - sines - counts[Op.COS] <= most
