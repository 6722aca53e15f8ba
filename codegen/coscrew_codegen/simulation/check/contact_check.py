"""Contacts of bodies along a run: how deep they get, how often they slip, whether steps resolve
their bounces."""

from dataclasses import dataclass

import numpy as np

from coscrew_codegen.scene.function_selection import ALL_CONTACTS
from coscrew_codegen.scene.functions.steps.step_parts import MOST_OF_CONTACTS
from coscrew_codegen.simulation.plan import Trajectory
from coscrew_codegen.simulation.recordings.record import largest
from coscrew_codegen.simulation.system import System

_SLIPS = 1 - 1e-6
"""Share of mu N from which a contact slips."""


@dataclass(frozen=True)
class ContactsOfRun:
    """The contacts at the samples of a run."""

    depth: float  # the largest, over that at rest
    at: float  # its time, in s
    closed: float  # of a contact and a sample, the share that is closed
    slipping: float  # of those that are closed, the share that slips
    unresolved: float  # the first time of a bounce that no number of parts resolves; NaN: none


def contacts_of(system: System, trajectory: Trajectory, step: float) -> ContactsOfRun | None:
    """The contacts along a trajectory by steps of a length; None if nothing touches."""
    if not system.has(ALL_CONTACTS):
        return None
    t, q, v = trajectory.t, trajectory.q, trajectory.v
    with np.errstate(all="ignore"):
        _, _, depths, shares = (np.asarray(x, float) for x in system.outputs(
            ALL_CONTACTS, t=t, q=q, v=v))
    closed, deepest = depths > 0, depths.max(-1)
    worst = largest(deepest)
    count = max(1, int(np.count_nonzero(closed)))
    slips = int(np.count_nonzero(closed & (shares > _SLIPS))) / count
    return ContactsOfRun(float(deepest[worst]), float(t[worst]), float(closed.mean()), slips,
                         unresolved(system, trajectory, step))


def unresolved(system: System, trajectory: Trajectory, step: float) -> float:
    """The first time at which a step of this length would need more parts than contacts of bodies
    may have; NaN if there is none."""
    if not system.has("parts"):
        return float("nan")
    t, q, v = trajectory.t, trajectory.q, trajectory.v
    with np.errstate(all="ignore"):
        closing = system.call("closing_contacts", h=step, q=q, v=v) > 0
        parts = system.outputs("parts", h=step, q=q, v=v)[0]
    stiff = closing & (parts == MOST_OF_CONTACTS)
    first = np.flatnonzero(stiff.reshape(-1, stiff.shape[-1]).any(0))
    return float(t[first[0]]) if len(first) else float("nan")
