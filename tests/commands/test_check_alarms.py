"""`coscrew check` stops where `coscrew simulate` does, and neither stops for rounding errors."""

import pytest

from tests.support.scenes.simulated import outcome

SLIDE = """
[bodies]
b = { mass = 1, inertia = [1, 1, 1] }
[joints]
z = { type = "prismatic", child = "b", axis = [0, 0, 1] }
"""
SPRING = SLIDE + """
[effects.spring]
joints = "all"
k = 1e8
[start.q]
z = 1
[run]
"""


@pytest.mark.parametrize("run", (
    "duration = 0.5", "duration = 0.095", "duration = 1e-3", "duration = 3e-3",
    "duration = 0.5\n[outputs]\nevery = 0.5", "duration = 0.9\nstep = 0.01"))
def test_a_spring_that_turns_by_ten_radians_a_step_is_false(tmp_path, capsys, run):
    """Its energy is kept to rounding.  `check` compares steps with half steps, as `simulate` does;
    both do so at least twice, however short the run is and however few its samples."""
    text = SPRING.replace("1e8", "1e6" if "step" in run else "1e8")
    for command in ("simulate", "check"):
        status, message = outcome(tmp_path / "spring.toml", capsys, command, text + run)
        assert status == 1 and "the step is too large" in message


@pytest.mark.parametrize("integrator", ("rk4", "semi-implicit-euler"))
@pytest.mark.parametrize("k, precision", (("1e7", "single"), ("1e8", "double")))
def test_energy_that_overflows_is_no_rounding(tmp_path, capsys, integrator, k, precision):
    text = SPRING.replace("1e8", k) + f'duration = 0.09\nintegrator = "{integrator}"\n'
    for command in ("simulate", "check"):
        status, out = outcome(tmp_path / "spring.toml", capsys, command, text, "--precision",
                            precision)
        assert status == 1 and "rounding" not in out
        assert "is not kept at" in out or "not finite at" in out or "too large at" in out


TURNING = """
[bodies]
a = { mass = 1, com = [0, 0, -0.2], inertia = [0.01, 0.01, 0.01] }
b = { mass = 1, inertia = [0.01, 0.01, 0.01] }
[joints]
a = { type = "revolute", child = "a", axis = [0, 1, 0] }
b = { type = "revolute", child = "b", axis = [0, 1, 0] }
[run]
duration = 0.5
"""


@pytest.mark.parametrize("effect", (
    'actuator.a]\nkind = "torque"\ntorque = 1', 'actuator.a]\nkind = "torque"\ntorque = "1+0*t"',
    "wrench.a]\nforce = [0, 0, 0]\ntorque = [0, 1, 0]"))
def test_a_power_that_is_a_velocity_feeds_energy_in(tmp_path, capsys, effect):
    """A torque of 1 has the power v, which takes no operation."""
    for command in ("simulate", "check"):
        status, message = outcome(tmp_path / "one.toml", capsys, command,
                                  f"{TURNING}[effects.{effect}")
        assert status == 0, message


def test_what_only_smaller_steps_show_is_false(tmp_path, capsys):
    """A torque whose period equals the step is zero at the beginning of each step."""
    text = SLIDE + """
[effects.actuator.z]
kind = "torque"
torque = "1000*sin(2*pi*1000*t)"
[start.v]
z = 1
[run]
duration = 0.5
"""
    status, message = outcome(tmp_path / "hum.toml", capsys, "check", text, "--precision", "double")
    assert status == 1
    assert "joint z is off by 0.9 of the way it moves" in message


def test_a_light_body_beside_a_heavy_one_is_judged_by_its_own_motion(tmp_path, capsys):
    """It vibrates by a millimetre, which energies do not show: cos(ω t) with h ω = 10, and 0.01."""
    text = """
[bodies]
a = { mass = 100, inertia = [1, 1, 1] }
b = { mass = 0.01, inertia = [1, 1, 1] }
[joints]
x = { type = "prismatic", child = "a", axis = [1, 0, 0] }
z = { type = "prismatic", child = "b", axis = [0, 0, 1] }
[effects.spring.z]
k = 1e6
[start.q]
z = 0.001
[start.v]
x = 10
"""
    for k, expected in (("1e6", 1), ("1", 0)):
        for command in ("simulate", "check"):
            status, message = outcome(tmp_path / "light.toml", capsys, command,
                                      text.replace("1e6", k), "--precision", "double")
            assert status == expected, message
            assert ("joint z is off by" in message) == (expected == 1)


def test_what_double_shows_is_no_rounding_of_single(tmp_path, capsys):
    """Euler's steps change the energy of a pendulum on a hill in both precisions."""
    text = PENDULUM.format(angle="0.2", z=2000) + "step = 25e-3\n"
    status, message = outcome(tmp_path / "hill.toml", capsys, "check", text, "--integrator",
                        "linear-implicit-euler")
    assert status == 1 and message.count("integrator, of order 1.0") == 2
    assert "rounding" not in message


@pytest.mark.parametrize("height", (0, 1, 2000))
def test_what_rests_has_no_error_of_energy(tmp_path, capsys, height):
    """In both precisions, however much potential energy it has."""
    status, message = outcome(tmp_path / "rest.toml", capsys, "check",
                              PENDULUM.format(angle="0", z=height), "--precision", "both")
    cause = next(x for x in message.splitlines() if x.startswith("cause of this error"))
    assert status == 0 and cause.count("none: nothing moves") == 2


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
    """The rounding error of m g z of a pendulum on a hill is larger than its kinetic energy."""
    text = PENDULUM.format(angle=angle, z=z)
    for command in ("simulate", "check"):
        status, message = outcome(tmp_path / "pendulum.toml", capsys, command, text, "--precision",
                            precision)
        assert status == 0, message
    if angle in ("3e-8", "1e-9"):
        assert "unknown: the potential energy's rounding exceeds the energy moved" in message


@pytest.mark.parametrize("angle, z, precision", [("1e-3", 0, "single"), ("0.1", 2000, "single"),
                                                 ("3e-8", 0, "double")])
def test_such_motions_are_still_false_where_steps_are_too_long(tmp_path, capsys, angle, z,
                                                               precision):
    """Their energies show nothing, but a step of 0.6 s differs from two half steps: h ω = 2.6."""
    text = PENDULUM.format(angle=angle, z=z).replace("duration = 1", "duration = 30\nstep = 0.6")
    text += "[outputs]\nevery = 0.6\n"
    for command in ("simulate", "check"):
        status, message = outcome(tmp_path / "pendulum.toml", capsys, command, text, "--precision",
                            precision)
        assert status == 1
        assert "the step is too large" in message or command == "simulate"  # energy, too
