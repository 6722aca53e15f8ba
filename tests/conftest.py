"""Before the first test: checks that the compiled extensions match the kernels in generated/.

`--quick` leaves out slow files, and runs tests with many parameters for a few of them.
"""

import gc
import importlib
import os
import shutil
import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:  # imports SymPy and the operations: only the tests that need it import it
    from tests.support.truth.exact import Exact, Sample

LONG = frozenset("""
    test_absence test_accurate_functions test_cache test_calibration test_certified_scenes
    test_check test_check_advice test_check_alarms test_check_bounces test_checkers test_climb
    test_closed_loops test_closed_loops_of_pinocchio
    test_command_line test_cost test_cost_accuracy test_cost_files test_cross test_documents
    test_elementary_attack test_encodings test_examples test_family_cache test_flags
    test_found test_generate test_generate_scene test_gufuncs test_hard_cases
    test_hard_effects test_headers test_implausible test_integrators test_inverses
    test_load_scene test_loop_bits test_loop_rows test_loop_tables
    test_minimax test_motions test_mujoco test_packaging test_parity
    test_pinocchio test_random_robots test_recording test_references test_report_command
    test_report_files test_report_measure test_report_page test_roundings test_sanitizers
    test_scene_accuracy test_scene_agreement test_scene_arrays test_scene_bounds
    test_scene_compilation test_scene_flags test_scene_names test_scene_pairs test_scene_parts
    test_scene_signs test_scene_text test_scene_tiers test_selected_functions test_selfcheck
    test_simulate test_simulate_command test_sincos test_sweep test_sweep_runs test_symmetric
    test_tiers test_told test_true_motion test_typing test_version test_view""".split())
"""Files that take more than four seconds of processor time, even with few parameters."""
MANY = frozenset("""
    test_bits test_derivatives test_lagrange test_lanes test_numeric_truth test_rounding
    test_symbolic_truth test_tier_text""".split())
"""Files that take more than ten with all parameters."""
FEW = 4


@pytest.fixture(params=["double", "single"])
def k(request: pytest.FixtureRequest) -> "Exact":
    """The functions of one precision, on rational numbers."""
    from tests.support.truth.exact import Exact

    return Exact(importlib.import_module(f"coscrew.{request.param}"))


@pytest.fixture(params=range(3))
def sample(request: pytest.FixtureRequest) -> "Sample":
    """Rational numbers, seeded."""
    from tests.support.truth.exact import Sample

    return Sample(request.param)


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--stale-extensions", action="store_true",
                     help="run, though extensions are missing or of other kernels: coscrew is then "
                          "pure NumPy, and tests of compiled functions fail")
    parser.addoption("--quick", action="store_true",
                     help="leave out files that take long, and of each test's parameters all but "
                          f"{FEW}, evenly spread")


def _keep_bytecode() -> None:
    """Workers and the hundreds of processes that tests start compile no module again."""
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    sys.dont_write_bytecode = False


def _keep_cache_apart() -> None:
    """Gives tests a cache of their own, separate from the user's."""
    os.environ["XDG_CACHE_HOME"] = str(Path(__file__).parents[1] / "build" / "cache")


def _compile_fast() -> None:
    """Compiles scenes without optimization, in a fifth of the time: their bits are the same."""
    name = next((x for x in ("clang", "gcc", "cc") if shutil.which(x)), None)
    if name and "CC" not in os.environ:
        os.environ["CC"] = f"{name} -O0"


@contextmanager
def _optimized() -> Iterator[None]:
    with pytest.MonkeyPatch.context() as patch:
        if os.environ.get("CC", "").endswith(" -O0"):
            patch.delenv("CC")
        yield


@pytest.fixture(scope="module")
def users_compiler() -> Iterator[None]:
    """Scenes are compiled as users' are: tests of compiled code use it."""
    with _optimized():
        yield


@pytest.fixture
def long_run() -> Iterator[None]:
    """Scenes of one test are compiled as users' are: millions of steps take a third of the time.
    """
    with _optimized():
        yield


def pytest_configure(config: pytest.Config) -> None:
    """Report stale extensions once and stop, instead of failing in some test."""
    _keep_bytecode()
    _keep_cache_apart()
    _compile_fast()
    if config.getoption("--stale-extensions") or hasattr(config, "workerinput"):
        return
    from coscrew_codegen.runtime.build import extensions

    extended = [x.name.removesuffix("._gufunc") for x in extensions(Path(__file__).parents[1])]
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", RuntimeWarning)
        stale = [name for name in extended if not importlib.import_module(name).COMPILED]
    if stale:
        message = sorted({str(x.message) for x in caught if "pure NumPy" in str(x.message)})
        raise pytest.UsageError("\n".join((
            f"not compiled from the kernels in generated/: {', '.join(stale)}.  `make build` "
            "compiles them; --stale-extensions runs tests all the same.", *message)))


def pytest_collection_finish() -> None:
    """Excludes imported objects from Python's garbage collection, and makes it less frequent: by
    default it takes a tenth of the tests' time."""
    gc.freeze()
    gc.set_threshold(20_000)


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Ignore slow files with --quick, unless they are named."""
    named = any(Path(x.partition("::")[0]).name == collection_path.name for x in config.args)
    return config.getoption("--quick") and collection_path.stem in LONG and not named or None


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Slow files first, so that at the end no processor waits for another; a few parameters."""
    items.sort(key=lambda item: (item.path.stem not in LONG, item.path.stem not in MANY))
    if not config.getoption("--quick"):
        return
    each: dict[str, list[pytest.Item]] = {}
    for item in items:
        each.setdefault(item.nodeid.partition("[")[0], []).append(item)
    chosen = {result[k * len(result) // FEW] for result in each.values() for k in range(FEW)}
    config.hook.pytest_deselected(items=[item for item in items if item not in chosen])
    items[:] = [item for item in items if item in chosen]
