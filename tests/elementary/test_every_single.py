"""A sample of what `make attack` does on every number of single precision."""

from pathlib import Path

import pytest

from tests.every_single import judged, program
from tests.support.compiled.c_harness import INCLUDE

STRIDE = 1021  # a prime: two million arguments


def test_elementary_functions_are_within_their_errors(tmp_path: Path):
    for found in judged(program(tmp_path), STRIDE):
        assert found.holds, found


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
    found = {x.name: x for x in judged(program(tmp_path, tmp_path), 256 * STRIDE)}
    assert {x.name for x in found.values() if not x.holds} == {name}
