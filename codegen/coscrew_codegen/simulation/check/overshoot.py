"""Finds controllers whose torques change too fast for the interval of their calls.

Between two calls, T apart, a controller's torques are held.  On a joint whose acceleration answers
its own torque with w = (M^-1)_ii, a law with slopes d = -du/dv and k = -du/dq overshoots if T d w >
1 or T sqrt(k w) > 1. After the end of a run whose torques changed direction from call to call, d
and k are computed from differences of the law's values at states of the run, w from differences of
accelerations."""

from collections.abc import Iterator
from dataclasses import dataclass
from math import floor, log10

import numpy as np

from coscrew_codegen.scene.mechanism.model import Joint
from coscrew_codegen.scene.recorded_quantities import coordinates
from coscrew_codegen.simulation.control import EFFORT, Controller
from coscrew_codegen.simulation.controlled_run import Driven
from coscrew_codegen.simulation.plan import Plan, Trajectory
from coscrew_codegen.simulation.system import System

_DIFFERENCE = {"float64": 1e-6, "float32": 1e-3}  # of q and v, relative where they are above 1


@dataclass(frozen=True)
class _Torque:
    """A torque that the controller sets: its place among the values, and its joint's places."""

    place: int
    joint: Joint
    q: int
    v: int


@dataclass(frozen=True)
class _Share:
    """The slope of a controller at a joint, relative to the largest without overshooting."""

    of_period: float  # T d w, or T sqrt(k w)
    slope: float  # d, or k
    joint: Joint
    what: str  # speed, or position


class _UnknownError(Exception):
    """A controller's values at other states cannot be determined."""


_UNITS = {("speed", True): "N m s/rad", ("speed", False): "N s/m",
          ("position", True): "N m/rad", ("position", False): "N/m"}
"""Units of slopes, by the quantity that they respond to and whether the joint turns."""


def too_fast(controller: Controller, driven: Driven, system: System, plan: Plan, run: Trajectory
             ) -> str:
    """Returns a warning that names the joint at which the controller overshoots most, and a remedy.
    It is "" if the controller overshoots nowhere, or if this cannot be determined: it returns
    different values for the same state, raises an error, or has a context in C, which further calls
    may change.  A law in Python whose torques did not change direction from call to call needs no
    further calls."""
    if controller.context is not None or run.interrupted or not driven.turned:
        return ""
    with np.errstate(all="ignore"):
        try:
            shares = tuple(_shares(driven, system, run, plan.step * controller.steps))
        except _UnknownError:
            return ""
    share = max(shares, key=lambda x: x.of_period, default=None)
    return _words(plan.step, controller.steps, share) if share and share.of_period > 1 else ""


def _words(step: float, every: int, share: _Share) -> str:
    longest = step * every / share.of_period
    steps = floor(longest / step)
    helps = f"steps={steps}" if steps else f"step={_rounded_down(longest):g}"
    if not steps and every > 1:
        helps = f"steps=1 and {helps}"
    unit = _UNITS[share.what, not share.joint.kind.slides]
    name = share.joint.name
    return (f"controller: at joint {name} it answers {share.what} with {share.slope:.3g} {unit}, "
            f"and is called every {step * every:.3g} s: its torque, held between calls, overshoots "
            f"if that is longer than {longest:.2g} s; wanted {helps}, or "
            f'[effects.actuator.{name}] kind = "pd", which steps take implicitly')


def _rounded_down(x: float) -> float:
    """The number with one digit, not above it: 4e-4 for 4.7e-4."""
    size = 10.0**floor(log10(x))
    return floor(x / size) * size


def _shares(driven: Driven, system: System, run: Trajectory, period: float) -> Iterator[_Share]:
    """Yields a share of each torque that the controller sets, at the first sample, the middle one
    and the last."""
    count = run.q.shape[-2]
    for k in sorted({0, count // 2, count - 1}):
        t, q, v = float(run.t[k]), run.q[..., k, :], run.v[..., k, :]
        if not (np.isfinite(q).all() and np.isfinite(v).all()):
            continue
        for x in _torques(system, driven.names):
            w = _response(system, x, t, q, v)
            d, stiffness = _slopes(driven, x, t, q, v)
            yield _share(period * d * w, d, x.joint, "speed")
            yield _share(period * np.sqrt(np.maximum(stiffness * w, 0)), stiffness, x.joint,
                         "position")


def _share(of_period: np.ndarray, slope: np.ndarray, joint: Joint, what: str) -> _Share:
    """The largest share among the members."""
    at = np.unravel_index(int(np.argmax(np.nan_to_num(of_period, nan=-1))), of_period.shape)
    return _Share(float(of_period[at]), float(slope[at]), joint, what)


def _torques(system: System, names: tuple[str, ...]) -> Iterator[_Torque]:
    """The torques of actuators among the parameters that a controller sets."""
    joints = {joint.name: (joint, q, v) for joint, q, v in coordinates(system.scene)}
    for place, name in enumerate(names):
        on = name.removeprefix("actuator.").removesuffix(EFFORT)
        if name == f"actuator.{on}{EFFORT}" and on in joints:
            joint, q, v = joints[on]
            yield _Torque(place, joint, q.start, v.start)


def _response(system: System, torque: _Torque, t: float, q: np.ndarray, v: np.ndarray
              ) -> np.ndarray:
    """(M^-1)_ii: the acceleration of a joint per unit of its own torque."""
    def pushed(by: np.ndarray) -> np.ndarray:
        tau = by[..., None] * np.eye(v.shape[-1])[torque.v]
        a = system.call("forward_dynamics", t=t, q=q, v=v, tau=tau)
        return np.asarray(a[..., torque.v], float)

    free = pushed(np.zeros(q.shape[:-1]))
    by = size = 1 + np.abs(free)
    for _ in range(2):  # the second adds about as much as there is, so that little is rounded away
        result: np.ndarray = (pushed(by) - free) / by
        by = size / result
    return result


def _slopes(driven: Driven, torque: _Torque, t: float, q: np.ndarray, v: np.ndarray
            ) -> tuple[np.ndarray, np.ndarray]:
    """-du/dv and -du/dq.  Raises _UnknownError if the law raises an error at states for which it
    was not called before, or returns different values for the same state."""
    def answer(at_q: np.ndarray, at_v: np.ndarray) -> np.ndarray:
        try:
            return driven.demanded(t, at_q, at_v)[..., torque.place].astype(float)
        except Exception as error:
            raise _UnknownError from error

    first = answer(q, v)
    further_q, dq = _beside(q, torque.q)
    further_v, dv = _beside(v, torque.v)
    of_q, of_v = answer(further_q, v), answer(q, further_v)
    if not np.array_equal(answer(q, v), first):
        raise _UnknownError("a law with a memory")
    return (first - of_v) / dv, (first - of_q) / dq


def _beside(x: np.ndarray, place: int) -> tuple[np.ndarray, np.ndarray]:
    """The states with a slightly larger number in this place, and the difference."""
    result, difference = x.copy(), _DIFFERENCE[x.dtype.name]
    result[..., place] += x.dtype.type(difference) * np.maximum(1, np.abs(x[..., place]))
    return result, (result - x)[..., place].astype(float)
