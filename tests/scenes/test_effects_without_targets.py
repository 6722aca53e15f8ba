"""Effects that can act on nothing are refused; the message names the needed and the existing
targets."""

from dataclasses import replace

import pytest

from coscrew_codegen.scene.effect import Place
from coscrew_codegen.scene.effects import EFFECTS
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.scenes.effect_scenes import assert_listed
from tests.support.scenes.evaluation import MULTIPRECISE, Evaluated

FLOATING = 'base = "free"\n[bodies.hull]\nmass = 1\ninertia = [1, 1, 1]\n'
FRAME = ('[bodies.tip]\n[joints.tip_joint]\ntype = "fixed"\nparent = "hull"\nchild = "tip"\n')
FIELD = "[effects.field]\nmu = 4e14\n"


@pytest.fixture
def refusal(tmp_path):
    """The place and the problem of the error in a scene."""
    def refused(text):
        path = tmp_path / "ship.toml"
        path.write_text(text, encoding="utf-8")
        with pytest.raises(SceneError) as caught:
            read_scene(path)
        return caught.value.where, caught.value.problem
    return refused


def test_an_effect_on_joints_with_one_coordinate_needs_one(refusal):
    limit = '[effects.limit]\njoints = "all"\nk = 1\n'
    needed = "no joint of the model is revolute or prismatic, as limit needs: 'base' is free"
    wanted = "; wanted such a joint, or no limit"
    assert refusal(FLOATING + limit) == ("effects.limit.joints", needed + wanted)
    assert refusal(FLOATING + FRAME + limit) == (
        "effects.limit.joints", f"{needed}, 'tip_joint' is fixed{wanted}")
    hulls = "".join(f'[bodies.b{i}]\nmass = 1\ninertia = [1, 1, 1]\n[joints.j{i}]\n'
                    f'type = "free"\nchild = "b{i}"\n' for i in range(7))
    assert refusal(hulls + limit)[1].endswith(f"'j4' is free, …{wanted}")


def test_all_with_numbers_means_joints_with_one_coordinate(refusal):
    """A number for the joints of an arm does not hold its floating base."""
    assert refusal(FLOATING + '[effects.viscous]\njoints = "all"\nd = 1\n') == (
        "effects.viscous.joints", '"all" with numbers means joints with one coordinate, and there '
        'is none; wanted a list of names, as ["base"]')


SERIES = "".join(f'[bodies.b{x}]\nmass = 1\ninertia = [1, 1, 1]\n[joints.{x}]\ntype = "revolute"\n'
                 f'child = "b{x}"\nparent = "{y}"\naxis = [1, 0, 0]\n'
                 for x, y in (("p", "world"), ("q", "bp"), ("r", "bq")))


def test_all_means_joints_without_a_table_of_their_own(refusal, tmp_path):
    path = tmp_path / "arm.toml"
    path.write_text(f'{SERIES}[effects.viscous]\njoints = "all"\nd = {{ p = 1, r = 3 }}\n'
                    "[effects.viscous.q]\nd = 2\n", encoding="utf-8")
    assert [(x.on, x.values["d"]) for x in read_scene(path).effects] == [
        ("p", 1), ("q", 2), ("r", 3)]
    listed = '[effects.viscous]\njoints = ["q", "r"]\nd = 1\n[effects.viscous.q]\nd = 2\n'
    assert refusal(SERIES + listed)[1] == "viscous is given twice for joint 'q'; wanted it once"
    own = "".join(f"[effects.viscous.{x}]\nd = 1\n" for x in "pqr")
    assert refusal(f'{SERIES}[effects.viscous]\njoints = "all"\nd = 1\n{own}') == (
        "effects.viscous.joints", '"all" stands for those without a table of their own, and each '
        "joint has one; wanted no joints")


def test_where_a_model_has_many_joints_an_unknown_key_lists_those_of_the_effect(refusal):
    many = "".join(f'[bodies.b{i}]\nmass = 1\ninertia = [1, 1, 1]\n[joints.j{i}]\n'
                   f'type = "free"\nchild = "b{i}"\n' for i in range(30))
    text = many + '[effects.viscous]\njoints = "all"\nresistance = 1\n'
    assert refusal(text)[1] == "unknown key; wanted one of d, joints"


def test_all_means_bodies_without_a_table_of_their_own(tmp_path):
    path = tmp_path / "arm.toml"
    path.write_text(f'{SERIES}[effects.drag]\nbodies = "all"\nrho = 1\narea = 1\n'
                    "[effects.drag.bq]\nrho = 2\narea = 1\n", encoding="utf-8")
    assert [(x.on, x.values["rho"]) for x in read_scene(path).effects] == [
        ("bp", 1), ("bq", 2), ("br", 1)]


