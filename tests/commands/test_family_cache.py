"""`coscrew generate` after a change: cached results of families equal those derived anew.

`--check` derives everything anew; it must find no difference."""

import pickle
import re
import shutil
import subprocess
import zlib
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from itertools import cycle
from pathlib import Path

import pytest

from coscrew_codegen.__main__ import main
from coscrew_codegen.algebra import operations
from coscrew_codegen.algebra.operations import FAMILIES, OPERATIONS, contributors
from coscrew_codegen.backends.library import FamilyKernels
from coscrew_codegen.runtime import cache, sources
from coscrew_codegen.runtime.family_cache import FamilyCache, makers, modules
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
    output = re.fullmatch(r"out: \d+ files, \d+ changed(?:; derived: (.*))?\n", done.stdout)
    assert output, done.stdout
    return set((output[1] or "").split(", ")) - {""}


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


def test_anew_derives_all_whatever_is_kept(site):
    assert derived(generated(site, *WORDS, "--anew")) == ALL
    assert derived(generated(site, *WORDS)) == set()


@pytest.mark.parametrize("source, old, new", [
    ("algebra/operations/trig.py", "\nFAMILY =", "\n# A comment.\nFAMILY ="),
    ("algebra/operations/formulas/norm.py", '"""The ', '"""Of vectors: the '),
    ("backends/c/c_statements.py", "WIDTH = ", "# A comment.\nWIDTH = "),
    ("scene/effects/joint_torques/viscous.py",
     '-(values["d"] * state.v)', '-(2 * values["d"] * state.v)'),
    ("scene/effects/gravity.py", '"""', "# A comment.\n" + '"""'),
    ("reports/cost/figures/cost_page.py", "\n\n\ndef", "\n\n\nEXTRA = 1\n\n\ndef")])
def test_comments_docstrings_and_what_is_not_imported_cost_nothing(site, source, old, new):
    """A change of an effect, too: nothing of a family depends on it."""
    before = contents(site)
    change(site / "coscrew_codegen" / source, old, new)
    assert derived(generated(site, *WORDS)) == set()
    assert contents(site) == before


@pytest.mark.parametrize("steps", [
    [([("algebra/operations/trig.py", "θ in rad", "θ in radians"),
       ("algebra/operations/mat6x6.py", "lambda M: M.T", "lambda M: 2 * M.T")],
      {"trig", "mat6x6"})],
    [([("algebra/operations/formulas/linear_formulas.py", "def linear_space(",
        "def another():\n    pass\n\n\ndef linear_space(")],
      {"vec3", "mat6x6"})],
    [([("backends/c/c_statements.py", "WIDTH = ", "WIDTH = 4 + ")], ALL),
     ([("templates/c/family.h.jinja", "#include <", "#include  <")], ALL)]])
def test_what_changed_is_made_again_and_nothing_else(site, steps):
    before, changed = contents(site), [x for changes, _ in steps for x in changes]
    for changes, again in steps:
        for source, old, new in changes:
            change(site / "coscrew_codegen" / source, old, new)
        assert derived(generated(site, *WORDS)) == again
    assert_true(site)
    assert (contents(site) == before) == ("linear" in changed[0][0])
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
    entries = sorted((site / "cache/coscrew").rglob("*.family"))
    assert len(entries) > len(damages)
    for path, damage in zip(entries, cycle(damages), strict=False):
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
    stands = sources.read()
    for change, count in (({"coscrew_codegen.another": b""}, 0), ({}, 1)):
        kept = FamilyCache(stands | change, "coscrew generate", lambda words: None)
        assert kept(FamilyKernels("trig", (), ()), made) == "trig"
        kept.save()
        assert len(list(tmp_path.rglob("*.family"))) == count


def made(kernels: FamilyKernels) -> str:
    return kernels.family


made.__module__ = "coscrew_codegen.backends.requirements"  # a module of the generator


def test_bounds_of_rotations_are_made_from_the_defect_that_they_compare():
    for family, known in (("exponential", True), ("mat3x3", True), ("trig", False)):
        assert ("formulas.nearest" in made_from(family)) == known


def made_from(family: str) -> set[str]:
    """The modules of operations that count for a family."""
    package = operations.__name__
    reached = sources.Sources.of(sources.read()).reached(
        makers(made), {package: modules(family)})
    return {x.removeprefix(f"{package}.") for x in reached if x.startswith(f"{package}.")}


@pytest.mark.parametrize("family", FAMILIES)
def test_functions_of_a_family_are_of_the_files_it_is_made_from(family):
    """Wherever the code that derives it is defined."""
    result = made_from(family)
    for name in contributors(family):
        assert name in result
    for operation in OPERATIONS:
        if operation.family == family:
            for function in (operation.formula, operation.derivation):
                assert all(path in result for path in files_of(function)), operation.name


def files_of(function: Callable | None) -> set[str]:
    """The names of the files of a function of operations/ and of those it calls."""
    waiting, seen, paths = [function], set(), set()
    while waiting:
        one = waiting.pop()
        one = getattr(one, "func", one)  # of a partial
        code = getattr(one, "__code__", None)
        if code is None or code in seen or "/operations/" not in code.co_filename:
            continue
        seen.add(code)
        inner = Path(code.co_filename).with_suffix("").as_posix().rpartition("/operations/")[2]
        paths.add(inner.replace("/", "."))
        waiting += [one.__globals__[name] for name in code.co_names if name in one.__globals__]
        waiting += [cell.cell_contents for cell in one.__closure__ or ()]
    return paths
