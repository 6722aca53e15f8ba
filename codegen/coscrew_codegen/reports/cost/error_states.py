"""States at which rounding errors are measured: of the run, in the ranges that the scene states or
between the joint limits, and the worst of a search there.  All are numbers of single precision, so
that every precision gets the same inputs."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from coscrew_codegen.dynamics.ranges.accuracy_requests import positions, speeds
from coscrew_codegen.simulation.plan import Trajectory
from coscrew_codegen.simulation.system import System

Reals = NDArray[np.float64]
Values = Mapping[str, Reals]
"""t, h (n,), p (n, np), q (n, nq), v, a, tau, phi (n, nv), c (n, trees, 6): inputs of functions."""

BATCH = 2048
"""Number of states that the search compares at once by default."""
_ROUNDS, _KEPT, _NARROWER = 12, 32, 0.6
_REACHED_IN = 0.1  # s: time in which accelerations reach the velocity limits


def joined(parts: Sequence[Values]) -> dict[str, Reals]:
    """Concatenates the states."""
    return {name: np.concatenate([x[name] for x in parts]) for name in parts[0]}


@dataclass(frozen=True)
class Box:
    """Half widths and centres of every number of a state: the scene's ranges, the limits of the
    joints, or ±π rad, 1 m, π rad/s, 1 m/s for joints without limits."""

    system: System
    step: float
    centre: Values
    half: Values

    def drawn(self, rng: np.random.Generator, count: int) -> dict[str, Reals]:
        """Random states, each number evenly distributed."""
        return self._inputs({name: x + self.half[name] * rng.uniform(-1, 1, (count, *x.shape))
                             for name, x in self.centre.items()})

    def near(self, rng: np.random.Generator, values: Values, scale: float, count: int
             ) -> dict[str, Reals]:
        """`count` states near each of these, inside the box."""
        results = {}
        for name in self.centre:
            around = np.repeat(values[name], count, axis=0)
            results[name] = around + scale * self.half[name] * rng.normal(size=around.shape)
        return self._inputs(self._inside(results))

    def of_run(self, trajectory: Trajectory, count: int) -> dict[str, Reals]:
        """States of the run at equal intervals, with random torques and the accelerations that
        these cause."""
        chosen = np.linspace(0, len(trajectory.t) - 1, count).astype(int)
        result = self.drawn(np.random.default_rng(3), count)
        result |= {name: getattr(trajectory, name)[chosen] for name in ("t", "q", "v")}
        result = self._inputs(result)
        result = {**result, "a": self.system.call("forward_dynamics", **result)}
        return self._inputs(self._inside(result) if self.system.scene.ranges else result)

    def _inside(self, values: Values) -> dict[str, Reals]:
        """The nearest states inside the box."""
        return {**values, **{name: np.clip(values[name], x - self.half[name], x + self.half[name])
                             for name, x in self.centre.items()}}

    def _inputs(self, values: Values) -> dict[str, Reals]:
        """The nearest states of single precision, with quaternions of norm 1, and the inputs that
        belong to them: parameters, a step, the motion in it, the momenta of floating trees."""
        its, count = self.system, len(values["t"])
        results = {**values, "q": its.normalized(values["q"]), "h": np.full(count, self.step),
                   "p": np.tile(np.array(its.p, float), (count, 1))}
        points = np.random.default_rng(4).uniform(-1, 1, (count, 3))
        results["r"] = points * its.scene.model.length
        results = {name: _single(x) for name, x in results.items()}
        results["q1"] = np.roll(results["q"], 1, axis=0)
        results["phi"] = _single(results["h"][:, None] * results["v"])
        if its.has("free_momentum"):
            results["c"] = _single(its.call("free_momentum", **results))
        return results


def _single(x: Reals) -> Reals:
    return x.astype(np.float32).astype(float)


def box_of(system: System, until: float, step: float) -> Box:
    """The scene's ranges; where these state nothing, the limits of its joints."""
    joints = {joint.name: joint for joint in system.scene.model.joints}
    q, half_q = np.zeros(system.functions.nq), np.ones(system.functions.nq)
    half_v, effort = np.ones(system.functions.nv), np.full(system.functions.nv, np.nan)
    for c in system.functions.coordinates:
        joint = joints[c.joint]
        half_v[c.v] = speeds(joint)
        effort[c.v] = float(joint.effort) if joint.effort else np.nan
        lower, upper = np.array(positions(joint)).T
        q[c.q], half_q[c.q] = (lower + upper) / 2, (upper - lower) / 2
    half = {"t": np.array(until / 2), "q": half_q, "v": half_v, "a": half_v / _REACHED_IN,
            "tau": effort}
    centre = {"t": np.array(until / 2), "q": q, **{name: np.zeros_like(half_v)
                                                   for name in ("v", "a", "tau")}}
    ends = {name: _stated(system, name, x - half[name], x + half[name])
            for name, x in centre.items()}
    centre = {name: (lower + upper) / 2 for name, (lower, upper) in ends.items()}
    half = {name: (upper - lower) / 2 for name, (lower, upper) in ends.items()}
    some = Box(system, step, centre, {**half, "tau": np.zeros_like(half_v)}).drawn(
        np.random.default_rng(0), 64)
    needed = np.abs(system.call("inverse_dynamics", **some)).max(axis=0, initial=0)
    unknown = np.isnan(half["tau"])
    return Box(system, step, {**centre, "tau": np.where(unknown, 0, centre["tau"])},
               {**half, "tau": np.where(unknown, needed, half["tau"])})


def _stated(system: System, name: str, lower: Reals, upper: Reals) -> tuple[Reals, Reals]:
    """The ends of the intervals that the scene states for an argument; these where it states
    none."""
    ranges = system.scene.ranges
    if ranges is None or name not in ranges.by_name:
        return lower, upper
    stated = np.reshape(ranges.of(name, lower.size), (*lower.shape, 2))
    return (np.where(np.isfinite(stated[..., 0]), stated[..., 0], lower),
            np.where(np.isfinite(stated[..., 1]), stated[..., 1], upper))


def searched(box: Box, score: Callable[[Values], Reals], count: int, batch: int = BATCH
             ) -> dict[str, Reals]:
    """Finds states of large scores by hill climbing from the best of many."""
    rng = np.random.default_rng(1)
    best = box.drawn(rng, batch)
    for number in range(_ROUNDS):
        best = _top(best, score(best), _KEPT)
        near = box.near(rng, best, 0.3 * _NARROWER**number, batch // _KEPT)
        best = joined((best, near))
    return _top(best, score(best), count)


def _top(values: Values, scores: Reals, count: int) -> dict[str, Reals]:
    order = np.argsort(np.where(np.isfinite(scores), scores, -1))[::-1][:count]
    return {name: x[order] for name, x in values.items()}
