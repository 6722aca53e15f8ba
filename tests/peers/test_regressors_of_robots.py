"""Regressors of torques equal Pinocchio's, on real robots in random states; a UR5 has 36 base
parameters of 60."""

import numpy as np
import pinocchio as pin
import pytest

from tests.support.scenes.robot_results import STATES, apart, evaluated
from tests.support.scenes.robots import model_of, paired, scene_of

ORDER = (0, 1, 2, 3, 4, 6, 9, 5, 7, 8)
"""The places of ours among theirs: m, m c, then xx, xy, yy, xz, yz, zz."""
NAMES = ("inverse_dynamics", "torque_regressor", "base_regressor", "linear_parameters",
         "base_parameters")
ROBOTS = (  # file, free base, links, base parameters
    ("ur_description/urdf/ur5_robot.urdf", False, 6, 36),
    ("kinova_description/robots/kinova.urdf", False, 6, 36),
    ("double_pendulum_description/urdf/double_pendulum.urdf", False, 2, 6),
    ("solo_description/robots/solo12.urdf", True, 13, 94),
)


@pytest.mark.parametrize("file, free, links, base", ROBOTS,
                         ids=[r[0].split("/")[-1] for r in ROBOTS])
def test_regressors_are_pinocchios(file: str, free: bool, links: int, base: int) -> None:
    x = paired(scene_of(file, free), model_of(file, free), NAMES)
    q, v, a = x.states(STATES)
    ours = {f.name: evaluated(f.program, {"q": q, "v": v, "a": a})
            for f in x.functions.functions}
    model, data, nv = x.model, x.model.createData(), x.functions.nv
    assert ours["linear_parameters"].shape[1] == 10 * links
    assert ours["base_parameters"].shape[1] == base
    places = [10 * link + k for link in range(links) for k in ORDER]
    for k in range(STATES):
        Y, of_base = (ours[name][k][:-nv].reshape(nv, -1)
                      for name in ("torque_regressor", "base_regressor"))
        theirs = pin.computeJointTorqueRegressor(
            model, data, x.theirs(q[k]), x.follow @ v[k], x.follow @ a[k])
        assert apart(Y, x.follow.T @ theirs[:, places]) <= 1e-14
        tau = ours["inverse_dynamics"][k]
        assert apart(Y @ ours["linear_parameters"][k], tau) <= 1e-14
        assert apart(of_base @ ours["base_parameters"][k], tau) <= 1e-14
        parameters = np.concatenate([
            model.inertias[n].toDynamicParameters() for n in range(1, model.njoints)])
        assert apart(ours["linear_parameters"][k], parameters[places]) <= 1e-14


def test_base_parameters_are_named_in_the_header() -> None:
    """With their numbers, which are the same on every machine."""
    x = paired(scene_of(ROBOTS[0][0]), model_of(ROBOTS[0][0], False), ("base_parameters",))
    words = x.functions.named("base_parameters").words
    for text in (" [1] upper_arm_link.mx, [2] upper_arm_link.mz + 0.425 forearm_link.m + ",
                 " [31] wrist_3_link.Ixx - wrist_3_link.Izz, ", " [35] wrist_3_link.Iyz"):
        assert text in words, words
