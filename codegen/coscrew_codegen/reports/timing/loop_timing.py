"""Measures times of several variants, in ns, in turn.

In every round each variant is timed once, after an untimed call, and the order rotates from round
to round, so that disturbances affect all of them.  Ratios are of times in the same round."""

import ctypes
import gc
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np

from coscrew_codegen.backends.render import copied
from coscrew_codegen.reports.timing.intervals import FEWEST, Interval, interval

DRIVER = "runtime/timing/driver.c"
"""The driver in libraries with timed loops."""

SAMPLE = 20e3
"""Least duration of a sample in ns, many times the resolution of clocks."""

_MOST_ROUNDS = 4000
_ROUNDS_TO_CALIBRATE = 5


@dataclass(frozen=True, eq=False)
class Timing:
    """The times of a variant, one per round."""

    rounds: np.ndarray

    @property
    def time(self) -> Interval:
        """The median time."""
        return interval(self.rounds)

    @property
    def minimum(self) -> float:
        """The shortest time."""
        return float(self.rounds.min())

    def ratio(self, other: "Timing") -> Interval:
        """The median of this time over the other one, round by round."""
        return interval(self.rounds / other.rounds)


@dataclass(frozen=True)
class Loop:
    """A compiled `void f(long n, void *const *arguments)`, a loop over n elements."""

    function: "ctypes._NamedFuncPointer"
    n: int
    arguments: "ctypes.Array[ctypes.c_void_p]"


def driver() -> str:
    """The C text of the driver, for libraries of timed loops."""
    return copied(DRIVER)


def pointers(arrays: Sequence[np.ndarray]) -> "ctypes.Array[ctypes.c_void_p]":
    """void *[] to these arrays, to which it also holds references."""
    array = (ctypes.c_void_p * len(arrays))(*(a.ctypes.data for a in arrays))
    setattr(array, "kept", tuple(arrays))  # noqa: B010  arrays of ctypes take any attribute
    return array


def timed_loops(library: ctypes.CDLL, loops: Sequence[Loop], ns: float) -> list[Timing]:
    """Times per element, in rounds of about `ns` altogether.  `library` holds the driver; loops may
    be of others."""
    calls = [1] * len(loops)
    while True:
        first = _rounds(library, loops, calls, _ROUNDS_TO_CALIBRATE).min(axis=0)
        samples = [t * x.n * count for t, x, count in zip(first, loops, calls, strict=True)]
        if min(samples) >= SAMPLE / 2:
            each = sum(sample * (1 + 1 / count)  # including untimed calls
                       for sample, count in zip(samples, calls, strict=True))
            break
        calls = [count if sample >= SAMPLE / 2 else
                 max(2 * count, min(int(count * SAMPLE / max(sample, 1)), 16 * count))
                 for count, sample in zip(calls, samples, strict=True)]
    result = _rounds(library, loops, calls, _round_count(ns, each))
    return [Timing(column) for column in result.T]


def _rounds(library: ctypes.CDLL, loops: Sequence[Loop], calls: Sequence[int],
            rounds: int) -> np.ndarray:
    """(rounds, loops): ns per element."""
    count, ns = len(loops), np.empty((rounds, len(loops)))
    functions = (ctypes.c_void_p * count)(
        *(ctypes.cast(x.function, ctypes.c_void_p).value for x in loops))
    arguments = (ctypes.c_void_p * count)(*(ctypes.addressof(x.arguments) for x in loops))
    library.time_rounds(ctypes.c_long(count), functions,
                        (ctypes.c_long * count)(*(x.n for x in loops)), arguments,
                        (ctypes.c_long * count)(*calls), ctypes.c_long(rounds),
                        ns.ctypes.data_as(ctypes.c_void_p))
    return ns


def timed_calls(calls: Sequence[Callable[[], object]], ns: float,
                sample: float = SAMPLE) -> list[Timing]:
    """Times of Python calls, in rounds of about `ns` altogether."""
    with _no_collection():
        numbers = [_number(call, sample) for call in calls]
        each = sum(number * _elapsed(call, number) for call, number in zip(calls, numbers,
                                                                           strict=True))
        rounds = _round_count(ns, each)
        result = np.empty((rounds, len(calls)))
        for i in range(rounds):
            for k in (*range(i % len(calls), len(calls)), *range(i % len(calls))):
                calls[k]()
                result[i, k] = _elapsed(calls[k], numbers[k])
    return [Timing(column) for column in result.T]


def _round_count(ns: float, each: float) -> int:
    return int(min(max(ns / each, FEWEST), _MOST_ROUNDS))


def _number(call: Callable[[], object], sample: float) -> int:
    """The number of calls in a sample."""
    call()
    number = 1
    while number * (each := _elapsed(call, number)) < sample / 2:
        number = max(2 * number, min(int(sample / max(each, 1)), 16 * number))
    return number


def _elapsed(call: Callable[[], object], number: int) -> float:
    """The time of one of `number` calls, in ns."""
    start = time.perf_counter_ns()
    for _ in range(number):
        call()
    return (time.perf_counter_ns() - start) / number


@contextmanager
def _no_collection() -> Iterator[None]:
    collects = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if collects:
            gc.enable()
