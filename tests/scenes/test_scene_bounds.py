"""The certified tier of scenes: plain results bit for bit, and bounds that hold, against 60 digits;
in double precision they are hardly more than the errors.

Truth of inverse dynamics of an arm is the tests' own Newton-Euler method, in the world's frame; of
other functions, the plain Program in 60 digits.
"""

from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path

import mpmath
import numpy as np
import pytest

from coscrew_codegen.program.values.formats import DOUBLE, Precision
from coscrew_codegen.runtime.load import Kernels, kernels_for
from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides, read_scene
from coscrew_codegen.scene.scene import Scene
from tests.support.each import each_precision
from tests.support.scenes import mechanisms as m
from tests.support.scenes.arms import arm, inverse, motions
from tests.support.scenes.scene_values import same_bits
from tests.support.scenes.tiers import DIGITS, flat, states, truths

EXAMPLES = Path(__file__).parents[2] / "examples" / "scenes"
OF_ARM = ("inverse_dynamics", "forward_dynamics", "mass_matrix")
SCALES = ((1, 1), (2.0**40, 2.0**10), (1, 2.0**60), (2.0**-30, 2.0**-60), (2.0**-60, 2.0**-100),
          (1, 0), (1, 2.0**-140))
"""What coordinates are multiplied by, and what all else; the last makes singles subnormal."""
DEEP = ((1, 2.0**480), (2.0**-500, 2.0**-500), (1, 2.0**-1065))
"""The same for doubles."""
LARGEST = {"inverse_dynamics": 12, "mass_matrix": 2}
"""The median of bound / error in single precision."""


def ratios(true: Sequence[Sequence[mpmath.mpf]], result: np.ndarray, bounds: np.ndarray
           ) -> Iterator[float]:
    """Bound / error wherever a bound is stated; asserts that it holds."""
    for k, row in enumerate(true):
        for place, x in enumerate(row):
            if np.isfinite(bounds[k, place]) and np.isfinite(result[k, place]):
                with mpmath.workdps(DIGITS):
                    bound = mpmath.mpf(float(bounds[k, place]))
                    error = abs(mpmath.mpf(float(result[k, place])) - x)
                    assert error <= bound, (k, place, float(error / bound) if bound else error)
                    yield float(bound / error) if error else 1.0


def judged(kernels: Kernels, name: str, given: Sequence[np.ndarray], precision: Precision
           ) -> list[float]:
    """The ratios of a function at these states; its results are the plain ones."""
    count, function = len(given[0]), kernels.functions.named(name)
    result = getattr(getattr(kernels.certified, precision.name), name)(*given)
    plain = getattr(getattr(kernels, precision.name), name)(*given)
    results = len(function.program.outputs)
    assert same_bits(result[:results] if results > 1 else result[0], plain)
    return list(ratios(truths(function.program, given), flat(result[:results], count),
                       flat(result[results:], count)))


@cache
def example(name: str) -> Kernels:
    return kernels_for(read_scene(EXAMPLES / f"{name}.toml", overrides=SceneOverrides(
        "both", functions=("default",), tiers=("certified",))))


@cache
def kernels_of_arm() -> Kernels:
    return kernels_for(Scene("arm", arm(), (m.gravity(),), functions=OF_ARM, tiers=("certified",)))


@each_precision
@pytest.mark.parametrize("name", ("pendulum", "stick_slip", "wingnut"))
def test_every_function_of_the_examples(name: str, precision: Precision):
    """There is a statement for each result, except for quaternions' motions: their formula splits
    numbers by rounding them, which sizes do not see."""
    kernels, stated = example(name), 0
    for function in (f for f in kernels.functions.functions if not f.internal):
        given = states(kernels.functions, function, 12, precision)
        result = judged(kernels, function.name, given, precision)
        stated += len(result)
        components = sum(a.quantity.size for a in function.program.outputs)
        assert len(result) == 12 * components or function.name == "integrated", function.name
    assert stated


@each_precision
def test_an_arm_at_large_and_small_numbers(precision: Precision):
    kernels, stated = kernels_of_arm(), 0
    for scale in SCALES + DEEP * (precision == DOUBLE):
        for name in OF_ARM:
            given = [np.asarray(x * (scale[a.name != "q"]), precision.numpy_type)
                     for a, x in zip(kernels.functions.named(name).program.inputs,
                                     states(kernels.functions, kernels.functions.named(name), 4,
                                            precision), strict=True)]
            stated += len(judged(kernels, name, given, precision))
    assert stated > 500


@each_precision
def test_bounds_are_hardly_more_than_errors(precision: Precision):
    kernels = kernels_of_arm()
    for name in OF_ARM:
        given = states(kernels.functions, kernels.functions.named(name), 20, precision)
        result = judged(kernels, name, given, precision)
        if precision == DOUBLE:
            assert np.quantile(result, 0.9) < 1.01, name
        elif name in LARGEST:
            assert np.median(result) < LARGEST[name], (name, np.median(result))


@each_precision
def test_inverse_dynamics_is_within_its_bound_of_newton_and_euler(precision: Precision):
    kernels, given = kernels_of_arm(), motions(60, precision)
    columns = [given[:, k] for k in range(3)]
    result, bound = getattr(kernels.certified, precision.name).inverse_dynamics(*columns)
    true = [inverse(arm(), *row) for row in given]
    assert len(list(ratios(true, result, bound))) == result.size
