"""Compares functions of many states of the examples' robots, plain and in tiers, with those of one
state: with each compiler, width and flag.

`python -m tests.lanes_attack [SCENE ...]`, or `make attack`, prints how many numbers were compared.
"""

import argparse
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path

from coscrew_codegen.accuracy.scene_tiers import tiers_of
from coscrew_codegen.dynamics import derive
from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides, read_scene
from tests.support.compiled.c_harness import C11, COMPILERS, in_parallel
from tests.support.compiled.flags import HASWELL
from tests.support.scenes import lanes_program

SCENES = Path(__file__).parents[1] / "examples" / "scenes"
FLAGS = (("-O1",), ("-O2", *HASWELL, "-ffp-contract=fast"), ("-O3", "-march=native"))


def programs(scene: str, folder: Path) -> Iterator[tuple[str, Sequence[Path]]]:
    """All plain functions that the scene can have; its default functions in tiers."""
    path = SCENES / f"{scene}.toml"
    plain = read_scene(path, overrides=SceneOverrides(functions=("all",)))
    yield "plain", lanes_program.written(derive(plain), folder)
    tiered = read_scene(path, overrides=SceneOverrides(
        functions=("forward_dynamics",), tiers=("accurate", "certified", "pairs")))
    for made in tiers_of(derive(tiered)):
        yield made.tier.name, lanes_program.tier_written(made, folder)


def compared(sources: Sequence[Path], compiler: str, *flags: str) -> subprocess.CompletedProcess:
    """The program's output, compiled with these flags."""
    objects = [x.with_suffix(".o") for x in sources]
    in_parallel([(compiler, *C11, *flags, "-c", x, "-o", y)
                 for x, y in zip(sources, objects, strict=True)])
    program = sources[0].with_suffix("")
    in_parallel([(compiler, *flags, *objects, "-o", program, "-lm")])
    return subprocess.run([program], capture_output=True, text=True)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scenes", metavar="SCENE", nargs="*")
    failed = 0
    for scene in parser.parse_args().scenes or ("pendulum", "arm6", "quadruped"):
        with tempfile.TemporaryDirectory() as folder:
            for tier, sources in programs(scene, Path(folder)):
                for compiler in COMPILERS:
                    for flags in FLAGS:
                        done = compared(sources, compiler, *flags)
                        print(scene, tier, compiler, *flags, done.stdout.strip(), flush=True)
                        failed |= done.returncode
    return failed


if __name__ == "__main__":
    sys.exit(main())
