"""Derivatives of a scene's functions are functions like others: the same bits from C, in lanes and
from NumPy, in both precisions, and accurate and certified ones."""

from collections.abc import Sequence
from pathlib import Path
from types import ModuleType

import mpmath
import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.backends.python_extension import scene_calls
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import Signature
from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.compiled.c_harness import CXX_COMPILERS
from tests.support.compiled.flags import HASWELL, X86
from tests.support.each import each_precision
from tests.support.scenes.cuda_program import of_scene
from tests.support.scenes.cuda_runs import compared
from tests.support.scenes.evaluation import evaluator, without_errors
from tests.support.scenes.generated_scenes import imported
from tests.support.scenes.scene_texts import TIMED
from tests.support.scenes.scene_values import inputs, same_bits

STEP = "step_leapfrog_tau"
NAMES = ("difference", "difference_tangent", "chart", "inverse_dynamics_adjoint",
         "forward_dynamics_tangent", "energy_adjoint", "jacobian_lower_tangent", STEP,
         f"{STEP}_derivatives", f"{STEP}_tangent", f"{STEP}_adjoint")
TIERED = ("inverse_dynamics_tangent", "energy_adjoint", "difference")


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("derivatives") / "arm.toml"
    path.write_text(TIMED)
    return path


@pytest.fixture(scope="module")
def both(file: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Kernels, ModuleType]:
    """The compiled functions, and the generated package."""
    kernels = load_scene(file, functions=NAMES)
    return kernels, imported(kernels.functions, tmp_path_factory.mktemp("package"))


def drawn(function: Signature, kind: str, *lead: int) -> list[np.ndarray]:
    """Arguments of a function: quaternions of norm 1, parameters that are positive."""
    arguments = []
    for (name, _), x in zip(function.inputs, inputs(function, kind, *lead), strict=True):
        x = np.abs(x) if name == "p" else x
        if name in ("q", "q1"):
            x[..., :4] /= np.linalg.norm(x[..., :4], axis=-1, keepdims=True)
        arguments.append(x)
    return arguments


@each_precision
@pytest.mark.parametrize("lead", [(), (19,)], ids=str)
def test_bits_are_the_same(both, precision, lead) -> None:
    kernels, package = both
    functions = scene_calls.callables(kernels.functions)
    assert kernels.compiled and len(functions) == len(NAMES)
    for function in functions:
        arguments = drawn(function, precision.numpy_type, *lead)
        result, wanted = (getattr(getattr(x, precision.name), function.name)(*arguments)
                          for x in both)
        assert same_bits(result, wanted), function.name


@each_precision
def test_steps_have_the_bits_of_steps(both, precision) -> None:
    """q and v, from their derivatives, tangents and adjoints, too."""
    kernels = getattr(both[0], precision.name)
    described = {x.name: x for x in both[0].interface.signatures}
    for kind in ("derivatives", "tangent", "adjoint"):
        arguments = drawn(described[f"{STEP}_{kind}"], precision.numpy_type, 7)
        q, v = getattr(kernels, STEP)(*arguments[:len(described[STEP].inputs)])
        result = getattr(kernels, f"{STEP}_{kind}")(*arguments)
        assert same_bits(result[:2], (q, v)), kind


@pytest.mark.parametrize("names", [
    ("inverse_dynamics_derivatives", "forward_dynamics_derivatives", "difference", "chart"),
    ("energy_tangent", "inverse_dynamics_adjoint", f"{STEP}_derivatives")], ids=len)
def test_kernels_for_cuda_have_the_bits_of_c(file: Path, tmp_path: Path, names: Sequence[str]
                                             ) -> None:
    """Compiled as C++ that fuses products wherever it may."""
    scene = of_scene(derive(read_scene(file), names))
    flags = ("-O1", *(HASWELL if X86 else ()), "-ffp-contract=fast")
    assert compared(scene, tmp_path, CXX_COMPILERS[0], *flags) > 1000


@pytest.mark.parametrize("name", TIERED)
def test_accurate_and_certified(file: Path, name: str) -> None:
    """In double: the accurate result is within 2 u of the largest component of the exact one, the
    certified one within its bound, which is finite."""
    kernels = load_scene(file, functions=[name], tiers=["plain", "accurate", "certified"])
    program = kernels.functions.named(name).program
    arguments = drawn(kernels.interface.signatures[0], "float64", 6)
    accurate, certified = (getattr(getattr(kernels, x).double, name)(*arguments)
                           for x in ("accurate", "certified"))
    accurate = accurate if isinstance(accurate, tuple) else (accurate,)
    for row in range(6):
        with mpmath.workdps(50):
            exact = [float(x) for x in evaluator(program, without_errors("double"))(
                [[mpmath.mpf(float(y)) for y in np.ravel(x[row])] for x in arguments])]
        for k, a in enumerate(program.outputs):
            wanted = np.reshape(exact[:a.quantity.size], a.quantity.shape)
            del exact[:a.quantity.size]
            scale = np.abs(wanted).max(initial=0) * 2.0**-53
            assert np.abs(accurate[k][row] - wanted).max(initial=0) <= 2 * scale, (name, a.name)
            bound = certified[len(program.outputs) + k][row]
            error = np.abs(certified[k][row] - wanted)
            assert (error <= bound + scale).all() and np.isfinite(bound).all(), (name, a.name)
