"""Jacobians and accelerations of bodies and of their points, centre of mass, centroidal momentum,
Coriolis matrix and gradients of energies equal Pinocchio's, on real robots in random states."""

from functools import cache

import numpy as np
import pinocchio as pin
import pytest

from tests.support.scenes.robot_results import STATES, apart, evaluated, full
from tests.support.scenes.robots import Robot, model_of, paired, scene_of

FRAMES = ("", "aligned_", "world_", "point_", "aligned_point_")
WHOLE = ("coriolis_matrix", "bias_torques", "gravity_torques", "energy_gradients",
         "centroidal_momentum_matrix", "centroidal_momentum_rate", "center_of_mass",
         "center_of_mass_velocity", "center_of_mass_jacobian")
ROBOTS = (
    ("ur_description/urdf/ur5_robot.urdf", False, False, "wrist_3_link"),
    ("panda_description/urdf/panda.urdf", False, True, "panda_leftfinger"),
    ("solo_description/robots/solo12.urdf", True, False, "FL_LOWER_LEG"),
    ("talos_data/robots/talos_reduced.urdf", True, False, "arm_left_7_link"),
)
BOUND = 1e-13
Matrices = dict[str, np.ndarray]


@cache
def results(file: str, free: bool, mimics: bool, body: str) -> tuple[Robot, Matrices, Matrices]:
    """The robot, its states and our results at each."""
    names = [f"{axes}{kind}_{body}" for kind in ("jacobian", "twist_rate") for axes in FRAMES]
    x = paired(scene_of(file, free, mimics), model_of(file, free), (*WHOLE, *names), mimics)
    q, v, a = x.states(STATES)
    given = {"q": q, "v": v, "a": a,
             "r": np.random.default_rng(5).uniform(-1, 1, (STATES, 3))}
    return x, given, {f.name: evaluated(f.program, given) for f in x.functions.functions}


def with_point(model: "pin.Model", frame: int, r: np.ndarray) -> tuple["pin.Model", int]:
    """The model with a frame at a point of another one."""
    other, own = model.copy(), model.frames[frame]
    place = own.placement * pin.SE3(np.eye(3), r)
    return other, other.addFrame(pin.Frame("point", own.parentJoint, frame, place,
                                           pin.OP_FRAME))


each_robot = pytest.mark.parametrize("case", ROBOTS, ids=[r[0].split("/")[-1] for r in ROBOTS])


@each_robot
def test_jacobians_and_their_rates_are_pinocchios(case: tuple[str, bool, bool, str]) -> None:
    x, given, ours = results(*case)
    q, v, a, r = given.values()
    F, body = x.follow, case[3]
    for k in range(STATES):
        for axes in FRAMES:
            model, frame = x.model, x.model.getFrameId(body)
            if "point" in axes:
                model, frame = with_point(model, frame, r[k])
            reference, rate = {
                "": (pin.LOCAL, pin.getFrameAcceleration),
                "aligned_": (pin.LOCAL_WORLD_ALIGNED, pin.getFrameClassicalAcceleration),
                "world_": (pin.WORLD, pin.getFrameAcceleration)}[axes.replace("point_", "")]
            data = model.createData()
            pin.forwardKinematics(model, data, x.theirs(q[k]), F @ v[k], F @ a[k])
            pin.computeJointJacobians(model, data)
            pin.updateFramePlacements(model, data)
            wanted = pin.getFrameJacobian(model, data, frame, reference) @ F
            assert apart(ours[f"{axes}jacobian_{body}"][k].reshape(wanted.shape), wanted) <= BOUND
            wanted = rate(model, data, frame, reference).vector
            assert apart(ours[f"{axes}twist_rate_{body}"][k], wanted) <= BOUND


@each_robot
def test_momenta_and_energies_are_pinocchios(case: tuple[str, bool, bool, str]) -> None:
    x, given, ours = results(*case)
    model, data, F, nv = x.model, x.model.createData(), x.follow, x.functions.nv
    for k in range(STATES):
        q, v, a = x.theirs(given["q"][k]), F @ given["v"][k], F @ given["a"][k]

        def close(name: str, wanted: np.ndarray, k: int = k) -> None:
            assert apart(ours[name][k].reshape(wanted.shape), wanted) <= BOUND, name

        pin.dccrba(model, data, q, v)
        close("centroidal_momentum_matrix", data.Ag @ F)
        close("centroidal_momentum_rate", data.Ag @ a + data.dAg @ v)
        close("center_of_mass", pin.centerOfMass(model, data, q, v))
        close("center_of_mass_velocity", data.vcom[0])
        close("center_of_mass_jacobian", pin.jacobianCenterOfMass(model, data, q) @ F)
        _, momenta, gravity = ours["energy_gradients"][k].reshape(3, nv)
        assert apart(momenta, F.T @ full(pin.crba(model, data, q)) @ v) <= BOUND
        assert apart(gravity, F.T @ pin.computeGeneralizedGravity(model, data, q)) <= BOUND


@each_robot
def test_coriolis_matrix_is_pinocchios(case: tuple[str, bool, bool, str]) -> None:
    """Compares matrices where a free base rests: of one that moves, another matrix has the same
    torques C v, and the errors of ours do not grow with that speed."""
    x, given, ours = results(*case)
    model, data, F, nv = x.model, x.model.createData(), x.follow, x.functions.nv
    for k in range(STATES):
        C, v = ours["coriolis_matrix"][k].reshape(nv, nv), given["v"][k]
        torques = ours["bias_torques"][k] - ours["gravity_torques"][k]
        assert apart(C @ v, torques) <= BOUND
        resting = v * (np.arange(nv) >= 3) if case[1] else v
        pin.computeCoriolisMatrix(model, data, x.theirs(given["q"][k]), F @ resting)
        assert apart(C, F.T @ data.C @ F) <= BOUND


@pytest.mark.parametrize("case", [r for r in ROBOTS if r[1]], ids=["solo12", "talos"])
def test_errors_do_not_grow_with_the_place_of_a_free_base(case: tuple[str, bool, bool, str]
                                                          ) -> None:
    """1e5 m away all that does not depend on the place has the same bits."""
    x, given, ours = results(*case)
    far = {**given, "q": given["q"].copy()}
    far["q"][:, :3] += 1e5
    for f in x.functions.functions:
        if f.name not in ("center_of_mass", f"world_jacobian_{case[3]}",
                          f"world_twist_rate_{case[3]}"):
            assert np.array_equal(evaluated(f.program, far), ours[f.name]), f.name
