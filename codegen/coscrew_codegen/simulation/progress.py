"""Progress of a run: one line on standard error, if that is a terminal, else one for each tenth."""

import time
from contextlib import ExitStack
from dataclasses import dataclass
from types import TracebackType

import numpy as np

from coscrew_codegen.runtime.console import Tenths, status_line
from coscrew_codegen.simulation.system import System

_EVERY = 0.1  # s between two updates


class Progress:
    """Shows a run: `t 3.2/10 s  32 %  41x real time  dE/E 2e-11  ETA 4 s`."""

    def __init__(self, system: System, until: float) -> None:
        self._system, self._until = system, until
        self._began = self._shown = time.monotonic()
        self._drift, self._first = EnergyDrift(), True
        self._tenths = Tenths()
        self._stack = ExitStack()

    def __enter__(self) -> "Progress":
        self._show = self._stack.enter_context(status_line())
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        self._stack.close()

    def __call__(self, t: float, q: np.ndarray, v: np.ndarray) -> None:
        """Shows the progress of the run."""
        now, first, self._first = time.monotonic(), self._first, False
        if self._show is None:
            if first:
                self._change(t, q, v)
            self._tenths(t / self._until, lambda: self._line(now, t, q, v))
        elif first or now >= self._shown + _EVERY:
            self._shown = now
            self._show(self._line(now, t, q, v))

    def _line(self, now: float, t: float, q: np.ndarray, v: np.ndarray) -> str:
        return line(t, self._until, now - self._began, self._change(t, q, v))

    def _change(self, t: float, q: np.ndarray, v: np.ndarray) -> float:
        """The relative change of energy; of a batch, of its first member."""
        if not self._system.has("energy"):
            return float("nan")
        kinetic, potential = self._system.energies(t, q, v)
        return self._drift(float(np.ravel(kinetic)[0]), float(np.ravel(potential)[0]))


@dataclass
class EnergyDrift:
    """Change of the total energy since the first call, relative to the largest energy exchanged so
    far: kinetic energy, or change of potential energy.  So it does not depend on where the
    potential energy is zero."""

    first: tuple[float, float] | None = None  # kinetic, potential
    exchanged: float = 0.0  # J

    def __call__(self, kinetic: float, potential: float) -> float:
        """The drift at these energies."""
        self.first = self.first or (kinetic, potential)
        change = potential - self.first[1]
        self.exchanged = max(self.exchanged, kinetic, abs(change))
        drift = abs(kinetic - self.first[0] + change)
        return drift / self.exchanged if self.exchanged else 0.0


def line(t: float, until: float, elapsed: float, drift: float) -> str:
    """The line at time t of a run that has taken `elapsed` s; `drift` is the relative
    change of energy."""
    speed = t / elapsed if elapsed > 0 else 0
    left = f"{(until - t) / speed:.0f} s" if speed > 0 else "?"
    return (f"t {t:.{_digits(until)}g}/{until:g} s  {100 * t / until:.0f} %  "
            f"{speed:.3g}x real time  dE/E {drift:.0e}  ETA {left}")


def _digits(until: float) -> int:
    """Digits of times up to the end: three, or as many as stand before its point."""
    return max(3, len(f"{until:.0f}"))
