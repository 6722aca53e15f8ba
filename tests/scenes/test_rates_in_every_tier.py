"""Functions of points, of the centre of mass and of parameters have the same bits in C, in lanes
and in NumPy, and keep the bounds of the certified tier."""

from collections.abc import Iterator
from fractions import Fraction
from types import ModuleType

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from coscrew_codegen import load_scene
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes import mechanisms as m
from tests.support.scenes.evaluation import MULTIPRECISE, evaluator
from tests.support.scenes.generated_scenes import imported
from tests.support.scenes.kinds import Kind

pytestmark = pytest.mark.usefixtures("users_compiler")

NAMES = ("coriolis_matrix", "energy_gradients", "center_of_mass", "center_of_mass_velocity",
         "center_of_mass_jacobian", "centroidal_momentum_matrix", "centroidal_momentum_rate",
         "aligned_jacobian_b1", "aligned_twist_rate_b1", "point_jacobian_b1",
         "aligned_point_twist_rate_b1", "world_twist_rate_b1", "torque_regressor",
         "base_regressor", "linear_parameters", "base_parameters")
STATES = 40


def carrier() -> Scene:
    """A free body with another one on a revolute joint, friction and a spring."""
    moments = (3, 4, 5, Fraction(1, 2), Fraction(1, 3), Fraction(-1, 4))
    model = m.chain((Kind.FREE, m.Z, m.HERE, m.inertia(5, (Fraction(1, 2), 0, 1), moments)),
                    (Kind.REVOLUTE, m.Y, m.at(1, 0, Fraction(1, 2)),
                     m.inertia(2, (0, Fraction(1, 2), 1), moments)), name="carrier")
    return m.scene(model, m.gravity(0, 0, "-9.81"), m.applied("viscous", "j1", d=2),
                   m.applied("spring", "j1", k=7, q0=1), m.applied("armature", "j1", inertia=3))


@pytest.fixture(scope="module")
def package(tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    """The generated Python package."""
    return imported(derive(carrier(), NAMES), tmp_path_factory.mktemp("package"))


@pytest.fixture(scope="module")
def made() -> Iterator[tuple[SceneFunctions, Kernels, dict[str, np.ndarray]]]:
    """The functions, compiled, and states that single precision can hold."""
    scene, rng = carrier(), np.random.default_rng(1)
    q, v, a = rng.uniform(-1, 1, (STATES, 8)), *rng.uniform(-1, 1, (2, STATES, 7))
    q[:, 3:7] /= np.linalg.norm(q[:, 3:7], axis=1)[:, None]
    given = {"q": q, "v": v, "a": a, "r": rng.uniform(-1, 1, (STATES, 3))}
    given = {k: x.astype(np.float32).astype(float) for k, x in given.items()}
    yield (derive(scene, NAMES),
           load_scene(scene, functions=NAMES, tiers=["plain", "certified"]), given)


def flat(results: object) -> np.ndarray:
    """All components of all outputs."""
    parts = results if isinstance(results, tuple) else (results,)
    return np.concatenate([np.asarray(x).ravel() for x in parts])


@pytest.mark.parametrize("precision", ["double", "single"])
@pytest.mark.parametrize("name", NAMES)
def test_c_and_lanes_have_the_bits_of_numpy(made, package, name: str, precision: str) -> None:
    functions, kernels, given = made
    dtype = {"double": np.float64, "single": np.float32}[precision]
    function, in_numpy = (getattr(getattr(x, precision), name) for x in (kernels, package))
    inputs = [given[a.name].astype(dtype) for a in functions.named(name).program.inputs]
    many = function(*inputs)
    for k in range(0, STATES, 7):
        own = [x[k] for x in inputs]
        wanted = flat(in_numpy(*own))
        assert np.array_equal(flat(function(*own)), wanted)
        if inputs:
            parts = many if isinstance(many, tuple) else (many,)
            assert np.array_equal(flat(tuple(x[k] for x in parts)), wanted)


@pytest.mark.parametrize("name", NAMES)
def test_certified_bounds_hold(made, name: str) -> None:
    """Against 50 digits, with bounds below 1e-10."""
    functions, kernels, given = made
    program = functions.named(name).program
    for k in range(0, STATES, 5):
        own = [given[a.name][k] for a in program.inputs]
        results = getattr(kernels.certified.double, name)(*own)
        half = len(results) // 2
        values, bounds = flat(results[:half]), flat(results[half:])
        with mpmath.workdps(50):
            wanted = evaluator(program, MULTIPRECISE)([[mpf(float(y)) for y in x] for x in own])
            for x, bound, y in zip(values, bounds, wanted, strict=True):
                assert abs(mpf(float(x)) - y) <= bound <= 1e-10, name
