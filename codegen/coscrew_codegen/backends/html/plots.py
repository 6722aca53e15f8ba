"""Figures: how all look, marks of errors against times, and the way into files and pages."""

import io
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from math import inf, isnan
from pathlib import Path
from xml.etree import ElementTree

import matplotlib
from cycler import cycler
from markupsafe import Markup
from matplotlib import RcParams
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.text import Text
from matplotlib.ticker import Formatter, LogLocator, NullFormatter
from matplotlib.transforms import Transform

from coscrew_codegen.accuracy.tiers import OF_SCENES, TIERS
from coscrew_codegen.program.values.digits import three_digits

LINES = (("#0072b2", "#56b4e9"), ("#c2570c", "#f5a04d"), ("#00805d", "#3ccf9f"),
         ("#b0307a", "#ee7fbb"), ("#6a51a3", "#a99be0"), ("#7a6a00", "#cdbb3f"),
         ("#8c564b", "#d0a394"), ("#17789c", "#6fd3e8"), ("#b3261e", "#ff8a80"),
         ("#4d5563", "#c3cad5"))
"""Colours of lines that stand for nothing else, on a light and on a dark ground."""

THEME = tuple(dict.fromkeys((*LINES, *(tier.colours for tier in (*TIERS, *OF_SCENES)))))
"""Colours that are others on a dark ground."""

INK, QUIET, _RULE, _EDGE, _CARD = "#1d2330", "#5b6475", "#e3e6eb", "#9aa2b1", "#ffffff"
STYLE = RcParams({
    "svg.hashsalt": "coscrew", "svg.fonttype": "path", "font.family": "DejaVu Sans",
    "font.size": 9, "axes.spines.top": False, "axes.spines.right": False,
    "axes.grid": True, "grid.color": _RULE, "axes.edgecolor": _EDGE, "text.color": INK,
    "axes.labelcolor": QUIET, "xtick.color": QUIET, "ytick.color": QUIET, "axes.titlesize": 10,
    "axes.axisbelow": True, "axes.titlelocation": "left", "legend.frameon": False,
    "axes.prop_cycle": cycler(color=[light for light, _ in LINES])})
"""Text as paths, so that it looks alike everywhere; ids from a fixed salt."""

PANEL = (4.6, 3.4)
"""Inches of a figure that stands alone in a page: as wide as a phone."""

_IN_PAGES = {INK: "--ink", QUIET: "--quiet", _RULE: "--rule", _EDGE: "--quiet", _CARD: "--card"}
_SVG, _LINK = "http://www.w3.org/2000/svg", "http://www.w3.org/1999/xlink"
_AUTOMATIC = re.compile(r"[a-z0-9]+_\d+|[a-z]+")  # ids of artists without a name: line2d_3
_REPRODUCIBLE = {".svg": {"Date": None, "Creator": None}, ".png": {"Software": None}}
_PLACES = tuple((dx * side, dy, ("right", "center", "left")[side + 1])
                for dx, dy in ((9, 0), (0, 11), (0, -11), (9, 10), (9, -10), (9, 21), (9, -21),
                               (9, 32), (9, -32)) for side in ((1, -1) if dx else (0,)))
_SPARE = 1.5  # px around a label: a browser's letters may be wider

styled = matplotlib.rc_context(STYLE)
"""Decorates functions that draw."""


@dataclass(frozen=True)
class Mark:
    """An error against a time, with the interval of the time."""

    name: str  # its id
    x: float
    low: float
    high: float
    y: float
    colour: str
    shape: str
    hollow: bool = False  # another is better
    label: str = ""
    foot: float = 0.0  # of a line from below, 0 without


