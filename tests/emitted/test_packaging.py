"""The package as users install it: without a compiler, with a stale extension, with its headers."""

import importlib
import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import zipfile
from pathlib import Path

import pytest

import coscrew
from coscrew_codegen.__main__ import main
from coscrew_codegen.runtime.build import extensions

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def without_compiler(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """coscrew from a wheel that was built where no C compiler works."""
    folder = tmp_path_factory.mktemp("wheel")
    wheel = built(project(folder), "--wheel", CC="/bin/false")
    assert wheel.name.endswith("-py3-none-any.whl")
    zipfile.ZipFile(wheel).extractall(folder / "site")
    return folder / "site"


def project(folder: Path) -> Path:
    """A copy of the project's sources, as in a new checkout."""
    for name in ("codegen", "templates", "generated"):
        shutil.copytree(ROOT / name, folder / name,
                        ignore=shutil.ignore_patterns("*.so", "__pycache__"))
    for name in (".gitignore", "pyproject.toml", "hatch_build.py", "README.md", "LICENSE",
                 "CHANGELOG.md"):
        shutil.copy(ROOT / name, folder)
    return folder


def built(folder: Path, kind: str, **environment: str) -> Path:
    """The distribution of this kind, built from the project in the folder."""
    plain = {name: value for name, value in os.environ.items() if name != "CC"}
    done = subprocess.run([sys.executable, "-m", "build", kind, "--no-isolation", "--outdir",
                           "dist"], cwd=folder, text=True, capture_output=True,
                          env={**plain, **environment})
    assert done.returncode == 0, done.stdout + done.stderr
    (distribution,) = (folder / "dist").glob("*.whl" if kind == "--wheel" else "*.tar.gz")
    return distribution


@pytest.mark.parametrize("when", ["", "later"])
def test_an_editable_installation_compiles_unless_that_is_left_for_later(when, monkeypatch):
    monkeypatch.syspath_prepend(ROOT)
    hatch_build, compiled = importlib.import_module("hatch_build"), []
    monkeypatch.setattr(hatch_build, "build_modules", lambda *places: compiled.append(places))
    monkeypatch.setenv("COSCREW_COMPILE", when)
    hatch_build.BuildHook(str(ROOT), {}, None, None, "", "wheel").initialize("editable", {})
    assert compiled == ([] if when else [(ROOT, ROOT / "generated" / "python")])


MODULE = """
#include <Python.h>
static PyModuleDef module = {PyModuleDef_HEAD_INIT, "_gufunc"};
PyMODINIT_FUNC PyInit__gufunc(void) { return PyModule_Create(&module); }
"""


def test_a_wheel_from_a_source_distribution_holds_what_is_compiled(tmp_path, without_compiler):
    """It holds the files of a checkout's wheel; here the modules are small, as theirs take minutes.
    A module of another Python that lies in the checkout is not packed."""
    checkout = project(tmp_path / "checkout")
    foreign = "generated/python/coscrew/_gufunc.cpython-37-x86_64-linux-gnu.so"
    (checkout / foreign).touch()
    with tarfile.open(built(checkout, "--sdist")) as archive:
        archive.extractall(tmp_path, filter="data")
    (unpacked,) = tmp_path.glob("coscrew-*")
    assert not (unpacked / foreign).exists()
    (unpacked / foreign).touch()
    for path in (unpacked / "generated/gufunc").rglob("*.c"):
        path.write_text(MODULE if path.name == "module.c" else "typedef int nothing;\n")
    wheel = built(unpacked, "--wheel")
    tag = f"cp{sys.version_info.major}{sys.version_info.minor}"
    assert f"-{tag}-{tag}-linux" in wheel.name
    packed = {Path(x) for x in zipfile.ZipFile(wheel).namelist() if ".dist-info/" not in x}
    modules = {x for x in packed if x.suffix == ".so"}
    assert {x.parent for x in modules} == {
        Path(*extension.name.split(".")[:-1]) for extension in extensions(ROOT)}
    assert {x.name for x in modules} == {f"_gufunc{sysconfig.get_config_var('EXT_SUFFIX')}"}
    assert packed - modules == {x for x in contents(without_compiler)
                                if ".dist-info" not in x.parts[0]}


def run(program: str, site: Path) -> str:
    """Runs the program, with warnings as errors, and returns its output; with coscrew from `site`
    and the other packages from where they are: without -S, an editable coscrew there would lend its
    extension."""
    path = os.pathsep.join((str(site), sysconfig.get_paths()["purelib"]))
    done = subprocess.run([sys.executable, "-S", "-W", "error", "-c", program], cwd=site, text=True,
                          capture_output=True, env={**os.environ, "PYTHONPATH": path})
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_without_a_compiler_it_runs_in_pure_numpy(without_compiler):
    program = ("import coscrew, coscrew.accurate, numpy as np; print(coscrew.__file__); "
               "print(coscrew.COMPILED, coscrew.product_CoAdc(np.eye(3, 4), range(6)))")
    file, result = run(program, without_compiler).splitlines()
    assert Path(file).is_relative_to(without_compiler)
    assert result == "False [0. 1. 2. 3. 4. 5.]"


def test_a_stale_extension_is_not_used(without_compiler):
    stale = without_compiler / "coscrew" / "_gufunc.py"
    stale.write_text('PROVENANCE = "of other kernels"\n')
    program = ("import warnings\nwith warnings.catch_warnings(record=True) as caught:\n"
               "    warnings.simplefilter('always')\n    import coscrew\n"
               "print(coscrew.COMPILED, caught[0].message)")
    try:
        assert run(program, without_compiler).startswith(
            "False coscrew runs in pure NumPy and not in its compiled extension: it was built from")
    finally:
        stale.unlink()


def test_an_installed_generator_makes_the_same_files(without_compiler, tmp_path, monkeypatch):
    """It has all modules and templates, and finds them."""
    for name, package in (("codegen/coscrew_codegen", ""), ("templates", "templates")):
        installed = contents(without_compiler / "coscrew_codegen" / package)
        assert contents(ROOT / name).items() <= installed.items()
    words = ["generate", "--family", "vec3", "--output", "made"]
    run(f"import sys; from coscrew_codegen.__main__ import main; sys.exit(main({words}))",
        without_compiler)
    monkeypatch.chdir(tmp_path)
    assert main(words) == 0
    assert contents(tmp_path / "made") == contents(without_compiler / "made")
    assert any(x.name == "vec3.h" for x in contents(tmp_path))


def test_extensions_depend_on_every_header_that_they_include():
    """Else they would not be compiled again after its change, nor from a source distribution."""
    for extension in extensions(ROOT):
        left, seen = [ROOT / x for x in extension.sources], set()
        while left:
            file = left.pop()
            if file in seen:
                continue
            seen.add(file)
            names = re.findall(r'^#include "(.+)"', file.read_text("utf-8"), re.MULTILINE)
            left += [(file.parent / name).resolve() for name in names]
        known = {ROOT / x for x in (*extension.sources, *extension.depends)}
        assert seen <= known, (extension.name, sorted(seen - known))


def contents(folder: Path) -> dict[Path, bytes]:
    return {x.relative_to(folder): x.read_bytes() for x in folder.rglob("*")
            if x.is_file() and x.parent.name != "__pycache__"}


def test_the_wheel_holds_the_headers(without_compiler, tmp_path):
    include = run("import coscrew; print(coscrew.get_include())", without_compiler).strip()
    (tmp_path / "main.c").write_text("#include <ksl/ksl.h>\nint main(void) { return 0; }\n")
    subprocess.run(["cc", "-I", include, "main.c", "-o", "main", "-lm"], cwd=tmp_path, check=True)
    assert (Path(include).parent / "coscrew.h").exists()
    assert Path(coscrew.get_include(), "ksl", "coscrew.h").exists()


def test_functions_can_be_pickled_without_a_compiler(without_compiler):
    program = ("import pickle, coscrew, coscrew.accurate; "
               "from coscrew_codegen.algebra.operations import *\n"
               "for op in OPERATIONS:\n"
               "    for module in (coscrew, coscrew.double, coscrew.accurate):\n"
               "        f = getattr(module, op.name, None)\n"
               "        assert f is pickle.loads(pickle.dumps(f)), op.name\nprint('all')")
    assert run(program, without_compiler) == "all\n"


def test_the_wheel_holds_every_template(without_compiler):
    templates = {path.relative_to(ROOT / "templates").as_posix()
                 for path in (ROOT / "templates").rglob("*.*") if path.suffix != ".pyc"}
    installed = without_compiler / "coscrew_codegen" / "templates"
    assert {name for name in templates if not (installed / name).is_file()} == set()
