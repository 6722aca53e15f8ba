"""coscrew_codegen: derives spatial algebra symbolically and emits C and Python kernels.

Each stage is a function from one frozen value to the next.  Imports run one way, in the order in
which docs/architecture.md lists the packages:

    program        what a Program is: instructions, folding, derivatives
    algebra        the truth in SymPy, the table of operations, the way to Programs
    accuracy       Program → Program: more accurate, faster, or with an error bound
    scene          TOML, URDF → Scene: mechanism, effects, integrators, run
    dynamics       Scene → Programs of its functions, by calling the operations' Programs
    backends       Programs → files: one Target per module, found like effects
    runtime        Programs → functions that Python calls: compile, cache, load
    simulation     run, record, check, sweep
    reports        costs, errors and times; the reference
    cli            the commands; __main__ turns their end into an exit status
"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from coscrew_codegen.backends.version import VERSION as __version__
    from coscrew_codegen.runtime.load import load_scene as load_scene
    from coscrew_codegen.simulation.api import again as again
    from coscrew_codegen.simulation.api import run as run
    from coscrew_codegen.simulation.control import Controller as Controller
    from coscrew_codegen.simulation.run_adjoint import run_adjoint as run_adjoint

__all__ = ["Controller", "__version__", "again", "load_scene", "run", "run_adjoint"]


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})


def __getattr__(name: str) -> object:
    """Import what `__all__` lists on first use, so that importing this package stays fast."""
    if name == "__version__":
        from coscrew_codegen.backends.version import VERSION
        return VERSION
    if name == "load_scene":
        from coscrew_codegen.runtime.load import load_scene
        return load_scene
    if name == "run":
        from coscrew_codegen.simulation.api import run
        return run
    if name == "again":
        from coscrew_codegen.simulation.api import again
        return again
    if name == "Controller":
        from coscrew_codegen.simulation.control import Controller
        return Controller
    if name == "run_adjoint":
        from coscrew_codegen.simulation.run_adjoint import run_adjoint
        return run_adjoint
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
