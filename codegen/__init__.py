"""coscrew_codegen: derives spatial algebra symbolically and emits C and Python kernels.

Each stage is a function from one frozen value to the next; imports run one way, downwards:

    algebra            SymPy matrices: skew, Ad, CoAd, ad, coad          (the truth)
    quantity           vec3, mat3x3, SE3, screw, coscrew, …              (shapes, parts, units)
    operations/        one Operation each: inputs, outputs, formula      (the table)
    kernel, passes     Operation → let-bound SymPy, simplified
    schedule           Kernel → Program: the order of evaluation; programs: all the way
    recording/         arithmetic on Numbers → Program
    program/           Programs: what is proved of them, how they fold; no SymPy
    tiers/             Program → Program, more accurate, faster, or with its bound
    library            what targets are given: every operation as every tier has it
    formats            double and single precision
    targets/           given Programs, its files: a Target each, found like effects
    layout, emit       the files of all targets, gathered, and written or compared
    command_line       the commands; __main__ is how they end

Scenes take the operations' Programs from there on:

    scene_files/       TOML, URDF → Scene: a model and the effects it calls for
    scene/             what a scene is: model, effects with their values, run; its checks
    mechanics/         Scene → Programs of its functions, the operations' Programs replayed
    effects/           one Effect each: what fills slots of the mechanics
    scene_functions    what targets see of a scene
    simulate/, cost/   compile, run, record, check; what effects and accuracy cost
"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from coscrew_codegen.simulate.load import load_scene as load_scene
    from coscrew_codegen.version import VERSION as __version__

__all__ = ["__version__", "load_scene"]


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})


def __getattr__(name: str) -> object:
    """`load_scene` is imported when it is used: to import this package costs nothing."""
    if name == "__version__":
        from coscrew_codegen.version import VERSION
        return VERSION
    if name == "load_scene":
        from coscrew_codegen.simulate.load import load_scene
        return load_scene
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
