"""Fixed point for CUDA has the bits of NumPy's integers: compiled as C++, and instruction by
instruction as clang translates it for a device; `python -m tests.cuda_attack` does so with nvcc,
and on a device."""

import re
from dataclasses import replace
from pathlib import Path

import pytest

from coscrew_codegen.accuracy.fixed_scene import FixedScene, in_fixed
from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.backends.fixed.scene_c_fixed_runtime import NAME
from coscrew_codegen.backends.output_files import scene_files
from coscrew_codegen.dynamics import derive
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.compiled.c_harness import CXX_COMPILERS, STRICT, run
from tests.support.scenes import fixed_cuda
from tests.support.scenes import fixed_point as fx

GIMBAL = Path(__file__).parents[2] / "examples/fixed_point/gimbal.toml"


@pytest.fixture(scope="module")
def made() -> FixedScene:
    return in_fixed(derive(read_scene(GIMBAL), ("inverse_dynamics", "energy")), tier_named("fixed"))


@pytest.mark.parametrize("compiler, flags", (
    (CXX_COMPILERS[0], ("-O1",)),
    (CXX_COMPILERS[-1], ("-O0", "-fsanitize=undefined", "-fsanitize-undefined-trap-on-error"))),
    ids=("optimised", "sanitized"))
def test_bits_on_the_host(made, compiler, flags, tmp_path):
    assert fixed_cuda.compared(fixed_cuda.on_host(made, tmp_path, compiler, *flags), made) == 700


@pytest.mark.skipif("nvptx64" not in run((CXX_COMPILERS[-1], "--print-targets")),
                    reason="clang makes no code for devices")
def test_bits_of_instructions(made, tmp_path):
    library, ptx = fixed_cuda.translated(made, tmp_path, CXX_COMPILERS[-1])
    assert fixed_cuda.compared(library, made) == 700
    assert "mul.wide.s32" in ptx and not re.search(r"\.f(32|64)\b", ptx)


def test_two_headers_in_one_program(made, tmp_path):
    fixed_cuda.written(made, tmp_path)
    fx.written(made, tmp_path)
    other = replace(made, plain=replace(made.plain, name="other"))
    fixed_cuda.written(other, tmp_path)
    program = tmp_path / "all.cpp"
    program.write_text("".join(f'#include "{x}"\n' for x in (
        "gimbal_fixed.h", "gimbal_fixed.cuh", "other_fixed.cuh", "gimbal_fixed.cuh", NAME)))
    run((CXX_COMPILERS[0], "-std=c++11", *STRICT, "-c", program, "-o", tmp_path / "all.o"))


def test_other_versions_of_the_shared_header_are_refused(made, tmp_path):
    fixed_cuda.written(made, tmp_path)
    shared = (tmp_path / NAME).read_text()
    (tmp_path / NAME).write_text(shared.replace("COSCREW_FIXED 0x", "COSCREW_FIXED 1"))
    (tmp_path / "program.cpp").write_text('#include "gimbal_fixed.cuh"\n')
    with pytest.raises(pytest.fail.Exception, match="belongs to another version of coscrew"):
        run((CXX_COMPILERS[0], "-c", tmp_path / "program.cpp", "-o", tmp_path / "program.o"))


def test_only_scenes_with_the_tier_have_the_header(tmp_path):
    plain = derive(fx.panda(tmp_path, tiers=""), ("energy",))
    fixed = replace(plain, tiers=("fixed",))
    assert scene_files(fixed, cuda=True).keys() - scene_files(fixed).keys() == {
        "panda.cuh", "panda_fixed.cuh"}
    assert scene_files(plain, cuda=True).keys() - scene_files(plain).keys() == {"panda.cuh"}
