"""Compares all functions of many elements with those of one, in every tier, with each compiler, as
vectors of every width.

`python -m tests.many_attack [TIER ...]`, or `make attack`, prints how many comparisons there were.
"""

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

from coscrew_codegen.accuracy.tiers import TIERS
from tests.support.compiled import many_program
from tests.support.compiled.bits_program import kernels
from tests.support.compiled.c_harness import COMPILERS
from tests.support.compiled.flags import HASWELL

FLAGS = (("-O3",), ("-O2", *HASWELL, "-ffp-contract=fast"), ("-O3", "-march=native"))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("tiers", metavar="TIER", nargs="*")
    named = parser.parse_args().tiers
    failed = 0
    for tier in (x for x in TIERS if not named or x.name in named):
        for compiler in COMPILERS:
            for flags in FLAGS:
                with tempfile.TemporaryDirectory() as folder:
                    program = many_program.built(Path(folder), kernels(tier.mark), True,
                                                 (compiler, *flags))
                    done = subprocess.run([program], capture_output=True, text=True)
                print(tier.name, compiler, *flags, done.stdout.strip(), flush=True)
                failed |= done.returncode
    return failed


if __name__ == "__main__":
    sys.exit(main())
