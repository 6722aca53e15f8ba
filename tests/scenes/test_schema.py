"""The JSON Schema accepts all files that the reader accepts, and refuses unknown keys, types and
words."""

import copy
import json
import re
import tomllib
from collections.abc import Iterator
from pathlib import Path

import jsonschema
import pytest

from coscrew_codegen.__main__ import main
from coscrew_codegen.scene.effect import Place
from coscrew_codegen.scene.effects import EFFECTS
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.keys import TABLES
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene

ROOT = Path(__file__).parents[2]
SCENES = sorted((ROOT / "examples/scenes").glob("*.toml"))
SCHEMA = json.loads((ROOT / "generated/docs/scene.schema.json").read_text(encoding="utf-8"))
OUTDATED = "generated/docs/scene.schema.json is out of date: make generate"

FULL = """
name = "full"
base = "fixed"
precision = "both"
implausible = "error"
falling = "warn"
functions = ["default"]
tiers = ["plain", "accurate"]
runtime = ["b.mass"]
[bodies.a]
mass = 1
com = [0, 0, "1/3"]
inertia = [0.01, 0.01, 0.01]
[bodies.b]
mass = 0.5
com = [0, 0, 0.1]
inertia = [0.01, 0.01, 0.01, 0, 0, 0]
[bodies.c]
mass = 0.5
inertia = [[0.01, 0, 0], [0, 0.01, 0], [0, 0, 0.01]]
[bodies.d]
mass = 0.1
inertia = [0.01, 0.01, 0.01]
[attach.load]
to = "c"
place = { xyz = [0, 0, 0.1], rpy = [0, 0, 1] }
mass = 0.1
com = [0, 0, 0.01]
shape = { box = [0.1, 0.1, 0.2] }
[attach.can]
to = "load"
mass = 0.1
shape = { cylinder = { radius = 0.1, length = 0.2 } }
[attach.ball]
to = "load"
mass = 0.1
shape = { sphere = 0.1 }
[frames.tip]
to = "can"
xyz = [0, 0, 0.1]
quaternion = [0, 0, 0, 1]
[joints.one]
type = "revolute"
parent = "world"
child = "a"
axis = [0, 1, 0]
origin = { xyz = [0, 0, 1], rpy = [0, "pi/2", 0] }
limits = { lower = -1, upper = 1, effort = 2, velocity = 3 }
damping = 0.1
friction = 0.2
[joints.two]
type = "continuous"
parent = "a"
child = "b"
axis = [1, 0, 0]
origin = { quaternion = [0, 0, 0, 1] }
mimic = { joint = "one", multiplier = 2, offset = 0.1 }
[joints.three]
type = "spherical"
parent = "b"
child = "c"
origin = { axis = [0, 0, 1], angle = "pi/3" }
[joints.four]
type = "universal"
parent = "c"
child = "d"
axis = [1, 0, 0]
axis2 = [0, 0, 2]
[loops.pin]
kind = "hinge"
bodies = ["a", "d"]
first = [0, 0, 0.1]
second = [0.1, 0, 0]
axis = [0, 0, 1]
axis2 = [0, 1, 0]
[loops.strut]
kind = "rod"
bodies = ["d", "world"]
length = 0.5
[loops.cam]
kind = "law"
joints = { one = 1 }
leaders = { "four.1" = 1 }
polynomial = [0, 1, 0.5]
[effects.gravity]
g = [0, 0, -9.81]
[effects.viscous]
joints = "all"
d = { one = 0.1, two = 0.2 }
[effects.mimic]
joints = "all"
[effects.spring.one]
k = 2
[effects.limit.one]
k = 1e4
[effects.wrench.push]
body = "a"
force = [0, 0, "sin(t)"]
[effects.spring_damper.rope]
bodies = ["a", "world"]
k = 3
[effects.contact.feet]
bodies = ["a", "d"]
mu = 0.5
[effects.ground]
offset = -1
[accuracy]
energy = 1e-3  # by FUNCTION
[ranges]
q = { one = "limits", four = [1, { lower = 0, upper = 2 }] }
v = [1, [1, 2, 3], { lower = -1, upper = 1 }]
a = 20
tau = "pi"
p = { "b.mass" = { lower = 0, upper = 1 } }
t = { lower = 0, upper = 10 }
[start]
q.one = 0.1
q.three = [0, 0, 0, 1]
v.three = [0.1, 0, 0]
x."contact.feet.d" = [0, 0, 1e-4]
[outputs]
record = ["q", "v"]
every = 0.1
[run]
duration = 1
integrator = "leapfrog"
step = 1e-3
rtol = 1e-9
atol = 1e-9
[expect]
"q.one" = [{ at = 0.5, value = 0, atol = 1e3 }, { at = 1, value = 0, rtol = 1, atol = 1e3 }]
"energy" = { at = 0, value = 0, atol = 1e9 }
"""


