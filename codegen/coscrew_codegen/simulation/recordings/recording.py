"""Recording: recorded quantities over time.  Frozen data."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Column:
    """One recorded number: its name, as in a scene's `record`, and its unit."""

    name: str  # q.elbow, pose.hand.3
    unit: str
    quantity: str  # q, v, energy, …; columns of the same quantity are plotted together


Provenance = tuple[tuple[str, str], ...]
"""Origin of a recording: pairs (name, value)."""


@dataclass(frozen=True)
class Recording:
    """Columns over time, in the precision of the run; of a batch, with a leading axis."""

    t: np.ndarray  # (n), s, in double
    columns: tuple[Column, ...]
    values: np.ndarray  # (…, n, m)
    provenance: Provenance

    def of(self, name: str) -> np.ndarray:
        """The column of this name."""
        return self.values[..., [c.name for c in self.columns].index(name)]
