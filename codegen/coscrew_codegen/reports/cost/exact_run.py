"""Computes a run's end to many digits: the dynamics' Programs on MPFR's numbers, with
extrapolation.

Independent of the emitted texts, of their precisions and of SciPy, but not of the Programs."""

from collections.abc import Callable
from dataclasses import dataclass

import gmpy2
import numpy as np
from gmpy2 import mpfr

from coscrew_codegen.program.in_python import in_python
from coscrew_codegen.program.multiprecise import MULTIPRECISE, precise
from coscrew_codegen.program.values.formats import DOUBLE
from coscrew_codegen.reports.cost import CostError
from coscrew_codegen.scene.joints import kind_named
from coscrew_codegen.scene.mechanism.joint_in_reals import JointInReals
from coscrew_codegen.simulation.system import System

_ROWS = 10  # of the extrapolation, of order 20
_SMALLEST = 1e-5  # least step, as a fraction of the run: smaller ones would take too long
_GUARD = 10  # digits beyond the wanted ones

Numbers = list[mpfr]
Rates = Callable[[mpfr, Numbers], Numbers]


def exact_end(system: System, until: float, digits: int) -> tuple[np.ndarray, np.ndarray, float]:
    """q and v at the end, and an estimate of their error.  Raises CostError if that needs too small
    steps, as for scenes that are not smooth."""
    with precise(digits + _GUARD):
        run = _Run(_rates(system), mpfr(until), mpfr(10)**-digits)
        y, apart = run.end([mpfr(float(x)) for part in system.start() for x in part])
        end = np.array(y, float)
    nq = system.functions.nq
    return system.normalized(end[:nq]), end[nq:], max(float(apart), float(DOUBLE.u))


def _rates(system: System) -> Rates:
    """(t, y) -> y', y = (q; v); quaternions move as r' = r (ω; 0) / 2."""
    forward = system.programs["forward_dynamics"]
    accelerations = in_python(forward, MULTIPRECISE)
    nq, nv = system.functions.nq, system.functions.nv
    p, tau = [mpfr(x) for x in system.p], [mpfr(0)] * nv

    def rates(t: mpfr, y: Numbers) -> Numbers:
        r, v = y[:nq], y[nq:]
        q = _normalized(system, r)
        values = {"t": [t], "p": p, "q": q, "v": v, "tau": tau}
        moved = [x for c in system.functions.coordinates for x in _moved(
            c.kind, *(_places(x, of) for x, of in ((r, c.q), (q, c.q), (v, c.v))))]
        return [*moved, *accelerations([values[a.name] for a in forward.inputs])]

    return rates


def _normalized(system: System, q: Numbers) -> Numbers:
    q = list(q)
    for places in system.quaternions:
        norm = gmpy2.sqrt(sum(x * x for x in q[places]))
        q[places] = [x / norm for x in q[places]]
    return q


def _moved(kind: str, r: Numbers, q: Numbers, v: Numbers) -> Numbers:
    """The rates of a joint's coordinates r; q is r with normalized quaternions."""
    manifold = kind_named(kind).manifold
    if manifold is None:
        return v
    return list(manifold.rates(JointInReals((), tuple(q), gmpy2.sin, gmpy2.cos), r, v))


def _places(x: Numbers, places: range) -> Numbers:
    return x[places.start:places.stop]


@dataclass(frozen=True)
class _Run:
    rates: Rates
    until: mpfr
    tolerance: mpfr

    def end(self, y: Numbers) -> tuple[Numbers, mpfr]:
        """y at the end, by the modified midpoint rule with 2, 4, 6, … steps extrapolated to step
        zero (Gragg, Bulirsch, Stoer), and the sum of the estimated errors."""
        t, h, apart = mpfr(0), self.until / 16, mpfr(0)
        while t < self.until:
            h = min(h, self.until - t)
            if h < _SMALLEST * self.until and h < self.until - t:
                raise CostError(f"the reference needs steps below {float(h):.1g} s at t = "
                                f"{float(t):.6g} s: --digits is for smooth scenes")
            new, error = self._extrapolated(t, h, y)
            if error <= self.tolerance:
                t, y, apart = t + h, new, apart + error
            factor = (self.tolerance / max(error, self.tolerance * mpfr(10)**-20))
            h *= min(max(0.9 * factor**(mpfr(1) / (2 * _ROWS - 1)), mpfr("0.1")), mpfr(4))
        return y, apart

    def _extrapolated(self, t: mpfr, h: mpfr, y: Numbers) -> tuple[Numbers, mpfr]:
        first = self.rates(t, y)
        rows: list[list[Numbers]] = []
        for i in range(_ROWS):
            row = [self._midpoint(t, h, y, first, 2 * (i + 1))]
            for k in range(1, i + 1):
                ratio = mpfr(i + 1)**2 / mpfr(i + 1 - k)**2 - 1
                row.append([a + (a - b) / ratio for a, b in
                            zip(row[k - 1], rows[i - 1][k - 1], strict=True)])
            rows.append(row)
        error = max(abs(a - b) for a, b in zip(rows[-1][-1], rows[-1][-2], strict=True))
        return rows[-1][-1], error

    def _midpoint(self, t: mpfr, h: mpfr, y: Numbers, first: Numbers, n: int) -> Numbers:
        part = h / n
        before, now = y, [a + part * b for a, b in zip(y, first, strict=True)]
        for i in range(1, n):
            slope = self.rates(t + i * part, now)
            before, now = now, [a + 2 * part * b for a, b in zip(before, slope, strict=True)]
        slope = self.rates(t + h, now)
        return [(a + b + part * c) / 2 for a, b, c in zip(before, now, slope, strict=True)]
