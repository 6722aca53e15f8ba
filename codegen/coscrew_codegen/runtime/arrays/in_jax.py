"""Functions of arrays as primitives of JAX, with derivatives, batching and transposition.

`value` is a function f; `linear` is its derivative along directions, linear in these: the value of
f's tangent Program.  The transposed of `linear` is the value of f's adjoint Program.  Since these
are functions, too, derivatives of any order follow.  Operands are rows (states, numbers), or one
row that all states share.  Those of one state have no axis of states: JAX moves the axes of arrays
whose shape changes, and copies them.
"""

from collections.abc import Sequence
from functools import cache, partial
from itertools import accumulate, count
from math import prod
from typing import Any

import jax
import jax.numpy as jnp
from jax.extend.core import Primitive
from jax.interpreters import ad, batching, mlir
from jax.sharding import NamedSharding, get_abstract_mesh, reshard
from jax.sharding import PartitionSpec as P

from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.runtime.arrays.array_function import ArrayFunction
from coscrew_codegen.runtime.arrays.compiled import handler
from coscrew_codegen.runtime.arrays.standard import ArrayLibrary, Shape

LIBRARY = ArrayLibrary(jnp)
FEWEST = 3
"""Directions for which the Jacobian is computed instead of tangents."""
_NUMBERS = count()
"""Of handlers: scenes may share names."""

value, linear = Primitive("coscrew_value"), Primitive("coscrew_linear")


def call(function: ArrayFunction, lead: Shape, arrays: Sequence[Any], precision: Precision
         ) -> list[Any]:
    """The results for arrays that are checked."""
    return list(_jitted(function, lead)(*arrays))


@cache
def _jitted(function: ArrayFunction, lead: Shape) -> Any:
    states = (prod(lead),) if lead else ()

    def rows(x: Any, shape: Shape) -> Any:
        x = _replicated(x)
        own = x.shape[:x.ndim - len(shape)]
        if prod(own) != 1:
            x, own = jnp.broadcast_to(x, (*lead, *shape)), lead
        return x.reshape(*(prod(own) for _ in states), prod(shape))

    def computed(*arrays: Any) -> list[Any]:
        given = [rows(x, shape) for x, (_, shape) in zip(arrays, function.inputs, strict=True)]
        outputs = _bound(value, *given, function=function, states=states)
        return [y.reshape(*lead, *shape) for y, shape in zip(outputs, function.shapes, strict=True)]

    return jax.jit(computed)


def _evaluated(primitive: Primitive, *rows: Any, function: ArrayFunction, states: Shape) -> Any:
    with jax.disable_jit(False):  # else it would evaluate itself
        return _of_rows(primitive, function, states)(*rows)


@cache
def _of_rows(primitive: Primitive, function: ArrayFunction, states: Shape) -> Any:
    return jax.jit(partial(primitive.bind, function=function, states=states))


def _replicated(x: Any) -> Any:
    """An array that each device has whole, where types say how arrays are divided."""
    divided = jax.typeof(x).sharding
    return reshard(x, NamedSharding(divided.mesh, P())) if any(divided.spec) else x


def _bound(primitive: Primitive, *rows: Any, function: ArrayFunction, states: Shape) -> Any:
    """The primitive of rows that all vary over the same axes of a mesh.  Under shard_map one that
    all devices share is made to vary as the others do, as by JAX's own functions: the transposed of
    that sums over devices."""
    varying = [jax.typeof(x).manual_axis_type.varying for x in rows]
    axes = frozenset().union(*varying)
    alike = [jax.lax.pcast(x, tuple(sorted(axes - own)), to="varying")
             for x, own in zip(rows, varying, strict=True)]
    return primitive.bind(*alike, function=function, states=states)


def _shapes(*rows: Any, function: ArrayFunction, states: Shape) -> list[Any]:
    """Shapes of the results, which vary over the axes of a mesh over which rows vary; otherwise
    each device has them whole."""
    mesh = next((x.sharding.mesh for x in rows if not x.sharding.mesh.empty), get_abstract_mesh())
    return [jax.core.ShapedArray((*states, n), rows[0].dtype, sharding=NamedSharding(mesh, P()),
                                 manual_axis_type=rows[0].manual_axis_type)
            for n in function.sizes]


def _batched(primitive: Primitive, rows: Sequence[Any], axes: Sequence[int | None], *,
             function: ArrayFunction, states: Shape) -> tuple[list[Any], list[int]]:
    members = next(x.shape[axis] for x, axis in zip(rows, axes, strict=True) if axis is not None)
    outputs = _bound(primitive, *(_flat(x, axis, members, states) for x, axis in zip(
        rows, axes, strict=True)), function=function, states=(members * prod(states),))
    return [y.reshape(members, *states, y.shape[-1]) for y in outputs], [0] * len(outputs)


