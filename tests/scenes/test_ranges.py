"""Numbers that a precision cannot hold are refused by name before anything is generated."""

import math
import subprocess
from fractions import Fraction

import mpmath
import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.__main__ import main
from coscrew_codegen.backends.output_files import scene_files
from coscrew_codegen.dynamics import derive
from coscrew_codegen.dynamics.ranges.representable import RangeError
from coscrew_codegen.program import Constant, Op, folding
from coscrew_codegen.program.folding import Folded, Result, folded
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE
from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides, read_scene

SCENE = """
{precision}
runtime = []
[bodies.bob]
mass = 2
com = [0, 0, -0.5]
inertia = [0.01, 0.01, 0.01]
[bodies.tip]
mass = 0.5
inertia = [0.01, 0.01, 0.01]
[joints.pivot]
type = "continuous"
child = "bob"
axis = [0, 1, 0]
[joints.wrist]
type = "revolute"
parent = "bob"
child = "tip"
axis = [0, 1, 0]
origin = {{ xyz = [0, 0, -1] }}
mimic = {{ joint = "pivot", multiplier = 2, offset = 3 }}
[effects.gravity]
[effects.mimic]
[effects.viscous.pivot]
d = 0.25
[effects.drag.tip]
rho = 1.25
area = 0.125
point = [0, 0, 7]
[effects.wrench.tip]
force = ["4*t", 0, 6]
[run]
duration = 0.01
"""
DOUBLE_SAID = 'precision = "double"'

CASES = [
    ("mass = 2", "mass = 1e60", "body 'bob': mass 1e+60 kg"),
    ("mass = 2", "mass = 1e-40", "body 'bob': mass 1e-40 kg"),
    ("inertia = [0.01, 0.01, 0.01]\n[bodies.tip]",
     "inertia = [0.01, 0.01, 1e-39]\n[bodies.tip]", "body 'bob': inertia zz 1e-39 kg m²"),
    ("com = [0, 0, -0.5]", "com = [0, 0, -1e39]", "body 'bob': com z -1e+39 m"),
    ("xyz = [0, 0, -1]", "xyz = [0, 1e200, 0]", "joint 'wrist': origin y 1e+200 m"),
    ("multiplier = 2", "multiplier = 1e-39", "joint 'wrist': mimic's multiplier 1e-39"),
    ("offset = 3", "offset = 1e39", "joint 'wrist': mimic's offset 1e+39"),
    ("d = 0.25", "d = 1e40", "effect viscous.pivot: d 1e+40 N m s/rad or N s/m"),
    ("area = 0.125", "area = 1e-45", "effect drag.tip: area 1e-45 m^2"),
    ("[0, 0, 7]", "[0, 0, 7e50]", "effect drag.tip: point 7e+50 m"),
    ("0, 6]", "0, 6e50]", "effect wrench.tip: force 6e+50 N"),
    ("[effects.gravity]", "[effects.gravity]\ng = [0, 0, 1e39]", "effect gravity: g 1e+39 m/s^2"),
    # products
    ("com = [0, 0, -0.5]", "com = [0, 0, -1e25]", "body 'bob': its numbers are multiplied to"),
    ("rho = 1.25\narea = 0.125", "rho = 1e30\narea = 1e20",
     "drag at tip: its numbers are multiplied to 1e+50"),
    ('"4*t"', '"4e50*t"', "wrench at tip: its numbers are multiplied to 4e+50"),
    # slopes: that of dry friction at rest is tau/eps
    ("[effects.viscous.pivot]", "[effects.coulomb.pivot]\ntau_c = 1e5\neps = 1e-37\n"
     "[effects.viscous.pivot]", "coulomb at pivot: its numbers are multiplied to 1e+42"),
    ("[effects.viscous.pivot]", "[effects.coulomb.pivot]\ntau_c = 1e-30\neps = 1e30\n"
     "[effects.viscous.pivot]", "coulomb at pivot: its numbers are multiplied to 1e-60"),
    # quotients that no constant holds: kt/R with an R that may change
    ("runtime = []", 'runtime = ["actuator.pivot.R"]\n[effects.actuator.pivot]\nkind = "dc"\n'
     "voltage = 1\nkt = 1e5\nke = 1\nR = 1e-37",
     "actuator at pivot: its numbers are divided to 1e+42 at rest"),
]


