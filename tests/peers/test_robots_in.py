"""`python -m tests.robots_in` on small files: one of each format, and of each outcome."""

from pathlib import Path
from types import SimpleNamespace

import pytest

pytest.importorskip("mujoco", reason="no wheel for this platform")
pytest.importorskip("pinocchio", reason="no wheel for this platform")

from tests import robots_in
from tests.support.robots_in.by_name import alone, robots
from tests.support.robots_in.compare import FORMATS, files_of, outcome_of
from tests.support.robots_in.outcome import Outcome

LINK = ('<link name="{0}"><inertial><origin xyz="0 0 0.25"/><mass value="1.5"/><inertia ixx="0.5" '
        'iyy="0.5" izz="0.5" ixy="0" ixz="0.1" iyz="0"/></inertial></link>')
JOINT = ('<joint name="{0}" type="{1}"><parent link="{2}"/><child link="{3}"/><origin xyz="0 0 0.5"'
         ' rpy="0.1 0 0"/><axis xyz="0 1 0"/></joint>')
URDF = (f'<robot name="arm"><link name="foot"/>{LINK.format("upper")}{LINK.format("hand")}'
        f'{JOINT.format("pin", "continuous", "foot", "upper")}'
        f'{JOINT.format("turn", "continuous", "upper", "hand")}</robot>')
MJCF = ('<mujoco>{}<worldbody><body name="b"><geom size="0.1" pos="0 0 1"/>{}</body></worldbody>'
        "</mujoco>")
HINGE = '<joint name="j" axis="0 1 0" damping="1" armature="0.5" stiffness="2"/>'
FILES = {
    "a/arm.urdf": (URDF, "URDF", "agrees"),
    "a/arm.xacro": (URDF.replace("<robot", '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"'),
                    "xacro", "agrees"),
    "a/copy.urdf": (URDF.replace('"upper"', '"arm"'), "URDF", "agrees"),
    "a/still.urdf": (URDF.replace("continuous", "fixed"), "URDF", "nothing moves"),
    "a/wrong.urdf": (URDF.replace("<axis", "<axes"), "URDF", "refused"),
    "b/b.xml": (MJCF.format("", HINGE), "MJCF", "agrees"),
    "b/fluid.xml": (MJCF.format('<option density="1000"/>', HINGE).replace("0.1", "0.2"), "MJCF",
                    "differs"),
    "b/old.xml": (MJCF.format('<compiler coordinate="global"/>', HINGE), "MJCF", "not compared"),
    "b/piece.xml": ("<mujocoinclude/>", "", ""),
    "b/plane.urdf": (URDF.replace("continuous", "planar"), "URDF", "not compared"),
}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name, (text, _, _) in FILES.items():
        path = tmp_path / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)
    return tmp_path


def test_each_file_has_its_outcome(folder):
    pytest.importorskip("xacro")
    wanted = {name: rest for name, (_, *rest) in FILES.items() if rest[0]}
    seen = {}
    for package in ("a", "b"):
        for path, format_ in files_of(folder / package, FORMATS):
            outcome = outcome_of(package, path, format_, folder / package)
            seen[f"{package}/{outcome.file}"] = [format_, outcome.status]
            assert (outcome.status == "agrees") == (0 < outcome.error <= 1e-9), outcome
            if outcome.status == "differs":
                assert (outcome.without, outcome.reason) == (("fluid",), "bias, torques")
    assert seen == wanted


def test_the_command_counts_copies_once_and_fails_for_a_difference(folder, monkeypatch, capsys):
    arguments = ["robots_in", "--folder", str(folder), "--packages", "a", "b", "--formats", "URDF",
                 "MJCF"]
    monkeypatch.setattr("sys.argv", arguments)
    assert robots_in.main() == 0
    out = capsys.readouterr().out
    assert "URDF: 2 distinct models that move, 1 agree to 1e-9" in out
    assert "MJCF: 2 distinct models that move, 1 agree to 1e-9" in out
    assert "without fluid: bias, torques" in out
    assert "URDF alone: 3 robots by name: 1 agree to 1e-9, 1 are refused, 1 are read by no" in out
    assert "MJCF alone: 3 robots by name: 1 agree to 1e-9, 1 differ, 1 are read by no other" in out
    changed = (folder / "a/arm.urdf").read_text()
    monkeypatch.setattr("tests.support.robots_in.pinocchio_states.in_full",
                        lambda text: changed.replace('value="1.5"', 'value="1.6"'))
    assert robots_in.main() == 1


def outcome(file: str, format_: str, status: str = "agrees", model: str = "") -> Outcome:
    return Outcome("p", file, format_, status, model=model or file)


def test_a_robot_has_one_name_in_all_formats():
    """A copy under another name is the same robot, and so is what is called as it."""
    files = [outcome("arms/ur5/urdf/robot.urdf", "URDF"), outcome("mj/UR5.xml", "MJCF", model="u"),
             outcome("mj/scene-of-arm.xml", "MJCF", model="u"), outcome("of_arm.xacro", "xacro"),
             outcome("hand.xml", "MJCF", "refused"), outcome("hand.scene.xml", "MJCF", "differs"),
             outcome("box.xml", "MJCF", "nothing moves")]
    for given in (files, files[::-1]):
        held = [sorted({x.file for x in of}) for of in robots(given)]
        assert sorted(held) == [["arms/ur5/urdf/robot.urdf", "mj/UR5.xml", "mj/scene-of-arm.xml",
                                 "of_arm.xacro"], ["hand.scene.xml", "hand.xml"]]
        assert alone(given, ("MJCF", "URDF")) == {"MJCF": {"differs": 1}, "URDF": {}}


def test_an_interrupted_installation_is_done_again(tmp_path, monkeypatch):
    calls = []

    def fails(command: list[str], check: bool) -> SimpleNamespace:
        calls.append(command)
        Path(command[-2]).mkdir()
        return SimpleNamespace(returncode=len(calls) == 1)

    monkeypatch.setattr("subprocess.run", fails)
    for count in (1, 2, 2):
        robots_in.installed(tmp_path, ["arms"])
        assert len(calls) == count
    assert (tmp_path / "arms").is_dir() and not (tmp_path / "arms.partial").exists()
