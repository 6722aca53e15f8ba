"""`coscrew simulate` as a command: output, refusals, parameters."""

import math
import re

import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.__main__ import main
from coscrew_codegen.scene.function_selection import FunctionsError
from coscrew_codegen.scene.integrators import NAMES
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.system import system
from tests.support.scenes import scene_texts as texts
from tests.support.scenes.selecting import STEPPED
from tests.support.scenes.simulated import run, scene_file


def test_the_command_prints_states_energies_and_differences(tmp_path, capsys):
    assert main(["simulate", str(scene_file(tmp_path, texts.SPRING)), "--until", "1"]) == 0
    out, err = capsys.readouterr()
    assert err == ""  # no terminal, no progress
    (state,) = re.findall(r"^q\.slide +(\S+) +(\S+)$", out, re.M)
    assert float(state[0]) == pytest.approx(float(texts.spring(1)[0]), abs=1e-10)
    assert float(state[1]) == pytest.approx(float(texts.spring(1)[0]), abs=1e-6)
    (energy,) = re.findall(r"^energy at the start +(\S+)", out, re.M)
    assert float(energy) == pytest.approx(texts.STIFFNESS * 0.1**2 / 2)
    (energy,) = re.findall(r"^energy at the end +(\S+)", out, re.M)
    q, v = (float(x) for x in texts.spring(1))
    assert float(energy) == pytest.approx(
        texts.STIFFNESS * q**2 / 2 + texts.MASS * v**2 / 2, rel=1e-8)
    assert "work of effects -" not in out and "gained" not in out and "coscrew check" in out
    (apart,) = re.findall(r"^q +m +\S+ +(\S+) +q\.slide", out, re.M)
    assert 0 < float(apart) < 1e-6


def test_a_run_that_stops_says_so_and_writes(tmp_path, capsys):
    output = tmp_path / "out.npz"
    assert main(["simulate", str(scene_file(tmp_path, texts.UNSTABLE)), "--output",
                 str(output)]) == 1
    assert "joint slide" in capsys.readouterr().err
    for path in (output, tmp_path / "out.single.npz"):
        with np.load(path) as data:
            assert len(data["t"]) > 1
            assert "not finite" in dict(data["provenance"])["stopped"]


URDF = """<robot name="arm">
  <link name="tool"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0"
    iyz="0"/></inertial></link>
  <link name="ground"/>
  <joint name="hinge" type="revolute"><parent link="ground"/><child link="tool"/>
    <axis xyz="0 1 0"/><limit lower="-1" upper="2" effort="3" velocity="4"/>
    <dynamics damping="5" friction="6"/></joint>
</robot>"""


def test_a_urdf_alone_runs_and_says_what_acts(tmp_path, capsys):
    path = tmp_path / "arm.urdf"
    path.write_text(URDF)
    assert main(["simulate", str(path), "--until", "0.1"]) == 0
    first, *unused = capsys.readouterr().err.splitlines()
    assert first == ("coscrew: arm.urdf alone: gravity, viscous at 1 joint act; limits, friction "
                     "and drives take a scene file")
    assert unused == ["coscrew: not used: friction, limits, effort and velocity of joint hinge "
                      "(add [effects.coulomb], [effects.limit], [effects.actuator], "
                      "[effects.speed_limit]; --verbose "
                      "lists them with what to write)"]


@pytest.mark.parametrize("words", [
    "simulate ARM --until 0.1", "check ARM --until 0.1", "generate ARM --output OUT",
    "cost ARM --function energy --states 8",
    "sweep ARM --until 0.1 --grid start.q.hinge=0:1:2 --member 0"])
def test_commands_sum_up_what_is_not_used_and_list_it_on_demand(tmp_path, capsys, words):
    """In one line, or in a line for each, what changes the motion first."""
    path = tmp_path / "arm.urdf"
    path.write_text(URDF)
    given = words.replace("ARM", str(path)).replace("OUT", str(tmp_path / "out")).split()
    for verbose in (False, True):
        main([*given, *["--verbose"] * verbose])
        output = [line.partition(": ")[2] for line in capsys.readouterr().err.splitlines()
                  if "not used" in line or "used by" in line]
        if not verbose:
            assert len(output) == 1 and "--verbose lists them" in output[0]
            continue
        assert sorted(output) == sorted(read_scene(path).unused)
        assert [line.split()[2] for line in output] == ["friction", "lower", "upper", "effort",
                                                        "velocity"]


