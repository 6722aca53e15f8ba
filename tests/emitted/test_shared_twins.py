"""Kernels of single precision that share the text of double are those of a package that has single
precision alone: bits, docstrings, signatures."""

import subprocess
import sys
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import coscrew
import coscrew.certified
from coscrew_codegen.__main__ import main
from coscrew_codegen.algebra.operations import OPERATIONS
from coscrew_codegen.backends.numpy.shared_twins import shared
from coscrew_codegen.program import Constant, Op
from tests.support.truth.attack import plain_program

KERNELS = """
import hashlib
import importlib
import inspect
import re
import sys
import zlib

import numpy as np

sys.path.insert(0, sys.argv[1])
ENDS = np.float32([0, -0.0, 1, -1, 1e-45, 1e-38, -3e-20, 1e-7, 3e5, 1e19, -3e38, np.inf, np.nan])
for tier in ("coscrew", "coscrew.certified"):
    kernels = importlib.import_module(f"{tier}.single")
    for name, kernel in sorted(vars(kernels).items()):
        if not hasattr(kernel, "signature"):
            continue
        rng = np.random.default_rng(zlib.crc32(name.encode()))
        given = []
        for shape in re.findall(r"\\(([^)]*)\\)", kernel.signature.split("->")[0]):
            shape = (90, *map(int, filter(None, shape.split(","))))
            numbers = rng.uniform(-2, 2, shape).astype(np.float32)
            ends = rng.choice(ENDS, shape)
            part = (0, 0.2, 0.9)[len(given) % 3]
            given.append(np.where(rng.random(shape) < part, ends, numbers))
        with np.errstate(all="ignore"):
            found = kernel(*given)
        digest = hashlib.sha256()
        for x in found if isinstance(found, tuple) else (found,):
            assert x.dtype == np.float32
            digest.update(np.where(np.isnan(x), np.float32(np.nan), x).tobytes())
        print(tier, name, digest.hexdigest(), inspect.signature(kernel),
              repr(inspect.getdoc(kernel)), kernel.__module__)
"""
GENERATED = Path(coscrew.__file__).parents[1]


def described(folder: Path) -> list[str]:
    """A line for each kernel of single precision of the package in this folder."""
    done = subprocess.run([sys.executable, "-W", "ignore", "-c", KERNELS, folder], text=True,
                          capture_output=True)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


def test_shared_kernels_are_those_of_single_precision_alone(tmp_path: Path):
    assert main(["generate", "--precision", "single", "--language", "python", "--output",
                 str(tmp_path)]) == 0
    assert not (tmp_path / "python/coscrew/double").exists()
    wanted, result = described(tmp_path / "python"), described(GENERATED)
    assert len(wanted) > 400
    assert [line for line, want in zip(result, wanted, strict=True) if line != want] == []


def test_most_text_is_shared():
    for tier in (coscrew, coscrew.certified):
        kernels = [(getattr(tier.single, op.name), getattr(tier.double, op.name))
                   for op in OPERATIONS if hasattr(tier.single, op.name)]
        same = sum(code_of(a) is code_of(b) for a, b in kernels)
        assert same > 0.8 * len(kernels)


def code_of(kernel):
    while hasattr(kernel, "__wrapped__"):
        kernel = kernel.__wrapped__
    return kernel.__code__


def test_programs_that_differ_in_an_operation_are_not_shared():
    program = plain_program(next(op for op in OPERATIONS if op.name == "cross_sc"))
    first, *others = program.instructions
    assert shared(program, program) is not None
    for wrong in ((*others,), (first._replace(op=Op.DIV), *others),
                  (first._replace(operands=first.operands[::-1]), *others)):
        assert shared(program, replace(program, instructions=wrong)) is None


@pytest.mark.parametrize("double, single, name", [
    (0.1, 0.1, False), (1e-300, 1e-30, True), (1e300, 1e30, True), (2.0**-30, 2.0**-30, False),
    (1 / 3, float(np.float32(1 / 3)), False), (1 / 3, float(np.float32(1 / 3)) * (1 + 2e-7), True)])
def test_a_constant_is_a_parameter_if_rounding_does_not_give_it(double, single, name):
    program = plain_program(next(op for op in OPERATIONS if op.name == "coscrew_scale"))
    first, *others = program.instructions
    scaled = [first._replace(operands=(first.operands[0], Constant(Fraction(x), Fraction(x))))
              for x in (double, single)]
    result = shared(*(replace(program, instructions=(x, *others)) for x in scaled))
    assert result is not None and bool(result.names) == name
