"""Effects that can act on nothing are refused, with what they need and what there is."""

import pytest

from coscrew_codegen.scene_files.errors import SceneError
from coscrew_codegen.scene_files.toml_scene import read_scene

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
    viscous = '[effects.viscous]\njoints = "all"\nd = 1\n'
    needed = "no joint of the model is revolute or prismatic, as viscous needs: 'base' is free"
    wanted = "; wanted such a joint, or no viscous"
    assert refusal(FLOATING + viscous) == ("effects.viscous.joints", needed + wanted)
    assert refusal(FLOATING + FRAME + viscous) == (
        "effects.viscous.joints", f"{needed}, 'tip_joint' is fixed{wanted}")
    hulls = "".join(f'[bodies.b{i}]\nmass = 1\ninertia = [1, 1, 1]\n[joints.j{i}]\n'
                    f'type = "free"\nchild = "b{i}"\n' for i in range(7))
    assert refusal(hulls + viscous)[1].endswith(f"'j4' is free, …{wanted}")


def test_the_gravity_of_a_field_acts_on_bodies_with_a_mass(refusal, tmp_path):
    massless = "field cannot act on body 'tip', which has no mass"
    for table, where in ((f'{FIELD}bodies = ["hull", "tip"]\n', "bodies"),
                         ("[effects.field.tip]\nmu = 4e14\n", "tip"),
                         ('[effects.field.pull]\nbody = "tip"\nmu = 1\n', "pull.body")):
        assert refusal(FLOATING + FRAME + table) == (f"effects.field.{where}", massless)
    path = tmp_path / "ship.toml"
    path.write_text(FLOATING + FRAME + FIELD + 'bodies = "all"\n', encoding="utf-8")
    assert [applied.on for applied in read_scene(path).effects] == ["hull"]


def test_numbers_that_neither_the_table_nor_the_model_gives_are_named(refusal):
    assert refusal(f'{FLOATING}[effects.wrench]\nbodies = "all"\n') == (
        "effects.wrench.force", "missing; wanted force or torque")
    hinge = '[bodies.arm]\nmass = 1\n[joints.hip]\ntype = "continuous"\nparent = "hull"\n' \
        'child = "arm"\naxis = [0, 0, 1]\norigin = { xyz = [1, 0, 0] }\n'
    assert refusal(f'{FLOATING}{hinge}[effects.limit]\njoints = "all"\nk = 1\n') == (
        "effects.limit", "no joint of the model has lower, upper; wanted numbers, or no limit")
