"""Scenes and sweeps in notebooks, and plots of runs with targets and without curves on zero."""

import re
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from coscrew_codegen import load_scene, run
from coscrew_codegen.__main__ import main
from coscrew_codegen.simulation import SimulateError, sweep
from coscrew_codegen.simulation.control import Controller
from coscrew_codegen.simulation.recordings.recording_plot import plot
from coscrew_codegen.simulation.recordings.targets import targets
from coscrew_codegen.simulation.sweep.statistics.axis import parts_for
from tests.support.browser import chromium
from tests.support.playback_page import drawn as shown_page

DRIVEN = """
name = "swing"
runtime = ["bob.mass", "actuator.fin.target"]
[bodies.bob]
mass = 2
com = [0, 0, -0.5]
inertia = [0.1, 0.1, 0.1]
[bodies."<i>fin & co</i>"]
mass = 0.1
com = [0, 0, -0.1]
inertia = [0.01, 0.01, 0.01]
[joints.pin]
type = "revolute"
child = "bob"
axis = [0, 1, 0]
limits = { lower = -1.5, upper = 1.5 }
[joints.fin]
type = "revolute"
parent = "bob"
child = "<i>fin & co</i>"
axis = [0, 1, 0]
[effects.gravity]
[effects.viscous.pin]
d = 0.1
[effects.actuator.pin]
kind = "pd"
kp = 30
kd = 1
target = "0.5*sin(2*t)"
limit = 3
[effects.actuator.fin]
kind = "pd"
kp = 3
target = 0.25
[outputs]
record = ["q", "actuator.pin.torque", "actuator.pin.saturated", "energy.total", "position.bob"]
[run]
duration = 0.5
"""


