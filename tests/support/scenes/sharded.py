"""A program that compares functions of arrays divided among two devices with those of one.

`XLA_FLAGS=--xla_force_host_platform_device_count=2 python -m tests.support.scenes.sharded`
"""

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jax.sharding import AxisType, Mesh, NamedSharding
from jax.sharding import PartitionSpec as P

import coscrew
from coscrew_codegen.runtime.load import kernels_of
from tests.support.scenes.generated_scenes import slider

ROWS = 8
ON_JAX, LIE = kernels_of(slider()).arrays(jnp), coscrew.arrays(jnp)
SHARED, DIVIDED = P(), P("x")


def dynamics(p: Any, q: Any, v: Any, tau: Any) -> Any:
    return ON_JAX.forward_dynamics(0.5, p, q, v, tau)


def rotated(w: Any, x: Any) -> Any:
    """Points, by a rotation that all share."""
    return LIE.product_drv(LIE.SO3_exp(w), x)


def given() -> Iterator[tuple[Callable[..., Any], list[Any]]]:
    """Functions, with an argument that all rows share and one or several of rows."""
    rng = np.random.default_rng(2)
    yield dynamics, [jnp.array([1.5, 0.25]), *(jnp.array(rng.normal(size=(ROWS, 2)))
                                               for _ in range(3))]
    yield rotated, [jnp.array([0.1, 0.2, 0.3]), jnp.array(rng.normal(size=(ROWS, 3)))]


def same(result: Any, wanted: Any) -> None:
    assert np.asarray(result).tobytes() == np.asarray(wanted).tobytes(), (result, wanted)


def near(result: Any, parts: Any) -> None:
    """A sum of the parts in any order: to rounding."""
    true = np.sum(parts, axis=0)
    assert np.all(np.abs(result - true) <= len(parts) * 2.0**-52 * np.abs(parts).sum(axis=0)), (
        result, true)


def under_shard_map(function: Callable[..., Any], x: list[Any], check: bool) -> None:
    """Values and derivatives, each device with half of the rows."""
    mesh = jax.make_mesh((2,), ("x",), axis_types=(AxisType.Auto,))
    specs = (SHARED, *[DIVIDED] * (len(x) - 1))
    mapped = partial(jax.shard_map, mesh=mesh, in_specs=specs, check_vma=check)

    def total(*x: Any) -> Any:
        return mapped(lambda *x: jax.lax.psum(function(*x).sum(), "x"), out_specs=SHARED)(*x)

    def slopes(x: Any, *others: Any) -> Any:
        rows = jax.vmap(jax.hessian(lambda *y: function(*y).sum(), argnums=1),
                        (None, *[0] * len(others)))
        return rows(x, *others)

    for made in (lambda f: f, jax.jit) if function is dynamics else (jax.jit,):
        same(made(mapped(function, out_specs=DIVIDED))(*x), function(*x))
        same(made(jax.grad(total, argnums=1))(*x),
             jax.grad(lambda *x: function(*x).sum(), argnums=1)(*x))
        by_row = jax.vmap(jax.grad(lambda *x: function(*x).sum()), (None, *[0] * len(x[1:])))(*x)
        near(made(jax.grad(total))(*x), by_row)
        if function is dynamics:
            same(made(mapped(slopes, out_specs=DIVIDED))(*x), slopes(*x))
    if check:
        try:
            mapped(function, out_specs=SHARED)(*x)
        except ValueError as error:
            assert "require replication" in str(error)
        else:
            raise AssertionError("one device's rows went out as everybody's")


def divided(function: Callable[..., Any], x: list[Any], mesh: Mesh) -> None:
    """Values and derivatives by rows that lie on two devices, as their types say."""
    rows = [jax.device_put(y, NamedSharding(mesh, DIVIDED)) for y in x[1:]]
    same(function(x[0], *rows), function(*x))
    same(jax.vmap(function, (None, *[0] * len(rows)))(x[0], *rows), function(*x))
    slope = jax.grad(lambda *x: function(*x).sum(), argnums=1)
    result = jax.jit(slope)(x[0], *rows)
    same(result, slope(*x))
    assert jax.typeof(result).sharding == jax.typeof(rows[0]).sharding


if __name__ == "__main__":
    jax.config.update("jax_enable_x64", True)
    assert len(jax.devices()) == 2
    for function, arguments in given():
        under_shard_map(function, arguments, check=True)
        if function is dynamics:
            under_shard_map(function, arguments, check=False)
        with jax.set_mesh(mesh := jax.make_mesh((2,), ("x",), axis_types=(AxisType.Explicit,))):
            divided(function, arguments, mesh)
