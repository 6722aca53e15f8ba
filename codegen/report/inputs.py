"""Inputs that operations are measured on: benign ones, hard ones, and those of a hard-case corpus.

Rows hold all input components of one call.  Seeded by the operation's name: the same numbers on
every machine.
"""

import math
import random
from collections.abc import Callable
from pathlib import Path

import numpy as np
from gmpy2 import mpq

from coscrew_codegen.exact import exact_functions, is_polynomial
from coscrew_codegen.formats import PRECISIONS, Precision
from coscrew_codegen.operations import OPERATIONS, Operation
from coscrew_codegen.quantity import Argument
from coscrew_codegen.report import ReportError

Generator = np.random.Generator
Corpus = dict[tuple[str, str], tuple[tuple[float, ...], ...]]  # by operation and precision

_SPREAD = {"double": 40, "single": 8}  # sizes go from 2^-spread to 2^spread


def benign(operation: Operation, precision: Precision, count: int, seed: int) -> np.ndarray:
    """Numbers about 1; rotations are rotations, and (sin θ, cos θ) is of an angle."""
    numbers = _generator(operation, precision, seed, 0)
    angles = np.pi * (1 - 2 * numbers.random(count))
    return _drawn(operation, precision, numbers, angles)


def hard(operation: Operation, precision: Precision, count: int, seed: int) -> np.ndarray:
    """Polynomials: sizes differ greatly, and in half of the rows one result nearly cancels.
    Others: angles about 0 and π, arguments as small as 2^-spread."""
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
    free = [_drawing(a) is None for a in operation.inputs]
    sizes = [a.quantity.size for a in operation.inputs]
    factors = np.repeat(np.where(free, scales, 1.0), sizes, axis=1)
    return (rows * factors).astype(precision.numpy_type)


def cancel(operation: Operation, row: np.ndarray, chooser: random.Random) -> None:
    """Change one input so that one result, linear in it, nearly vanishes: to the input's last bit
    or so, or to any part of that."""
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
    components of all inputs, row by row, in hex; # starts a remark.  Raises ReportError."""
    sizes = {operation.name: _size(operation) for operation in OPERATIONS}
    found: dict[tuple[str, str], list[tuple[float, ...]]] = {}
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
            found.setdefault((name, precision), []).append(values)
    return {key: tuple(rows) for key, rows in found.items()}


def _generator(operation: Operation, precision: Precision, seed: int, kind: int) -> Generator:
    return np.random.default_rng([seed, kind, precision.bytes, *operation.name.encode()])


def _size(operation: Operation) -> int:
    return sum(a.quantity.size for a in operation.inputs)


def _drawn(operation: Operation, precision: Precision, numbers: Generator,
           angles: np.ndarray) -> np.ndarray:
    def draw(argument: Argument) -> np.ndarray:
        quantity = argument.quantity
        drawn = _drawing(argument)
        return drawn(numbers, angles, quantity.size) if drawn else numbers.normal(
            size=(len(angles), quantity.size))

    return np.concatenate([draw(a) for a in operation.inputs], axis=1).astype(precision.numpy_type)


def _axes(numbers: Generator, angles: np.ndarray, size: int) -> np.ndarray:
    """Of length 1."""
    axes = numbers.normal(size=(len(angles), size))
    return axes / np.linalg.norm(axes, axis=1, keepdims=True)


def _rotations(numbers: Generator, angles: np.ndarray, _: int) -> np.ndarray:
    """R = I + sin θ k~ + (1 - cos θ) k~², about random axes; row by row."""
    x, y, z = _axes(numbers, angles, 3).T
    zero = np.zeros_like(x)
    k = np.stack([zero, -z, y, z, zero, -x, -y, x, zero], axis=1).reshape(-1, 3, 3)
    sine, versine = np.sin(angles)[:, None, None], 2 * np.sin(angles / 2)[:, None, None]**2
    return (np.eye(3) + sine * k + versine * (k @ k)).reshape(-1, 9)


def _displacements(numbers: Generator, angles: np.ndarray, _: int) -> np.ndarray:
    R = _rotations(numbers, angles, 9).reshape(-1, 3, 3)
    t = numbers.normal(size=(len(angles), 3, 1))
    return np.concatenate([R, t], axis=2).reshape(-1, 12)


def _quaternions(numbers: Generator, angles: np.ndarray, _: int) -> np.ndarray:
    """(k sin θ/2; cos θ/2), about random axes."""
    half = angles[:, None] / 2
    return np.hstack([np.sin(half) * _axes(numbers, angles, 3), np.cos(half)])


def _sines_and_cosines(numbers: Generator, angles: np.ndarray, _: int) -> np.ndarray:
    return np.stack([np.sin(angles), np.cos(angles)], axis=1)


def _positive_definite(numbers: Generator, angles: np.ndarray, size: int) -> np.ndarray:
    """I + X X^T, row by row."""
    n = math.isqrt(size)
    X = numbers.normal(size=(len(angles), n, n))
    return (np.eye(n) + X @ X.swapaxes(1, 2)).reshape(-1, size)


def _inertias(numbers: Generator, angles: np.ndarray, size: int) -> np.ndarray:
    """Of the same bodies, moments about the centre of mass: I - (h·h 1 - h h^T) / m."""
    B = _spatial_inertias(numbers, angles, size)
    h = B[:, 1:4] / np.sqrt(B[:, :1])
    x, y, z = h.T
    own = np.stack([y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z], axis=1)
    return np.hstack([B[:, :4], (B[:, 4:] - own)[:, [0, 1, 2, 3, 5, 4]]])


def _spatial_inertias(numbers: Generator, angles: np.ndarray, _: int) -> np.ndarray:
    """Σ m (1, r, r·r 1 - r r^T) of a few points: of bodies that can be."""
    shape = (len(angles), 6)
    m, (x, y, z) = 0.1 + numbers.random(shape), numbers.normal(size=(3, *shape))
    return np.stack([np.sum(m * part, axis=1) for part in (
        1, x, y, z, y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z)], axis=1)


def _fractions(numbers: Generator, angles: np.ndarray, size: int) -> np.ndarray:
    """Of the way from one to another."""
    return numbers.random((len(angles), size))


# Quantities that are more than so many numbers, and arguments that are more than their quantity.
_DRAWN: dict[str, Callable[[Generator, np.ndarray, int], np.ndarray]] = {
    "mat3x3": _rotations, "SE3": _displacements, "dc": _sines_and_cosines,
    "quaternion": _quaternions, "inertia": _inertias,
    "spatial_inertia": _spatial_inertias, "axis": _axes, "k": _fractions,
    "A": _positive_definite, "Ic": _positive_definite}


def _drawing(argument: Argument) -> Callable[[Generator, np.ndarray, int], np.ndarray] | None:
    return _DRAWN.get(argument.name, _DRAWN.get(argument.quantity.name))
