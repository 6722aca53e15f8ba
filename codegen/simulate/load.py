"""load_scene: from a scene to callable kernels of both precisions, compiled where possible."""

from __future__ import annotations

import functools
import importlib
import importlib.util
import pickle
import sys
import warnings
import zlib
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, replace
from hashlib import sha256
from pathlib import Path
from types import ModuleType

import numpy as np
from numpy.typing import NDArray

from coscrew_codegen import emit
from coscrew_codegen.formats import PRECISIONS, Precision, named
from coscrew_codegen.mechanics import derive
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene_functions import SceneFunctions
from coscrew_codegen.scene_layout import banner_of
from coscrew_codegen.simulate import calls, native
from coscrew_codegen.targets import scene_c, scene_calls, scene_python


@dataclass(frozen=True, repr=False)
class Kernels:
    """A scene's functions, callable, in `double` and `single` precision; and which entries of q, v
    and p belong to what:

        NQ, NV       how many numbers q and v hold
        joints       names of the joints that move, in the order of q and v
        bodies       names, in the order of body_poses' and body_twists' rows
        parameters   names and default values of p's elements: the scene's `runtime`
        neutral_q    q where every joint is at rest in its placement.  (NQ)
    """

    scene: Scene | None
    functions: SceneFunctions
    double: calls.Functions[np.float64]
    single: calls.Functions[np.float32]
    compiler: str  # its version and flags; "" where the generated Python runs

    @property
    def NQ(self) -> int:
        """How many numbers q holds."""
        return self.functions.nq

    @property
    def NV(self) -> int:
        """How many numbers v, a and tau hold."""
        return self.functions.nv

    @property
    def joints(self) -> tuple[str, ...]:
        """Names of the joints that move, in the order of q and v."""
        return tuple(c.joint for c in self.functions.coordinates)

    @property
    def bodies(self) -> tuple[str, ...]:
        """Bodies' names, in the order of body_poses' and body_twists' rows."""
        return self.functions.bodies

    @property
    def parameters(self) -> dict[str, float]:
        """Default values by name, in the order of p."""
        return dict(self.functions.parameters)

    @property
    def neutral_q(self) -> NDArray[np.float64]:
        """q where every joint is at rest in its placement, in double.  (NQ)."""
        return np.array(self.functions.neutral, float)

    @property
    def compiled(self) -> bool:
        """Whether compiled C runs, and not generated Python."""
        return bool(self.compiler)

    @functools.cached_property
    def _pickled(self) -> bytes:
        return zlib.compress(pickle.dumps((self.scene, self.functions)))

    def __reduce__(self) -> tuple[Callable, tuple[bytes]]:
        """Of the scene and its functions; where they are unpickled, they are compiled, or found
        among kept libraries."""
        return restored, (self._pickled,)

    def __copy__(self) -> Kernels:
        return self

    def __deepcopy__(self, memo: dict) -> Kernels:
        return self

    def __repr__(self) -> str:
        return f"<kernels of {self.functions.name}: {self.compiler or 'pure NumPy'}>"


def load_scene(scene: Scene | Path | str, *, precision: str | None = None,
               implausible: str | None = None, functions: Sequence[str] = ()) -> Kernels:
    """The kernels of a scene or of a scene file: `.double` and `.single` hold the functions of its
    header.

    They are generated and compiled with the system's C compiler, $CC if set; libraries are kept in
    $XDG_CACHE_HOME or ~/.cache.  Without a compiler that works, which a warning tells, the
    generated Python runs.  `precision` and `implausible` stand in for what the file says of them:
    a scene of precision "double" has no `single`; what implausible "warn" lets through is warned
    of.  `functions` are those wanted, by name, instead of those that the scene asks for; "default"
    stands for those of a scene that asks for none, "all" for all it can have.  Raises AskedError
    for names of none, TypeError for what is neither file nor Scene, ValueError for unknown words,
    RangeError for numbers that a precision cannot hold, and what reading the scene raises.
    """
    functions = _names(functions)
    if isinstance(scene, (str, Path)):
        from coscrew_codegen.scene_files.toml_scene import Said, read_scene
        path = Path(scene)
        scene = read_scene(path, said=Said(precision, implausible, functions))
        for line in scene.model.implausible:
            warnings.warn(f"{path.name}: {line}", RuntimeWarning, stacklevel=2)
    elif not isinstance(scene, Scene):
        raise TypeError(f"load_scene: wanted the path of a scene file, or a Scene; "
                        f"got {type(scene).__name__}")
    elif precision or implausible:
        raise TypeError("load_scene: precision and implausible belong to a scene file; this Scene "
                        "has its own")
    elif functions:
        scene = replace(scene, functions=functions)
    return kernels_of(derive(scene), scene)


