"""All scenes' C shares one header, which stands apart from it, and which belongs to its version."""

import math
import re
from dataclasses import replace
from pathlib import Path

import pytest

from coscrew_codegen.accuracy.scene_tiers import in_tier
from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.backends.scene import (
    scene_c,
    scene_c_many,
    scene_c_runtime,
    scene_c_tier,
    scene_runtime_header,
)
from coscrew_codegen.backends.scene.scene_runtime_header import fingerprint_of
from coscrew_codegen.backends.selection import select
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.compiled.c_harness import C11, DIALECTS, STRICT, run
from tests.support.compiled.flags import FMA
from tests.support.each import each_compiler
from tests.support.scenes.generated_scenes import (
    BANNER,
    CASES,
    LATEST,
    first_function,
    pendulum,
    robot,
    slider,
)

EXAMPLES = Path(__file__).parents[2] / "examples" / "scenes"
RUNTIME = scene_c_runtime.NAME
MAIN = """
#include <stdio.h>
#include "pendulum.h"
#include "other.h"
int main(void) {
  const double q = 0.5, v = 0.25, tau = 0.125;
  const float qf = -0.75f, vf = 0, tauf = 0;
  double a;
  float af;
  pendulum_forward_dynamics(&q, &v, &tau, &a);
  other_forward_dynamicsf(&qf, &vf, &tauf, &af);
  printf("%.17g %.9g", a, (double)af);
  return 0;
}
"""


def example(name: str) -> SceneFunctions:
    """The functions of an example scene."""
    return derive(read_scene(EXAMPLES / f"{name}.toml"))


def test_every_scene_and_tier_brings_the_same_header():
    accurate = in_tier(pendulum(), tier_named("accurate"))
    made = [*(scene_c.files(x(), BANNER) for x in CASES.values()),
            scene_c_many.files(slider(), BANNER), scene_c_tier.files(accurate, BANNER),
            scene_c_many.tier_files(accurate, BANNER)]
    assert len({files[RUNTIME] for files in made}) == 1
    name = slider().name.upper()
    assert name not in made[0][RUNTIME] and "slider" not in made[0][RUNTIME]


def test_the_header_comes_with_the_whole_library_and_with_no_part_of_it():
    def made(*families: str) -> dict[str, str]:
        return scene_runtime_header.files(select([*families], "both", None).library(
            lambda kernels, make: make(kernels)))

    assert made() == {scene_c_runtime.PATH: scene_c_runtime.files()[RUNTIME]}
    assert made("vec3") == {}


def test_sources_define_no_elementary_function_themselves():
    """They are in the header alone."""
    for made in CASES.values():
        files = scene_c.files(made(), BANNER)
        for path, text in files.items():
            if path.endswith(".c"):
                assert not re.search(r"^static [^;{]*\bksl_\w+\([^;]*\{$", text, re.MULTILINE), path


@pytest.mark.parametrize("more", ((), FMA), ids=str)
@pytest.mark.parametrize("compiler, language", DIALECTS, ids=lambda x: "".join(x).replace("-", ""))
def test_the_header_compiles_alone_and_in_any_order(compiler: str, language: tuple[str, ...],
                                                    more: tuple[str, ...], tmp_path: Path):
    """The additions of accurate tiers may come later, or first."""
    (tmp_path / RUNTIME).write_text(scene_c_runtime.files()[RUNTIME])
    include, define = f'#include "{RUNTIME}"\n', "#define COSCREW_RUNTIME_ERRORS\n"
    for n, text in enumerate((include * 2, define + include * 2, include + define + include)):
        (tmp_path / f"{n}.c").write_text(f"{text}typedef int nothing;\n")
        run((compiler, *language, *STRICT, *more, "-O1", "-c", tmp_path / f"{n}.c", "-o",
             tmp_path / "x.o"))


def _written(folder: Path, *several: dict[str, str]) -> list[Path]:
    """The sources among these files, which are written."""
    for files in several:
        for path, text in files.items():
            (folder / path).write_text(text)
    return sorted(folder.glob("*.c"))


@each_compiler
def test_two_scenes_are_linked_into_one_program(compiler: str, tmp_path: Path):
    """Each in both precisions, with an accurate tier and functions of many states: a = tau - g/l
    sin q."""
    one = example("pendulum")
    sources = _written(tmp_path, *(
        files for x in (one, replace(one, name="other"))
        for files in (scene_c.files(x, BANNER), scene_c_many.files(x, BANNER),
                      scene_c_tier.files(in_tier(x, tier_named("accurate")), BANNER))))
    assert len(sources) == 2 * 2 * 3
    (tmp_path / "main.c").write_text(MAIN)
    run((compiler, *C11, "-O1", *sources, tmp_path / "main.c", "-o", tmp_path / "main", "-lm"))
    a, af = map(float, run([tmp_path / "main"]).split())
    assert a == pytest.approx(0.125 - 9.81 * math.sin(0.5), rel=2**-51)
    assert af == pytest.approx(9.81 * math.sin(0.75), rel=2**-22)


@pytest.mark.parametrize("source", ("pendulum.c", "pendulumf.c", "pendulum_many.c",
                                    "pendulum_accurate.c"))
@each_compiler
def test_a_header_of_another_version_is_refused(compiler: str, source: str, tmp_path: Path):
    made = in_tier(pendulum(), tier_named("accurate"))
    _written(tmp_path, scene_c.files(pendulum(), BANNER), scene_c_many.files(pendulum(), BANNER),
             scene_c_tier.files(made, BANNER))
    command = (compiler, *C11, "-fsyntax-only", tmp_path / source)
    run(command)
    header = tmp_path / RUNTIME
    own = scene_c_runtime.fingerprint()
    for other in (header.read_text().replace(own, f"{int(own, 16) ^ 1:#x}"),
                  "/* before there were versions */\n"):
        header.write_text(other)
        with pytest.raises(pytest.fail.Exception, match="belongs to another version of coscrew"):
            run(command)


def test_the_fingerprint_is_that_of_the_code():
    """Every change of code gives another, no comment does."""
    text = scene_c_runtime.files()[RUNTIME]
    unnamed = text.replace(scene_c_runtime.fingerprint(), "0x00000000")
    own = fingerprint_of(unnamed)
    assert own == scene_c_runtime.fingerprint()

    def changed(old: str, new: str) -> str:
        assert old in unnamed
        return fingerprint_of(unnamed.replace(old, new, 1))

    assert changed("/* ", "/* once more: ") == own
    assert changed("#define COSCREW_RUNTIME ", "/* more */ #define COSCREW_RUNTIME ") == own
    assert changed(" * 0.5)", " * 0.25)") != own
    assert changed("static ", "static inline ") != own


def test_a_reader_meets_the_first_function_soon():
    """Its place where functions are cut into parts; test_examples.py looks into the examples."""
    for name, text in scene_c.files(robot(35, 9000), BANNER).items():
        if name.endswith(".c"):
            assert first_function(text) <= LATEST, name
