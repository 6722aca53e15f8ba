"""Searches at length for the largest errors of kernels whose bounds are not proved.

`python -m tests.search --minutes M [KERNEL …]` climbs (climb.c) for M minutes of processor time for
each kernel and precision.  The result of each slice of that time is saved in build/search, so that
an interrupted search can be continued.  Errors are estimated in long double; each champion, the
input with the largest error so far, is confirmed in 60 digits, as are inputs for which the estimate
is not usable.  If a kernel or its search has changed since, its champions stay and its time starts
anew. Right Jacobians are the left ones of -v, bit for bit except for signs, and functions that work
in place are those that return: these are not searched again.
"""

import hashlib
import json
import os
import subprocess
from collections.abc import Iterator
from dataclasses import asdict, dataclass, field
from pathlib import Path

from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from tests.hard_cases.climb_case import parameters, parts, text_of
from tests.hard_cases.corpus import TABLE, Case, load, save
from tests.support.compiled.c_harness import INCLUDE
from tests.support.truth.attack import plain_program
from tests.support.truth.backward import BACKWARD
from tests.support.truth.judge import ratio

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "build" / "search"
SLICE = 60.0  # seconds

SAME = {"SO3_rightJacobian": "SO3_leftJacobian", "SE3_rightJacobian": "SE3_leftJacobian",
        "SO3_rightJacobianInverse": "SO3_leftJacobianInverse",
        "SE3_rightJacobianInverse": "SE3_leftJacobianInverse",
        "mat3x3_normalize": "mat3x3_normalized"}
SEARCHED = tuple(op for op in TABLE.values()
                 if (op.normwise or op.name in BACKWARD) and op.name not in SAME)
NAMES = tuple(op.name for op in SEARCHED)


@dataclass
class Found:
    """Time for which a kernel was searched, and each group's champion: error in u, parameters,
    inputs."""

    kernel: str = ""  # digest of the searched code
    seconds: float = 0.0
    slices: int = 0
    errors: list[float] = field(default_factory=list)
    parameters: list[list[str]] = field(default_factory=list)
    inputs: list[list[str]] = field(default_factory=list)
    of_bound: list[float] = field(default_factory=list)  # confirmed
    broken: list[list[str]] = field(default_factory=list)  # inputs without a usable estimate

    @property
    def worst(self) -> float:
        """The largest ratio of error to bound; infinite if a result is wrong."""
        return float("inf") if self.broken else max(self.of_bound)


def path_of(operation: Operation, precision: Precision) -> Path:
    return FOLDER / f"{operation.name}-{precision.name}.json"


def known(operation: Operation, precision: Precision) -> Found:
    path = path_of(operation, precision)
    return Found(**json.loads(path.read_text())) if path.exists() else Found()


def climb(operation: Operation, precision: Precision, seconds: float) -> Iterator[Found]:
    """The results after each slice, until the kernel has been searched for this time."""
    result, kernel = known(operation, precision), _digest(operation, precision)
    if result.kernel != kernel:
        result = Found(kernel, slices=result.slices, parameters=result.parameters)
    if result.seconds < seconds:
        program = compiled(operation, precision, FOLDER)
    while result.seconds < seconds:
        length = min(SLICE, seconds - result.seconds)
        result = after(operation, precision, result, length, program)
        _kept(path_of(operation, precision), json.dumps(asdict(result), indent=1))
        yield result


def after(operation: Operation, precision: Precision, before: Found, length: float,
          program: Path, rounds: int = 0) -> Found:
    """The results after this many more seconds, and at least so many climbs."""
    earlier = [x for row in before.parameters for x in row]
    text = subprocess.run([program, str(before.slices + 1), str(length), str(rounds), *earlier],
                          check=True, capture_output=True, text=True).stdout
    result = Found(before.kernel, before.seconds + length, before.slices + 1,
                   broken=before.broken)
    given, free = sum(a.quantity.size for a in operation.inputs), parameters(operation)

    def of_bound(numbers: list[str]) -> float:
        row = [float.fromhex(x) for x in numbers]
        return ratio(operation, precision, "plain", row[:given], row[given:])

    for line in text.splitlines():
        first, *numbers = line.split()
        if first == "?":
            if of_bound(numbers) > 1:
                result.broken.append(numbers[:given])
            continue
        result.errors.append(float(first))
        result.parameters.append(numbers[:free])
        result.inputs.append(numbers[free:free + given])
        result.of_bound.append(of_bound(numbers[free:]))
    return result


def compiled(operation: Operation, precision: Precision, folder: Path) -> Path:
    """The program that climbs."""
    folder.mkdir(parents=True, exist_ok=True)
    stem = folder / f"{operation.name}-{precision.name}"
    case = stem.with_suffix(".h")
    _kept(case, text_of(operation, precision))
    subprocess.run(["gcc", "-std=gnu11", "-O2", "-ffp-contract=off", "-I", INCLUDE,
                    f'-DCASE="{case}"', Path(__file__).with_suffix(".c"), "-o", stem, "-lm"],
                   check=True)
    return stem


def _digest(operation: Operation, precision: Precision) -> str:
    """A digest of the kernel, the domain of its inputs and its truth."""
    text = f"{text_of(operation, precision)}{plain_program(operation).instructions}"
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def _kept(path: Path, text: str) -> None:
    part = path.with_suffix(".part")
    part.write_text(text)
    os.replace(part, path)


def search(names: list[str], minutes: float, append: bool) -> int:
    """Climb for this time, beginning with short searches of all; print each kernel's figures.
    Returns how many kernels exceed their bounds."""
    operations = [TABLE[name] for name in names] or list(SEARCHED)
    targets = [(op, precision) for op in operations for precision in PRECISIONS]
    violations = 0
    for budget in (*(m for m in (1, 5) if m < minutes), minutes):
        for operation, precision in targets:
            for _ in climb(operation, precision, 60 * budget):
                pass
            print(line_of(operation, precision), flush=True)
    for operation, precision in targets:
        result = known(operation, precision)
        violations += result.worst > 1
        if append:
            origin = f"search --minutes {result.seconds / 60:g}"
            new = [Case(operation, precision, tuple(map(float.fromhex, row)), origin)
                   for row in (*result.inputs, *result.broken)]
            save((*load(), *new))
    return violations


def line_of(operation: Operation, precision: Precision) -> str:
    """Name, precision, minutes, each part's error in u beside the stated one, confirmed ratio."""
    result = known(operation, precision)
    names = [bound.part for bound in operation.normwise] or ["residual"]
    figures = ", ".join(f"{name} {error:.2f} of {part.k} u" for name, error, part in
                        zip(names, result.errors, parts(operation), strict=True))
    return (f"{operation.name} {precision.name}, {result.seconds / 60:g} min: {figures}; "
            f"{result.worst:.3f} of the bound")
