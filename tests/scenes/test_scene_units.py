"""Scenes' C compiles without a warning whatever is left out of it."""

from pathlib import Path

import pytest

from coscrew_codegen.targets import scene_c, scene_c_many
from tests.support.compiled.c_harness import C11, COMPILERS, STRICT, run
from tests.support.compiled.flags import FMA
from tests.support.scenes.generated_scenes import BANNER, pendulum

LEFT_OUT = ("-DPENDULUM_NO_DOUBLE", "-DPENDULUM_NO_SINGLE", "-DKSL_LANE_BYTES=0",
            "-DKSL_BLOCK=256")  # the last is CUDA's: threads of a block
by_compiler = pytest.mark.parametrize("compiler", COMPILERS)


def written(folder: Path) -> None:
    for files in (scene_c.files(pendulum(), BANNER), scene_c_many.files(pendulum(), BANNER)):
        for path, text in files.items():
            (folder / path).write_text(text)


@by_compiler
@pytest.mark.parametrize("definition", LEFT_OUT)
def test_nothing_is_unused_whatever_is_left_out(definition: str, compiler: str, tmp_path: Path):
    written(tmp_path)
    for name in ("pendulum.c", "pendulum_many.c"):
        for flags in ((), FMA):
            run((compiler, *C11, "-O1", *STRICT, *flags, definition, "-c", tmp_path / name, "-o",
                 tmp_path / "unit.o"))
