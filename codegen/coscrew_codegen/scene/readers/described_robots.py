"""Robots by name, robot_descriptions:panda: the files that the package robot_descriptions has.

The package fetches the files of a robot on its first use, from public repositories."""

from dataclasses import replace
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

from coscrew_codegen.scene.names import did_you_mean
from coscrew_codegen.scene.readers.model_reader import ModelSource

_PACKAGE, _ENDING = "robot_descriptions", "_description"
SCHEME = f"{_PACKAGE}:"
_PATHS = ("URDF_PATH", "MJCF_PATH", "XACRO_PATH")
"""Names of the modules' paths; the first that a module has counts."""


def robot_source(name: str, source: ModelSource) -> ModelSource:
    """The source with the robot's file and, if that is a program, its packages and arguments,
    which those of the source override.

    Raises ValueError, with what was wanted, without the package, for an unknown robot, and for one
    that cannot be fetched or has no model."""
    if find_spec(_PACKAGE) is None:
        raise ValueError(f"needs the package {_PACKAGE}; run `pip install {_PACKAGE}`")
    word = name.removeprefix(SCHEME)
    robots = {x.removesuffix(_ENDING): x for x in import_module(_PACKAGE).DESCRIPTIONS}
    entry = robots.get(word.removesuffix(_ENDING))
    if entry is None:
        raise ValueError(f"is no robot of {_PACKAGE}; {did_you_mean(word, robots)}")
    try:
        module = import_module(f"{_PACKAGE}.{entry}")
    except Exception as error:  # of git, of the network, of the disk
        raise ValueError(f"cannot be fetched: {' '.join(str(error).split())[:200]}") from None
    which = next((x for x in _PATHS if hasattr(module, x)), None)
    if which is None:
        raise ValueError(f"has no model; wanted one of {', '.join(_PATHS)} in {module.__name__}")
    path, program = Path(getattr(module, which)), which == _PATHS[-1]
    arguments = getattr(module, "XACRO_ARGS", {}) if program else {}
    folders = getattr(module, "XACRO_PACKAGE_PATHS", {}) if program else {}
    return replace(source, path=path, arguments={**arguments, **source.arguments},
                   packages={**{x: Path(y) for x, y in folders.items()}, **source.packages})
