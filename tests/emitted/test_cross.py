"""Other processors: the same bits, from every function, with bare -O2, under qemu-user.

Functions that call libm are linked with substitutes, so that they are compared, too.  On a
Cortex-M4F, whose double precision is software, single precision calls none of it.
"""

import re
from collections import Counter
from pathlib import Path

import pytest

from coscrew_codegen.accuracy.tiers import TIERS
from tests.support.compiled import many_program
from tests.support.compiled.bits_program import Kernel, kernels, text, wanted
from tests.support.compiled.c_harness import INCLUDE, in_parallel, run
from tests.support.compiled.cross import COMPILERS, needed
from tests.support.scenes import scene_bits

CORTEX_M4F = ("arm-none-eabi-gcc", "-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard",
              "-mfpu=fpv4-sp-d16", "-O2", "-DKSL_NO_ALLOC")
MARKS = tuple(tier.mark for tier in TIERS)

# Functions that compute in double: software's arithmetic and conversions; <math.h> without f.
DOUBLE = re.compile(r"__aeabi_(d\w+|f2d|[u]?i2d|[u]?l2d)|fma|sqrt|fabs|sin|cos|atan2|pow|exp|tanh")


def chosen(architecture: str, tier: str) -> tuple[Kernel, ...]:
    """Every second one: each runs on two architectures."""
    return kernels(tier)[[*COMPILERS].index(architecture) % 2::2]


def built(folder: Path, architecture: str) -> list[Path]:
    """A program a tier."""
    commands = []
    for tier in MARKS:
        source = folder / f"bits_{tier}.c"
        source.write_text(text(chosen(architecture, tier), planes=False))
        commands.append((COMPILERS[architecture], "-O2", "-static", "-I", INCLUDE, source, "-o",
                         source.with_suffix(""), "-lm"))
    in_parallel(commands)
    return [folder / f"bits_{tier}" for tier in MARKS]


@pytest.fixture(scope="module")
def right() -> dict[str, dict[str, str]]:
    """The twins' lines by tier and kernel."""
    return {tier: dict(zip((k.name for k in kernels(tier)), wanted(kernels(tier), planes=False),
                           strict=True)) for tier in MARKS}


@pytest.mark.parametrize("architecture", COMPILERS)
def test_every_function_has_the_same_bits(architecture: str, right: dict[str, dict[str, str]],
                                          tmp_path: Path):
    needed(COMPILERS[architecture], f"qemu-{architecture}")
    results = [line for binary in built(tmp_path, architecture)
               for line in run((f"qemu-{architecture}", binary)).splitlines()]
    those = [right[tier][k.name] for tier in MARKS for k in chosen(architecture, tier)]
    assert [a for a, b in zip(results, those, strict=True) if a != b] == []


def test_every_function_runs_on_two_architectures():
    for tier in MARKS:
        count = Counter(k.name for x in COMPILERS for k in chosen(x, tier))
        assert {*count} == {k.name for k in kernels(tier)} and min(count.values()) >= 2


@pytest.mark.parametrize("architecture", [x for x in COMPILERS if x != "arm"])
def test_scenes_have_the_same_bits(architecture: str, tmp_path: Path):
    """On processors where compilers fuse products by default."""
    needed(COMPILERS[architecture], f"qemu-{architecture}")
    run((COMPILERS[architecture], "-O2", "-static", scene_bits.source(tmp_path),
         "-o", tmp_path / "bits", "-lm"))
    result = run((f"qemu-{architecture}", tmp_path / "bits")).splitlines()
    right = scene_bits.wanted(tmp_path)
    assert [a for a, b in zip(result, right, strict=True) if a != b] == []


def test_many_elements_have_the_same_bits(tmp_path: Path):
    """NEON's vectors of them; some of each tier."""
    compiler, emulator = COMPILERS["aarch64"], "qemu-aarch64"
    needed(compiler, emulator)
    chosen = [k for tier in MARKS for k in kernels(tier)[17::100]]
    program = many_program.built(tmp_path, chosen, True, (compiler, "-O3", "-static"))
    assert run((emulator, program)).endswith(" 0 differ\n")


def test_floats_computed_in_double_are_refused(tmp_path: Path):
    """Strict C has them on s390x, where 0.1f is 0.1."""
    compiler = COMPILERS["s390x"]
    needed(compiler)
    (tmp_path / "user.c").write_text("#include <ksl/ksl.h>\n")
    command = (compiler, "-std=c11", "-fsyntax-only", "-I", INCLUDE, tmp_path / "user.c")
    with pytest.raises(pytest.fail.Exception, match="-fexcess-precision=fast"):
        run(command)
    run((*command, "-fexcess-precision=fast"))


@pytest.mark.parametrize("tier", ("", "certified"))
def test_single_precision_needs_no_double_on_a_cortex_m4f(tier: str, tmp_path: Path,
                                                          capsys: pytest.CaptureFixture):
    """Its floating-point unit has 32 bits: no call computes in double. Prints the size of the code.
    """
    needed(CORTEX_M4F[0])
    singles = [k for k in kernels(tier) if k.precision.name == "single"]
    calls, size = _called(singles, tmp_path)
    with capsys.disabled():
        print(f"\nCortex-M4F, {tier or 'plain'}, single: {len(singles)} functions, {size} bytes")
    assert not [name for name in calls if DOUBLE.fullmatch(name)]
    assert calls <= {"sqrtf", "fmaf", "memcpy"}, "a function of the C library is called"


def test_double_on_a_cortex_m4f_would_be_noticed(tmp_path: Path):
    needed(CORTEX_M4F[0])
    doubles = [k for k in kernels("") if k.precision.name == "double"]
    calls, _ = _called(doubles[:20], tmp_path)
    assert [name for name in calls if DOUBLE.fullmatch(name)]


def _called(chosen: list[Kernel], folder: Path) -> tuple[set[str], int]:
    """The functions called by an object with all these functions, and its bytes of code."""
    header = f"ksl_{chosen[0].tier}" if chosen[0].tier else "ksl"
    pointers = [f"void (*const pointer_{n})(void) = (void (*)(void)){k.name};"
                for n, k in enumerate(chosen)]
    source = folder / "all.c"
    source.write_text("\n".join([f"#include <ksl/{header}.h>", *pointers, ""]))
    run((*CORTEX_M4F, "-I", INCLUDE, "-c", source, "-o", folder / "all.o"))
    symbols = run(("arm-none-eabi-nm", folder / "all.o")).splitlines()
    sizes = run(("arm-none-eabi-size", folder / "all.o")).splitlines()[1].split()
    return {line.split()[-1] for line in symbols if " U " in line}, int(sizes[0])
