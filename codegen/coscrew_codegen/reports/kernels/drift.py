"""Errors of a displacement after many compositions D ← D E, with and without orthonormalising."""

import ctypes
import time
from collections.abc import Iterator

import mpmath
import numpy as np

from coscrew_codegen.algebra.exact import DIGITS, UNIT
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from coscrew_codegen.reports.kernels.kernel_library import KernelLibrary, loaded
from coscrew_codegen.reports.kernels.report_json import DriftErrors
from coscrew_codegen.reports.timing.intervals import FEWEST, interval

STEPS = 1_000_000
EVERY = 1000  # compositions between two Newton steps R ← R (3I - R^T R) / 2
_RUNS = FEWEST  # per precision, with and without orthonormalising in turn


def drifts(library: KernelLibrary, steps: int = STEPS) -> Iterator[DriftErrors]:
    """The drift in both precisions, without and with orthonormalising."""
    cases = [(precision, _step().astype(precision.numpy_type), every)
             for precision in PRECISIONS for every in (0, EVERY)]
    rounds = [[_run(library, *case, steps) for case in cases] for _ in range(_RUNS)]
    for (precision, E, every), runs in zip(cases, zip(*rounds, strict=True), strict=True):
        defect, error = deviations(runs[0][0], power(E, steps))
        u = float(UNIT[precision.name])
        ns = interval(np.array([ns / steps for _, ns in runs]))
        yield DriftErrors(precision.name, bool(every), steps, defect / u, error / u, ns.median,
                          ns.low,
                          ns.high)


def power(E: np.ndarray, steps: int) -> mpmath.matrix:
    """The rigid displacement nearest to E = [R | t], to the power `steps`: R is replaced by its
    orthogonal polar factor, so that no defect accumulates."""
    with mpmath.workdps(DIGITS):
        motion = mpmath.matrix([*map(list, E.astype(float).tolist()), [0, 0, 0, 1]])
        R = motion[:3, :3]
        for _ in range(10):  # squares the defect each time: 1e-7 vanishes after 5
            R = R * (3 * mpmath.eye(3) - R.T * R) / 2
        motion[:3, :3] = R
        return motion**steps


def deviations(D: np.ndarray, truth: mpmath.matrix) -> tuple[float, float]:
    """(largest |R^T R - I|, largest error of a component relative to the largest of R or of t)."""
    with mpmath.workdps(DIGITS):
        result = mpmath.matrix(D.astype(float).tolist())
        R, t = result[:, :3], result[:, 3]
        defect = max(map(abs, R.T * R - mpmath.eye(3)))
        errors = [max(map(abs, x - y)) / max(map(abs, y))
                  for x, y in ((R, truth[:3, :3]), (t, truth[:3, 3]))]
        return float(defect), float(max(errors))


def _step() -> np.ndarray:
    """A screw motion about (1, 2, 3), by an angle that is not a rational part of a turn."""
    x, y, z = np.array([1, 2, 3]) / np.sqrt(14)
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angle = 0.0037
    R = np.eye(3) + np.sin(angle) * k + 2 * np.sin(angle / 2)**2 * (k @ k)
    return np.hstack([R, [[0.001], [0.002], [-0.0005]]])


def _run(library: KernelLibrary, precision: Precision, E: np.ndarray, every: int,
         steps: int) -> tuple[np.ndarray, float]:
    """The displacement after all steps, and the time in ns."""
    step, D = np.ascontiguousarray(E.T), np.ascontiguousarray(np.eye(4, 3, dtype=E.dtype))
    run = getattr(loaded(library.path), f"drift{precision.suffix}")
    start = time.perf_counter_ns()
    run(ctypes.c_void_p(D.ctypes.data), ctypes.c_void_p(step.ctypes.data),
        ctypes.c_long(steps), ctypes.c_long(every))
    return D.T, float(time.perf_counter_ns() - start)
