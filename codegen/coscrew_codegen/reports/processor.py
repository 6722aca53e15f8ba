"""The processor and the system, which measurements name."""

import platform
import sys
from pathlib import Path
from subprocess import run


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


def system() -> str:
    """The operating system and the kind of processor: Linux x86_64."""
    return f"{platform.system()} {platform.machine()}"
