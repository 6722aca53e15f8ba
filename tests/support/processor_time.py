"""Lists test files by the processor time of their tests: `pytest -p tests.support.processor_time`.

Unlike --durations it does not depend on the machine's load, and counts the processes that tests
start and wait for, such as compilers."""

import resource
import time
from collections import defaultdict
from collections.abc import Generator
from dataclasses import dataclass

import pluggy
import pytest
from tabulate import tabulate

_PROPERTY = "processor_time"
_LEAST = 1.0  # s below which a file is only counted in the sum


@dataclass(frozen=True)
class Spent:
    """Processor time in s: of Python, and of processes that it has waited for."""

    own: float = 0.0
    children: float = 0.0

    def __add__(self, other: "Spent") -> "Spent":
        return Spent(self.own + other.own, self.children + other.children)

    def __sub__(self, other: "Spent") -> "Spent":
        return Spent(self.own - other.own, self.children - other.children)

    @property
    def total(self) -> float:
        return self.own + self.children


def spent() -> Spent:
    """By this process so far."""
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return Spent(time.process_time(), children.ru_utime + children.ru_stime)


class _Clock:
    """Notes in each report the time since the one before, and sums by file.  In a worker of xdist
    the reports are made, and where the workers were started they are summed."""

    def __init__(self) -> None:
        self._before = spent()
        self._files: defaultdict[str, Spent] = defaultdict(Spent)

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_makereport(self) -> Generator[None, pluggy.Result[pytest.TestReport], None]:
        now = spent()
        since, self._before = now - self._before, now
        made = yield
        made.get_result().user_properties.append((_PROPERTY, (since.own, since.children)))

    def pytest_collection_finish(self) -> None:
        self._before = spent()

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        for name, since in report.user_properties:
            if name == _PROPERTY and isinstance(since, tuple | list):
                self._files[report.nodeid.partition("::")[0]] += Spent(*since)

    def pytest_terminal_summary(self, terminalreporter: pytest.TerminalReporter) -> None:
        ordered = sorted(self._files.items(), key=lambda x: -x[1].total)
        rows = [(name, x.own, x.children) for name, x in ordered if x.total >= _LEAST]
        every = sum(self._files.values(), Spent())
        terminalreporter.section("processor time in s")
        terminalreporter.write_line(str(tabulate(
            [*rows, ("all", every.own, every.children)], ("file", "tests", "what they start"),
            floatfmt=".1f")))


def pytest_configure(config: pytest.Config) -> None:
    config.pluginmanager.register(_Clock(), _PROPERTY)
