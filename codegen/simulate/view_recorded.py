"""What effects record, as charts of a run's page: a chart for each quantity and unit."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from coscrew_codegen.scene.recorded import recorded
from coscrew_codegen.simulate.plan import Trajectory
from coscrew_codegen.simulate.record import quantity
from coscrew_codegen.simulate.system import System

LEFT, RIGHT, TOP, BOTTOM = 8, 632, 10, 150
"""The part of a chart of 640 by 160 in which its lines lie, as in view.js."""
_POINTS = 1500  # of a line


@dataclass(frozen=True)
class Line:
    """A recorded column: the numbers of its chart's line, and its values."""

    name: str
    number: int
    points: str
    values: np.ndarray


@dataclass(frozen=True)
class Chart:
    """Columns of one quantity and unit, and the range of their values."""

    quantity: str
    unit: str
    low: str
    high: str
    lines: tuple[Line, ...]


def charts(system: System, trajectory: Trajectory, frames: np.ndarray) -> tuple[Chart, ...]:
    """The charts of the effects that the scene records, over the frames that are shown."""
    columns: dict[tuple[str, str], dict[str, np.ndarray]] = {}
    for x in (recorded(text, system.scene) for text in system.scene.record):
        if x.of_effect:
            values = np.asarray(quantity(system, trajectory, x), float)[frames]
            for i, (name, unit) in enumerate(zip(x.names, x.units, strict=True)):
                columns.setdefault((x.quantity, unit), {})[name] = values[:, i]
    first, found = 0, []
    for (kind, unit), by_name in columns.items():
        found.append(_chart(kind, unit, by_name, trajectory.t[frames], first))
        first += len(by_name)
    return tuple(found)


def _chart(kind: str, unit: str, columns: dict[str, np.ndarray], t: np.ndarray, first: int
           ) -> Chart:
    finite = [x[np.isfinite(x)] for x in columns.values()]
    low = min((float(x.min()) for x in finite if len(x)), default=0.0)
    high = max((float(x.max()) for x in finite if len(x)), default=0.0)
    lines = tuple(Line(name, first + k, _points(t, x, low, high), x)
                  for k, (name, x) in enumerate(columns.items()))
    return Chart(kind, unit, f"{low:.5g}", f"{high:.5g}", lines)


def _points(t: np.ndarray, values: np.ndarray, low: float, high: float) -> str:
    """The line's points in the chart, without values that are not finite."""
    some: Sequence[int] = np.unique(np.linspace(0, len(t) - 1, min(len(t), _POINTS)).round()
                                    .astype(int)).tolist()
    x = LEFT + (RIGHT - LEFT) * (t / t[-1] if t[-1] > 0 else 0 * t)
    y = BOTTOM - (BOTTOM - TOP) * (values - low) / (high - low if high > low else 1.0)
    return " ".join(f"{x[i]:.1f},{y[i]:.1f}" for i in some if np.isfinite(y[i]))
