"""Panels of a figure: a function's errors against its times, in every tier and precision."""

import math
from collections.abc import Sequence

from matplotlib.axes import Axes
from matplotlib.figure import FigureBase
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter
from matplotlib.transforms import Transform

from coscrew_codegen.cost.accuracy import Accuracy
from coscrew_codegen.cost.advice import recommended, undominated
from coscrew_codegen.cost.labels import Label, label
from coscrew_codegen.formats import BY_NAME, PRECISIONS
from coscrew_codegen.simulate.units import in_unit, written
from coscrew_codegen.tiers import OF_SCENES

_COLOURS = {tier.name: tier.colours[0] for tier in OF_SCENES}
_QUIET = "#5b6475"
_RING = 11  # points across


def panel(axes: Axes, rows: Sequence[Accuracy]) -> None:
    """A mark for each tier and precision at the worst error, or bound if it is certified, in the
    function's first unit; a line from the typical error."""
    unit, best = rows[0].errors[0].unit, undominated(rows)
    places = [_mark(axes, x, x in best) for x in rows]
    _ring(axes, recommended(rows))
    axes.set_xscale("log")
    if any(0 < shown(x) < math.inf for x in rows):
        axes.set_yscale("log")
    else:
        axes.set_yticks([])
    axes.margins(x=0.25, y=0.1)
    axes.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda ns, _: f"{ns:g}"))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.set_xlabel("ns per call in C")
    axes.set_ylabel("error" if unit == "1" else f"error, {written(unit)}")
    axes.set_title(rows[0].function)
    label(axes, [Label(in_unit(shown(x), unit), *place)
                 for x, place in zip(rows, places, strict=True)], _QUIET)


def _ring(axes: Axes, x: Accuracy) -> None:
    """Around the choice that is recommended."""
    if shown(x) > 0:
        axes.plot([x.time.median], [shown(x)], "o", color=_QUIET, markersize=_RING,
                  markerfacecolor="none", gid=f"{x.function} recommended")


def _mark(axes: Axes, x: Accuracy, best: bool) -> tuple[float, float, float, Transform]:
    """The mark; returns where it and the foot of its line stand."""
    colour, name = _COLOURS[x.tier], f"{x.function} {x.name}"
    y = shown(x)
    # Zero is drawn at the lower edge of the axes, infinity at the upper one.
    drawn = 0 < y < math.inf
    at, transform = (y, axes.transData) if drawn else (float(y > 0), axes.get_xaxis_transform())
    typical = x.errors[0].typical
    foot = typical if drawn and typical > 0 else at
    if foot != at:
        axes.plot([x.time.median] * 2, [typical, y], color=colour, linewidth=1, alpha=0.6)
    axes.plot([x.time.low, x.time.high], [at, at], "|-", color=colour, linewidth=1.2,
              transform=transform, clip_on=False, gid=f"{name} interval")
    axes.plot([x.time.median], [at], BY_NAME[x.precision].marker, color=colour, clip_on=False,
              transform=transform, markerfacecolor=colour if best else "white", gid=name)
    return x.time.median, at, foot, transform


def shown(x: Accuracy) -> float:
    """What a mark shows: the worst error, or the largest bound of a certified function."""
    errors = x.errors[0]
    return errors.bounds.worst if errors.bounds else errors.worst


def legend(figure: FigureBase, rows: Sequence[Accuracy]) -> None:
    """What these marks mean, above all panels."""
    tiers = dict.fromkeys(x.tier for x in rows)
    handles = [Line2D([], [], marker="o", linestyle="", color=_COLOURS[name], label=name)
               for name in tiers]
    handles += [Line2D([], [], marker=p.marker, linestyle="", color=_QUIET, label=p.name)
                for p in PRECISIONS]
    handles.append(Line2D([], [], marker="o", linestyle="", color=_QUIET, markersize=_RING,
                          markerfacecolor="none", label="recommended"))
    figure.legend(handles=handles, loc="outside upper left", ncols=len(handles), frameon=False,
                  title="worst error, of certified functions the largest bound; lines start at the "
                        "typical error; hollow: another is faster and as accurate",
                  title_fontsize=8, alignment="left")
