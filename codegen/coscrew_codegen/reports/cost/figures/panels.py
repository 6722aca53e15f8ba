"""Panels of a figure: a function's errors against its times, in every tier and precision."""

from collections.abc import Iterator, Sequence

from matplotlib.axes import Axes
from matplotlib.figure import FigureBase
from matplotlib.lines import Line2D

from coscrew_codegen.accuracy.tiers import OF_SCENES
from coscrew_codegen.backends.html.plots import INK, QUIET, Mark, name_beside, place, scatter
from coscrew_codegen.program.values.digits import three_digits
from coscrew_codegen.program.values.formats import BY_NAME, PRECISIONS
from coscrew_codegen.reports.cost.function_errors import FunctionErrors
from coscrew_codegen.reports.cost.needs.need import Need
from coscrew_codegen.reports.cost.recommendations import recommended, undominated
from coscrew_codegen.simulation.result_units import in_unit, written

_COLOURS = {tier.name: tier.colours[0] for tier in OF_SCENES}
_RING = 11  # points across


def panel(axes: Axes, rows: Sequence[FunctionErrors], number: int = 0,
          needs: Sequence[Need] = ()) -> None:
    """Draws a mark for each tier and precision at the worst error, or bound if it is certified, in
    the function's unit of this number; a line from the typical error; a ring around the recommended
    choice; a line at each request."""
    best, unit, choice = undominated(rows), rows[0].errors[number].unit, recommended(rows)
    axes.set(xlabel="ns per call in C", title=rows[0].function,
             ylabel="error" if unit == "1" else f"error, {written(unit)}")
    for need in needs:
        if need.function == choice.function and need.concerns(unit):
            axes.axhline(need.within, color=INK, linestyle="--", linewidth=1, gid=f"{need} line")
            name_beside(axes, (0, need.within), f"needed: {need.named((unit,))}",
                        axes.get_yaxis_transform())
    scatter(axes, [Mark(f"{x.function} {x.name}", x.time.median, x.time.low, x.time.high,
                        shown(x, number), _COLOURS[x.tier], BY_NAME[x.precision].marker,
                        x not in best, in_unit(shown(x, number), unit) if shown(x, number) else "",
                        x.errors[number].typical)
                   for x in rows])
    at, transform = place(axes, shown(choice, number))
    axes.plot([choice.time.median], [at], "o", color=QUIET, markersize=_RING, clip_on=False,
              markerfacecolor="none", transform=transform, gid=f"{choice.function} recommended")


def titles(rows: Sequence[FunctionErrors], number: int) -> Iterator[tuple[str, str]]:
    """The marks' names and values, as titles."""
    for x in rows:
        errors = x.errors[number]
        yield f"{x.function} {x.name}", (
            f"{x.name}: {'bound' if errors.bounds else 'error'} "
            f"{in_unit(shown(x, number), errors.unit)}, typically an error of "
            f"{in_unit(errors.typical, errors.unit)}, {three_digits(x.time.median)} ns")


def shown(x: FunctionErrors, number: int = 0) -> float:
    """The number of a mark: the worst error, or the largest bound of a certified function."""
    errors = x.errors[number]
    return errors.bounds.worst if errors.bounds else errors.worst


def legend(figure: FigureBase, rows: Sequence[FunctionErrors]) -> None:
    """Draws the legend of the marks, above all panels."""
    handles = [_handle(name, "o", _COLOURS[name]) for name in dict.fromkeys(x.tier for x in rows)]
    handles += [_handle(p.name, p.marker, QUIET) for p in PRECISIONS]
    ring = _handle("recommended", "o", QUIET)
    ring.set(markersize=_RING, markerfacecolor="none")
    handles.append(ring)
    figure.legend(handles=handles, loc="outside upper left", ncols=len(handles),
                  title="worst error, of certified functions the largest bound; lines start at the "
                        "typical error; hollow: another is faster and as accurate",
                  title_fontsize=8, alignment="left")


def _handle(label: str, marker: str, colour: str) -> Line2D:
    return Line2D([], [], marker=marker, linestyle="", color=colour, label=label)
