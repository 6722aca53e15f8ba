"""load_scene: from a scene to callable kernels of both precisions, compiled where possible."""

from __future__ import annotations

import ctypes
import functools
import importlib
import importlib.util
import pickle
import sys
import warnings
import zlib
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from hashlib import sha256
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, cast

import numpy as np
from numpy.typing import NDArray

from coscrew_codegen.program.plugins import holder
from coscrew_codegen.program.scene_functions import SceneFunctions, SceneInterface, Signature
from coscrew_codegen.program.values.formats import PRECISIONS, Precision, named
from coscrew_codegen.runtime import cache, callables, compilation, sources
from coscrew_codegen.runtime.console import doing
from coscrew_codegen.scene.content import content_hash
from coscrew_codegen.scene.function_selection import CONTACTS, FREE, left_out, together
from coscrew_codegen.scene.names import listed
from coscrew_codegen.scene.scene import Scene

if TYPE_CHECKING:
    from coscrew_codegen.runtime.arrays.namespace import Arrays
    from coscrew_codegen.runtime.lanes import CompiledLanes

BOTH = tuple(p.name for p in PRECISIONS)


@dataclass(frozen=True, repr=False)
class Kernels:
    """A scene's functions, callable, in `double` and `single` precision; those of a selected tier
    are Kernels again: `.accurate.double`.  And the meaning of the entries of q, v and p:

        NQ, NV       lengths of q and v
        joints       names of the joints that move, in the order of q and v
        bodies       names of bodies, in the order of the rows of body_poses and body_twists
        parameters   names and default values of the elements of p: the scene's `runtime`
        neutral_q    the q at which every joint's displacement is the identity.  (NQ)
    """

    scene: Scene | None
    interface: SceneInterface
    double: callables.Functions[np.float64]
    single: callables.Functions[np.float32]
    compiler: str  # its version and flags; "" if the generated Python runs
    library: str = ""  # its key in the cache
    selected: tuple[str, ...] = ()  # names of the selected functions; (): those of the scene
    _derived: SceneFunctions | None = None
    precisions: tuple[str, ...] = BOTH  # in which there are functions
    plain: Kernels | None = None  # of a tier's: the scene's own

    def _in_tier(self, name: str) -> Kernels:
        """The functions in a tier that the scene selects, compiled when it is first asked for."""
        if name.startswith("_"):
            raise AttributeError(name)
        if name in self.interface.tiers:
            from coscrew_codegen.runtime.load_tier import in_tier_of

            vars(self)[name] = found = in_tier_of(self, name)
            return found
        from coscrew_codegen.scene.tier_selection import known

        hint = f"; it was not selected: tiers=[{name!r}]" if name in known()[1:] else ""
        raise AttributeError(f"kernels of {self.interface.name} have no attribute {name!r}{hint}",
                             name=name, obj=self)

    if TYPE_CHECKING:  # checkers and editors know these alone
        @property
        def accurate(self) -> Kernels: ...
        @property
        def certified(self) -> Kernels: ...
        @property
        def pairs(self) -> Kernels: ...
        @property
        def mixed(self) -> Kernels: ...
    else:
        __getattr__ = _in_tier

    @functools.cached_property
    def functions(self) -> SceneFunctions:
        """The functions as Programs, derived again if the kernels came from the cache."""
        if self._derived:
            return self._derived
        from coscrew_codegen.dynamics import derive
        assert self.scene  # without one, the functions were given
        return derive(self.scene, self.selected)

    def _with(self, *names: str) -> Kernels:
        """Returns these kernels, or, if they lack functions of these names that the scene has,
        kernels of both, compiled when they are first needed."""
        own = tuple(x.name for x in self.interface.signatures)
        if self.scene is None or {*names} - {*CONTACTS, *FREE} <= {*own}:
            return self
        key = " ".join(("with", *names))
        if key not in vars(self):
            vars(self)[key] = kernels_for(self.scene, together(own, names), self.precisions)
        found: Kernels = vars(self)[key]
        return found

    @property
    def NQ(self) -> int:
        """The length of q."""
        return self.interface.nq

    @property
    def NV(self) -> int:
        """The length of v, a and tau."""
        return self.interface.nv

    @property
    def joints(self) -> tuple[str, ...]:
        """Names of the joints that move, in the order of q and v."""
        return tuple(c.joint for c in self.interface.coordinates)

    @property
    def bodies(self) -> tuple[str, ...]:
        """Names of bodies, in the order of the rows of body_poses and body_twists."""
        return self.interface.bodies

    @property
    def parameters(self) -> dict[str, float]:
        """Default values by name, in the order of p."""
        return dict(self.interface.parameters)

    @property
    def neutral_q(self) -> NDArray[np.float64]:
        """The q at which every joint's displacement is the identity, in double.  (NQ)."""
        return np.array(self.interface.neutral, float)

    @property
    def compiled(self) -> bool:
        """Whether the functions are compiled C, not generated Python."""
        return bool(self.compiler)

    def arrays(self, xp: ModuleType) -> Arrays:
        """The functions on arrays of a library, with derivatives: jax.numpy, torch, cupy,
        array_api_strict, numpy.  Raises TypeError for others."""
        from coscrew_codegen.runtime.arrays.namespace import of_scene

        made: dict[ModuleType, Arrays] = vars(self).setdefault("_arrays", {})
        if xp not in made:
            made[xp] = of_scene(xp, self.interface, lambda: self.functions,
                                {"double": self.double, "single": self.single}, opened, self)
        return made[xp]

    @functools.cached_property
    def _pickled(self) -> bytes:
        functions = None if self.scene else self.functions
        return zlib.compress(pickle.dumps((self.scene, self.selected, functions)))

    def __reduce__(self) -> tuple[Callable[..., object], tuple[object, ...]]:
        """Pickle the scene and the selected functions; unpickling compiles them, or finds them in
        the cache."""
        if self.plain:
            return getattr, (self.plain, self.interface.mark)
        return restored, (self._pickled,)

    @functools.cached_property
    def _lanes(self) -> CompiledLanes:
        """The functions of many states, compiled when they pay."""
        from coscrew_codegen.runtime.lanes import CompiledLanes

        return CompiledLanes(self)

    def __copy__(self) -> Kernels:
        return self

    def __deepcopy__(self, memo: dict[int, object]) -> Kernels:
        return self

    def __repr__(self) -> str:
        tier = f"{self.interface.mark} " if self.interface.mark else ""
        return f"<{tier}kernels of {self.interface.name}: {self.compiler or 'pure NumPy'}>"


