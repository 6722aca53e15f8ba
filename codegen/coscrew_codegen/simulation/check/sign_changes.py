"""Counts how often a controller's values change direction from call to call."""

from collections import deque

import numpy as np

_CALLS, _TURNS = 12, 3
"""Number of turns among so many calls that is suspicious.  A torque that is held too long changes
direction at every call if it responds to speed, or at every third or fourth if it responds to
position."""


class Turns:
    """Counts the turns of values, call after call."""

    def __init__(self) -> None:
        self.many = False
        self._last: np.ndarray | None = None
        self._way: np.ndarray | None = None
        self._recent: deque[np.ndarray] = deque(maxlen=_CALLS)

    def add(self, values: np.ndarray) -> None:
        """Adds the values of the next call."""
        if self.many:
            return
        last, self._last = self._last, values
        if last is None:
            return
        way = np.sign(np.nan_to_num(values) - np.nan_to_num(last))
        before = way if self._way is None else self._way
        self._way = np.where(way == 0, before, way)
        self._recent.append(way * before < 0)
        self.many = bool((np.sum(self._recent, axis=0) >= _TURNS).any())
