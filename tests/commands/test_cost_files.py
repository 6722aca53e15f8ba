"""Files of coscrew cost: JSON whose fields are documented, a self-contained page, all or nothing;
and every kind of function that it can measure."""

import json
import math
import re
from dataclasses import replace
from itertools import permutations
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.__main__ import main
from coscrew_codegen.program.values.digits import three_digits
from coscrew_codegen.program.values.formats import BY_NAME
from coscrew_codegen.reports.cost import CostError, cost_json, cost_measurement
from coscrew_codegen.reports.cost.cost_measurement import Costs, Row
from coscrew_codegen.reports.cost.cost_request import CostRequest
from coscrew_codegen.reports.cost.figures import cost_page
from coscrew_codegen.reports.cost.figures.cost_figure import shown
from coscrew_codegen.reports.cost.figures.cost_page import accuracies, others
from coscrew_codegen.reports.cost.function_errors import Bounds
from coscrew_codegen.reports.cost.measured import Counts
from coscrew_codegen.reports.cost.run_errors import RunError, RunErrors
from coscrew_codegen.reports.cost.work_precision import Point, ReferenceRun
from coscrew_codegen.reports.timing.intervals import Interval
from coscrew_codegen.runtime.load import kernels_for
from coscrew_codegen.scene.function_selection import FunctionsError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.result_units import in_unit
from coscrew_codegen.simulation.run_summary import RunOverrides
from tests.benchmarks import published_bounds
from tests.support.browser import chromium
from tests.support.scenes import scene_texts as texts

TIERS = ("plain", "accurate", "certified")
ROOT = Path(__file__).parents[2]
FLOATING = """
base = "free"
[bodies.trunk]
mass = 2
inertia = [0.1, 0.2, 0.25]
[bodies.arm]
mass = 1
com = [0, 0, -0.3]
inertia = [0.1, 0.1, 0.1]
[joints.hinge]
type = "revolute"
parent = "trunk"
child = "arm"
axis = [0, 1, 0]
limits = { lower = -1, upper = 1 }
[effects.gravity]
[effects.limit.hinge]
k = 1000
alpha = 0.1
[run]
duration = 0.1
"""


