"""Types of the steps that `load_scene` returns, for type checkers: a step of each integrator."""

from coscrew_codegen.backends.library import Library
from coscrew_codegen.backends.render import render
from coscrew_codegen.backends.target import Files, Target
from coscrew_codegen.scene.integrators import EMITTED


def files(library: Library) -> Files:
    """python/coscrew/_steps.pyi."""
    return {"python/coscrew/_steps.pyi": render("python/_steps.pyi", banner=library.banner,
                                        names=[x.step_name for x in EMITTED])}


TARGET = Target("types of steps", ("python",), library=files)
