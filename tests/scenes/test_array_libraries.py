"""A scene's functions on arrays of JAX and of the array API standard: C's bits, with the bits of
the tangent and adjoint Programs as derivatives, which tests/laws hold against 50 digits."""

import copy
import os
import pickle
import subprocess
import sys
from collections.abc import Iterator, Sequence
from functools import cache

import array_api_strict
import jax
import jax.numpy as jnp
import mpmath
import numpy as np
import pytest

import coscrew
from coscrew_codegen.algebra.recording.derivatives import tangent
from coscrew_codegen.program.values.formats import DOUBLE, Precision
from coscrew_codegen.runtime import compilation
from coscrew_codegen.runtime.arrays.array_function import ArrayFunction
from coscrew_codegen.runtime.arrays.namespace import Arrays, of_scene
from coscrew_codegen.runtime.arrays.standard import ArrayLibrary
from coscrew_codegen.runtime.load import Kernels, kernels_of
from coscrew_codegen.runtime.scene_library import opened
from tests.support.each import each_precision
from tests.support.scenes import scene_bits
from tests.support.scenes.evaluation import MULTIPRECISE, evaluator
from tests.support.scenes.generated_scenes import slider

STATES = 9


@cache
def kernels() -> Kernels:
    """A free body with another one on a joint with every effect, and a parameter."""
    return kernels_of(scene_bits.functions())


@cache
def on_jax() -> Arrays:
    return kernels().arrays(jnp)


@pytest.fixture(autouse=True)
def with_x64() -> Iterator[None]:
    with jax.enable_x64(True):
        yield


def given(name: str, precision: Precision = DOUBLE, states: int = STATES) -> list[np.ndarray]:
    """Rows for each argument of a function; t and p are shared by all states."""
    rng = np.random.default_rng(5)
    signature = next(x for x in kernels().interface.signatures if x.name == name)
    results = []
    for x, shape in signature.inputs:
        rows = rng.uniform(0.2, 0.9, shape if x in "thp" else (states, *shape))
        if x == "q":
            rows[:, 3:7] /= np.linalg.norm(rows[:, 3:7], axis=1, keepdims=True)
        results.append(np.asarray(rows, precision.numpy_type))
    return results


@each_precision
def test_bits_are_those_of_c(precision: Precision) -> None:
    name = "inverse_dynamics"
    function, compiled = getattr(on_jax(), name), getattr(getattr(kernels(), precision.name), name)
    arguments = given(name, precision)
    wanted = compiled(*arguments)
    for made in (function, jax.jit(function)):
        assert np.asarray(made(*arguments)).tobytes() == wanted.tobytes()
    several = jax.vmap(function, [0 if x.ndim > 1 else None for x in arguments])
    assert np.asarray(several(*arguments)).tobytes() == wanted.tobytes()
    one = [x[0] if x.ndim > 1 else x for x in arguments]
    assert np.asarray(function(*one)).tobytes() == wanted[0].tobytes()
    none = [x[:0] if x.ndim > 1 else x for x in arguments]
    assert function(*none).shape == (0, *wanted.shape[1:])


def test_bits_where_nothing_is_jitted() -> None:
    arguments = given("energy")
    slope = jax.grad(lambda *x: on_jax().energy(*x).sum(), argnums=3)
    wanted = slope(*arguments)
    with jax.disable_jit():
        assert (np.asarray(on_jax().energy(*arguments)).tobytes()
                == kernels().double.energy(*arguments).tobytes())
        assert np.asarray(slope(*arguments)).tobytes() == np.asarray(wanted).tobytes()


def test_subnormal_numbers_are_kept() -> None:
    """XLA flushes them to zero where it computes."""
    made = kernels_of(slider())
    q, phi = np.array([3e-310, 1]), np.array([1e-310, 2])
    wanted = made.double.integrated(q, phi)
    assert wanted[0] > 0
    assert np.asarray(made.arrays(jnp).integrated(q, phi)).tobytes() == wanted.tobytes()


def test_gradients_are_adjoints() -> None:
    """They have the bits of the adjoint Program; for arrays that all states share, they are sums.
    """
    arguments = given("inverse_dynamics")
    function = on_jax().inverse_dynamics
    wanted = adjoint_of("inverse_dynamics", arguments)
    places = tuple(range(len(arguments)))
    result = jax.grad(lambda *x: function(*x).sum(), argnums=places)(*arguments)
    for x, a, b in zip(arguments, result, wanted, strict=True):
        if x.ndim > 1:
            assert np.asarray(a).tobytes() == b.tobytes()
        else:
            assert np.abs(a - b.sum(axis=0)).max() <= STATES * 2.0**-53 * np.abs(b).sum()


def adjoint_of(name: str, arguments: Sequence[np.ndarray]) -> list[np.ndarray]:
    """Derivatives of the sum of results, by NumPy."""
    made = ArrayFunction(name, kernels().functions.named(name).program)
    weights = np.ones((STATES, *made.shapes[0]))
    with np.errstate(all="ignore"):
        return made.adjoint.printed(ArrayLibrary(np), DOUBLE)(*arguments, weights, lead=(STATES,))


