"""All C headers: the ones in generated/, and others that only options write, for functions of many
elements and for each tier in one file.  They are generated once, for all processes of a run of
tests and for later runs, until the generator's sources change."""

import fcntl
import hashlib
import shutil
import sys
from functools import cache
from pathlib import Path

from coscrew_codegen.accuracy.tiers import MARKED, TIERS
from coscrew_codegen.backends.c.c_amalgamated import file_name
from tests.support.compiled.c_harness import run

ROOT = Path(__file__).parents[3]
AMALGAMATIONS = tuple(file_name(tier) for tier in TIERS)
"""The names of the files that hold all headers of a tier."""
COMMAND = ("generate", "--language", "c", "--many", "--amalgamate",
           *(tier.name for tier in MARKED))


@cache
def c_folder() -> Path:
    """The folder with coscrew.h, coscrew_accurate.h and so on, and with include/ksl/."""
    folder = ROOT / "build" / "headers"
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / "lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # until it is closed: other processes wait
        made_from, sources = folder / "made_from", _digest()
        if not made_from.exists() or made_from.read_text() != sources:
            made_from.unlink(missing_ok=True)
            shutil.rmtree(folder / "c", ignore_errors=True)  # with files that are no longer made
            run([sys.executable, "-m", "coscrew_codegen", *COMMAND, "--output", folder])
            made_from.write_text(sources)
    return folder / "c"


def include() -> Path:
    """The folder for a compiler's include path."""
    return c_folder() / "include"


def _digest() -> str:
    """A hash of the generator's sources."""
    digest = hashlib.sha256()
    for path in sorted(x for name in ("codegen", "templates") for x in (ROOT / name).rglob("*")):
        if path.suffix in (".py", ".jinja", ".c", ".h"):
            digest.update(str(path.relative_to(ROOT)).encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()
