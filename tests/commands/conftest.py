"""Fixtures of several files of this folder."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support.scenes.simulated import kernels, scene_file

__all__ = ["kernels"]


@pytest.fixture(scope="module")
def scene(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The file of the scene that sweeps vary: a block that slides, and swivels on it."""
    from tests.support.scenes.sweeps import SLIDER  # imports PyArrow

    return scene_file(tmp_path_factory.mktemp("scene"), SLIDER, "slider")


@pytest.fixture(scope="module")
def small_chunks() -> Iterator[None]:
    """Chunks of sweeps have 64 members, though their work is little."""
    from coscrew_codegen.simulation.sweep import prepare

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(prepare, "_STEPS", (1, 50_000_000))
        yield
