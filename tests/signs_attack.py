"""Flips every sign of a scene's accurate inverse and forward dynamics in C, one by one.

`python -m tests.signs_attack [--states N]`, or `make attack`, prints how many of them are noticed,
as results that are off by more than half a unit of their last digit and a bit, and the others.
"""

import argparse
import sys
import tempfile
from pathlib import Path

from tests.support.truth.signed_arm import judge, named_scene, unnoticed

NOTICED = 0.97


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--states", type=int, default=3000)
    options = parser.parse_args()
    scene, failed = named_scene(), False
    for function in scene.functions:
        with tempfile.TemporaryDirectory() as folder:
            count, missed = unnoticed(judge(scene, function, options.states), Path(folder))
        print(f"{function.name}: {count - len(missed)} of {count} signs noticed; not these:")
        print("\n".join(f"  {line[:100]}" for line in missed))
        failed |= len(missed) > (1 - NOTICED) * count
    return failed


if __name__ == "__main__":
    sys.exit(main())
