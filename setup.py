"""What setuptools builds: asked of codegen/build.py, which looks at the folders."""

import sys
from pathlib import Path

from setuptools import setup

ROOT = Path(__file__).parent
sys.path.insert(0, str(ROOT))

from codegen.build import ROOTS, BuildExt, extensions, packages  # noqa: E402

setup(packages=packages(ROOT), package_dir=ROOTS, ext_modules=extensions(ROOT),
      cmdclass={"build_ext": BuildExt})
