"""The reference documentation, generated from the tables of operations, effects and scene keys.

Markdown with formulas in LaTeX, as GitHub and `make docs` render it; a JSON Schema for editors."""

from collections.abc import Mapping

from coscrew_codegen.documentation.operations import families_page, family_page
from coscrew_codegen.documentation.scenes import effects_page, integrators_page, keys_page
from coscrew_codegen.documentation.schema import schema_text
from coscrew_codegen.operations import FAMILIES
from coscrew_codegen.program import Program


def reference_files(programs: Mapping[str, Program], banner: str) -> dict[str, str]:
    """The files of the reference, by path in the output folder."""
    pages = {"effects.md": effects_page(banner), "scene_keys.md": keys_page(banner),
             "integrators.md": integrators_page(banner), "scene.schema.json": schema_text(banner),
             "operations/index.md": families_page(banner)}
    pages |= {f"operations/{family}.md": family_page(family, programs, banner)
              for family in FAMILIES}
    return {f"docs/{path}": text for path, text in pages.items()}
