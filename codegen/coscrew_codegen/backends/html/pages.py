"""Pages of chapters: self-contained HTML, and text for a terminal; data as JSON."""

import re
import textwrap
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from markupsafe import Markup
from tabulate import tabulate

from coscrew_codegen.backends.render import render
from coscrew_codegen.program.values.digits import three_digits

if TYPE_CHECKING:  # Matplotlib, which data and tables do without
    from coscrew_codegen.backends.html.plots import Panel


@dataclass(frozen=True)
class Table:
    """Rows of texts under their headers, and sentences about them."""

    headers: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    notes: tuple[str, ...] = ()
    title: str = ""
    texts: int = 1  # columns from the left that hold words

    @staticmethod
    def of(rows: Iterable[Mapping[str, str]], notes: Sequence[str] = (), title: str = "",
           texts: int = 1, columns: Sequence[str] = ()) -> "Table":
        """The table of rows by their headers, in all columns or in these."""
        known = tuple(rows)
        headers = tuple(columns or next(iter(known), ()))
        return Table(headers, tuple(tuple(row[x] for x in headers) for row in known),
                     tuple(notes), title, texts)

    def text(self) -> str:
        """The table as text for a terminal."""
        table = [self._tabulated("simple")] if self.rows else []
        return "\n".join((*table, *map(wrapped, self.notes)))

    def html(self) -> Markup:
        """The rows as an element of a page."""
        return Markup(re.sub("(?<=>) +| +(?=<)", "", self._tabulated("html")))

    def _tabulated(self, style: str) -> str:
        sides = ("left",) * self.texts + ("right",) * (len(self.headers) - self.texts)
        return str(tabulate(self.rows, self.headers, style, disable_numparse=True, colalign=sides))


@dataclass(frozen=True)
class Chapter:
    """A part of a page: sentences, figures, tables.  Tables that are folded can be filtered and
    sorted."""

    title: str
    sentences: tuple[str, ...] = ()
    figures: Sequence["Panel"] = ()
    tables: Sequence[Table] = ()
    folded: bool = False


@dataclass(frozen=True)
class Page:
    """Chapters under a title and sentences; `source` says where the figures come from."""

    title: str
    lead: Sequence[str]
    chapters: Sequence[Chapter]
    source: Iterable[tuple[str, str]] = ()

    def html(self) -> str:
        """The page, in one file."""
        return render("page/page.html", page=self)

    def text(self) -> str:
        """All but titles and chapters of figures, for a terminal."""
        parts = list(map(wrapped, self.lead))
        for x in self.chapters:
            if not x.figures:
                parts += [*map(wrapped, x.sentences), *(table.text() for table in x.tables)]
        return "\n\n".join(parts)


def number(x: float | None) -> str:
    """Three digits; – for None and NaN."""
    return "–" if x is None or x != x else three_digits(x).replace("inf", "∞")


def with_interval(median: float | None, low: float | None, high: float | None) -> str:
    """A median and its interval: 1.39 (1.38–1.41)."""
    return "–" if median is None else f"{number(median)} ({number(low)}–{number(high)})"


def wrapped(text: str) -> str:
    """The text in lines for a terminal."""
    return textwrap.fill(text, 110)
