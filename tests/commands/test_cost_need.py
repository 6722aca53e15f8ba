"""coscrew cost --need: the cheapest tier and precision that suffices, here and on a Cortex-M4F,
with its proof, bound or search; requests that cannot be understood."""

import json
import os
import re
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import mpmath as mp
import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.__main__ import main
from coscrew_codegen.backends.html import plots
from coscrew_codegen.program.values.formats import BY_NAME
from coscrew_codegen.reports.cost import cost_json, cost_measurement
from coscrew_codegen.reports.cost.cost_measurement import Costs
from coscrew_codegen.reports.cost.cost_request import CostRequest
from coscrew_codegen.reports.cost.effect_ablation import WHOLE, part
from coscrew_codegen.reports.cost.figures import cost_figure, cost_page
from coscrew_codegen.reports.cost.function_errors import ErrorStatistics, FunctionErrors
from coscrew_codegen.reports.cost.loops import CompiledLoops
from coscrew_codegen.reports.cost.measured import Counts, TierChoice
from coscrew_codegen.reports.cost.needs import cortex_m4, need_table
from coscrew_codegen.reports.cost.needs.answers import (
    BOUNDED,
    PROVED,
    SEARCHED,
    Answer,
    Sufficient,
)
from coscrew_codegen.reports.cost.needs.m4_functions import FunctionOnM4
from coscrew_codegen.reports.cost.needs.need import Need, read
from coscrew_codegen.reports.timing.intervals import Interval
from coscrew_codegen.reports.timing.machine_load import Load, LoadWatch
from coscrew_codegen.runtime.load import kernels_for
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.simulation.run_summary import RunOverrides
from tests.support.processor_time import spent

ROOT = Path(__file__).parents[2]
ARM = """
[bodies]
upper = { mass = 2.3, com = [0.01, 0.02, -0.25], inertia = [0.041, 0.042, 0.0023] }
lower = { mass = 1.1, com = [0, 0.03, -0.2], inertia = [0.0117, 0.0121, 0.0012] }
[joints.shoulder]
type = "revolute"
child = "upper"
axis = [0, 1, 0]
limits = { lower = -1.7, upper = 2.1, velocity = 2.5, effort = 60 }
[joints.elbow]
type = "revolute"
parent = "upper"
child = "lower"
axis = [1, 0, 0]
origin = { xyz = [0, 0, -0.5] }
limits = { lower = -1.2, upper = 1.4, velocity = 3.5, effort = 20 }
[effects.gravity]
[run]
duration = 0.1
step = 1e-3
"""
ERRORS = ErrorStatistics("N m", 3e-6, 1e-5, 8, 7, 100, "search", None)
NEEDS = (Need("inverse_dynamics", 1e-4), Need("forward_dynamics", 1e-3),
         Need("body_poses", 1e-6, "m"), Need("body_poses", 1e-6, "1"))


