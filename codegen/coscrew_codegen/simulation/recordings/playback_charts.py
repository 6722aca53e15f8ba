"""Charts of a run's page: a chart for each quantity and unit."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import cycle

import numpy as np
from markupsafe import Markup

from coscrew_codegen.backends.html.plots import LINES, themed
from coscrew_codegen.scene.recorded_quantities import recorded
from coscrew_codegen.simulation.plan import Trajectory
from coscrew_codegen.simulation.recordings.record import quantity
from coscrew_codegen.simulation.recordings.recording_plot import chart
from coscrew_codegen.simulation.system import System


@dataclass(frozen=True)
class Chart:
    """Columns of one quantity and unit: their values, colours, and the range of all."""

    quantity: str
    unit: str
    columns: Mapping[str, np.ndarray]
    t: np.ndarray

    @property
    def figure(self) -> Markup:
        """The chart as an element of the page."""
        return chart(self.t, self.columns, f"{self.quantity} in {self.unit} over time")

    @property
    def range(self) -> str:
        """The least and the largest value."""
        finite = np.concatenate([x[np.isfinite(x)] for x in self.columns.values()] or [[]])
        return f"from {finite.min():.5g} to {finite.max():.5g}" if finite.size else "not finite"

    @property
    def names(self) -> list[tuple[str, str]]:
        """The columns' names and colours."""
        return [(name, themed(light)) for name, (light, _) in zip(self.columns, cycle(LINES))]


def charts(system: System, trajectory: Trajectory, frames: np.ndarray) -> Iterator[Chart]:
    """The energies, and the effects that the scene records, over the frames that are shown."""
    t, q, v = (x[frames] for x in (trajectory.t, trajectory.q, trajectory.v))
    kinetic, potential = system.energies(t, q, v)
    yield Chart("energy", "J", {
        "kinetic": kinetic, "potential": potential, "total": kinetic + potential}, t)
    groups: dict[tuple[str, str], dict[str, np.ndarray]] = {}
    for x in (recorded(text, system.scene) for text in system.scene.record):
        if x.of_effect:
            values = np.asarray(quantity(system, trajectory, x), float)[frames]
            for i, (name, unit) in enumerate(zip(x.names, x.units, strict=True)):
                groups.setdefault((x.quantity, unit), {})[name] = values[:, i]
    yield from (Chart(*key, columns, t) for key, columns in groups.items())
