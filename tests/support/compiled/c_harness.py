"""Compiles C, and calls every kernel of the headers on NumPy arrays, row by row.

Rows are arrays of structs, as in C programs: matrices are stored column by column, while NumPy's
are stored row by row.  Knows names and types, but no arithmetic.
"""

import ctypes
import functools
import os
import shutil
import subprocess
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.backends.c.c_operations import (
    STRUCTS,
    c_name,
    c_type,
    is_pointer,
    parameters,
    returned,
)
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.program.values.quantity import Argument

C_FOLDER = Path(__file__).resolve().parents[3] / "generated" / "c"
INCLUDE = C_FOLDER / "include"


def _installed(*names: str) -> tuple[str, ...]:
    """The installed compilers; on a build server all, so that `run` reports missing ones."""
    results = tuple(name for name in names if os.environ.get("CI") or shutil.which(name))
    return results or names[:1]


COMPILERS = _installed("gcc", "clang")
CXX_COMPILERS = _installed("g++", "clang++")
C11 = ("-std=c11",)
CXX17 = ("-x", "c++", "-std=c++17")
STRICT = ("-Wall", "-Wextra", "-Wconversion", "-Wdouble-promotion", "-Wshadow", "-pedantic",
          "-Werror")
EXACT = "-ffp-contract=off"
DIALECTS = (*((name, C11) for name in COMPILERS), *((name, CXX17) for name in CXX_COMPILERS))
"""(compiler, flags of its language)"""


def run(command: Sequence[str | Path]) -> str:
    """The command's output; unless it returns 0, the test fails with all of its output."""
    words = [str(word) for word in command]
    if shutil.which(words[0]) is None:
        pytest.fail(f"{words[0]} is not installed; these tests need it")
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode:
        pytest.fail(f"{' '.join(words)}\nreturned {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def in_parallel(commands: Sequence[Sequence[str | Path]]) -> None:
    """Run them all, as many at a time as there are processors."""
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(run, commands))


@functools.cache
def harness(folder: Path, compiler: str, flags: tuple[str, ...], tier: str = "",
            operations: tuple[Operation, ...] = OPERATIONS) -> ctypes.CDLL:
    """The kernels of a tier, in both precisions, as loops over rows; a library in this folder."""
    words = (compiler, *(flag.strip("-") for flag in flags), *filter(None, (tier,)))
    stem = folder / "-".join(words).replace("=", "-")
    sources = {stem.with_name(f"{stem.name}-{p.name}"): loops(p, tier, operations)
               for p in PRECISIONS}
    for path, text in sources.items():
        path.with_suffix(".c").write_text(text)
    options: tuple[str | Path, ...] = (*C11, *flags, "-fPIC", "-I", INCLUDE)
    in_parallel([(compiler, *options, "-c", f"{path}.c", "-o", f"{path}.o") for path in sources])
    run((compiler, "-shared", *(f"{path}.o" for path in sources), "-o", f"{stem}.so", "-lm"))
    return ctypes.CDLL(f"{stem}.so")


def loops(precision: Precision, tier: str, operations: tuple[Operation, ...]) -> str:
    """C: `void run_<kernel>(long n, rows of inputs and outputs)` for every operation."""
    header = f"ksl_{tier}" if tier else "ksl"
    return "\n".join([f"#include <ksl/{header}.h>",
                      *(_loop(op, precision, tier) for op in operations)])


def _loop(operation: Operation, precision: Precision, tier: str) -> str:
    written = {a.name for a in operation.outputs}

    def rows(a: Argument) -> str:
        const = "" if a.name in written else "const "
        star = f"*{a.name}" if not is_array(a) else f"(*{a.name})[{a.quantity.size}]"
        return f"{const}{c_type(a.quantity, precision)} {star}"

    declared = ", ".join(["long n", *map(rows, distinct(operation))])
    name = c_name(operation.name, precision)
    call = call_of(operation, precision, {a.name: f"{a.name}[i]" for a in distinct(operation)},
                   tier)
    return (f"void run_{name}({declared});\nvoid run_{name}({declared}) {{\n"
            f"  for (long i = 0; i < n; i++) {{ {call} }}\n}}\n")


def call_of(operation: Operation, precision: Precision, values: dict[str, str],
            tier: str = "") -> str:
    """The C statement that calls the kernel; `values` gives the lvalue of each argument."""
    passed = ", ".join(f"&{values[a.name]}" if is_pointer(operation, a) else values[a.name]
                       for a in parameters(operation))
    value = returned(operation)
    result = f"{values[value.name]} = " if value else ""
    name = c_name(operation.name, precision) + (f"_{tier}" if tier else "")
    return f"{result}{name}({passed});"


def distinct(operation: Operation) -> tuple[Argument, ...]:
    """Inputs, then outputs; arguments that are both occur once."""
    return tuple({a.name: a for a in (*operation.inputs, *operation.outputs)}.values())


def is_struct(argument: Argument) -> bool:
    """Returns whether C passes a struct (else a number or an array of numbers)."""
    return argument.quantity.name in STRUCTS


def is_array(argument: Argument) -> bool:
    """Returns whether C passes a plain array, as dc[2]."""
    return bool(argument.quantity.shape) and not is_struct(argument)


def call(library: ctypes.CDLL, operation: Operation, precision: Precision,
         inputs: Sequence[np.ndarray]) -> tuple[np.ndarray, ...]:
    """The outputs for these inputs, each (n, *shape) in C order."""
    n = len(inputs[0])
    rows = {a.name: _as_structs(x) for a, x in zip(operation.inputs, inputs, strict=True)}
    for output in operation.outputs:
        if output.name in rows:
            rows[output.name] = rows[output.name].copy()
        else:  # a number that no kernel writes, so that missing outputs are noticed
            shape = (n, *output.quantity.shape[::-1])
            rows[output.name] = np.full(shape, 0.123456789, precision.numpy_type)
    pointers = [rows[a.name].ctypes.data_as(ctypes.c_void_p) for a in distinct(operation)]
    getattr(library, f"run_{c_name(operation.name, precision)}")(ctypes.c_long(n), *pointers)
    return tuple(_transposed(rows[output.name]) for output in operation.outputs)


def _transposed(x: np.ndarray) -> np.ndarray:
    return x.swapaxes(-1, -2) if x.ndim == 3 else x


def _as_structs(x: np.ndarray) -> np.ndarray:
    return np.ascontiguousarray(_transposed(x))
