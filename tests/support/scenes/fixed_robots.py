"""Robots in fixed point, in the ranges for which errors and instructions are stated."""

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cache

from coscrew_codegen.accuracy.fixed_scene import FixedScene, in_fixed
from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.dynamics import derive
from coscrew_codegen.scene.mechanism.ranges import ranges_of_model, symmetric
from coscrew_codegen.scene.mechanism.tree import tree_of
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes.fixed_point import PANDA
from tests.support.scenes.robots import scene_of

ROBOTS = ("UR5", "Panda")


@cache
def scene(robot: str) -> Scene:
    """UR5: velocities of the model, accelerations up to 20 rad/s².  Panda: up to 0.5 rad/s and
    1 rad/s²."""
    its = scene_of("ur_description/urdf/ur5_robot.urdf") if robot == "UR5" else read_scene(PANDA)
    ranges = ranges_of_model(tree_of(its.model, mimics=False), its.parameters)
    stated = {"a": (symmetric(Fraction(20 if robot == "UR5" else 1)),) * len(ranges.a)}
    if robot == "Panda":
        stated["v"] = (symmetric(Fraction(1, 2)),) * len(ranges.v)
    return replace(its, ranges=ranges.stating(stated), tiers=("fixed",))


def fixed(robot: str, names: Sequence[str]) -> FixedScene:
    """These functions in fixed point."""
    return in_fixed(derive(scene(robot), names), tier_named("fixed"))
