"""Reference motions: DOP853 at two tolerances, kept in build/ under a hash of their inputs."""

import hashlib
import os
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pinocchio
import scipy
from scipy.integrate import solve_ivp

from tests.support.motions import dynamics, mechanism
from tests.support.motions import errors as of_errors
from tests.support.motions.dynamics import Dynamics
from tests.support.motions.errors import errors
from tests.support.motions.mechanism import Motion

KEPT = Path(__file__).parents[3] / "build" / "motions"
TOLERANCES = (1e-13, 1e-12)
"""Of the judge, and of the integration that must agree with it."""
AGREE = 1e-2
"""Largest difference of the two, of what errors may be."""
_DISTURBED = 1e-4
"""Relative change of the start that tells how sensitive a chaotic motion is."""
_MOST_EVALUATIONS = 6_000_000
SOURCES = (dynamics, mechanism, of_errors, sys.modules[__name__])
"""The modules that compute it."""
PACKAGES = (np, scipy, pinocchio)


class Unjudged(Exception):
    """The reference does not converge."""


@dataclass(frozen=True)
class Reference:
    """States at the times of samples.  (n), (n, nq), (n, nv). `doubt` is the largest difference of
    the two integrations, relative to the allowed error; states after `horizon` mean nothing, since
    a ten-thousandth of the start decides them."""

    t: np.ndarray
    q: np.ndarray
    v: np.ndarray
    doubt: float
    horizon: float


def reference(motion: Motion, times: np.ndarray) -> Reference:
    """The motion at these times.  Raises Unjudged."""
    path = KEPT / f"{_key(motion, times)}.npz"
    if path.exists():
        with np.load(path) as kept:
            return Reference(times, kept["q"], kept["v"], float(kept["doubt"]),
                             float(kept["horizon"]))
    result = _integrated(motion, times)
    path.parent.mkdir(parents=True, exist_ok=True)
    whole = path.with_suffix(f".{os.getpid()}.tmp")
    with whole.open("wb") as file:
        np.savez(file, q=result.q, v=result.v, doubt=result.doubt, horizon=result.horizon)
    whole.replace(path)
    return result


def _key(motion: Motion, times: np.ndarray) -> str:
    """A hash of all that it is computed from: modules, versions of packages, motion and times."""
    result = hashlib.sha256()
    for x in (*(Path(str(x.__file__)).read_bytes() for x in SOURCES),
              *(x.__version__.encode() for x in PACKAGES), repr(motion).encode(), times.tobytes()):
        result.update(hashlib.sha256(x).digest())
    return result.hexdigest()[:32]


def _integrated(motion: Motion, times: np.ndarray) -> Reference:
    its = Dynamics(motion.mechanism)
    start = its.packed(motion.q, motion.v)
    (q, v), coarse = (_states(its, motion, start, times, x) for x in TOLERANCES)
    horizon = np.inf
    if motion.chaotic:
        rng = np.random.default_rng(motion.number)
        other = start * (1 + _DISTURBED * rng.choice((-1, 1), len(start)))
        horizon = _parting(its, motion, times, (q, v), _states(its, motion, other, times,
                                                               TOLERANCES[0]))
    judged = times <= horizon
    result = errors(its, motion, q[judged], v[judged], q[judged], v[judged],
                    *(x[judged] for x in coarse))
    doubt = float(np.max([x.of_allowed for x in result]))
    if not doubt <= AGREE:
        raise Unjudged(f"two tolerances differ by {doubt:.2g} of what is allowed")
    return Reference(times, q, v, doubt, horizon)


def _parting(its: Dynamics, motion: Motion, times: np.ndarray, one: Sequence[np.ndarray],
             other: Sequence[np.ndarray]) -> float:
    """The time until which the disturbed motion stays within what errors may be."""
    for n in range(2, len(times) + 1, max(1, len(times) // 100)):
        result = errors(its, motion, *one, *(x[:n] for x in (*one, *other)))
        if any(x.of_allowed > 1 for x in result):
            return float(times[n - 2])
    return np.inf


def _states(its: Dynamics, motion: Motion, start: np.ndarray, times: np.ndarray, rtol: float
            ) -> tuple[np.ndarray, np.ndarray]:
    nq, count = its.model.nq, 0
    size = np.concatenate((np.ones(nq), np.full(its.model.nv, max(1.0, motion.rate))))

    def rates(t: float, y: np.ndarray) -> np.ndarray:
        nonlocal count
        count += 1
        if count > _MOST_EVALUATIONS:
            raise Unjudged("the reference takes too long")
        return its.rates(t, y)

    done = solve_ivp(rates, (0, times[-1]), start, "DOP853", t_eval=times, rtol=rtol,
                     atol=0.1 * rtol * size, max_step=times[-1] / 50)
    if not done.success:
        raise Unjudged(done.message)
    q = np.array([its.normalized(x) for x in done.y[:nq].T])
    return q, done.y[nq:].T
