"""The hard cases in tests/hard_cases: one file per family, one case per line.

    operation precision : components of all inputs, hexadecimal, row by row : where it is from

Expected results are never stored; tests compute them exactly.
"""

import os
import tempfile
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from coscrew_codegen.algebra.operations import FAMILIES, OPERATIONS, Operation
from coscrew_codegen.program.values.formats import PRECISIONS, Precision

FOLDER = Path(__file__).parent
TABLE = {op.name: op for op in OPERATIONS}
_PRECISIONS = {precision.name: precision for precision in PRECISIONS}


class CorpusError(ValueError):
    """A line that is no case; the message says which and why."""


@dataclass(frozen=True)
class Case:
    """Inputs of one call, and their origin."""

    operation: Operation
    precision: Precision
    inputs: tuple[float, ...]
    origin: str

    @property
    def line(self) -> str:
        """The case as a line of its file."""
        numbers = " ".join(x.hex() for x in self.inputs)
        return f"{self.operation.name} {self.precision.name} : {numbers} : {self.origin}"


def size(operation: Operation) -> int:
    """Number of components of all inputs."""
    return sum(a.quantity.size for a in operation.inputs)


def parse(line: str, where: str) -> Case:
    """The case a line holds; `where` names the line in errors."""

    def wrong(message: str) -> CorpusError:
        return CorpusError(f"{where}: {message}")

    parts = [part.strip() for part in line.split(" : ", 2)]
    if len(parts) != 3 or not parts[2]:
        raise wrong("wanted 'operation precision : inputs : origin'")
    names = parts[0].split()
    if len(names) != 2:
        raise wrong(f"wanted 'operation precision', got {parts[0]!r}")
    if names[0] not in TABLE:
        raise wrong(f"no operation is called {names[0]!r}")
    if names[1] not in _PRECISIONS:
        raise wrong(f"wanted one of {', '.join(_PRECISIONS)}, got {names[1]!r}")
    operation, precision = TABLE[names[0]], _PRECISIONS[names[1]]
    try:
        inputs = tuple(map(float.fromhex, parts[1].split()))
    except (ValueError, OverflowError) as error:
        raise wrong(f"wanted hexadecimal floats: {error}") from None
    if len(inputs) != size(operation):
        raise wrong(f"{operation.name} takes {size(operation)} components, got {len(inputs)}")
    with np.errstate(over="ignore"):
        if not all(np.isfinite(x) and x == float(np.dtype(precision.numpy_type).type(x))
                   for x in inputs):
            raise wrong(f"wanted finite numbers of {precision.name} precision")
    return Case(operation, precision, inputs, parts[2])


def load(folder: Path = FOLDER) -> tuple[Case, ...]:
    """All cases, in the order of the families' files."""
    return tuple(case for family in FAMILIES for case in _load_file(folder / f"{family}.txt"))


def _load_file(path: Path) -> list[Case]:
    if not path.exists():
        return []
    return [parse(line, f"{path.name}:{number}")
            for number, line in enumerate(path.read_text().splitlines(), start=1)
            if line and not line.startswith("#")]


def save(cases: Iterable[Case], folder: Path = FOLDER) -> None:
    """Write all files anew, each in one step, sorted as the table of operations is; cases that
    have the same inputs are kept once."""
    order = {op.name: number for number, op in enumerate(OPERATIONS)}
    unique: dict[tuple[object, ...], Case] = {}
    for case in cases:
        unique.setdefault((case.operation.name, case.precision.name, case.inputs), case)
    ordered = sorted(unique.values(),
                     key=lambda c: (order[c.operation.name], -c.precision.bytes))
    for family in FAMILIES:
        lines = [case.line for case in ordered if case.operation.family == family]
        if lines:
            _replace(folder / f"{family}.txt", "\n".join([_HEAD, *lines, ""]))


_HEAD = "# operation precision : components of all inputs, row by row : where the case is from"


def _replace(path: Path, text: str) -> None:
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    with os.fdopen(handle, "w") as file:
        file.write(text)
    os.chmod(name, 0o644)
    os.replace(name, path)
