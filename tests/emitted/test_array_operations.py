"""The library's operations on arrays of other libraries: the bits of NumPy where every operation is
rounded once, the proved bounds where XLA compiles them."""

from collections.abc import Iterator

import array_api_strict
import jax
import jax.numpy as jnp
import mpmath
import numpy as np
import pandas
import pytest

import coscrew
from coscrew_codegen.algebra.operations import OPERATIONS
from coscrew_codegen.program.elementary import ELEMENTARY, Elementary
from coscrew_codegen.program.values.formats import DOUBLE, PRECISIONS, Precision
from coscrew_codegen.reports.kernels.inputs import benign
from tests.support.each import each_precision

ROWS = 6
STRICT, ON_JAX = coscrew.arrays(array_api_strict), coscrew.arrays(jnp)


@pytest.fixture(autouse=True)
def with_x64() -> Iterator[None]:
    with jax.enable_x64(True):
        yield


def several(x: object) -> tuple:
    return x if isinstance(x, tuple) else (x,)


@each_precision
def test_operations_have_the_bits_of_numpy(precision: Precision) -> None:
    for operation in OPERATIONS[::2 if precision == DOUBLE else 5]:
        rows = benign(operation, precision, ROWS, 5).astype(precision.numpy_type)
        sizes = [a.quantity.size for a in operation.inputs]
        given = [np.ascontiguousarray(x).reshape(ROWS, *a.quantity.shape) for x, a in zip(
            np.split(rows, np.cumsum(sizes)[:-1], axis=1), operation.inputs, strict=True)]
        wanted = several(getattr(getattr(coscrew, precision.name), operation.name)(*given))
        result = several(getattr(STRICT, operation.name)(*map(array_api_strict.asarray, given)))
        for a, b in zip(wanted, result, strict=True):
            assert a.tobytes() == np.asarray(b).tobytes(), operation.name


def arguments(precision: Precision) -> np.ndarray:
    """Arguments of every size, zeros among them."""
    rng = np.random.default_rng(7)
    most = 300 if precision == DOUBLE else 37
    x = rng.standard_normal(999) * 10.0**rng.uniform(-most, most, 999)
    return np.concatenate([x, rng.uniform(-20, 20, 1000), [0.0]]).astype(precision.numpy_type)


@pytest.mark.parametrize("function", ELEMENTARY, ids=lambda f: f.name)
@each_precision
def test_xla_keeps_the_bounds_of_elementary_functions(function: Elementary, precision: Precision
                                                      ) -> None:
    x = arguments(precision)
    given = (x, np.roll(x, 1))[:len(function.inputs)]
    result = several(jax.jit(getattr(ON_JAX, function.name))(*given))
    bound = function.error(precision)
    smallest = float(precision.smallest_normal / precision.u)  # XLA flushes subnormal corrections
    names = [a.name for a in function.outputs] if function.name == "sincos" else [function.name]
    with mpmath.workdps(400 if precision == DOUBLE else 80):
        for name, results in zip(names, result, strict=True):
            truth = getattr(mpmath, {"s": "sin", "c": "cos"}.get(name, name))
            for *numbers, y in zip(*(z.tolist() for z in given), np.asarray(results), strict=True):
                true = truth(*map(mpmath.mpf, numbers))
                if smallest < abs(true) < float(precision.limit("max")):
                    error = abs(mpmath.mpf(float(y)) - true) / float(np.spacing(abs(y)))
                    assert error <= bound * 1.01, (name, numbers, y)


@pytest.mark.parametrize("name", ("SE3_log", "Ad", "vec3_normalized"))
def test_under_jit_vmap_and_in_single_precision(name: str) -> None:
    operation = next(op for op in OPERATIONS if op.name == name)
    sizes = [a.quantity.size for a in operation.inputs]
    for precision in PRECISIONS:
        rows = benign(operation, precision, ROWS, 5).astype(precision.numpy_type)
        given = [x.reshape(ROWS, *a.quantity.shape) for x, a in zip(
            np.split(rows, np.cumsum(sizes)[:-1], axis=1), operation.inputs, strict=True)]
        function = getattr(ON_JAX, name)
        wanted = getattr(coscrew, name)(*given)
        result = jax.jit(function if precision == DOUBLE else jax.vmap(function))(*given)
        assert result.dtype == precision.numpy_type
        assert np.all(np.abs(result - wanted) <= 64 * float(precision.u) * np.abs(wanted).max())


