"""Provenance of figures: processor, system, versions, command; no names of hosts or users."""

import os
import platform
import sys
from pathlib import Path
from subprocess import run

import numpy as np

from coscrew_codegen import version
from coscrew_codegen.report.schema import Compiler, Provenance


def provenance(command: str, seed: int, compilers: tuple[Compiler, ...],
               seconds: float) -> Provenance:
    """The provenance of a report made on this machine."""
    return Provenance(command, seed, version.described(), processor(), os.cpu_count() or 1,
                      f"{platform.system()} {platform.machine()}",
                      f"{platform.python_implementation()} {platform.python_version()}",
                      np.__version__, compilers, seconds)


def processor() -> str:
    """The processor's model, if the system reports it."""
    cpuinfo = Path("/proc/cpuinfo")
    if cpuinfo.exists():
        for line in cpuinfo.read_text(errors="replace").splitlines():
            key, _, value = line.partition(":")
            if key.strip() in ("model name", "Model"):
                return value.strip()
    if sys.platform == "darwin":
        return run(["sysctl", "-n", "machdep.cpu.brand_string"], capture_output=True,
                   text=True).stdout.strip()
    return platform.processor() or platform.machine()
