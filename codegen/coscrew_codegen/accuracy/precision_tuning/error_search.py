"""Searches for the states where a program errs most: the same states on every machine."""

from collections.abc import Callable

import numpy as np

from coscrew_codegen.accuracy.precision_tuning.array_evaluation import Array, Given
from coscrew_codegen.accuracy.precision_tuning.sample import States, at, in_double, in_rows, joined
from coscrew_codegen.program import Program
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE

_AT_ONCE, _ROUNDS, _KEPT = 2048, 60, 128
CLIMBED = _AT_ONCE * (_ROUNDS + 1)
"""States that a search looks at."""
Sizes = Callable[[Given], Array]
"""Sizes to be maximized by a search: a row for each component of the results."""


def climbed(states: States, sizes: Sizes) -> Given:
    """Searches states of large sizes, by small steps from the largest of some states."""
    best = states.numbers(_AT_ONCE)
    result = sizes(best)
    for _ in range(_ROUNDS):
        kept = _largest(result)
        best, result = at(best, kept), result[:, kept]
        near = states.near(at(best, np.resize(np.arange(len(kept)), _AT_ONCE)))
        best, result = joined(best, near), np.concatenate((result, sizes(near)), axis=1)
    return at(best, _largest(result))


def errors(program: Program, plain: Program, tolerances: Array) -> Sizes:
    """Errors of a program in single precision, in units of the accuracy requested of each
    component.

    They are differences from the plain program in double precision: quick, not certified."""
    results, true = in_rows(program, SINGLE), in_rows(plain, DOUBLE)
    return lambda given: _known(results(given) - true(in_double(given)), tolerances)


def results(plain: Program, tolerances: Array) -> Sizes:
    """A program's results, in units of the requested accuracy; errors of pairs grow in steps, where
    results pass powers of two."""
    true = in_rows(plain, DOUBLE)
    return lambda given: _known(true(in_double(given)), tolerances)


def _known(x: Array, tolerances: Array) -> Array:
    sizes = np.absolute(x) / tolerances[:, None]
    return np.where(np.isfinite(sizes), sizes, -1)


def _largest(sizes: Array) -> Array:
    """The states of the largest sizes, and that of the largest of each component."""
    order = np.argsort(-sizes.max(axis=0), kind="stable")[:_KEPT]
    return np.unique(np.concatenate((order, sizes.argmax(axis=1))))
