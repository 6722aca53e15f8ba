"""Errors of the derivatives of inverse and forward dynamics: coscrew's, in each tier and precision,
and Pinocchio's, at the same states.

`python -m tests.benchmarks.derivatives` prints, for each robot and motion, the worst error of an
entry in u = 2^-53 (single: 2^-24) of its matrix's largest entry.  Truth: the Programs in 50 digits,
which tests compare with differences.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import mpmath
import numpy as np
import pinocchio as pin
from tabulate import tabulate
from tqdm import tqdm

from coscrew_codegen.program import Program
from coscrew_codegen.runtime.load import Kernels, in_tier_of, kernels_of
from tests.support.scenes import evaluation
from tests.support.scenes.robots import Robot, model_of, paired, scene_of

INVERSE, FORWARD = "inverse_dynamics_derivatives", "forward_dynamics_derivatives"
STATES = 8
ROBOTS = (("UR5", "ur_description/urdf/ur5_robot.urdf", False),
          ("Panda", "panda_description/urdf/panda.urdf", False),
          ("Solo12", "solo_description/robots/solo12.urdf", True),
          ("ANYmal", "anymal_b_simple_description/robots/anymal.urdf", True))
AT_HOME, AWAY = (0.0, 0.0), (1e5, 1e3)
"""A free base's place in m and speed in m/s."""
Matrices = Sequence[np.ndarray]


@dataclass(frozen=True)
class Motion:
    """A robot's states, the same in all libraries and tiers."""

    robot: Robot
    q: np.ndarray
    v: np.ndarray
    given: np.ndarray  # accelerations, or torques


def motion(robot: Robot, place: float, speed: float) -> Motion:
    """Random states; a free base is displaced and fast along x."""
    q, v, given = robot.states(STATES)
    if robot.functions.coordinates[0].kind == "free":
        q[:, 0] += place
        v[:, 0] += speed
    return Motion(robot, q, v, given)


def truth(program: Program, x: Motion, k: int) -> list[np.ndarray]:
    """The three matrices of a state, of 50-digit numbers."""
    nv = x.robot.functions.nv
    with mpmath.workdps(50):
        values = evaluation.evaluator(program, evaluation.MULTIPRECISE)(
            [[mpmath.mpf(float(c)) for c in row[k]] for row in (x.q, x.v, x.given)])
    return list(np.array(values, object).reshape(3, nv, nv))


def full(upper: np.ndarray) -> np.ndarray:
    """The symmetric matrix whose upper triangle this has."""
    return np.triu(upper) + np.triu(upper, 1).T


def pinocchios(name: str, x: Motion, k: int) -> Matrices:
    """The three matrices by Pinocchio."""
    model, data, order = x.robot.model, x.robot.model.createData(), x.robot.follow
    state = x.robot.theirs(x.q[k]), order @ x.v[k], order @ x.given[k]
    if name == INVERSE:
        pin.computeRNEADerivatives(model, data, *state)
        result = data.dtau_dq, data.dtau_dv, full(data.M)
    else:
        pin.computeABADerivatives(model, data, *state)
        result = data.ddq_dq, data.ddq_dv, full(data.Minv)
    return [order.T @ A @ order for A in result]


def worst(results: Iterator[Matrices], wanted: Sequence[Matrices], u: float) -> float:
    """The largest error, in u of the largest entry of its matrix."""
    return max(float(abs(a.astype(float) - b).max() / abs(b).max() / u)
               for state, true in zip(results, wanted, strict=True)
               for a, b in zip(state, true, strict=True))


def errors(name: str, x: Motion, kernels: Kernels) -> list[float]:
    """The worst errors: plain and accurate in double, Pinocchio, plain and accurate in single."""
    accurate = in_tier_of(kernels, "accurate")
    double = [truth(x.robot.functions.named(name).program, x, k) for k in range(STATES)]
    rounded = Motion(x.robot, *(np.float32(y).astype(float) for y in (x.q, x.v, x.given)))
    single = [truth(x.robot.functions.named(name).program, rounded, k) for k in range(STATES)]

    def ours(tier: Kernels, precision: str) -> Iterator[Matrices]:
        function = getattr(getattr(tier, precision), name)
        return (function(*(y[k].astype(precision) for y in (x.q, x.v, x.given)))
                for k in range(STATES))

    return [worst(ours(kernels, "double"), double, 2.0**-53),
            worst(ours(accurate, "double"), double, 2.0**-53),
            worst((pinocchios(name, x, k) for k in range(STATES)), double, 2.0**-53),
            worst(ours(kernels, "single"), single, 2.0**-24),
            worst(ours(accurate, "single"), single, 2.0**-24)]


def main() -> None:
    """Print the table."""
    rows = []
    for title, file, free in tqdm(ROBOTS):
        robot = paired(scene_of(file, free), model_of(file, free), (INVERSE, FORWARD))
        kernels = kernels_of(robot.functions)
        for place, speed in (AT_HOME, AWAY) if free else (AT_HOME,):
            x = motion(robot, place, speed)
            where = f", {speed:g} m/s at {place:g} m" if place else ""
            rows += [(f"{title}{where}", name.removesuffix("_dynamics_derivatives"),
                      *errors(name, x, kernels)) for name in (INVERSE, FORWARD)]
    print(tabulate(rows, ("robot", "dynamics", "coscrew", "accurate", "Pinocchio", "single",
                          "single, accurate"), floatfmt=".3g"))


if __name__ == "__main__":
    main()
