"""Provenance of figures: processor, system, versions, command; no names of hosts or users."""

import os
import platform

import numpy as np

from coscrew_codegen.backends import version
from coscrew_codegen.reports.kernels.report_json import CompilerRecord, Provenance
from coscrew_codegen.reports.processor import processor, system


def provenance(command: str, seed: int, compilers: tuple[CompilerRecord, ...],
               seconds: float) -> Provenance:
    """The provenance of a report made on this machine."""
    return Provenance(command, seed, version.described(), processor(), os.cpu_count() or 1,
                      system(),
                      f"{platform.python_implementation()} {platform.python_version()}",
                      np.__version__, compilers, seconds)
