"""Calibration of certified bounds: parts of a function's outputs by bound / error, as a row of a
table and as a curve of a figure."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter
from numpy.typing import NDArray

from coscrew_codegen.backends.html import plots
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.simulation.recordings.recording_writer import delivered

FACTORS = (1.00001, 1.001, 1.01, 1.1, 2)
_LEAST = 1e-8  # bound / error - 1 where curves begin
_POINTS = 40  # of a curve, in each decade


@dataclass(frozen=True)
class Calibration:
    """Bound / error of the outputs of a function that have an error."""

    robot: str
    function: str
    precision: Precision
    ratios: NDArray[np.float64]

    def percent(self, factor: float) -> float:
        """The part of the outputs whose bound is at most so many times the error."""
        return 100 * float(np.mean(self.ratios <= factor))

    @property
    def row(self) -> tuple[object, ...]:
        """Its line of the table."""
        return (self.robot, self.function, self.precision.name, self.ratios.size,
                *(f"{self.percent(x):.3f}" for x in FACTORS), f"{self.ratios.max():.4g}")


def plot(results: Sequence[Calibration], path: Path) -> None:
    """Draw the curves to an SVG, a panel a robot.  Raises SimulateError."""
    with delivered(path) as temporary:
        plots.write(figure(results), temporary)


@plots.styled
def figure(calibrations: Sequence[Calibration]) -> Figure:
    """Percent against bound / error, whose distance from 1 is on a logarithmic axis."""
    robots = list(dict.fromkeys(x.robot for x in calibrations))
    functions = list(dict.fromkeys(x.function for x in calibrations))
    largest = max(float(x.ratios.max()) for x in calibrations) - 1
    end = math.ceil(math.log10(max(largest, 1)))
    steps = np.logspace(math.log10(_LEAST), end, round(_POINTS * (end - math.log10(_LEAST))) + 1)
    figure = Figure(figsize=(4.5 * len(robots), 4.2), layout="constrained")
    panels = figure.subplots(1, len(robots), sharey=True, squeeze=False)[0]
    for axes, robot in zip(panels, robots, strict=True):
        axes.set_title(robot)
        for x in calibrations:
            if x.robot == robot:
                axes.plot(steps, [x.percent(1 + step) for step in steps], x.precision.dash,
                          color=f"C{functions.index(x.function)}", linewidth=1.5,
                          gid=f"{robot} {x.function} {x.precision.name}")
        _axes(axes)
    panels[0].set_ylabel("outputs with at most this bound / error, %")
    for n, function in enumerate(functions):
        panels[0].plot((), (), color=f"C{n}", label=function.replace("_", " "))
    for precision in PRECISIONS:
        panels[0].plot((), (), precision.dash, color=plots.QUIET, label=precision.name)
    figure.legend(loc="outside lower center", ncols=len(functions) + len(PRECISIONS))
    return figure


def _axes(axes: Axes) -> None:
    axes.set_xscale("log")
    axes.set_ylim(0, 103)
    axes.xaxis.set_major_locator(LogLocator(base=100, numticks=9))
    axes.xaxis.set_minor_locator(LogLocator(numticks=99))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda x, _: f"{1 + x:.9g}"))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.set_xlabel("bound / error")
