"""The accurate tier of scenes keeps its promise: against 60 digits, a component is right to one
unit of its last digit as long as its condition is below 1e13, and in single precision it is the
nearest number, except near ties.

Truth of inverse and forward dynamics of arms is a Newton-Euler method of the tests' own, in the
world's frame; of motions of free joints, power series; of other functions, the plain Program in 60
digits.
"""

from collections.abc import Sequence
from fractions import Fraction
from functools import cache
from pathlib import Path

import mpmath
import numpy as np
import pytest

from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.values.formats import DOUBLE, Precision
from coscrew_codegen.runtime.load import kernels_for
from coscrew_codegen.scene.mechanism.model import Model
from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides, read_scene
from coscrew_codegen.scene.scene import Scene
from tests.support.each import each_precision
from tests.support.limits import LARGEST_CONDITION
from tests.support.scenes import mechanisms as m
from tests.support.scenes.arms import GRAVITY, arm, exact, inverse, motions
from tests.support.scenes.tiers import DIGITS, Result, results, states
from tests.support.truth import motions as series
from tests.support.truth.condition import conditions
from tests.support.truth.newton_euler import inverse_dynamics

EXAMPLES = Path(__file__).parents[2] / "examples" / "scenes"
NEAREST = 0.5001


def broken(results: Sequence[Result], precision: Precision) -> list[tuple[int, float, float]]:
    """Place, condition and error of every result that is worse than promised."""
    most = 1.0 if precision == DOUBLE else NEAREST
    largest = LARGEST_CONDITION[precision.name]
    return [(x.place, x.condition, x.ulps(precision)) for x in results
            if x.true and x.condition < largest and x.ulps(precision) > most]


@cache
def example(name: str) -> Scene:
    """An example with all its functions, in the accurate tier."""
    return read_scene(EXAMPLES / f"{name}.toml", overrides=SceneOverrides(
        "both", functions=("default",), tiers=("accurate",)))


@each_precision
@pytest.mark.parametrize("name", ("arm6", "pendulum", "quadruped", "stick_slip", "wingnut"))
def test_every_function_of_the_examples(name: str, precision: Precision):
    kernels = kernels_for(example(name))
    count = 60 if name == "arm6" else 12
    tiered = getattr(kernels.accurate, precision.name)
    public = [f for f in kernels.functions.functions if not f.internal]
    assert sorted(f.name for f in public) == sorted(tiered)
    for function in public:
        given = states(kernels.functions, function, count, precision)
        values = list(results(function.program, given, getattr(tiered, function.name)(*given)))
        assert not broken(values, precision), function.name
        assert all(x.value == 0 for x in values if not x.true and x.condition == 0)


@each_precision
def test_inverse_dynamics_is_that_of_newton_and_euler(precision: Precision):
    model = arm()
    scene = Scene("arm", model, (m.gravity(),), functions=("inverse_dynamics",),
                  tiers=("accurate",))
    kernels, given = kernels_for(scene), motions(60, precision)
    function = kernels.functions.named("inverse_dynamics")
    columns = [given[:, k] for k in range(3)]
    result = getattr(kernels.accurate, precision.name).inverse_dynamics(*columns)
    size = conditions(function.program, [list(x.T.astype(float)) for x in columns])
    judged = [Result(j, result[k, j], true, float(size[j][k])) for k in range(60)
              for j, true in enumerate(inverse(model, *given[k]))]
    assert not broken(judged, precision)
    plain = getattr(kernels, precision.name).inverse_dynamics(*columns)
    errors = [Result(x.place, y, x.true, 0).ulps(precision)
              for x, y in zip(judged, plain.ravel(), strict=True)]
    assert max(errors) > 5, "plain is accurate enough"


def forward(model: Model, q: np.ndarray, v: np.ndarray, tau: np.ndarray
            ) -> tuple[list[mpmath.mpf], mpmath.mpf]:
    """a with M a + bias = τ by elimination, and the condition of M."""
    with mpmath.workdps(2 * DIGITS):
        still, n = [mpmath.mpf(0)] * len(q), len(q)
        bias = inverse_dynamics(model, GRAVITY, exact(q), exact(v), still)
        columns = [inverse_dynamics(model, (Fraction(0),) * 3, exact(q), still, [
            mpmath.mpf(k == j) for k in range(n)]) for j in range(n)]
        M = mpmath.matrix(columns).T
        right = mpmath.matrix([x - y for x, y in zip(exact(tau), bias, strict=True)])
        norms = [mpmath.mnorm(x, mpmath.inf) for x in (M, M**-1)]
        return list(mpmath.lu_solve(M, right)), norms[0] * norms[1]


