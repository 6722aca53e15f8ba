"""A scene file with a model that tests of readers share, and functions that read it."""

from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from coscrew_codegen.scene.mechanism.joint_kind import JointKind
from coscrew_codegen.scene.mechanism.model import Model
from coscrew_codegen.scene.readers.model_reader import ModelSource
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.readers.urdf.urdf import READER
from coscrew_codegen.scene.scene import Scene, Setting
from tests.support.scenes.example_effects import CATALOGUE
from tests.support.scenes.kinds import Kind

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

ARM = """<?xml version="1.0"?>
<robot name="arm">
  <material name="grey"><color rgba="1 1 1 1"/></material>
  <link name="foot"/>
  <link name="upper">
    <inertial>
      <origin xyz="0 0 0.25" rpy="0 0 1.57079632679"/>
      <mass value="1.5"/>
      <inertia ixx="0.1" ixy="0.01" ixz="0" iyy="0.2" iyz="0" izz="0.15"/>
    </inertial>
    <visual><geometry><mesh filename="nan"/></geometry></visual>
  </link>
  <link name="tool">
    <inertial><mass value="0.3"/>
    <inertia ixx="1e-3" ixy="0" ixz="0" iyy="1e-3" iyz="0" izz="1e-3"/></inertial>
  </link>
  <link name="frame"/>
  <joint name="elbow" type="continuous">
    <origin xyz="0 0 .5"/>
    <parent link="upper"/><child link="tool"/>
    <limit effort="9" velocity="3" lower="5" upper="-5"/>
    <dynamics damping="0.25"/>
    <mimic joint="shoulder" multiplier="-2" offset="0.5"/>
  </joint>
  <joint name="shoulder" type="revolute">
    <parent link="foot"/><child link="upper"/>
    <axis xyz="0 2 0"/>
    <limit lower="-1" upper="1.5" effort="100" velocity="2"/>
    <dynamics damping="0.5" friction="0.125"/>
  </joint>
  <joint name="tip" type="fixed"><parent link="tool"/><child link="frame"/></joint>
</robot>
"""


@pytest.fixture
def read(tmp_path: Path) -> Callable[..., Scene]:
    """A function that reads a scene, with MODEL unless the scene has a model of its own."""

    def read(head: str = "", tail: str = "", model: str = MODEL, name: str = "arm.toml") -> Scene:
        path = tmp_path / name
        path.write_text(head + model + tail, encoding="utf-8")
        return read_scene(path, CATALOGUE)

    return read


def applied(scene: Scene, effect: str) -> dict[tuple[str, str], Mapping[str, Setting]]:
    return {(x.on, x.label): x.values for x in scene.effects if x.effect.name == effect}


def read_urdf(path: Path | str, base: JointKind = Kind.FIXED, implausible: str = "error") -> Model:
    """The model in a URDF file."""
    return READER.read(ModelSource(Path(path), base, implausible))
