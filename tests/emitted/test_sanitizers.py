"""Every function of the headers stays inside its objects, and may be given aliased arguments."""

import re
from pathlib import Path

import pytest

from coscrew_codegen.accuracy.tiers import TIERS
from coscrew_codegen.backends.c.c_ksl import MARK
from coscrew_codegen.program.values.formats import DOUBLE, PRECISIONS, SINGLE, Precision
from tests.support.compiled import c_calls
from tests.support.compiled.c_harness import C11, COMPILERS, EXACT, INCLUDE, run
from tests.support.compiled.flags import SANITIZERS, has_sanitizers

HELPERS = {f"ksl_{name}{f}" for name in ("power", "two_over_pi") for f in ("", "f")}
"""What elementary functions call."""
DEFINED = re.compile(r"^static (?:inline|KSL_INLINE) [^(]*?\*?(ksl_\w+)\(", re.MULTILINE)


TIER_NAMES = tuple(tier.mark for tier in TIERS)

# Also optimised without sanitizers, where a compiler makes use of its assumptions about aliases: in
# functions that are not inlined, it does not see which arguments are.
BUILDS = (*((name, SANITIZERS) for name in COMPILERS if has_sanitizers(name)),
          *((name, ("-O2", "-fno-inline")) for name in COMPILERS))

# One printer writes all kernels and both precisions: in either precision those of each tier are
# built with the sanitizers of one compiler and optimised by the other.
SANITIZED, OPTIMISED = BUILDS[:len(BUILDS) - len(COMPILERS)], BUILDS[-len(COMPILERS):]
RUNS = tuple((precision, tier, *build) for tier in TIER_NAMES for precision, builds in (
    (DOUBLE, (*SANITIZED[:1], *OPTIMISED[-1:])), (SINGLE, (*SANITIZED[-1:], *OPTIMISED[:1])))
    for build in builds)


@pytest.mark.parametrize("precision, tier, compiler, flags", RUNS, ids=lambda x: (
    x.name if isinstance(x, Precision) else x or "plain" if isinstance(x, str)
    else x[0].strip("-")))
def test_aliased_arguments_give_the_same_bits(precision: Precision, tier: str, compiler: str,
                                              flags: tuple[str, ...], tmp_path: Path):
    """The sanitizers stop at the first access outside an object and at undefined behaviour."""
    source, binary = tmp_path / "calls.c", tmp_path / "calls"
    source.write_text(c_calls.program(precision, tier))
    run((compiler, *C11, *flags, EXACT, "-I", INCLUDE, source, "-o", binary, "-lm"))
    assert run([binary]) == ""


def test_every_function_is_called():
    others = re.compile("_(exactf?|elementary_error|rounding|selfcheck|states)$")
    defined = {name for header in sorted((INCLUDE / "ksl").glob("*.h"))
               if not others.search(header.stem)
               for name in DEFINED.findall(header.read_text(encoding="utf-8").partition(MARK)[0])}
    text = "".join(c_calls.program(p, tier) for p in PRECISIONS for tier in TIER_NAMES)
    called = set(re.findall(r"\b(ksl_\w+)\(", text))
    assert HELPERS < defined <= called | HELPERS, sorted(defined - called - HELPERS)
