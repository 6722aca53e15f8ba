"""Recording: what a run recorded.  Frozen data."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Column:
    """One number that is recorded: its name as in a scene's `record`, and its unit."""

    name: str  # q.elbow, pose.hand.3
    unit: str
    quantity: str  # what it is one of: q, v, energy; columns of one are plotted together


Provenance = tuple[tuple[str, str], ...]
"""Where a recording comes from: (what, its value)."""


@dataclass(frozen=True)
class Recording:
    """Columns over time, in the precision they were computed in."""

    t: np.ndarray  # (n), s, in double
    columns: tuple[Column, ...]
    values: np.ndarray  # (n, m)
    provenance: Provenance

    def of(self, name: str) -> np.ndarray:
        """The column of this name."""
        return self.values[:, [c.name for c in self.columns].index(name)]
