"""Scenes' C compiles without a warning everywhere, and stays within its arrays and its precision.
"""

import re
from pathlib import Path

import pytest

from coscrew_codegen.backends import emit
from coscrew_codegen.backends.python_extension import scene_calls
from coscrew_codegen.backends.scene import scene_c_parts
from coscrew_codegen.backends.scene.scene_text import c_name, count
from coscrew_codegen.program.scene_functions import Signature
from coscrew_codegen.program.values.formats import DOUBLE, PRECISIONS, SINGLE, Precision
from tests.support.compiled.c_harness import C11, COMPILERS, DIALECTS, EXACT, STRICT, run
from tests.support.compiled.flags import SANITIZERS, X86, has_sanitizers
from tests.support.each import each_compiler, each_precision
from tests.support.scenes.generated_scenes import CASES, written

# x86 instructions that compute in double precision, or leave single precision
DOUBLE_ARITHMETIC = re.compile(
    r"\bv?(?:add|sub|mul|div|sqrt|min|max|u?comi|cmp\w*|hadd|hsub|addsub|round|f\w+)[sp]d\b"
    r"|\bv?cvt\w*[sp]d\w*\b|\bf(?:ld|st|add|mul|sub|div)\w*\b")
MATHEMATICS = ("fabs", "sqrt", "copysign")


@pytest.fixture(params=(*CASES, "spinner in parts"))
def case(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch):
    """The functions of one case."""
    name, _, cut = request.param.partition(" ")
    if cut:
        monkeypatch.setattr(scene_c_parts, "LONG", 0)
        monkeypatch.setattr(scene_c_parts, "LONGEST", 9)
    return CASES[name]()


@pytest.mark.parametrize("level", ("-O0", "-O3"))
@pytest.mark.parametrize("compiler, language", DIALECTS, ids=lambda x: "".join(x).replace("-", ""))
def test_all_files_compile_without_a_warning(case, compiler: str, language: tuple[str, ...],
                                              level: str, tmp_path: Path):
    written(case, tmp_path)
    (tmp_path / "alone.c").write_text(f'#include "{case.name}.h"\n#include "{case.name}.h"\n')
    for source in (f"{case.name}.c", f"{case.name}f.c", "alone.c"):
        run([compiler, *language, *STRICT, level, "-c", tmp_path / source, "-o", tmp_path / "x.o"])


@each_compiler
def test_what_python_calls_compiles_without_a_warning(case, compiler: str, tmp_path: Path):
    written(case, tmp_path)
    made = scene_calls.files(case, "")
    emit.write(made, tmp_path)
    run([compiler, *C11, *STRICT, "-O2", "-fPIC",
         "-c", tmp_path / next(iter(made)), "-o", tmp_path / "x.o"])


@pytest.mark.skipif(COMPILERS[0] != "gcc", reason="these are flags of gcc's")
@pytest.mark.parametrize("flag", (
    "-ffast-math", "-freciprocal-math", "-fno-signed-zeros", "-ffinite-math-only",
    "-funsafe-math-optimizations", "-fsingle-precision-constant",
    pytest.param("-mfpmath=387", marks=pytest.mark.skipif(not X86, reason="a flag of x86's"))))
def test_fast_math_is_refused_unless_allowed(flag: str, tmp_path: Path):
    written(CASES["slider"](), tmp_path)
    for source in ("slider.c", "sliderf.c"):
        command = [COMPILERS[0], *C11, flag, "-c", tmp_path / source, "-o", tmp_path / "x.o"]
        with pytest.raises(pytest.fail.Exception, match="COSCREW_ALLOW_FAST_MATH"):
            run(command)
        run([*command, "-DCOSCREW_ALLOW_FAST_MATH"])


@each_compiler
def test_a_double_of_32_bits_is_refused_except_in_single_precision(compiler: str, tmp_path: Path):
    """AVR is such a processor: its float.h says that a double has 24 digits."""
    written(CASES["slider"](), tmp_path)
    command = [compiler, *C11, "-Wno-builtin-macro-redefined", "-D__DBL_MANT_DIG__=24",
               "-o", tmp_path / "x.o", "-c"]
    run([*command, tmp_path / "sliderf.c"])
    with pytest.raises(pytest.fail.Exception, match=r"sliderf\.c has the same functions"):
        run([*command, tmp_path / "slider.c"])


@each_precision
@each_compiler
def test_objects_hold_no_state_and_call_only_mathematics(case, compiler: str, precision: Precision,
                                                         tmp_path: Path):
    symbols = [line.split() for line in run(["nm", _object(case, compiler, precision, tmp_path)])
               .splitlines()]
    called = {fields[-1] for fields in symbols if fields[-2] == "U"}
    allowed = {f"{name}{precision.suffix}" for name in MATHEMATICS} | {"memcpy"}
    allowed |= {"_GLOBAL_OFFSET_TABLE_", "__stack_chk_fail"}
    assert called <= allowed
    assert not [fields for fields in symbols if fields[-2].upper() in "BDC"]


@pytest.mark.skipif(not X86, reason="knows the instructions of x86-64; "
                                     "-Wdouble-promotion looks everywhere")
@each_compiler
def test_single_precision_holds_no_operation_in_double(case, compiler: str, tmp_path: Path):
    results = {p: _double_operations(_object(case, compiler, p, tmp_path)) for p in PRECISIONS}
    assert not results[SINGLE]
    assert results[DOUBLE]  # so that the test can see them


