"""Functions and steps of a scene with closed loops have the same bits in C, in NumPy, in lanes and
in CUDA; a scene without loops has no trace of them."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from coscrew_codegen.backends.python_extension import scene_calls
from coscrew_codegen.backends.scene import scene_c
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.runtime.load import kernels_of
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Scene
from tests.support.compiled.c_harness import C11, COMPILERS, CXX_COMPILERS, run
from tests.support.compiled.flags import FMA
from tests.support.each import each_precision
from tests.support.scenes import closed_loops, lanes_program
from tests.support.scenes.cuda_program import of_scene
from tests.support.scenes.cuda_runs import compared
from tests.support.scenes.generated_scenes import imported
from tests.support.scenes.scene_values import inputs, same_bits

NAMES = ("closure", "with_closed_loops", "closing_knee", "reaction_drive", "forward_dynamics",
         "forward_dynamics_derivatives", "integrated", "step_leapfrog", "step_rk4")
Made = Callable[[], SceneFunctions]


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> SceneFunctions:
    path = tmp_path_factory.mktemp("loops") / "floating.toml"
    path.write_text(closed_loops.floating_loop(), encoding="utf-8")
    return derive(read_scene(path), NAMES)


@each_precision
def test_bits_of_numpy_are_those_of_c(made: SceneFunctions, precision, tmp_path: Path,
                                      monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    kernels, package = kernels_of(made), imported(made, tmp_path)
    assert kernels.compiled
    functions = scene_calls.callables(made)
    assert {*NAMES} <= {x.name for x in functions}
    for function in functions:
        for special in (False, True):
            arguments = inputs(function, precision.numpy_type, 5, special=special)
            result, twin = (getattr(getattr(x, precision.name), function.name)(*arguments)
                            for x in (kernels, package))
            assert same_bits(result, twin), function.name


def test_bits_in_lanes_are_those_of_one_state(made: SceneFunctions, tmp_path: Path) -> None:
    sources = lanes_program.written(made, tmp_path)
    run((COMPILERS[0], *C11, "-O1", *FMA, *sources, "-o", tmp_path / "lanes", "-lm"))
    assert int(run([tmp_path / "lanes"])) > 10000


def test_bits_of_cuda_are_those_of_c(made: SceneFunctions, tmp_path: Path) -> None:
    assert compared(of_scene(made), tmp_path, CXX_COMPILERS[0], "-O1", *FMA) > 10000


def test_a_scene_without_loops_has_no_trace_of_them(tmp_path: Path) -> None:
    path = tmp_path / "open.toml"
    text = closed_loops.floating_loop()
    loop = text[text.index("[loops"):text.index("[start]")]
    path.write_text(text.replace(loop, ""), encoding="utf-8")
    opened = read_scene(path)
    path.write_text(text, encoding="utf-8")
    closed = read_scene(path)
    emptied = replace(closed, model=replace(closed.model, loops=()), name="open")
    assert _text(opened) == _text(emptied)
    assert "loops" not in _text(opened)
    assert "closure" not in _text(opened)
    assert "with_closed_loops" in _text(closed)


def _text(scene: Scene) -> str:
    return "".join(scene_c.files(derive(scene), "banner").values())
