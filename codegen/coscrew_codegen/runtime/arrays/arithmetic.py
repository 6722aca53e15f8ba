"""Arrays as numbers: each operation of a Program by functions of the array API standard.

Elementary functions are those of our own, with the same instructions as in C.  Libraries that round
every operation once give the same bits; XLA contracts a b + c, and may move the last bit.
"""

import operator
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any, TypeAlias

from coscrew_codegen.program import Constant, Instruction, Op, Program
from coscrew_codegen.program.elementary import ELEMENTARY, Elementary
from coscrew_codegen.program.elementary.elementary_calls import FUNCTION_OF
from coscrew_codegen.program.in_python import in_python
from coscrew_codegen.program.interpreter import Arithmetic, by_operation
from coscrew_codegen.program.tables import TableColumn
from coscrew_codegen.program.two_over_pi import chunks
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.program.values.table_arrays import rounded
from coscrew_codegen.runtime.arrays.deciding import deciding
from coscrew_codegen.runtime.arrays.standard import ArrayLibrary

Array: TypeAlias = Any
"""An array of any library, or a Python number in its place."""
Functions: TypeAlias = Callable[[Sequence[Sequence[Array]]], list[Array]]
"""From the components of each input to those of the results."""


def arithmetic(library: ArrayLibrary, precision: Precision, program: Program) -> Arithmetic[Array]:
    """Returns the arithmetic with which the interpreter runs a plain Program on arrays of a
    precision."""
    plain = _plain(library, precision)
    known = {x.name: _function(x, library, precision, plain) for x in ELEMENTARY}
    numbers = _on_arrays(precision, plain | {
        op: _one_of(known[FUNCTION_OF[op]], number) for op, number in _PLACES.items()})
    return _decided_once(numbers, program) if library.traced else numbers


def _decided_once(numbers: Arithmetic[Array], program: Program) -> Arithmetic[Array]:
    """The arithmetic with one result of every comparison, wherever XLA computes it."""
    from coscrew_codegen.runtime.arrays.once import once

    names = deciding(program)

    def function(step: Instruction, number: int) -> Callable[..., Array]:
        computed = numbers.function(step, number)
        return (lambda *x: once(computed(*x))) if step.name in names else computed

    return replace(numbers, function=function)


_PLACES = {Op.SIN: 0, Op.COS: 1, Op.EXP: 0, Op.TANH: 0, Op.ATAN2: 0}
"""Index of an operation's result among those of its elementary function."""


def _on_arrays(precision: Precision, operations: Mapping[Op, Callable[..., Array]]
               ) -> Arithmetic[Array]:
    def constant(x: Constant) -> Array:
        return float(precision.rounded(precision.value(x)))

    return by_operation(constant, operations, float("nan"))


def _plain(library: ArrayLibrary, precision: Precision) -> dict[Op, Callable[..., Array]]:
    """Computes every operation except elementary functions."""
    xp = library.xp

    def like(x: Array) -> Array:
        return library.number(x, precision)

    def select(test: Array, a: Array, b: Array) -> Array:
        if isinstance(test, bool):
            return a if test else b
        return xp.where(test, like(a), like(b))

    return {
        Op.ADD: library.kept(operator.add), Op.SUB: library.kept(operator.sub),
        Op.MUL: operator.mul, Op.SCALE: operator.mul,
        Op.DIV: library.quotient, Op.NEG: operator.neg, Op.LESS: operator.lt,
        Op.EQUAL: operator.eq, Op.ABS: abs, Op.SELECT: select,
        Op.SQRT: lambda x: xp.sqrt(like(x)),
        Op.COPYSIGN: lambda a, b: xp.copysign(like(a), like(b)),
        Op.POWER: partial(_power, library, precision),
        Op.TWO_OVER_PI: partial(_two_over_pi, library, precision),
        Op.INDEX: partial(_index, library, precision), Op.GATHER: partial(
            _gathered, library, precision)}


def _index(library: ArrayLibrary, precision: Precision, x: Array, count: float) -> Array:
    """The integer part of x, within 0 … count - 1; 0 for NaN."""
    where, x = library.xp.where, library.number(x, precision)
    inside = where(x > 0, x, library.xp.zeros_like(x))
    return library.xp.floor(where(inside < count, inside, library.xp.zeros_like(x) + (count - 1)))


def _gathered(library: ArrayLibrary, precision: Precision, column: TableColumn, at: Array) -> Array:
    """The column's number in the row `at`."""
    of = column.table
    row = _index(library, precision, at, of.rows)
    return library.taken(rounded(of, precision)[column.place::of.stride].tolist(), row, row)


def _power(library: ArrayLibrary, precision: Precision, a: Array, b: Array) -> Array:
    """2^(a - b), 0 or infinite beyond the exponents of normal numbers; anything for NaN."""
    least, most = precision.least_exponent - 1, 1 - precision.least_exponent + 1
    k, where = a - b, library.xp.where
    k = where(k > least, where(k < most, k, k * 0 + most), k * 0 + least)
    k = where(k == k, k, library.xp.zeros_like(k))
    powers = [0.0, *(2.0**n for n in range(least + 1, most)), float("inf")]
    return library.taken(powers, k - least, k)


def _two_over_pi(library: ArrayLibrary, precision: Precision, x: Array, n: Array, digits: Array
                 ) -> Array:
    """The chunk n places after the first one that x uses."""
    some, size = chunks(precision.digits), abs(x)
    steps = range(1, (1 - precision.least_exponent - some.offset) // some.bits + 1)
    index = sum((library.xp.where(size >= 2.0**(some.offset + some.bits * i),
                                  library.number(1.0, precision),
                                  library.number(0.0, precision)) for i in steps),
                start=library.xp.zeros_like(size))
    return library.taken([float(precision.rounded(value)) for value in some.values],
                         index + float(n), x)


def _function(function: Elementary, library: ArrayLibrary, precision: Precision,
              operations: Mapping[Op, Callable[..., Array]]) -> Callable[..., list[Array]]:
    """Returns an elementary function of arrays, which caches the results for its last arguments."""
    numbers = _on_arrays(precision, operations)

    def made(program: Callable[[Precision], Program]) -> Functions:
        return in_python(program(precision), numbers)

    kernel = made(function.kernel)
    if not (function.near and function.far and function.limit):
        return lambda *x: kernel([[library.number(y, precision)] for y in x])
    near, far, limit = made(function.near), made(function.far), float(function.limit(precision))
    where = library.xp.where

    def reduced(x: Array) -> list[Array]:
        value, beyond = near([[x]]), abs(x) > limit
        if not library.traced and not bool(library.xp.any(beyond)):
            return value
        away = far([[where(beyond, x, library.xp.zeros_like(x) + limit)]])
        return [where(beyond, a, b) for a, b in zip(away, value, strict=True)]

    latest: list[tuple[Array, list[Array]]] = [(None, [])]  # sine and cosine follow each other

    def apply(x: Array) -> list[Array]:
        of, results = latest[0]
        if of is x:
            return results
        results = kernel([[y] for y in reduced(library.number(x, precision))])
        if not library.traced:
            latest[0] = x, results
        return results

    return apply


def _one_of(function: Callable[..., list[Array]], number: int) -> Callable[..., Array]:
    return lambda *x: function(*x)[number]
