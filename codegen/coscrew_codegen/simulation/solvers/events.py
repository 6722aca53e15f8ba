"""Events of effects with states: contacts close or open, bristles slip or hold.

An event is the change of a switch's sign, or the return of a state that has left its bounds, by
more than the tolerances: it must be put back on them where it turns.  After a step of the solver
events are searched on its interpolant: samples bracket the first one, and further samples narrow
the bracket."""

from collections.abc import Callable

import numpy as np

from coscrew_codegen.scene.effect_quantities import states_of
from coscrew_codegen.scene.function_selection import STATE_RATES, SWITCHES
from coscrew_codegen.simulation.system import System

Interpolant = Callable[[np.ndarray], np.ndarray]
"""t -> y.  (n)->(nq + nv, n)."""

_SAMPLES = 24  # of a bracket
_ROUNDS = 10  # most brackets, one within the other: 24^10 is more than the digits of a double
_MANY = 10  # tolerances, by which states return that have left their bounds
_UNCLEAR = 1e-9  # of a switch's largest value: less may have either sign


class Events:
    """The events of a system's effects."""

    def __init__(self, system: System, rtol: float, atol: float):
        self._system, self._rtol, self._atol = system, rtol, atol
        first = system.functions.nq - len(system.functions.states)
        self._states = [slice(first + x.places.start, first + x.places.stop)
                        for x in states_of(system.scene)]

    def first(self, state: Interpolant, start: float, end: float, least: float
              ) -> float | None:
        """The time just after the first event of a step, to within `least`; None if there is none.
        """
        result, first, last = None, start, end
        for _ in range(_ROUNDS):
            bracket = self._narrowed(state, first, last, begins=result is None)
            if bracket is None:
                break
            first, result = bracket
            last = result
            if last - first <= least:
                break
        return result if result is None or result < end else None

    def _narrowed(self, state: Interpolant, start: float, end: float, begins: bool
                  ) -> tuple[float, float] | None:
        """The first two samples between which there is an event."""
        t = np.linspace(start, end, _SAMPLES + 1)
        switches, beyond, least = self._at(t, state(t))
        changes, returns = self._changes(switches, begins), self._returns(beyond, least)
        if not (changes | returns).any():
            return None
        k = int(np.argmax(changes | returns))
        first = k if changes[k] else max(int(np.argmax(beyond[:k + 1].max(-1))) - 1, 0)
        return t[first], t[k + 1]

    def _at(self, t: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The switches, by how much the states of each effect are beyond their bounds, and the
        tolerances of that."""
        system, nq = self._system, self._system.functions.nq
        q, v = system.normalized(y[:nq].T), y[nq:].T
        switches = np.asarray(system.call(SWITCHES, t=t, q=q, v=v), float)
        kept = system.outputs(STATE_RATES, t=t, q=q, v=v)[1]
        sizes = np.stack([np.linalg.norm(q[:, x], axis=-1) for x in self._states], -1)
        beyond = sizes - np.stack([np.linalg.norm(kept[:, x], axis=-1) for x in self._states], -1)
        return switches, beyond, _MANY * (self._atol + self._rtol * sizes)

    @staticmethod
    def _changes(switches: np.ndarray, begins: bool) -> np.ndarray:
        """Between which samples a switch changes its sign.  At the begin of a step, signs of small
        values are unknown."""
        positive = switches > 0
        changes: np.ndarray = positive[1:] != positive[:-1]
        if begins:
            size = np.max(np.abs(switches), 0)
            changes[0] &= np.abs(switches[0]) > _UNCLEAR * size
        return np.asarray(changes.any(-1))

    @staticmethod
    def _returns(beyond: np.ndarray, least: np.ndarray) -> np.ndarray:
        """Between which samples a state that has left its bounds has returned by more than this."""
        back: np.ndarray = beyond < np.maximum.accumulate(beyond) - least
        return np.asarray(back[1:].any(-1))
