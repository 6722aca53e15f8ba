"""Inputs for measuring operations: benign ones, hard ones, and a corpus of hard cases.

Rows hold all input components of one call.  Seeded by the operation's name: the same numbers on
every machine."""

import random
from pathlib import Path

import numpy as np
from gmpy2 import mpq

from coscrew_codegen.algebra.domains import Generator, holds_less, ordinary
from coscrew_codegen.algebra.exact import exact_functions, is_polynomial
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.program.values.quantity import Argument
from coscrew_codegen.reports.kernels import ReportError

Corpus = dict[tuple[str, str], tuple[tuple[float, ...], ...]]  # by operation and precision

_SPREAD = {"double": 40, "single": 8}  # sizes go from 2^-spread to 2^spread


def benign(operation: Operation, precision: Precision, count: int, seed: int) -> np.ndarray:
    """Numbers about 1 within the arguments' domains: rotations are orthonormal, and so on."""
    numbers = _generator(operation, precision, seed, 0)
    angles = np.pi * (1 - 2 * numbers.random(count))
    return _drawn(operation, precision, numbers, angles)


def hard(operation: Operation, precision: Precision, count: int, seed: int) -> np.ndarray:
    """Draws hard inputs: for polynomials, numbers of very different sizes, in half of the rows with
    one result nearly cancelled; for others, angles about 0 and π, and arguments as small as
    2^-spread."""
    numbers = _generator(operation, precision, seed, 1)
    if is_polynomial(operation):
        rows = numbers.normal(size=(count, _size(operation)))
        rows *= np.exp2(numbers.uniform(-1, 1, rows.shape) * _SPREAD[precision.name])
        rows = rows.astype(precision.numpy_type)
        chooser = random.Random(seed)
        for row in rows[count // 2:]:
            cancel(operation, row, chooser)
        return rows
    small = np.exp2(-numbers.uniform(0, _SPREAD[precision.name], count))
    angles = np.where(numbers.random(count) < 0.5, small, np.pi - small)
    rows = _drawn(operation, precision, numbers, angles)
    scales = np.exp2(numbers.uniform(-_SPREAD[precision.name], 0, (count, len(operation.inputs))))
    free = [holds_less(a) for a in operation.inputs]
    sizes = [a.quantity.size for a in operation.inputs]
    factors = np.repeat(np.where(free, scales, 1.0), sizes, axis=1)
    return np.asarray(rows * factors, precision.numpy_type)


def cancel(operation: Operation, row: np.ndarray, chooser: random.Random) -> None:
    """Changes one input so that a result that is linear in it nearly vanishes, at most as far as
    the input's last bits allow."""
    exact, _ = chooser.choice(exact_functions(operation))
    values = [mpq(float(x)) for x in row]
    for place in chooser.sample(range(len(values)), len(values)):
        at = {t: exact(*values[:place], mpq(t), *values[place + 1:]) for t in (0, 1, 2)}
        slope = at[1] - at[0]
        if slope and at[2] - at[1] == slope:
            root = -at[0] / slope
            if root and abs(root) < 2**60 and abs(root) > mpq(1, 2**60):
                row[place] = float(root * (1 + mpq(1, 2**chooser.randrange(1, 64))))
                return


def split(operation: Operation, rows: np.ndarray) -> tuple[np.ndarray, ...]:
    """The rows as the operation's arguments, each (n, *shape)."""
    edges = np.cumsum([a.quantity.size for a in operation.inputs])[:-1]
    return tuple(np.ascontiguousarray(part).reshape(len(rows), *a.quantity.shape) for part, a in
                 zip(np.split(rows, edges, axis=1), operation.inputs, strict=True))


def corpus(folder: Path) -> Corpus:
    """The hard cases in the folder's *.txt, lines `operation precision : components : origin`, the
    components of all inputs, row by row, in hex; # starts a comment.  Raises ReportError."""
    sizes = {operation.name: _size(operation) for operation in OPERATIONS}
    results: dict[tuple[str, str], list[tuple[float, ...]]] = {}
    for path in sorted(folder.glob("*.txt")):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if not line.partition("#")[0].strip():
                continue
            try:
                names, components, _ = line.split(":", 2)
                name, precision = names.split()
                values = tuple(map(float.fromhex, components.split()))
            except (ValueError, OverflowError):
                raise ReportError(f"{path.name}:{number}: wanted 'operation precision : numbers in "
                                  f"hex : origin'; got {line!r}") from None
            if precision not in (p.name for p in PRECISIONS) or len(values) != sizes.get(name):
                raise ReportError(f"{path.name}:{number}: {name!r} {precision!r} with "
                                  f"{len(values)} components is no operation's input")
            results.setdefault((name, precision), []).append(values)
    return {key: tuple(rows) for key, rows in results.items()}


def _generator(operation: Operation, precision: Precision, seed: int, kind: int) -> Generator:
    return np.random.default_rng([seed, kind, precision.bytes, *operation.name.encode()])


def _size(operation: Operation) -> int:
    return sum(a.quantity.size for a in operation.inputs)


def _drawn(operation: Operation, precision: Precision, numbers: Generator,
           angles: np.ndarray) -> np.ndarray:
    def draw(argument: Argument) -> np.ndarray:
        quantity = argument.quantity
        drawn = ordinary(argument)
        return drawn(numbers, angles, quantity.size) if drawn else numbers.normal(
            size=(len(angles), quantity.size))

    return np.concatenate([draw(a) for a in operation.inputs], axis=1).astype(precision.numpy_type)
