"""Provenance of figures: processor, system, versions, command; no names of hosts or users."""

import os
import platform

import numpy as np

from coscrew_codegen import version
from coscrew_codegen.machine import processor, system
from coscrew_codegen.report.schema import Compiler, Provenance


def provenance(command: str, seed: int, compilers: tuple[Compiler, ...],
               seconds: float) -> Provenance:
    """The provenance of a report made on this machine."""
    return Provenance(command, seed, version.described(), processor(), os.cpu_count() or 1,
                      system(),
                      f"{platform.python_implementation()} {platform.python_version()}",
                      np.__version__, compilers, seconds)
