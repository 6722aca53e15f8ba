"""Only what divides by the mass matrix needs it regular: kinematics needs no masses, and inverse
dynamics no inertia at every joint.  All joints without inertia are named at once."""

import re
import warnings
from dataclasses import replace

import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.__main__ import main
from coscrew_codegen.dynamics import derive
from coscrew_codegen.scene.function_selection import (
    FunctionsError,
    dividing,
    left_out,
    selected_functions,
)
from coscrew_codegen.scene.mechanism.inertia_checks import unmoved, why_singular
from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides, read_scene
from tests.support.scenes.robots import path_of

KINEMATIC = """<robot name="kin"><link name="base"/><link name="a"/><link name="b"/>
<joint name="j1" type="revolute"><parent link="base"/><child link="a"/><axis xyz="0 0 1"/></joint>
<joint name="j2" type="revolute"><parent link="a"/><child link="b"/><origin xyz="0 0 1"/>
<axis xyz="0 1 0"/></joint></robot>"""

ARM = """
[bodies]
upper = { mass = 2, com = [0, 0, 0.5], inertia = [0.2, 0.2, 0.01] }
roller = { mass = 0.5, com = [0, 0.3, 0] }
finger = {}
[joints]
shoulder = { type = "revolute", child = "upper", axis = [0, 1, 0] }
spin = { type = "revolute", parent = "upper", child = "roller", axis = [0, 1, 0], \
origin = { xyz = [0, 0, 1] } }
grip = { type = "prismatic", parent = "roller", child = "finger", axis = [1, 0, 0] }
[effects.gravity]
"""
CAUSE = ("joint 'grip' moves nothing that has a mass and what joint 'spin' moves has no inertia "
         "against that motion, so that the mass matrix is singular; wanted [effects.armature] with "
         'joints = ["spin", "grip"] and inertia = 1e-3')


@pytest.fixture
def arm(tmp_path):
    def written(tail="", head=""):
        path = tmp_path / "arm.toml"
        path.write_text(head + ARM + tail)
        return path
    return written


@pytest.fixture
def leafless(arm):
    """The roller is the last link, a point on its own axis."""
    path = arm()
    path.write_text(re.sub(r"grip = .*\n|finger = .*\n", "", path.read_text()))
    return path


def test_kinematics_need_no_masses(tmp_path):
    (tmp_path / "kin.urdf").write_text(KINEMATIC)
    (tmp_path / "kin.toml").write_text(
        'model = "kin.urdf"\nfunctions = ["body_poses", "jacobian_b"]\n')
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        scene = load_scene(tmp_path / "kin.toml")
    q1, q2 = 0.3, -1.1
    b = scene.double.body_poses(np.array([q1, q2]))[2]
    z, y = (np.array([[np.cos(a), -s * np.sin(a)], [s * np.sin(a), np.cos(a)]])
            for a, s in ((q1, 1), (q2, -1)))
    turn = np.eye(3)
    turn[:2, :2] = z
    tilt = np.eye(3)
    tilt[::2, ::2] = y
    np.testing.assert_allclose(b, np.column_stack([turn @ tilt, [0, 0, 1]]), atol=1e-15)
    J = scene.double.jacobian_b(np.array([q1, q2]))
    np.testing.assert_allclose(J[3:], np.column_stack([tilt.T @ [0, 0, 1], [0, 1, 0]]), atol=1e-15)
    assert not J[:3].any()


def test_what_can_be_had_is_generated_and_the_rest_told_once(arm, capsys, tmp_path):
    """One line on standard error, and one warning."""
    path = arm()
    assert main(["generate", str(path), "-o", str(tmp_path / "out")]) == 0
    output = capsys.readouterr().err
    assert output == f"arm.toml: forward_dynamics and steps are left out: {CAUSE}\n"
    header = (tmp_path / "out/arm.h").read_text()
    assert "arm_inverse_dynamics(" in header and "arm_mass_matrix(" in header
    assert not any(f"arm_{name}(" in header for name in dividing(read_scene(path)))
    assert "positive semidefinite" in header
    for given in (path, read_scene(path)):
        with pytest.warns(RuntimeWarning, match="^arm: forward_dynamics and steps are left out"):
            scene = load_scene(given)
    with pytest.raises(AttributeError, match="'forward_dynamics': joint 'grip' moves nothing"):
        scene.double.forward_dynamics  # noqa: B018


def test_mass_matrices_of_singular_models_are_right(arm):
    """M from inverse dynamics, column by column: its null space consists of the motions that
    nothing resists."""
    with pytest.warns(RuntimeWarning):
        f = load_scene(arm()).double
    q = np.array([0.4, -0.9, 0.2])
    rest = f.inverse_dynamics(q, np.zeros(3), np.zeros(3))
    M = np.column_stack([f.inverse_dynamics(q, np.zeros(3), e) - rest for e in np.eye(3)])
    np.testing.assert_allclose(M, f.mass_matrix(q), atol=1e-14)
    assert not M[2].any() and np.linalg.matrix_rank(M) == 1
    assert rest[2] == 0 and abs(rest[0]) > 1


