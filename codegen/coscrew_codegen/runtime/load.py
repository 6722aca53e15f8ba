"""load_scene: from a scene to callable kernels of both precisions, compiled where possible."""

from __future__ import annotations

import functools
import warnings
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, cast

import numpy as np
from numpy.typing import NDArray

from coscrew_codegen.program.scene_functions import SceneFunctions, SceneInterface, Signature
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.runtime import callables, compilation, request, scene_library
from coscrew_codegen.runtime.cache import packed, unpacked
from coscrew_codegen.runtime.caller_warnings import at_callers_line, warn
from coscrew_codegen.runtime.request import BOTH, Request
from coscrew_codegen.scene.function_selection import (
    CONTACTS,
    FREE,
    all_names,
    known_tiers,
    left_out,
    tiers_in_ranges,
    together,
)
from coscrew_codegen.scene.names import listed
from coscrew_codegen.scene.scene import Scene

if TYPE_CHECKING:
    from coscrew_codegen.runtime.arrays.namespace import Arrays
    from coscrew_codegen.runtime.lanes import CompiledLanes


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

    request: Request
    interface: SceneInterface
    double: callables.Functions[np.float64]
    single: callables.Functions[np.float32]
    compiler: str  # its version and flags; "" if the generated Python runs
    library: str = ""  # its key in the cache
    plain: Kernels | None = None  # of a tier's: the scene's own

    def _in_tier(self, name: str) -> Kernels | ModuleType:
        """The functions in a tier that the scene selects, compiled on first use."""
        if name.startswith("_"):
            raise AttributeError(name)
        if name in self.interface.tiers:
            if name in tiers_in_ranges():
                vars(self)[name] = module = scene_library.in_fixed_point(self.functions, name)
                return module
            with at_callers_line():
                vars(self)[name] = in_tier = in_tier_of(self, name)
            return in_tier
        hint = f"; it was not selected: tiers=[{name!r}]" if name in known_tiers()[1:] else ""
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
        @property
        def fixed(self) -> ModuleType: ...
    else:
        __getattr__ = _in_tier

    @property
    def scene(self) -> Scene | None:
        """The scene; None if the functions were given."""
        return self.request.scene

    @property
    def selected(self) -> tuple[str, ...]:
        """The names of the selected functions; () if those of the scene."""
        return self.request.selected

    @property
    def precisions(self) -> tuple[str, ...]:
        """The precisions in which there are functions."""
        return self.request.precisions

    @property
    def functions(self) -> SceneFunctions:
        """The plain functions as Programs, derived again if the kernels came from the cache."""
        return self.request.functions()

    def _with(self, *names: str) -> Kernels:
        """Returns these kernels, or, if they lack functions of these names that the scene has,
        kernels of both, compiled when they are first needed."""
        own = tuple(x.name for x in self.interface.signatures)
        if self.scene is None or {*names} - {*CONTACTS, *FREE} <= {*own}:
            return self
        key = " ".join(("with", *names))
        if key not in vars(self):
            vars(self)[key] = kernels_for(self.scene, together(own, names), self.precisions)
        kernels: Kernels = vars(self)[key]
        return kernels

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
        """True if the functions are compiled C, not generated Python."""
        return bool(self.compiler)

    def _repr_html_(self) -> str:
        """The scene's tree, effects, functions and sizes, for notebooks."""
        from coscrew_codegen.backends.html.notebook import html

        return html(self.scene, self.interface, self.compiler)

    def arrays(self, xp: ModuleType) -> Arrays:
        """The functions on arrays of a library, with derivatives: jax.numpy, torch, cupy,
        array_api_strict, numpy.  Raises TypeError for others."""
        from coscrew_codegen.runtime.arrays.namespace import of_scene

        made: dict[ModuleType, Arrays] = vars(self).setdefault("_arrays", {})
        if xp not in made:
            made[xp] = of_scene(xp, self.interface, lambda: self.functions,
                                {"double": self.double, "single": self.single},
                                scene_library.opened, self, self._derived)
        return made[xp]

    def _derived(self, name: str) -> SceneFunctions | None:
        """The function of this name, selected or not, if the scene can have it."""
        if self.scene is None or name not in all_names(self.scene):
            return None
        return request.of_scene(self.scene, (name,), self.precisions).functions()

    @functools.cached_property
    def _pickled(self) -> bytes:
        return packed((self.scene, self.selected, None if self.scene else self.functions))

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

        return CompiledLanes(self.request)

    def __copy__(self) -> Kernels:
        return self

    def __deepcopy__(self, memo: dict[int, object]) -> Kernels:
        return self

    def __repr__(self) -> str:
        tier = f"{self.interface.mark} " if self.interface.mark else ""
        return f"<{tier}kernels of {self.interface.name}: {self.compiler or 'pure NumPy'}>"


