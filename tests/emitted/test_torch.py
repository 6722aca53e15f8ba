"""PyTorch, in an environment of its own: bits, derivatives and vmap of functions of its arrays."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
WHEEL = "2.13.0+cpu"
PLACE = ROOT / "build" / "torch"


@pytest.fixture(scope="module")
def place() -> Path:
    """The folder with PyTorch: 750 MB, kept; where pip sees no wheel for processors alone, of
    several GB with those for GPUs, tests are skipped."""
    if not (PLACE / f"torch-{WHEEL}.dist-info").is_dir():
        done = subprocess.run(
            [sys.executable, "-m", "pip", "install", "--quiet", "--no-compile", "--no-deps",
             "--only-binary", ":all:", "--target", PLACE, f"torch=={WHEEL}"],
            capture_output=True, text=True)
        if done.returncode:
            pytest.skip(f"pip sees no wheel torch {WHEEL}; PIP_EXTRA_INDEX_URL="
                        "https://download.pytorch.org/whl/cpu shows it")
    return PLACE


def test_scenes_and_derivatives_on_pytorchs_arrays(place: Path) -> None:
    """A scene's functions have NumPy's bits, also under vmap; first and second derivatives are
    PyTorch's differences."""
    done = subprocess.run([sys.executable, "-m", "tests.arrays_attack", "derivatives", "scene"],
                          env={**os.environ, "PYTHONPATH": str(place)}, cwd=ROOT,
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert done.stdout.split()[1:] == ["functions", "compared"] and int(done.stdout.split()[0]) > 20
