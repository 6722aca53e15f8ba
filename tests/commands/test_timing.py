"""Measurement of times: confidence intervals of medians, rounds, addresses of arrays."""

import ctypes
import subprocess
from collections import Counter
from math import comb
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen.reports.timing import buffers
from coscrew_codegen.reports.timing.intervals import FEWEST, Interval, interval, rank
from coscrew_codegen.reports.timing.loop_timing import (
    Loop,
    driver,
    pointers,
    timed_calls,
    timed_loops,
)


@pytest.mark.parametrize("count", (6, 7, 20, 100, 999))
def test_an_interval_holds_the_median_in_95_of_100_cases_and_no_shorter_one_does(count: int):
    """By the binomial distribution of the number of samples below the true median."""
    def held(k: int) -> float:
        return 1 - 2 * sum(comb(count, i) for i in range(k)) / 2**count

    assert held(rank(count)) >= 0.95 > held(rank(count) + 1)
    ordered = np.arange(1.0, count + 1)
    k = rank(count)
    assert interval(ordered[::-1]) == Interval((count + 1) / 2, k, count + 1 - k)


def test_an_interval_holds_the_median_of_skewed_times():
    """About 95 % of 2000 sets of 30 samples, exponentially distributed with the median ln 2."""
    rng = np.random.default_rng(5)
    sets = map(interval, rng.exponential(size=(2000, 30)))
    held = sum(x.low <= np.log(2) <= x.high for x in sets) / 2000
    assert 0.94 < held < 0.985  # 95.7 % by the binomial distribution


def test_fewer_than_six_samples_reach_from_the_shortest_to_the_longest():
    for count in range(1, FEWEST):
        assert interval(np.arange(count)) == Interval((count - 1) / 2, 0, count - 1)


def test_intervals_are_below_only_apart():
    assert Interval(2, 1, 3).below(Interval(5, 4, 6))
    assert not Interval(2, 1, 4).below(Interval(5, 4, 6))
    assert not Interval(5, 4, 6).below(Interval(2, 1, 3))


@pytest.mark.parametrize("dtype", (np.float64, np.float32))
@pytest.mark.parametrize("elements", range(16, 272, 16))
def test_planes_start_at_lines_and_in_sets_of_their_own(elements: int, dtype: type):
    """The cache has 32 KiB, in 64 sets of lines of 64 bytes."""
    given = [np.arange(elements * size, dtype=dtype).reshape(elements, *shape)
             for size, shape in ((12, (3, 4)), (6, (6,)), (1, ()))]
    result = buffers.planes(given)
    starts = [part[k:].ctypes.data for part in result for k in range(len(part))]
    assert all(start % buffers.LINE == 0 for start in starts)
    assert len({start // buffers.LINE % 64 for start in starts}) == len(starts) == 19
    for x, part in zip(given, result, strict=True):
        assert part.shape[1] == buffers.plane_length(elements, x.itemsize)
        assert (part[:, :elements].T.reshape(x.shape) == x).all()


def test_aligned_copies_start_at_a_line():
    for count in range(1, 40):
        x = np.arange(float(count))
        copy = buffers.aligned(x)
        assert copy.ctypes.data % buffers.LINE == 0 and (copy == x).all()


COUNTING = """
void log_one(long n, void *const *a) { long *log = a[0]; log[++log[0]] = *(long *)a[1]; (void)n; }
void slow(long n, void *const *a) {
  volatile double *x = a[0];
  for (long i = 0; i < n; i++) { for (int k = 0; k < 40; k++) { *x = *x + 1; } }
}
void fast(long n, void *const *a) {
  volatile double *x = a[0];
  for (long i = 0; i < n; i++) { for (int k = 0; k < 10; k++) { *x = *x + 1; } }
}
"""


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> ctypes.CDLL:
    folder: Path = tmp_path_factory.mktemp("timed")
    (folder / "timed.c").write_text(driver() + COUNTING, encoding="utf-8")
    flags = ("-std=c11", "-Wall", "-Wextra", "-Wconversion", "-Werror", "-O1", "-shared", "-fPIC")
    subprocess.run(["cc", *flags, "-Wno-missing-prototypes", "timed.c", "-o", "timed.so"],
                   cwd=folder, check=True)
    return ctypes.CDLL(str(folder / "timed.so"))


def test_loops_take_turns(library: ctypes.CDLL):
    """In a round each is called once untimed and calls[k] times timed; each round begins with the
    next one."""
    log = np.zeros(100, np.int64)
    arguments = [pointers((log, np.array([k], np.int64))) for k in range(3)]
    loops = (ctypes.c_void_p * 3)(*[ctypes.cast(library.log_one, ctypes.c_void_p).value] * 3)
    ns = np.full((4, 3), -1.0)
    library.time_rounds(
        ctypes.c_long(3), loops, (ctypes.c_long * 3)(1, 1, 1),
        (ctypes.c_void_p * 3)(*map(ctypes.addressof, arguments)), (ctypes.c_long * 3)(1, 2, 3),
        ctypes.c_long(4), ns.ctypes.data_as(ctypes.c_void_p))
    runs = {0: [0] * 2, 1: [1] * 3, 2: [2] * 4}
    order = [k for first in range(4) for k in np.roll([0, 1, 2], -first)]
    assert log[1:log[0] + 1].tolist() == [x for k in order for x in runs[int(k)]]
    assert (ns >= 0).all()


def test_times_of_loops_are_per_element(library: ctypes.CDLL):
    """Four times the work takes two to eight times as long, whatever else runs, for any n."""
    loops = [Loop(getattr(library, name), n, pointers((np.zeros(8),)))
             for name, n in (("fast", 100), ("slow", 100), ("fast", 1000))]
    fast, slow, longer = timed_loops(library, loops, 2e7)
    assert len(fast.rounds) == len(slow.rounds) >= FEWEST
    assert 2 < slow.ratio(fast).median < 8
    assert 0.5 < longer.ratio(fast).median < 2


def test_calls_take_turns():
    calls: list[str] = []
    short, long = timed_calls([lambda: calls.append("a"), lambda: calls.append("b")], 1e6, 1e3)
    assert len(short.rounds) == len(long.rounds) >= FEWEST
    counts = Counter(calls)
    assert min(counts.values()) > 2 * FEWEST
    assert short.minimum > 0
