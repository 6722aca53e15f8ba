"""Contacts of bodies along a run: how deep they get, how often they slip, whether steps resolve
their bounces."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from coscrew_codegen.program.values.parameter import Parameter, Scalar
from coscrew_codegen.scene.function_selection import ALL_CONTACTS
from coscrew_codegen.scene.functions.steps.step_parts import MOST_OF_CONTACTS
from coscrew_codegen.scene.scene import Applied
from coscrew_codegen.simulation.plan import Trajectory
from coscrew_codegen.simulation.recordings.record import largest
from coscrew_codegen.simulation.system import System

_SLIPS = 1 - 1e-6
"""Share of mu N from which a contact slips."""
_RADII = ("radius", "first_radius", "second_radius")
_ROUNDED = 64
"""Roundoffs of the largest force that a normal force below zero may have."""


@dataclass(frozen=True)
class ContactOfRun:
    """One contact at the samples of a run; depths are over that at rest."""

    name: str
    depth: float  # the largest
    at: float  # its time, in s
    ends: float  # depth at the end
    closed: float  # share of samples at which it is closed
    slipping: float  # share of these at which it slips
    through: float  # depth of its radius; infinite if it has none


@dataclass(frozen=True)
class ContactsOfRun:
    """The contacts at the samples of a run."""

    each: tuple[ContactOfRun, ...]
    unresolved: float  # the first time of a bounce that no number of parts resolves; NaN: none
    least: float  # normal force, over the largest force
    pulls_at: float  # its time, in s
    allowed: float  # the least that it may be

    @property
    def closed(self) -> float:
        """The share of contacts and samples that are closed."""
        return sum(x.closed for x in self.each) / len(self.each)

    @property
    def slipping(self) -> float:
        """The share of these that slip."""
        closed = sum(x.closed for x in self.each)
        return sum(x.slipping * x.closed for x in self.each) / closed if closed else 0.0

    @property
    def through(self) -> ContactOfRun | None:
        """A contact that gets deeper than its radius; None if there is none."""
        return next((x for x in self.each if x.depth >= x.through), None)

    @property
    def passed(self) -> bool:
        """True if all contacts push, and none gets deeper than its radius."""
        return self.least >= self.allowed and not self.through


def touching(system: System) -> list[Applied]:
    """The contacts of a scene, in the order of the function's results."""
    return [x for x in system.scene.effects if x.effect.parts or x.effect.bodies_force]


def depths_through(system: System) -> np.ndarray:
    """The depth, over that at rest, at which each contact is as deep as the smallest of its radii;
    infinite for points.  (…, contacts)."""
    return np.stack(np.broadcast_arrays(*(
        np.min(np.stack(np.broadcast_arrays(np.inf, *_numbers(system, x, _RADII))), 0)
        / next(_numbers(system, x, ("depth",))) for x in touching(system))), -1)


def _numbers(system: System, contact: Applied, names: Sequence[str]) -> Iterator[np.ndarray]:
    """The numbers of these names that a contact has, with the system's parameters."""
    for x in (contact.values.get(name) for name in names):
        if isinstance(x, Parameter):
            yield np.asarray(system.p, float)[..., x.index]
        elif isinstance(x, Scalar):
            yield np.asarray(float(x))


def sinks(name: str, at: float) -> str:
    """A sentence on a contact that is deeper than its radius."""
    return (f"{name} is deeper than its radius at t = {at:.9g} s: its load is far below what "
            "presses on it; give it load in N, or k")


def contacts_of(system: System, trajectory: Trajectory, step: float) -> ContactsOfRun | None:
    """The contacts along a trajectory by steps of a length; None if nothing touches."""
    if not system.has(ALL_CONTACTS):
        return None
    t, q, v = trajectory.t, trajectory.q, trajectory.v
    with np.errstate(all="ignore"):
        _, forces, depths, shares, normals = (np.asarray(x, float) for x in system.outputs(
            ALL_CONTACTS, t=t, q=q, v=v))
    pushes = (forces * normals).sum(-1).min(-1)
    pulls, largest_force = int(np.argmin(pushes)), float(np.abs(forces).max())
    closed = depths > 0
    slips = closed & (shares > _SLIPS)
    each = tuple(ContactOfRun(x.name, float(depths[(worst := largest(depths[:, i])), i]),
                              float(t[worst]), float(depths[-1, i]), float(closed[:, i].mean()),
                              float(slips[:, i].sum() / max(1, closed[:, i].sum())), float(through))
                 for i, (x, through) in enumerate(zip(touching(system), depths_through(system),
                                                      strict=True)))
    return ContactsOfRun(each, unresolved(system, trajectory, step),
                         float(pushes[pulls]) / (largest_force or 1.0), float(t[pulls]),
                         -_ROUNDED * float(np.finfo(system.dtype).eps))


def point_distances(double: tuple[System, Trajectory], single: tuple[System, Trajectory]
                    ) -> tuple[float, ...]:
    """The largest distance between the points of each contact in both precisions, while it is
    closed in both, in m."""
    if not double[0].has(ALL_CONTACTS):
        return ()
    n = min(len(x.t) for _, x in (double, single))
    with np.errstate(all="ignore"):
        points, depths = zip(*(
            [np.asarray(x[k], float) for k in (0, 2)] for x in (
                its.outputs(ALL_CONTACTS, t=run.t[:n], q=run.q[:n], v=run.v[:n])
                for its, run in (double, single))), strict=True)
        ways = np.linalg.norm(points[0] - points[1], axis=-1)
    both = (depths[0] > 0) & (depths[1] > 0)
    return tuple(np.where(both, ways, 0.0).max(0).tolist())


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
