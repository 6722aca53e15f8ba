"""The cache of loaded scenes: an entry is reused if nothing changed; otherwise it is made again."""

import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import coscrew_codegen
from coscrew_codegen import dynamics
from coscrew_codegen.__main__ import main
from coscrew_codegen.runtime import cache, compilation, request, sources
from coscrew_codegen.runtime.load import kernels_for
from coscrew_codegen.runtime.scene_library import key_of
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.walks import copied

ROOT = Path(__file__).parents[2]
TEXT = """functions = ["forward_dynamics", "energy"]
[bodies]
bob = { mass = 2, com = [0, 0, -0.5], inertia = [0.01, 0.01, 0.01] }
[joints.pivot]
type = "revolute"
child = "bob"
axis = [0, 1, 0]
[effects.gravity]
"""
STATE = ([0.3], [0.5])
ENERGY = [0.51 * 0.5**2 / 2, -2 * 9.81 * 0.5 * np.cos(0.3)]


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.delenv(cache.LIMIT, raising=False)
    return tmp_path / "cache" / "coscrew"


@pytest.fixture
def path(tmp_path: Path) -> Path:
    result = tmp_path / "swing.toml"
    result.write_text(TEXT)
    return result


@pytest.fixture(scope="module")
def filled(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, np.ndarray]:
    """A cache that contains the scene, and results of the scene's kernels."""
    base = tmp_path_factory.mktemp("filled")
    (base / "swing.toml").write_text(TEXT)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(base))
        return base / "coscrew", energy(base / "swing.toml")


