"""The headers compile in any order, as C11 and C++17, without a warning; single is single."""

import platform
import re
import subprocess
import sys
from itertools import permutations, product
from pathlib import Path

import pytest

from coscrew_codegen.backends.c.c_ksl import REFUSED
from tests.support.compiled import all_headers
from tests.support.compiled.c_harness import (
    C11,
    C_FOLDER,
    COMPILERS,
    DIALECTS,
    EXACT,
    INCLUDE,
    STRICT,
    run,
)
from tests.support.each import each_compiler

CHECK = (*STRICT, EXACT, "-fsyntax-only")

# With this definition every function is compiled, called or not; system headers come first.
_USED = """\
#include <math.h>
#include <stdlib.h>
#include <string.h>
#define inline __attribute__((used))
"""
ALL_FUNCTIONS, OF_VEC3 = (_USED + "".join(f"#include <ksl/{name}.h>\n" for name in names)
                          for names in (("ksl", "ksl_certified"), ("vec3",)))
DOUBLE_INSTRUCTION = re.compile(r"v?((add|sub|mul|div|sqrt|min|max|round|hadd|hsub|addsub|u?comi|"
                                r"cmp\w*|fn?m(add|sub)\w*)[sp]d|cvt\w*[sp]d\w*)")
DOUBLE_SYMBOLS = {"sin", "cos", "sincos", "sqrt", "fabs", "fmin", "fmax", "fma"}
DOUBLE_TEXT = re.compile(r"\bdouble\b|(?<![\w.])(\d+\.\d*(e[-+]?\d+)?|\d+e[-+]?\d+)(?![\w.])|"
                         rf"\b({'|'.join(sorted(DOUBLE_SYMBOLS))})\(")

ON_ROTATED_BODY = """\
#include <coscrew.h>

/* A body turned by a quarter about z and shifted by (1, 2, 3). */
int main(void) {
  ksl_SE3f_t D = {{{0, 1, 0, -1, 0, 0, 0, 0, 1, 1, 2, 3}}};
  const ksl_coscrewf_t c = ksl_coscrewf(1, 2, 3, 4, 5, 6);
  const ksl_coscrewf_t moved = ksl_coscrewf(-2, 1, 3, -2, -5, 11);
  ksl_coscrewf_t co;
  ksl_product_CoAdcf(&D, &c, &co);
  return memcmp(&co, &moved, sizeof co) != 0;
}
"""

dialects = pytest.mark.parametrize("compiler, language", DIALECTS,
                                   ids=[f"{name} {flags[-1]}" for name, flags in DIALECTS])
# Of C and of C++ one: what a header includes is the same to every compiler.  C++'s own library is
# left out: its <math.h> includes half of it, which takes long and hides what a header lacks.
first_and_last = pytest.mark.parametrize("compiler, language", (
    DIALECTS[0], (DIALECTS[-1][0], (*DIALECTS[-1][1], "-nostdinc++"))), ids=("C", "C++"))