def load_scene(scene: Scene | Path | str, *, precision: str | None = None,
               implausible: str | None = None, functions: Sequence[str] | None = None,
               tiers: Sequence[str] | None = None) -> Kernels:
    """The kernels of a scene or of a scene file: `.double` and `.single` hold the functions of its
    header.

    They are generated and compiled with the system's C compiler, $CC if set; libraries are cached
    in $XDG_CACHE_HOME or ~/.cache.  Without a working compiler, a warning is issued and the
    generated Python runs.  `precision` and `implausible` override the file's: a scene of precision
    "double" has no `single`; with implausible "warn", implausible bodies cause warnings.
    `functions` names functions to use instead of the scene's own selection; "default" stands for
    those of a scene that selects none, "all" for all it can have; `tiers` names tiers, to use
    likewise.  Raises FunctionsError for unknown functions, TiersError for unknown tiers, TypeError
    for anything but a file or a Scene, ValueError for unknown words, RangeError for numbers that a
    precision cannot hold, and the errors of reading the scene.
    """
    functions, tiers = (_names(*x) for x in (("functions", functions, "energy"),
                                             ("tiers", tiers, "accurate")))
    if isinstance(scene, (str, Path)):
        from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides, read_scene
        path = Path(scene)
        scene = read_scene(path, overrides=SceneOverrides(precision, implausible, functions,
                                                            tiers))
        for line in scene.model.implausible:
            warnings.warn(f"{path.name}: {line}", RuntimeWarning, stacklevel=2)
    elif not isinstance(scene, Scene):
        raise TypeError(f"load_scene: wanted the path of a scene file, or a Scene; "
                        f"got {type(scene).__name__}")
    elif precision or implausible:
        raise TypeError("load_scene: precision and implausible belong to a scene file; this Scene "
                        "has its own")
    else:
        from coscrew_codegen.scene.tier_selection import selected

        scene = replace(scene, functions=functions or scene.functions,
                        tiers=selected(tiers) or scene.tiers)
    if line := left_out(scene):
        warnings.warn(f"{scene.name}: {line}", RuntimeWarning, stacklevel=2)
    return kernels_for(scene)


