"""Errors of a motion: each part against its own amplitude, in the frame of the centre of mass."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import pinocchio as pin

from tests.support.motions.dynamics import Dynamics, Place
from tests.support.motions.mechanism import Motion

FLOOR = 1e-3
"""The least amplitude in rad, and in typical lengths of the scene: 5 % of it is rest."""


@dataclass(frozen=True)
class Error:
    """The largest error of a part's coordinates and velocities, relative to their amplitudes."""

    part: str
    q: float
    v: float

    @property
    def of_allowed(self) -> float:
        """Error relative to the allowed one; at most 1 if the motion is right."""
        return float(np.maximum(self.q / ALLOWED.q, self.v / ALLOWED.v))  # NaN if one is


ALLOWED = Error("any", 0.01, 0.05)
"""Errors up to which a motion is right."""
WRONG = 0.05
"""The error of coordinates above which it is wrong."""


def judged(results: tuple[Error, ...]) -> str:
    """right, between or wrong."""
    if not all(x.q <= WRONG for x in results):
        return "wrong"
    return "right" if all(x.of_allowed <= 1 for x in results) else "between"


def errors(its: Dynamics, motion: Motion, whole_q: np.ndarray, whole_v: np.ndarray,
           q: np.ndarray, v: np.ndarray, came_q: np.ndarray, came_v: np.ndarray
           ) -> tuple[Error, ...]:
    """The error of each part of the states that came, against q and v at the same times;
    amplitudes are those of the whole reference.  All (n, nq), (n, nv)."""
    if not (np.isfinite(came_q).all() and np.isfinite(came_v).all()):
        return (Error("all", np.inf, np.inf),)
    with np.errstate(over="ignore", invalid="ignore"):
        return tuple(_of_parts(its, motion, (whole_q, whole_v), (q, v), (came_q, came_v)))


States = tuple[np.ndarray, np.ndarray]


def _of_parts(its: Dynamics, motion: Motion, whole: States, true: States, came: States
              ) -> Iterator[Error]:
    floating = [p for p in its.places if p.joint.kind == "free"]
    if motion.pair:
        whole, true, came = (_about_centre(its, motion, x) for x in (whole, true, came))
    for p in its.places:
        name, unit = p.joint.name, motion.length if p.joint.kind == "prismatic" else 1.0
        if p.joint.kind in ("free", "spherical"):
            turn = slice(p.q.stop - 4, p.q.stop)
            amplitude = np.max(_angle(whole[0][:, turn], whole[0][:1, turn]))
            off = np.max(_angle(true[0][:, turn], came[0][:, turn]))
            w = slice(p.v.stop - 3, p.v.stop)
        else:
            amplitude = np.max(np.abs(whole[0][:, p.q] - whole[0][:1, p.q]))
            off, w = np.max(np.abs(true[0][:, p.q] - came[0][:, p.q])), p.v
        yield Error(name, _relative(off, amplitude, unit), _of_speeds(
            whole[1][:, w], true[1][:, w], came[1][:, w], unit * motion.rate))
    for p in floating:
        at = [_centres(its, p, *x) for x in (whole, true, came)]
        amplitude = np.max(_norm(at[0][0] - at[0][0][:1]))
        yield Error(f"{p.joint.name}'s centre of mass", _relative(
            np.max(_norm(at[1][0] - at[2][0])), amplitude, motion.length), _of_speeds(
            at[0][1], at[1][1], at[2][1], motion.length * motion.rate))


def _about_centre(its: Dynamics, motion: Motion, states: States) -> States:
    """Coordinates and velocities of a pair less those of its centre of mass."""
    q, v = (np.array(x) for x in states)
    at = {p.joint.name: p for p in its.places}
    masses = np.array([mass for _, mass in motion.pair])
    for x, places in ((q, [at[name].q.start for name, _ in motion.pair]),
                      (v, [at[name].v.start for name, _ in motion.pair])):
        x[:, places] -= (x[:, places] @ masses / masses.sum())[:, None]
    return q, v


def _relative(off: float, amplitude: float, unit: float) -> float:
    return float(off / max(amplitude, FLOOR * unit))


def _of_speeds(whole: np.ndarray, true: np.ndarray, came: np.ndarray, unit: float) -> float:
    return _relative(np.max(_norm(true - came)), np.max(_norm(whole)), unit)


def _norm(x: np.ndarray) -> np.ndarray:
    return np.linalg.norm(x, axis=-1)


def _angle(p: np.ndarray, q: np.ndarray) -> np.ndarray:
    """The angle of the rotation between quaternions."""
    return 4 * np.arcsin(np.minimum(1, np.minimum(_norm(p - q), _norm(p + q)) / 2))


def _centres(its: Dynamics, base: Place, q: np.ndarray, v: np.ndarray) -> States:
    """Position and velocity of the centre of mass of the tree that a free joint carries."""
    places, speeds = np.empty((len(q), 3)), np.empty((len(q), 3))
    for n, (x, u) in enumerate(zip(q, v, strict=True)):
        pin.centerOfMass(its.model, its.data, x, u)
        # subtrees' centres are in the frame of their joint
        at = its.data.oMi[base.number]
        places[n] = at.act(its.data.com[base.number])
        speeds[n] = at.rotation @ its.data.vcom[base.number]
    return places, speeds
