"""Before the first test: compiled extensions must be of the kernels that stand in generated/."""

import importlib
import warnings

import pytest

EXTENDED = ("coscrew", "coscrew.accurate", "coscrew.certified")


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--stale-extensions", action="store_true",
                     help="run, though extensions are missing or of other kernels: coscrew is then "
                          "pure NumPy, and tests of compiled functions fail")


def pytest_configure(config: pytest.Config) -> None:
    """Says once what is wrong and ends, instead of failing where something happens to notice."""
    if config.getoption("--stale-extensions") or hasattr(config, "workerinput"):
        return
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", RuntimeWarning)
        stale = [name for name in EXTENDED if not importlib.import_module(name).COMPILED]
    if stale:
        said = sorted({str(x.message) for x in caught if "pure NumPy" in str(x.message)})
        raise pytest.UsageError("\n".join((
            f"not compiled from the kernels in generated/: {', '.join(stale)}.  `make build` "
            "compiles them; --stale-extensions runs tests all the same.", *said)))