def _object(case, compiler: str, precision: Precision, folder: Path) -> Path:
    """The object file of one precision."""
    written(case, folder)
    path = folder / f"{precision.name}.o"
    run([compiler, *C11, "-O2", "-c", folder / f"{case.name}{precision.suffix}.c", "-o", path])
    return path


def _double_operations(path: Path) -> list[str]:
    lines = run(["objdump", "-d", "--no-show-raw-insn", path]).splitlines()
    return [line for line in lines if DOUBLE_ARITHMETIC.search(line.partition("\t")[2])]


BUILDS = (*((name, SANITIZERS) for name in COMPILERS if has_sanitizers(name)),
          *((name, ("-O3",)) for name in COMPILERS))


@each_precision
@pytest.mark.parametrize("compiler, flags", BUILDS, ids=lambda x: x if isinstance(x, str) else x[0])
def test_outputs_may_overlap_inputs(case, compiler: str, flags: tuple[str, ...],
                                    precision: Precision, tmp_path: Path):
    """Wherever an output begins within an input, the results are those of separate arrays."""
    written(case, tmp_path)
    source, binary = tmp_path / "overlaps.c", tmp_path / "overlaps"
    source.write_text(_overlaps(case, precision))
    run([compiler, *C11, *flags, EXACT, source,
         tmp_path / f"{case.name}{precision.suffix}.c", "-o", binary, "-lm"])
    checked = run([binary])
    assert int(checked) > 0


def test_all_functions_are_called_with_overlaps(case):
    text = _overlaps(case, SINGLE)
    for function in scene_calls.callables(case):
        assert f"{c_name(case, function.name, SINGLE)}(" in text


def _overlaps(case, precision: Precision) -> str:
    """A program that prints how many overlaps were compared, and stops at the first difference."""
    blocks = [_calls(case, x, precision) for x in scene_calls.callables(case)]
    return "\n".join((
        "#include <stdio.h>", "#include <stdlib.h>", "#include <string.h>",
        f'#include "{case.name}.h"', f"typedef {precision.c_type} real;",
        "static real *block(int n, int seed) {",
        "  real *x = malloc(sizeof(real) * (size_t)n);",
        "  for (int i = 0; i < n; i++) x[i] = (real)((seed * 7 + i * 3) % 11 - 4) / (real)8;",
        "  return x;", "}", "int main(void) {", "  int checked = 0;", *blocks,
        '  printf("%d\\n", checked);', "  return 0;", "}", ""))


def _calls(case, function: Signature, precision: Precision) -> str:
    name = c_name(case, function.name, precision)
    if function.moved:
        arguments = ", ".join(f"{x}" if shape else "(real)0.125" for x, shape in function.inputs)
        lines = [f"real *{x} = block({count(shape)}, {n});"
                 for n, (x, shape) in enumerate(function.inputs) if shape]
        lines += [f"{name}({arguments});", "checked++;"]
        return "  {\n" + "\n".join(f"    {line}" for line in (
            *lines, *(f"free({x});" for x, shape in function.inputs if shape))) + "\n  }"
    results = []
    for into, (_, shape) in enumerate(function.inputs):
        for output in range(len(function.outputs)):
            if shape:
                results += [_overlap(name, function, into, output, shift) for shift in (-1, 0, 1)]
    return "\n".join(results)


def _overlap(name: str, function: Signature, into: int, output: int, shift: int) -> str:
    """One call with separate arrays, and one with an output that begins `shift` numbers after an
    input."""
    inputs, outputs = function.inputs, function.outputs
    n, m = count(inputs[into][1]), count(outputs[output][1])
    room, start = max(n, m) + 1, max(0, -shift)
    lines = [f"real *i{k} = block({count(shape)}, {k});" for k, (_, shape) in enumerate(inputs)]
    lines += [f"real *o{k} = block({count(shape)}, 0);" for k, (_, shape) in enumerate(outputs)]
    given = [f"i{k}" if shape else f"*i{k}" for k, (_, shape) in enumerate(inputs)]
    made = [f"o{k}" for k in range(len(outputs))]
    lines += [f"{name}({', '.join((*given, *made))});", f"real *both = block({room}, 0);",
              f"memcpy(both + {start}, i{into}, sizeof(real) * {n});",
              f"real *kept = block({m}, 0);", f"memcpy(kept, o{output}, sizeof(real) * {m});"]
    given[into], made[output] = f"both + {start}", f"both + {start + shift}"
    lines += [f"{name}({', '.join((*given, *made))});",
              f"if (memcmp(both + {start + shift}, kept, sizeof(real) * {m})) "
              f'{{ printf("{name}: output {output} over input {into} at {shift}\\n"); return 1; }}',
              "checked++;", "free(both);", "free(kept);"]
    lines += [f"free({letter}{k});" for letter, side in (("i", inputs), ("o", outputs))
              for k in range(len(side))]
    return "  {\n" + "\n".join(f"    {line}" for line in lines) + "\n  }"


def test_each_precision_has_a_file(tmp_path: Path):
    for precision in PRECISIONS:
        path = _object(CASES["pendulum"](), COMPILERS[0], precision, tmp_path)
        names = re.findall(r" T (\w+)", run(["nm", path]))
        assert names and all(x.endswith("f") == bool(precision.suffix) for x in names)
