"""Self-contained pages: their frame, data as JSON, tables."""

import html
import json
import re
import textwrap
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from math import isfinite

from markupsafe import Markup
from tabulate import tabulate

from coscrew_codegen.backends.render import render

Json = Mapping[str, "Json"] | Sequence["Json"] | str | float | bool | None


@dataclass(frozen=True)
class Table:
    """Rows of texts under their headers, with sentences above and below."""

    headers: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    above: tuple[str, ...] = ()
    below: tuple[str, ...] = ()
    title: str = ""
    texts: int = 1  # columns from the left that hold words

    def text(self) -> str:
        """The table as text for a terminal."""
        table = [self._tabulated(self.rows, "simple")] if self.rows else []
        return "\n".join((*map(wrapped, self.above), *table, *map(wrapped, self.below)))

    def markdown(self) -> str:
        """The rows alone."""
        return self._tabulated([list(map(in_markdown, row)) for row in self.rows], "pipe")

    def _tabulated(self, rows: Sequence[Sequence[str]], style: str) -> str:
        sides = ("left",) * self.texts + ("right",) * (len(self.headers) - self.texts)
        return str(tabulate(rows, self.headers, style, disable_numparse=True, colalign=sides))


def in_markdown(text: str) -> str:
    """The text on one line, escaped for Markdown."""
    return re.sub(r"([\\`*_\[\]|~])", r"\\\1", html.escape(" ".join(text.split()), quote=False))


def wrapped(text: str) -> str:
    """The text in lines for a terminal."""
    return textwrap.fill(text, 110)


def page(template: str, data: Json = None, scripted: bool = False, **holes: object) -> str:
    """The text of a page that fills the frame.  Scripts read the data; one without data has scripts
    if it is `scripted`."""
    from coscrew_codegen.backends.html.plots import THEME  # Matplotlib, which tables do without

    return render(template, data="" if data is None else embedded(data), colours=THEME,
                  scripted=scripted or data is not None, **holes)


def embedded(data: Json) -> Markup:
    """JSON that is safe in a script element: without `<`, and without bare NaN or Infinity."""
    text = json.dumps(finite(data), allow_nan=False, separators=(",", ":"))
    return Markup(text.replace("<", "\\u003c"))


def finite(data: Json, instead: Callable[[float], Json] = json.dumps) -> Json:
    """The data without NaN and infinities: as strings, "NaN", "Infinity" and "-Infinity", or what
    stands `instead`."""
    if isinstance(data, Mapping):
        return {key: finite(value, instead) for key, value in data.items()}
    if isinstance(data, list | tuple):
        return [finite(value, instead) for value in data]
    return instead(data) if isinstance(data, float) and not isfinite(data) else data
