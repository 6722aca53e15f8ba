"""An addition is one file or one entry, and is in no list: CONTRIBUTING.md's examples, in copies of
the generator.

The tier reorders sums; the target writes another language, with a folder of templates."""

import os
import re
import shutil
import subprocess
import sys
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import numpy as np
import pytest

import coscrew.double
import coscrew_codegen
from coscrew_codegen.accuracy.bounds import bounds_of
from coscrew_codegen.algebra.operations import OPERATIONS
from coscrew_codegen.program.values.formats import DOUBLE
from tests.support.truth.attack import TIERED, plain_program
from tests.support.walks import command, copied, generated, walk

ROOT = Path(__file__).parents[2]
TABLE = {operation.name: operation for operation in OPERATIONS}
DERIVED = ("vec3", "mat3x3", "coscrew")  # families; deriving all would take long
FOLDERS = {"scene.effects": "EFFECT", "scene.integrators": "INTEGRATOR",
           "scene.functions": "FUNCTION", "algebra.operations": "FAMILY",
           "scene.readers": "READER", "accuracy.tiers": "TIER", "backends": "TARGET"}


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder that holds a copy of the generator and of its templates."""
    folder = tmp_path_factory.mktemp("site")
    copied(folder)
    return folder


@pytest.fixture(scope="module")
def made(site: Path) -> Path:
    """The files of the families, with the tier and the target added."""
    walk(site / "coscrew_codegen", "pairwise", "rust", "family")
    done = generated(site, "--family", *DERIVED, "--output", "out")
    assert done.returncode == 0, done.stderr
    return site / "out"


def test_files_of_what_was_there_do_not_change(site, made):
    """Same paths and same bytes as without the two."""
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
    program = ("import coscrew.pairwise as p, numpy as np; "
               "print(p.dot_vv(np.arange(3.), np.arange(3.)))")
    done = subprocess.run([sys.executable, "-c", program], cwd=made / "python", text=True,
                          capture_output=True)
    assert done.stdout == "5.0\n", done.stderr


def test_the_tier_adds_in_another_order(made, site):
    """Polynomials and numbers of operations stay; for sums of four products the constant of the
    bound falls from 3 to 2."""
    spec = spec_from_file_location("pairwise", site / "coscrew_codegen/accuracy/tiers/pairwise.py")
    pairwise = module_from_spec(spec)
    spec.loader.exec_module(pairwise)
    constants = {}
    for operation in TIERED:
        plain = plain_program(operation)
        program = pairwise.TIER.program(plain, DOUBLE)
        result, before = bounds_of(program), bounds_of(plain)
        assert [x.terms for x in result] == [x.terms for x in before], operation.name
        assert len(program.instructions) == len(plain.instructions)
        constants[operation.name] = tuple(max(x.c1 for x in y) for y in (before, result))
    assert constants["dot_qq"] == constants["product_dd"] == (3, 2)
    assert constants["dot_vv"] == (2, 2)  # of three terms there is no shorter way
    assert sum(after < before for before, after in constants.values()) > 12


def test_the_target_writes_the_same_arithmetic(made):
    """Its statements, run as Python, give the bits of the NumPy kernels."""
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


def run_in(site: Path, program: str) -> str:
    """Runs a program in a folder with a package coscrew; returns its output."""
    done = subprocess.run([sys.executable, "-c", program], cwd=site, text=True,
                          capture_output=True, env={**os.environ, "PYTHONPATH": str(site)})
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_an_operation_is_one_entry(tmp_path):
    """v - 2 (n·v) n of integers, which needs no rounding: in every tier, precision and language."""
    walk(copied(tmp_path), "vec3")
    done = generated(tmp_path, "--family", "vec3", "--output", "out")
    assert done.returncode == 0, done.stderr
    shutil.copytree(tmp_path / "out/python/coscrew", tmp_path / "coscrew", dirs_exist_ok=True)
    assert run_in(tmp_path, (
        "import numpy as np, coscrew, coscrew.accurate, coscrew.certified\n"
        "n, v = [1, 2, 2], [3, 5, 7]\n"
        "for tier in (coscrew, coscrew.accurate, coscrew.certified):\n"
        "    for dtype in (np.float64, np.float32):\n"
        "        x = tier.vec3_reflected(np.array(n, dtype), np.array(v, dtype))\n"
        "        x = x[0] if isinstance(x, tuple) else x\n"
        "        assert x.dtype == dtype and x.tolist() == [-51, -103, -101], (tier, dtype, x)\n"
        "print(coscrew.vec3_reflected.__doc__)")).find("vo = v - 2 (n·v) n") >= 0
    (tmp_path / "main.c").write_text(
        "#include <ksl/ksl.h>\n#include <ksl/ksl_accurate.h>\n"
        "int main(void) {\n"
        "  const ksl_vec3_t n = ksl_vec3(1, 2, 2), v = ksl_vec3(3, 5, 7);\n"
        "  const ksl_vec3f_t m = ksl_vec3f(1, 2, 2), w = ksl_vec3f(3, 5, 7);\n"
        "  ksl_vec3_t x, y;\n  ksl_vec3f_t z;\n"
        "  ksl_vec3_reflected(&n, &v, &x);\n  ksl_vec3_reflected_accurate(&n, &v, &y);\n"
        "  ksl_vec3f_reflected(&m, &w, &z);\n"
        "  return x.x != -51 || x.y != -103 || y.z != -101 || z.z != -101;\n}\n")
    subprocess.run(["gcc", "-std=c11", "-Wall", "-Wextra", "-Werror", "-I", "out/c/include",
                    "main.c", "-o", "main", "-lm"], cwd=tmp_path, check=True)
    subprocess.run([tmp_path / "main"], check=True)


def test_a_family_is_one_file(tmp_path):
    """It has headers and modules, and a place in the umbrella header by its `order`."""
    walk(copied(tmp_path), "area")
    done = generated(tmp_path, "--family", "mat3x3", "area", "SE3", "--output", "out")
    assert done.returncode == 0, done.stderr
    header = (tmp_path / "out/c/include/ksl/area.h").read_text()
    assert '#include "mat3x3.h"' in header and "double ksl_area_box(const ksl_vec3_t *v)" in header
    umbrella = (tmp_path / "out/c/include/ksl/ksl.h").read_text()
    assert '"mat3x3.h"\n#include "area.h"\n#include "SE3.h"' in umbrella
    shutil.copytree(tmp_path / "out/python/coscrew", tmp_path / "coscrew", dirs_exist_ok=True)
    assert run_in(tmp_path, "import coscrew; print(coscrew.area_box([1, 2, 3]))") == "22.0\n"


def test_an_effect_is_one_file(tmp_path):
    """At rest, without gravity, the effect's torque is the pull's, to the bit; energy is balanced,
    also in steps that are implicit in its slope."""
    walk(copied(tmp_path), "cogging")
    (tmp_path / "rotor.toml").write_text(
        "[bodies]\nrotor = { mass = 1, inertia = [1, 1, 1] }\n[joints]\n"
        'pin = { type = "continuous", child = "rotor", axis = [0, 0, 1] }\n'
        "[effects.cogging.pin]\na = 0.5\nn = 3\n[run]\nduration = 1\n[start.q]\npin = 1\n")
    done = generated(tmp_path, "rotor.toml", "-o", "out")
    assert done.returncode == 0, done.stderr
    run_in(tmp_path / "out", (
        "import coscrew, numpy as np, rotor.double as rotor\n"
        "for q in np.linspace(-4, 4, 50):\n"
        "    tau, = rotor.inverse_dynamics([q], [0.0], [0.0])\n"
        "    assert float(tau).hex() == float(0.5 * coscrew.sin(3 * q)).hex(), q\n"))
    for words in (["check", "rotor.toml"], ["effects"]):
        done = command(tmp_path, *words)
        assert done.returncode == 0, done.stdout + done.stderr
    assert "cogging" in done.stdout and "tau = -a sin(n q)" in done.stdout


def test_tests_name_the_entries_that_an_effect_lacks(tmp_path):
    walk(copied(tmp_path), "cogging")
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "--stale-extensions",
         *(f"tests/scenes/test_{x}.py" for x in ("absence", "effect_values", "slopes", "schema")),
         "-k", "every_effect or command_prints"], cwd=ROOT, text=True, capture_output=True,
        env={**os.environ, "PYTHONPATH": str(tmp_path)})
    for words in ("add cogging to PLACES in tests/support/scenes/effect_scenes.py",
                  "add cogging to ZEROS in tests/scenes/test_absence.py", "add cogging to TRUE",
                  "add cogging to CASES in tests/scenes/test_effect_values.py",
                  "BOUNDED (bounds of them) or FRICTION in tests/scenes/test_slopes.py",
                  "generated/docs/scene.schema.json is out of date: make generate"):
        assert words in done.stdout, done.stdout


@pytest.mark.parametrize("folder", FOLDERS)
def test_every_file_is_found_or_helps_one_that_is(folder):
    """A file without the name by which it is found is reported here."""
    package = Path(coscrew_codegen.__file__).parent
    texts = {path: path.read_text() for path in package.rglob("*.py")}
    for path in (package / folder.replace(".", "/")).rglob("[!_]*.py"):
        *above, name = path.relative_to(package.parent).with_suffix("").parts
        inside = ".".join(above)
        imported = re.compile(rf"from {inside}.{name} import|import {inside}.{name}\b|"
                              rf"from {inside} import(?: \([^)]*|[^)\n]*)\b{name}\b")
        assert re.search(rf"^{FOLDERS[folder]}\b", texts[path], re.MULTILINE) or any(
            imported.search(text) for other, text in texts.items() if other != path), (
            f"{folder}/{path.name} calls nothing {FOLDERS[folder]}, and nothing imports it")


@pytest.mark.parametrize(("text", "message"), [
    ("TIER = 'fast'\n", "TIER is str; wanted Tier"),
    ("from coscrew_codegen.accuracy.tiers.plain import TIER\n",
     "coscrew_codegen.accuracy.tiers: another.py and plain.py are both called 'plain'")])
def test_a_file_that_cannot_be_added_says_why(site, text, message):
    file = site / "coscrew_codegen/accuracy/tiers/another.py"
    file.write_text(text)
    try:
        done = generated(site, "--family", "trig", "--output", "refused")
    finally:
        file.unlink()
    assert done.returncode != 0 and message in done.stderr
    assert not (site / "refused").exists()


def test_two_targets_that_write_one_file_are_refused(site):
    file = site / "coscrew_codegen/backends/twice.py"
    file.write_text("from coscrew_codegen.backends.c.c_amalgamated import files\n"
                    "from coscrew_codegen.backends.target import Target\n"
                    "TARGET = Target('twice', ('c',), library=lambda library: {\n"
                    "    name: f'{text}\\n' for name, text in files(library).items()})\n")
    try:
        done = generated(site, "--family", "trig", "--output", "refused")
    finally:
        file.unlink()
    assert "c/coscrew.h is made by two targets: amalgamated C headers and twice" in done.stderr
    assert done.returncode != 0 and not (site / "refused").exists()


def test_helpers_of_targets_are_not_imported():
    code = ("import sys; from coscrew_codegen.backends import targets; print(len(targets()), "
            "'coscrew_codegen.backends.html.plots' in sys.modules)")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    count, imported = done.stdout.split()
    assert int(count) >= 10 and imported == "False"
