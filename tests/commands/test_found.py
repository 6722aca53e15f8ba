"""What is added is one file: a tier, a target, put into a copy of the generator; no list has them.

The tier reorders sums; the target writes another language, with a folder of templates."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import coscrew.double
import coscrew_codegen
from coscrew_codegen.formats import DOUBLE
from coscrew_codegen.operations import OPERATIONS
from coscrew_codegen.program.bounds import bounds_of
from tests.support.generator_copy import copied, generated
from tests.support.truth.attack import TIERED, plain_program
from tests.support.walks.pairwise import TIER as PAIRWISE

TABLE = {operation.name: operation for operation in OPERATIONS}
WALKS = Path(__file__).parents[1] / "support" / "walks"
DERIVED = ("vec3", "mat3x3", "coscrew")  # families: to derive everything would take long
FOLDERS = {"effects": "EFFECT", "integrators": "INTEGRATOR", "operations": "FAMILY",
           "tiers": "TIER", "targets": "TARGET"}


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder that holds a copy of the generator."""
    return copied(tmp_path_factory.mktemp("site"))


@pytest.fixture(scope="module")
def made(site: Path) -> Path:
    """The files of the families, with the tier and the target added."""
    shutil.copy(WALKS / "pairwise.py", site / "coscrew_codegen" / "tiers")
    shutil.copy(WALKS / "rust.py", site / "coscrew_codegen" / "targets")
    shutil.copytree(WALKS / "rust", site / "coscrew_codegen" / "templates" / "rust")
    done = generated(site, "--family", *DERIVED, "--output", "out")
    assert done.returncode == 0, done.stderr
    return site / "out"


def test_files_of_what_was_there_do_not_change(site, made):
    """But for none: same paths, same bytes as without the two."""
    done = generated(site, "--family", *DERIVED, "--output", "out", "--check")
    assert done.returncode == 0, done.stdout
    assert (made / "c/include/ksl/coscrew_pairwise.h").is_file()
    plain = subprocess.run([sys.executable, "-m", "coscrew_codegen", "generate", "--family",
                            *DERIVED, "--output", str(site / "without")], capture_output=True)
    assert plain.returncode == 0
    before, after = ({p.relative_to(folder): p.read_bytes() for p in folder.rglob("*.*")
                      if p.is_file()} for folder in (site / "without", made))
    assert before == {path: after[path] for path in before}
    assert {path.parts[0] for path in after.keys() - before.keys()} == {
        "c", "gufunc", "python", "rust"}
    assert all("pairwise" in str(path) or path.parts[0] == "rust"
               for path in after.keys() - before.keys())


def test_the_tier_has_a_header_an_extension_and_a_package(made):
    main = made / "main.c"
    main.write_text("#include <ksl/ksl_pairwise.h>\nint main(void) { return 0; }\n")
    subprocess.run(["gcc", "-std=c11", "-Wall", "-Wextra", "-Werror", "-I", made / "c/include",
                    "-c", main, "-o", made / "main.o"], check=True)
    assert "coscrew.pairwise" in (made / "gufunc/pairwise/module.c").read_text()
    (made / "coscrew").symlink_to(made / "python")
    program = ("import coscrew.pairwise as p, numpy as np; "
               "print(p.dot_vv(np.arange(3.), np.arange(3.)))")
    done = subprocess.run([sys.executable, "-c", program], cwd=made, text=True,
                          capture_output=True, env={**os.environ, "PYTHONPATH": str(made)})
    assert done.stdout == "5.0\n", done.stderr


def test_the_tier_adds_in_another_order():
    """The same polynomials by as many operations.  A sum of four products rounds each term three
    times in a row, in halves twice."""
    constants = {}
    for operation in TIERED:
        plain = plain_program(operation)
        program = PAIRWISE.program(plain, DOUBLE)
        found, before = bounds_of(program), bounds_of(plain)
        assert [x.terms for x in found] == [x.terms for x in before], operation.name
        assert len(program.instructions) == len(plain.instructions)
        constants[operation.name] = tuple(max(x.c1 for x in y) for y in (before, found))
    assert constants["dot_qq"] == constants["product_dd"] == (3, 2)
    assert constants["dot_vv"] == (2, 2)  # of three terms there is no shorter way
    assert sum(after < before for before, after in constants.values()) > 12


