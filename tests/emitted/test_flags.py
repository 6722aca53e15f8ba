"""The headers' bits under every flag that compiles: those of the NumPy twins.

Loops over arrays of structs and over structures of arrays, where vectorisers see them.
"""

import shutil
from pathlib import Path

import pytest

from coscrew_codegen.accuracy.tiers import MARKED, TIERS
from coscrew_codegen.algebra.operations import OPERATIONS
from tests.support.compiled.bits_program import Kernel, kernels, text, wanted
from tests.support.compiled.c_harness import COMPILERS, INCLUDE, run
from tests.support.compiled.flags import FMA, TUNED, UNHEEDED
from tests.support.each import each_compiler

# Kernels with all shapes: sums of two and three products, differences, chains, quotients, roots.
CHOSEN = ("cross_vv", "dot_vv", "vec3_normalized", "product_drv", "mat3x3_determinant",
          "product_CoAdc", "product_CoAdtc", "cross_sc", "cross_ss", "axpy_cc", "dot_cs",
          "quaternion_product_qq", "hctx", "product_Bs", "mat3x3_orthonormalized")
BEHIND = ("cross_vv", "dot_cs", "product_CoAdtc", "cross_sc", "vec3_normalized")
NEGATED = ("product_avinv", "product_drvinv", "hsrainv", "quaternion_product_qq")  # fused sums
KERNELS = tuple(k for tier in TIERS for k in kernels(
    tier.mark, BEHIND + NEGATED if tier.marked else CHOSEN))


# gcc fuses by default, unless told -std=c11.
FLAGS = {
    "gcc": (("-O2",), ("-O3", *FMA), ("-O2", *TUNED), ("-std=c11", "-O3", "-march=native"),
            ("-std=c11", "-O2", *FMA, "-ffp-contract=fast", UNHEEDED),
            ("-x", "c++", "-std=gnu++17", "-O3", "-march=native", "-ffp-contract=fast", UNHEEDED)),
    "clang": (("-O2",), ("-O3", *FMA), ("-O3", *FMA, "-ffp-contract=fast"),
              ("-std=c11", "-O2", "-march=native", "-ffp-contract=fast"),
              ("-O3", *FMA, "-ffp-contract=off", "-DKSL_CONTRACT_OFF"),
              ("-O3", *FMA, "-DKSL_CONTRACT_OFF"),  # fuses within expressions
              ("-x", "c++", "-std=c++17", "-O2", *FMA, "-ffp-contract=fast")),
}
BUILDS = tuple((compiler, flags) for compiler in COMPILERS for flags in FLAGS[compiler])


def test_chosen_kernels_exist():
    names = {op.name for op in OPERATIONS}
    assert len([name for name in CHOSEN if name in names]) > 10
    assert {k.tier for k in KERNELS} == {tier.mark for tier in TIERS}
    assert {k.tier for k in KERNELS if k.operation.name == "product_drvinv"} == {
        tier.mark for tier in MARKED}


@pytest.fixture(scope="module")
def right() -> list[str]:
    """The twins' hashes."""
    return wanted(KERNELS)


@pytest.mark.parametrize("compiler, flags", BUILDS,
                         ids=[" ".join((name, *flags)) for name, flags in BUILDS])
def test_bits_are_the_twins(compiler: str, flags: tuple[str, ...], right: list[str],
                            tmp_path: Path):
    result = printed(tmp_path, (compiler, *flags), KERNELS)
    assert [line for line, want in zip(result, right, strict=True) if line != want] == []


def printed(folder: Path, command: tuple[str, ...], chosen: tuple[Kernel, ...]) -> list[str]:
    """The output of the program of these kernels, compiled by this command."""
    source, binary = folder / "bits.c", folder / "bits"
    source.write_text(text(chosen))
    run((*command, "-I", INCLUDE, source, "-o", binary, "-lm"))
    return run([binary]).splitlines()


PRAGMA = '#pragma GCC optimize("fp-contract=off", "no-associative-math")'


@pytest.mark.skipif(not FMA, reason="nothing fuses here")
@each_compiler
def test_a_fused_product_would_be_noticed(compiler: str, tmp_path: Path):
    """With products written a * b, and without the pragma, the flags change bits."""
    include = tmp_path / "include"
    shutil.copytree(INCLUDE, include)
    header = include / "ksl" / "ksl_rounding.h"
    plain = header.read_text().replace(PRAGMA, "")
    plain = plain.replace("__builtin_assoc_barrier", "").replace("KSL_HAS_FMA &&", "0 &&")
    header.write_text(plain.replace("KSL_HAS_FMAF &&", "0 &&"))
    result = printed(tmp_path, (compiler, "-I", str(include), "-O3", *FMA, "-ffp-contract=fast"),
                     KERNELS)
    assert result != wanted(KERNELS)
