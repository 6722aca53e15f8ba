"""Inverse kinematics of an arm within its joints' ranges, with SciPy: reaches random places of a
body, counts successes.

Usage: python examples/inverse_kinematics.py MODEL BODY COUNT
"""

import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

import coscrew
import coscrew_codegen
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene

Reals = NDArray[np.float64]
STARTS, CLOSE = 20, 1e-6  # tries for a target; m and rad


class Arm:
    """A model's body, and the ranges of the joints that carry it."""

    def __init__(self, model: Path, body: str):
        scene = read_scene(model)
        self.its = coscrew_codegen.load_scene(scene, functions=["body_poses", f"jacobian_{body}"])
        self.jacobian = getattr(self.its.double, f"jacobian_{body}")
        self.place = self.its.bodies.index(body)
        joints = {x.name: x for x in scene.model.joints}
        ends = [(joints[name].lower, joints[name].upper) for name in self.its.joints]
        self.ranges = np.array([(float(-np.pi if low is None else low),
                                 float(np.pi if high is None else high)) for low, high in ends]).T

    def pose(self, q: Reals) -> Reals:
        """D of the body."""
        return np.asarray(self.its.double.body_poses(q))[..., self.place, :, :]

    def reached(self, target: Reals, rng: np.random.Generator) -> Reals | None:
        """q within the ranges that brings the body to the target; None if no start leads there."""
        def away(q: Reals) -> Reals:
            return np.asarray(coscrew.SE3_log(coscrew.product_dinvd(self.pose(q), target)))

        def slopes(q: Reals) -> Reals:
            inverse = np.asarray(coscrew.SE3_leftJacobianInverse(away(q)))
            return -inverse @ np.asarray(self.jacobian(q))

        for _ in range(STARTS):
            result = least_squares(away, rng.uniform(*self.ranges), slopes, bounds=self.ranges,
                                   xtol=1e-12, ftol=1e-12, gtol=1e-12, max_nfev=100)
            if np.abs(result.fun).max() < CLOSE:
                return np.asarray(result.x)
        return None


def successes(arm: Arm, count: int) -> int:
    """Targets reached, of poses at random q within the ranges."""
    rng = np.random.default_rng(0)
    targets = arm.pose(rng.uniform(*arm.ranges, (count, arm.ranges.shape[1])))
    return sum(arm.reached(target, rng) is not None for target in targets)


if __name__ == "__main__":
    _, model, body, count = sys.argv
    print(f"{successes(Arm(Path(model), body), int(count))} of {count} targets reached")
