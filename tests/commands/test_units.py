"""Units of a scene's functions, component by component, and numbers with units in few words."""

import math

import pytest

from coscrew_codegen.dynamics import derive
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.simulation.result_units import in_unit, units


def test_every_component_has_its_unit(tmp_path):
    path = tmp_path / "scene.toml"
    path.write_text("""
[bodies.block]
mass = 0.7
inertia = [0.02, 0.02, 0.02]
[joints.slide]
type = "prismatic"
child = "block"
axis = [1, 0, 0]
[bodies.arm]
mass = 1
inertia = [0.1, 0.1, 0.1]
[joints.hinge]
type = "revolute"
child = "arm"
parent = "block"
axis = [0, 1, 0]
""")
    functions = derive(read_scene(path), (
        "inverse_dynamics", "forward_dynamics", "mass_matrix", "jacobian_arm", "reaction_hinge",
        "energy", "body_poses", "body_twists", "momentum", "integrated"))
    results = {f.name: units(functions, f.name) for f in functions.functions}
    for f in functions.functions:
        assert len(results[f.name]) == sum(a.quantity.size for a in f.program.outputs)
    assert results["inverse_dynamics"] == ("N", "N m")
    assert results["forward_dynamics"] == ("m/s^2", "rad/s^2")
    assert results["mass_matrix"] == ("kg", "kg m", "kg m", "kg m^2")
    assert results["jacobian_arm"] == 3 * ("1", "m") + 3 * ("1/m", "1")
    assert results["reaction_hinge"] == ("N", "N", "N", "N m", "N m", "N m")
    assert results["body_poses"] == 2 * 3 * ("1", "1", "1", "m")
    assert results["energy"] == ("J", "J") and results["integrated"] == ("m", "rad")


@pytest.mark.parametrize("x, unit, words", (
    (3e-6, "N m", "3 µN m"), (7.13e-13, "N m", "7.2e-13 N m"), (0.9996, "J", "1 J"),
    (2e-7, "kg m^2", "2e-7 kg m²"), (1e-17, "1", "1e-17"), (0, "N", "0 N"),
    (123456, "N", "130 kN"), (math.inf, "N", "unbounded")))
def test_numbers_with_units_are_short(x, unit, words):
    assert in_unit(x, unit) == words


def test_effects_have_the_units_of_their_results(tmp_path):
    path = tmp_path / "scene.toml"
    path.write_text("""
[bodies.block]
mass = 0.7
inertia = [0.02, 0.02, 0.02]
[joints.slide]
type = "prismatic"
child = "block"
axis = [1, 0, 0]
[effects.spring.slide]
k = 3
[effects.drag.block]
kind = "stokes"
b = 2
""")
    functions = derive(read_scene(path), ("effect_spring_slide", "effect_drag_block"))
    assert units(functions, "effect_spring_slide") == ("N", "W", "J")
    assert units(functions, "effect_drag_block") == (*("N",) * 3, *("N m",) * 3, "W")