def test_the_gravity_of_a_field_acts_on_bodies_with_a_mass(refusal, tmp_path):
    massless = "field cannot act on body 'tip', which has no mass"
    for table, where in ((f'{FIELD}bodies = ["hull", "tip"]\n', "bodies"),
                         ("[effects.field.tip]\nmu = 4e14\n", "tip"),
                         ('[effects.field.pull]\nbody = "tip"\nmu = 1\n', "pull.body")):
        assert refusal(FLOATING + FRAME + table) == (f"effects.field.{where}", massless)
    path = tmp_path / "ship.toml"
    path.write_text(FLOATING + FRAME + FIELD + 'bodies = "all"\n', encoding="utf-8")
    assert [applied.on for applied in read_scene(path).effects] == ["hull"]


ARM = ('[bodies.column]\nmass = 1\ninertia = [1, 1, 1]\n[bodies.base]\n'
       '[bodies.arm]\nmass = 1\ninertia = [1, 1, 1]\n[bodies.hand]\n'
       '[joints.bolts]\ntype = "fixed"\nparent = "column"\nchild = "base"\n'
       '[joints.hinge]\ntype = "revolute"\nparent = "base"\nchild = "arm"\naxis = [0, 1, 0]\n'
       '[joints.wrist]\ntype = "fixed"\nparent = "arm"\nchild = "hand"\n')
"""A column and a base that are fixed to the world, an arm, and a hand fixed to that."""
VALUES = {"added_mass": "mass = [1, 1, 1]", "buoyancy": "rho = 1\nV = 1",
          "drag": "kind = 'stokes'\nb = 1",
          "field": "mu = 1\ncentre = [9, 0, 0]", "wrench": "force = [1, 0, 0]"}
ON_BODIES = [x.name for x in EFFECTS if x.place is Place.BODY and not x.parts]


def test_effects_on_bodies_have_values_here():
    assert_listed(VALUES, ON_BODIES, "VALUES", "tests/scenes/test_effects_without_targets.py")


@pytest.mark.parametrize("name", ON_BODIES)
def test_effects_on_a_body_fixed_to_the_world_are_refused(refusal, name):
    """However the body is named."""
    useless = (f"{name} does nothing to body 'column', which is fixed to the world; wanted a body "
               "that moves")
    for head, where in (("", "bodies"), (".column", "column"), (".label", "label.body")):
        named = {"bodies": 'bodies = ["column", "arm"]\n', "column": ""}.get(where,
                                                                             'body = "column"\n')
        text = f"{ARM}[effects.{name}{head}]\n{named}{VALUES[name]}\n"
        assert refusal(text) == (f"effects.{name}.{where}", useless)


@pytest.mark.parametrize("name", ON_BODIES)
def test_of_all_bodies_those_fixed_to_the_world_have_no_part_in_the_motion(tmp_path, name):
    """Their effects change neither accelerations nor powers, and of the energy only a constant."""
    path = tmp_path / "arm.toml"
    path.write_text(f'{ARM}[effects.gravity]\n[effects.{name}]\nbodies = "all"\n{VALUES[name]}\n',
                    encoding="utf-8")
    scene = read_scene(path)
    acting = {x.on for x in scene.effects if x.effect.name == name}
    assert {"column", "arm"} <= acting
    moving = replace(scene, effects=tuple(x for x in scene.effects if x.on != "column"))
    both = [Evaluated(x, MULTIPRECISE) for x in (scene, moving)]
    state = {"q": [0.25], "v": [0.5], "tau": [0.75]}
    for function in ("forward_dynamics", "power"):
        assert both[0](function, **state) == both[1](function, **state)


@pytest.mark.parametrize("pair, why", (
    (("world", "column"), "neither moves"), (("base", "column"), "neither moves"),
    (("hand", "arm"), "they move as one")))
def test_pairs_of_bodies_at_a_constant_distance_are_refused(refusal, pair, why):
    table = f"[effects.spring_damper.tie]\nbodies = {list(pair)}\nk = 1\n"
    assert refusal(ARM + table) == (
        "effects.spring_damper.tie.bodies", f"spring_damper does nothing between {pair[0]!r} and "
        f"{pair[1]!r}: {why}; wanted two bodies that move apart")


@pytest.mark.parametrize("pair", (("world", "hand"), ("arm", "column")))
def test_pairs_with_one_moving_body_are_accepted(tmp_path, pair):
    path = tmp_path / "arm.toml"
    path.write_text(f"{ARM}[effects.spring_damper.tie]\nbodies = {list(pair)}\nk = 1\n",
                    encoding="utf-8")
    assert [x.bodies for x in read_scene(path).effects] == [pair]


def test_numbers_that_neither_the_table_nor_the_model_gives_are_named(refusal):
    assert refusal(f'{FLOATING}[effects.wrench]\nbodies = "all"\n') == (
        "effects.wrench.force", "missing; wanted force or torque")
    hinge = '[bodies.arm]\nmass = 1\n[joints.hip]\ntype = "continuous"\nparent = "hull"\n' \
        'child = "arm"\naxis = [0, 0, 1]\norigin = { xyz = [1, 0, 0] }\n'
    assert refusal(f'{FLOATING}{hinge}[effects.limit]\njoints = "all"\nk = 1\n') == (
        "effects.limit", "no joint of the model has lower, upper; wanted numbers, or no limit")
