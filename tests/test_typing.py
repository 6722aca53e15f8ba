"""The stubs: type checkers see every operation, its arguments and its result."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

import coscrew
from coscrew_codegen.operations import OPERATIONS

PROGRAM = """
import numpy as np
from numpy.typing import NDArray
import coscrew

c: NDArray[np.float32] = np.ones(6, np.float32)
D = coscrew.SE3(np.eye(3), [1.0, 2.0, 3.0])
moved: NDArray[np.floating] = coscrew.product_CoAdc(D, c)
double: NDArray[np.float64] = coscrew.double.product_CoAdc(D, c)
single: NDArray[np.float32] = coscrew.single.product_CoAdc(D, c, out=c)
first, second = coscrew.vec3_swap([1, 2, 3], [4, 5, 6])
compiled: bool = coscrew.COMPILED
folder: str = coscrew.get_include()
"""

WRONG = {
    "coscrew.product_CoAdc(1)": "Missing positional argument",
    "coscrew.product_CoAd(1, 2)": 'has no attribute "product_CoAd"',
    "text: str = coscrew.double.dot_cs([1], [2])": "Incompatible types in assignment",
}


def check(program: str, tmp_path) -> subprocess.CompletedProcess:
    (tmp_path / "program.py").write_text(program)
    (tmp_path / "coscrew").symlink_to(Path(coscrew.__file__).parent)  # as an ordinary install
    return subprocess.run([sys.executable, "-m", "mypy", "--strict", "program.py"], cwd=tmp_path,
                          text=True, capture_output=True)


def test_right_programs_are_accepted(tmp_path):
    done = check(PROGRAM, tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr


def test_wrong_programs_are_refused(tmp_path):
    done = check(PROGRAM + "\n".join(WRONG), tmp_path)
    for message in WRONG.values():
        assert message in done.stdout, done.stdout
    assert f"Found {len(WRONG)} errors" in done.stdout


@pytest.mark.parametrize("module", (coscrew, coscrew.double, coscrew.single))
def test_the_stubs_name_what_is_there(module):
    stub = ast.parse(Path(module.__file__).with_suffix(".pyi").read_text())
    typed = {node.name for node in stub.body if isinstance(node, ast.FunctionDef)}
    assert typed - {"get_include", "selfcheck"} == {operation.name for operation in OPERATIONS}
    for name in typed:
        assert callable(getattr(module, name)), name
