"""Flags under which compilers behave otherwise: fused products, sanitizers."""

import os
import platform
import shutil
import subprocess
from pathlib import Path

SANITIZERS = ("-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-O0")
X86 = platform.machine() in ("x86_64", "AMD64")


def _fma() -> tuple[str, ...]:
    """What x86 needs for instructions that fuse; elsewhere they are there."""
    flags = Path("/proc/cpuinfo").read_text() if Path("/proc/cpuinfo").exists() else ""
    return ("-mfma", "-mavx2") if X86 and " fma " in flags and " avx2 " in flags else ()


FMA = _fma()
UNHEEDED = "-fassociative-math"  # alone, gcc says so; a pragma may put it in force
TUNED = (*FMA, "-mtune=sapphirerapids") if FMA else ()


def has_sanitizers(compiler: str) -> bool:
    """Whether the compiler's sanitizers are installed; a build server must have them."""
    if os.environ.get("CI") or shutil.which(compiler) is None:
        return True  # so that the test says what is missing
    command = (compiler, *SANITIZERS, "-x", "c", "-", "-o", os.devnull)
    return not subprocess.run(command, input="int main(void) { return 0; }", text=True,
                              capture_output=True).returncode