@pytest.fixture
def derived(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """A list that gets an entry for each derivation."""
    result, derive = [], dynamics.derive
    monkeypatch.setattr(dynamics, "derive", lambda scene, *others: (
        result.append(scene.name), derive(scene, *others))[1])
    return result


def energy(path: Path, **others: object) -> np.ndarray:
    return coscrew_codegen.load_scene(path, **others).double.energy(*STATE)


def test_the_second_time_nothing_is_derived_or_compiled(path: Path, derived: list, monkeypatch):
    first = coscrew_codegen.load_scene(path)
    assert derived == ["swing"]
    monkeypatch.setattr(compilation, "_run", lambda *words: pytest.fail("compiled again"))
    again = coscrew_codegen.load_scene(path)
    assert derived == ["swing"]
    assert np.allclose(again.double.energy(*STATE), ENERGY, rtol=1e-15, atol=0)
    assert again.interface == first.interface and again.compiler == first.compiler
    assert dir(again.single) == dir(first.single) == ["energy", "forward_dynamics"]
    assert again.double.energy.__doc__ == first.double.energy.__doc__
    assert again.functions == first.functions and derived == ["swing"] * 2  # Programs, when asked


def test_a_change_of_the_scene_misses(path: Path, derived: list):
    before = energy(path)
    path.write_text(TEXT.replace("mass = 2", "mass = 4"))
    assert energy(path)[1] == 2 * before[1] and len(derived) == 2
    path.write_text(f"# a comment\n{TEXT}")
    assert (energy(path) == before).all() and len(derived) == 2


def test_functions_precisions_flags_and_compilers_miss(path: Path, derived: list, monkeypatch):
    energy(path)
    energy(path, functions=["energy"])
    energy(path, precision="double")
    kernels_for(read_scene(path), precisions=("double",))
    monkeypatch.setattr(compilation, "_FLAGS", (*compilation._FLAGS, "-DANOTHER"))
    compilation._compiler.cache_clear()
    energy(path)
    other = shutil.which("gcc")
    if other and compilation.compiler().command != ("gcc",):
        monkeypatch.setenv("CC", "gcc")
        energy(path)
    count = len(derived)
    assert count >= 5
    energy(path)
    assert len(derived) == count
    compilation._compiler.cache_clear()


@pytest.fixture
def changed(tmp_path: Path, path: Path, monkeypatch: pytest.MonkeyPatch
            ) -> Callable[[str, str, str], bool]:
    """Returns whether the scene's key changes with a source of the generator, in a copy of it."""
    copy = copied(tmp_path / "copy")
    monkeypatch.setattr(sources, "_folders", lambda: (
        copy, copy / "templates", copy.parent / "coscrew"))
    scene = read_scene(path)

    def key() -> str:
        sources._current.cache_clear()
        return key_of(request.of_scene(scene, (), ("double",)),
                      compilation.Compiler(("cc",), "1", ()))

    def change(source: str, old: str, new: str) -> bool:
        file = copy / source
        text, before = file.read_text(), key()
        assert old in text
        file.write_text(text.replace(old, new, 1))
        after = key()
        file.write_text(text)
        assert key() == before
        return after != before

    yield change
    monkeypatch.undo()
    sources._current.cache_clear()


def test_a_scene_is_derived_again_if_what_it_depends_on_changes(changed):
    """The effects that it has, the mechanics, templates; not by comments, docstrings, effects that
    it does not have, nor by what others print."""
    for source, old, new in (
            ("scene/effects/gravity.py", "EFFECT = ", "X = 1\nEFFECT = "),
            ("dynamics/algorithms/forward.py", "\n\n\ndef ", "\n\n\nX = 1\n\n\ndef "),
            ("algebra/operations/coscrew.py", "FAMILY = ", "X = 1\nFAMILY = "),
            ("runtime/source_text.py", "def in_c", "X = 1\ndef in_c"),
            ("templates/scene/scene.c.jinja", "#undef RN", "#undef  RN"),
            ("templates/runtime/calls/threads.h", "#include <", "#include  <"),
            ("../coscrew/c/coscrew_runtime.h", "#include <", "#include  <"),
            ("templates/runtime/calls/binding.c", "#include <", "#include  <")):
        assert changed(source, old, new), source
    for source, old, new in (
            ("runtime/load.py", "def in_tier_of", "X = 1\n\n\ndef in_tier_of"),
            ("scene/effects/gravity.py", "EFFECT = ", "# A comment.\nEFFECT = "),
            ("scene/effects/gravity.py", '"""', '"""On Earth: '),
            ("dynamics/algorithms/forward.py", '    """', '    """Here: '),
            ("scene/effects/joint_torques/viscous.py", '-(values["d"]', '-(2 * values["d"]'),
            ("reports/cost/figures/cost_page.py", "\n\n\ndef ", "\n\n\nX = 1\n\n\ndef "),
            ("templates/view/page.html.jinja", ": playback", ": play")):
        assert not changed(source, old, new), source


def test_the_hash_of_sources_is_part_of_every_key(path: Path, derived: list, monkeypatch):
    energy(path)
    monkeypatch.setattr(sources, "digest_of", lambda *makers, chosen=None: "another")
    energy(path)
    assert len(derived) == 2


def test_effects_of_one_s_own_are_never_found_by_name(path: Path, derived: list):
    """Their names do not determine their equations."""
    scene = read_scene(path)
    gravity = scene.effects[0]
    own = replace(scene, effects=(replace(gravity, effect=replace(gravity.effect)),))
    for _ in range(2):
        kernels_for(own)
    assert len(derived) == 2


LOADING = """
import os, sys
import coscrew_codegen

for base in sys.argv[2:]:
    os.environ["XDG_CACHE_HOME"] = base
    its = coscrew_codegen.load_scene(sys.argv[1])
    print(its.double.energy([0.3], [0.5]).tolist(), flush=True)
"""
DAMAGES = {"truncated": lambda x: x[:len(x) // 2], "emptied": lambda x: b"",
           "changed": lambda x: x[:-1] + bytes([x[-1] ^ 1]), "another's": lambda x: b"\x80\x04N.",
           "no pickle": lambda x: b"no pickle"}


@pytest.mark.parametrize("suffix", (".scene", ".so"))
def test_damaged_entries_are_made_again(path: Path, filled: tuple, tmp_path: Path, suffix: str):
    """In another process, since a library that this process has loaded stays loaded.  Each damage
    has a cache of its own."""
    whole, result = filled
    bad = {}
    for damage, damaged in DAMAGES.items():
        folder = shutil.copytree(whole, tmp_path / damage / "coscrew")
        entry, = folder.rglob(f"*{suffix}")
        content = damaged(entry.read_bytes())
        entry.unlink()
        if damage in ("another's", "no pickle"):  # with its content's hash: whole, but not ours
            key = entry.name.partition("-")[0]
            entry = entry.parent / f"{key}-{len(content)}-{cache.hashed(content)}{suffix}"
        entry.write_bytes(content)
        bad[damage] = content
    done = subprocess.run([sys.executable, "-W", "error", "-c", LOADING, path,
                           *(tmp_path / damage for damage in bad)],
                          capture_output=True, text=True, cwd=ROOT)
    assert dict(zip(bad, done.stdout.splitlines(), strict=False)) == dict.fromkeys(
        bad, str(result.tolist())), done.stderr
    assert not done.stderr
    for damage, content in bad.items():
        entry, = (tmp_path / damage / "coscrew").rglob(f"*{suffix}")
        assert entry.read_bytes() != content, damage


def test_the_limit_holds_and_what_was_used_last_stays(folder: Path, tmp_path: Path, monkeypatch):
    monkeypatch.setenv(cache.LIMIT, "2.5 kB")
    for number, key in enumerate("ab"):
        cache.write(cache.key_of(key), ".txt", bytes(1000))
        os.utime(cache.entry(cache.key_of(key), ".txt"), (number, number))
    assert cache.entry(cache.key_of("a"), ".txt")  # is now the last one used
    cache.write(cache.key_of("c"), ".txt", bytes(1000))
    assert cache.entry(cache.key_of("b"), ".txt") is None
    assert cache.entry(cache.key_of("a"), ".txt") and cache.entry(cache.key_of("c"), ".txt")
    cache.write(cache.key_of("d"), ".txt", bytes(9000))
    assert [x.size for x in cache.entries()] == [9000]  # the entry just made stays
    left = folder / ".building-left"
    left.mkdir()
    assert len(cache.entries()) == 1  # another process may be making it
    os.utime(left, (0, 0))
    assert len(cache.entries()) == 2  # a day later none is


def test_the_limit_is_a_size(path: Path, monkeypatch, capsys: pytest.CaptureFixture[str]):
    for text, size in (("0", 0), ("12", 12), ("1.5MB", 1_500_000), ("2 gb", 2 * 10**9)):
        monkeypatch.setenv(cache.LIMIT, text)
        assert cache.limit() == size
    monkeypatch.setenv(cache.LIMIT, "much")
    with pytest.raises(cache.CacheError, match="COSCREW_CACHE_LIMIT='much': wanted a size"):
        energy(path)
    assert main(["cache"]) == 2
    assert "coscrew: COSCREW_CACHE_LIMIT='much': wanted" in capsys.readouterr().err


def test_processes_at_once_find_or_make_the_same(path: Path, folder: Path):
    program = ("import coscrew_codegen, sys\n"
               "its = coscrew_codegen.load_scene(sys.argv[1])\n"
               "print(its.double.energy([0.3], [0.5]).tolist())")
    running = [subprocess.Popen([sys.executable, "-W", "error", "-c", program, str(path)],
                                cwd=ROOT, stdout=subprocess.PIPE, text=True) for _ in range(2)]
    message = {x.communicate()[0] for x in running}
    assert len(message) == 1 and message != {""} and {x.returncode for x in running} == {0}
    assert {x.suffix for x in folder.rglob("*.*")} == {".so", ".scene", ".o", ".function"}


def test_of_processes_at_once_one_derives(path: Path):
    """The others wait for its entry."""
    program = ("import coscrew_codegen, sys\n"
               "from coscrew_codegen import dynamics\n"
               "derive = dynamics.derive\n"
               "dynamics.derive = lambda *given: (print('derived'), derive(*given))[1]\n"
               "sys.stdin.read()\n"
               "coscrew_codegen.load_scene(sys.argv[1])")
    running = [subprocess.Popen([sys.executable, "-W", "error", "-c", program, str(path)], cwd=ROOT,
                                stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
               for _ in range(3)]
    for x in running:
        x.stdin.close()  # all have imported what they need
    output = [x.stdout.read() for x in running]
    assert [x.wait() for x in running] == [0, 0, 0] and "".join(output) == "derived\n"


def test_the_command_shows_and_empties(path: Path, folder: Path, capsys):
    assert main(["cache"]) == 0
    assert "entries  0\nsize     0 bytes\nlimit    1 GB" in capsys.readouterr().out
    assert not folder.exists()
    energy(path)
    assert main(["cache"]) == 0
    shown = capsys.readouterr().out
    assert f"folder   {folder}\nentries  6\n" in shown
    assert main(["cache", "--clear"]) == 0
    assert "6 entries" in capsys.readouterr().out
    assert list(folder.rglob("*.*")) == []


def test_a_folder_that_cannot_be_is_empty(path: Path, monkeypatch, capsys):
    monkeypatch.setenv("XDG_CACHE_HOME", str(path))  # a file
    assert main(["cache"]) == 0
    assert "entries  0\n" in capsys.readouterr().out


def test_folders_that_another_user_has_made_are_done_without(path: Path, folder: Path, derived,
                                                             monkeypatch):
    for number in range(256):
        (folder / f"{number:02x}").mkdir(parents=True)
    access = os.access
    monkeypatch.setattr(os, "access", lambda place, mode: place.parent != folder and access(
        place, mode))
    for _ in range(2):
        assert np.allclose(energy(path), ENERGY, rtol=1e-15, atol=0)
    assert derived == ["swing"] and not cache.entries()


def test_files_in_the_place_of_folders_are_done_without(path: Path, folder: Path):
    folder.mkdir(parents=True)
    for number in range(256):
        (folder / f"{number:02x}").touch()
    assert np.allclose(energy(path), ENERGY, rtol=1e-15, atol=0)


def test_entries_that_cannot_be_removed_are_told(path: Path, folder: Path, capsys,
                                                 monkeypatch: pytest.MonkeyPatch):
    def refused(path: Path) -> None:
        raise PermissionError(13, "Permission denied", str(path))

    energy(path)
    monkeypatch.setattr(Path, "unlink", refused)
    assert main(["cache", "--clear"]) == 1
    out, err = capsys.readouterr()
    assert "0 entries, 0 bytes, are gone" in out
    assert err == f"coscrew: 6 entries of {folder} cannot be removed\n"


def test_what_is_found_imports_neither_sympy_nor_scipy(path: Path):
    """Nor the modules that derive, print and plot: importing them takes longer than most runs."""
    program = ("import sys\nfrom coscrew_codegen.__main__ import main\n"
               f"status = main(['simulate', {str(path)!r}, '--until', '0.01', '--output',\n"
               f"               {str(path.with_suffix('.csv'))!r}])\n"
               "heavy = {'sympy', 'scipy', 'matplotlib', 'jinja2', 'coscrew',\n"
               "         'coscrew_codegen.dynamics'}\n"
               "print(status, sorted(heavy & set(sys.modules)))")
    for wanted in (None, "0 []"):
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True,
                              cwd=ROOT, check=True)
        assert wanted in (None, done.stdout.splitlines()[-1])
