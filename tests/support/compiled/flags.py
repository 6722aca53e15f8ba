"""Flags that change the behaviour of compilers: fused products, sanitizers."""

import os
import platform
import shutil
import subprocess
from pathlib import Path

SANITIZERS = ("-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-O0")
X86 = platform.machine() in ("x86_64", "AMD64")


def _can(*instructions: str) -> bool:
    """Returns whether this is an x86 that has all of these instructions."""
    known = Path("/proc/cpuinfo")
    return X86 and known.exists() and {*instructions} <= {*known.read_text().split()}


FMA = ("-mfma", "-mavx2") if _can("fma", "avx2") else ()
"""Flags that x86 needs for fused instructions; other processors always have them."""
HASWELL = ("-march=haswell",) if _can("fma", "avx2", "bmi2", "movbe") else ()
UNHEEDED = "-fassociative-math"  # gcc ignores it alone and says so; a pragma may put it in force
TUNED = ("-march=sapphirerapids",) if _can("avx512_fp16", "amx_tile") else (
    (*FMA, "-mtune=sapphirerapids") if FMA else ())


def has_sanitizers(compiler: str) -> bool:
    """Returns whether the compiler's sanitizers are installed; a build server must have them."""
    if os.environ.get("CI") or shutil.which(compiler) is None:
        return True  # so that the test names the missing compiler
    command = (compiler, *SANITIZERS, "-x", "c", "-", "-o", os.devnull)
    return not subprocess.run(command, input="int main(void) { return 0; }", text=True,
                              capture_output=True).returncode
