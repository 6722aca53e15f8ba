"""Kernels of a scene for CUDA have the bits of its C functions: compiled as C++, and instruction by
instruction as clang translates them for a device, whatever the flags.

`make cuda` does the same with nvcc: python -m tests.cuda_attack.
"""

import re
import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from coscrew_codegen.accuracy.scene_tiers import in_tier
from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.backends.scene import scene_c_parts
from coscrew_codegen.program.scene_functions import SceneFunctions
from tests.support.compiled.c_harness import CXX_COMPILERS, STRICT, run
from tests.support.compiled.flags import HASWELL, SANITIZERS, X86, has_sanitizers
from tests.support.scenes import scene_bits
from tests.support.scenes.cuda_program import of_scene, of_tier
from tests.support.scenes.cuda_runs import CXX11, compared, executed
from tests.support.scenes.generated_scenes import pendulum, slider, spinner

CONTRACTED = (*HASWELL, "-ffp-contract=fast") if X86 else ("-ffp-contract=fast",)
"""Flags with which products are fused into sums wherever a compiler may."""
BUILDS = [(pendulum, CXX_COMPILERS[0], ("-O2", *CONTRACTED)),
          (pendulum, CXX_COMPILERS[-1], ("-O1", *CONTRACTED)),
          (spinner, CXX_COMPILERS[0], ("-O0",)),
          *((slider, x, SANITIZERS) for x in CXX_COMPILERS[:1] if has_sanitizers(x))]


@pytest.mark.parametrize("scene, compiler, flags", BUILDS, ids=lambda x: "")
def test_bits_on_the_host(scene: Callable[[], SceneFunctions], compiler: str,
                          flags: tuple[str, ...], tmp_path: Path):
    assert compared(of_scene(scene()), tmp_path, compiler, *flags) > 10000


@pytest.mark.parametrize("tier", ("accurate", "pairs"))
def test_tiers(tier: str, tmp_path: Path):
    made = of_tier(in_tier(pendulum(), tier_named(tier)))
    assert compared(made, tmp_path, CXX_COMPILERS[0], "-O1", *CONTRACTED) > 5000


def test_functions_that_are_cut(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(scene_c_parts, "LONG", 0)
    monkeypatch.setattr(scene_c_parts, "LONGEST", 60)
    made = scene_bits.functions()
    scene = replace(made, functions=(made.named("forward_dynamics"),), steps=())
    assert compared(of_scene(scene), tmp_path, CXX_COMPILERS[0], "-O1", *CONTRACTED) > 1000
    assert "KSL_PART_DEVICE void" in (tmp_path / "carrier.cuh").read_text()


@pytest.mark.parametrize("compiler", CXX_COMPILERS)
def test_fast_math_is_refused_on_the_host(compiler: str, tmp_path: Path):
    with pytest.raises(pytest.fail.Exception, match="-ffast-math breaks the bits promised here"):
        compared(of_scene(slider()), tmp_path, compiler, "-ffast-math")


def test_several_headers_in_one_program(tmp_path: Path):
    for scene in (pendulum(), slider()):
        of_scene(scene).on_host(tmp_path)
        of_tier(in_tier(scene, tier_named("accurate"))).on_host(tmp_path)
    stems = [f"{x}{tier}" for x in ("pendulum", "slider") for tier in ("", "_accurate")]
    program = tmp_path / "all.cpp"
    program.write_text("".join(f'#include "{x}.{e}"\n' for e in ("h", "cuh") for x in stems * 2))
    run((CXX_COMPILERS[0], *CXX11, *STRICT, "-c", program, "-o", tmp_path / "all.o"))


def _makes_ptx(compiler: str) -> bool:
    """Returns whether devices of CUDA are among its targets."""
    return shutil.which(compiler) is not None and "nvptx64" in run((compiler, "--print-targets"))


@pytest.mark.parametrize("compiler", [x for x in ("clang++",) if _makes_ptx(x)])
@pytest.mark.parametrize("scene", (pendulum, slider))
def test_bits_of_instructions(compiler: str, scene: Callable[[], SceneFunctions], tmp_path: Path):
    numbers, ptx = executed(of_scene(scene()), tmp_path, compiler)
    assert numbers > 10000
    assert "mul.rn.f64" in ptx and "mul.rn.f32" in ptx and "fma" not in ptx


@pytest.mark.parametrize("compiler", [x for x in ("clang++",) if _makes_ptx(x)])
def test_bits_of_instructions_of_tiers(compiler: str, tmp_path: Path):
    for tier in ("accurate", "pairs"):
        made = of_tier(in_tier(pendulum(), tier_named(tier)))
        numbers, ptx = executed(made, tmp_path, compiler)
        assert numbers > 5000
        wanted = {"accurate": "f64", "pairs": "f32"}[tier]
        assert set(re.findall(r"fma\.rn\.(f\d\d)", ptx)) == {wanted} and ".ftz" not in ptx
