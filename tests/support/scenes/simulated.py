"""Files, kernels and runs that tests of simulations share."""

from pathlib import Path

import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.__main__ import main
from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.simulation.plan import Trajectory, plan
from coscrew_codegen.simulation.run import integrate
from coscrew_codegen.simulation.system import system
from tests.support.scenes import scene_texts as texts
from tests.support.scenes.selecting import STEPPED


def scene_file(folder: Path, text: str, name: str = "scene") -> Path:
    path = folder / f"{name}.toml"
    path.write_text(text)
    return path


class Loaded(dict[str, Kernels]):
    """Kernels by the name of their text, loaded when they are first used."""

    def __init__(self, folder: Path):
        self._folder = folder

    def __missing__(self, name: str) -> Kernels:
        path = scene_file(self._folder, getattr(texts, name), name.lower())
        self[name] = load_scene(path, functions=STEPPED)
        return self[name]


@pytest.fixture(scope="module")
def kernels(tmp_path_factory: pytest.TempPathFactory) -> Loaded:
    return Loaded(tmp_path_factory.mktemp("scenes"))


def run(kernels: Kernels, precision: str = "double", until: float | None = None,
        step: float | None = None, integrator: str | None = None, every: float | None = None
        ) -> Trajectory:
    its = system(kernels, precision)
    return integrate(its, plan(its, until, step, integrator, every))


def outcome(path: Path, capsys: pytest.CaptureFixture[str], command: str, text: str,
            *words: str) -> tuple[int, str]:
    """The command's exit status and output."""
    path.write_text(text)
    status = main([command, str(path), *words])
    output = capsys.readouterr()
    return status, output.out + output.err