def test_jacobians_by_both_modes_and_batches() -> None:
    """Forward and reverse mode agree to rounding, alone and in batches."""
    arguments = given("inverse_dynamics")
    function, q = on_jax().inverse_dynamics, 2
    assert arguments[q].shape[1] == kernels().NQ
    one = [x[0] if x.ndim > 1 else x for x in arguments]
    back, along = (mode(function, argnums=q)(*one) for mode in (jax.jacrev, jax.jacfwd))
    assert np.abs(back - along).max() <= 2.0**-40 * np.abs(back).max()
    axes = [0 if x.ndim > 1 else None for x in arguments]
    several = jax.vmap(jax.jacrev(function, argnums=q), axes)(*arguments)
    assert np.asarray(several[0]).tobytes() == np.asarray(back).tobytes()


def test_tangents_are_slopes_in_fifty_digits() -> None:
    program = kernels().functions.named("forward_dynamics").program
    step = mpmath.mpf(10)**-16
    with mpmath.workdps(50):
        f, along = evaluator(program, MULTIPRECISE), evaluator(tangent(program), MULTIPRECISE)
        x = [[mpmath.mpf(k + 2) / 7 for k in range(a.quantity.size)] for a in program.inputs]
        d = [[mpmath.mpf(k - 2) / 3 for k in range(a.quantity.size)] for a in program.inputs]
        ends = [f([[a + s * b for a, b in zip(*rows, strict=True)]
                   for rows in zip(x, d, strict=True)]) for s in (step, -step)]
        for slope, a, b in zip(along([*x, *d])[len(program.results):], *ends, strict=True):
            assert abs(slope - (a - b) / (2 * step)) <= mpmath.mpf(10)**-20 * (1 + abs(slope))


def test_steps_are_those_of_numpy() -> None:
    name = next(x for x in on_jax() if x.startswith("step_"))
    arguments = given(name)
    for a, b in zip(getattr(kernels().double, name)(*arguments),
                    jax.jit(getattr(on_jax(), name))(*arguments), strict=True):
        assert a.tobytes() == np.asarray(b).tobytes()


def test_bits_by_the_standard() -> None:
    library = kernels().arrays(array_api_strict)
    for name in ("inverse_dynamics", "energy"):
        arguments = given(name)
        wanted = getattr(kernels().double, name)(*arguments)
        result = getattr(library, name)(*map(array_api_strict.asarray, arguments))
        assert np.asarray(result).tobytes() == wanted.tobytes()
        assert getattr(kernels().arrays(np), name)(*arguments).tobytes() == wanted.tobytes()


def test_without_a_compiler_xla_computes(monkeypatch: pytest.MonkeyPatch) -> None:
    """To the last digits."""
    def fails(*_: object) -> None:
        raise compilation.CompilationError("none here")

    monkeypatch.setattr(compilation, "library", fails)
    arguments = given("energy")
    result = of_scene(jnp, kernels().interface, lambda: kernels().functions, {}, opened,
                      kernels())
    with pytest.warns(RuntimeWarning, match="computed by calls of the array library") as messages:
        energy = result.energy(*arguments)
    assert messages[-1].filename == __file__
    wanted = kernels().double.energy(*arguments)
    assert np.abs(energy - wanted).max() <= 2.0**-48 * np.abs(wanted).max()


def test_arrays_are_divided_among_devices() -> None:
    """Arrays are divided under shard_map, which records what varies over devices, and by arrays'
    types."""
    subprocess.run([sys.executable, "-m", "tests.support.scenes.sharded"], check=True, env={
        **os.environ, "XLA_FLAGS": "--xla_force_host_platform_device_count=2"})


def test_copies_and_pickles() -> None:
    for made in (on_jax(), kernels().arrays(np), coscrew.arrays(np), coscrew.arrays(jnp)):
        assert copy.copy(made) is made and copy.deepcopy([made])[0] is made
    for made in (kernels().arrays(np), on_jax()):
        again = pickle.loads(pickle.dumps(made))
        assert dir(again) == dir(made) and again is not made
        assert (np.asarray(again.energy(*given("energy"))).tobytes()
                == kernels().double.energy(*given("energy")).tobytes())
    for made in (coscrew.arrays(np), coscrew.arrays(jnp)):
        assert pickle.loads(pickle.dumps(made)) is made


def test_what_is_not_there_is_said() -> None:
    with pytest.raises(AttributeError, match="no function 'enrgy'; did you mean 'energy'?"):
        _ = on_jax().enrgy
    with pytest.raises(TypeError, match="wanted a namespace of arrays"):
        kernels().arrays(jax)
    with pytest.raises(TypeError, match="wanted an array of array_api_strict"):
        kernels().arrays(array_api_strict).energy(*given("energy"))
    assert repr(on_jax()).startswith("<carrier on arrays of jax: ")
