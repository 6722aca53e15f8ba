"""Scenes with stated ranges."""

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

from coscrew_codegen.dynamics.derivation import tree_for
from coscrew_codegen.scene.mechanism.ranges import QUATERNION, Intervals, ranges_of_model, symmetric
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes import mechanisms as m
from tests.support.scenes.arms import arm
from tests.support.scenes.kinds import Kind

PANDA = Path(__file__).parents[3] / "examples/cost/panda.toml"


def ranged(scene: Scene, sizes: Mapping[str, str]) -> Scene:
    """The scene with arguments up to these sizes, positions within the joints' limits."""
    tree = tree_for(scene)
    stated: dict[str, Intervals] = {
        name: (symmetric(Fraction(size)),) * tree.nv for name, size in sizes.items()}
    return replace(scene, ranges=ranges_of_model(tree, scene.parameters).stating(stated))


def panda() -> Scene:
    """The Panda with |v| <= 0.5 and |a| <= 1."""
    return ranged(read_scene(PANDA), {"v": "0.5", "a": "1"})


def floating() -> Scene:
    """A free body that carries a joint and a ball joint, within 10 m of the origin."""
    kinds = (Kind.FREE, Kind.REVOLUTE, Kind.SPHERICAL)
    model = arm()
    model = replace(model, bodies=model.bodies[:3], joints=tuple(
        replace(joint, kind=kind) for joint, kind in zip(model.joints[:3], kinds, strict=True)))
    scene = ranged(Scene("floating", model, (m.gravity(),)), {"v": "2", "a": "10"})
    assert scene.ranges
    place = (symmetric(Fraction(10)),) * 3
    return replace(scene, ranges=scene.ranges.stating({
        "q": (*place, *QUATERNION, symmetric(Fraction(4)), *QUATERNION)}))


SCENES = {"panda": panda, "floating": floating}
FUNCTIONS = {
    "panda": ("inverse_dynamics", "inverse_dynamics_derivatives", "mass_matrix", "energy",
              "jacobian_link7", "inverse_dynamics_tangent"),
    "floating": ("inverse_dynamics", "body_poses", "mass_matrix", "momentum", "energy")}
"""Functions whose bounds are attacked, by scene."""
WORST = Path(__file__).parents[2] / "scenes/range_worst_cases.csv"
"""The worst states found."""
