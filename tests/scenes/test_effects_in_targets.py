"""Added mass, wind, motors with a speed without load, speed limits and tables: C, C of many states
and NumPy compute the same bits."""

from fractions import Fraction
from types import ModuleType

import numpy as np
import pytest

from coscrew_codegen.backends.python_extension import scene_calls
from coscrew_codegen.dynamics import derive
from coscrew_codegen.runtime.load import Kernels, kernels_of
from coscrew_codegen.scene.readers.toml.trajectories.interpolant import Interpolant
from coscrew_codegen.scene.scene import Scene
from tests.support.each import each_precision
from tests.support.scenes.effect_scenes import arm, effects
from tests.support.scenes.generated_scenes import imported
from tests.support.scenes.mechanisms import applied, numbers, scene
from tests.support.scenes.scene_values import inputs, same_bits

TABLE = Interpolant("a of b.csv", tuple(map(Fraction, range(-3, 4))), numbers(0, 1, 3, 3, -1, 2, 2))
NAMES = ("inverse_dynamics", "forward_dynamics", "energy", "power", "mass_matrix",
         "inverse_dynamics_derivatives", "step_leapfrog")


def wet() -> Scene:
    """An arm under water, with all of them."""
    motor = applied("actuator", "j2", kind="pd", kp=3, kd=2, target=TABLE, target_v=TABLE.rate,
                    limit=4, speed=2)
    mass = applied("added_mass", "b2", mass=(1, 2, 3), inertia=(1, 1, 0), point=(0, 0, 1))
    return scene(arm(), *effects("gravity", "wind", "drag", "buoyancy", "speed_limit"), motor, mass)


@pytest.fixture(scope="module")
def targets(tmp_path_factory: pytest.TempPathFactory) -> tuple[Kernels, ModuleType]:
    functions = derive(wet(), NAMES)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
        return kernels_of(functions), imported(functions, tmp_path_factory.mktemp("wet"))


@pytest.mark.parametrize("lead", [(), (7,), (64,)], ids=str)
@each_precision
def test_bits_are_the_same(targets: tuple[Kernels, ModuleType], precision, lead: tuple) -> None:
    kernels, package = targets
    assert kernels.compiled
    for function in scene_calls.callables(kernels.functions):
        compiled, twin = (getattr(getattr(x, precision.name), function.name)
                          for x in (kernels, package))
        for special in (False, True):
            arguments = inputs(function, precision.numpy_type, *lead, special=special)
            with np.errstate(all="ignore"):
                assert same_bits(compiled(*arguments), twin(*arguments)), function.name


@each_precision
def test_many_states_have_the_bits_of_each(targets: tuple[Kernels, ModuleType], precision) -> None:
    kernels, _ = targets
    for function in scene_calls.callables(kernels.functions):
        compiled = getattr(getattr(kernels, precision.name), function.name)
        batch = inputs(function, precision.numpy_type, 33)
        many = compiled(*batch)
        for k in range(33):
            one = compiled(*(x[k] for x in batch))
            row = tuple(x[k] for x in many) if isinstance(many, tuple) else many[k]
            assert same_bits(one, row), function.name
