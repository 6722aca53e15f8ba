"""Flips every sign of a scene's accurate inverse and forward dynamics in C, one by one.

`python -m tests.signs_attack [--states N]`, or `make attack`, prints how many of them are noticed,
as results that are off by more than half a unit of their last digit and a bit, and the others.
"""

import argparse
import sys
import tempfile
from pathlib import Path

from tests.support.truth.signed_arm import named_scene, unnoticed


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--states", type=int, default=3000)
    options = parser.parse_args()
    failed = False
    for function in named_scene().functions:
        with tempfile.TemporaryDirectory() as folder:
            count, missed = unnoticed(function.name, options.states, Path(folder))
        print(f"{function.name}: {count - len(missed)} of {count} signs noticed")
        print("\n".join(f"  not {line[:100]}" for line in missed))
        failed |= bool(missed)
    return failed


if __name__ == "__main__":
    sys.exit(main())
