"""Functions of many elements have the bits of the function of one: in arrays of structs and in
planes, with shared elements, any strides, unaligned pointers, outputs that are inputs; and they
touch nothing else.  `python -m tests.many_attack` compiles all of them in every way."""

import re
from pathlib import Path

import pytest

from coscrew_codegen.accuracy.tiers import TIERS
from tests.support.compiled import all_headers, many_program
from tests.support.compiled.bits_program import Kernel, kernels
from tests.support.compiled.c_harness import COMPILERS, run
from tests.support.compiled.flags import HASWELL, SANITIZERS, has_sanitizers

MARKS = tuple(tier.mark for tier in TIERS)
DECLARED = re.compile(r"^static KSL_INLINED void (ksl_\w+)_(?:many|planes)\(", re.MULTILINE)
VECTORS = ("-O3", *HASWELL, "-ffp-contract=fast")


def some(one_in: int, first: int = 0) -> list[Kernel]:
    """Returns every so-many-th kernel of each tier."""
    return [k for tier in MARKS for k in kernels(tier)[first::one_in]]


def test_bits_are_those_of_one_element(tmp_path: Path):
    """All plain kernels are tested, and some of each tier: one writer writes them all."""
    program = many_program.built(tmp_path, (*kernels(""), *some(20)), False, ("gcc", "-O0"))
    assert run([program]).endswith(" 0 differ\n")


def test_nothing_else_is_touched(tmp_path: Path):
    """Sanitizers stop at the first access outside of operands."""
    compiler = next((x for x in COMPILERS if has_sanitizers(x)), COMPILERS[0])
    program = many_program.built(tmp_path, some(40, 5), False, (compiler, *SANITIZERS))
    assert run([program]).endswith(" 0 differ\n")


@pytest.mark.parametrize("compiler", COMPILERS)
def test_vectors_have_the_same_bits(compiler: str, tmp_path: Path):
    """Under flags that let compilers fuse products."""
    chosen = some(100, 31 * COMPILERS.index(compiler))
    program = many_program.built(tmp_path, chosen, True, (compiler, *VECTORS))
    assert run([program]).endswith(" 0 differ\n")


def test_every_kernel_has_both():
    declared = {}
    for path in sorted((all_headers.include() / "ksl").glob("*_many.h")):
        text = path.read_text(encoding="utf-8")
        declared |= dict.fromkeys(DECLARED.findall(text), path.stem)
        assert len(DECLARED.findall(text)) == 2 * len({*DECLARED.findall(text)})
    assert declared == {k.name: many_program.header(k) for tier in MARKS for k in kernels(tier)}