def test_the_target_writes_the_same_arithmetic(made):
    """Its statements, read as Python's, give the bits of the kernels in NumPy."""
    numbers, compared = np.random.default_rng(3), 0
    for family in DERIVED:
        text = (made / f"rust/{family}.rs").read_text()
        assert text.startswith("// Made by `coscrew generate --family vec3 mat3x3 coscrew`; ")
        assert text.splitlines()[1] == "// SPDX-License-Identifier: MIT"
        for name, parameters, body, results in re.findall(
                r"pub fn (\w+)\((.*)\) -> .* \{\n((?:    let .*;\n)*)    \[(.*)\]\n\}", text):
            operation = TABLE[name]
            inputs = [numbers.normal(size=a.quantity.shape) for a in operation.inputs]
            assert parameters.count("&[f64; ") == len(inputs)
            scope = {a.name: np.ravel(x).tolist() for a, x in zip(operation.inputs, inputs,
                                                                  strict=True)}
            for line in body.replace("_f64", "").splitlines():
                target, expression = line.removeprefix("    let ").removesuffix(";").split(" = ")
                scope[target] = eval(expression, {}, scope)
            got = [eval(x, {}, scope) for x in results.replace("_f64", "").split(", ")]
            want = getattr(coscrew.double, name)(*inputs)
            want = np.concatenate([np.ravel(x) for x in (
                want if isinstance(want, tuple) else (want,))])
            assert [x.hex() for x in map(float, got)] == [x.hex() for x in want.tolist()], name
            compared += 1
    assert compared > 40


@pytest.mark.parametrize("folder", FOLDERS)
def test_every_file_is_found_or_helps_one_that_is(folder):
    """A file whose author forgot the name it is found by is told here."""
    package = Path(coscrew_codegen.__file__).parent
    texts = {path: path.read_text() for path in package.rglob("*.py")}
    for path in (package / folder).glob("[!_]*.py"):
        module = f"coscrew_codegen.{folder}.{path.stem}"
        imported = re.compile(rf"from {module} import|import {module}\b|"
                              rf"from coscrew_codegen.{folder} import[^)\n]*\b{path.stem}\b")
        assert re.search(rf"^{FOLDERS[folder]}\b", texts[path], re.MULTILINE) or any(
            imported.search(text) for other, text in texts.items() if other != path), (
            f"{folder}/{path.name} calls nothing {FOLDERS[folder]}, and nothing imports it")


@pytest.mark.parametrize(("text", "said"), [
    ("TIER = 'fast'\n", "TIER is str; wanted Tier"),
    ("from coscrew_codegen.tiers.plain import TIER\n",
     "coscrew_codegen.tiers: another.py and plain.py are both called 'plain'")])
def test_a_file_that_cannot_be_added_says_why(site, text, said):
    file = site / "coscrew_codegen" / "tiers" / "another.py"
    file.write_text(text)
    try:
        done = generated(site, "--family", "trig", "--output", "refused")
    finally:
        file.unlink()
    assert done.returncode != 0 and said in done.stderr
    assert not (site / "refused").exists()


FAMILY_FILE = '''"""Areas."""

from coscrew_codegen.operations.family import Family
from coscrew_codegen.operations.operation import Operation
from coscrew_codegen.quantity import ANY, SCALAR, VEC3, Argument

_a, _v = Argument("a", SCALAR), Argument("v", VEC3, ANY)
FAMILY = Family("area", 35, __doc__, (Operation(
    "box_area", "area", "a = 2 (x y + y z + z x)", (_v,), (_a,),
    lambda v: 2 * (v[0] * v[1] + v[1] * v[2] + v[2] * v[0])),), includes=("mat3x3",))
'''


def test_a_family_is_one_file(site):
    """It has headers, modules, and its place in the umbrella header, which its order says."""
    file = site / "coscrew_codegen" / "operations" / "area.py"
    file.write_text(FAMILY_FILE)
    try:
        done = generated(site, "--family", "mat3x3", "area", "SE3", "--output", "areas")
    finally:
        file.unlink()
    assert done.returncode == 0, done.stderr
    header = (site / "areas/c/include/ksl/area.h").read_text()
    assert '#include "mat3x3.h"' in header and "double ksl_box_area(const ksl_vec3_t *v)" in header
    umbrella = (site / "areas/c/include/ksl/ksl.h").read_text()
    assert re.search('"mat3x3.h"\n#include "area.h"\n#include "SE3.h"', umbrella)
    (site / "areas/python").rename(site / "areas/coscrew")
    done = subprocess.run(
        [sys.executable, "-c", "import coscrew; print(coscrew.box_area([1, 2, 3]))"], text=True,
        env={**os.environ, "PYTHONPATH": str(site / "areas")}, capture_output=True)
    assert done.stdout == "22.0\n", done.stderr


def test_two_targets_that_write_one_file_are_refused(site):
    file = site / "coscrew_codegen" / "targets" / "twice.py"
    file.write_text("from coscrew_codegen.targets.c_amalgamated import files\n"
                    "from coscrew_codegen.targets.target import Target\n"
                    "TARGET = Target('twice', ('c',), library=files)\n")
    try:
        done = generated(site, "--family", "trig", "--output", "refused")
    finally:
        file.unlink()
    assert "c/coscrew.h is made by two targets: amalgamated C headers and twice" in done.stderr
    assert done.returncode != 0 and not (site / "refused").exists()
