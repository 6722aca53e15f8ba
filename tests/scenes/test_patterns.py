"""Patterns of names (*, ?, [ab]) wherever names are listed: one meaning, one refusal."""

from pathlib import Path

import pytest

from coscrew_codegen import Controller, load_scene, run
from coscrew_codegen.__main__ import main
from coscrew_codegen.scene.patterns import PatternError, expanded, matching
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.recorded_quantities import (
    QuantityError,
    components,
    quantities_of,
    recordable,
    recorded,
)
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.control import set_by

HEAD = """
runtime = RUNTIME
functions = FUNCTIONS
[outputs]
record = RECORD
"""
BODY = """
[bodies]
base = { mass = 1, inertia = [1, 1, 1] }
hand = { mass = 2, com = [1, 0, 0], inertia = [1, 1, 1] }
"h[1]" = { mass = 3, inertia = [1, 1, 1] }
[joints]
left_hip = { type = "continuous", child = "base", axis = [0, 0, 1] }
left_knee = { type = "continuous", parent = "base", child = "hand", axis = [0, 0, 1] }
right = { type = "spherical", parent = "hand", child = "h[1]" }
[effects.gravity]
[effects.viscous]
joints = ["left_*"]
d = 0.1
[effects.actuator]
joints = ["left_*"]
kind = "torque"
torque = 0
[run]
duration = 0.01
[expect]
"v.left_*" = { at = 0, value = 0, atol = 1e-9 }
"""


def written(folder: Path, runtime: str = '["actuator.*.torque"]', functions: str = '["default"]',
            record: str = '["q"]', body: str = BODY) -> Path:
    path = folder / "scene.toml"
    path.write_text(HEAD.replace("RUNTIME", runtime).replace("FUNCTIONS", functions).replace(
        "RECORD", record) + body)
    return path


def test_a_name_that_exists_stands_for_itself():
    known = ("h[1]", "h1", "a*", "ab")
    assert matching("h[1]", known) == ("h[1]",)
    assert matching("h[0-9]", known) == ("h1",)
    assert matching("a*", known) == ("a*",)
    assert matching("?b", ("x",), known) == ("ab",)
    assert expanded(["ab", "*b", "h*"], known) == ("ab", "h[1]", "h1")
    with pytest.raises(PatternError, match=r"^'hnd\*' matches nothing; did you mean 'hand'\?$"):
        expanded(["hnd*"], ("hand", "foot"))


@pytest.mark.parametrize(("runtime", "names"), (
    ('["actuator.*.torque"]', ["actuator.left_hip.torque", "actuator.left_knee.torque"]),
    ('["hand.mass", "*.mass"]', ["hand.mass", "base.mass", "h[1].mass"]),
    ('["h[1].mass"]', ["h[1].mass"]),
    ('["han?.com"]', ["hand.com.x", "hand.com.y", "hand.com.z"]),
    ('["hand.*x"]', ["hand.com.x", "hand.inertia.xx"])))
def test_patterns_of_runtime_give_parameters(runtime, names, tmp_path):
    result = read_scene(written(tmp_path, runtime))
    assert [x.name for x in result.parameters] == names


@pytest.mark.parametrize(("changed", "message"), (
    ({"runtime": '[""]'}, "runtime: '' is no name"),
    ({"runtime": '["actuator.*.torqe"]'}, "runtime: 'actuator.*.torqe' matches nothing; did you "
     "mean 'actuator.left_"),
    ({"functions": '["jacobain_*"]'}, "functions: 'jacobain_*' matches no function of the scene; "
     "did you mean 'jacobian_h"),
    ({"functions": '["energi", "pwr"]'}, "'energi' is no function of the scene; did you mean "
     "'energy'?; 'pwr' is no function of the scene; did you mean 'power'?"),
    ({"record": '["positon.*", "q.rigt"]'}, "record: 'positon.*' matches no quantity; did you mean "
     "'position."),
    ({"record": '["positon.*", "q.rigt"]'}, "; 'q.rigt': no joint 'rigt' that has it; did you mean "
     "'right'?"),
    ({"body": BODY.replace('joints = ["left_*"]', 'joints = ["lfet_*"]')}, "joints: 'lfet_*' "
     "matches nothing; did you mean 'left_"),
    ({"body": BODY.replace('joints = ["left_*"]', 'joints = [""]')}, "joints: '' is no name"),
    ({"body": BODY.replace("v.left_*", "v.*_left")}, "'v.*_left' matches no quantity; did you "),
    ({"body": BODY.replace("v.left_*", "position.*")}, "has 3 components; wanted one")))
