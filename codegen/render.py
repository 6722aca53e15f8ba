"""Renders the templates; they stand beside this package and hold file shapes only."""

from importlib.resources import files

import jinja2

_ENVIRONMENT = jinja2.Environment(
    loader=jinja2.FunctionLoader(
        lambda name: files("coscrew_codegen.templates").joinpath(name).read_text("utf-8")),
    undefined=jinja2.StrictUndefined, autoescape=False, trim_blocks=False, lstrip_blocks=False,
    keep_trailing_newline=True)


def render(template: str, **holes: object) -> str:
    """The text of `template` with its holes filled; an unfilled hole is an error."""
    text = _ENVIRONMENT.get_template(f"{template}.jinja").render(**holes)
    return text.rstrip("\n") + "\n"
