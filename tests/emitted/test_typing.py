"""The stubs: type checkers see every operation, its arguments and its result."""

import ast
import inspect
import subprocess
import sys
from pathlib import Path

import pytest

import coscrew
import coscrew_codegen
from coscrew_codegen.algebra.operations import OPERATIONS
from coscrew_codegen.backends.python_extension import scene_calls
from coscrew_codegen.dynamics import derive
from coscrew_codegen.runtime import callables
from coscrew_codegen.scene.integrators import EMITTED
from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides, read_scene

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

SCENES = """
import numpy as np
from numpy.typing import NDArray
import coscrew_codegen
from coscrew_codegen import load_scene

arm = load_scene("arm.toml")
q: NDArray[np.float64] = arm.neutral_q
tau: NDArray[np.float64] = arm.double.inverse_dynamics(q, [0.0], [0.0])
narrow: NDArray[np.float32] = arm.single.forward_dynamics(q, [0.0], tau=tau,
                                                          out=tau.astype(np.float32))
jacobian: NDArray[np.float64] = arm.double.jacobian_hand(q)
q, v = arm.double.step_rk4(0.1, q, [0.0], out=(q, None))
names: tuple[str, ...] = arm.joints
version: str = coscrew_codegen.__version__
"""

WRONG_SCENES = {
    "text: str = arm.double.mass_matrix(q)": "Incompatible types in assignment",
    "one: NDArray[np.float64] = arm.double.step_rk4(0.1, q, v)": "Incompatible types in assignment",
    "load_scene(3)": 'incompatible type "int"',
    "arm.triple": 'has no attribute "triple"',
    "arm.double.energy(q, v, out=3)": 'incompatible type "int"',
}

WRONG = {
    "coscrew.product_CoAdc(1)": "Missing positional argument",
    "coscrew.product_CoAd(1, 2)": 'has no attribute "product_CoAd"',
    "text: str = coscrew.double.dot_cs([1], [2])": "Incompatible types in assignment",
}


def check(program: str, tmp_path) -> subprocess.CompletedProcess:
    """mypy on a user's program, in a folder with nothing else, where coscrew is installed."""
    (tmp_path / "program.py").write_text(program)
    return subprocess.run([sys.executable, "-m", "mypy", "--strict", "--follow-imports=silent",
                           "program.py"], cwd=tmp_path, text=True, capture_output=True)


def test_right_programs_are_accepted(tmp_path):
    done = check(PROGRAM, tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr


def test_wrong_programs_are_refused(tmp_path):
    done = check(PROGRAM + "\n".join(WRONG), tmp_path)
    for message in WRONG.values():
        assert message in done.stdout, done.stdout
    assert f"Found {len(WRONG)} errors" in done.stdout


def test_programs_with_scenes_are_checked(tmp_path):
    done = check(SCENES + "\n".join(WRONG_SCENES), tmp_path)
    lines = [x for x in done.stdout.splitlines() if ": error: " in x]
    assert len(lines) == len(WRONG_SCENES), done.stdout + done.stderr
    for line, (program, message) in zip(lines, WRONG_SCENES.items(), strict=True):
        assert message in line, program


def test_what_is_typed_is_there():
    stub = Path(coscrew.__file__).with_name("_steps.pyi").read_text()
    source = ast.parse(inspect.getsource(callables.Functions) + stub)
    typed = {node.target.id for node in ast.walk(source) if isinstance(node, ast.AnnAssign)
             and isinstance(node.target, ast.Name)}
    scene = Path(__file__).parents[2] / "examples" / "scenes" / "pendulum.toml"
    functions = derive(read_scene(scene, overrides=SceneOverrides(functions=("all",))))
    there = {x.name for x in scene_calls.callables(functions)}
    assert {x.step_name for x in EMITTED} <= typed <= there
    assert Path(coscrew_codegen.__file__).with_name("py.typed").exists()
    assert {"load_scene", "__version__"} <= {*dir(coscrew_codegen)} & {*coscrew_codegen.__all__}


@pytest.mark.parametrize("module", (coscrew, coscrew.double, coscrew.single))
def test_the_stubs_name_what_is_there(module):
    stub = ast.parse(Path(module.__file__).with_suffix(".pyi").read_text())
    typed = {node.name for node in stub.body if isinstance(node, ast.FunctionDef)}
    others = {"arrays", "get_include", "selfcheck", "unchecked", "mat3x3_is_rotation",
              "quaternion_is_unit"}
    assert typed - others == {operation.name for operation in OPERATIONS}
    for name in typed:
        assert callable(getattr(module, name)), name
