"""Gufuncs against a NumPy user's own code, and against the pure-NumPy twins; and the times of their
checks of arguments."""

from collections.abc import Callable
from functools import partial

import numpy as np
from tabulate import tabulate

import coscrew
import coscrew.accurate
from coscrew_codegen.reports.timing.buffers import aligned
from coscrew_codegen.reports.timing.intervals import interval
from coscrew_codegen.reports.timing.loop_timing import timed_calls
from tests.benchmarks.words import span

COUNT = 1000
ROW = 7  # the most elements that loops on vectors compute one by one
ON_VECTORS = ("dc", "SO3_exp", "SO3_log", "SE3_exp", "SE3_log")
SECONDS = 1.0  # of each task

Case = tuple[str, Callable[[], object]]


def _cases(dtype: str) -> dict[str, list[Case]]:
    """The alternatives for each task: ours first, then the others."""
    random = np.random.default_rng(20)
    one = coscrew.SE3_exp(random.normal(size=6)).astype(dtype)
    each = aligned(coscrew.SE3_exp(random.normal(size=(COUNT, 6))).astype(dtype))
    s, c = (aligned(random.normal(size=(COUNT, 6)).astype(dtype)) for _ in range(2))
    out, matrix = np.empty_like(c), coscrew.CoAd(one)
    twin = coscrew.single if dtype == "float32" else coscrew.double

    def einsum_and_cross() -> np.ndarray:
        R, t = each[:, :, :3], each[:, :, 3]
        force = np.einsum("nij,nj->ni", R, c[:, :3])
        moment = np.einsum("nij,nj->ni", R, c[:, 3:]) + np.cross(t, force)
        return np.concatenate((force, moment), axis=1)

    def crosses() -> np.ndarray:
        v, w, f, m = s[:, :3], s[:, 3:], c[:, :3], c[:, 3:]
        return np.concatenate((np.cross(w, f), np.cross(v, f) + np.cross(w, m)), axis=1)

    return {
        "product_CoAdc, one D": [
            ("coscrew", lambda: coscrew.product_CoAdc(one, c)),
            ("coscrew, out=", lambda: coscrew.product_CoAdc(one, c, out=out)),
            ("coscrew.accurate, out=", lambda: coscrew.accurate.product_CoAdc(one, c, out=out)),
            ("einsum with one 6×6", lambda: np.einsum("ij,nj->ni", matrix, c)),
            ("matmul with one 6×6, out=", lambda: np.matmul(c, matrix.T, out=out)),
            ("NumPy twin", lambda: twin.product_CoAdc(one, c))],
        "product_CoAdc, D each": [
            ("coscrew", lambda: coscrew.product_CoAdc(each, c)),
            ("coscrew.accurate", lambda: coscrew.accurate.product_CoAdc(each, c)),
            ("einsum and cross", einsum_and_cross),
            ("NumPy twin", lambda: twin.product_CoAdc(each, c))],
        "cross_sc": [
            ("coscrew", lambda: coscrew.cross_sc(s, c)),
            ("coscrew.accurate", lambda: coscrew.accurate.cross_sc(s, c)),
            ("np.cross", crosses),
            ("NumPy twin", lambda: twin.cross_sc(s, c))],
    }


def _cases_on_vectors(dtype: str) -> dict[str, list[Case]]:
    """Several elements at a time, and the same one by one: in rows too short for vectors, with gaps
    between them, so that NumPy does not join them."""
    made = {}
    for name in ON_VECTORS:
        function = getattr(coscrew, name)
        twin = getattr(coscrew.single if dtype == "float32" else coscrew.double, name)
        x, outs = _arguments(name, dtype)
        padded = aligned(np.zeros((COUNT // ROW, ROW + 1, *x.shape[1:]), dtype))
        rows = padded[:, :ROW]
        rows[...] = x[:COUNT // ROW * ROW].reshape(rows.shape)
        outs_of_rows = tuple(np.empty((*padded.shape[:2], *out.shape[1:]), dtype)[:, :ROW]
                             for out in outs)
        made[name] = [
            ("coscrew, out=", partial(function, x, out=outs)),
            ("coscrew, out=, one by one", partial(function, rows, out=outs_of_rows)),
            ("NumPy twin", partial(twin, x))]
    return made


def _arguments(name: str, dtype: str) -> tuple[np.ndarray, tuple[np.ndarray, ...]]:
    """An array of elements, and arrays for the results."""
    random = np.random.default_rng(21)
    sizes = {"dc": (), "SO3": (3,), "SE3": (6,)}
    x = random.normal(size=(COUNT, *sizes[name.partition("_")[0]])).astype(dtype)
    if name.endswith("_log"):
        x = getattr(coscrew, name.replace("log", "exp"))(x)
    results = getattr(coscrew, name)(x)
    return aligned(x), results if isinstance(results, tuple) else (results,)


def _checks(dtype: str) -> list[tuple[str, ...]]:
    """Lines of functions that refuse arguments: times of a call, and of an element of many,
    unchecked, and the additional time of the check."""
    rows = []
    v, R = np.ones(3, dtype), coscrew.SO3_exp(np.ones((COUNT, 3), dtype))
    for name, many, more in (("SO3_log", R, ()),
                             ("rotate_qv", coscrew.quaternion_from_mat3x3(R), (v,))):
        checked, out = getattr(coscrew, name), np.empty((COUNT, 3), dtype)
        functions = coscrew.unchecked(checked), checked
        calls = [*(partial(f, many[0], *more) for f in functions),
                 *(partial(f, many, *more, out=out) for f in functions)]
        one, one_checked, each, each_checked = timed_calls(calls, 1e9 * SECONDS)
        rows.append((name, dtype, span(one.time), span(interval(one_checked.rounds - one.rounds)),
                     span(each.time, 1 / COUNT),
                     span(interval(each_checked.rounds - each.rounds), 1 / COUNT)))
    return rows


def main() -> None:
    """Print the tables."""
    rows = []
    for dtype in ("float64", "float32"):
        for task, cases in (_cases(dtype) | _cases_on_vectors(dtype)).items():
            timings = timed_calls([function for _, function in cases], 1e9 * SECONDS)
            rows += [(task, dtype, name, span(timing.time, 1 / COUNT),
                      span(timing.ratio(timings[0])))
                     for (name, _), timing in zip(cases, timings, strict=True)]
    print(f"\nns per element, N = {COUNT}, in {coscrew._gufunc.LOOPS}: median (95 % interval) of "
          "rounds in which all of a task take turns; ratio: to coscrew's in the same round")
    print(tabulate(rows, ("task", "dtype", "how", "ns", "ratio"), disable_numparse=True))
    print(f"\nns of functions that refuse arguments, without the check, and what it adds, of one "
          f"call and of each of {COUNT} elements")
    print(tabulate([row for dtype in ("float64", "float32") for row in _checks(dtype)],
                   ("function", "dtype", "call", "check", "element", "check"),
                   disable_numparse=True))
    D, c = np.eye(3, 4), np.ones(6)
    (single,) = timed_calls([lambda: coscrew.product_CoAdc(D, c)], 1e9 * SECONDS)
    print(f"\nproduct_CoAdc of one displacement and one coscrew: {span(single.time)} ns a call")


if __name__ == "__main__":
    main()
