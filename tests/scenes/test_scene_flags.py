"""Scenes' C gives the bits of their Python package under every flag with which it compiles."""

from pathlib import Path

import pytest

from coscrew_codegen.backends.scene import scene_c_runtime
from tests.support.compiled.c_harness import COMPILERS, run
from tests.support.compiled.flags import FMA, HASWELL, TUNED, UNHEEDED
from tests.support.scenes import scene_bits

FLAGS = {
    "gcc": (("-O0",), ("-O2", *TUNED), ("-O3", "-march=native"), ("-O2", *HASWELL),
            ("-O3", *HASWELL, "-ffp-contract=fast"),
            ("-std=c11", "-O2", *FMA, "-ffp-contract=fast", UNHEEDED),
            ("-x", "c++", "-std=gnu++17", "-O3", "-march=native", "-ffp-contract=fast", UNHEEDED)),
    "clang": (("-O0", *HASWELL, "-ffp-contract=fast"), ("-O1",), ("-O3", "-march=native"),
              ("-O2", *HASWELL), ("-O2", *HASWELL, "-DKSL_CONTRACT_OFF"),
              ("-O2", *FMA, "-ffp-contract=fast"), ("-O3", *TUNED, "-ffp-contract=fast"),
              ("-x", "c++", "-std=c++17", "-O2", *FMA, "-ffp-contract=fast")),
}
BUILDS = tuple((compiler, flags) for compiler in COMPILERS for flags in FLAGS[compiler])


@pytest.fixture(scope="module")
def right(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    """The expected output of the program."""
    return scene_bits.wanted(tmp_path_factory.mktemp("package"))


def printed(folder: Path, *command: str) -> list[str]:
    """The output of the program that this command compiles."""
    run((*command, scene_bits.source(folder), "-o", folder / "bits", "-lm"))
    return run([folder / "bits"]).splitlines()


def test_every_function_and_integrator_is_there(right: list[str]):
    names = {line.split()[0].removeprefix("carrier_") for line in right}
    assert {"step_leapfrog", "step_rk4f", "step_semi_implicit_euler", "step_linear_implicit_eulerf",
            "inverse_dynamics", "forward_dynamicsf", "energy", "free_momentum"} <= names


@pytest.mark.parametrize("compiler, flags", BUILDS,
                         ids=[" ".join((name, *flags)) for name, flags in BUILDS])
def test_bits_are_those_of_the_package(compiler: str, flags: tuple[str, ...], right: list[str],
                                       tmp_path: Path):
    result = printed(tmp_path, compiler, *flags)
    assert [a for a, b in zip(result, right, strict=True) if a != b] == []


# The means against fused products, each with flags under which no other means is effective.
KEEPERS = {
    "gcc's pragma": ("gcc", "#pragma GCC optimize(", "-DKSL_RN(x)=(x)", "-DKSL_RNF(x)=(x)"),
    "clang's pragma": ("clang", "#pragma STDC FP_CONTRACT OFF", "-DKSL_CONTRACT_OFF"),
    "clang's RN": ("clang", "", "-DKSL_CONTRACT_OFF", "-ffp-contract=fast"),
}


@pytest.mark.skipif(not FMA, reason="nothing fuses here")
@pytest.mark.parametrize("keeper", [x for x, (name, *_) in KEEPERS.items() if name in COMPILERS])
def test_a_fused_product_would_be_noticed(keeper: str, right: list[str], tmp_path: Path):
    """Compiled without the means against fused products, the program prints other bits."""
    compiler, pragma, *flags = KEEPERS[keeper]
    source = scene_bits.source(tmp_path)
    runtime = tmp_path / scene_c_runtime.NAME
    text = runtime.read_text()
    assert pragma in text
    runtime.write_text(text.replace(pragma, "//") if pragma else text)
    run((compiler, "-O2", *FMA, *flags, source, "-o", tmp_path / "bits", "-lm"))
    assert run([tmp_path / "bits"]).splitlines() != right