@dataclass(frozen=True)
class Panel:
    """A drawing on one pair of axes: its label, the function that draws it, the texts at artists by
    their ids, and its inches alone on a page."""

    label: str
    draw: Callable[[Axes], None]
    titles: Mapping[str, str] = field(default_factory=dict)
    size: tuple[float, float] = PANEL

    @property
    def alone(self) -> Figure:
        """The panel as a figure, higher by the rows of a long legend."""
        with matplotlib.rc_context(STYLE):
            figure = Figure(figsize=self.size, layout="constrained")
            self.draw(axes := figure.subplots())
            if legend := axes.get_legend():
                figure.set_figheight(self.size[1] + 0.08 * len(legend.get_texts()))
            place_labels(figure)
        return figure

    @property
    def inline(self) -> Markup:
        """The panel as an element of a page."""
        with matplotlib.rc_context(STYLE):
            return inline(self.alone, self.label, self.titles)


@styled
def write(figure: Figure, path: Path) -> None:
    """Write an SVG or PNG, the same bytes for the same figure."""
    figure.savefig(path, metadata=_REPRODUCIBLE[path.suffix])


@styled
def svg(figure: Figure, letters: str = "path", ground: bool = True) -> str:
    """The figure's SVG, its letters as paths or none, on a ground or transparent."""
    text = io.StringIO()
    with matplotlib.rc_context({"svg.fonttype": letters}):
        figure.savefig(text, format="svg", metadata=_REPRODUCIBLE[".svg"], transparent=not ground)
    return text.getvalue()


def inline(figure: Figure, label: str, titles: Mapping[str, str] | None = None) -> Markup:
    """The figure as an element of a page, in the page's colours and font; `titles` are shown at
    the artists with these ids."""
    _fit_labels(figure)
    ElementTree.register_namespace("", _SVG)
    ElementTree.register_namespace("xlink", _LINK)
    root = ElementTree.fromstring(svg(figure, "none", ground=False))
    for data in root.findall(f"{{{_SVG}}}metadata"):
        root.remove(data)
    root.attrib = {"viewBox": root.attrib["viewBox"], "role": "img", "aria-label": label}
    for node in root.iter(f"{{{_SVG}}}g"):
        name = node.attrib.pop("id", "")
        if name and not _AUTOMATIC.fullmatch(name):
            node.set("data-artist", name)
        if name in (titles or {}):
            node.set("data-mark", name)
            title = ElementTree.Element(f"{{{_SVG}}}title")
            title.text = (titles or {})[name]
            node.insert(0, title)
    own = re.sub(r"\W+", "-", label)
    text = ElementTree.tostring(root, "unicode")
    text = re.sub(r'(\bid="|href="#|url\(#)', rf"\g<1>{own}-", text)
    return Markup(re.sub(r"(?<=: )#[0-9a-f]{6}\b", lambda colour: themed(colour[0]), text))


def _fit_labels(figure: Figure) -> None:
    """Shrink titles and labels that are longer than the figure, down to what can still be read."""
    figure.draw_without_rendering()
    whole = figure.bbox.padded(1)
    for axes in figure.axes:
        titles = [x for x in axes.get_children() if isinstance(x, Text)]
        for text in (*titles, axes.xaxis.label, axes.yaxis.label):
            while text.get_text() and float(text.get_fontsize()) > 4 and not all(
                    whole.contains(*corner) for corner in text.get_window_extent().corners()):
                text.set_fontsize(0.9 * float(text.get_fontsize()))


def themed(colour: str) -> str:
    """The colour in a page, on a ground that is light or dark."""
    return f"var({_IN_PAGES.get(colour, f'--{colour[1:]}, {colour}')})"


def escaped(name: str) -> str:
    """The name with characters escaped that Matplotlib reads as mathematics."""
    return name.replace("$", r"\$")


class _Alike(Formatter):
    """All numbers of an axis with powers of ten, if one needs it."""

    def __call__(self, x: float, pos: int | None = None) -> str:
        return three_digits(x)

    def format_ticks(self, values: Sequence[float]) -> list[str]:
        """The texts of all ticks."""
        if not any("e" in three_digits(x) for x in values):
            return [three_digits(x) for x in values]
        parts = (f"{x:.2e}".split("e") for x in values)
        return [f"{float(mantissa):g}e{int(exponent)}" for mantissa, exponent in parts]


