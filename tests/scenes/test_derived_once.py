"""Derived functions of a scene are cached one by one: other requests for them derive none again."""

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from coscrew_codegen.algebra.recording.recorder import Recorder
from coscrew_codegen.backends.output_files import scene_files
from coscrew_codegen.dynamics import derive
from coscrew_codegen.dynamics.derivation import Derivation
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.runtime.cache import packed
from coscrew_codegen.runtime.request import BOTH, of_scene
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Scene

SCENE = """[bodies.bob]
mass = 0.1
com = [0, 0.01, -0.3]
inertia = [0.02, 0.03, 0.04]
[joints.hinge]
type = "revolute"
child = "bob"
axis = [0, 1, 0]
[effects.gravity]
"""


@pytest.fixture(autouse=True)
def scene(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Scene:
    """A scene, with an empty cache."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    (tmp_path / "swing.toml").write_text(SCENE)
    return read_scene(tmp_path / "swing.toml")


@pytest.fixture
def recorded(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """A list that gets the name of each function that is recorded."""
    names, derived = [], Derivation._derived
    monkeypatch.setattr(Derivation, "_derived", lambda self, entry: (
        names.append(entry.name), derived(self, entry))[1])
    return names


def functions(scene: Scene, *names: str) -> SceneFunctions:
    return of_scene(scene, names, BOTH).functions()


def test_other_requests_derive_only_what_none_has_derived(scene, recorded):
    functions(scene, "energy")
    assert recorded == ["energy"]
    functions(scene, "energy", "inverse_dynamics")
    assert recorded == ["energy", "inverse_dynamics"]
    functions(replace(scene, functions=("inverse_dynamics",), tiers=("accurate",)))
    assert recorded == ["energy", "inverse_dynamics"]


def test_found_functions_are_the_derived_ones(scene):
    """Their files too, and the Programs for twice the digits, which do not count in comparisons."""
    anew, made = derive(scene), functions(scene)
    again = functions(scene)
    assert anew == made == again
    fine = [[f.program.fine for f in x.functions] for x in (anew, again)]
    assert fine[0] == fine[1]
    assert all(f.program is not g.program for f, g in zip(
        made.functions, again.functions, strict=True) if f.name == "forward_dynamics")
    assert scene_files(anew) == scene_files(again)


def test_another_scene_or_cache_has_its_own(scene, recorded, tmp_path, monkeypatch):
    functions(scene, "energy")
    functions(replace(scene, run=replace(scene.run, step=2e-3)), "energy")
    assert recorded == ["energy"] * 2
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "other"))
    functions(scene, "energy")
    assert recorded == ["energy"] * 3


def test_effects_that_are_no_files_are_derived_each_time(scene, recorded):
    """Their names do not identify their equations."""
    (gravity,) = scene.effects
    own = replace(scene, effects=(replace(gravity, effect=replace(gravity.effect)),))
    for _ in range(2):
        functions(own, "energy")
    assert recorded == ["energy"] * 2


def test_damaged_entries_are_derived_again(scene, recorded, tmp_path):
    for damage in (lambda x: x[:-1], lambda x: b"", lambda x: x[:-1] + bytes([x[-1] ^ 1])):
        functions(scene, "energy")
        (entry,) = (tmp_path / "cache" / "coscrew").rglob("*.function")
        entry.write_bytes(damage(entry.read_bytes()))
    functions(scene, "energy")
    assert recorded == ["energy"] * 4


def test_hashes_of_programs_are_those_of_the_process(scene, tmp_path):
    """Texts have other hashes in each process; a hash that was pickled would find no equal
    Program."""
    program = functions(scene, "energy").functions[0].program
    assert {program: 1}  # computes its hash
    (tmp_path / "program").write_bytes(packed(program))
    code = ("import sys; from pathlib import Path\n"
            "from coscrew_codegen.dynamics import derive\n"
            "from coscrew_codegen.runtime.cache import unpacked\n"
            "from coscrew_codegen.scene.readers.toml.toml_scene import read_scene\n"
            "derived = derive(read_scene(sys.argv[1]), ('energy',)).functions[0].program\n"
            "assert unpacked(Path(sys.argv[2]).read_bytes()) in {derived}\n")
    subprocess.run([sys.executable, "-c", code, tmp_path / "swing.toml", tmp_path / "program"],
                   check=True)


def test_a_recording_holds_nothing_when_its_program_is_made(scene, monkeypatch):
    """Frees all instructions at once, whatever refers to the recorder."""
    ended: list[Recorder] = []
    end = Recorder.end
    monkeypatch.setattr(Recorder, "end", lambda self: (ended.append(self), end(self))[1])
    derive(scene, ("forward_dynamics",))
    assert ended and not any(x.issued(0) for x in ended)