def _names(argument: str, given: Sequence[str] | None, example: str) -> tuple[str, ...]:
    """The names in a list; none for None.  Raises ValueError for an empty list."""
    found = () if given is None else listed(argument, given, example)
    if given is not None and not found:
        raise ValueError(f'{argument}: an empty list; wanted names, as ["{example}"], or None')
    return found


def kernels_for(scene: Scene, functions: Collection[str] = (),
                precisions: tuple[str, ...] = BOTH) -> Kernels:
    """The kernels of the scene's selected functions, or of those with these names that it has,
    compiled in these precisions: found in the cache, or made."""
    compiler = _compiler(scene.name)
    key = key_of(scene, functions, precisions, compiler) if compiler else ""
    if compiler and key and (kept := kept_as(key)):
        interface, library = kept
        return _compiled(scene, tuple(functions), interface, library, precisions, compiler)
    with doing(f"deriving {scene.name}") as tell:
        from coscrew_codegen.dynamics import derive  # imports SymPy

        derived = derive(scene, functions, lambda name: tell(f"deriving {name}"))
    made = _made(derived, scene, tuple(functions), precisions, compiler)
    if key and made.compiled:
        cache.write(key, ".scene", pickle.dumps((made.interface, made.library)))
    return made


def kernels_of(functions: SceneFunctions, scene: Scene | None = None) -> Kernels:
    """The kernels of derived functions."""
    return _made(functions, scene, (), BOTH, _compiler(functions.name))


def _compiler(name: str) -> compilation.Compiler | None:
    """The compiler; None, with a warning, if none works."""
    try:
        return compilation.compiler()
    except compilation.CompilationError as error:
        compilation.warn(name, error)
        return None


def key_of(scene: Scene, functions: Collection[str], precisions: tuple[str, ...],
           compiler: compilation.Compiler, *tier: str) -> str:
    """The cache key: a hash of all that the kernels are made from.  "" if an effect is not in the
    catalogue, since its name does not identify its equations."""
    from coscrew_codegen.scene import effects

    used = {holder(effects.__name__, "EFFECT", x.effect) for x in scene.effects}
    if "" in used:
        return ""
    made_from = sources.digest_of(__name__, chosen={effects.__name__: used})
    return cache.key_of(made_from, content_hash(scene), *compilation.place(compiler),
                        " ".join(precisions), *functions, *(f"tier {x}" for x in tier))


def kept_as(key: str) -> tuple[SceneInterface, compilation.CompiledLibrary] | None:
    """The cache's entry of this key, if it can be read and its library exists."""
    path = cache.found(key, ".scene")
    if path is None:
        return None
    try:
        interface, library_key = pickle.loads(path.read_bytes())
    except Exception:  # for a foreign file, pickle may raise any error
        path.unlink(missing_ok=True)
        return None
    library = compilation.kept(library_key)
    return (interface, library) if library else None


def _made(functions: SceneFunctions, scene: Scene | None, selected: tuple[str, ...],
          precisions: tuple[str, ...], compiler: compilation.Compiler | None) -> Kernels:
    """The kernels: compiled or, if that fails, generated Python."""
    from coscrew_codegen.backends.python_extension.scene_calls import interface

    found = interface(functions)
    if compiler:
        try:
            library = _library(functions, compiler, precisions)
            return _compiled(scene, selected, found, library, precisions, compiler, functions)
        except compilation.CompilationError as error:
            compilation.warn(functions.name, error)
    modules = _modules(functions)
    return gathered(scene, selected, found, "", "", functions, precisions, lambda x, p: (
        callables.in_numpy(getattr(modules[p.name], x.name), x)))


def _compiled(scene: Scene | None, selected: tuple[str, ...], found: SceneInterface,
              library: compilation.CompiledLibrary, precisions: tuple[str, ...],
              compiler: compilation.Compiler,
              functions: SceneFunctions | None = None) -> Kernels:
    return gathered(scene, selected, found, str(compiler), library.key, functions, precisions,
                    lambda x, p: callables.compiled(found, library.opened, x, p))