@pytest.fixture
def path(tmp_path):
    def path(old="", new="", precision=""):
        assert old in SCENE
        (tmp_path / "arm.toml").write_text(
            SCENE.format(precision=precision).replace(old.replace("{{", "{"), new, 1))
        return tmp_path / "arm.toml"
    return path


@pytest.mark.parametrize("old, new, words", CASES)
def test_what_single_precision_cannot_hold_is_named(path, old, new, words):
    with pytest.raises(RangeError) as caught:
        derive(read_scene(path(old, new)))
    message = str(caught.value)
    assert message.startswith(f"arm: {words}") and "\n" not in message
    assert "is outside single precision's range: 0, and 1." in message
    assert 'precision = "double" in the scene file, or --precision double' in message


@pytest.mark.parametrize("old, new, words", CASES)
def test_double_precision_alone_is_not_refused_for_single(path, old, new, words):
    scene = read_scene(path(old, new, DOUBLE_SAID))
    files = scene_files(derive(scene))
    assert set(files) == {"arm.h", "arm.c", "coscrew_runtime.h", *(f"arm/{name}.py" for name in (
        "__init__", "_arrays", "double", "_elementary_double"))}
    assert "3.4028235e+38" not in files["arm.c"] and " float " not in files["arm.c"]
    assert read_scene(path(old, new), overrides=SceneOverrides("double")) == scene


@pytest.mark.parametrize("old, new", [("com = [0, 0, -0.5]", "com = [0, 0, 1e200]"),
                                      ("xyz = [0, 0, -1]", "xyz = [1e200, 0, 0]"),
                                      ("rho = 1.25\narea = 0.125", "rho = 1e200\narea = 1e200")])
def test_what_double_precision_cannot_hold_has_no_such_way_round(path, old, new):
    with pytest.raises(RangeError, match="outside double precision's range: 0, and 4.9e-324 to "
                                         r"1.8e\+308 in size$"):
        derive(read_scene(path(old, new, DOUBLE_SAID)))


@pytest.mark.parametrize("x, size", [(2000, -869), (16000, -6949)])
def test_sizes_of_any_length_are_told(path, x, size):
    """exp(-16000) has 6949 decimals: e^-x = 10^(-x/ln 10)."""
    assert round(-x / math.log(10)) == size
    with pytest.raises(RangeError, match=f"its numbers are multiplied to about 1e{size} in"):
        derive(read_scene(path('"4*t"', f'"exp(-{x})*t"', DOUBLE_SAID)))


def folded_exp(x: Fraction) -> Result:
    return folded(Op.EXP, (Constant(x, x),), {})


@pytest.mark.parametrize("x", [Fraction(x) for x in (
    "0.5", "-1/3", "100", "-745.2", "-5000", "16000")])
def test_exponentials_of_constants_have_sixty_digits(x):
    result = folded_exp(x)
    assert isinstance(result, Constant)
    with mpmath.workdps(80):
        truth = mpmath.exp(mpmath.mpf(x.numerator) / x.denominator)
        relative = mpmath.mpf(result.double.numerator) / result.double.denominator / truth - 1
        assert abs(relative) < mpmath.mpf(10)**-58


@pytest.mark.parametrize("x", [Fraction(x) for x in (
    "-2e4", "-2.5e11", "-1e400", "2e4", "2.5e11")])
def test_exponentials_beyond_all_formats_are_no_long_fractions(x):
    """They round to zero; numbers that round to infinity are left to the program."""
    with mpmath.workdps(20):  # 2^-16495: half of the least number of 128 bits; 2^16384: beyond them
        truth = mpmath.exp(mpmath.mpf(x.numerator) / x.denominator)
        assert truth < mpmath.mpf(2)**-16495 or truth > mpmath.mpf(2)**16384
    assert folded_exp(x) == (Constant(Fraction(0), Fraction(0)) if x < 0 else
                             Folded(Op.EXP, (Constant(x, x),)))