@pytest.fixture(scope="module")
def scene(tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("need") / "arm.toml"
    path.write_text(ARM)
    return path


@pytest.fixture(scope="module")
def costs(scene) -> Costs:
    return measured(scene, *NEEDS)


def measured(scene: Path, *needs: Need) -> Costs:
    whole = replace(read_scene(scene), precision="both", precisions=("double", "single"))
    request = CostRequest(counts=Counts.of(12), needs=needs)
    return cost_measurement.measure(kernels_for(whole, request.needed(whole, None)), RunOverrides(),
                                    request)


def of(costs: Costs, function: str) -> Answer:
    return next(x for x in costs.answers if x.function == function)


# answers

def test_the_cheapest_choice_that_suffices_is_named(costs):
    """Compared with all choices: none that meets the request is faster, or takes fewer
    instructions."""
    for reply in costs.answers:
        rows = next(x for x in costs.accuracy if x[0].function == reply.function)
        meet = [x for x in rows if all(
            e.worst <= need.within for e in x.errors for need in reply.needs
            if need.unit in ("", e.unit)) and all(
            e.bounds is None or e.bounds.worst <= need.within for e in x.errors
            for need in reply.needs if need.unit in ("", e.unit))]
        assert {x.row.name for x in reply.candidates} == {x.name for x in meet}
        assert reply.here[0].row.time.median == min(x.time.median for x in meet)
        least = min(x.instructions for x in reply.candidates)
        assert reply.on_cortex_m4[0].instructions == least and reply.on_cortex_m4[0].counted
        for named in (reply.here, reply.on_cortex_m4):
            sure = [x.sureness for x in named]
            assert sure == sorted(set(sure))
    assert of(costs, "inverse_dynamics").on_cortex_m4[0].row.name == "single plain"


def test_what_divides_is_bound_at_states_and_what_does_not_is_proved(costs):
    sureness = {name: {x.row.name: x.sureness for x in of(costs, name).candidates}
                for name in ("inverse_dynamics", "forward_dynamics")}
    assert sureness["inverse_dynamics"]["double plain"] == PROVED
    assert sureness["inverse_dynamics"]["single accurate"] == PROVED
    assert sureness["inverse_dynamics"]["double accurate"] == SEARCHED
    assert sureness["forward_dynamics"]["double plain"] == SEARCHED
    assert sureness["forward_dynamics"]["double certified"] == BOUNDED


def test_no_error_exceeds_what_is_proved(costs, scene):
    """Poses of the second body in closed form, with 50 digits, at random states and at corners of
    the ranges; the bound is at most 100 times the worst error."""
    scene_ = load_scene(scene, functions=["body_poses"], tiers=["accurate"])
    rng = np.random.default_rng(5)
    ends = np.array([[-1.7, 2.1], [-1.2, 1.4]])
    corners = np.array(np.meshgrid(*ends)).reshape(2, -1).T
    q = np.concatenate([corners, rng.uniform(*ends.T, (400, 2))]).astype(np.float32)
    for name, function in (("single plain", scene_.single.body_poses),
                           ("single accurate", scene_.accurate.single.body_poses),
                           ("double plain", scene_.double.body_poses)):
        (x,) = (x for x in of(costs, "body_poses").candidates if x.row.name == name)
        assert x.sureness == PROVED
        kind = np.float32 if "single" in name else float
        results = np.asarray(function(q.astype(kind)), float)[:, 1]
        worst = {"1": 0.0, "m": 0.0}
        for (shoulder, elbow), pose in zip(q.tolist(), results, strict=True):
            with mp.workdps(50):
                s, c, u, w = mp.sin(shoulder), mp.cos(shoulder), mp.sin(elbow), mp.cos(elbow)
                true = mp.matrix([[c, s * u, s * w, -s / 2], [0, w, -u, 0],
                                  [-s, c * u, c * w, -c / 2]])
                for i in range(3):
                    for j in range(4):
                        unit = "m" if j == 3 else "1"
                        off = float(abs(mp.mpf(float(pose[i, j])) - true[i, j]))
                        worst[unit] = max(worst[unit], off)
        for unit, bound in x.errors.items():
            assert 0 < worst[unit] <= bound <= 100 * worst[unit], (name, unit)


def candidate(name: str, ns: float, sureness: int, instructions: int, emitted: bool = True
              ) -> Sufficient:
    precision, tier = name.split()
    row = FunctionErrors("f", tier, precision, 64, Interval(ns, ns, ns), (ERRORS,), {},
                         emitted)
    return Sufficient(row, sureness, {"N m": 1e-5}, instructions)


def test_surer_choices_stand_below_the_cheapest():
    reply = Answer("f", (Need("f", 1e-3),), ("N m",), (
        candidate("single plain", 90, SEARCHED, 100), candidate("double plain", 100, PROVED, 9000),
        candidate("single certified", 150, BOUNDED, 5000),
        candidate("double accurate", 400, SEARCHED, 90000)), "without qemu-arm")
    assert [x.row.name for x in reply.here] == ["single plain", "double plain"]
    assert [x.row.name for x in reply.on_cortex_m4] == [
        "single plain", "single certified", "double plain"]
    table = need_table.table((reply,))
    assert table.rows[0] == ("f within 0.001 N m", "this machine", "single plain", "90 ns",
                             "found by search", "10 µN m")
    assert [x[3] for x in table.rows[2:]] == [
        "about 100 instructions", "about 5,000 instructions", "about 9,000 instructions"]
    assert table.notes[0].endswith("Instructions are estimated from operations, without qemu-arm.")


def test_what_no_choice_meets_is_said_so():
    none = Answer("f", (Need("f", 1e-30),), ("N m",), ())
    assert need_table.table((none,)).rows == (
        ("f within 1e-30 N m", "", "no tier and precision", "", "", ""),)
    other = Answer("f", (Need("f", 1e-3),), ("N m",), (
        candidate("double plain", 90, SEARCHED, 100, emitted=False),))
    first, second = need_table.table((other,)).rows
    assert first[2] == "none of the scene's precision; double plain would"
    assert second[1] == "Cortex-M4F"


# instructions

def test_estimates_of_instructions_are_near_the_counts(costs, scene):
    """Within a fourth of the counts, of single precision and of double in software."""
    name = "forward_dynamics"
    whole = replace(read_scene(scene), precision="both", precisions=("double", "single"))
    alone = part(WHOLE, whole, (name,))
    tiers = cost_measurement._tiers(alone, (name,), all_of_them=True)
    on_m4 = FunctionOnM4(CompiledLoops(alone, None, tiers), name)
    for x in of(costs, name).candidates:
        if x.row.name in ("single plain", "single pairs", "double plain", "single accurate"):
            choice = TierChoice(x.row.tier, BY_NAME[x.row.precision])
            count = on_m4.counted(choice, [*x.row.worst_at.values()])
            assert x.instructions == count or not x.counted
            assert count / 1.25 < on_m4.estimated(choice) < 1.25 * count, x.row.name


def test_without_a_compiler_instructions_are_estimated(scene, monkeypatch):
    monkeypatch.setattr(cortex_m4, "COMPILER", ("no-such-compiler",))
    (reply,) = measured(scene, Need("energy", 1e-3)).answers
    assert reply.candidates and not any(x.counted for x in reply.candidates)
    assert reply.uncounted == "without no-such-compiler"


def test_where_the_compiler_fails_its_message_is_shown(scene, monkeypatch):
    monkeypatch.setattr(cortex_m4, "COMPILER", (*cortex_m4.COMPILER, "--no-such-flag"))
    (reply,) = measured(scene, Need("energy", 1e-3)).answers
    assert not any(x.counted for x in reply.candidates)
    assert re.match(r"since arm-none-eabi-gcc fails: .*--no-such-flag", reply.uncounted)


# requests

@pytest.mark.parametrize("text, need", (
    ("inverse_dynamics=1e-3", Need("inverse_dynamics", 1e-3)),
    (" body_poses = 2e-6 m ", Need("body_poses", 2e-6, "m")),
    ("forward_dynamics=0.1 rad/s²", Need("forward_dynamics", 0.1, "rad/s²"))))
def test_requests_are_read(text, need):
    assert read(text) == need


@pytest.mark.parametrize("text", (
    "inverse_dynamics", "=1e-3", "energy=", "energy=0", "energy=-1", "energy=nan", "energy=inf",
    "energy=1e-3N", "energy 1e-3"))
def test_requests_that_are_none_are_refused(text, scene, capsys):
    with pytest.raises(SystemExit):
        main(["cost", str(scene), "--need", text])
    message = capsys.readouterr().err
    assert "wanted FUNCTION=NUMBER, as inverse_dynamics=1e-3" in message and repr(text) in message


@pytest.mark.parametrize("text, words", (
    ("enrgy=1e-3", "--need enrgy=0.001: 'enrgy' is no function of this scene; did you mean "
                   "'energy'?"),
    ("jacobian_*=1e-3", "'jacobian_*' is no function of this scene"),
    ("all=1e-3", "'all' is no function of this scene"),
    ("inverse_dynamics=1 mN m", "--need inverse_dynamics=1 mN m: inverse_dynamics has no result in "
                                "'mN m'; did you mean 'N m'?"),
    ("body_poses=1e-3 rad", "body_poses has no result in 'rad'; wanted one of 1, m"),
    ("step_rk4=1e-3", "step_rk4: the error of a step")))
def test_names_and_units_that_are_not_there_are_refused(text, words, scene, capsys):
    assert main(["cost", str(scene), "--need", text]) == 2
    assert words in capsys.readouterr().err


# the load, the files

@pytest.mark.parametrize("load, loaded", (
    (Load(0.99, 0.4, 8), False), (Load(0.5, 0.4, 8), True), (Load(0.99, 9.5, 8), True),
    (Load(1.0, None, 2), False)))
def test_the_load_is_stated(load, loaded):
    assert ("it was loaded" in str(load)) == loaded
    assert f"{100 * load.share:.0f} % of a processor" in str(load)


def test_the_load_is_measured():
    watch = LoadWatch()
    with watch.timing():
        time.sleep(0.2)
    assert watch.load and watch.load.share < 0.5


def test_the_page_and_the_figure_show_the_line(costs, tmp_path):
    page = cost_page.page(costs, "coscrew cost arm.toml")
    text = page.html()
    assert text.index("What suffices</h2>") < text.index("<figure>")
    cost_figure.plot(costs, tmp_path / "costs.svg")
    drawn = (tmp_path / "costs.svg").read_text()
    for need in NEEDS:
        assert f'id="{need} line"' in drawn
        assert f"needed: {need.within:g}" in text
    (axes,) = (x for x in plots.drawn((*cost_figure.functions(costs),)).axes
               if x.get_title("left") == "inverse_dynamics")
    (line,) = (x for x in axes.lines if str(x.get_gid()).endswith("line"))
    assert [*line.get_ydata()] == [1e-4, 1e-4]
    low, high = axes.get_ylim()
    assert low < 1e-4 < high


def test_json_has_the_answers(costs):
    result = cost_json.data(costs, "")
    assert [x["function"] for x in result["needs"]] == [x.function for x in costs.answers]
    first = result["needs"][0]
    assert first["within"] == [{"number": 1e-4, "unit": None}]
    assert first["here"][0]["sureness"] in ("search", "bound", "proof")
    assert 0 < result["load"]["share"] <= 1
    json.dumps(result, default=str)


def test_a_seven_joint_arm_takes_less_than_a_minute_of_processor_time(tmp_path):
    """All of it, compiled anew."""
    before = spent()
    subprocess.run([sys.executable, "-m", "coscrew_codegen", "cost",
                    str(ROOT / "examples/cost/panda.toml"), "--need", "inverse_dynamics=1e-3"],
                   check=True, capture_output=True,
                   env={**os.environ, "XDG_CACHE_HOME": str(tmp_path)})
    assert (spent() - before).total < 60