def errors(scene: object) -> list[str]:
    return [error.message for error in jsonschema.Draft7Validator(SCHEMA).iter_errors(scene)]


def is_read(scene: dict, folder: Path) -> bool:
    path = folder / "scene.toml"
    path.write_text(toml(scene))
    try:
        read_scene(path)
    except SceneError:
        return False
    return True


def toml(scene: dict) -> str:
    """A file that says this: every table inline, every key in quotes."""
    return "".join(f"{json.dumps(key)} = {_inline(value)}\n" for key, value in scene.items())


def _inline(value: object) -> str:
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(k)} = {_inline(v)}" for k, v in value.items()) + "}"
    if isinstance(value, list):
        return f"[{', '.join(map(_inline, value))}]"
    return json.dumps(value)


def places(value: object, path: tuple = ()) -> Iterator[tuple]:
    """The paths to all values that are not tables."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from places(inner, (*path, key))
    else:
        yield path


def tables(value: object, path: tuple = ()) -> Iterator[tuple]:
    """The paths to all tables except those whose keys are names of the scene's own."""
    if isinstance(value, dict):
        own = ("accuracy", "attach", "frames", "bodies", "joints", "leaders", "q", "v", "x", "p",
               "expect", "contact", "spring_damper", "viscous", "wrench")
        if not path or path[-1] not in own and path[-2:] != ("viscous", "d"):
            yield path
        for key, inner in value.items():
            yield from tables(inner, (*path, key))


def changed(path: tuple, value: object) -> dict:
    scene = copy.deepcopy(tomllib.loads(FULL))
    inner = scene
    for key in path[:-1]:
        inner = inner[key]
    inner[path[-1]] = value
    return scene


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_example_scenes_are_valid(path):
    scene = tomllib.loads(path.read_text(encoding="utf-8"))
    assert not errors(scene)
    assert errors(scene | {"efects": {}})


def test_the_command_prints_it(capsys):
    assert main(["schema"]) == 0
    assert json.loads(capsys.readouterr().out) == SCHEMA, OUTDATED


def test_a_scene_with_every_key_is_read_and_valid(tmp_path):
    scene = tomllib.loads(FULL)
    assert is_read(scene, tmp_path) and not errors(scene)
    for table in TABLES:
        for key in table.names:
            of_files = ("model", "arguments", "packages", "leave_out", "prefix")
            assert key in of_files or re.search(rf"\b{key}\b", FULL), f"{table.heading}: {key}"


def test_unknown_keys_are_refused_by_both(tmp_path):
    results = list(tables(tomllib.loads(FULL)))
    assert len(results) > 20
    for path in results:
        scene = changed((*path, "nonsense"), 1)
        assert errors(scene) and not is_read(scene, tmp_path), path


def test_values_of_another_type_are_refused_by_both(tmp_path):
    results = list(places(tomllib.loads(FULL)))
    assert len(results) > 60
    for path in results:
        for wrong in (True, {"nonsense": []}, [[[1]]]):
            scene = changed(path, wrong)
            assert errors(scene) and not is_read(scene, tmp_path), (path, wrong)


def test_unknown_words_are_refused_by_both(tmp_path):
    words = (("base",), ("precision",), ("implausible",), ("joints", "one", "type"),
             ("run", "integrator"), ("effects", "mimic", "joints"))
    for path in words:
        scene = changed(path, "nonsense")
        assert errors(scene) and not is_read(scene, tmp_path), path


@pytest.mark.parametrize("effect", EFFECTS, ids=lambda effect: effect.name)
def test_effects_have_their_parameters_and_no_others(effect):
    assert effect.name in SCHEMA["definitions"], OUTDATED
    own = SCHEMA["definitions"][effect.name]
    names = {parameter.name for parameter in effect.parameters}
    extra = {"bodies"} if effect.parts else {Place.BODY: {"body"}, Place.PAIR: {"bodies"}}.get(
        effect.place, {"joints"} if effect.on_sums else set())
    assert set(own["properties"]) == names | extra and own["additionalProperties"] is False
    for parameter in effect.parameters:
        if parameter.choices:
            assert own["properties"][parameter.name]["enum"] == list(parameter.choices)
