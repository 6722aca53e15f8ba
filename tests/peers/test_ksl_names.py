"""Every name that KSL's headers declare is here, or stands in one list with its reason.

tests/references/ksl_names.txt lists these names.  A program calls each function and macro with the
types that KSL declares, and runs.
"""

import re
from pathlib import Path

import pytest

from coscrew_codegen.__main__ import main
from coscrew_codegen.backends.c.c_ksl import REFUSED
from tests.support.compiled.c_harness import C11, COMPILERS, DIALECTS, INCLUDE, STRICT, run
from tests.support.compiled.ksl_interface import MACRO, Prototype, names, prototypes

ABSENT = {f"{header}.h": refused.all_names for header, refused in REFUSED.items()}
GUIDE = Path(__file__).parents[2] / "docs" / "from_ksl.md"
REAL = re.compile(r"(?:const )?(int|double|float) (?:\*|\[2\])")


def test_every_name_is_here_or_has_a_reason():
    """A header may declare a name that stands in another one."""
    here = {(p.header, p.name) for p in prototypes()}
    elsewhere = {name for _, name in here}
    for header, declared in names().items():
        for name in declared:
            absent = name in ABSENT.get(header, ())
            assert (header, name) in here or absent or header in ABSENT and name in elsewhere, name


def test_no_name_is_both_here_and_absent():
    absent = [name for group in ABSENT.values() for name in group]
    assert len(absent) == len({*absent}) and not {*absent} & {p.name for p in prototypes()}
    for header, group in ABSENT.items():
        assert {*group} <= {*names()[header]}


def test_other_names_here_are_twins_in_single_precision():
    declared = {name for group in names().values() for name in group}
    for name in {p.name for p in prototypes()} - declared:
        stem = name.replace("f_", "_") if "f_" in name else name.removesuffix("f")
        assert stem in declared or stem.replace("ksl_", "ksl_quaternion_") in declared, name


def test_the_guide_shows_the_list():
    rows = "".join(f"| `{header}.h` | {', '.join(f'`{name}`' for name in refused.names)} | "
                   f"{refused.reason} | {refused.instead.replace(chr(92), '')} |\n"
                   for header, refused in REFUSED.items())
    assert rows in GUIDE.read_text("utf-8")


@pytest.mark.parametrize("header", ABSENT)
def test_a_refused_header_shows_its_names(header):
    text = (INCLUDE / "ksl" / header).read_text("utf-8")
    assert {*re.findall(r"\bksl_\w+", text.split("#error")[0])} == {*ABSENT[header]}


def call(prototype: Prototype) -> str:
    """A C function that calls this one, with zeros, or identities where allocators return them."""
    lines, given = [], []
    for number, kind in enumerate(prototype.passed):
        real, variable = REAL.fullmatch(kind), f"x{number}"
        if kind == "...":
            given.append("NULL")
        elif real or kind.endswith("*"):  # quaternion_squad takes an array of four
            stem = real[1] if real else kind.removeprefix("const ").removesuffix(" *")
            lines.append(f"  {stem} {variable}[16] = {ZERO};")
            given.append(variable)
        else:
            zero = "KSL_AXIS_XYZ" if kind == "ksl_axis_enum_t" else (
                "0" if kind in ("int", "double", "float") else ZERO)
            lines.append(f"  const {kind} {variable} = {zero};")
            given.append(variable)
    calls = [f"{prototype.name}({', '.join(given)})"]
    if prototype.returned == MACRO:  # the last argument, a reference, may be left out
        calls.append(f"{prototype.name}({', '.join((*given, given[-1]))})")
    used = "(void)" if prototype.returned not in ("void", MACRO) else ""
    freed = prototype.returned.endswith("*")
    lines += [f"  free({x});" if freed else f"  {used}{x};" for x in calls]
    return "\n".join((f"static void call_{prototype.name}(void) {{", *lines, "}"))


ZERO = "ZERO"
"""Initialises any union with zeros, in C and in C++."""


@pytest.mark.parametrize("compiler, language", DIALECTS, ids=lambda x: str(x))
def test_every_function_is_called_with_ksls_types(compiler, language, tmp_path):
    """The program links, as C11 and as C++17, with both precisions."""
    every = prototypes()
    headers = "".join(f'#include "ksl/{header}"\n' for header in names() if header not in ABSENT)
    calls = "".join(f"  call_{p.name}();\n" for p in every)
    path = tmp_path / "all.c"
    path.write_text("\n".join((
        headers, "#include <stdio.h>", "#ifdef __cplusplus", "#define ZERO {}", "#else",
        "#define ZERO {0}", "#endif", *map(call, every), f"int main(void) {{\n{calls}",
        f'  puts("{len(every)}");', "  return 0;", "}", "")))
    run((compiler, *language, *STRICT, "-Wno-missing-braces", "-Wno-missing-field-initializers",
         "-I", INCLUDE, path, "-o", tmp_path / "all", "-lm"))
    assert int(run([tmp_path / "all"])) == len(every)


@pytest.mark.parametrize("precision", ["double", "single"])
def test_one_precision_alone_has_nothing_mixed(precision, tmp_path):
    assert main(["generate", "--family", "SE3", "vec3", "--precision", precision, "--language", "c",
                 "-o", str(tmp_path)]) == 0
    path = tmp_path / "user.c"
    path.write_text('#include "ksl/SE3.h"\n#include "ksl/array.h"\n')
    run((COMPILERS[0], *C11, *STRICT, "-Wno-unused-function", "-I", tmp_path / "c" / "include",
         "-fsyntax-only", path))
    text = (tmp_path / "c" / "include" / "ksl" / "SE3.h").read_text("utf-8")
    assert "ksl_SE3_toMat4x4f" not in text
