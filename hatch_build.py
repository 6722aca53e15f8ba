"""Tells hatchling what it cannot find: extension modules, which setuptools compiles, and folders
that a wheel holds inside its packages."""

import os
import shutil
import sys
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

sys.path.insert(0, str(Path(__file__).parent / "codegen"))

from coscrew_codegen.runtime.build import PYTHON, WITHIN_PACKAGES, build_modules  # noqa: E402


class BuildHook(BuildHookInterface[Any]):
    """Compiles the extension modules: beside their packages for an editable installation, unless
    COSCREW_COMPILE is `later`; else into the wheel, whose tag then names the processor."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        root = Path(self.root)
        if version == "editable":
            if os.environ.get("COSCREW_COMPILE") != "later":
                build_modules(root, root / PYTHON)
            return
        built = root / "build" / "wheel"
        shutil.rmtree(built, ignore_errors=True)  # an older module would pass for one of this build
        modules = build_modules(root, built)
        build_data["force_include"] |= WITHIN_PACKAGES | modules
        build_data["pure_python"] = not modules
        build_data["infer_tag"] = bool(modules)