@pytest.mark.parametrize("name", ["forward_dynamics", "step_leapfrog", "step_rk4"])
def test_what_divides_by_a_singular_matrix_names_all_joints(arm, capsys, name, tmp_path):
    with pytest.raises(FunctionsError) as caught:
        read_scene(arm(), overrides=SceneOverrides(functions=(name,)))
    assert str(caught.value) == f"arm: {name} divides by the mass matrix, but {CAUSE}"
    for command in ("simulate", "check", "cost"):
        assert main([command, str(arm())]) == 2
        output = capsys.readouterr().err.splitlines()
        assert output[-1].endswith(CAUSE) and CAUSE not in output[:-1]


def test_the_remedy_works(arm, capsys):
    remedy = '[effects.armature]\njoints = ["spin", "grip"]\ninertia = 1e-3\n'
    path = arm(f"{remedy}[run]\nduration = 0.02\n")
    assert not why_singular(read_scene(path))
    assert main(["simulate", str(path)]) == 0
    assert "singular" not in capsys.readouterr().err


def test_a_point_on_its_own_axis_needs_an_armature_alone(leafless):
    scene = read_scene(leafless)
    assert [(x.joint.name, x.massive) for x in unmoved(scene)] == [("spin", True)]
    leafless.write_text(f"{leafless.read_text()}[effects.armature.spin]\ninertia = 1\n")
    assert not unmoved(read_scene(leafless))
    assert derive(read_scene(leafless)).steps


def test_one_joint_with_inertia_is_enough_for_those_that_move_with_it(arm):
    """Followers and leaders share a coordinate; without [effects.mimic] each has its own."""
    def scene(follow, effect):
        path = arm("[effects.mimic]\n" if effect else "")
        path.write_text(path.read_text().replace(
            "axis = [1, 0, 0] }", f'axis = [1, 0, 0], mimic = {{ joint = "{follow}" }} }}'))
        return [x.joint.name for x in unmoved(read_scene(path))]

    assert scene("shoulder", False) == ["spin", "grip"]
    assert scene("shoulder", True) == ["spin"]
    assert scene("spin", True) == ["spin", "grip"]


def test_balls_and_free_bodies_need_masses(arm):
    path = arm()
    path.write_text(path.read_text().replace(
        'grip = { type = "prismatic"', 'grip = { type = "spherical"').replace(
        ', axis = [1, 0, 0] }', " }"))
    assert why_singular(read_scene(path)).endswith("wanted masses and moments in what they move")


def test_selected_functions_need_no_notice(arm):
    scene = read_scene(arm(head='functions = ["inverse_dynamics", "energy"]\n'))
    assert not left_out(scene) and why_singular(scene) == CAUSE
    for words in ('"all"', '"energy", "*_dynamics"'):
        assert left_out(read_scene(arm(head=f"functions = [{words}]\n")))


@pytest.mark.parametrize("words", (["step_*"], ["energy", "forward_?ynamics"], ["step_rk4"]))
def test_patterns_of_nothing_but_what_divides_by_the_mass_matrix_are_refused(arm, words):
    scene = replace(read_scene(arm()), functions=tuple(words))
    with pytest.raises(FunctionsError) as refused:
        selected_functions(scene)
    assert f"divides by the mass matrix, but {CAUSE}" in str(refused.value)


def test_patterns_select_what_can_be(arm):
    scene = replace(read_scene(arm()), functions=("*_dynamics",))
    assert selected_functions(scene) == ("inverse_dynamics",)


def test_settings_that_leave_a_joint_without_inertia_are_refused(arm, capsys):
    path = arm("[run]\nduration = 0.01\n[effects.armature.grip]\ninertia = 0.1\n",
               'runtime = ["roller.com"]\n')
    path.write_text(path.read_text().replace("com = [0, 0.3, 0]", "com = [0.1, 0.3, 0]"))
    assert main(["simulate", str(path)]) == 0
    capsys.readouterr()
    assert main(["simulate", str(path), "--set", "roller.com.x=0"]) == 2
    assert capsys.readouterr().err.startswith(
        "coscrew: --set roller.com.x=0: what joint 'spin' moves has no inertia against that motion")


def test_all_joints_of_a_humanoid_with_massless_hands_are_named():
    scene = read_scene(path_of("romeo_description/urdf/romeo.urdf"))
    assert len(unmoved(scene)) == 24
    assert all(f"'{x.joint.name}'" in why_singular(scene) for x in unmoved(scene))
    assert derive(scene, ("inverse_dynamics",)).has("inverse_dynamics")
