"""A build that breaks the promised bits says so."""

from pathlib import Path

import pytest

import coscrew
from tests.support.compiled.c_harness import C11, COMPILERS, EXACT, INCLUDE, run
from tests.support.compiled.flags import X86
from tests.support.each import each_compiler

PROGRAM = """
#include <ksl/ksl.h>
#include <stdio.h>
int main(void) {
  const char *d = ksl_selfcheck(), *f = ksl_selfcheckf();
  printf("%s\\n%s\\n", d ? d : "fine", f ? f : "fine");
  return 0;
}
"""



def verdicts(folder: Path, compiler: str, *flags: str, text: str = PROGRAM) -> list[str]:
    """The verdicts on double and single precision: the first word of the fault, or fine."""
    source = folder / "main.c"
    source.write_text(text)
    run((compiler, *C11, *flags, "-I", INCLUDE, source, "-o", folder / "main", "-lm"))
    return [line.split(":")[0] for line in run([folder / "main"]).splitlines()]


@each_compiler
@pytest.mark.parametrize("flags", [("-O0",), ("-O2",), ("-O3", "-march=native")])
def test_a_right_build_is_fine(compiler, flags, tmp_path):
    assert verdicts(tmp_path, compiler, *flags, EXACT) == ["fine", "fine"]


@each_compiler
def test_contraction_is_detected(compiler, tmp_path):
    flags = ("-std=gnu11", "-O3", "-march=native", "-ffp-contract=fast")
    macros = run((compiler, "-march=native", "-dM", "-E", "-x", "c", "/dev/null"))
    fused = "__FMA__" in macros or "__ARM_FEATURE_FMA" in macros
    assert verdicts(tmp_path, compiler, *flags) == ["fine", "fine"]
    messages = "-DKSL_CONTRACT_OFF"  # wrongly; for clang alone
    word = "contraction" if fused and compiler == "clang" else "fine"
    assert verdicts(tmp_path, compiler, *flags, messages) == [word, word]


@each_compiler
def test_fast_math_is_detected(compiler, tmp_path):
    flags = ("-O2", "-ffast-math", "-DKSL_ALLOW_FAST_MATH")
    assert "fine" not in verdicts(tmp_path, compiler, *flags)


@pytest.mark.skipif("clang" not in COMPILERS, reason="these are flags of clang's")
@pytest.mark.parametrize("flag, word", [
    ("-fassociative-math -fno-signed-zeros", "reassociation"),
    ("-freciprocal-math", "reciprocals"), ("-fno-signed-zeros", "signed zeros"),
    ("-fno-honor-nans", "finite math"), ("-fno-honor-infinities", "finite math"),
    ("-fapprox-func", "approximate functions"), ("-funsafe-math-optimizations", "reassociation")])
def test_what_has_no_macro_is_detected(flag, word, tmp_path):
    assert verdicts(tmp_path, "clang", "-O2", *flag.split()) == [word, word]


@pytest.mark.skipif(not X86, reason="sets x86's MXCSR")
@pytest.mark.parametrize("bits", ["0x8000", "0x40"], ids=["results", "operands"])
@each_compiler
def test_flush_to_zero_is_detected(compiler, bits, tmp_path):
    """Flushing of results and of operands is detected: any linked library can set either."""
    start = f"int main(void) {{ _mm_setcsr(_mm_getcsr() | {bits});"
    text = "#include <xmmintrin.h>" + PROGRAM.replace("int main(void) {", start)
    assert verdicts(tmp_path, compiler, "-O2", text=text) == ["flush-to-zero"] * 2


@pytest.mark.skipif(not X86, reason="the x87 is x86's")
@pytest.mark.skipif("gcc" not in COMPILERS, reason="this is a flag of gcc's")
def test_excess_precision_is_detected(tmp_path):
    """On x86 gcc can compute on the x87: it rounds to 64 bits, and to the type when it stores.  For
    sums and products of floats the second rounding changes nothing."""
    flags = ("-O2", "-mfpmath=387", EXACT, "-DKSL_ALLOW_FAST_MATH")
    assert verdicts(tmp_path, "gcc", *flags) == ["excess precision", "fine"]


def test_this_installation_is_fine():
    assert coscrew.selfcheck() == []


def test_wrong_kernels_are_detected(monkeypatch):
    monkeypatch.setattr(coscrew, "axpy_cc", lambda a, x, y: x * 0 + 1e-30)
    monkeypatch.setattr(coscrew, "product_ac", lambda a, x: x * 0)
    monkeypatch.setattr(coscrew, "product_CoAdc", coscrew.product_CoAdinvc)
    words = [problem.split()[0] for problem in coscrew.selfcheck()]
    assert words == ["contraction:", "flush-to-zero:", "product_CoAdc"] * 2
