"""`coscrew generate` after a change: cached results of families equal those derived anew.

`--check` derives everything anew; it must find no difference."""

import pickle
import re
import shutil
import subprocess
import zlib
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from coscrew_codegen.__main__ import main
from coscrew_codegen.family_cache import FamilyCache, made_from
from coscrew_codegen.library import FamilyKernels
from coscrew_codegen.native import cache
from coscrew_codegen.operations import FAMILIES, OPERATIONS, contributors
from tests.support.walks import copied, generated

SOME = ("vec3", "mat6x6", "trig")  # families that are derived quickly
WORDS = ("--family", *SOME, "--output", "out")
ALL = set(SOME)


@pytest.fixture(scope="module")
def filled(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the generator that has derived and cached SOME families."""
    site = copied(tmp_path_factory.mktemp("site")).parent
    assert derived(generated(site, *WORDS)) == ALL
    return site


@pytest.fixture
def site(filled: Path, tmp_path: Path) -> Path:
    """A copy of it, to change."""
    return shutil.copytree(filled, tmp_path / "site")


def derived(done: subprocess.CompletedProcess[str]) -> set[str]:
    """The families that were derived, not found."""
    assert done.returncode == 0, done.stderr
    said = re.fullmatch(r"out: \d+ files, \d+ changed(?:; derived: (.*))?\n", done.stdout)
    assert said, done.stdout
    return set((said[1] or "").split(", ")) - {""}


def assert_true(site: Path) -> None:
    """The files there are those derived anew."""
    done = generated(site, *WORDS, "--check")
    assert done.returncode == 0, done.stdout


def change(path: Path, old: str, new: str) -> None:
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))


def test_what_did_not_change_is_not_made_again(site):
    shutil.rmtree(site / "out")
    assert derived(generated(site, *WORDS)) == set()
    assert_true(site)


@pytest.mark.parametrize("steps", [
    [([("operations/trig.py", "θ in rad", "θ in radians"),
       ("operations/mat6x6.py", "lambda M: M.T", "lambda M: 2 * M.T")], {"trig", "mat6x6"})],
    [([("operations/norm.py", "def safe_norm(", "def another():\n    pass\n\n\ndef safe_norm(")],
      {"vec3", "mat6x6"})],
    [([("targets/c_statements.py", "WIDTH = ", "WIDTH = 4 + ")], ALL),
     ([("templates/c/family.h.jinja", "#include <", "#include  <")], ALL)]])
def test_what_changed_is_made_again_and_nothing_else(site, steps):
    before, changed = contents(site), [x for changes, _ in steps for x in changes]
    for changes, again in steps:
        for source, old, new in changes:
            change(site / "coscrew_codegen" / source, old, new)
        assert derived(generated(site, *WORDS)) == again
    assert_true(site)
    assert (contents(site) == before) == ("norm" in changed[0][0])
    for source, old, new in changed:
        change(site / "coscrew_codegen" / source, new, old)
    assert derived(generated(site, *WORDS)) == set()  # all are kept
    assert contents(site) == before


def contents(site: Path) -> dict[Path, bytes]:
    return {path: path.read_bytes() for path in (site / "out").rglob("*") if path.is_file()}


def test_other_commands_keep_their_own(site):
    """Selections of precision, language and families have entries of their own."""
    words = ("--family", "trig", "--precision", "single", "--language", "c", "--output", "out")
    for again in ({"trig"}, set()):
        assert derived(generated(site, *words)) == again
    done = generated(site, *words, "--check")
    assert done.returncode == 0, done.stdout


@pytest.mark.parametrize("damages", (("truncated", "emptied", "changed"),
                                     ("no pickle", "another's", "a folder")))
def test_damaged_entries_are_made_again(site, damages):
    entries = sorted((site / "cache/coscrew").glob("*.family"))
    for path, damage in zip(entries, damages, strict=True):
        content = path.read_bytes()
        path.unlink()
        bad = {"truncated": content[:len(content) // 2], "emptied": b"", "a folder": None,
               "changed": content[:-1] + bytes([content[-1] ^ 1]), "no pickle": b"no pickle",
               "another's": zlib.compress(pickle.dumps(3))}[damage]
        if damage in ("no pickle", "another's"):  # with a valid hash
            path = path.with_name(f"{path.name.split('-')[0]}-{cache.hashed(bad)}.family")
        path.mkdir() if bad is None else path.write_bytes(bad)
    shutil.rmtree(site / "out")
    assert derived(generated(site, *WORDS)) == ALL
    assert_true(site)
    assert derived(generated(site, *WORDS)) == set()


def test_without_a_folder_to_write_to_nothing_is_kept(site):
    (site / "file").write_text("not a folder\n")
    (site / "tmp").mkdir()
    for _ in range(2):
        assert derived(generated(site, *WORDS, XDG_CACHE_HOME=str(site / "file"),
                                 TMPDIR=str(site / "tmp"))) == ALL
    assert not list((site / "tmp").iterdir())


def test_a_limit_that_is_no_size_is_told_before_anything_is_made(site):
    done = generated(site, *WORDS, COSCREW_CACHE_LIMIT="much")
    assert done.returncode == 2 and "COSCREW_CACHE_LIMIT='much': wanted a size" in done.stderr
    assert generated(site, *WORDS, "--check", COSCREW_CACHE_LIMIT="much").returncode == 0


def test_processes_at_once_make_the_same(site):
    shutil.rmtree(site / "cache")
    with ThreadPoolExecutor() as pool:
        running = [pool.submit(generated, site, *WORDS[:-1], f"out{n}") for n in range(2)]
    assert {x.result().returncode for x in running} == {0}
    assert derived(generated(site, *WORDS)) == set()
    assert_true(site)


def test_a_process_that_knew_older_sources_keeps_nothing(tmp_path, monkeypatch, capsys):
    """This process has imported the operations, which may have changed on disk since."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    for _ in range(2):
        assert main(["generate", "--family", "trig", "--output", str(tmp_path / "out")]) == 0
        assert "derived: trig" in capsys.readouterr().out
    assert not list(tmp_path.rglob("*.family"))


def test_sources_that_change_meanwhile_keep_nothing(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    stands = cache.sources()
    for change, count in (({"codegen/another.py": b""}, 0), ({}, 1)):
        kept = FamilyCache(stands | change, "coscrew generate", lambda words: None)
        assert kept(FamilyKernels("trig", (), ()), made) == "trig"
        kept.save()
        assert len(list(tmp_path.rglob("*.family"))) == count


def made(kernels: FamilyKernels) -> str:
    return kernels.family


def test_a_family_is_made_from_all_that_it_imports():
    """Also imports inside functions, relative ones and indirect ones; but not modules that only
    other families import."""
    sources = {"codegen/kernel.py": b"", "codegen/operations/__init__.py": b"",
               "codegen/operations/vec3.py": b"from coscrew_codegen.operations import a\n",
               "codegen/operations/a.py": b"def f():\n    from .b import x\n",
               "codegen/operations/b.py": b"from . import c\n",
               "codegen/operations/c.py": b"import coscrew_codegen.operations.d\n",
               "codegen/operations/d.py": b"from coscrew_codegen.operations.a import f\n",
               "codegen/operations/SE3.py": b"from coscrew_codegen.quantity import SE3\n",
               "codegen/operations/vec4.py": b""}
    found = made_from("vec3", sources)
    assert sources.keys() - found.keys() == {
        "codegen/operations/SE3.py", "codegen/operations/vec4.py"}


def test_bounds_of_rotations_are_made_from_the_defect_that_they_compare():
    for family, known in (("exponential", True), ("mat3x3", True), ("trig", False)):
        assert ("codegen/operations/nearest.py" in made_from(family, cache.sources())) == known


@pytest.mark.parametrize("family", FAMILIES)
def test_functions_of_a_family_are_of_the_files_it_is_made_from(family):
    """Wherever the code that derives it is defined."""
    found = made_from(family, cache.sources())
    for name in contributors(family):
        assert f"codegen/operations/{name}.py" in found
    for operation in OPERATIONS:
        if operation.family == family:
            for function in (operation.formula, operation.derivation):
                assert all(path in found for path in files_of(function)), operation.name


def files_of(function: Callable | None) -> set[str]:
    """The files of a function of operations/ and of those it calls."""
    waiting, seen, paths = [function], set(), set()
    while waiting:
        one = waiting.pop()
        one = getattr(one, "func", one)  # of a partial
        code = getattr(one, "__code__", None)
        if code is None or code in seen or "/operations/" not in code.co_filename:
            continue
        seen.add(code)
        paths.add(f"codegen/operations/{Path(code.co_filename).name}")
        waiting += [one.__globals__[name] for name in code.co_names if name in one.__globals__]
        waiting += [cell.cell_contents for cell in one.__closure__ or ()]
    return paths
