"""Gathers the files of all targets, for the library or for a scene."""

from collections.abc import Iterable

from coscrew_codegen.accuracy.fixed_scene import fixed_of
from coscrew_codegen.accuracy.scene_tiers import tiers_of
from coscrew_codegen.backends import targets
from coscrew_codegen.backends.library import Library
from coscrew_codegen.backends.scene.scene_text import banner_of
from coscrew_codegen.backends.target import Files
from coscrew_codegen.program.scene_functions import SceneFunctions


def generated_files(library: Library) -> Files:
    """Every file of the library, by its path in the output folder."""
    wanted = set(library.languages)
    return _gathered((target.name, target.library(library)) for target in targets()
                     if target.generated and target.library and wanted.issuperset(target.languages))


def scene_files(functions: SceneFunctions, command: str = "", many: bool = False, cuda: bool = False
                ) -> Files:
    """Every file of a scene, by its path in the output folder, also those of its functions of many
    states if `many`, and for CUDA if `cuda`; their first lines name `command` as what makes them.
    Raises ValueError for names that cannot be used in C or Python."""
    banner, tiers = banner_of(functions.name, command), tuple(tiers_of(functions))
    made = [(target.name, target.scene(functions, banner)) for target in targets()
            if target.generated and target.scene]
    made += [(target.name, target.tier(tier, banner)) for tier in tiers
             for target in targets() if target.generated and target.tier]
    for fixed in fixed_of(functions):
        made += [(target.name, files(fixed, banner)) for target in targets() for files, wanted in (
            (target.fixed, target.generated), (target.many_fixed, many), (target.cuda_fixed, cuda))
            if files and wanted]
    made += [(target.name, target.many(functions, banner)) for target in targets()
             if many and target.many]
    made += [(target.name, target.many_tier(tier, banner)) for tier in tiers
             for target in targets() if many and target.many_tier]
    made += [(target.name, target.cuda(functions, banner)) for target in targets()
             if cuda and target.cuda]
    made += [(target.name, target.cuda_tier(tier, banner)) for tier in tiers
             for target in targets() if cuda and target.cuda_tier]
    return _gathered(made)


def _gathered(made: Iterable[tuple[str, Files]]) -> Files:
    """All files.  Raises ValueError if two targets make different ones of the same path."""
    files: Files = {}
    makers: dict[str, str] = {}
    for name, more in made:
        for path, text in more.items():
            if files.get(path, text) != text:
                raise ValueError(f"{path} is made by two targets: {makers[path]} and {name}")
            makers[path] = name
        files |= more
    return files
