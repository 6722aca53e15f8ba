"""nvcc, where it is installed: as NVIDIA installs it, or by `pip install "coscrew[cuda]"`."""

import shutil
import subprocess
import sysconfig
from pathlib import Path

from tests.support.compiled import c_harness


def _found() -> Path | None:
    if path := shutil.which("nvcc"):
        return Path(path)
    packages = Path(sysconfig.get_path("purelib"))
    return max(packages.glob("nvidia/cu*/bin/nvcc"), default=None)


NVCC = _found()
"""The compiler, if there is one."""


def has_device() -> bool:
    """Returns whether there is a device on which its programs run."""
    if not NVCC or not shutil.which("nvidia-smi"):
        return False
    listed = subprocess.run(["nvidia-smi", "-L"], capture_output=True, text=True)
    return not listed.returncode and "GPU" in listed.stdout


def run(source: Path, made: Path, *flags: str) -> str:
    """Compile a file; the output of nvcc."""
    return c_harness.run((str(NVCC), "-std=c++17", *flags, source, "-o", made))
