"""The load of the machine while times were measured."""

import os
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field

_BUSY = 0.9  # least share of a processor that timing has on a machine that is free


@dataclass(frozen=True)
class Load:
    """The share of a processor that timing had, and the tasks that wanted the processors."""

    share: float
    tasks: float | None  # mean number in the last minute; None where the system does not count
    processors: int

    def __str__(self) -> str:
        tasks = "" if self.tasks is None else (
            f"; in the last minute {self.tasks:.1f} tasks on average wanted the "
            f"{self.processors} processors")
        busy = (": it was loaded, so times vary; compare them by their intervals"
                if self.share < _BUSY or (self.tasks or 0) > self.processors else "")
        return (f"Load of the machine: timing had {100 * self.share:.0f} % of a processor{tasks}"
                f"{busy}.")


@dataclass
class LoadWatch:
    """Adds up the time that timing took, and that its processor gave it."""

    elapsed: float = 0.0
    processor: float = 0.0
    tasks: list[float] = field(default_factory=list)

    @contextmanager
    def timing(self) -> Iterator[None]:
        """Surrounds what is timed."""
        began, processor = time.perf_counter(), time.thread_time()
        try:
            yield
        finally:
            self.elapsed += time.perf_counter() - began
            self.processor += time.thread_time() - processor
            if hasattr(os, "getloadavg"):
                self.tasks.append(os.getloadavg()[0])

    @property
    def load(self) -> Load | None:
        """The load, if anything was timed."""
        return Load(min(1.0, self.processor / self.elapsed), max(self.tasks, default=None),
                    os.cpu_count() or 1) if self.elapsed else None
