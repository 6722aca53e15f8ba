"""Names that can be read in two ways are refused, with both readings."""

from pathlib import Path

import pytest

from coscrew_codegen.dynamics import derive
from coscrew_codegen.scene.function_selection import FunctionsError
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.recorded_quantities import QuantityError, recorded

BESIDE = """
[bodies]
a = { mass = 1, inertia = [1, 1, 1] }
b = { mass = 1, inertia = [1, 1, 1] }
[joints]
j = { type = "spherical", child = "a" }
"j.0" = { type = "continuous", parent = "a", child = "b", axis = [0, 0, 1] }
"""
"""A joint that is called as a component of another."""

ARMATURE = """
runtime = ["armature.j.inertia"]
[bodies]
"armature.j" = { mass = 1, inertia = [1, 1, 1] }
[joints]
j = { type = "continuous", child = "armature.j", axis = [0, 0, 1] }
[effects.armature.j]
inertia = 0.1
"""
"""A body's moments of inertia that are called as a number of an effect."""

CONTACTS = """
[bodies]
hand = { mass = 1, inertia = [1, 1, 1] }
hand_tangent = { mass = 1, com = [1, 0, 0], inertia = [1, 1, 1] }
[joints]
wrist = { type = "continuous", child = "hand", axis = [0, 0, 1] }
finger = { type = "continuous", parent = "hand", child = "hand_tangent", axis = [0, 0, 1] }
[loops.contacts]
kind = "law"
joints = { finger = 1 }
leaders = { wrist = 1 }
polynomial = [0, 0.5]
[effects.gravity]
"""
"""A body and a loop whose functions are called as others."""


def refused(tmp_path: Path, text: str) -> str:
    path = tmp_path / "scene.toml"
    path.write_text(text)
    with pytest.raises(SceneError) as caught:
        read_scene(path)
    return str(caught.value)


@pytest.mark.parametrize("quantity", ("q", "v", "a"))
def test_columns_of_two_joints_have_different_names(tmp_path: Path, quantity: str):
    both = f"'{quantity}.j.0' is a component of the joint 'j' or of the joint 'j.0'; rename one"
    for text in (quantity, f"{quantity}.j", f"{quantity}.j.0"):
        assert both in refused(tmp_path, f'{BESIDE}[outputs]\nrecord = ["{text}"]\n')


def test_scenes_that_record_nothing_of_them_are_read(tmp_path: Path):
    path = tmp_path / "scene.toml"
    path.write_text(f'{BESIDE}[outputs]\nrecord = ["energy"]\n')
    with pytest.raises(QuantityError):
        recorded("q", read_scene(path))


def test_numbers_of_bodies_and_effects_have_different_names(tmp_path: Path):
    assert ("'armature.j.inertia' is a number, and the vector of 'armature.j.inertia.xx', too; "
            "rename one") in refused(tmp_path, ARMATURE)


@pytest.mark.parametrize("name", ("ksl", "KSL_exact", "coscrew_arm"))
def test_scenes_are_not_called_as_the_librarys_headers(tmp_path: Path, name: str):
    assert f"{name!r} begins as the names of the library's headers and macros do; wanted" in \
        refused(tmp_path, f'name = "{name}"\n{BESIDE}')
    path = tmp_path / f"{name}.toml"
    path.write_text(f'{BESIDE}[outputs]\nrecord = ["energy"]\n')
    assert read_scene(path).name == f"scene_{name}"


@pytest.mark.parametrize("functions, problem", (
    (("jacobian_hand_tangent", "energy_tangent"),
     "jacobian_hand_tangent is a function of 'hand_tangent', and a derivative of jacobian_hand, "
     "too; rename one"),
    (("closing_contacts",), "closing_contacts is a function of 'contacts', and a function of the "
                            "scene, too; rename one")))
def test_functions_have_different_names(tmp_path: Path, functions: tuple[str, ...], problem: str):
    path = tmp_path / "two.toml"
    path.write_text(CONTACTS)
    scene = read_scene(path)
    with pytest.raises(FunctionsError) as caught:
        derive(scene, functions)
    assert str(caught.value) == f"two: {problem}"
    assert derive(scene, ("jacobian_hand_tangent",)).functions[0].name == "jacobian_hand_tangent"
