"""The reference documentation, generated from the tables of operations, effects and scene keys.

Markdown with formulas in LaTeX, as GitHub and `make docs` render it; a JSON Schema for editors."""

from coscrew_codegen.algebra.operations import FAMILIES
from coscrew_codegen.backends.library import Library
from coscrew_codegen.reports.reference.operation_pages import families_page, family_page
from coscrew_codegen.reports.reference.scene_pages import (
    effects_page,
    functions_page,
    functions_stub,
    integrators_page,
    joints_page,
    keys_page,
)
from coscrew_codegen.reports.reference.scene_schema import schema_text


def reference_files(library: Library) -> dict[str, str]:
    """The files of a whole library's reference, by path in the output folder, with types of scenes'
    functions for editors."""
    banner = library.banner
    pages = {"effects.md": effects_page(banner), "functions.md": functions_page(banner),
             "scene_keys.md": keys_page(banner), "integrators.md": integrators_page(banner),
             "joints.md": joints_page(banner),
             "scene.schema.json": schema_text(banner),
             "operations/index.md": families_page(banner)}
    pages |= {f"operations/{family}.md": family_page(family, library)
              for family in FAMILIES}
    return {"python/coscrew/_functions.pyi": functions_stub(banner),
            **{f"docs/{path}": text for path, text in pages.items()}}
