"""The example of inverse kinematics reaches every target within the joints' ranges, as Pinocchio's
forward kinematics confirm; Pinocchio's own example, a damped iteration, reaches fewer."""

import runpy
from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest

from tests.support.scenes.robots import model_of, path_of

FOLDER = Path(__file__).parents[2] / "examples"
EXAMPLE = runpy.run_path(str(FOLDER / "inverse_kinematics.py"))
ARMS = pytest.mark.parametrize("file, body", [
    ("ur_description/urdf/ur5_robot.urdf", "wrist_3_link"),
    ("xarm_description/urdf/xarm7.urdf", "link7")])
COUNT, CLOSE = 25, 1e-5  # as the example of Pinocchio asks for: 1e-4


def iterated(model: "pin.Model", frame: int, target: "pin.SE3") -> np.ndarray | None:
    """Pinocchio's example: from the neutral position, at most 1000 steps; None if it fails."""
    data, q = model.createData(), pin.neutral(model)
    for _ in range(1000):
        pin.framesForwardKinematics(model, data, q)
        error = data.oMf[frame].actInv(target)
        away = pin.log(error).vector
        if np.linalg.norm(away) < 1e-4:
            return q
        J = -pin.Jlog6(error.inverse()) @ pin.computeFrameJacobian(model, data, q, frame)
        step = -J.T @ np.linalg.solve(J @ J.T + 1e-12 * np.eye(6), away)
        q = pin.integrate(model, q, step * 0.1)
    return None


@ARMS
def test_targets_are_reached_within_ranges(file: str, body: str) -> None:
    arm, model = EXAMPLE["Arm"](path_of(file), body), model_of(file, False)
    rng = np.random.default_rng(1)
    lower, upper = arm.ranges
    assert np.allclose(lower, model.lowerPositionLimit)
    assert np.allclose(upper, model.upperPositionLimit)
    frame, data, theirs = model.getFrameId(body), model.createData(), 0
    for target in arm.pose(rng.uniform(lower, upper, (COUNT, len(lower)))):
        q = arm.reached(target, rng)
        assert q is not None and (lower <= q).all() and (q <= upper).all()
        pin.framesForwardKinematics(model, data, q)
        assert np.abs(data.oMf[frame].homogeneous[:3] - target).max() < CLOSE
        other = iterated(model, frame, pin.SE3(target[:, :3], target[:, 3]))
        theirs += other is not None and bool((lower <= other).all() and (other <= upper).all())
    assert theirs < COUNT


@ARMS
def test_many_targets_are_reached_at_once(monkeypatch: pytest.MonkeyPatch, file: str, body: str
                                          ) -> None:
    """All but a few of 1000, within the ranges, as Pinocchio's forward kinematics confirm."""
    monkeypatch.syspath_prepend(FOLDER)
    arm, model = EXAMPLE["Arm"](path_of(file), body), model_of(file, False)
    rng = np.random.default_rng(2)
    targets = arm.pose(rng.uniform(*arm.ranges, (1000, arm.ranges.shape[1])))
    q, done = runpy.run_path(str(FOLDER / "many_targets.py"))["reached"](arm, targets, rng)
    assert done.mean() > 0.99
    assert (arm.ranges[0] <= q).all() and (q <= arm.ranges[1]).all()
    frame, data = model.getFrameId(body), model.createData()
    for own, target in zip(q[done][::7], targets[done][::7], strict=True):
        pin.framesForwardKinematics(model, data, own)
        assert np.abs(data.oMf[frame].homogeneous[:3] - target).max() < CLOSE
