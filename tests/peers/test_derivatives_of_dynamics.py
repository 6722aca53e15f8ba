"""Derivatives of inverse and forward dynamics equal Pinocchio's, on real robots in random states;
entries of joints in different branches are zero and not computed."""

from functools import cache

import numpy as np
import pinocchio as pin
import pytest

from coscrew_codegen.dynamics import derive
from coscrew_codegen.program import Constant
from coscrew_codegen.program.flops import flops
from tests.support.scenes.robot_results import STATES, apart, evaluated, full
from tests.support.scenes.robots import Robot, model_of, paired, scene_of

INVERSE, FORWARD = "inverse_dynamics_derivatives", "forward_dynamics_derivatives"
ROBOTS = (
    ("ur_description/urdf/ur5_robot.urdf", False, False),
    ("panda_description/urdf/panda.urdf", False, True),
    ("double_pendulum_description/urdf/double_pendulum.urdf", False, False),
    ("solo_description/robots/solo12.urdf", True, False),
    ("anymal_b_simple_description/robots/anymal.urdf", True, False),
    ("pr2_description/urdf/pr2.urdf", False, True),
)
each_robot = pytest.mark.parametrize("file, free, mimics", ROBOTS,
                                     ids=[r[0].split("/")[-1] for r in ROBOTS])


@cache
def robot(file: str, free: bool, mimics: bool) -> Robot:
    names = (INVERSE, FORWARD) if "pr2" not in file else (INVERSE,)
    return paired(scene_of(file, free, mimics), model_of(file, free), names, mimics)


def ours(x: Robot, name: str, *arguments: np.ndarray) -> np.ndarray:
    """The three matrices of each state."""
    program, nv = x.functions.named(name).program, x.functions.nv
    given = {a.name: x for a, x in zip(program.inputs, arguments, strict=True)}
    return evaluated(program, given).reshape(STATES, 3, nv, nv)


@pytest.mark.parametrize("file, free, mimics, body", [
    ("ur_description/urdf/ur5_robot.urdf", False, False, "wrist_3_link"),
    ("panda_description/urdf/panda.urdf", False, True, "panda_leftfinger"),
    ("solo_description/robots/solo12.urdf", True, False, "FL_LOWER_LEG")])
def test_jacobians_in_the_worlds_axes_and_accelerations_are_pinocchios(
        file: str, free: bool, mimics: bool, body: str) -> None:
    names = [f"{x}_jacobian_{body}" for x in ("aligned", "world")] + [f"acceleration_{body}"]
    x = paired(scene_of(file, free, mimics), model_of(file, free), names, mimics)
    q, v, a = x.states(STATES)
    data, F, frame = x.model.createData(), x.follow, x.model.getFrameId(body)
    results = {f.name: evaluated(f.program, {"q": q, "v": v, "a": a})
               for f in x.functions.functions}
    for k in range(STATES):
        pin.forwardKinematics(x.model, data, x.theirs(q[k]), F @ v[k], F @ a[k])
        pin.computeJointJacobians(x.model, data)
        pin.updateFramePlacements(x.model, data)
        for name, axes in zip(names, (pin.LOCAL_WORLD_ALIGNED, pin.WORLD), strict=False):
            wanted = pin.getFrameJacobian(x.model, data, frame, axes) @ F
            assert apart(results[name][k].reshape(wanted.shape), wanted) <= 1e-13
        wanted = pin.getFrameClassicalAcceleration(x.model, data, frame, pin.LOCAL).vector
        assert apart(results[names[2]][k], wanted) <= 1e-13


@each_robot
def test_inverse_dynamics_derivatives_are_pinocchios(file: str, free: bool, mimics: bool) -> None:
    x = robot(file, free, mimics)
    q, v, a = x.states(STATES)
    results, data, F = ours(x, INVERSE, q, v, a), x.model.createData(), x.follow
    for k in range(STATES):
        pin.computeRNEADerivatives(x.model, data, x.theirs(q[k]), F @ v[k], F @ a[k])
        for result, wanted in zip(results[k], (data.dtau_dq, data.dtau_dv, full(data.M)),
                                  strict=True):
            assert apart(result, F.T @ wanted @ F) <= 1e-13


@pytest.mark.parametrize("file, free", [(r[0], r[1]) for r in ROBOTS if not r[2]],
                         ids=[r[0].split("/")[-1] for r in ROBOTS if not r[2]])
def test_forward_dynamics_derivatives_are_pinocchios(file: str, free: bool) -> None:
    """To the condition of M."""
    x = robot(file, free, False)
    q, v, tau = x.states(STATES)
    results, data, F = ours(x, FORWARD, q, v, tau), x.model.createData(), x.follow
    for k in range(STATES):
        theirs = x.theirs(q[k])
        condition = np.linalg.cond(full(pin.crba(x.model, data, theirs)))
        pin.computeABADerivatives(x.model, data, theirs, F @ v[k], F @ tau[k])
        for result, wanted in zip(results[k], (data.ddq_dq, data.ddq_dv, full(data.Minv)),
                                  strict=True):
            assert apart(result, F.T @ wanted @ F) <= 8 * condition * 2.0**-53


@pytest.mark.parametrize("name, most", [(INVERSE, 1836), (FORWARD, 2937)])
def test_operations_of_a_ur5(name: str, most: int) -> None:
    """No more than the recursion takes, without what the robot's numbers make zero or one."""
    x = robot("ur_description/urdf/ur5_robot.urdf", False, False)
    assert flops(x.functions.named(name).program) <= most


@pytest.mark.parametrize("name", [
    "inverse_dynamics", "forward_dynamics", "bias_torques", "energy", "energy_gradients",
    "mass_matrix", "coriolis_matrix", "momentum", "centroidal_momentum_matrix", "body_twists",
    "center_of_mass_jacobian", "jacobian_wrist_3_link", "aligned_jacobian_wrist_3_link",
    "world_jacobian_wrist_3_link", "aligned_point_jacobian_wrist_3_link"])
def test_a_direction_costs_less_than_three_times_the_function(name: str) -> None:
    """Tangents and adjoints, by all inputs."""
    functions = derive(scene_of("ur_description/urdf/ur5_robot.urdf", False, False),
                       [name, f"{name}_tangent", f"{name}_adjoint"])
    own, *others = (flops(f.program) for f in functions.functions)
    assert len(others) == 2 and max(others) <= 3 * own


def test_entries_of_different_branches_are_zeros() -> None:
    """The constant: no instruction computes them."""
    x = robot("solo_description/robots/solo12.urdf", True, False)
    program, nv = x.functions.named(INVERSE).program, x.functions.nv
    legs = [0] * 6 + [1 + k // 3 for k in range(12)]
    for matrix in range(3):
        for i in range(nv):
            for j in range(nv):
                entry = program.results[(matrix * nv + i) * nv + j]
                if legs[i] and legs[j] and legs[i] != legs[j]:
                    assert isinstance(entry, Constant) and entry.double == 0
