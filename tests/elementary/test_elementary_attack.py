"""A sample of `make attack`'s comparisons on every number of single precision, and many of double.
"""

from pathlib import Path

import pytest

from coscrew_codegen.program.values.formats import SINGLE, Precision
from tests.elementary_attack import SINGLES, judged, program
from tests.support.compiled.c_harness import INCLUDE
from tests.support.each import each_precision
from tests.support.truth.wide import IS_WIDE

STRIDE = 1021  # a prime: two million arguments

needs_long_double = pytest.mark.skipif(not IS_WIDE, reason="the judge needs x86's long double")


@needs_long_double
@each_precision
def test_elementary_functions_are_within_their_errors(precision: Precision, tmp_path: Path):
    arguments = (SINGLES, STRIDE) if precision is SINGLE else (2_000_000, 1)
    for result in judged(precision, program(precision, tmp_path), *arguments):
        assert result.holds, result


@needs_long_double
@pytest.mark.parametrize("name, spoiled", [
    ("sin", "x * 1.0000001f"), ("cos", "isnan(x) ? 0.0f : x"), ("exp", "x + 2e-45f"),
    ("tanh", "x + 0.0f")], ids=["errors", "NaN", "subnormal results", "signs of zeros"])
def test_a_spoiled_function_is_seen(name: str, spoiled: str, tmp_path: Path):
    header = tmp_path / "ksl" / "elementary.h"
    header.parent.mkdir()
    header.write_text(
        f'#include "{INCLUDE / "ksl" / "elementary.h"}"\n'
        f"static float result(float x) {{ return {spoiled}; }}\n"
        f"static float spoiled(float x) {{ return result(ksl_{name}f(x)); }}\n"
        f"#define ksl_{name}f spoiled\n")
    result = judged(SINGLE, program(SINGLE, tmp_path, tmp_path), SINGLES, 256 * STRIDE)
    assert {x.name for x in result if not x.holds} == {name}