def _linear_batched(rows: Sequence[Any], axes: Sequence[int | None], *, function: ArrayFunction,
                    states: Shape) -> tuple[list[Any], list[int]]:
    """Many directions at one place, as jacfwd takes them, are multiplied by the Jacobian; where
    they are the units of the inputs that they change, the Jacobian's columns are the result."""
    half = len(rows) // 2
    members = next(rows[k].shape[axis] for k, axis in enumerate(axes) if axis is not None)
    directions = [x if axis is None else jnp.moveaxis(x, axis, 0)
                  for x, axis in zip(rows[half:], axes[half:], strict=True)]
    shared = all(axis is None for axis in axes[:half]) and all(
        not states or x.shape[-2] == 1 for x in directions)
    if members < FEWEST or not shared or not (jacobian := function.jacobian):
        return _batched(linear, rows, axes, function=function, states=states)
    D = [jnp.broadcast_to(x.reshape(-1, x.shape[-1]), (members, x.shape[-1])) for x in directions]
    changed = [k for k, axis in enumerate(axes[half:]) if axis is not None]
    *firsts, end = accumulate((D[k].shape[1] for k in changed), initial=0)

    def blocks() -> list[list[Any]]:
        """The Jacobian of each result by each input."""
        parts = iter(_bound(value, *rows[:half], function=jacobian, states=states))
        return [[next(parts).reshape(*states, -1, d.shape[1]) for d in D] for _ in function.sizes]

    def columns() -> list[list[Any]]:
        return [[row[k] for k in changed] for row in blocks()]

    def products() -> list[list[Any]]:
        return [jnp.split(jnp.einsum("...oi,mi->...om", jnp.concatenate(row, axis=-1),
                                     jnp.concatenate(D, axis=1)), firsts[1:], axis=-1)
                for row in blocks()]

    if end == members:
        units = [jnp.zeros_like(d) for d in D]
        for k, first in zip(changed, firsts, strict=True):
            units[k] = jnp.eye(members, D[k].shape[1], -first, D[k].dtype)
        same = jnp.concatenate(units, axis=1) == jnp.concatenate(D, axis=1)
        result = jax.lax.cond(same.all(), columns, products)
    else:
        result = products()  # other directions than the units
    return [jnp.concatenate(row, axis=-1) for row in result], [len(states) + 1] * len(result)


def _flat(x: Any, axis: int | None, members: int, states: Shape) -> Any:
    """Rows of all members' states; a row that all share stays one row."""
    if axis is None and x.size == x.shape[-1]:
        return x.reshape(1, x.shape[-1])
    x = _replicated(x)
    x = x[None] if axis is None else jnp.moveaxis(x, axis, 0)
    return jnp.broadcast_to(x, (members, *states, x.shape[-1])).reshape(-1, x.shape[-1])


def _value_jvp(primals: Sequence[Any], tangents: Sequence[Any], **of: Any) -> tuple[Any, Any]:
    directions = map(ad.instantiate_zeros, tangents)
    return _bound(value, *primals, **of), _bound(linear, *primals, *directions, **of)


def _linear_jvp(primals: Sequence[Any], tangents: Sequence[Any], *, function: ArrayFunction,
                states: Shape) -> tuple[Any, Any]:
    directions = map(ad.instantiate_zeros, tangents)
    return (_bound(linear, *primals, function=function, states=states),
            _bound(linear, *primals, *directions, function=function.tangent, states=states))


def _transposed(weights: Sequence[Any], *rows: Any, function: ArrayFunction, states: Shape
                ) -> list[Any]:
    at, directions = rows[:len(rows) // 2], rows[len(rows) // 2:]
    cotangents = _bound(value, *at, *map(ad.instantiate_zeros, weights), function=function.adjoint,
                        states=states)
    return [*[None] * len(at), *(
        _shared(x, d.aval.shape) if ad.is_undefined_primal(d) else None
        for x, d in zip(cotangents, directions, strict=True))]


def _shared(x: Any, shape: Shape) -> Any:
    """The sum over states, for a row that all share."""
    return x if x.shape == shape else x.sum(axis=0, keepdims=True)


def _printed(*rows: Any, function: ArrayFunction, states: Shape) -> list[Any]:
    precision = LIBRARY.precision(rows[0].dtype)
    assert precision
    arrays = [x.reshape(*x.shape[:-1], *shape) for x, (_, shape) in zip(
        rows, function.inputs, strict=True)]
    outputs = function.printed(LIBRARY, precision)(*arrays, lead=states)
    return [y.reshape(*states, n) for y, n in zip(outputs, function.sizes, strict=True)]


def _lowered(context: Any, *rows: Any, function: ArrayFunction, states: Shape) -> Any:
    """Lowers to a call of C where there is one, else to the function by calls of JAX."""
    precision = LIBRARY.precision(context.avals_in[0].dtype)
    assert precision
    if function.compile and (name := _registered(function, precision)):
        return jax.ffi.ffi_lowering(name)(context, *rows)
    return mlir.lower_fun(_printed, multiple_results=True)(
        context, *rows, function=function, states=states)


@cache
def _registered(function: ArrayFunction, precision: Precision) -> str:
    """The name by which XLA knows the function in C; empty where nothing compiles."""
    target = handler(function, precision, jax.ffi.include_dir())
    name = f"{function.name}_{precision.name}_{next(_NUMBERS)}"
    if target:
        jax.ffi.register_ffi_target(name, jax.ffi.pycapsule(target), platform="cpu")
    return name if target else ""


def _along(rule: Any) -> Any:
    """The rule of `linear` from that of `value`."""
    return lambda *rows, function, **of: rule(*rows, function=function.tangent, **of)


for primitive, jvp, shapes in ((value, _value_jvp, _shapes), (linear, _linear_jvp, None)):
    primitive.multiple_results = True
    primitive.def_impl(partial(_evaluated, primitive))
    primitive.def_abstract_eval(shapes or _along(_shapes))
    ad.primitive_jvps[primitive] = jvp
batching.primitive_batchers[value] = partial(_batched, value)
batching.primitive_batchers[linear] = _linear_batched
ad.primitive_transposes[linear] = _transposed
mlir.register_lowering(value, mlir.lower_fun(_printed, multiple_results=True))
mlir.register_lowering(linear, mlir.lower_fun(_along(_printed), multiple_results=True))
mlir.register_lowering(value, _lowered, platform="cpu")
mlir.register_lowering(linear, _along(_lowered), platform="cpu")