def kernels_for(scene: Scene, functions: Collection[str]) -> Kernels:
    """The kernels of those functions of a scene that it has, and of no others."""
    return kernels_of(derive(scene, functions), scene)


def _names(functions: Sequence[str]) -> tuple[str, ...]:
    """The names, as one may write them by mistake: "energy"."""
    if isinstance(functions, str) or not all(isinstance(name, str) for name in functions):
        raise TypeError(f'functions: wanted a list of names, as ["energy"]; got {functions!r}')
    return tuple(functions)


def kernels_of(functions: SceneFunctions, scene: Scene | None = None) -> Kernels:
    """The kernels of functions, wherever they come from."""
    try:
        compiler = native.compiler()
        library = _library(functions, compiler)
    except native.CompilationError as error:
        warnings.warn(f"{functions.name} runs in pure NumPy: {error}", RuntimeWarning, stacklevel=3)
        modules = _modules(functions)
        return _kernels(scene, functions, "", lambda x, p: calls.in_numpy(
            getattr(modules[p.name], x.name), x))
    return _kernels(scene, functions, str(compiler), lambda x, p: calls.compiled(
        functions, library, x, p))


def _kernels(scene: Scene | None, functions: SceneFunctions, compiler: str,
             made: Callable[[scene_calls.Callable, Precision], Callable]) -> Kernels:
    described = scene_calls.callables(functions)
    found = [calls.gathered(functions, p, {x.name: made(x, p) for x in described
                                               if p.name in functions.precisions})
             for p in PRECISIONS]
    kernels = Kernels(scene, functions, *found, compiler)
    for x in found:
        x._kernels = kernels
    return kernels


@functools.lru_cache(maxsize=32)
def restored(pickled: bytes) -> Kernels:
    """The kernels of a scene and its functions, pickled: made once in a process."""
    scene, functions = pickle.loads(zlib.decompress(pickled))
    return kernels_of(functions, scene)


def _library(functions: SceneFunctions, compiler: native.Compiler):
    source = f"{functions.name}_calls.c"
    files = {**scene_c.files(functions, banner_of(functions.name)),
             source: scene_calls.source(functions)}
    units = {p.name: (source, *(f"-D{functions.name.upper()}_NO_{other.name.upper()}"
                                for other in PRECISIONS if other != p))
             for p in named(functions.precisions)}
    return native.library(units, files, compiler)


def _modules(functions: SceneFunctions) -> dict[str, ModuleType]:
    """The generated package's modules, imported from a folder where it stays."""
    files = scene_python.files(functions, banner_of(functions.name))
    key = sha256("\0".join(x for pair in sorted(files.items()) for x in pair).encode()).hexdigest()
    folder = native.cache_folder() / f"python-{key[:32]}"
    emit.write(files, folder)
    name = f"_coscrew_scene_{key[:32]}"
    if name not in sys.modules:
        init = folder / functions.name / "__init__.py"
        spec = importlib.util.spec_from_file_location(
            name, init, submodule_search_locations=[str(init.parent)])
        module = importlib.util.module_from_spec(spec)
        sys.modules[name] = module
        spec.loader.exec_module(module)
    return {p.name: importlib.import_module(f"{name}.{p.name}")
            for p in named(functions.precisions)}