@pytest.mark.parametrize("scale, least", ((Fraction(1), 1e2), (Fraction("0.15"), 1e10)))
def test_forward_dynamics_of_an_ill_conditioned_arm_is_right_to_one_unit(scale, least):
    """The mass matrix has a condition of 1e10 and more; a component within 1 u."""
    model = arm(scale)
    scene = Scene("arm", model, (m.gravity(),), functions=("forward_dynamics",),
                  tiers=("accurate",))
    kernels, given = kernels_for(scene), motions(12, DOUBLE)
    result = kernels.accurate.double.forward_dynamics(*(given[:, k] for k in range(3)))
    for row, numbers in zip(given, result, strict=True):
        true, condition = forward(model, *row)
        assert condition > least
        for place, (x, y) in enumerate(zip(numbers, true, strict=True)):
            assert abs(mpmath.mpf(float(x)) - y) <= 2.0**-53 * abs(y), (place, float(x).hex())


def test_functions_are_those_of_the_scene():
    """Nothing is left out but steps."""
    scene = example("wingnut")
    names = {f.name for f in derive(scene).functions if not f.internal}
    assert {*kernels_for(scene).accurate.double} == names


ANGLES = (1e-160, 1e-9, 0.5, 0.999, 1.001, 2, 3.1415926, 6.2831853, 1e3, 1e9, 1e12)


def free_motions(precision: Precision) -> tuple[np.ndarray, np.ndarray]:
    """q and phi of a free joint for these angles; every second q and translation is chosen such
    that the motion takes a component to 1e-12 of the others."""
    rng, rows = np.random.default_rng(7), []
    for angle in [x for x in ANGLES if precision == DOUBLE or 1e-20 < x < 1e4]:
        for near in (False, True, False, True):
            w, v, q = rng.normal(size=3), rng.normal(size=3), rng.normal(size=4)
            w *= angle / np.linalg.norm(w)
            q[rng.integers(4)] *= 1e-12 if near else 1
            phi = np.array([*v, *w], precision.numpy_type)
            r = series.quaternion_exp(mpmath.matrix(phi[3:].astype(float).tolist()))
            q = series.product(mpmath.matrix((q / np.linalg.norm(q)).tolist()),
                               series.conjugate(r) if near else r)
            t = moved(mpmath.matrix([0, 0, 0, *q]), mpmath.matrix(phi.tolist()))[0:3]
            rows.append(([*(-x for x in t), *q], phi))
    q, phi = (np.array(x, float).astype(precision.numpy_type) for x in zip(*rows, strict=True))
    return q, phi


def moved(q: mpmath.matrix, phi: mpmath.matrix) -> mpmath.matrix:
    """(t; r), moved by the screw motion phi; r with a Newton step towards norm 1."""
    t = q[0:3] + series.matrix_of(q[3:7]) * series.SE3_exp(phi)[0:3, 3]
    r = series.product(q[3:7], series.quaternion_exp(phi[3:6]))
    return mpmath.matrix([*t, *(r * (3 - mpmath.fsum(x * x for x in r)) / 2)])


@each_precision
def test_motions_of_quaternions_are_those_of_power_series(precision: Precision):
    """Angles around the ends of series, and large ones, are tested."""
    kernels = kernels_for(example("wingnut"))
    program = kernels.functions.named("integrated").program
    assert program.fine and len(program.fine.instructions) < len(program.instructions)
    with mpmath.workdps(DIGITS):
        given = free_motions(precision)
        true = [moved(*(mpmath.matrix(x.astype(float).tolist()) for x in row))
                for row in zip(*given, strict=True)]
    result = getattr(kernels.accurate, precision.name).integrated(*given)
    size = conditions(program.fine, [list(x.T.astype(float)) for x in given])
    judged = [Result(j, result[k, j], true[k][j], float(size[j][k]))
              for k in range(len(result)) for j in range(7)]
    assert not broken(judged, precision)
    assert max(x.condition for x in judged) > LARGEST_CONDITION[precision.name] / 100


def test_angles_that_a_function_computes_may_be_large():
    """A mimic joint has such angles; their rests are 1e-4 and more."""
    scene = Scene("geared", m.geared(Fraction("1.7"), Fraction("0.3")), (
        m.applied("mimic"), m.gravity(0, 0, Fraction("-9.81"))), functions=("body_poses",),
        tiers=("accurate",))
    kernels = kernels_for(scene)
    function = kernels.functions.named("body_poses")
    given = [np.random.default_rng(3).uniform(1e12, 3e12, (40, 1))]
    values = list(results(function.program, given, kernels.accurate.double.body_poses(*given)))
    assert not broken(values, DOUBLE)
    assert sum(x.condition > 1e11 for x in values) > 100
