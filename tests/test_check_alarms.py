"""`coscrew check` stops where `coscrew simulate` does, and neither where only rounding is seen."""

import pytest

from tests.test_check import told


def test_a_spring_that_turns_by_ten_radians_a_step_is_false(tmp_path, capsys):
    """Though its energy is kept to rounding: `check` looks at steps as `simulate` does."""
    text = """
[bodies]
b = { mass = 1, inertia = [1, 1, 1] }
[joints]
z = { type = "prismatic", child = "b", axis = [0, 0, 1] }
[effects.spring]
joints = "all"
k = 1e8
[start.q]
z = 1
[run]
duration = 0.5
"""
    for command in ("simulate", "check"):
        status, said = told(tmp_path / "spring.toml", capsys, command, text)
        assert status == 1 and "the step is too large" in said


PENDULUM = """
[bodies]
bob = {{ mass = 1, com = [0, 0, -0.5], inertia = [0.01, 0.01, 0.01] }}
[joints]
pivot = {{ type = "continuous", child = "bob", axis = [0, 1, 0], origin = {{ xyz = [0, 0, {z}] }} }}
[effects.gravity]
[start.q]
pivot = {angle}
[run]
duration = 1
"""


@pytest.mark.parametrize("angle, z, precision", [
    ("1e-3", 0, "single"), ("0.1", 2000, "single"), ("3e-7", 0, "double"), ("3e-8", 0, "double"),
    ("1e-9", 0, "double"), ("'pi'", 0, "double")])
def test_motions_smaller_than_the_rounding_of_energies_are_true(tmp_path, capsys, angle, z,
                                                                precision):
    """Of a pendulum whose m g z has more rounding than its kinetic energy has to lose."""
    text = PENDULUM.format(angle=angle, z=z)
    for command in ("simulate", "check"):
        status, said = told(tmp_path / "pendulum.toml", capsys, command, text, "--precision",
                            precision)
        assert status == 0, said
    if angle in ("3e-8", "1e-9"):
        assert "untold: potential energy rounds by more than was moved" in said


@pytest.mark.parametrize("angle, z, precision", [("1e-3", 0, "single"), ("0.1", 2000, "single"),
                                                 ("3e-8", 0, "double")])
def test_such_motions_are_still_false_where_steps_are_too_long(tmp_path, capsys, angle, z,
                                                               precision):
    """Their energies tell nothing, but a step of 0.6 s differs from its halves: hω is 2.6."""
    text = PENDULUM.format(angle=angle, z=z).replace("duration = 1", "duration = 30\nstep = 0.6")
    text += "[outputs]\nevery = 0.6\n"
    for command in ("simulate", "check"):
        status, said = told(tmp_path / "pendulum.toml", capsys, command, text, "--precision",
                            precision)
        assert status == 1
        assert "the step is too large" in said or command == "simulate"  # energy tells that, too
