"""The kernels of a scene in a tier: compiled, or found in the cache, like the scene's own."""

import pickle

from coscrew_codegen.accuracy.scene_tiers import SceneTier, in_tier
from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.runtime import cache, callables, compilation, load
from coscrew_codegen.runtime.console import doing


def in_tier_of(plain: load.Kernels, name: str) -> load.Kernels:
    """The kernels in the tier of this name; in pure NumPy where the scene's own are."""
    compiler = compilation.compiler() if plain.compiled else None
    key = "" if not (compiler and plain.scene) else load.key_of(
        plain.scene, plain.selected, plain.precisions, compiler, name)
    if compiler and key and (kept := load.kept_as(key)):
        interface, library = kept
        return load.gathered(
            plain.scene, plain.selected, interface, str(compiler), library.key, None,
            plain.precisions, lambda x, p: callables.compiled(interface, library.opened, x, p),
                             plain)
    with doing(f"deriving the {name} tier of {plain.interface.name}"):
        tier = in_tier(plain.functions, tier_named(name))
    made = _made(plain, tier, compiler)
    if key and made.compiled:
        cache.write(key, ".scene", pickle.dumps((made.interface, made.library)))
    return made


def _made(plain: load.Kernels, tier: SceneTier, compiler: compilation.Compiler
          | None) -> load.Kernels:
    """The kernels: compiled or, if that fails, generated Python."""
    from coscrew_codegen.backends.python_extension.scene_calls import tier_interface

    found = tier_interface(tier)
    if compiler:
        try:
            library = _library(tier, compiler, plain.precisions)
            return load.gathered(
                plain.scene, plain.selected, found, str(compiler), library.key, None,
                plain.precisions, lambda x, p: callables.compiled(found, library.opened, x, p),
                                 plain)
        except compilation.CompilationError as error:
            compilation.warn(f"{tier.plain.name} in the {tier.tier.name} tier", error)
    from coscrew_codegen.backends.numpy import scene_python
    from coscrew_codegen.backends.scene.scene_text import banner_of

    banner = banner_of(tier.plain.name)
    files = scene_python.files(tier.plain, banner) | scene_python.tier_files(tier, banner)
    modules = load.modules_of(files, tier.plain, tier.tier.mark)
    return load.gathered(plain.scene, plain.selected, found, "", "", None, plain.precisions,
                         lambda x, p: callables.in_numpy(getattr(modules[p.name], x.name), x),
                         plain)


def _library(tier: SceneTier, compiler: compilation.Compiler, precisions: tuple[str, ...]
             ) -> compilation.CompiledLibrary:
    from coscrew_codegen.backends.python_extension import scene_calls
    from coscrew_codegen.backends.scene import scene_c_tier
    from coscrew_codegen.backends.scene.scene_text import banner_of

    with doing(f"writing {tier.stem}"):
        banner = banner_of(tier.plain.name)
        files = scene_c_tier.files(tier, banner) | scene_calls.tier_files(tier, banner)
    return load.library_of(files, tier.plain, f"{tier.stem}_calls.c", compiler, precisions)