def test_a_pattern_without_a_match_is_refused_with_the_nearest_name(changed, message, tmp_path):
    with pytest.raises(SceneError) as error:
        read_scene(written(tmp_path, **changed))
    assert message in str(error.value)


def test_patterns_of_functions_select_them(tmp_path):
    path = written(tmp_path, functions='["energy", "*_dynamics"]')
    assert read_scene(path).functions == ("energy", "*_dynamics")
    kernels = load_scene(path)
    assert {"energy", "inverse_dynamics", "forward_dynamics"} == {*kernels.double}
    assert {*load_scene(path, functions=["jacobian_h*"]).double} == {"jacobian_hand",
                                                                    "jacobian_h_1"}


def test_patterns_of_joints_of_effects_are_joints(tmp_path):
    scene = read_scene(written(tmp_path))
    assert [x.on for x in scene.effects if x.effect.name == "viscous"] == ["left_hip", "left_knee"]
    assert [x.quantity for x in scene.expectations] == ["v.left_hip", "v.left_knee"]


@pytest.mark.parametrize(("texts", "names"), (
    (("q.left_*",), ("q.left_hip", "q.left_knee")),
    (("position.*.z",), ("position.base.z", "position.hand.z", "position.h[1].z")),
    (("position.*",), ("position.base", "position.hand", "position.h[1]")),
    (("position.h[1]",), ("position.h[1]",)),
    (("position.h[1].x",), ("position.h[1].x",)),
    (("energy.[kp]*", "energy.total"), ("energy.kinetic", "energy.potential", "energy.total")),
    (("q.right.?",), ("q.right.0", "q.right.1", "q.right.2", "q.right.3")),
    (("reaction.*hip", "reaction.left_hip"), ("reaction.left_hip",)),
    (("?",), ()),
    (("v.right", "v.*"), ("v.right", "v.left_hip", "v.left_knee"))))
def test_patterns_of_quantities_are_whole_ones_or_else_components(texts, names, tmp_path):
    scene = read_scene(written(tmp_path))
    if names:
        assert quantities_of(texts, scene) == names
    else:
        with pytest.raises(QuantityError, match="matches no quantity"):
            quantities_of(texts, scene)


ALL = tuple("""
center_of_mass center_of_mass_velocity energy momentum power
q.left_hip q.left_knee q.right v.left_hip v.left_knee v.right a.left_hip a.left_knee a.right
pose.base pose.hand pose.h[1] position.base position.hand position.h[1]
twist.base twist.hand twist.h[1] reaction.left_hip reaction.left_knee reaction.right
actuator.left_hip.torque actuator.left_hip.power actuator.left_knee.torque actuator.left_knee.power
gravity.power gravity.energy
viscous.left_hip.torque viscous.left_hip.power viscous.left_knee.torque viscous.left_knee.power
""".split())
"""What the scene can record: viscous friction and torques store no energy, and have no limits."""


def test_all_quantities_that_can_be_recorded_are_matched(tmp_path):
    scene = read_scene(written(tmp_path))
    assert recordable(scene) == quantities_of(("*",), scene) == ALL
    each = components(ALL, scene)
    assert len({*each}) == len(each) > len(ALL)


@pytest.mark.parametrize(("name", "columns"), (
    ("actuator.left_hip.torque", ["actuator.left_hip.torque"]),
    ("viscous.left_knee.power", ["viscous.left_knee.power"]),
    ("gravity.energy", ["gravity.energy"]),
    ("energy", ["energy.kinetic", "energy.potential", "energy.total"]),
    ("momentum", [f"momentum.{n}" for n in range(6)]),
    ("position.h[1]", [f"position.h[1].{n}" for n in range(3)])))
def test_a_quantity_has_these_columns(name, columns, tmp_path):
    assert list(recorded(name, read_scene(written(tmp_path))).names) == columns


@pytest.mark.parametrize("name", ("viscous.left_hip.energy", "viscous.right.power",
                                  "actuator.left_hip.saturated", "gravity.torque", "bristles"))