def test_help_tells_that_a_model_will_do(capsys):
    with pytest.raises(SystemExit):
        main(["simulate", "--help"])
    output = " ".join(capsys.readouterr().out.split())
    assert "a scene file (.toml), or a model's file alone, as a URDF" in output


def test_without_pyarrow_nothing_runs_for_parquet(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("coscrew_codegen.simulation.recordings.recording_writer.find_spec",
                        lambda name: None)
    monkeypatch.setattr("coscrew_codegen.runtime.load.load_scene", None)  # would fail if called
    path = tmp_path / "out.parquet"
    assert main(["simulate", str(scene_file(tmp_path, texts.SPRING)), "--output", str(path)]) == 2
    assert 'needs pyarrow; run `pip install "coscrew[simulate]"`' in capsys.readouterr().err
    assert not path.exists()


@pytest.mark.parametrize("arguments, message", (
    (["--integrator", "rk5"],
     f"integrator: 'rk5'; wanted one of {', '.join(NAMES)}; did you mean 'rk4'?"),
    (["--set", "block.mas=2"], "wanted a parameter that the scene lists in `runtime`: block.mass"),
    (["--set", "spring.slide.k=2"], "wanted a parameter that the scene lists in `runtime`: "
     "block.mass; to change this constant, write it there"),
    (["--precision", "single", "--set", "block.mass=1e39"], "outside single precision's range: 0, "
     "and 1.2e-38 to 3.4e+38 in size"),
    (["--precision", "single", "--set", "block.mass=1e-40"], "outside single precision's range"),
    (["--output", "out.xls"], "wanted a name that ends in .csv or .npz or .parquet"),
    (["--output", "nowhere/out.csv"], "cannot write nowhere/out.csv"),
    (["--plot", "out.gif"], "wanted a name that ends in .svg or .png"),
    (["--view", "nowhere/run.html"], "cannot write nowhere/run.html"),
    (["--until", "1e9"], "samples, one every")))
def test_wrong_options_are_refused_before_anything_runs(tmp_path, capsys, monkeypatch, arguments,
                                                        message):
    monkeypatch.chdir(tmp_path)
    assert main(["simulate", str(scene_file(tmp_path, texts.SPRING)), *arguments]) == 2
    assert message in capsys.readouterr().err
    assert [x.name for x in tmp_path.iterdir()] == ["scene.toml"]


RUNTIME = """
runtime = ["tool.mass", "tool.com", "tool.inertia", "spring.hinge.k", "coulomb.hinge.eps"]
[bodies.tool]
mass = 2
com = [0, 0, -0.5]
inertia = [0.01, 0.01, 0.01]
[joints.hinge]
type = "revolute"
child = "tool"
axis = [0, 1, 0]
[effects.spring]
joints = "all"
k = 3
[effects.coulomb.hinge]
tau_c = 1
eps = 1e-3
"""


@pytest.mark.parametrize("key, given, settings", (
    ("mass = 2", "mass = -1.5", {"tool.mass": -1.5}), ("mass = 2", "mass = 0", {"tool.mass": 0}),
    ("mass = 2", "mass = 1e301", {"tool.mass": 1e301}),
    ("[0.01, 0.01, 0.01]", "[0.01, 0.01, 1]", {"tool.inertia.zz": 1}),
    ("k = 3", "k = -3", {"spring.hinge.k": -3}),
    ("eps = 1e-3", "eps = 0", {"coulomb.hinge.eps": 0}),
    ("com = [0, 0, -0.5]\ninertia = [0.01, 0.01, 0.01]", "com = [0, 0, 0]",
     {"tool.com.z": 0, "tool.inertia.xx": 0, "tool.inertia.yy": 0, "tool.inertia.zz": 0})))
def test_numbers_are_set_that_the_file_may_hold(tmp_path, key, given, settings):
    kernels = load_scene(scene_file(tmp_path, RUNTIME), functions=STEPPED)
    system(kernels, "double", {"tool.mass": 5.0, "tool.inertia.zz": 0.02})
    with pytest.raises(SimulateError, match="--set"):
        system(kernels, "double", {name: float(x) for name, x in settings.items()})
    assert key in RUNTIME
    with pytest.raises((SceneError, FunctionsError)):  # a model without inertia can be read
        load_scene(scene_file(tmp_path, RUNTIME.replace(key, given)), functions=STEPPED)


LIMITED = """
runtime = ["limit.slide.lower"]
[bodies]
block = { mass = 1 }
[joints]
slide = { type = "prismatic", child = "block", axis = [0, 0, 1] }
[effects.limit.slide]
lower = -1
upper = 0.1
k = 1e4
[start.q]
slide = 0.1
[run]
duration = 0.1
"""


@pytest.mark.parametrize("command", ("simulate", "check"))
def test_ends_of_ranges_are_not_exchanged(tmp_path, capsys, command):
    scene = scene_file(tmp_path, LIMITED)
    assert main([command, str(scene), "--set", "limit.slide.lower=1"]) == 2
    assert capsys.readouterr().err == ("coscrew: --set limit.slide.lower=1: limit.slide: lower, 1, "
                                       "is above upper, 0.1\n")


@pytest.mark.parametrize("command", ("simulate", "check"))
@pytest.mark.parametrize("start, settings, messages", (
    ("0.1", (), ""), ("-1", (), ""),
    ("0.2", (), "joint slide starts at 0.2, outside its range from -1 to 0.1"),
    ("-1.5", (), "joint slide starts at -1.5, outside"),
    ("0", ("--set", "limit.slide.lower=0.05"), "starts at 0, outside its range from 0.05 to 0.1")))
def test_starts_outside_ranges_are_told(tmp_path, capsys, command, start, settings, messages):
    text = LIMITED.replace("slide = 0.1\n", f"slide = {start}\n")
    assert main([command, str(scene_file(tmp_path, text)), "--precision", "single", *settings]) == 0
    output = capsys.readouterr()
    assert messages in output.out + output.err
    assert ("outside" in output.out + output.err) == bool(messages)


@pytest.mark.parametrize("start, info", (("0.5", "joint tail starts at 2, outside its range"),
                                         ("0.1", "")))
def test_followers_that_start_outside_are_told(tmp_path, capsys, start, info):
    text = LIMITED.replace("[joints]", "tail = { mass = 1 }\n[joints]").replace(
        "[effects.limit.slide]", """
[joints.tail]
type = "prismatic"
child = "tail"
axis = [0, 0, 1]
[joints.tail.mimic]
joint = "slide"
multiplier = 3
offset = 0.5
[effects.mimic]
[effects.limit.tail]
lower = -1
upper = 0.8
k = 1e4
[effects.limit.slide]""").replace("upper = 0.1", "upper = 1").replace(
            "slide = 0.1\n", f"slide = {start}\n")
    assert main(["simulate", str(scene_file(tmp_path, text))]) == bool(info)  # by too large a force
    out = capsys.readouterr().err
    assert info in out and ("outside" in out) == bool(info)


@pytest.mark.parametrize("number", (math.nan, math.inf))
def test_what_is_no_number_is_not_set(kernels, capsys, number):
    with pytest.raises(SimulateError, match="--set block.mass"):
        system(kernels["SPRING"], "double", {"block.mass": number})
    with pytest.raises(SystemExit):
        main(["simulate", "scene.toml", "--set", f"block.mass={number}"])
    assert f"block.mass: wanted a finite number; got '{number}'" in capsys.readouterr().err


def test_vectors_are_set_by_components(capsys):
    with pytest.raises(SystemExit):
        main(["simulate", "scene.toml", "--set", "tool.com=1,2,3"])
    assert "got '1,2,3'; components one by one, as tool.com.x=1" in capsys.readouterr().err


@pytest.mark.parametrize("command", ("simulate", "check", "cost"))
def test_no_command_takes_a_negative_mass(tmp_path, capsys, command):
    scene = scene_file(tmp_path, texts.SPRING)
    assert main([command, str(scene), "--set", "block.mass=-1.5"]) == 2
    assert capsys.readouterr().err == (
        "coscrew: --set block.mass=-1.5: wanted a positive number\n")


@pytest.mark.parametrize("arguments", (["--until", "-1"], ["--step", "nan"], ["--until", "soon"],
                                       ["--set", "mass"], ["--precision", "half"]))
def test_arguments_that_are_none_are_refused(tmp_path, capsys, arguments):
    with pytest.raises(SystemExit) as refused:
        main(["simulate", str(scene_file(tmp_path, texts.SPRING)), *arguments])
    assert refused.value.code == 2
    assert arguments[0] in capsys.readouterr().err


def test_a_start_that_overflows_single_precision_is_refused(tmp_path):
    text = texts.SPRING.replace("slide = 0.1", "slide = 1e300")
    with pytest.raises(SimulateError, match="joint slide: q is inf"):
        run(load_scene(scene_file(tmp_path, text), functions=STEPPED), "single")
