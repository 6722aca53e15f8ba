"""A scene's functions in fixed point as a module of Python, in memory."""

from types import ModuleType

from coscrew_codegen.program.scene_functions import SceneFunctions


def fixed_module(functions: SceneFunctions, tier: str) -> ModuleType:
    """The module arm/fixed.py of the generated package.  Raises NoFunctionsError."""
    from coscrew_codegen.accuracy.fixed_scene import in_fixed  # imports SymPy
    from coscrew_codegen.accuracy.tiers import tier_named
    from coscrew_codegen.backends.numpy import scene_python_fixed
    from coscrew_codegen.backends.scene.scene_text import banner_of

    made = in_fixed(functions, tier_named(tier))
    ((path, text),) = scene_python_fixed.files(made, banner_of(functions.name)).items()
    module = ModuleType(path.removesuffix(".py").replace("/", "."))
    exec(compile(text, path, "exec"), vars(module))
    return module