def test_numbers_and_errors() -> None:
    assert ON_JAX.sin(0.5) == coscrew.sin(0.5)
    assert coscrew.arrays(np).SO3_exp(np.zeros(3, np.float32)).dtype == np.float32
    with pytest.raises(TypeError, match="wanted a namespace of arrays.*got math"):
        coscrew.arrays(__import__("math"))
    with pytest.raises(AttributeError, match="no function 'SO3_xp'; did you mean 'SO3_exp'?"):
        _ = ON_JAX.SO3_xp
    with pytest.raises(TypeError, match=r"SO3_exp: v is float16; wanted float64 or float32"):
        ON_JAX.SO3_exp(np.zeros(3, np.float16))
    with pytest.raises(TypeError, match="v is bfloat16"):
        ON_JAX.SO3_exp(jnp.zeros(3, jnp.bfloat16))
    with jax.enable_x64(False), pytest.raises(TypeError, match="jax_enable_x64"):
        ON_JAX.SO3_exp(np.zeros(3))
    with pytest.raises(TypeError, match="got v1 float32, v2 float64; wanted one type for all"):
        ON_JAX.cross_vv(np.zeros(3, np.float32), np.zeros(3))
    with pytest.raises(ValueError, match=r"v1 has shape \(4,\); wanted \(..., 3\)"):
        ON_JAX.cross_vv(np.zeros(4), np.zeros(3))
    with pytest.raises(ValueError, match=r"do not broadcast: v1 \(2,\), v2 \(3,\)"):
        ON_JAX.cross_vv(np.zeros((2, 3)), np.zeros((3, 3)))
    with pytest.raises(TypeError, match=r"cross_vv\(v1, v2\): 1 of v1, v2 is missing"):
        ON_JAX.cross_vv(np.zeros(3))
    for of, library in (ON_JAX, "jax"), (coscrew.arrays(np), "numpy"):
        for masked in np.ma.array(np.zeros(3), mask=True), np.ma.masked:
            with pytest.raises(TypeError, match=r"^SO3_exp: v is a numpy\.ma.*\.Masked\w*; "
                                                f"wanted an array of {library}$"):
                of.SO3_exp(masked)
        with pytest.raises(TypeError, match="v is a pandas.*Series; wanted an array of"):
            of.SO3_exp(pandas.Series([0.0, 0.0, 0.0]))
    with pytest.raises(TypeError, match=r"v is key<fry>; wanted float64 or float32"):
        ON_JAX.SO3_exp(jax.random.key(0))
    for weak in False, True:
        with pytest.raises(TypeError, match=r"v is a jax\..*ShapeDtypeStruct; wanted an array of"):
            ON_JAX.SO3_exp(jax.ShapeDtypeStruct((3,), np.float64, weak_type=weak))
    with pytest.raises(TypeError, match="v is >f8; wanted float64 or float32"):
        ON_JAX.SO3_exp(np.zeros(3, ">f8"))
    ones = np.ones(3, np.float32)
    assert jax.jit(ON_JAX.axpy_vv)(2.0, ones, ones).dtype == np.float32
    with pytest.raises(ValueError, match=r"a is 1e\+300 that overflows in float32"):
        ON_JAX.axpy_vv(1e300, ones, ones)
    with pytest.raises(TypeError, match="v is a builtins.list; wanted an array of jax"):
        ON_JAX.SO3_exp([0, 0, 0])


def test_single_precision_without_x64() -> None:
    with jax.enable_x64(False):
        result = jax.jacrev(ON_JAX.SO3_log)(np.eye(3, dtype=np.float32))
        assert result.dtype == np.float32
        assert np.array_equal(result[2], [[0, -0.5, 0], [0.5, 0, 0], [0, 0, 0]])


def normalized(v: list) -> list:
    return [x / mpmath.norm(v) for x in v]


def angle_to_123(v: list) -> list:
    """By the cosine, which is far from ±1 here."""
    w = [mpmath.mpf(k) for k in (1, 2, 3)]
    return [mpmath.acos(mpmath.fdot(v, w) / mpmath.norm(v) / mpmath.norm(w))]


@pytest.mark.parametrize("name, truth", (("vec3_normalized", normalized),
                                         ("angle_vv", angle_to_123)))
@pytest.mark.parametrize("size", (1, 1e-3, 300, 1e60))
def test_second_derivatives_under_xla(name: str, truth: object, size: float) -> None:
    """XLA makes a / (b b) of a / b / b."""
    v, count = np.array([2, -0.5, 0.7]) * size, 3
    others = [] if name == "vec3_normalized" else [jnp.array([1.0, 2.0, 3.0])]
    result = np.asarray(jax.jit(jax.hessian(getattr(ON_JAX, name)))(jnp.asarray(v), *others))
    with mpmath.workdps(60):
        step = mpmath.mpf(size) * mpmath.mpf(10)**-15
        x, unit = [mpmath.mpf(a) for a in v], np.eye(3)

        def moved(a: int, b: int, s: int, t: int) -> list:
            return truth([c + step * (s * int(unit[a, k]) + t * int(unit[b, k]))
                          for k, c in enumerate(x)])

        for a in range(count):
            for b in range(count):
                ends = (moved(a, b, *signs) for signs in ((1, 1), (1, -1), (-1, 1), (-1, -1)))
                wanted = [float((p - q - r + s) / (4 * step**2))
                          for p, q, r, s in zip(*ends, strict=True)]
                assert np.allclose(result[..., a, b], wanted, rtol=0,
                                   atol=1000 * 2**-53 * np.abs(result).max())
