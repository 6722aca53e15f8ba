"""Every example scene runs from the command line, in both precisions, and meets its expectations.
"""

import csv
import json
import math
import re
import tomllib
from pathlib import Path

import pytest

from coscrew_codegen import load_scene, run
from coscrew_codegen.__main__ import main
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.compiled.c_harness import STRICT
from tests.support.compiled.c_harness import run as run_program
from tests.support.scenes.generated_scenes import LATEST, first_function

FOLDER = Path(__file__).parents[2] / "examples/scenes"
SCENES = sorted(FOLDER.glob("*.toml"))


@pytest.fixture(params=SCENES, ids=lambda path: path.stem)
def scene(request) -> Path:
    return request.param


def test_there_are_scenes_from_trivial_to_rich():
    bodies = {path.stem: len(read_scene(path).model.bodies) for path in SCENES}
    assert {"pendulum", "wingnut", "stick_slip", "arm6", "quadruped"} <= set(bodies)
    assert min(bodies.values()) == 1 and max(bodies.values()) == 13


def test_scenes_use_every_number_of_their_own(scene):
    """Models in scene files are tested; a URDF file may contain more than a scene needs."""
    if "model" not in tomllib.loads(scene.read_text()):
        assert not read_scene(scene).unused


def test_loaded_kernels_run_like_the_file(scene):
    """Whatever integrator the scene selects."""
    loaded, read = run(load_scene(scene), until=0.05), run(scene, until=0.05)
    assert loaded.q.tobytes() == read.q.tobytes() and loaded.v.tobytes() == read.v.tobytes()


def test_scenes_are_as_they_expect(scene, capsys):
    assert main(["check", str(scene)]) == 0
    printed = capsys.readouterr().out
    verdicts = re.findall(r"^(pass|FAIL) ", printed, re.MULTILINE)
    assert verdicts == ["pass"] * len(read_scene(scene).expectations) and len(verdicts) >= 3
    assert "DOUBTFUL" not in printed


def test_a_wrong_expectation_is_not_met(tmp_path, capsys):
    path = tmp_path / "pendulum.toml"
    text = (FOLDER / "pendulum.toml").read_text().replace("-0.275087462", "-0.275087562")
    path.write_text(text)
    assert main(["check", str(path)]) == 1
    assert re.findall(r"^FAIL  (\S+)", capsys.readouterr().out, re.MULTILINE) == ["position.bob.0"]


def test_scenes_are_simulated_recorded_plotted_and_shown(scene, tmp_path, capsys):
    table, page, plot = (tmp_path / f"run.{x}" for x in ("csv", "html", "svg"))
    assert main(["simulate", str(scene), "--until", "0.3", "--output", str(table), "--view",
                 str(page), "--plot", str(plot)]) == 0
    assert "at t = 0.3 s" in capsys.readouterr().out
    for path in (table, tmp_path / "run.single.csv"):
        lines = [x for x in path.read_text().splitlines() if not x.startswith("#")]
        rows = list(csv.reader(lines))
        assert float(rows[-1][0]) == 0.3 and len(rows) == 32  # names, then every 0.01 s
        assert all(math.isfinite(float(x)) for row in rows[1:] for x in row)
    assert plot.stat().st_size > 1000
    data = re.search(r'id="data">(.*?)</script>', page.read_text(), re.S)
    assert [body["name"] for body in json.loads(data[1])["bodies"]] == [
        body.name for body in read_scene(scene).model.bodies]


def test_scenes_are_generated_as_c_that_compiles_clean(scene, tmp_path):
    """A reader meets the first function soon."""
    assert main(["generate", str(scene), "-o", str(tmp_path)]) == 0
    for name in (f"{scene.stem}.c", f"{scene.stem}f.c"):
        assert first_function((tmp_path / name).read_text(encoding="utf-8")) <= LATEST, name
        run_program(["cc", "-std=c11", *STRICT, "-c", tmp_path / name, "-o",
                     tmp_path / "scene.o"])


def test_a_payload_is_set_at_run_time(tmp_path, capsys):
    """A heavier payload pulls the elbow further below its motor's target."""
    angles = {}
    for mass in ("0.5", "1.5", "4"):
        path = tmp_path / f"{mass}.csv"
        assert main(["simulate", str(FOLDER / "arm6.toml"), "--precision", "double", "--set",
                     f"payload.mass={mass}", "--output", str(path)]) == 0
        lines = [x for x in path.read_text().splitlines() if not x.startswith("#")]
        last = dict(zip(*csv.reader((lines[0], lines[-1])), strict=True))
        angles[mass] = float(last["q.elbow [rad]"])
    assert angles["0.5"] < angles["1.5"] < angles["4"]  # y points left: down is up


def test_costs_of_a_scene_are_told_effect_by_effect(capsys):
    assert main(["cost", str(FOLDER / "stick_slip.toml"), "--until", "0.2"]) == 0
    printed = capsys.readouterr().out
    for words in ("all effects", "without actuator", "without stribeck", "bare"):
        assert re.search(rf"^{words} ", printed, re.MULTILINE)
