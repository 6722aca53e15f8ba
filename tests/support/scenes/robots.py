"""The robots of example-robot-data, which comes with Pinocchio, in both libraries.

Ours snaps entries of rotations within 1e-11 of 0 and ±1, so Pinocchio gets the files with right
angles written in full: 1.57079632679 as 1.5707963267948966.
"""

import re
import sysconfig
from collections.abc import Callable, Collection
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache
from pathlib import Path

import numpy as np
import pinocchio as pin

from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.scene.effects import EFFECTS
from coscrew_codegen.scene.mechanism.model import WORLD, Joint
from coscrew_codegen.scene.scene import Applied, Scene
from tests.support.scenes.kinds import Kind
from tests.support.scenes.reading import read_urdf
from tests.support.scenes.selecting import jacobians, with_jacobians

COMPARED = ("inverse_dynamics", "forward_dynamics", "mass_matrix", "bias_torques", "energy",
            "body_poses", "body_twists")
"""The functions, besides Jacobians, that Pinocchio has as well."""
FOLDER = Path(sysconfig.get_path("purelib"), "cmeel.prefix/share/example-robot-data/robots")


def robots() -> tuple[Path, ...]:
    """All URDF files, in order; none without the package."""
    return tuple(sorted(FOLDER.rglob("*.urdf")))


def path_of(file: str) -> Path:
    """A robot's file."""
    return FOLDER / file


@dataclass(frozen=True)
class Robot:
    """A robot in both libraries.  `follow` maps our velocities to Pinocchio's."""

    functions: SceneFunctions
    model: "pin.Model"
    follow: np.ndarray
    offset: np.ndarray  # of joints with one coordinate, in v's order

    def states(self, count: int, seed: int = 0) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Random q, v, a in our order, one state a row, each number a float32."""
        rng = np.random.default_rng(seed)
        f = self.functions
        q = rng.uniform(-2, 2, (count, f.nq))
        for c in f.coordinates:
            if c.kind in ("free", "spherical"):
                x = q[:, c.q.stop - 4:c.q.stop]
                x /= np.linalg.norm(x, axis=1)[:, None]
        v, a = rng.uniform(-2, 2, (2, count, f.nv))
        return q, v, a

    def theirs(self, q: np.ndarray) -> np.ndarray:
        """q in Pinocchio's order."""
        model, f = self.model, self.functions
        result = pin.neutral(model)
        one = np.zeros(f.nv)  # joints with one coordinate, in v's order
        for c in f.coordinates:
            if c.kind == "free":
                result[:7] = q[c.q.start:c.q.stop]
            else:
                one[c.v.start] = q[c.q.start]
        values = self.follow @ one + self.offset
        for joint in model.joints:
            if joint.nv == 1:
                x = values[joint.idx_v]
                result[joint.idx_q:joint.idx_q + joint.nq] = (
                    x if joint.nq == 1 else (np.cos(x), np.sin(x)))
        return result


def in_full(text: str) -> str:
    """The text with right angles written in full."""
    def angle(results: re.Match[str]) -> str:
        x = float(results[0])
        near = round(x / (np.pi / 2)) * np.pi / 2
        return repr(near) if near and abs(x - near) < 1e-11 else results[0]

    return re.sub(r'rpy\s*=\s*"[^"]*"',
                  lambda results: re.sub(r"[-+0-9.eE]+", _safely(angle), results[0].split("=")[1])
                  .join(("rpy=", "")), text)


def _safely(function: Callable[[re.Match[str]], str]) -> Callable[[re.Match[str]], str]:
    def apply(results: re.Match[str]) -> str:
        try:
            return function(results)
        except ValueError:
            return results[0]
    return apply


def scene_of(file: str, free: bool = False, mimics: bool = False) -> Scene:
    """The robot under gravity; its base free or not; with followers following or not."""
    model = read_urdf(path_of(file))
    if free:
        root = ({j.parent for j in model.joints} - {j.child for j in model.joints}).pop()
        joints = model.joints
        if root == WORLD:
            joints = tuple(replace(j, kind=Kind.FREE) if j.parent == WORLD else j for j in joints)
        else:
            joints = (Joint("base", Kind.FREE, WORLD, root), *joints)
        model = replace(model, joints=joints)
    effects = {effect.name: effect for effect in EFFECTS}
    applied = [Applied(effects["gravity"], "",
                       {"g": (Fraction(0), Fraction(0), Fraction(-981, 100))})]
    if mimics:
        applied.append(Applied(effects["mimic"], "", {"joints": "all"}))
    return with_jacobians(Scene("robot", model, tuple(applied)))


@cache
def robot(file: str, free: bool, mimics: bool) -> Robot:
    """The robot in both libraries, ours with the functions that Pinocchio has as well."""
    scene = scene_of(file, free, mimics)
    return paired(scene, model_of(file, free), (*COMPARED, *jacobians(scene)), mimics)


def model_of(file: str, free: bool) -> "pin.Model":
    """Pinocchio's model of the robot; its base free or not."""
    arguments = (in_full(path_of(file).read_text()),
                 *([pin.JointModelFreeFlyer()] if free else []))
    result = pin.buildModelFromXML(*arguments)
    result.gravity.linear = np.array([0, 0, -9.81])
    return result


def paired(scene: Scene, theirs: "pin.Model", names: Collection[str], mimics: bool = False
           ) -> Robot:
    """A scene with these functions beside Pinocchio's model of it."""
    return paired_with(scene, derive(scene, names), theirs, mimics)


def paired_with(scene: Scene, functions: SceneFunctions, theirs: "pin.Model",
                mimics: bool = False) -> Robot:
    """A scene, with functions that are derived already, beside Pinocchio's model of it."""
    follow, offset = np.zeros((theirs.nv, functions.nv)), np.zeros(theirs.nv)
    places = {}
    for c in functions.coordinates:
        number = 1 if c.kind == "free" else theirs.getJointId(c.joint)
        start = theirs.joints[number].idx_v
        places[c.joint] = c.v.start
        for k in range(len(c.v)):
            follow[start + k, c.v.start + k] = 1
    for joint in scene.model.joints if mimics else ():
        if joint.mimic:
            place = theirs.joints[theirs.getJointId(joint.name)].idx_v
            follow[place, places[joint.mimic.joint]] = float(joint.mimic.multiplier)
            offset[place] = float(joint.mimic.offset)
    return Robot(functions, theirs, follow, offset)
