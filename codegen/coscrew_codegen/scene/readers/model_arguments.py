"""Arguments of Python's functions on how a model's file is read, as the commands' options."""

from collections.abc import Mapping, Sequence
from pathlib import Path

from coscrew_codegen.scene.names import listed
from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides

Folders = Mapping[str, str | Path]
_EXAMPLES = {"packages": '{"ur_description": "ros/ur"}', "arguments": '{"prefix": "left_"}'}


def overrides_of(packages: Folders | None, arguments: Mapping[str, str] | None,
                 leave_out: Sequence[str] | None) -> SceneOverrides:
    """The settings for a file; None: none.  Raises TypeError for other types."""
    groups = () if leave_out is None else listed("leave_out", leave_out, "loops")
    return SceneOverrides(arguments=_pairs("arguments", arguments),
                          packages=_pairs("packages", packages), leave_out=groups)


def refuse_given(function: str, **of_file: object) -> None:
    """Raises TypeError if any of these settings of a file is given, beside what is no file."""
    if given := [name for name, x in of_file.items() if x]:
        verb = "are" if len(given) > 1 else "is"
        raise TypeError(f"{function}: {', '.join(given)} {verb} for a file; wanted the path of one")


def _pairs(argument: str, given: Folders | None) -> tuple[tuple[str, str], ...]:
    if given is None:
        return ()
    if not isinstance(given, Mapping) or not all(
            isinstance(x, str) and isinstance(y, str | Path) for x, y in given.items()):
        raise TypeError(f"{argument}: wanted a mapping from names to texts, as "
                        f"{_EXAMPLES[argument]}; got {given!r}")
    return tuple((name, str(value)) for name, value in given.items())
