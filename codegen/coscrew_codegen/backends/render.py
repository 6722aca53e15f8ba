"""Renders the templates, which hold file shapes only.

In a template a line that begins with the empty comment {#- #} continues the one before.  The filter
`each` fills a pattern with each item: {{ names|each("double {}") }} is "double x, double y".
"""

from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from coscrew_codegen.backends.version import VERSION

if TYPE_CHECKING:  # imported on first use: scenes found in the cache need no rendering
    import jinja2


_PACKAGE = Path(__file__).parents[1]
_INSTALLED = _PACKAGE / "templates"
TEMPLATES = _INSTALLED if _INSTALLED.is_dir() else _PACKAGE.parents[1] / "templates"
"""The folder of templates: inside the package where it is installed from a wheel, otherwise at the
top of the project."""
GENERATED = _PACKAGE.parent / "coscrew" if TEMPLATES is _INSTALLED else \
    TEMPLATES.parent / "generated"
"""The folder with the generated headers, in its folder c: the package `coscrew` where it is
installed from a wheel, otherwise generated/."""

_BANNER = "{{ banner }}"

LICENSE = ("SPDX-License-Identifier: MIT",
           f"coscrew {VERSION}.  Copyright (c) 2026 The coscrew authors.")
"""Lines 2 and 3 of every generated file.  Code generated for a user's scene contains coscrew's code
and so carries its license; the numbers and names in it belong to the scene."""


@cache
def _environment() -> "jinja2.Environment":
    import jinja2

    environment = jinja2.Environment(
        loader=jinja2.FunctionLoader(_source),
        undefined=jinja2.StrictUndefined, autoescape=_is_page, trim_blocks=False,
        lstrip_blocks=False, keep_trailing_newline=True)
    environment.filters["each"] = _each
    return environment


def _each(items: Iterable[object], pattern: str) -> str:
    """The pattern filled with each item in turn, with commas in between."""
    return ", ".join(pattern.format(item) for item in items)


def _is_page(name: str | None) -> bool:
    return name is not None and name.endswith((".html.jinja", ".html"))


def _source(name: str) -> str:
    return (TEMPLATES / name).read_text("utf-8")


@cache
def _between_lines(template: str) -> str:
    """The text between two comment lines, in the comment syntax of the template's banner line."""
    line = next(line for line in _source(f"{template}.jinja").splitlines() if _BANNER in line)
    before, after = line.split(_BANNER)
    return f"{after}\n{before}"


def render(template: str, **holes: object) -> str:
    """The text of `template` with its holes filled; an unfilled hole is an error.

    The hole `banner`, a file's first line, is followed by the lines of LICENSE."""
    if "banner" in holes:
        holes["banner"] = _between_lines(template).join((str(holes["banner"]), *LICENSE))
    text = _environment().get_template(f"{template}.jinja").render(**holes)
    return text.rstrip("\n") + "\n"


def copied(path: str) -> str:
    """The text of a file of templates/ that is C as it stands, whatever the Program."""
    return _source(path)


def generated(path: str) -> str:
    """The text of a header that `coscrew generate` has made: c/coscrew.h."""
    return (GENERATED / path).read_text("utf-8")


def runtime(pattern: str, banner: str = "") -> Mapping[str, str]:
    """The files that match runtime/…, copied, by their paths in templates/runtime/; each begins
    with the banner, if there is one."""
    lines = "".join(f"/* {line} */\n" for line in (banner, *LICENSE)) if banner else ""
    paths = sorted(path.relative_to(TEMPLATES).as_posix() for path in TEMPLATES.glob(pattern))
    return {path.removeprefix("runtime/"): lines + copied(path) for path in paths}