def load_scene(scene: Scene | Path | str, *, precision: str | None = None,
               implausible: str | None = None, functions: Sequence[str] | None = None,
               tiers: Sequence[str] | None = None,
               packages: Mapping[str, str | Path] | None = None,
               arguments: Mapping[str, str] | None = None,
               leave_out: Sequence[str] | None = None) -> Kernels:
    """The kernels of a scene, of a scene file or of a model's file alone, also by a name such as
    "robot_descriptions:panda": `.double` and `.single` hold the functions of its header.

    They are generated and compiled with the system's C compiler, $CC if set ("clang -O0" compiles
    long functions in a sixth of the time, for short runs); libraries are cached in $XDG_CACHE_HOME
    or ~/.cache.  Without a working compiler, a warning is issued and the generated Python runs.
    `precision` and `implausible` override the file's: a scene of precision "double" has no
    `single`; with implausible "warn", implausible bodies cause warnings. `functions` names
    functions to use instead of the scene's own selection; "default" stands for those of a scene
    that selects none, "all" for all it can have; `tiers` names tiers, to use likewise.  `packages`,
    `arguments` and `leave_out` are for the model's file, as the commands' --package, --argument and
    --leave-out.  Raises FunctionsError for unknown functions, TiersError for unknown tiers,
    TypeError for anything but a file or a Scene, ValueError for unknown words, RangeError for
    numbers that a precision cannot hold, and the errors of reading the scene."""
    functions, tiers = (_names(*x) for x in (("functions", functions, "energy"),
                                             ("tiers", tiers, "accurate")))
    from coscrew_codegen.scene.readers import model_arguments

    if isinstance(scene, (str, Path)):
        from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
        path = Path(scene)
        scene = read_scene(path, overrides=replace(
            model_arguments.overrides_of(packages, arguments, leave_out), precision=precision,
            implausible=implausible, functions=functions, tiers=tiers))
        for line in scene.model.implausible:
            warnings.warn(f"{path.name}: {line}", RuntimeWarning, stacklevel=2)
    elif not isinstance(scene, Scene):
        raise TypeError(f"load_scene: wanted the path of a scene file, or a Scene; "
                        f"got {type(scene).__name__}")
    else:
        from coscrew_codegen.scene.function_selection import selected_tiers

        model_arguments.refuse_given(
            "load_scene", precision=precision, implausible=implausible, packages=packages,
            arguments=arguments, leave_out=leave_out)
        scene = replace(scene, functions=functions or scene.functions,
                        tiers=selected_tiers(tiers) or scene.tiers)
    if line := left_out(scene):
        warnings.warn(f"{scene.name}: {line}", RuntimeWarning, stacklevel=2)
    with at_callers_line():
        return kernels_for(scene)


def _names(argument: str, given: Sequence[str] | None, example: str) -> tuple[str, ...]:
    """The names in a list; none for None.  Raises ValueError for an empty list."""
    names = () if given is None else listed(argument, given, example)
    if given is not None and not names:
        raise ValueError(f'{argument}: an empty list; wanted names, as ["{example}"], or None')
    return names


def kernels_for(scene: Scene, functions: Collection[str] = (),
                precisions: tuple[str, ...] = BOTH) -> Kernels:
    """The kernels of the scene's selected functions, or of those with these names that it has,
    compiled in these precisions: found in the cache, or made."""
    with at_callers_line():
        return _kernels(request.of_scene(scene, tuple(functions), precisions),
                        _compiler(scene.name))


def kernels_of(functions: SceneFunctions) -> Kernels:
    """The kernels of derived functions."""
    with at_callers_line():
        return _kernels(request.of_functions(functions), _compiler(functions.name))


def in_tier_of(plain: Kernels, name: str, part: SceneFunctions | None = None) -> Kernels:
    """The kernels in the tier of this name, or those of `part`, some of their functions; in pure
    NumPy where the scene's own are."""
    wanted = replace(plain.request, tier=name)
    if part:
        wanted = replace(wanted, selected=tuple(f.name for f in part.functions),
                         functions=lambda: part)
    return _kernels(wanted, compilation.compiler() if plain.compiled else None, plain)


@functools.lru_cache(maxsize=32)
def restored(pickled: bytes) -> Kernels:
    """The kernels of a pickled scene and its selected functions; made once per process."""
    scene, selected, functions = unpacked(pickled)
    return kernels_of(functions) if functions else kernels_for(scene, selected)


def _compiler(name: str) -> compilation.Compiler | None:
    """The compiler; None, with a warning, if none works."""
    try:
        return compilation.compiler()
    except compilation.CompilationError as error:
        warn(f"{name} runs in pure NumPy: {error}")
        return None


def _kernels(wanted: Request, using: compilation.Compiler | None, plain: Kernels | None = None
             ) -> Kernels:
    """The kernels: compiled or, if that fails, generated Python."""
    if using:
        try:
            made = scene_library.compiled(wanted, using)
        except compilation.CompilationError as error:
            warn(f"{wanted.title} runs in pure NumPy: {error}")
        else:
            checks = callables.checks(made.checks)
            return _gathered(wanted, made.interface, plain, lambda x, p: callables.compiled(
                made.interface, made.library.opened, checks, x, p), str(using), made.library.key)
    interface, modules = scene_library.in_numpy(wanted)
    return _gathered(wanted, interface, plain, lambda x, p: callables.in_numpy(
        getattr(modules[p.name], x.name), x))


def _gathered(wanted: Request, interface: SceneInterface, plain: Kernels | None,
              made: Callable[[Signature, Precision], callables.Made], compiler: str = "",
              key: str = "") -> Kernels:
    """The kernels, whose functions `made` returns."""
    double, single = (
        callables.gathered(interface, p, {
            x.name: made(x, p) for x in interface.signatures
            if p.name in interface.precisions and p.name in wanted.precisions})
        for p in PRECISIONS)
    kernels = Kernels(wanted, interface, cast("callables.Functions[np.float64]", double),
                      cast("callables.Functions[np.float32]", single), compiler, key, plain)
    for x in (double, single):
        x._kernels = kernels
    return kernels
