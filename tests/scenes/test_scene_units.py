"""Scenes' C compiles without a warning whatever is left out of it, and several files as one."""

from pathlib import Path

import pytest

from coscrew_codegen.backends.scene import scene_c, scene_c_many
from tests.support.compiled import all_headers
from tests.support.compiled.c_harness import C11, COMPILERS, STRICT, run
from tests.support.compiled.flags import FMA
from tests.support.scenes import lanes_program
from tests.support.scenes.generated_scenes import BANNER, pendulum, slider

LEFT_OUT = ("-DKSL_LANE_BYTES=0", "-DKSL_BLOCK=256")  # the last is CUDA's: threads of a block
by_compiler = pytest.mark.parametrize("compiler", COMPILERS)


def written(folder: Path) -> None:
    for scene in (pendulum(), slider()):
        for files in (scene_c.files(scene, BANNER), scene_c_many.files(scene, BANNER)):
            for path, text in files.items():
                (folder / path).write_text(text)


@by_compiler
@pytest.mark.parametrize("definition", LEFT_OUT)
def test_nothing_is_unused_whatever_is_left_out(definition: str, compiler: str, tmp_path: Path):
    written(tmp_path)
    for name in ("pendulum.c", "pendulumf.c", "pendulum_many.c", "pendulum_manyf.c"):
        for flags in ((), FMA):
            run((compiler, *C11, "-O1", *STRICT, *flags, definition, "-c", tmp_path / name, "-o",
                 tmp_path / "unit.o"))


LIBRARY = "ksl/coscrew_many.h"
ORDERS = (("pendulum.c", "pendulumf.c", "pendulum_many.c", "pendulum_manyf.c", "slider.c",
           "sliderf.c", "slider_many.c", "slider_manyf.c", LIBRARY),
          ("slider_manyf.c", "slider_many.c", "pendulum_many.c", "pendulumf.c", "pendulum.c",
           "pendulum_manyf.c", LIBRARY, "slider.c", "sliderf.c"),
          (LIBRARY, "sliderf.c", "slider.c", "pendulum_manyf.c", "pendulum_many.c",
           "slider_many.c", "slider_manyf.c", "pendulum.c", "pendulumf.c"))


@pytest.mark.parametrize("compiler, order, flags", (
    *((x, order, FMA) for x in COMPILERS for order in ORDERS),
    (COMPILERS[0], ORDERS[1], ("-DKSL_LANE_BYTES=0",))), ids=str)
def test_several_files_are_one(compiler: str, order: tuple[str, ...], flags: tuple[str, ...],
                               tmp_path: Path):
    """With the bits that each has alone."""
    written(tmp_path)
    program, *_ = lanes_program.written(pendulum(), tmp_path)
    unit = tmp_path / "unit.c"
    unit.write_text("".join(f'#include "{x}"\n' for x in (*order, program.name)))
    run((compiler, *C11, "-O1", *STRICT, *flags, "-I", all_headers.include(), unit,
         "-o", tmp_path / "unit", "-lm"))
    assert int(run([tmp_path / "unit"])) > 10000
