"""Figures: how all look, marks of errors against times, and the way into files and pages."""

import io
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
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
from matplotlib.lines import Line2D
from matplotlib.ticker import LogLocator, NullFormatter

from coscrew_codegen.accuracy.tiers import OF_SCENES, TIERS
from coscrew_codegen.program.values.formats import PRECISIONS

LINES = (("#0072b2", "#56b4e9"), ("#c2570c", "#f5a04d"), ("#00805d", "#3ccf9f"),
         ("#b0307a", "#ee7fbb"), ("#6a51a3", "#a99be0"), ("#7a6a00", "#cdbb3f"),
         ("#8c564b", "#d0a394"), ("#17789c", "#6fd3e8"), ("#b3261e", "#ff8a80"),
         ("#4d5563", "#c3cad5"))
"""Colours of lines that stand for nothing else, on a light and on a dark ground."""

COLOURS = {tier.name: tier.colours[0] for tier in (*TIERS, *OF_SCENES)}
"""Colours of tiers on a light ground."""

INK, QUIET, EDGE, _RULE, _CARD = "#1d2330", "#5b6475", "#9aa2b1", "#e3e6eb", "#ffffff"
STYLE = RcParams({
    "svg.hashsalt": "coscrew", "svg.fonttype": "path", "font.family": "DejaVu Sans",
    "font.size": 9, "axes.spines.top": False, "axes.spines.right": False,
    "axes.grid": True, "grid.color": _RULE, "axes.edgecolor": EDGE, "text.color": INK,
    "axes.labelcolor": QUIET, "xtick.color": QUIET, "ytick.color": QUIET, "axes.titlesize": 10,
    "axes.axisbelow": True, "axes.titlelocation": "left", "legend.frameon": False,
    "legend.fontsize": 8, "legend.title_fontsize": 8, "lines.markersize": 5,
    "text.parse_math": False, "savefig.bbox": "tight",
    "axes.prop_cycle": cycler(color=[light for light, _ in LINES])})
"""Text as paths, so that it looks alike everywhere; ids from a fixed salt."""

_PAIRS = (*LINES, *(tier.colours for tier in (*TIERS, *OF_SCENES)))
_DARK = {INK: "#e7eaf0", QUIET: "#a0a9b8", EDGE: "#a0a9b8", _RULE: "#313947", _CARD: "#1a1f27",
         **dict(_PAIRS)}
"""Colours on a dark ground, by those on a light one."""
_IN_PAGES = {INK: "var(--ink)", QUIET: "var(--quiet)", EDGE: "var(--quiet)", _RULE: "var(--rule)",
             _CARD: "var(--card)", **{x: f"light-dark({x}, {dark})" for x, dark in _PAIRS}}
_SIZE = (4.1, 3.2)  # inches of a panel: three stand in a row of a wide page, one on a phone
_SVG, _LINK = "http://www.w3.org/2000/svg", "http://www.w3.org/1999/xlink"
_REPRODUCIBLE = {".svg": dict.fromkeys(("Date", "Creator", "Format", "Type")),
                 ".png": {"Software": None}}
_PLACES = tuple((dx * side, dy, ("right", "center", "left")[side + 1])
                for dx, dy in ((9, 0), (0, 11), (0, -11), (9, 10), (9, -10), (9, 21), (9, -21),
                               (9, 32), (9, -32)) for side in ((1, -1) if dx else (0,)))
_RING = "recommended"
_SPARE = 1.5  # px around a label: a browser's letters may be wider

styled = matplotlib.rc_context(STYLE)
"""Decorates functions that draw."""


@dataclass(frozen=True)
class Panel:
    """A drawing on one pair of axes: its label, and the function that draws it."""

    label: str
    draw: Callable[[Axes], None]

    @property
    @styled
    def inline(self) -> Markup:
        """The panel as an element of a page, in the page's colours and font; artists with an id and
        a label have it as their title."""
        figure = drawn((self,))
        titles = {x.get_gid(): str(x.get_label()) for x in figure.findobj() if x.get_gid()}
        ElementTree.register_namespace("", _SVG)
        ElementTree.register_namespace("xlink", _LINK)
        root = ElementTree.fromstring(svg(figure, "none", ground=False))
        root.attrib = {"viewBox": root.attrib["viewBox"], "role": "img", "aria-label": self.label}
        for node in root.iter(f"{{{_SVG}}}g"):
            name = node.attrib.pop("id", "")
            if name in titles:
                node.set("data-artist", name)
                if not titles[name].startswith("_"):
                    ElementTree.SubElement(node, f"{{{_SVG}}}title").text = titles[name]
        text = ElementTree.tostring(root, "unicode")
        text = re.sub(r'(\bid="|href="#|url\(#)', rf"\g<1>{slug(self.label)}-", text)
        return Markup(re.sub(r"(?<=: )#[0-9a-f]{6}\b", lambda x: _IN_PAGES.get(x[0], x[0]), text))


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
    ring: bool = False  # it is recommended
    label: str = ""
    title: str = ""  # shown by pages at the mark
    foot: float = 0.0  # of a line from below, 0 without


