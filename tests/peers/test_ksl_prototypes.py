"""Every function of KSL (Kinematics Subroutine Library) is here, with its parameters, in its order.

tests/references/ksl_prototypes.txt holds the prototypes of KSL's headers, shortened.  C compilers
compare them with ours; programs written for KSL include the headers as "ksl/X.h", in any order.
"""

import random
import re

import pytest

from coscrew_codegen.backends.c.c_ksl import REFUSED
from tests.support.compiled.c_harness import C11, COMPILERS, CXX17, DIALECTS, INCLUDE, STRICT, run
from tests.support.compiled.ksl_interface import MACRO, Prototype, prototypes
from tests.support.each import each_compiler

HEADERS = tuple(dict.fromkeys(p.header for p in prototypes()))

# Pairs that these functions only read are pairs of const here; callers are not affected.
TO_CONST = ("ksl_quaternion_product_q", "ksl_product_q")


def source(wanted: tuple[Prototype, ...], includes: tuple[str, ...]) -> str:
    """C source: for each function a pointer of KSL's type, set to ours."""
    lines = [f'#include "ksl/{header}"' for header in includes]
    for prototype in (p for p in wanted if p.returned != MACRO):
        pointer = prototype.pointer
        if prototype.name.startswith(TO_CONST):
            pointer = re.sub(r"\b(double|float) \[2\]", r"const \1 [2]", pointer)
        lines += [f"extern {pointer};", f"{pointer} = {prototype.name};"]
    return "\n".join([*lines, ""])


@each_compiler
@pytest.mark.parametrize("header", HEADERS)
def test_prototypes_are_ksls(header, compiler, tmp_path):
    """Each header alone declares what KSL's declares."""
    wanted = tuple(p for p in prototypes() if p.header == header)
    path = tmp_path / "prototypes.c"
    path.write_text(source(wanted, (header,)))
    run((compiler, *C11, *STRICT, "-Wno-unused-function", "-I", INCLUDE, "-c", path,
         "-o", tmp_path / "prototypes.o"))


@pytest.mark.parametrize("seed", range(4))
def test_headers_go_in_any_order(seed, tmp_path):
    order = random.Random(seed).sample(HEADERS, len(HEADERS))
    compiler, language = DIALECTS[seed % len(DIALECTS)]
    path = tmp_path / "ordered.c"
    path.write_text("\n".join([*(f'#include "ksl/{header}"' for header in order),
                               "int main(void) { return 0; }", ""]))
    run((compiler, *language, *STRICT, "-I", INCLUDE, "-fsyntax-only", path))


def test_another_prototype_is_noticed(tmp_path):
    one = next(p for p in prototypes() if p.name == "ksl_product_ddr")
    turned = Prototype(one.header, one.name, one.returned, one.passed[1::-1] + one.passed[2:])
    path = tmp_path / "wrong.c"
    path.write_text(source((turned,), ("ksl.h",)))
    with pytest.raises(pytest.fail.Exception, match="incompatible"):
        run((COMPILERS[0], *C11, *STRICT, "-I", INCLUDE, "-fsyntax-only", path))


@each_compiler
@pytest.mark.parametrize("language", [C11, CXX17], ids=["C", "C++"])
@pytest.mark.parametrize("header", sorted(REFUSED))
def test_headers_that_are_not_here_say_what_to_do(header, language, compiler, tmp_path):
    path = tmp_path / "user.c"
    path.write_text(f'#include "ksl/{header}.h"\n')
    with pytest.raises(pytest.fail.Exception, match=f"ksl/{header}.h is not here: .*[a-z]"):
        run((compiler, *language, "-I", INCLUDE, "-fsyntax-only", path))
