"""The numbers that effects take where a scene gives none: numbers that make their equations the
plain ones (a gear of 1, a rest at 0), and gravity as on Earth."""

from fractions import Fraction

import pytest

from coscrew_codegen.scene.effects import EFFECTS
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene

DEFAULTS = {"gear": 1, "g": (0, 0, Fraction(-981, 100)), "axis": (0, 0, 1), "speed": 1,
            "eps": Fraction(1, 1000), "v_s": Fraction(1, 100)}  # others are 0
GIVEN = [(effect.name, parameter) for effect in EFFECTS for parameter in effect.parameters
         if isinstance(parameter.default, int | Fraction | tuple)
         and not isinstance(parameter.default, bool)]


@pytest.mark.parametrize("effect, parameter", GIVEN,
                         ids=[f"{effect}-{parameter.name}" for effect, parameter in GIVEN])
def test_defaults_leave_an_equation_plain(effect, parameter):
    zero = (0, 0, 0) if isinstance(parameter.default, tuple) else 0
    assert parameter.default == DEFAULTS.get(parameter.name, zero)


def test_gravity_of_a_scene_that_gives_none_is_earths(tmp_path):
    path = tmp_path / "scene.toml"
    path.write_text("""
[bodies.link]
mass = 1
inertia = [1, 1, 1]
[joints.hinge]
type = "revolute"
child = "link"
axis = [0, 0, 1]
[effects.gravity]
""")
    (gravity,) = read_scene(path).effects
    assert gravity.values == {"g": (0, 0, Fraction(-981, 100))}
