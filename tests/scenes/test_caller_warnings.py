"""Warnings that nothing compiles name the line of the user's program, however deep they arise."""

import warnings
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import coscrew_codegen
from coscrew_codegen.runtime import compilation, lanes
from coscrew_codegen.runtime.caller_warnings import at_callers_line, warn
from coscrew_codegen.runtime.load import Kernels, kernels_for, kernels_of
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.scenes.generated_scenes import pendulum, slider

SCENE = Path(__file__).parents[2] / "examples/scenes/pendulum.toml"
CALLS = {
    "load_scene": lambda: coscrew_codegen.load_scene(SCENE),
    "kernels_for": lambda: kernels_for(read_scene(SCENE)),
    "kernels_of": lambda: kernels_of(pendulum()),
    "run": lambda: coscrew_codegen.run(SCENE, until=0.01)}


def no_room(*_: object) -> None:
    raise compilation.CompilationError("no room")


@pytest.fixture
def broken(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Nothing compiles, and the cache is empty."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(compilation, "library", no_room)


def warning_of(call: Callable[[], object]) -> tuple[str, int]:
    """The place of the only warning of a call."""
    with warnings.catch_warnings(record=True) as result:
        warnings.simplefilter("always")
        call()
    one, = result
    assert "no room" in str(one.message) and one.category is RuntimeWarning
    return one.filename, one.lineno


@pytest.mark.parametrize("name", CALLS)
def test_functions_that_make_kernels_warn_where_they_are_called(name: str, broken: None):
    call = CALLS[name]
    assert warning_of(call) == (__file__, call.__code__.co_firstlineno)


@pytest.fixture(scope="module")
def compiled() -> Iterator[Callable[[], Kernels]]:
    """Makes kernels that are compiled, but not yet for many states."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(lanes, "PAYS", 2)
        yield lambda: kernels_of(replace(slider(), tiers=("accurate",)))


def test_calls_that_would_use_lanes_warn_where_they_stand(
        compiled: Callable[[], Kernels], monkeypatch: pytest.MonkeyPatch):
    """A function, many steps, the functions of a tier."""
    kernels = [compiled() for _ in range(3)]
    p = [x for _, x in kernels[0].interface.parameters]
    q = np.tile(kernels[0].neutral_q, (4, 1))
    v = np.zeros((4, kernels[0].NV))
    monkeypatch.setattr(compilation, "library", no_room)
    calls = (lambda: kernels[0].double.energy(p, q, v),
             lambda: kernels[1].double.step_rk4.repeated(3, 0.0, 1e-3, p, q, v),
             lambda: kernels[2].accurate)
    for call in calls:
        assert warning_of(call) == (__file__, call.__code__.co_firstlineno)


def test_blocks_within_blocks_leave_warnings_to_the_outermost():
    def inner() -> None:
        with at_callers_line():
            warn("deep, no room")

    def outer() -> None:
        with at_callers_line():
            inner()
            inner()

    with warnings.catch_warnings(record=True) as result:
        warnings.simplefilter("always")
        outer()
    line = outer.__code__.co_firstlineno + 7
    assert [(x.filename, x.lineno) for x in result] == [(__file__, line)] * 2
    with pytest.raises(RuntimeWarning, match="deep"), warnings.catch_warnings():
        warnings.simplefilter("error")
        inner()
    with warnings.catch_warnings(record=True) as result:  # nothing is left of it
        warnings.simplefilter("always")
        inner()
    assert len(result) == 1