@pytest.mark.parametrize("width", ["4e-5", "1e-5", "1e-6", "1e-200"])
def test_short_pulses_in_time_take_no_memory(path, width):
    """At t = 0 that of 4e-5 s has 2^28 bits, 32 MB; two numbers of 1e-6 s do not fit in 64 GB."""
    pulse = f'kind = "torque"\ntorque = "4*exp(-((t-0.5)/{width})**2)"'
    scene = read_scene(path("[effects.gravity]", f"[effects.actuator.pivot]\n{pulse}",
                            DOUBLE_SAID))
    longest = 0

    def watched(x):
        nonlocal longest
        longest = max(longest, abs(x._mpf_[2]))
        assert longest < 10**5
        return rational(x)

    rational = folding._rational
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(folding, "_rational", watched)
        derive(scene)
    assert longest  # it was asked


@pytest.mark.parametrize("eps, tau_c", [("1e-30", "1e8"), ("1e-3", "1e-30")])
def test_quotients_within_range_are_not_refused(path, eps, tau_c):
    its = load_scene(path("[effects.viscous.pivot]", f"[effects.coulomb.pivot]\ntau_c = {tau_c}\n"
                          f"eps = {eps}\n[effects.viscous.pivot]"), functions=["step_leapfrog"])
    assert all(np.isfinite(x).all() for x in its.single.step_leapfrog(0.0, 1e-3, [0.1], [0.0]))


def test_parameters_values_count(path):
    with pytest.raises(RangeError, match="body 'bob': mass 1e-40 kg"):
        file = path("mass = 2", "mass = 1e-40")
        file.write_text(file.read_text().replace("runtime = []", 'runtime = ["bob.mass"]'))
        derive(read_scene(file))


@pytest.mark.parametrize("command", ["generate {} -o {}/out", "simulate {}", "check {}", "cost {}"])
def test_every_command_says_it_in_a_line(path, capsys, command):
    file = path("mass = 2", "mass = 1e60")
    words = command.format(file, file.parent).split()
    assert main(words) == 2
    output = capsys.readouterr()
    assert output.out == "" and output.err.count("\n") == 1
    assert output.err.startswith("coscrew: arm: body 'bob': mass 1e+60 kg is outside single")
    assert not (file.parent / "out").exists()


def test_double_alone_runs_and_single_says_why_it_does_not(path, capsys):
    file = path("mass = 2", "mass = 1e60")
    assert main(["simulate", str(file), "--precision", "double"]) == 0
    file = path("mass = 2", "mass = 1e60", DOUBLE_SAID)
    kernels = load_scene(file)
    assert np.isfinite(kernels.double.forward_dynamics(0.0, [0.1], [0.0], [0.0])).all()
    with pytest.raises(AttributeError, match="arm in single precision is not there: the scene is "
                                             "of double precision alone"):
        kernels.single.forward_dynamics
    with pytest.raises(RangeError):
        load_scene(path("mass = 2", "mass = 1e60"))


def test_files_of_double_alone_compile(path, tmp_path):
    out = tmp_path / "out"
    assert main(["generate", str(path()), "-o", str(out), "--precision", "double"]) == 0
    assert (out / "arm.h").read_text().startswith(
        "/* Made by `coscrew generate arm.toml --precision double`;")
    subprocess.run(["cc", "-std=c11", "-Wall", "-Wextra", "-Werror", "-c", "arm.c"], cwd=out,
                   check=True)
    assert main(["generate", str(path()), "-o", str(out)]) == 0 and (out / "arm/single.py").exists()


@pytest.mark.parametrize("precision, value", [
    (SINGLE, Fraction(10)**39), (SINGLE, Fraction(1, 10**46)), (SINGLE, -Fraction(10)**60),
    (DOUBLE, Fraction(10)**400), (DOUBLE, Fraction(1, 10**400))])
def test_no_literal_is_infinite_or_zero_that_is_not(precision, value):
    with pytest.raises(ValueError, match=f"outside {precision.name} precision's range"):
        precision.literal(Constant(value, value))
    assert precision.literal(Constant(Fraction(0), Fraction(0))) == "0.0"
