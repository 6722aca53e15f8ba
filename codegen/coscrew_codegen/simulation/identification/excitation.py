"""Motions that excite an arm: sums of harmonics whose weighted regressor is well conditioned.

Each joint moves by q = centre + Σ a_k cos(k ω t) + b_k sin(k ω t), ω = 2π/duration, so that the
motion repeats; velocity and acceleration are zero at its start.  It is scaled into the joints'
ranges and velocities, and keeps within their efforts as far as the scene's own parameters tell."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi

import numpy as np
from numpy.typing import NDArray

from coscrew_codegen.dynamics.ranges.accuracy_requests import positions, speeds
from coscrew_codegen.scene.mechanism.model import Joint
from coscrew_codegen.simulation.identification.arm_regressor import ArmRegressor

Reals = NDArray[np.float64]
ROOM = 0.9
"""The part of ranges, velocities and efforts that a motion may use."""
DRAWN, SEARCHED = 64, 40
"""Random motions, and steps that improve the best of them."""
_NOTHING = 1e-15
"""The rounding error of the smallest eigenvalue, as a part of the largest."""
SAMPLES = 8
"""At which the condition is computed, for each harmonic."""


@dataclass(frozen=True)
class Excitation:
    """A motion (n states of all joints), the condition of its regressor, and that of the median of
    random motions."""

    t: Reals
    q: Reals
    v: Reals
    a: Reals
    condition: float
    usual: float


@dataclass(frozen=True)
class Harmonics:
    """Sums of harmonics for an arm: coefficients to states."""

    arm: ArmRegressor
    count: int
    duration: float

    def states(self, coefficients: Reals, t: Reals) -> tuple[Reals, Reals, Reals]:
        """(q, v, a) at these times, scaled into the joints' limits."""
        a, b = self._resting(coefficients)
        k = np.arange(1, self.count + 1)[:, None]
        w = 2 * pi / self.duration * k
        cosine, sine = np.cos(w * t), np.sin(w * t)
        q = a @ cosine + b @ sine
        v = -(a * w.T) @ sine + (b * w.T) @ cosine
        acceleration = -(a * w.T**2) @ cosine - (b * w.T**2) @ sine
        centre, half, fastest = self._limits
        shift = (q.max(1) + q.min(1)) / 2
        scale = np.minimum(half / np.maximum(np.ptp(q, axis=1) / 2, 1e-9),
                           fastest / np.maximum(np.abs(v).max(1), 1e-9))
        return ((centre[:, None] + scale[:, None] * (q - shift[:, None])).T,
                (scale[:, None] * v).T, (scale[:, None] * acceleration).T)

    def _resting(self, coefficients: Reals) -> tuple[Reals, Reals]:
        """a and b with v = 0 and v' = 0 at t = 0: Σ k b = 0, Σ k² a = 0."""
        a, b = coefficients.reshape(2, -1, self.count)
        k = np.arange(1.0, self.count + 1)
        return (a - np.outer(a @ k**2, k**2) / (k**2 @ k**2), b - np.outer(b @ k, k) / (k @ k))

    @property
    def _limits(self) -> tuple[Reals, Reals, Reals]:
        """(centre, half of the range, largest velocity) of each joint."""
        ends = np.array([positions(joint)[0] for joint in self._joints])
        fastest = np.array([speeds(joint)[0] for joint in self._joints])
        return ends.mean(1), ROOM * np.ptp(ends, axis=1) / 2, ROOM * fastest

    @property
    def _joints(self) -> Sequence[Joint]:
        joints = {x.name: x for x in self.arm.scene.model.joints}
        return [joints[c.joint] for c in self.arm.coordinates]

    def condition(self, coefficients: Reals) -> tuple[float, float]:
        """(condition of the regressor with columns of length 1, the largest part of an effort)."""
        t = np.linspace(0, self.duration, SAMPLES * self.count, endpoint=False)
        Y, rest = self.arm.at(t, *self.states(coefficients, t))
        tau = Y @ self.arm.beta + rest
        A = (Y / np.maximum(np.abs(tau).max(0), 1e-9)[:, None]).reshape(-1, Y.shape[2])
        lengths = np.linalg.norm(A, axis=0)
        A = A / np.where(lengths, lengths, 1)
        least, *_, most = np.linalg.eigvalsh(A.T @ A)  # ten times as fast as singular values
        efforts = np.array([float(x.effort or np.inf) for x in self._joints])
        condition = float(np.sqrt(most / max(least, _NOTHING * most)))
        return condition, float((np.abs(tau).max(0) / efforts).max())

    def cost(self, coefficients: Reals) -> float:
        """ln of the condition, and a penalty for torques beyond the efforts."""
        condition, effort = self.condition(coefficients)
        return float(np.log(condition)) + 10 * max(0.0, effort / ROOM - 1)


def exciting(arm: ArmRegressor, duration: float, rate: float, count: int) -> Excitation:
    """The best motion of a search that is the same each time."""
    from scipy.optimize import minimize

    harmonics, nv = Harmonics(arm, count, duration), len(arm.coordinates)
    rng = np.random.default_rng(0)
    drawn = [rng.normal(size=2 * nv * count) for _ in range(DRAWN)]
    best = min(drawn, key=harmonics.cost)
    result = minimize(harmonics.cost, best, method="L-BFGS-B", options={"maxiter": SEARCHED})
    t = np.arange(round(duration * rate)) / rate
    q, v, a = harmonics.states(result.x, t)
    usual = float(np.median([harmonics.condition(x)[0] for x in drawn]))
    return Excitation(t, q, v, a, harmonics.condition(result.x)[0], usual)
