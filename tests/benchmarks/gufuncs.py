"""Gufuncs against what a NumPy user would write, and against the pure-NumPy twins."""

import timeit
from collections.abc import Callable

import numpy as np
from tabulate import tabulate

import coscrew

REPEATS = 1500
COUNT = 1000

Case = tuple[str, Callable[[], object]]


def _cases(dtype: str) -> dict[str, list[Case]]:
    """For each task: ours first, then the others."""
    random = np.random.default_rng(20)
    one = random.normal(size=(3, 4)).astype(dtype)
    each = random.normal(size=(COUNT, 3, 4)).astype(dtype)
    s, c = (random.normal(size=(COUNT, 6)).astype(dtype) for _ in range(2))
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
            ("einsum with one 6×6", lambda: np.einsum("ij,nj->ni", matrix, c)),
            ("matmul with one 6×6, out=", lambda: np.matmul(c, matrix.T, out=out)),
            ("NumPy twin", lambda: twin.product_CoAdc(one, c))],
        "product_CoAdc, D each": [
            ("coscrew", lambda: coscrew.product_CoAdc(each, c)),
            ("einsum and cross", einsum_and_cross),
            ("NumPy twin", lambda: twin.product_CoAdc(each, c))],
        "cross_sc": [
            ("coscrew", lambda: coscrew.cross_sc(s, c)),
            ("np.cross", crosses),
            ("NumPy twin", lambda: twin.cross_sc(s, c))],
    }


def _time(function: Callable[[], object], number: int = 5) -> tuple[float, float]:
    """(minimum, median) time of a call in ns."""
    samples = sorted(t / number * 1e9 for t in timeit.repeat(function, number=number,
                                                             repeat=REPEATS))
    return samples[0], samples[len(samples) // 2]


def main() -> None:
    """Print the table."""
    rows = []
    for dtype in ("float64", "float32"):
        for task, cases in _cases(dtype).items():
            ours = 0.0
            for name, function in cases:
                function()
                minimum, median = _time(function)
                ours = ours or minimum
                rows.append((task, dtype, name, minimum / COUNT, f"{median / minimum - 1:.0%}",
                             minimum / ours))
    print(f"\nns per element, N = {COUNT}, minimum of {REPEATS}; spread is median over minimum; "
          f"ratio is time / coscrew's; compiled: {coscrew.COMPILED}")
    print(tabulate(rows, ("task", "dtype", "how", "ns", "spread", "ratio"), floatfmt=".2f"))
    D, c = np.eye(3, 4), np.ones(6)
    single, _ = _time(lambda: coscrew.product_CoAdc(D, c), number=100)
    print(f"\nproduct_CoAdc of one displacement and one coscrew: {single:.0f} ns a call")


if __name__ == "__main__":
    main()