@pytest.fixture(scope="module")
def single_only(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The headers generated for single precision alone."""
    return _generated(tmp_path_factory.mktemp("single"), "--precision", "single")


def _generated(folder: Path, *options: str) -> Path:
    run((sys.executable, "-m", "coscrew_codegen", "generate", *options, "--language", "c",
         "--output", folder))
    return folder / "c"


def _source(folder: Path, name: str, *lines: str) -> Path:
    path = folder / f"{name}.c"
    path.write_text("\n".join([*lines, ""]))
    return path


def _headers() -> list[str]:
    """All, also those of many elements."""
    return sorted({x.stem for x in (all_headers.include() / "ksl").glob("*.h")} - {*REFUSED})


def _included(header: str) -> str:
    return {"amalgamation": f'#include "{C_FOLDER / "coscrew.h"}"',
            "headers": "#include <ksl/ksl.h>"}.get(header, f"#include <{header}.h>")


@first_and_last
def test_any_header_may_come_first_and_alone(compiler, language, tmp_path):
    sources = [_source(tmp_path, name, _included(f"ksl/{name}"), "typedef int something;")
               for name in _headers()]
    run((compiler, *language, *CHECK, "-I", all_headers.include(), *sources))


def test_headers_are_found_without_their_folder(tmp_path):
    sources = [_source(tmp_path, name, _included(name)) for name in _headers()]
    run((COMPILERS[0], *C11, "-M", "-I", all_headers.include() / "ksl", *sources))


@dialects
@pytest.mark.parametrize("order", [("amalgamation",), *permutations(("amalgamation", "headers"))],
                         ids=" then ".join)
def test_amalgamation_goes_alone_and_beside_the_headers(order, compiler, language, tmp_path):
    source = _source(tmp_path, "user", *map(_included, order),
                     "double power(const ksl_coscrew_t *c, const ksl_screw_t *s);",
                     "double power(const ksl_coscrew_t *c, const ksl_screw_t *s) {",
                     "  return ksl_dot_cs(c, s);", "}")
    run((compiler, *language, *CHECK, "-I", INCLUDE, source))


@dialects
@pytest.mark.parametrize("header", ["headers", "amalgamation"])
def test_two_translation_units_link(header, compiler, language, tmp_path):
    turn = "void turn(const ksl_SE3_t *D, ksl_coscrew_t *c)"
    one = _source(tmp_path, "one", _included(header), f"{turn};", f"{turn} {{",
                  "  ksl_product_CoAdc(D, c, c);", "}")
    two = _source(tmp_path, "two", _included(header), f"{turn};", "int main(void) {",
                  "  const ksl_SE3_t D = ksl_SE3(0, -1, 0, 1, 1, 0, 0, 2, 0, 0, 1, 3);",
                  "  const ksl_coscrew_t moved = ksl_coscrew(-2, 1, 3, -2, -5, 11);",
                  "  ksl_coscrew_t c = ksl_coscrew(1, 2, 3, 4, 5, 6);", "  turn(&D, &c);",
                  "  ksl_subtract_cc(&c, &moved, &c);", "  return ksl_coscrew_norm(&c) > 0;", "}")
    main = tmp_path / "main"
    run((compiler, *language, *STRICT, EXACT, "-I", INCLUDE, one, two, "-o", main, "-lm"))
    run([main])


@each_compiler
@pytest.mark.parametrize("header", ["headers", "amalgamation"])
def test_no_alloc_leaves_out_the_heap(header, compiler, tmp_path):
    source = _source(tmp_path, "user", _included(header))
    preprocess = (compiler, *C11, "-E", "-I", INCLUDE, source)
    heap = re.compile(r"calloc|stdlib\.h|_alloc\(")
    assert heap.search(run(preprocess))
    assert not heap.search(run((*preprocess, "-DKSL_NO_ALLOC")))
    run((compiler, *C11, *CHECK, "-DKSL_NO_ALLOC", "-I", INCLUDE, source))


FAST_MATH = ("-ffast-math", "-Ofast", "-freciprocal-math", "-ffinite-math-only",
             "-fno-signed-zeros", "-mfpmath=387", "-funsafe-math-optimizations",
             "-fsingle-precision-constant")
# ksl_selfcheck detects flags of clang without a macro.
FAST_MATH_OF = {compiler: FAST_MATH if compiler in ("gcc", "g++") else
                ("-ffast-math", "-Ofast", "-ffinite-math-only") for compiler, _ in DIALECTS}
any_header = pytest.mark.parametrize("header", ["ksl/vec3", "amalgamation"])


@dialects
@any_header
def test_fast_math_is_refused(header, compiler, language, tmp_path):
    source = _source(tmp_path, "user", _included(header))
    dialects = {tuple(x) for x in (language, [word.replace("=c", "=gnu") for word in language],
                                   [re.sub(r"=c\+\+\d+", "=c++98", word) for word in language])}
    for flag, dialect in product(FAST_MATH_OF[compiler], sorted(dialects)):
        refused = subprocess.run((compiler, flag, *dialect, "-fsyntax-only", "-Wfatal-errors",
                                  "-I", INCLUDE, source), capture_output=True, text=True)
        assert refused.returncode and "KSL_ALLOW_FAST_MATH" in refused.stderr, (flag, dialect)


@dialects
@any_header
def test_fast_math_may_be_allowed(header, compiler, language, tmp_path):
    """All at once: the flags define what each of them defines."""
    source = _source(tmp_path, "user", _included(header))
    run((compiler, *language, *FAST_MATH_OF[compiler], "-fsyntax-only", "-DKSL_ALLOW_FAST_MATH",
         "-I", INCLUDE, source))


PREDICATES = """\
#include <coscrew.h>

int main(void) {
  const ksl_mat3x3_t R = ksl_mat3x3(0, -1, 0, 1, 0, 0, 0, 0, 1);
  const ksl_mat3x3_t M = ksl_mat3x3(1, 0, 0, 0, 1, 0, 0, 0, -1);
  const ksl_mat3x3f_t A = ksl_mat3x3f(2, 0, 0, 0, 3, 0, 0, 0, 4);
  const ksl_quaternion_t q = ksl_quaternion(0, 0.6, 0, 0.8);
  const ksl_quaternionf_t p = ksl_quaternionf(0, 3, 0, 4), none = ksl_quaternionf(0, 0, 0, 0);
  ksl_mat3x3f_t nearest;
  ksl_quaternionf_t unit;
  ksl_mat3x3f_nearest_rotation(&A, &nearest);
  ksl_quaternionf_nearest_unit(&p, &unit);
  return !(ksl_mat3x3_is_rotation(&R) && !ksl_mat3x3_is_rotation(&M) && ksl_quaternion_is_unit(&q)
      && ksl_mat3x3_rotation_defect(&M) == 2 && !ksl_mat3x3f_is_rotation(&A)
      && ksl_mat3x3f_is_rotation(&nearest) && nearest.m00 == 1 && nearest.m11 == 1
      && !ksl_quaternionf_is_unit(&p) && !ksl_quaternionf_is_unit(&none)
      && ksl_quaternionf_unit_defect(&p) == 4 && ksl_quaternionf_unit_defect(&none) == -1
      && ksl_quaternionf_is_unit(&unit));
}
"""


@dialects
def test_predicates_of_rotations(compiler, language, tmp_path):
    source = _source(tmp_path, "user", PREDICATES)
    run((compiler, *language, *STRICT, EXACT, "-I", INCLUDE.parent, source,
         "-o", tmp_path / "user", "-lm"))
    run([tmp_path / "user"])


SHORT_DOUBLE = ("-Wno-builtin-macro-redefined", "-D__DBL_MANT_DIG__=24")  # as on AVR


@each_compiler
@pytest.mark.parametrize("header", ["ksl/vec3", "coscrew", "coscrew_accurate",
                                    "coscrew_certified"])
def test_a_double_of_32_bits_is_refused(header, compiler, tmp_path):
    source = _source(tmp_path, "user", f'#include "{header}.h"')
    command = (compiler, *C11, "-fsyntax-only", "-I", INCLUDE, "-I", all_headers.c_folder(), source)
    run(command)
    refused = subprocess.run((*command, *SHORT_DOUBLE), capture_output=True, text=True)
    assert refused.returncode and "--precision single" in refused.stderr


def _object(compiler: str, include: Path, folder: Path, text: str = ALL_FUNCTIONS) -> Path:
    """All functions of these headers, compiled as written: nothing is folded or left out."""
    source = _source(folder, "all", text)
    run((compiler, *C11, "-O0", EXACT, "-I", include, "-c", source, "-o", folder / "all.o"))
    return folder / "all.o"


def _double_instructions(binary: Path) -> list[str]:
    disassembly = run(("objdump", "-d", "--no-show-raw-insn", binary))
    return [" ".join(words[1:]) for words in map(str.split, disassembly.splitlines())
            if len(words) > 1 and DOUBLE_INSTRUCTION.fullmatch(words[1])]


@each_compiler
def test_single_precision_executes_no_double_arithmetic(compiler, single_only, tmp_path):
    binary = _object(compiler, single_only / "include", tmp_path)
    symbols = {line.split()[-1].lstrip("_") for line in run(("nm", "-u", binary)).splitlines()}
    assert "sqrtf" in symbols and not symbols & DOUBLE_SYMBOLS
    if platform.machine() in ("x86_64", "AMD64"):
        assert not _double_instructions(binary)


@each_compiler
def test_double_arithmetic_would_be_noticed(compiler, tmp_path):
    """Any header of both precisions contains what those of single precision must not."""
    binary = _object(compiler, INCLUDE, tmp_path, OF_VEC3)
    symbols = {line.split()[-1].lstrip("_") for line in run(("nm", "-u", binary)).splitlines()}
    assert symbols & DOUBLE_SYMBOLS
    assert platform.machine() not in ("x86_64", "AMD64") or _double_instructions(binary)
    assert DOUBLE_TEXT.search(_code(C_FOLDER))


def test_single_precision_says_no_double(single_only):
    """No double type, literal or function, in the text itself."""
    assert not (match := DOUBLE_TEXT.search(_code(single_only))), match


def _code(folder: Path) -> str:
    """All headers in this folder, without comments and messages."""
    text = "".join(path.read_text(encoding="utf-8") for path in sorted(folder.rglob("*.h"))
                   if not re.search(r"accurate|exact\b", path.name))  # single computed in double
    return re.sub(r'/\*.*?\*/|#error "[^"]*"', "", text, flags=re.DOTALL)


@pytest.fixture(scope="module")
def selection(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """One family in one precision."""
    return _generated(tmp_path_factory.mktemp("selection"), "--family", "coscrew",
                      "--precision", "single")


def test_a_family_with_predicates_compiles_alone(tmp_path):
    folder = _generated(tmp_path / "out", "--family", "quaternion", "--precision", "single")
    source = _source(tmp_path, "user", "#include <coscrew.h>\n")
    run(("gcc", *C11, *STRICT, EXACT, "-I", folder, "-c", source, "-o", tmp_path / "x.o"))


@each_compiler
def test_a_selection_compiles_and_runs(compiler, selection, tmp_path):
    """From its folder of headers and from its amalgamation."""
    source = _source(tmp_path, "user", ON_ROTATED_BODY)
    for include in (selection, selection / "include" / "ksl"):
        run((compiler, *C11, *STRICT, EXACT, "-I", include, source, "-o", tmp_path / "main", "-lm"))
        run([tmp_path / "main"])