@pytest.fixture(scope="module")
def scene(tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("files") / "spring.toml"
    path.write_text(texts.SPRING.replace("k = 100", "k = 100.3"))
    return path


@pytest.fixture(scope="module")
def costs(scene) -> Costs:
    need = CostRequest(("forward_dynamics", "energy"), Counts.of(8))
    return cost_measurement.measure(load_scene(scene, functions=["default"]), RunOverrides(), need)


@pytest.fixture(scope="module")
def whole(costs) -> Costs:
    """With a bound that is missing, operations and runs, and a name that is no HTML."""
    *others, last = costs.accuracy[0]
    (errors,) = last.errors
    last = replace(last, errors=(replace(errors, bounds=Bounds(math.inf, 1.5, 2, math.inf)),))
    time = Interval(100.0, 90.0, 110.0)
    points = (Point("rk4", "double", 1e-3, 1000, time, 1e-9, "C"),
              Point("rk4", "single", 1e-3, 1000, time, math.inf, "C"))
    return replace(
        costs, scene="</script><b>", accuracy=((*others, last), *costs.accuracy[1:]), runs=True,
        run_errors=RunErrors("rk4", 1e-3, 2.0, (0.5, 1.0), (
            RunError("rounding", "single plain", (1e-7, 1e-6), 1.0),
            RunError("model", "bare", (math.inf, math.inf)),
            RunError("step", "0.001 s", (1e-9, 1e-8))), 5000),
        rows=(Row("all effects", "energy", "3 mul", 3, (time, time)),), points=points,
        reference=ReferenceRun("dop853, rtol 1e-13", 1.0, np.zeros(1), np.zeros(1), 1e-12))


# JSON

def read(costs: Costs, folder: Path) -> dict:
    def refused(name: str):
        raise AssertionError(f"{name} is no JSON")

    cost_json.write(costs, folder / "costs.json", "coscrew cost spring.toml")
    return json.loads((folder / "costs.json").read_text("utf-8"), parse_constant=refused)


def keys(result: object) -> set[str]:
    """All names of fields, but those of a function's inputs."""
    if isinstance(result, list):
        return set().union(*map(keys, result))
    if not isinstance(result, dict):
        return set()
    return set(result).union(*(keys(x) for name, x in result.items() if name != "worst_at"))


def test_json_has_the_figures(whole, tmp_path):
    result = read(whole, tmp_path)
    assert [x["function"] for x in result["functions"]] == ["forward_dynamics", "energy"]
    for function, rows in zip(result["functions"], whole.accuracy, strict=True):
        for choice, row in zip(function["choices"], rows, strict=True):
            (errors,), (of,) = choice["errors"], row.errors
            assert (choice["precision"], choice["tier"]) == (row.precision, row.tier)
            assert (errors["worst"], errors["typical"], errors["unit"]) == (
                of.worst, of.typical, of.unit)
            assert choice["time"] == {"median": row.time.median, "low": row.time.low,
                                      "high": row.time.high}
            assert set(choice["worst_at"]) == set(row.worst_at)
    assert result["functions"][0]["choices"][-1]["errors"][0]["bound"] == {
        "worst": None, "least_ratio": 1.5, "typical_ratio": 2, "worst_ratio": None}
    assert [x["error"] for x in result["runs"]] == [1e-9, None]
    assert [x["best"] for x in result["runs"]] == [True, False]
    assert result["run_errors"]["whole"] is False
    assert result["run_errors"]["rows"] == [
        {"cause": "rounding", "of": "single plain", "errors": [1e-7, 1e-6], "gone": 1.0},
        {"cause": "model", "of": "bare", "errors": [None, None], "gone": None},
        {"cause": "step", "of": "0.001 s", "errors": [1e-9, 1e-8], "gone": None}]


def test_every_field_is_documented(whole, tmp_path):
    text = (ROOT / "docs/accuracy.md").read_text("utf-8")
    listed = text.partition("### Fields of the JSON")[2].partition("\n## ")[0]
    documented = set(re.findall(r"`([a-z_]+)`", listed.replace(".", "` `")))
    assert keys(read(whole, tmp_path)) <= documented


# the page

MARKS = """
    return [...document.querySelectorAll("figure")].flatMap((figure, panel) =>
      [...figure.querySelectorAll("[data-artist]:has(> title):has(use)")].map(mark => {
        const box = mark.querySelector("use").getBoundingClientRect();
        return [panel, mark.dataset.artist, mark.querySelector("title").textContent,
                box.x + box.width / 2, box.y + box.height / 2];
      }));"""


def test_the_page_is_self_contained(whole):
    text = cost_page.page(whole, "coscrew cost spring.toml").html()
    assert not re.search(r"(?:src|href)=\"(?!data:|#)", text)
    assert "://" not in re.sub(r'xmlns(:\w+)?="[^"]*"', "", text)
    assert "<b>" not in text.partition("<body>")[2].partition("<script")[0]
    places = [text.index(x) for x in ("Error against time", "What to choose",
                                      "Errors, bounds and times", "Operations, effects, runs")]
    assert places == sorted(places)


def test_the_page_shows_the_figures_in_a_browser(whole, tmp_path):
    cost_page.write(whole, tmp_path / "costs.html", "coscrew cost spring.toml")
    with chromium() as browser:
        browser.get((tmp_path / "costs.html").as_uri())
        assert not [x for x in browser.get_log("browser") if x["level"] == "SEVERE"]
        marks = browser.execute_script(MARKS)
        rows = browser.execute_script("""
            return [...document.querySelectorAll("tbody tr")].map(row =>
              [...row.children].map(cell => cell.textContent));""")
        curves = dict(browser.execute_script("""
            return [...document.querySelectorAll("[data-artist*=': ']:has(> title)")].map(curve => [
              curve.dataset.artist, curve.querySelector("path").getAttribute("d")]);"""))
        key = browser.execute_script("""
            return [...document.querySelector("figure").querySelectorAll("text")].map(
              x => x.textContent);""")
        cost_page.write(of_units(whole, ("N", 1e-3), ("kg", 0), ("N m", 1e-5)),
                        tmp_path / "units.html",
                        "")
        browser.get((tmp_path / "units.html").as_uri())
        texts = browser.execute_script("""
            return [...document.querySelectorAll("figure")].map(figure =>
              [...figure.querySelectorAll("text")].map(x => x.textContent));""")
    for number, its in enumerate(whole.accuracy):
        of = {name: (title, x, y) for panel, name, title, x, y in marks
              if panel == number and title != "recommended"}
        assert {name: title for name, (title, *_) in of.items()} == {
            f"{x.function} {x.name}": f"{x.name}: {'bound' if x.errors[0].bounds else 'error'} "
            f"{in_unit(shown(x), x.errors[0].unit)}, typically an error of "
            f"{in_unit(x.errors[0].typical, x.errors[0].unit)}, {three_digits(x.time.median)} ns"
            for x in its}
        for a, b in permutations(its, 2):  # to the right is slower, above is less accurate
            (_, ax, ay), (_, bx, by) = (of[f"{x.function} {x.name}"] for x in (a, b))
            assert ax < bx + 0.1 or a.time.median >= b.time.median
            assert ay > by - 0.1 or shown(a) >= shown(b)
    tables = [*(x for rows in whole.accuracy for x in accuracies(rows)), *others(whole)]
    assert rows == [list(row) for x in tables for row in x.rows]
    assert list(curves) == ["rounding: single plain", "model: bare", "step: 0.001 s"]
    heights = [float(y) for name in ("step: 0.001 s", "rounding: single plain")
               for y in re.findall(r"[ML] \S+ (\S+)", curves[name])]
    assert len(heights) == 4
    assert heights == sorted(set(heights), reverse=True)  # 1e-9, 1e-8, 1e-7, 1e-6: upwards
    assert [x for x in key if x in (*TIERS, *BY_NAME, "recommended")] == [
        *TIERS, *BY_NAME, "recommended"]
    assert [[x for x in of if x.startswith("error")] for of in texts[:2]] == [
        ["error, N"], ["error, N m"]]
    for of in texts[:2]:  # of an axis, all numbers are with a power of ten or none
        ticks = [x for x in of if re.fullmatch(r"[\d.]+(e-\d+)?", x) and float(x) < 1]
        assert len(ticks) > 2 and all("e-" in x for x in ticks)


def of_units(costs: Costs, *worst: tuple[str, float]) -> Costs:
    """The first function's choices with errors up to a thousand times as large in these units."""
    rows = [replace(x, errors=tuple(
        replace(x.errors[0], unit=unit, worst=error / 10**(n % 4), bounds=None)
        for unit, error in worst)) for n, x in enumerate(costs.accuracy[0])]
    return replace(costs, accuracy=(tuple(rows),), run_errors=None)


def test_what_cannot_be_written_leaves_the_old_file_whole(whole, tmp_path, monkeypatch):
    path = tmp_path / "costs.json"
    path.write_text("old")
    monkeypatch.setattr("os.replace", lambda *_: (_ for _ in ()).throw(OSError(28, "full")))
    for write in (cost_json.write, cost_page.write):
        with pytest.raises(SimulateError, match="cannot write .*: full"):
            write(whole, path, "")
    assert path.read_text() == "old" and list(tmp_path.iterdir()) == [path]


OVERLAPS = """
    let count = 0;
    const results = [];
    for (const figure of document.querySelectorAll("figure")) {
      const of = selector => [...figure.querySelectorAll(selector)].map(x =>
        [x.textContent, x.getBoundingClientRect()]);
      const labels = of("text").filter(([text]) => /^(needed: )?[\\d.e-]+( .*)?$/.test(text)
        && text.match(/[a-zN]/));
      const marks = [...of("[data-artist] use"), ...of("[data-artist] > path")];
      count += labels.length;
      for (const [i, [text, a]] of labels.entries()) {
        for (const [other, b] of [...marks, ...labels.slice(i + 1)]) {
          if (a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1
              && b.top < a.bottom - 1) results.push([text, other]);
        }
      }
    }
    return [count, results];"""


@pytest.mark.parametrize("width", (390, 1280))
def test_no_label_lies_under_another_mark(costs, tmp_path, width):
    """In the browser's own letters, with seven choices whose marks are close to one another."""
    rows = [replace(x, time=Interval(*(100.0 + 3 * n + d for d in (0, -1, 1))), errors=tuple(
        replace(e, unit="kg m^2/s", worst=10.0**-(9 + n % 3), bounds=None) for e in x.errors))
        for n, x in enumerate((*costs.accuracy[0], costs.accuracy[0][0]))]
    close = replace(costs, accuracy=(tuple(rows), *costs.accuracy))
    cost_page.write(close, tmp_path / "costs.html", "")
    with chromium() as browser:
        browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": 844, "deviceScaleFactor": 1, "mobile": False})
        browser.get((tmp_path / "costs.html").as_uri())
        labels, overlaps = browser.execute_script(OVERLAPS)
    assert labels > 0.7 * sum(map(len, close.accuracy))
    assert not overlaps


# what can be asked for

def test_functions_of_floating_bases_and_of_limits_can_be_asked_for(tmp_path):
    path = tmp_path / "floating.toml"
    path.write_text(FLOATING)
    names = ("with_free_momentum", "closing_contacts")
    scene = read_scene(path)
    need = CostRequest(names, Counts.of(4))
    got = cost_measurement.measure(kernels_for(scene, need.needed(scene, None)), RunOverrides(),
                                   need)
    assert {rows[0].function for rows in got.accuracy} == set(names)
    for rows in got.accuracy:
        for x in rows:
            assert all(e.worst < (1e-5 if x.precision == "single" else 1e-13) for e in x.errors)
            if x.tier == "certified":
                assert all(e.bounds.least_ratio >= 1 or not e.worst for e in x.errors)


def test_the_scene_chooses_the_functions_unless_told(scene):
    plain = read_scene(scene)
    assert CostRequest().of(plain) == ("inverse_dynamics", "forward_dynamics", "mass_matrix",
                                       "body_poses")
    own = replace(plain, functions=("step_rk4", "energy", "body_twists"))
    assert CostRequest().of(own) == ("energy", "body_twists")
    assert CostRequest(("power",)).of(own) == ("power",)
    assert "jacobian_block" in CostRequest(("all",)).of(own)
    assert not any(name.startswith("step_") for name in CostRequest(("all",)).of(own))
    with pytest.raises(FunctionsError, match="did you mean 'energy'"):
        CostRequest(("enregy",)).of(own)
    with pytest.raises(CostError, match="step_rk4: the error of a step"):
        CostRequest(("step_rk4",)).of(own)


def test_all_files_are_of_one_measurement(tmp_path, capsys):
    """With a scene that is quick to derive, at few states."""
    made = {x: tmp_path / f"costs.{x}" for x in ("svg", "json", "html")}
    names = ("inverse_dynamics", "forward_dynamics", "mass_matrix")
    chosen = " ".join(f"--function {x}" for x in names)
    assert main(["cost", str(ROOT / "examples/scenes/pendulum.toml"), *chosen.split(), "--states",
                 "4", "--plot", str(made["svg"]), "--json", str(made["json"]), "--page",
                 str(made["html"])]) == 0
    assert sorted(tmp_path.iterdir()) == sorted(made.values())
    drawn = made["svg"].read_text("utf-8")
    assert all(f'id="{name} {precision} {tier}"' in drawn for name in names
               for precision in BY_NAME for tier in TIERS)
    printed, result = capsys.readouterr().out, json.loads(made["json"].read_text("utf-8"))
    assert result["command"] == (
        f"coscrew cost pendulum.toml {chosen} --states 4")
    for function in result["functions"]:
        for sentence in function["sentences"]:
            assert sentence in " ".join(printed.split())
            assert sentence.replace("'", "&#39;") in made["html"].read_text("utf-8")


def test_the_readme_figure_shows_every_format_and_rival():
    """On this machine and each core; `make figure`, named below it, draws it."""
    readme, makefile = ((ROOT / x).read_text("utf-8") for x in ("README.md", "Makefile"))
    module, file = re.search(r"^figure:.*\n\t\$\(PYTHON\) -m (\S+) [^\t]*\\\n\s+--plot (\S+)$",
                             makefile, re.M).groups()
    assert module == published_bounds.__name__
    assert re.search(rf"\({re.escape(file)}\)\n\n[^\n](?:.+\n)+.*`make figure` draws it", readme)
    drawn = (ROOT / file).read_text("utf-8")
    formats = ("double", "single", "double accurate", "single accurate", "double certified",
               "single certified", "single mixed", "single pairs", "fixed", "fixed (high)")
    for place in ("", " Cortex-M0+", " Cortex-M3", " Cortex-M4F"):
        assert all(f'id="inverse_dynamics {x}{place}"' in drawn for x in formats)
        assert drawn.count('id="RoboPrec') == 12
    assert "prefers-color-scheme: dark" in drawn
