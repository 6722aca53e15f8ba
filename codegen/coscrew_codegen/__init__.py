"""coscrew_codegen: derives spatial algebra symbolically and emits C and Python kernels.

Each stage is a function from one frozen value to the next; imports run one way, downwards:

    algebra            SymPy matrices: skew, Ad, CoAd, ad, coad          (the truth)
    quantity           vec3, mat3x3, SE3, screw, coscrew, …              (shapes, parts, units)
    operations/        one Operation each: inputs, outputs, formula      (the table)
    kernel, passes     Operation → let-bound SymPy, simplified
    schedule           Kernel → Program: the order of evaluation; programs: all the way
    recording/         arithmetic on Numbers → Program
    program/           Programs: error bounds, constant folding, evaluation; no SymPy
    tiers/             Program → Program: more accurate, faster, or with an error bound
    library            what targets receive: every operation's Program in every tier
    formats            double and single precision
    targets/           Programs → files: one Target per module, found like effects
    layout, emit       gathers the files of all targets; writes or compares them
    command_line       the commands; __main__ turns their end into an exit status

Scenes build on the operations' Programs:

    scene_files/       TOML, URDF → Scene: a model and the effects it calls for
    scene/             what a scene is: model, effects and their parameters, run; its checks
    mechanics/         Scene → Programs of its functions, by calling the operations' Programs
    effects/           one Effect per module: the forces and inertias that act in a scene
    scene_functions    what targets receive of a scene
    simulate/, cost/   compile, run, record, check; the cost of effects and of accuracy
    sweep/             many runs, on Dask
"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from coscrew_codegen.simulate.api import again as again
    from coscrew_codegen.simulate.api import run as run
    from coscrew_codegen.simulate.control import Controller as Controller
    from coscrew_codegen.simulate.load import load_scene as load_scene
    from coscrew_codegen.version import VERSION as __version__

__all__ = ["Controller", "__version__", "again", "load_scene", "run"]


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})


def __getattr__(name: str) -> object:
    """Import what `__all__` lists on first use, so that importing this package stays fast."""
    if name == "__version__":
        from coscrew_codegen.version import VERSION
        return VERSION
    if name == "load_scene":
        from coscrew_codegen.simulate.load import load_scene
        return load_scene
    if name == "run":
        from coscrew_codegen.simulate.api import run
        return run
    if name == "again":
        from coscrew_codegen.simulate.api import again
        return again
    if name == "Controller":
        from coscrew_codegen.simulate.control import Controller
        return Controller
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
