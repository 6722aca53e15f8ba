"""Panel of a figure: the errors of a run over time, by cause."""

import numpy as np
from matplotlib.axes import Axes

from coscrew_codegen.accuracy.tiers import OF_SCENES, PLAIN
from coscrew_codegen.backends.html.plots import INK, legend_below, logarithmic
from coscrew_codegen.program.values.formats import BY_NAME
from coscrew_codegen.reports.cost.run_errors import RunError, RunErrors

_COLOURS = {tier.name: tier.colours[0] for tier in OF_SCENES}


def panel(axes: Axes, errors: RunErrors) -> None:
    """Draws a curve for each cause; a cross where no digit is left."""
    for n, x in enumerate(errors.rows):
        _curve(axes, x, errors.times, f"C{n}")
    logarithmic(axes.yaxis)
    axes.set(xlim=(0, errors.times[-1]), xlabel="t, s", ylabel="error of a coordinate, m or rad",
             title=f"errors of the run: {errors.integrator}, step {errors.step:g} s")
    legend_below(axes, "×: no digit is right from here on")


def _curve(axes: Axes, x: RunError, times: tuple[float, ...], other: str) -> None:
    """Draws one curve; effects have other colours than tiers and the step, and dots."""
    precision, _, tier = x.of.partition(" ") if x.cause == "rounding" else ("", "", "")
    if tier:
        colour, dash, width = _COLOURS[tier], BY_NAME[precision].dash, 1.2
    else:
        colour, dash, width = (INK, "-", 1.8) if x.cause == "step" else (other, ":", 1.2)
    errors = np.array(x.errors)
    errors[~np.isfinite(errors) | (errors == 0)] = np.nan
    name = f"{x.cause}: {x.of}"
    below = tier and tier != PLAIN.name  # where it coincides with plain's
    axes.plot(times, errors, dash, color=colour, linewidth=3 if below else width, label=name,
              alpha=0.5 if below else 1, zorder=1.9 if below else 2, gid=name)
    if x.gone is not None:
        n = times.index(x.gone)
        axes.plot([x.gone], [errors[n]], "x", color=colour, markersize=6, gid=f"{name} gone")
