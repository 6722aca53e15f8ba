"""Cost of certified functions of scenes: instructions, as callgrind counts them, beside plain's.

`python -m tests.benchmarks.certified_cost` compiles inverse and forward dynamics of a UR5 and a
Panda with gcc and clang, for x86-64 with FMA and without, and counts what a call takes."""

import re
import shutil
import tempfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from tabulate import tabulate

from coscrew_codegen.accuracy.scene_tiers import in_tier
from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.backends.scene import scene_c, scene_c_tier
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.program.values.formats import PRECISIONS
from tests.benchmarks.certified_scenes import ROBOTS
from tests.support.compiled.c_harness import run
from tests.support.scenes.robots import scene_of

FUNCTIONS = "inverse_dynamics", "forward_dynamics"
FLAGS = {"FMA": ("-O2", "-march=x86-64-v3"), "no FMA": ("-O2",)}
CALLS = 50
MAIN = """\
#include "{name}.h"
#include "{name}_certified.h"
#define CALLED(real, f) do {{ \\
    real q[{n}], v[{n}], x[{n}], y[{n}], bound[{n}]; \\
    for (int i = 0; i < {n}; i++) {{ \\
      q[i] = (real)((k * 7 + i * 5) % 11 - 5) / 2; \\
      v[i] = (real)((k * 3 + i) % 7 - 3) / 2; \\
      x[i] = (real)((k + i * 3) % 13 - 6) / 2; \\
    }} \\
    f; \\
  }} while (0)
int main(void) {{
  for (int k = 0; k < {calls}; k++) {{
    {lines}
  }}
  return 0;
}}
"""


def main_of(scene: SceneFunctions) -> str:
    """A program that calls every function, plain and certified."""
    lines = [f"CALLED({p.c_type}, {scene.name}_{f.name}{tier}{p.suffix}(q, v, x, y{more}));"
             for f in scene.functions for p in PRECISIONS
             for tier, more in (("", ""), ("_certified", ", bound"))]
    return MAIN.format(name=scene.name, n=scene.nv, calls=CALLS, lines="\n    ".join(lines))


def counted(binary: Path) -> dict[str, float]:
    """Instructions of a call, by function, including its callees."""
    out = binary.with_suffix(".callgrind")
    run(("valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", binary))
    table = run(("callgrind_annotate", "--inclusive=yes", "--threshold=100", out))
    matches = re.findall(r"^ *([\d,]+) .*?:(\w+) \[", table, re.M)
    return {name: int(count.replace(",", "")) / CALLS for count, name in matches}


def rows(name: str, folder: Path) -> Iterator[tuple[str, ...]]:
    """A line for each function, precision, compiler and set of flags."""
    scene = replace(derive(scene_of(*ROBOTS[name]), FUNCTIONS), name=name)
    texts = {"main.c": main_of(scene), **scene_c.files(scene, "for the benchmark"),
             **scene_c_tier.files(in_tier(scene, tier_named("certified")), "for the benchmark")}
    for path, text in texts.items():
        (folder / path).write_text(text)
    sources = [folder / path for path in texts if path.endswith(".c")]
    for compiler in filter(shutil.which, ("gcc", "clang")):
        for words, flags in FLAGS.items():
            run((compiler, "-std=c11", *flags, "-ffp-contract=off", "-DKSL_CONTRACT_OFF",
                 f"-I{folder}", *sources, "-o", folder / "main", "-lm"))
            counts = counted(folder / "main")
            for function in scene.functions:
                for p in PRECISIONS:
                    plain, certified = (counts[f"{name}_{function.name}{tier}{p.suffix}"]
                                        for tier in ("", "_certified"))
                    yield (name, function.name, p.name, compiler, words, f"{plain:.0f}",
                           f"{certified:.0f}", f"{certified / plain:.1f}")


def main() -> None:
    """Print the table."""
    table: list[tuple[str, ...]] = []
    for name in ("ur5", "panda"):
        with tempfile.TemporaryDirectory() as folder:
            table += rows(name, Path(folder))
    print("\nInstructions of a call, certified and plain")
    print(tabulate(sorted(table), ("robot", "function", "precision", "compiler", "flags", "plain",
                                   "certified", "ratio"), disable_numparse=True))


if __name__ == "__main__":
    main()