def logarithmic(axis: Axis) -> None:
    """Ticks at 1, 2 and 5 times powers of ten, or at powers of ten, in few digits."""
    axes = axis.axes
    (axes.set_xscale if axis is axes.xaxis else axes.set_yscale)("log")
    low, high = sorted(axis.get_view_interval())
    axis.set_major_locator(LogLocator(subs=(1, 2, 5) if high < 100 * low else (1,)))
    axis.set_major_formatter(_Alike())
    axis.set_minor_formatter(NullFormatter())


def legend_below(axes: Axes, title: str | None = None) -> None:
    """The legend, where a phone has room."""
    axes.legend(loc="upper left", bbox_to_anchor=(-0.1, -0.16), ncols=2, fontsize=8, title=title,
                title_fontsize=8, alignment="left")


def scatter(axes: Axes, marks: Sequence[Mark]) -> None:
    """Marks on logarithmic axes; those of no number are left out."""
    drawn = [x for x in marks if not isnan(x.x) and not isnan(x.y)]
    for x in drawn:
        _mark(axes, x, *place(axes, x.y))
    axes.margins(x=0.25, y=0.15)
    if any(0 < x.y < inf for x in drawn):
        logarithmic(axes.yaxis)
    else:
        axes.set_yticks([])
    for value in (0.0, inf):
        if any(x.y == value for x in drawn):
            axes.annotate("∞" if value else "0", (0, place(axes, value)[0]), (-4, 0),
                          xycoords="axes fraction",
                          textcoords="offset points", ha="right", va="center", color=QUIET)
    if drawn:
        logarithmic(axes.xaxis)


def place(axes: Axes, y: float) -> tuple[float, Transform]:
    """Returns the place of this error on the axes: zero is near their lower edge, infinity near
    their upper one."""
    return (y, axes.transData) if 0 < y < inf else (
        0.95 if y > 0 else 0.05, axes.get_xaxis_transform())


def _mark(axes: Axes, x: Mark, at: float, transform: Transform) -> None:
    if x.foot > 0 and 0 < x.y < inf:
        axes.plot([x.x] * 2, [x.foot, x.y], color=x.colour, linewidth=1, alpha=0.6,
                  gid=f"{x.name} foot")
    axes.plot([x.low, x.high], [at, at], "|-", color=x.colour, linewidth=1.2, clip_on=False,
              transform=transform, gid=f"{x.name} interval")
    axes.plot([x.x], [at], x.shape, color=x.colour, clip_on=False, transform=transform,
              markerfacecolor=_CARD if x.hollow else x.colour, gid=x.name)
    if x.label:
        name_beside(axes, (x.x, at), x.label, transform)


def name_beside(axes: Axes, at: tuple[float, float], text: str, transform: Transform) -> None:
    """Write a label that place_labels moves to where there is room."""
    axes.annotate(text, at, _PLACES[0][:2], xycoords=transform, fontsize=7.5, color=QUIET,
                  textcoords="offset points", va="center").set_in_layout(False)


def place_labels(figure: Figure) -> None:
    """Move each label to the first place where it meets no mark and no label; hide it if there is
    none: pages show its number at the mark, too."""
    figure.draw_without_rendering()
    for axes in figure.axes:
        taken = [x.get_window_extent().padded(1) for x in axes.lines if x.get_gid()]
        for text in axes.texts:
            if text.get_in_layout():
                continue
            for dx, dy, side in _PLACES:
                text.set(position=(dx, dy), ha=side)
                box = text.get_window_extent().padded(_SPARE)
                inside = axes.bbox.x0 <= box.x0 and box.x1 <= axes.bbox.x1 + 4
                if inside and not box.count_overlaps(taken):
                    taken.append(box)
                    break
            else:
                text.set_visible(False)
