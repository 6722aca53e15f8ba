"""A scene file whose model tests of readers share, and what reads it."""

import pytest

from coscrew_codegen.scene_files.toml_scene import read_scene
from tests.example_effects import CATALOGUE

MODEL = """
[bodies.upper]
mass = 1.5
com = [0, 0, 0.25]
inertia = [0.1, 0.1, 0.01]
[bodies.tool]
mass = 0.3
inertia = [0.02, 0.03, 0.04, 0.001, 0, -0.002]
[bodies.slide]
mass = 0.2
[joints.shoulder]
type = "revolute"
child = "upper"
axis = [0, -2, 0]
damping = 0.5
friction = 0.1
limits = { lower = -1, upper = 2, effort = 8, velocity = 3 }
[joints.elbow]
type = "continuous"
parent = "upper"
child = "tool"
axis = [1, 0, 0]
damping = 0.25
origin = { xyz = [0, 0, 0.5], rpy = [1.57079632679, 0, 0] }
[joints.rail]
type = "prismatic"
parent = "tool"
child = "slide"
axis = [0, 0, 1]
mimic = { joint = "elbow", multiplier = 0.5, offset = 0.125 }
"""


@pytest.fixture
def read(tmp_path):
    """Reads a scene with MODEL unless it brings its own."""

    def read(head="", tail="", model=MODEL, name="arm.toml"):
        path = tmp_path / name
        path.write_text(head + model + tail, encoding="utf-8")
        return read_scene(path, CATALOGUE)

    return read


def applied(scene, effect):
    return {(x.on, x.label): x.values for x in scene.effects if x.effect.name == effect}