def test_what_an_effect_does_not_have_is_no_quantity(name, tmp_path):
    with pytest.raises(QuantityError):
        recorded(name, read_scene(written(tmp_path)))


def test_patterns_of_controllers_and_records_of_runs(tmp_path):
    path = written(tmp_path, runtime='["actuator.*.torque", "hand.mass"]')
    scene = read_scene(path)
    law = Controller(lambda t, q, v: [1.0, 2.0], sets=["actuator.*.torque"])
    assert set_by(law, scene) == (0, 1)
    result = run(path, controller=law, record=["v.left_*"])
    assert [*result.recorded] == ["v.left_hip", "v.left_knee"]
    other = Controller(lambda t, q, v: [1.0, 2.0], sets=["actuatr.*.torque"])
    with pytest.raises(SimulateError, match=r"sets 'actuatr.*' matches nothing; did you mean"):
        set_by(other, scene)
    with pytest.raises(SimulateError, match=r"record: 'v.lft_\*' matches no quantity; did you "):
        run(path, record=["v.lft_*"])


@pytest.mark.parametrize("words", (
    ("--functions", "energy,power"), ("--functions", "energy", "power"),
    ("--functions", "energy", "--functions", "power"), ("--functions", "energy, power"),
    ("--functions", "[ex]nergy,powe?")), ids=" ".join)
def test_lists_of_the_command_line_have_commas_spaces_or_several_options(words, tmp_path):
    out = tmp_path / "out"
    assert main(["generate", str(written(tmp_path)), "-o", str(out), *words]) == 0
    text = (out / "scene.h").read_text()
    assert "scene_energy(" in text and "scene_power(" in text and "scene_momentum(" not in text


def test_each_unknown_name_of_the_command_line_has_its_suggestion(tmp_path, capsys):
    words = ["generate", str(written(tmp_path)), "-o", str(tmp_path / "out"), "--functions"]
    assert main([*words, "energi,pwer", "jacobian_hnd"]) == 2
    output = capsys.readouterr().err
    for near in ("'energy'", "'power'", "'jacobian_hand'"):
        assert f"did you mean {near}?" in output
    with pytest.raises(SystemExit):
        main([*words, "energy,,power"])
    assert "an empty name in 'energy,,power'" in capsys.readouterr().err
    assert main(["generate", "--family", "vec33,quaternoin"]) == 2
    assert ("'vec33': did you mean 'vec3'?  unknown family 'quaternoin': did you mean 'quaternion'?"
            in capsys.readouterr().err)


def test_sweeps_record_by_patterns_and_a_grid_is_of_one_name(tmp_path, capsys):
    path = str(written(tmp_path, runtime='["*.mass"]'))
    assert main(["sweep", path, "--grid", "hand.mass=1:2:2", "--record", "q.left_*,energy.k*",
                 "--member", "1"]) == 0
    output = capsys.readouterr().out
    assert "record=('q.left_hip', 'q.left_knee', 'energy.kinetic')" in output
    assert main(["sweep", path, "--grid", "*.mass=1:2:2", "--member", "1"]) == 2
    assert ("--grid *.mass: wanted one name; the pattern matches base.mass, hand.mass, h[1].mass"
            in capsys.readouterr().err)
    assert main(["sweep", path, "--sobol", "h*.mas=1:2", "--samples", "4", "--member", "1"]) == 2
    assert "--sobol h*.mas: matches nothing; did you mean 'h" in capsys.readouterr().err


@pytest.mark.parametrize(("runtime", "notice"), (
    ("[]", "2 torques or forces of actuators do nothing: they are zero, and no argument of the "
     'functions; write runtime = ["actuator.left_hip.torque", "actuator.left_knee.torque"]'),
    ('["actuator.left_hip.torque"]', "actuator.left_knee.torque does nothing: it is zero, and no "
     'argument of the functions; write runtime = ["actuator.left_knee.torque"]'),
    ('["actuator.*.torque"]', "")))
def test_an_actuator_that_nothing_drives_is_told(runtime, notice, tmp_path):
    results = [x for x in read_scene(written(tmp_path, runtime)).unused if "nothing" in x]
    assert results == [notice] * bool(notice)
