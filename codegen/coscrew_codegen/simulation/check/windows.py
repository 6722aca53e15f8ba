"""Windows: some steps of a run, repeated with smaller ones; and the way of coordinates."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from coscrew_codegen.program.values.formats import DOUBLE
from coscrew_codegen.scene.integrator import Integrator
from coscrew_codegen.scene.integrators import DEFAULT, INTEGRATOR_NAMED
from coscrew_codegen.scene.joints import KIND_NAMED
from coscrew_codegen.simulation import coordinate_rates
from coscrew_codegen.simulation.check.error_limits import AGREED
from coscrew_codegen.simulation.check.motion_error import Places, StateParts, turned
from coscrew_codegen.simulation.system import State, System

_GRID = (1, 2, 3, 4, 6, 8, 12, 16, 24, 32)  # steps after which motions are compared
_DIVISOR = 4
_POWERS = 5  # of _DIVISOR, by which steps are divided, at most
_SEEN = 0.01  # rad or m: least way whose loss to rounding counts
_KEPT = 16  # windows, at most, that are compared with a run in double precision
_MOST = 4_000_000  # steps of the finest reference motion of a window, of all members together


@dataclass(frozen=True)
class Window:
    """`count` steps of h from q, v at t: as the run takes them, and with smaller steps."""

    parts: StateParts
    integrator: str
    t: float
    h: float
    q: np.ndarray
    v: np.ndarray
    count: int

    @cached_property
    def grid(self) -> tuple[int, ...]:
        """The numbers of steps after which motions are compared."""
        return (*(n for n in _GRID if n < self.count), self.count)

    @cached_property
    def run(self) -> tuple[State, ...]:
        """The states of the run's own steps, on the grid."""
        return self._taken(self.parts.system, self.integrator, 1)

    @cached_property
    def places(self) -> tuple[tuple[float, Places], ...]:
        """(time since its start, places of the parts) on the grid, of the finer motion."""
        return tuple((n * self.h, self.parts.places(q))
                     for n, (q, _) in zip(self.grid, self._finer, strict=True))

    @cached_property
    def _finer(self) -> tuple[State, ...]:
        return self._taken(self.parts.system, DEFAULT, _DIVISOR)

    def errors(self, allowed: np.ndarray) -> np.ndarray:
        """The largest errors of the parts.  Errors beyond the allowed one are computed again with
        ever smaller steps in double precision, until two motions agree.  If that takes too long for
        all members, evenly spread ones are computed, and each other one gets the errors of the
        nearest of these.  (…, k)."""
        result = self._apart(self.run, self._finer)
        if (result <= allowed).all():
            return result
        bad = ~(result <= allowed).all(-1)
        if not bad.ndim:
            return self._resolved(allowed)
        members = np.flatnonzero(bad)
        most = max(1, _MOST // (self.count * _DIVISOR**_POWERS))
        chosen = members[np.unique(np.linspace(0, len(members) - 1, most).round().astype(int))]
        one = StateParts(self.parts.system.member(chosen))
        resolved = replace(self, parts=one, q=self.q[chosen], v=self.v[chosen])._resolved(
            allowed[chosen])
        nearest = np.abs(members[:, None] - chosen).argmin(-1)
        result[members] = resolved[nearest]
        return result

    def _resolved(self, allowed: np.ndarray) -> np.ndarray:
        """The errors, from a motion that smaller steps do not change."""
        exact = in_double(self.parts.system)
        other = StateParts(exact)
        before = self._finer
        result = self._apart(self.run, before)
        for power in range(2, _POWERS + 1):
            finer = self._taken(exact, DEFAULT, _DIVISOR**power)
            result, change = self._apart(self.run, finer), self._apart(before, finer, other)
            if (change <= AGREED * allowed).all():
                break
            before = finer
        return result

    def _apart(self, x: tuple[State, ...], y: tuple[State, ...], parts: StateParts | None = None
               ) -> np.ndarray:
        its = parts or self.parts
        each = [its.distances(its.places(a), its.places(b))
                for (a, _), (b, _) in zip(x, y, strict=True)]
        result: np.ndarray = np.max(each, axis=0)
        return result

    def _taken(self, system: System, integrator: str, finer: int) -> tuple[State, ...]:
        """The states on the grid, with steps smaller by `finer`."""
        step, h = system.stepper(INTEGRATOR_NAMED[integrator].step_name), self.h / finer
        q, v, done, result = self.q.astype(system.dtype), self.v.astype(system.dtype), 0, []
        for n in self.grid:
            q, v = step((n - done) * finer, self.t + done * self.h, h, q, v)
            done = n
            result.append((q, v))
        return tuple(result)


def in_double(system: System) -> System:
    """The system in double precision, compiled if necessary."""
    if system.precision is DOUBLE or system.origin is None:
        return system
    if DOUBLE.name in system.origin.interface.precisions and \
            DOUBLE.name in system.origin.precisions:
        return replace(system, kernels=system.origin.double, precision=DOUBLE)
    from coscrew_codegen.runtime.load import kernels_for

    both = replace(system.scene, precisions=(DOUBLE.name,))
    kernels = kernels_for(both, system.origin.selected or tuple(system.inputs))
    return replace(system, kernels=kernels.double, precision=DOUBLE, origin=kernels,
                   functions=kernels.interface)


class Way:
    """The change of coordinates in windows of a run, and the integral of their velocities: for
    angles, lengths and positions, and for rotations about the three axes of the body."""

    def __init__(self, system: System, integrator: Integrator):
        self._system = system
        its = system.functions.coordinates
        kept = integrator.keeps_momentum and system.has("free_momentum")
        self._vectors = [
            (c.joint, slice(c.v[v].start, c.v[v].stop), kind.floats and v.start == 0 and kept)
            for c in its for kind in [KIND_NAMED[c.kind]] for _, _, v in kind.q_parts]
        self._integrator = integrator
        self._made = self._lost = self._near = np.zeros(1)
        self._seen: list[tuple[float, State]] = []  # the times and states of some windows
        self._steps, self._h = 0, 0.0

    def add(self, window: Window, steps: int) -> None:
        """Adds a window, which represents so many steps."""
        if self._system.precision is DOUBLE or not self._vectors:
            return
        before, done, made, gone = (window.q, window.v), 0, np.zeros(1), np.zeros(1)
        for n, state in zip(window.grid, window.run, strict=True):
            rates = self._rates(*before) + self._rates(*state)
            made = made + (n - done) * window.h / 2 * rates
            gone = gone + self._moved(before[0], state[0])
            before, done = state, n
        self._h, share = self._h or window.h, steps / window.count
        self._made = self._made + share * np.abs(made)
        self._lost = self._lost + share * (made - gone) * np.sign(made)
        self._near = np.fmax(self._near, self._numbers(window.q))
        self._seen.append((window.t, (window.q, window.v)))
        if len(self._seen) > _KEPT:
            del self._seen[1:-1:2]
        self._steps += steps

    def frozen(self, allowed: float) -> dict[tuple[int, ...], tuple[str, float, float]]:
        """Returns (joint, lost share of its way, its coordinate) by member, where the loss exceeds
        the allowed one and rounding explains it, and a run in double precision comes elsewhere."""
        losses = self._lost
        if any(coarse.any() for *_, coarse in self._coarse(allowed, losses)):
            losses = np.where(self._missed > allowed * _SEEN, losses, 0)
        results: dict[tuple[int, ...], tuple[str, float, float]] = {}
        for joint, place, lost, way, coarse in self._coarse(allowed, losses):
            for i in map(tuple, np.argwhere(coarse).tolist()):
                results.setdefault(i, (joint, float(lost[i] / way[i]),
                                       float(self._near[i][place].max())))
        return results

    def _coarse(self, allowed: float, losses: np.ndarray
                ) -> Iterator[tuple[str, slice, np.ndarray, np.ndarray, np.ndarray]]:
        """(joint, its places, lost way, way, whether too much is lost)."""
        spacing = np.spacing(self._near.astype(self._system.dtype)).astype(float)
        for joint, place, kept in self._vectors if self._steps else ():
            lost, way, least = (np.linalg.norm(x[..., place], axis=-1)
                                for x in (losses, self._made, spacing))
            way = np.maximum(way, _SEEN)
            yield (joint, place, lost, way,
                   (lost > allowed * way) & (lost < self._steps * least) & (not kept))

    @property
    def _missed(self) -> np.ndarray:
        """The largest distances from a run in double precision.  They are small where forces
        balance between two numbers: there single precision keeps a velocity that leads nowhere."""
        exact, ((t, start), *others) = in_double(self._system), self._seen
        step, missed = exact.stepper(self._integrator.step_name), np.zeros(1)
        q, v = (x.astype(exact.dtype) for x in start)
        for at, (seen, _) in others:
            if count := round((at - t) / self._h):
                q, v = step(count, t, (at - t) / count, q, v)
                missed, t = np.fmax(missed, np.abs(self._moved(q, seen))), at
        return missed

    def _rates(self, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """The rates of angles, lengths and positions; for rotations the angular velocity in the
        body's frame."""
        results = []
        for c in self._system.functions.coordinates:
            x, own = (y[..., places].astype(float) for y, places in ((q, c.q), (v, c.v)))
            rates = coordinate_rates.rates(c.kind, x, x, own)
            results += [own[..., speeds] if part.quaternion else rates[..., places]
                        for part, places, speeds in KIND_NAMED[c.kind].q_parts]
        return np.concatenate(results, -1)

    def _moved(self, before: np.ndarray, after: np.ndarray) -> np.ndarray:
        """The differences of angles, lengths and positions; of rotations the rotation vector."""
        results = []
        for c in self._system.functions.coordinates:
            x, y = (q[..., c.q].astype(float) for q in (before, after))
            results += [turned(x[..., places], y[..., places]) if part.quaternion else
                        y[..., places] - x[..., places]
                        for part, places, _ in KIND_NAMED[c.kind].q_parts]
        return np.concatenate(results, -1)

    def _numbers(self, q: np.ndarray) -> np.ndarray:
        """The sizes of the coordinates; for rotations 2, since the angle is twice that of the
        quaternion, whose numbers are up to 1."""
        results = []
        for c in self._system.functions.coordinates:
            own = np.abs(q[..., c.q].astype(float))
            results += [np.full((*own.shape[:-1], 3), 2.0) if part.quaternion else own[..., places]
                        for part, places, _ in KIND_NAMED[c.kind].q_parts]
        return np.concatenate(results, -1)


def remedy_of_rounding(system: System) -> str:
    """Returns a remedy for coordinates that do not move."""
    return "take --precision double" if system.precision is not DOUBLE else \
        "place the scene nearer to the world's origin"
