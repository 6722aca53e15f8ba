"""What certified functions of scenes cost: instructions, as callgrind counts them, beside plain's.

`python -m tests.benchmarks.certified_cost` compiles inverse and forward dynamics of a UR5 and a
Panda with gcc and clang, for x86-64 with FMA and AVX2, and without, and counts what one more call
takes.
"""

import re
import shutil
import tempfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from tabulate import tabulate

from coscrew_codegen.formats import PRECISIONS, Precision
from coscrew_codegen.mechanics import derive
from coscrew_codegen.scene_functions import Function, SceneFunctions
from coscrew_codegen.scene_tiers import in_tier
from coscrew_codegen.targets import scene_c, scene_c_tier
from coscrew_codegen.tiers import tier_named
from tests.benchmarks.certified_scenes import ROBOTS
from tests.support.compiled.c_harness import run
from tests.support.scenes.robots import scene_of

FUNCTIONS = "inverse_dynamics", "forward_dynamics"
FLAGS = {"FMA": ("-O2", "-march=x86-64-v3"), "no FMA": ("-O2",)}
TIMES = 20, 120
MAIN = """\
#include <stdlib.h>
#include "{name}.h"
#include "{name}_certified.h"
int main(int argc, char **argv) {{
  {real} q[{n}], v[{n}], x[{n}], y[{n}], bound[{n}], sum = 0;
  (void)argc;
  for (int k = 0; k < atoi(argv[2]); k++) {{
    for (int i = 0; i < {n}; i++) {{
      q[i] = ({real})((k * 7 + i * 5) % 11 - 5) / 2;
      v[i] = ({real})((k * 3 + i) % 7 - 3) / 2;
      x[i] = ({real})((k + i * 3) % 13 - 6) / 2;
    }}
    if (argv[1][0] == 'c') {{ {certified}(q, v, x, y, bound); sum += bound[0]; }}
    else if (argv[1][0] == 'p') {{ {plain}(q, v, x, y); sum += y[0]; }}
  }}
  return sum == 1.25;
}}
"""


def instructions(binary: Path, which: str) -> float:
    """Of a call: the difference between few and many of them."""
    counted = []
    for times in TIMES:
        command = ("valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", binary, which,
                   str(times))
        found = re.search(r"Collected : (\d+)", run(command))
        assert found
        counted.append(int(found[1]))
    return (counted[1] - counted[0]) / (TIMES[1] - TIMES[0])


def compiled(folder: Path, compiler: str, flags: tuple[str, ...], scene: SceneFunctions,
             function: Function, p: Precision) -> Path:
    """A program that calls the function, plain, certified or not at all, so many times."""
    named = f"{scene.name}_{function.name}"
    (folder / "main.c").write_text(MAIN.format(
        name=scene.name, n=scene.nv, real=p.c_type, plain=named + p.suffix,
        certified=f"{named}_certified{p.suffix}"))
    sources = [folder / x for x in ("main.c", f"{scene.name}.c", f"{scene.name}_certified.c")]
    run((compiler, "-std=c11", *flags, "-ffp-contract=off", "-DKSL_CONTRACT_OFF", f"-I{folder}",
         *sources, "-o", folder / "main", "-lm"))
    return folder / "main"


def rows(name: str, folder: Path) -> Iterator[tuple[str, ...]]:
    """A line for each function, precision, compiler and set of flags."""
    scene = replace(derive(scene_of(*ROBOTS[name]), FUNCTIONS), name=name)
    texts = scene_c.files(scene, "for the benchmark") | scene_c_tier.files(
        in_tier(scene, tier_named("certified")), "for the benchmark")
    for path, text in texts.items():
        (folder / path).write_text(text)
    for function in scene.functions:
        for p in PRECISIONS:
            for compiler in filter(shutil.which, ("gcc", "clang")):
                for words, flags in FLAGS.items():
                    binary = compiled(folder, compiler, flags, scene, function, p)
                    idle, plain, certified = (instructions(binary, x) for x in "npc")
                    yield (name, function.name, p.name, compiler, words, f"{plain - idle:.0f}",
                           f"{certified - idle:.0f}",
                           f"{(certified - idle) / (plain - idle):.1f}")


def main() -> None:
    """Print the table."""
    table = []
    for name in ("ur5", "panda"):
        with tempfile.TemporaryDirectory() as folder:
            table += rows(name, Path(folder))
    print("\nInstructions of a call, certified and plain")
    print(tabulate(table, ("robot", "function", "precision", "compiler", "flags", "plain",
                           "certified", "ratio"), disable_numparse=True))


if __name__ == "__main__":
    main()