def gathered(scene: Scene | None, selected: tuple[str, ...], found: SceneInterface, compiler: str,
             library: str, functions: SceneFunctions | None, precisions: tuple[str, ...],
             made: Callable[[Signature, Precision], callables.Made],
             plain: Kernels | None = None) -> Kernels:
    """The kernels, whose functions `made` returns; `plain` are the scene's own, if of a tier."""
    double, single = (
        callables.gathered(found, p, {x.name: made(x, p) for x in found.signatures
                                      if p.name in found.precisions and p.name in precisions})
        for p in PRECISIONS)
    kernels = Kernels(scene, found, cast("callables.Functions[np.float64]", double),
                      cast("callables.Functions[np.float32]", single), compiler, library, selected,
                      functions, precisions, plain)
    for x in (double, single):
        x._kernels = kernels
    return kernels


@functools.lru_cache(maxsize=32)
def restored(pickled: bytes) -> Kernels:
    """The kernels of a pickled scene and its selected functions; made once per process."""
    scene, selected, functions = pickle.loads(zlib.decompress(pickled))
    return kernels_of(functions, scene) if functions else kernels_for(scene, selected)


def _library(functions: SceneFunctions, compiler: compilation.Compiler, precisions: tuple[str, ...]
             ) -> compilation.CompiledLibrary:
    from coscrew_codegen.backends.python_extension import scene_calls
    from coscrew_codegen.backends.scene import scene_c
    from coscrew_codegen.backends.scene.scene_text import banner_of

    with doing(f"writing {functions.name}"):
        banner = banner_of(functions.name)
        files = scene_c.files(functions, banner) | scene_calls.files(functions, banner)
    return library_of(files, functions, f"{functions.name}_calls.c", compiler, precisions)


def library_of(files: Mapping[str, str], functions: SceneFunctions, source: str,
               compiler: compilation.Compiler, precisions: tuple[str, ...], *flags: str
               ) -> compilation.CompiledLibrary:
    """The library of a source in these precisions; {f} in its name stands for their suffix."""
    units = {p.name: (source.format(f=p.suffix), *(
        f"-D{functions.name.upper()}_NO_{other.name.upper()}" for other in PRECISIONS
        if other != p), *flags)
             for p in named(functions.precisions) if p.name in precisions}
    return compilation.library(units, files, compiler)


def opened(name: str, units: Mapping[str, Sequence[str]], files: Mapping[str, str]
           ) -> ctypes.CDLL | None:
    """The library of these texts, whose functions run without Python's global lock; None, with a
    warning, where nothing compiles."""
    try:
        return ctypes.CDLL(compilation.library(units, files, compilation.compiler()).opened._name)
    except compilation.CompilationError as error:
        compilation.warn(name, error, "is computed by calls of the array library")
        return None


def _modules(functions: SceneFunctions) -> dict[str, ModuleType]:
    from coscrew_codegen.backends.numpy import scene_python
    from coscrew_codegen.backends.scene.scene_text import banner_of

    return modules_of(scene_python.files(functions, banner_of(functions.name)), functions)


def modules_of(files: Mapping[str, str], functions: SceneFunctions, *inner: str
               ) -> dict[str, ModuleType]:
    """The modules of a generated package, or of one in it, by precision, imported from a folder
    that is kept."""
    from coscrew_codegen.backends import emit

    key = sha256("\0".join(x for pair in sorted(files.items()) for x in pair).encode()).hexdigest()
    folder = cache.folder() / f"python-{key[:32]}"
    emit.write(files, folder)
    name = f"_coscrew_scene_{key[:32]}"
    if name not in sys.modules:
        init = folder / functions.name / "__init__.py"
        spec = importlib.util.spec_from_file_location(
            name, init, submodule_search_locations=[str(init.parent)])
        assert spec and spec.loader
        module = importlib.util.module_from_spec(spec)
        sys.modules[name] = module
        spec.loader.exec_module(module)
    return {p.name: importlib.import_module(".".join((name, *inner, p.name)))
            for p in named(functions.precisions)}
