"""A copy of the generator and of its templates, to change, and `coscrew generate` of it."""

import os
import shutil
import subprocess
import sys
from importlib.resources import as_file, files
from pathlib import Path

import coscrew_codegen


def copied(folder: Path) -> Path:
    """The folder, which holds a copy of the package now."""
    package, unneeded = folder / "coscrew_codegen", shutil.ignore_patterns("__pycache__")
    shutil.copytree(Path(coscrew_codegen.__file__).parent, package, ignore=unneeded)
    with as_file(files("coscrew_codegen.templates")) as templates:
        shutil.copytree(templates, package / "templates", ignore=unneeded)
    return folder


def generated(site: Path, *words: str, **environment: str) -> subprocess.CompletedProcess[str]:
    """`coscrew generate` of the copy in this folder, whose cache is there too."""
    return subprocess.run(
        [sys.executable, "-m", "coscrew_codegen", "generate", *words], cwd=site, text=True,
        capture_output=True, env={**os.environ, "PYTHONPATH": str(site),
                                  "XDG_CACHE_HOME": str(site / "cache"), **environment})
