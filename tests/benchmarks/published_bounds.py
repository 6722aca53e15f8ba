"""Proved bounds of a Panda's inverse dynamics and their derivatives in every number format, beside
those that RoboPrec publishes for |v| <= 0.5 and |a| <= 1, the worst errors found, times here and
instructions on three cores: `--plot FILE.svg` draws those of inverse dynamics."""

import argparse
from collections.abc import Iterator, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

import matplotlib
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from tabulate import tabulate

from coscrew_codegen.backends.html import plots
from coscrew_codegen.reports.cost import cost_measurement
from coscrew_codegen.reports.cost.cost_measurement import Costs
from coscrew_codegen.reports.cost.cost_request import CostRequest
from coscrew_codegen.reports.cost.figures.cost_figure import bounds, shape
from coscrew_codegen.reports.cost.needs.core_costs import CORES, CoreCost
from coscrew_codegen.runtime.load import kernels_for
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation.recordings.recording_writer import delivered
from coscrew_codegen.simulation.result_units import in_unit
from coscrew_codegen.simulation.run_summary import RunOverrides
from tests.support.scenes.fixed_point import PANDA, RANGES

FUNCTIONS = ("inverse_dynamics", "inverse_dynamics_derivatives")
PUBLISHED = {
    ("inverse_dynamics", "double"): 5e-11, ("inverse_dynamics", "single"): 2.5e-2,
    ("inverse_dynamics", "fixed"): 1e-3, ("inverse_dynamics_derivatives", "double"): 5e-4,
    ("inverse_dynamics_derivatives", "single"): 2.6e5}
"""Bounds by function and number format, in N m.  Source: RoboPrec, IEEE RA-L 2025."""
REFUSED = {("inverse_dynamics_derivatives", "fixed")}
"""A function for which it has no bound in a format."""
REQUEST = 2e-5  # N m, of the mixed tier
_PLACES = ("", *CORES)
_SIZE = (6.2, 6.6)  # inches: two panels in a row, letters that a phone shows large enough
_LETTERS = {"font.size": 11, "axes.titlesize": 11.5, "legend.fontsize": 10, "lines.markersize": 7}
_RIVAL = "RoboPrec, the same format"


def scene(folder: Path) -> Scene:
    """The Panda in these ranges, in all tiers."""
    path = folder / "panda.toml"
    path.write_text('tiers = ["fixed", "pairs", "mixed"]\nprecision = "both"\n' + PANDA.read_text()
                    + RANGES + f"\n[accuracy]\ninverse_dynamics = {REQUEST:g}\n")
    return read_scene(path)


def measured(functions: Sequence[str], folder: Path) -> Costs:
    """The costs of these functions."""
    request = CostRequest(tuple(functions))
    its = scene(folder)
    return cost_measurement.measure(kernels_for(its, request.needed(its, None)), RunOverrides(),
                                    request)


def rows(costs: Costs) -> Iterator[tuple[str, ...]]:
    """A line for each function and number format, with the component that has the largest bound."""
    for x in costs.cores:
        key = x.function, x.format
        unit = max(x.bounds, key=lambda unit: x.bounds[unit], default="")
        yield (x.function, x.format, f"{x.bounds[unit]:.1e}" if unit else "",
               "refused" if key in REFUSED else f"{PUBLISHED[key]:.1e}" if key in PUBLISHED else "",
               f"{max(x.worst.values(), default=0):.1e}",
               " and ".join(in_unit(y, unit) for unit, y in x.returned.items()),
               f"{x.time.median:.0f}" if x.time else "",
               *(f"{x.instructions[core]:,}" for core in CORES))


def panel(axes: Axes, costs: Sequence[CoreCost], where: str) -> None:
    """Marks of all formats, each with the published bound above it."""
    bounds(axes, costs, where, named=False)
    for x in costs:
        if (x.function, x.format) in PUBLISHED:
            at = x.instructions[where] if where else x.time.median if x.time else 0
            theirs = PUBLISHED[x.function, x.format]
            axes.plot([at, at], [x.bounds["N m"], theirs], ":", color=plots.QUIET, linewidth=1)
            axes.plot([at], [theirs], "x", color=plots.INK, gid=f"RoboPrec {x.format} {where}")
    axes.relim()
    axes.autoscale_view()
    plots.logarithmic(axes.yaxis)
    axes.set_title(where or "this machine")


@plots.styled
def figure(costs: Sequence[CoreCost]) -> Figure:
    """A panel for this machine and each core, with one legend."""
    with matplotlib.rc_context(_LETTERS):
        made = Figure(figsize=_SIZE, layout="constrained")
        panels = made.subplots(2, 2, sharey=True).flat
        for axes, where in zip(panels, _PLACES, strict=True):
            panel(axes, costs, where)
            axes.set_ylabel("")
        made.supylabel("proved bound, N m", fontsize=11, color=plots.QUIET)
        handles = [Line2D([], [], linestyle="", marker=shape(x), color=plots.COLOURS[x.tier],
                          label=x.format) for x in costs]
        handles.append(Line2D([], [], linestyle="", marker="x", color=plots.INK, label=_RIVAL))
        made.legend(handles=handles, loc="outside lower center", ncols=3)
    return made


def plot(costs: Costs, path: Path) -> None:
    """Draw inverse dynamics to an SVG or PNG.  Raises SimulateError."""
    its = [x for x in costs.cores if x.function == FUNCTIONS[0]]
    with delivered(path) as temporary:
        plots.write(figure(its), temporary, dark=True)


def main(given: Sequence[str] = ()) -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--plot", metavar="FILE", type=Path, help="draw it: .svg or .png")
    parser.add_argument("--function", action="append", choices=FUNCTIONS, default=[])
    options = parser.parse_args(given)
    with TemporaryDirectory() as folder:
        costs = measured(options.function or FUNCTIONS, Path(folder))
    print(tabulate(rows(costs), ("function", "format", "proved", "RoboPrec", "found", "returned",
                                 "ns here", *CORES), disable_numparse=True))
    if options.plot:
        plot(costs, options.plot)


if __name__ == "__main__":
    import sys

    main(sys.argv[1:])
