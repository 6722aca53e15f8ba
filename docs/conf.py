"""Sphinx: README, docs/ and generated/docs/ as pages; `make docs` calls it.

Formulas become MathML by docutils, which browsers show without a script or a network.
"""

import re

from docutils import nodes
from docutils.utils.math import MathError
from docutils.utils.math.latex2mathml import tex2mathml
from sphinx.application import Sphinx
from sphinx.util import logging
from sphinx.writers.html5 import HTML5Translator

project, author, copyright = "coscrew", "The coscrew authors", "2026, The coscrew authors"
extensions = ["myst_parser"]
root_doc = "docs/index"
include_patterns = ["*.md", "docs/*.md", "generated/docs/**.md"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
html_theme = "alabaster"
html_theme_options = {"page_width": "70em", "sidebar_width": "16em", "fixed_sidebar": True}
html_show_sourcelink = False
smartquotes = False
html_math_renderer = "mathml"

TREES = {  # the navigation: what stands under each caption
    "Guides": ("README <../README>", "c", "python", "arrays", "scenes", "urdf", "models",
               "contact", "loops", "playback", "sweeps", "derivatives", "identification",
               "fixed_point", "from_ksl", "from_pinocchio", "from_mujoco", "glossary", "convention",
               "accuracy", "bounds", "architecture", "../C*"),
    "Scenes": ("../generated/docs/*",),
    "Operations": ("../generated/docs/operations/index", "../generated/docs/operations/*")}


def _inline(translator: HTML5Translator, node: nodes.math) -> None:
    translator.body.append(_mathml(node, False))
    raise nodes.SkipNode


def _block(translator: HTML5Translator, node: nodes.math_block) -> None:
    translator.body.append(f'<div style="overflow: auto hidden">{_mathml(node, True)}</div>\n')
    raise nodes.SkipNode


def _mathml(node: nodes.Element, block: bool) -> str:
    try:
        return tex2mathml(node.astext(), as_block=block)
    except MathError as error:
        logging.getLogger(__name__).warning("%s: %s", node.astext(), error, location=node)
        return ""


def _read(_: Sphinx, name: str, source: list[str]) -> None:
    """Formulas as GitHub and GitLab write them, $`…`$ and fences, as MyST does; behind the root's
    text the navigation, which people who read it there need not see."""
    source[0] = re.sub(r"\$`(.+?)`\$", r"$\1$", source[0])
    source[0] = re.sub(r"^```math\n(.*?)\n```$", r"$$\n\1\n$$", source[0],
                       flags=re.MULTILINE | re.DOTALL)
    if name == root_doc:
        source[0] += "".join(_tree(caption, pages) for caption, pages in TREES.items())


def _tree(caption: str, pages: tuple[str, ...]) -> str:
    listed = "\n".join(pages)
    return f"\n```{{toctree}}\n:hidden:\n:glob:\n:caption: {caption}\n\n{listed}\n```\n"


def setup(app: Sphinx) -> None:
    app.connect("source-read", _read)
    app.add_html_math_renderer("mathml", (_inline, None), (_block, None))