@pytest.fixture(scope="module")
def scene(tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("notebooks") / "swing.toml"
    path.write_text(DRIVEN)
    return path


@pytest.fixture(scope="module")
def swept(scene) -> Path:
    folder = scene.parent / "masses"
    assert main(["sweep", str(scene), "--grid", "bob.mass=1:5:5", "--sobol",
                 "start.v.pin=-1:1", "--samples", "8", "--workers", "1", "--out",
                 str(folder)]) == 0
    return folder


def shown(text: str) -> ElementTree.Element:
    return ElementTree.fromstring(text.replace("<details open>", "<details>"))


# scenes

def test_a_scene_shows_its_tree_effects_functions_and_sizes(scene):
    kernels = load_scene(scene)
    root = shown(kernels._repr_html_())
    folded = {x.find("summary").text: x for x in root.iter("details")}
    assert "NQ = 2, NV = 2, bodies: 2; " in root.find("p").text
    (bob,) = folded["tree"].find("ul")
    assert "".join(bob.itertext()).startswith("bob, 2 kg: revolute pin")
    (fin,) = bob.find("ul")
    assert "".join(fin.itertext()) == "<i>fin & co</i>, 0.1 kg: revolute fin"
    effects = ["".join(x.itertext()) for x in folded["effects (3)"].iter("li")]
    assert effects == ["actuator: pin, fin", "gravity", "viscous: pin"]
    functions = [x.text for x in folded[f"functions ({len(kernels.interface.signatures)})"].iter(
        "li")]
    assert "inverse_dynamics(t, p 2, q 2, v 2, a 2) → tau 2" in functions
    assert [x.text for x in folded["p: parameters (2)"].iter("li")] == [
        "bob.mass = 2", "actuator.fin.target = 0.25"]


# plots

def lines(path: Path) -> dict[str, list[tuple[float, float]]]:
    """The points of each line, by its name."""
    root = ElementTree.parse(path).getroot()
    results = {}
    for x in root.iter("{http://www.w3.org/2000/svg}g"):
        if (d := next((p.get("d") for p in x.iter("{http://www.w3.org/2000/svg}path")), None)):
            results[x.get("id", "")] = [tuple(map(float, pair)) for pair in re.findall(
                r"[ML] (\S+) (\S+)", d)]
    return results


def test_targets_are_drawn_over_the_coordinates(scene, tmp_path):
    result = run(scene, p={"actuator.fin.target": 0.3})
    of = targets(result.system, result.recording)
    assert set(of) == {"q.pin", "q.fin"}
    assert np.allclose(of["q.pin"], 0.5 * np.sin(2 * result.t), rtol=1e-15, atol=0)
    assert of["q.fin"].tolist() == [0.3] * len(result.t)
    plot([result.recording], tmp_path / "out.svg", targets=of)
    drawn = lines(tmp_path / "out.svg")
    (_, start), *_, (_, end) = drawn["q.pin target"]
    assert start > end  # upwards: from 0 to 0.42
    assert drawn["q.fin target"][0][1] == drawn["q.fin target"][-1][1]


def test_a_controlled_run_shows_no_targets(scene):
    result = run(scene, controller=Controller(lambda t, q, v: 0.1, sets=("actuator.fin.target",)))
    assert targets(result.system, result.recording) == {}


def test_curves_on_zero_are_left_out_and_named(scene, tmp_path):
    result = run(scene)
    assert not result.recorded["position.bob.0"].any()
    plot([result.recording], tmp_path / "out.svg")
    drawn = lines(tmp_path / "out.svg")
    assert not {x for x in drawn if x.startswith("position")}
    assert {"q.pin", "actuator.pin.torque", "energy.total"} <= set(drawn)


def test_all_curves_on_zero_are_drawn(scene, tmp_path):
    result = run(scene, record=["position.bob"])
    plot([result.recording], tmp_path / "out.svg")
    assert {f"position.bob.{i}" for i in range(3)} <= set(lines(tmp_path / "out.svg"))


# runs

def test_a_run_shows_its_playback(scene, tmp_path):
    """In a frame that cannot reach the notebook."""
    one, other = (run(scene, p={"bob.mass": x}) for x in (2, 3))
    assert one._repr_html_() == one.show()._repr_html_()
    (tmp_path / "notebook.html").write_text(
        f"<!DOCTYPE html><meta charset='utf-8'>{one.show(other)._repr_html_()}")
    assert 2e5 < (tmp_path / "notebook.html").stat().st_size < 4e5
    with chromium() as browser:
        browser.get((tmp_path / "notebook.html").as_uri())
        browser.switch_to.frame(0)
        shown_page(browser)
        assert browser.find_element("tag name", "h1").text == "swing: playback"
        assert browser.execute_script("return JSON.parse(data.textContent).runs.map("
                                      "x => x.label);") == ["run 1", "run 2", "target"]
        assert [x["message"] for x in browser.get_log("browser")] == []
    with pytest.raises(SimulateError, match="show: wanted one run; got a batch"):
        run(scene, p={"bob.mass": [2, 3]}).show()


# sweeps

def test_a_sweep_shows_its_summary(swept, tmp_path):
    (tmp_path / "notebook.html").write_text(
        f"<!DOCTYPE html><meta charset='utf-8'>{sweep.summary(swept)._repr_html_()}")
    with chromium() as browser:
        browser.get((tmp_path / "notebook.html").as_uri())
        browser.switch_to.frame(0)
        assert browser.find_element("tag name", "h1").text == "A sweep of swing"
    with pytest.raises(sweep.SweepError, match="there is no summary.html; wanted the folder of a"):
        sweep.summary(tmp_path)


def test_the_page_of_a_sweep_puts_what_was_asked_for_first(swept):
    """The varied quantities in the order given, torques and saturation with plots, columns that
    are the same in all members named."""
    page = (swept / "summary.html").read_text("utf-8")
    labels = re.findall(r'aria-label="([^"]*)"', page)
    headings = re.findall(r"<h3>([^<]*)</h3>", page)
    assert headings == ["q.pin", "q.fin", "actuator.pin.torque", "actuator.pin.saturated",
                        "energy.total"]
    for name in headings:
        of = [x for x in labels if name in x]
        assert of == [f"distribution of {name}", f"{name} against bob.mass",
                      f"{name} against start.v.pin",
                      f"mean of {name} over bob.mass and start.v.pin"]
    assert ("The same in all members, not drawn: position.bob.0, position.bob.1, position.bob.2."
            in page)


@pytest.mark.parametrize("width, columns", ((390, 1), (1280, 3)))
def test_figures_of_a_sweep_stand_in_columns_that_fit(swept, width, columns):
    with chromium() as browser:
        browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": 844, "deviceScaleFactor": 1, "mobile": False})
        browser.get((swept / "summary.html").as_uri())
        left = browser.execute_script("""
            return [...document.querySelectorAll(".maps:first-of-type figure")].map(figure =>
              Math.round(figure.getBoundingClientRect().x));""")
        assert len(set(left)) == columns
        assert browser.execute_script("return document.documentElement.scrollWidth") <= width


@pytest.mark.parametrize("members, bins", (
    (1, 1), (2, 2), (5, 4), (64, 7), (320, 10), (10_000, 33), (10**6, 40)))
def test_bins_follow_the_number_of_members(members, bins):
    assert parts_for(members) == bins
