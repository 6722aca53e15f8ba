"""The source text of requested functions: in C, or in NumPy where nothing compiles."""

from collections.abc import Mapping
from dataclasses import dataclass

from coscrew_codegen.accuracy.scene_tiers import SceneTier
from coscrew_codegen.backends.numpy import scene_python
from coscrew_codegen.backends.python_extension import scene_calls
from coscrew_codegen.backends.python_extension.scene_calls import BINDING, binding_units
from coscrew_codegen.backends.render import render
from coscrew_codegen.backends.scene import scene_c, scene_c_many, scene_c_tier
from coscrew_codegen.backends.scene.scene_text import banner_of
from coscrew_codegen.program.scene_functions import SceneFunctions, SceneInterface
from coscrew_codegen.program.values.formats import PRECISIONS, Precision, named
from coscrew_codegen.runtime.console import doing
from coscrew_codegen.runtime.request import Request


@dataclass(frozen=True)
class SourceText:
    """The text of functions: files by their paths, and the interface of the functions."""

    interface: SceneInterface
    files: Mapping[str, str]
    plain: SceneFunctions  # the functions in the plain tier, in the precisions of the text
    source: str = ""  # the file to compile; {f} stands for the suffix of a precision
    flags: tuple[str, ...] = ()

    def units(self, precisions: tuple[str, ...]) -> dict[str, tuple[str, ...]]:
        """The objects to compile in these precisions: source and flags of each."""
        wanted = [p for p in named(self.plain.precisions) if p.name in precisions]
        units = {p.name: (self.source.format(f=p.suffix), *self.only(p), *self.flags)
                 for p in wanted}
        return units | binding_units(wanted) if BINDING in self.files else units

    def only(self, precision: Precision) -> tuple[str, ...]:
        """The flags that leave out the other precisions."""
        return tuple(f"-D{self.plain.name.upper()}_NO_{p.name.upper()}"
                     for p in PRECISIONS if p != precision)


def in_c(request: Request) -> SourceText:
    """The text in C, of one state and callable from Python, or of many states."""
    programs = request.programs()
    with doing(f"writing {request.name}{' for many states' if request.lanes else ''}"):
        return of_many(programs) if request.lanes else of_one(programs)


def checks() -> str:
    """The text in Python that checks arguments, as generated packages do."""
    return render("scene/arrays.py", banner="in memory")


def of_one(programs: SceneFunctions | SceneTier) -> SourceText:
    """The text in C of functions of one state, which Python calls."""
    banner = _banner(programs)
    if isinstance(programs, SceneTier):
        files = scene_c_tier.files(programs, banner) | scene_calls.tier_files(programs, banner)
        return SourceText(scene_calls.tier_interface(programs), files, programs.plain,
                          f"{programs.stem}_calls.c")
    files = scene_c.files(programs, banner) | scene_calls.files(programs, banner)
    return SourceText(scene_calls.interface(programs), files, programs, f"{programs.name}_calls.c")


def of_many(programs: SceneFunctions | SceneTier) -> SourceText:
    """The text in C of functions of many states."""
    banner, flags = _banner(programs), ("-DKSL_LANES_ONLY", scene_c_many.LEVEL)
    if isinstance(programs, SceneTier):
        files = (scene_c.files(programs.plain, banner) | scene_c_tier.files(programs, banner)
                 | scene_c_many.tier_files(programs, banner))
        return SourceText(scene_calls.tier_interface(programs), files, programs.plain,
                          f"{programs.stem}_many{{f}}.c", flags)
    files = scene_c.files(programs, banner) | scene_c_many.files(programs, banner)
    return SourceText(scene_calls.interface(programs), files, programs,
                      f"{programs.name}_many{{f}}.c", flags)


def in_numpy(request: Request) -> SourceText:
    """The text in NumPy, a package with a module for each precision."""
    programs = request.programs()
    banner = _banner(programs)
    if isinstance(programs, SceneTier):
        files = (scene_python.files(programs.plain, banner)
                 | scene_python.tier_files(programs, banner))
        return SourceText(scene_calls.tier_interface(programs), files, programs.plain)
    return SourceText(scene_calls.interface(programs), scene_python.files(programs, banner),
                      programs)


def _banner(programs: SceneFunctions | SceneTier) -> str:
    return banner_of((programs.plain if isinstance(programs, SceneTier) else programs).name)
