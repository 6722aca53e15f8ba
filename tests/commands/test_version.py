"""The version of pyproject.toml is that of both packages, the command and all emitted files."""

import json
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

import coscrew
import coscrew_codegen
from coscrew_codegen.backends.output_files import scene_files
from coscrew_codegen.dynamics import derive
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.compiled import all_headers
from tests.support.scenes import scene_texts as texts

ROOT = Path(__file__).parents[2]
VERSION = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["version"]
MAJOR, MINOR, PATCH = map(int, VERSION.split("."))

HEADS = {suffix: (f"{start} Made by `coscrew generate",
                  f"{start} SPDX-License-Identifier: MIT{end}",
                  f"{start} coscrew {VERSION}.  Copyright (c) 2026 The coscrew authors.{end}")
         for suffixes, start, end in ((".c .h", "/*", " */"), (".py .pyi", "#", ""),
                                     (".md", "<!--", " -->"))
         for suffix in suffixes.split()}


def refuse_other_heads(path: str, text: str) -> None:
    """Every file begins with its command, its license, and the project's name and version."""
    if path.endswith(".json"):  # which has no comments
        text = "\n".join(f"# {line}" for line in json.loads(text)["$comment"].splitlines())
    command, license_, project = text.splitlines()[:3]
    head = HEADS[".py" if path.endswith(".json") else Path(path).suffix]
    assert command.startswith(head[0]) and (license_, project) == head[1:], path


def test_packages_and_command_tell_the_version():
    assert coscrew.__version__ == coscrew_codegen.__version__ == VERSION
    done = subprocess.run([Path(sys.executable).parent / "coscrew", "--version"],
                          capture_output=True, text=True)
    assert (done.returncode, done.stdout, done.stderr) == (0, f"coscrew {VERSION}\n", "")


def test_every_generated_file_has_license_version_and_project():
    files = [path for path in (ROOT / "generated").rglob("*")
             if path.suffix in (*HEADS, ".json") and path.is_file()]
    assert len(files) > 100
    for path in files:
        refuse_other_heads(str(path), path.read_text(encoding="utf-8"))
    others = {path.suffix for path in (ROOT / "generated").rglob("*") if path.is_file()}
    assert others - set(HEADS) <= {".json", ".typed", "", ".so", ".pyc"}


def test_amalgamations_have_them_once():
    for name in all_headers.AMALGAMATIONS:
        path = all_headers.c_folder() / name
        text = path.read_text(encoding="utf-8")
        refuse_other_heads(name, text)
        assert text.count("SPDX") == text.count("Made by") == text.count("Copyright") == 1, path


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    folder = tmp_path_factory.mktemp("scene")
    (folder / "arm6.toml").write_text(texts.SPRING)
    scene = read_scene(folder / "arm6.toml")
    for path, text in scene_files(derive(scene)).items():
        (folder / path).parent.mkdir(exist_ok=True)
        (folder / path).write_text(text, encoding="utf-8")
    return folder


def test_every_file_of_a_scene_has_them(scene):
    files = [*scene.glob("*.[ch]"), *(scene / "arm6").glob("*.py")]
    assert len(files) == 8
    for path in files:
        refuse_other_heads(str(path), path.read_text(encoding="utf-8"))
    assert f'GENERATOR_VERSION = "{VERSION}"' in (scene / "arm6" / "__init__.py").read_text()


@pytest.mark.parametrize("macro, header", [("KSL_VERSION", "ksl/ksl_types.h"),
                                           ("KSL_VERSION", "coscrew.h"),
                                           ("ARM6_GENERATOR_VERSION", "arm6.h")])
def test_the_preprocessor_can_compare_versions(scene, macro, header, tmp_path):
    number = 10000 * MAJOR + 100 * MINOR + PATCH
    program = f"""
#include <stdio.h>
#include "{header}"
#if {macro} < {number} || {macro} > {number}
#error "{macro} is no number of the version"
#endif
#if defined(KSL_VERSION)
#if KSL_VERSION < KSL_VERSION_NUMBER({MAJOR}, {MINOR}, {PATCH}) || \\
    KSL_VERSION >= KSL_VERSION_NUMBER({MAJOR}, {MINOR}, {PATCH + 1}) || \\
    KSL_VERSION_MAJOR != {MAJOR} || KSL_VERSION_MINOR != {MINOR} || KSL_VERSION_PATCH != {PATCH}
#error "KSL_VERSION does not compare"
#endif
#endif
int main(void) {{ puts({macro}_STRING); return 0; }}
"""
    (tmp_path / "main.c").write_text(program)
    generated = ROOT / "generated" / "c"
    done = subprocess.run(["cc", "-std=c11", "-Wall", "-Werror", f"-I{scene}", f"-I{generated}",
                           f"-I{generated / 'include'}", "main.c", "-o", "main", "-lm"],
                          cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert subprocess.check_output([tmp_path / "main"], text=True) == f"{VERSION}\n"
