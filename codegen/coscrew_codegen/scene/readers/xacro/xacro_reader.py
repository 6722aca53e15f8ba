"""xacro files: programs that write a URDF, run by PyPI's xacro without ROS.

`$(find PACKAGE)` is the folder that the scene or the command line gives for the package, or one
beside the file or above it, by its name or by that in its package.xml.
"""

import io
import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, redirect_stderr
from dataclasses import replace
from pathlib import Path
from threading import Lock

from coscrew_codegen.scene.mechanism.notices import Notice
from coscrew_codegen.scene.names import did_you_mean, nearest
from coscrew_codegen.scene.readers.contents import read_bytes
from coscrew_codegen.scene.readers.model_reader import ModelReader, ModelSource, Parts
from coscrew_codegen.scene.readers.packages import folders_of
from coscrew_codegen.scene.readers.scene_error import SceneError, shown
from coscrew_codegen.scene.readers.urdf.urdf import urdf_parts
from coscrew_codegen.scene.readers.xml_files.xml import SIZE

_ONE_AT_A_TIME = Lock()  # xacro keeps the state of a run in its modules


class _NoPackage(LookupError):
    """A package whose folder nobody knows; xacro repeats its message in errors of its own."""


class _Arguments(dict[str, str]):
    """The arguments given to a file; `wanted` collects the names for which it looks."""

    def __init__(self, given: Mapping[str, str]) -> None:
        super().__init__(given)
        self.wanted: set[str] = set()

    def __contains__(self, name: object) -> bool:
        self.wanted.add(str(name))
        return super().__contains__(name)

    def __getitem__(self, name: str) -> str:
        self.wanted.add(name)
        return super().__getitem__(name)


def _parts(source: ModelSource) -> Parts:
    text, warnings = expanded(source)
    try:
        parts = urdf_parts(source, text.encode())
    except SceneError as error:
        where = f"{error.where}, of what xacro makes of it" if error.where else ""
        raise SceneError(error.file, where, error.problem) from None
    notices = (Notice("xacro", "robot", f"xacro warns: {line}") for line in warnings)
    return replace(parts, notices=(*parts.notices, *notices),
                   places={x: f"{place} of what xacro makes of it"
                           for x, place in parts.places.items()})


def expanded(source: ModelSource) -> tuple[str, list[str]]:
    """The URDF that the file writes, and xacro's warnings."""
    import xacro

    path, arguments, printed = source.path, _Arguments(source.arguments), io.StringIO()
    read_bytes(path, SIZE)  # refuses what cannot be read
    try:
        with _ONE_AT_A_TIME, _finding(_finder(source)), redirect_stderr(printed):
            text = str(xacro.process_file(str(path), mappings=arguments).toxml())
    except Exception as error:  # of xacro, of expressions in the file, of its XML
        inner = Path((xacro.filestack or [path])[-1] or path).name
        where = "" if inner == path.name else f"in {inner}"
        raise SceneError(path, where, _in_words(error, arguments)) from None
    if strange := [x for x in source.arguments if x not in arguments.wanted]:
        raise SceneError(path, "", f"has no argument {shown(strange[0])}; "
                         f"{did_you_mean(strange[0], arguments.wanted)}")
    lines = re.sub(r"\x1b\[[0-9;]*m", "", printed.getvalue()).splitlines()
    return text, [x.removeprefix("warning: ") for x in lines if x.strip()]


def _in_words(error: Exception, arguments: _Arguments) -> str:
    """xacro's message on one line, with a remedy if an argument is missing."""
    cause: BaseException | None = error
    while cause and not isinstance(cause, _NoPackage):
        cause = cause.__cause__ or cause.__context__
    line = " ".join(str(cause or error).split()) or type(error).__name__
    line = re.sub(r"^<class '[\w.]+'>: ", "", line)  # of an error inside of an expression
    missing = re.fullmatch(r"Undefined substitution argument (.+?)( when .*)?", line)
    if not missing:
        return f"xacro: {line[:300]}"
    near = nearest(missing[1], arguments)
    hint = f"; did you mean {missing[1]!r} by the argument {near!r}?" if near else ""
    return (f"needs the argument {missing[1]!r}; wanted --argument {missing[1]}=VALUE, or "
            f"arguments = {{ {missing[1]} = … }} in the scene{hint}")


@contextmanager
def _finding(find: Callable[[str], str]) -> Iterator[None]:
    """Lets `find` answer $(find PACKAGE), and find() in expressions."""
    from xacro import substitution_args

    before, entry = substitution_args._eval_find, substitution_args._eval_dict["find"]
    substitution_args._eval_find = substitution_args._eval_dict["find"] = find
    try:
        yield
    finally:
        substitution_args._eval_find, substitution_args._eval_dict["find"] = before, entry


def _finder(source: ModelSource) -> Callable[[str], str]:
    """A function from a package's name to its folder.  Raises _NoPackage if there is none."""
    def find(name: str) -> str:
        for folder in folders_of(name, source):
            return str(folder)
        raise _NoPackage(f"package {name!r} is not beside the file or above it; wanted --package "
                         f"{name}=FOLDER, or packages = {{ {name} = \"FOLDER\" }} in the scene")
    return find


READER = ModelReader(
    "xacro", (".xacro", ".urdf.xacro"), "a program that writes a URDF, with arguments and "
    "packages; it is run, as its expressions are Python: only files that you trust", _parts,
    modules=("xacro",), extra="xacro", takes_packages=True, takes_arguments=True)