@styled
def drawn(panels: Sequence[Panel], across: int = 4) -> Figure:
    """A figure of the panels, so many in a row, higher by the rows of long legends."""
    across = min(across, len(panels))
    down, (width, height) = -(-len(panels) // across), _SIZE
    figure = Figure(layout="constrained")
    for n, panel in enumerate(panels, 1):
        panel.draw(figure.add_subplot(down, across, n))
    legends = [len(x.get_texts()) for axes in figure.axes if (x := axes.get_legend())]
    figure.set_size_inches(width * across, (height + 0.08 * max(legends, default=0)) * down)
    place_labels(figure)
    return figure


@styled
def write(figure: Figure, path: Path, dark: bool = False) -> None:
    """Write an SVG or PNG, the same bytes for the same figure; `dark` gives an SVG a dark ground
    where the reader's system prefers that."""
    if not dark or path.suffix != ".svg":
        figure.savefig(path, metadata=_REPRODUCIBLE[path.suffix])
        return
    rules = " ".join(f'[style*="{x}: {light}"] {{ {x}: {other} !important }}'
                     for light, other in _DARK.items() for x in ("fill", "stroke"))
    path.write_text(svg(figure).replace(
        "</style>", f" @media (prefers-color-scheme: dark) {{ {rules} }}</style>", 1), "utf-8")


@styled
def svg(figure: Figure, letters: str = "path", ground: bool = True) -> str:
    """The figure's SVG, its letters as paths or none, on a ground or transparent."""
    text = io.StringIO()
    with matplotlib.rc_context({"svg.fonttype": letters}):
        figure.savefig(text, format="svg", metadata=_REPRODUCIBLE[".svg"], transparent=not ground)
    return text.getvalue()


def slug(text: str) -> str:
    """The text as a name in addresses: letters, digits, hyphens."""
    return re.sub(r"\W+", "-", text).strip("-").lower()


def logarithmic(axis: Axis) -> None:
    """Ticks at 1, 2 and 5 times powers of ten, or at powers of ten, in few digits; all with powers
    of ten, if one needs it."""
    axes = axis.axes
    (axes.set_xscale if axis is axes.xaxis else axes.set_yscale)("log")
    low, high = sorted(axis.get_view_interval())
    axis.set_major_locator(LogLocator(subs=(1, 2, 5) if high < 100 * low else (1,)))
    short = low > 5e-5 and high < 1e6
    axis.set_major_formatter(lambda x, _: f"{x:g}" if short else re.sub(
        r"e([+-])0?", lambda sign: f"e{sign[1].strip('+')}", f"{x:.0e}"))
    axis.set_minor_formatter(NullFormatter())


def legend_below(axes: Axes, title: str | None = None, handles: Sequence[Line2D] = (),
                 columns: int = 2) -> None:
    """The legend of the handles, or of all labels, where a phone has room."""
    axes.legend(handles=handles or axes.get_legend_handles_labels()[0], loc="upper left",
                bbox_to_anchor=(-0.1, -0.16), ncols=columns, title=title, alignment="left")


def scatter(axes: Axes, marks: Sequence[Mark]) -> None:
    """Marks on logarithmic axes: zero is below and infinity above all other errors; those of no
    number are left out."""
    shown = [x for x in marks if not isnan(x.x) and not isnan(x.y)]
    known = [x.y for x in shown if 0 < x.y < inf] or [1.0]
    for x in shown:
        _mark(axes, x, min(max(x.y, min(known) / 10), 10 * max(known)))
    axes.margins(x=0.25, y=0.15)
    for axis in (axes.xaxis, axes.yaxis) if shown else ():
        logarithmic(axis)


def _mark(axes: Axes, x: Mark, y: float) -> None:
    if x.foot > 0 and y == x.y:
        axes.plot([x.x] * 2, [x.foot, y], color=x.colour, linewidth=1, alpha=0.6,
                  gid=f"{x.name} foot")
    axes.plot([x.low, x.high], [y, y], "|-", color=x.colour, linewidth=1.2,
              gid=f"{x.name} interval")
    axes.plot([x.x], [y], x.shape, color=x.colour, gid=x.name, label=x.title or "_",
              markerfacecolor=_CARD if x.hollow else x.colour)
    if x.ring:
        axes.plot([x.x], [y], "o", color=QUIET, markersize=11, markerfacecolor="none",
                  label=_RING, gid=f"{x.name} {_RING}")
    if label := x.label or {0.0: "0", inf: "∞"}.get(x.y):
        name_beside(axes, (x.x, y), label)


def tier_legend(axes: Axes, tiers: Iterable[str]) -> None:
    """The legend of marks: colours of tiers, shapes of precisions, a ring."""
    looks = [(x, "o", COLOURS[x]) for x in dict.fromkeys(tiers)]
    looks += [(x.name, x.marker, QUIET) for x in PRECISIONS]
    handles = [Line2D([], [], linestyle="", label=x, marker=y, color=z) for x, y, z in looks]
    handles += [x for x in axes.lines if x.get_label() == _RING]
    legend_below(axes, "hollow: another is faster and as accurate", handles, 3)


def name_beside(axes: Axes, at: tuple[float, float], text: str, across: str = "data") -> None:
    """Write a label that place_labels moves to where there is room."""
    axes.annotate(text, at, _PLACES[0][:2], (across, "data"), "offset points", fontsize=7.5,
                  color=QUIET, va="center").set_in_layout(False)


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
