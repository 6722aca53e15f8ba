"""coscrew cost: its comparisons, that it times the scene itself, errors against closed forms."""

import math
import subprocess
from dataclasses import replace
from itertools import pairwise
from xml.etree import ElementTree

import mpmath as mp
import numpy as np
import pytest
from gmpy2 import mpfr
from matplotlib.container import BarContainer
from matplotlib.figure import Figure

from coscrew_codegen import load_scene
from coscrew_codegen.__main__ import main
from coscrew_codegen.backends.scene import scene_c
from coscrew_codegen.backends.scene.scene_text import banner_of
from coscrew_codegen.program.flops import flops
from coscrew_codegen.program.interpreter import evaluate
from coscrew_codegen.program.multiprecise import MULTIPRECISE, precise
from coscrew_codegen.program.values.digits import three_digits
from coscrew_codegen.program.values.formats import DOUBLE, PRECISIONS, SINGLE
from coscrew_codegen.reports.cost import CostError
from coscrew_codegen.reports.cost.cost_measurement import measure
from coscrew_codegen.reports.cost.cost_request import CostRequest
from coscrew_codegen.reports.cost.effect_ablation import SHOWN, parts
from coscrew_codegen.reports.cost.exact_run import exact_end
from coscrew_codegen.reports.cost.figures import cost_page
from coscrew_codegen.reports.cost.figures.cost_figure import _bars, _ends, plot
from coscrew_codegen.reports.cost.figures.cost_page import others
from coscrew_codegen.reports.cost.loops import ELEMENTS, compiled, text
from coscrew_codegen.reports.cost.work_precision import Point, ReferenceRun, error, reference
from coscrew_codegen.reports.timing.intervals import Interval
from coscrew_codegen.runtime import compilation
from coscrew_codegen.scene.integrators import EMITTED
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.simulation.run_summary import RunOverrides
from coscrew_codegen.simulation.system import system
from tests.support.each import each_precision
from tests.support.scenes import scene_texts as texts
from tests.support.scenes.selecting import STEPPED


@pytest.fixture(scope="module")
def kernels(tmp_path_factory):
    folder, result = tmp_path_factory.mktemp("cost"), {}
    for name in ("PENDULUM", "SPRING", "BRICK"):
        path = folder / f"{name.lower()}.toml"
        path.write_text(getattr(texts, name).replace("duration = 10", "duration = 2"))
        result[name] = load_scene(path, functions=STEPPED)
    return result


@pytest.fixture(scope="module")
def few(tmp_path_factory):
    """The spring with few functions, so that their tiers are soon compiled."""
    path = tmp_path_factory.mktemp("few") / "spring.toml"
    path.write_text(texts.SPRING.replace("duration = 10", "duration = 2"))
    return load_scene(path, functions=(*SHOWN, "energy", *STEPPED[1:]))


@pytest.fixture(scope="module")
def costs(few):
    return measure(few, RunOverrides(), CostRequest())


# what is left out

def test_each_effect_is_left_out_once(kernels):
    scene = kernels["SPRING"].scene
    results = {x.words: sorted(a.effect.name for a in x.scene.effects) for x in parts(scene)}
    assert results == {"all effects": ["spring", "viscous"], "without spring": ["viscous"],
                       "without viscous": ["spring"], "bare": []}


def test_what_costs_nothing_is_not_left_out(kernels):
    """Reactions are outputs and do not change the motion."""
    results = {x.words: [a.effect.name for a in x.scene.effects]
               for x in parts(kernels["PENDULUM"].scene)}
    assert results == {"all effects": ["gravity", "reaction"], "bare": ["reaction"]}


def test_operations_are_those_of_the_terms(tmp_path):
    """a = (τ - k q - d v) / m: each effect costs a product and a sum."""
    path = tmp_path / "scene.toml"
    path.write_text(texts.SPRING.replace("d = 1", "d = 3"))  # a factor of 1 costs nothing
    results = {x.words: next(f.program for f in x.public if f.name == "forward_dynamics")
               for x in parts(read_scene(path))}
    counts = {words: flops(program) for words, program in results.items()}
    assert counts["without spring"] == counts["without viscous"] == counts["bare"] + 2
    assert counts["all effects"] == counts["bare"] + 4


# what is timed

@each_precision
@pytest.mark.parametrize("name", ("SPRING", "BRICK"))
def test_the_loops_call_the_scenes_functions(kernels, name, precision):
    """A timed loop computes the functions' values at its inputs, to the last bit."""
    whole = parts(kernels[name].scene)[0]
    library = compiled(whole, whole.public, compilation.compiler())
    its, rng = system(kernels[name], precision.name), np.random.default_rng(1)
    for f in whole.public:
        inputs = [rng.normal(size=(ELEMENTS, *a.quantity.shape)).astype(precision.numpy_type)
                  for a in f.program.inputs]
        inputs = [abs(x) if a.name == "p" else x  # masses
                  for x, a in zip(inputs, f.program.inputs, strict=True)]
        result = getattr(its.kernels, f.name)(*inputs)
        several = result if isinstance(result, tuple) else (result,)
        for made, one in zip(library.values(f.name, precision, inputs), several, strict=True):
            wanted = np.broadcast_to(np.reshape(one, (-1, made.shape[1])), made.shape)
            assert made.tobytes() == np.ascontiguousarray(wanted).tobytes(), f.name


def test_the_loops_compile_without_warnings(kernels, tmp_path):
    for name in kernels:
        whole = parts(kernels[name].scene)[0]
        for file, content in {**scene_c.files(whole.functions, banner_of(name)),
                              "loops.c": text(whole, whole.public)}.items():
            (tmp_path / file).write_text(content)
        flags = ("-std=c11", "-Wall", "-Wextra", "-pedantic", "-Werror", "-fsyntax-only")
        subprocess.run(["cc", *flags, "loops.c"], cwd=tmp_path, check=True)


@pytest.mark.parametrize("integrator", EMITTED, ids=lambda x: x.name)
@pytest.mark.parametrize("precision", (DOUBLE, SINGLE), ids=lambda x: x.name)
def test_runs_in_c_are_the_steps_of_the_kernels(kernels, precision, integrator):
    whole = parts(kernels["BRICK"].scene)[0]
    its = system(kernels["BRICK"], precision.name)
    library = compiled(whole, whole.public, compilation.compiler())
    step = next(x for x in whole.functions.steps if x.name == integrator.step_name)
    q, v, seconds = library.run(step, precision, 50, 1e-3, its.p, its.start())
    wanted = its.stepper(step.name)(50, 0.0, 1e-3, *its.start())
    assert (q.tobytes(), v.tobytes()) == (wanted[0].tobytes(), wanted[1].tobytes())
    assert seconds > 0


def test_every_function_and_part_has_a_row(costs, few):
    public = [f.name for f in few.functions.functions if not f.internal]
    assert [x.function for x in costs.rows if x.part == "all effects"] == public
    for words in ("without spring", "without viscous", "bare"):
        assert [x.function for x in costs.rows if x.part == words] == [
            name for name in public if name in SHOWN]
    for row in costs.rows:
        assert all(0 < t.low <= t.median <= t.high < 1e6 for t in row.times), row


# errors against time

def test_references_are_the_closed_form(kernels):
    its = system(kernels["SPRING"], "double")
    wanted = [float(x) for x in texts.spring(2)]
    for digits, allowed in ((None, 1e-12), (30, 1e-16)):
        truth = reference(its, 2.0, digits)
        assert abs(truth.q[0] - wanted[0]) <= max(allowed, truth.error)
        assert abs(truth.v[0] - wanted[1]) <= 10 * max(allowed, truth.error)


def test_the_exact_run_of_a_pendulum_is_elliptic(kernels):
    q, v, apart = exact_end(system(kernels["PENDULUM"], "double"), 2.0, 30)
    wanted = texts.pendulum(2)
    assert abs(q[0] - float(wanted[0])) <= 2.0**-52
    assert abs(v[0] - float(wanted[1])) <= 2.0**-50
    assert apart <= 2.0**-52


def test_the_exact_run_of_a_free_body_is_dop853s(kernels):
    """DOP853 runs another program, with other formulas for the rates of change."""
    its = system(kernels["BRICK"], "double")
    q, v, _ = exact_end(its, 1.0, 20)
    other = reference(its, 1.0, None)
    assert error(its, q, other) < 1e-12
    assert np.abs(v - other.v).max() < 1e-11


def test_programs_are_evaluated_with_all_digits(kernels):
    its = system(kernels["PENDULUM"], "double")
    forward = its.programs["forward_dynamics"]
    with precise(60), mp.workdps(60):
        given = {"q": [mpfr(1) / 3], "v": [mpfr(2)], "tau": [mpfr(0)]}
        (a,) = evaluate(forward, [given[x.name] for x in forward.inputs], MULTIPRECISE)
        assert abs(mp.mpf(str(a)) + mp.mpf("9.81") * mp.sin(mp.mpf(1) / 3)) < mp.mpf(10)**-58


def test_scenes_that_are_not_smooth_have_no_exact_run(tmp_path):
    path = tmp_path / "scene.toml"
    path.write_text(texts.SPRING + """
[effects.coulomb.slide]
tau_c = 1
eps = 1e-9
""")
    with pytest.raises(CostError, match="--digits is for smooth scenes"):
        exact_end(system(load_scene(path, functions=STEPPED), "double"), 2.0, 20)


def test_the_sign_of_a_quaternion_is_no_error(kernels):
    its = system(kernels["BRICK"], "double")
    q = np.array([1.0, 2, 3, 0.5, -0.5, 0.5, 0.5])
    truth = ReferenceRun("", 1.0, q, np.zeros(6), 0.0)
    assert error(its, q * [1, 1, 1, -1, -1, -1, -1], truth) == 0
    assert error(its, q + [0, 0.25, 0, 0, 0, 0, 0], truth) == 0.25
    assert error(its, q * np.nan, truth) == math.inf


@pytest.mark.parametrize("integrator, order", (("semi-implicit-euler", 1), ("rk4", 4)))
def test_errors_of_runs_have_the_integrators_order(costs, integrator, order):
    results = [(x.step, x.error) for x in costs.points
               if (x.integrator, x.precision) == (integrator, "double") and x.error > 1e-11]
    assert len(results) >= 2
    slopes = [math.log(a[1] / b[1]) / math.log(a[0] / b[0]) for a, b in pairwise(results)]
    assert slopes[-1] == pytest.approx(order, abs=0.2)


def test_single_precision_is_no_more_accurate_than_it_can_be(costs):
    results = [x.error for x in costs.points if (x.integrator, x.precision) == ("rk4", "single")]
    assert min(results) > 2.0**-24 * 1e-3
    assert min(x.error for x in costs.points if x.precision == "double") < 1e-12


# what is shown

def test_the_table_holds_what_was_measured(costs):
    text = cost_page.page(costs, "").text()
    for row in costs.rows:
        assert row.function in text and row.part in text
    for point in costs.points:
        assert three_digits(point.error) in text
    assert text.count("*") >= 2
    shown = {x.headers[0]: [row[0] for row in x.rows] for x in others(costs)}
    assert "mass_matrix" not in shown  # no effect changes its operations
    assert shown["forward_dynamics"] == ["all effects", "without spring", "without viscous", "bare"]
    for row in costs.run_errors.rows:
        assert f"{row.cause}: {row.of} " in text


def test_the_figure_holds_a_bar_for_each_part_and_a_curve_for_each_integrator(costs, tmp_path):
    plot(costs, tmp_path / "costs.svg")
    root = ElementTree.parse(tmp_path / "costs.svg").getroot()
    ids = [x.get("id") for x in root.iter() if x.get("id")]
    drawn = {f"{x.integrator} {x.precision}" for x in costs.points}
    assert drawn <= set(ids)
    axes = Figure().subplots()
    _bars(axes, costs)
    rows = [x for x in costs.rows if x.function == "forward_dynamics"]
    bars = [bar for x in axes.containers if isinstance(x, BarContainer) for bar in x]
    assert [x.get_width() for x in bars] == [x.times[i].median for i, _ in enumerate(PRECISIONS)
                                             for x in rows]
    causes = {f"{x.cause}: {x.of}" for x in costs.run_errors.rows}
    assert len(causes) > 6 and causes <= set(ids)


def point(integrator: str, seconds: float, error: float) -> Point:
    time = Interval(seconds, 0.8 * seconds, 1.2 * seconds)
    return Point(integrator, "double", 1e-3, 100, time, error, "C")


@pytest.fixture
def rough(costs):
    """Costs whose reference is accurate to 1e-9; two of four runs are more accurate than that."""
    truth = replace(costs.reference, error=1e-9)
    return replace(costs, accuracy=(), reference=truth, points=(
        point("rk4", 1e-5, 1e-6), point("rk4", 2e-5, 3e-10), point("rk4", 4e-5, 2e-11),
        point("dop853", 1e-4, 1e-7)))


def test_runs_better_than_the_reference_are_not_called_best(rough):
    rows = [x.split() for x in cost_page.page(rough, "").text().splitlines()
            if x.startswith(("rk4 ", "dop853 "))]
    assert [x[7:] for x in rows] == [["*"], ["<"], ["<"], []]


def test_a_run_is_best_unless_another_ones_interval_lies_below(rough):
    """At 1.1 times the time the intervals overlap, and no run is called best."""
    near = replace(rough, points=(point("rk4", 1e-5, 1e-6), point("rk4", 1.1e-5, 1e-6),
                                  point("rk4", 1.6e-5, 1e-6)))
    marks = [x.split()[7:] for x in cost_page.page(near, "").text().splitlines()
             if x.startswith("rk4 ")]
    assert marks == [["*"], ["*"], []]


def test_runs_better_than_the_reference_are_hollow(rough, tmp_path):
    plot(rough, tmp_path / "costs.svg")
    root = ElementTree.parse(tmp_path / "costs.svg").getroot()
    groups = {x.get("id"): x for x in root.iter() if x.get("id")}
    fills = {name: next(y.get("style") for y in groups[name].iter() if y.tag.endswith("}use"))
             for name in (f"{x.integrator} double {x.error:g}" for x in rough.points)}
    assert [name for name, style in fills.items() if "fill: #ffffff" in style] == [
        "rk4 double 3e-10", "rk4 double 2e-11"]
    assert {f"{name} interval" for name in fills} <= set(groups)
    assert "reference" in groups


def test_the_legend_covers_no_curve(rough):
    figure = Figure(figsize=(13, 4.6), layout="constrained")
    axes = figure.subplots()
    _ends(axes, rough)
    figure.draw_without_rendering()
    legend, panel = axes.get_legend().get_window_extent(), axes.get_window_extent()
    assert legend.y1 <= panel.y0
    assert legend.y0 >= figure.bbox.y0


def test_the_legend_covers_no_bar(costs):
    figure = Figure(figsize=(5, 4.6), layout="constrained")
    axes = figure.subplots()
    _bars(axes, costs)
    figure.draw_without_rendering()
    assert axes.get_legend().get_window_extent().y1 <= axes.get_window_extent().y0


def test_the_command_prints_and_draws(tmp_path, capsys):
    path = tmp_path / "scene.toml"
    path.write_text(texts.SPRING)
    assert main(["cost", str(path), "--until", "0.5", "--plot", str(tmp_path / "out.png")]) == 0
    out = capsys.readouterr().out
    assert "without viscous" in out and "dop853" in out
    assert (tmp_path / "out.png").read_bytes().startswith(b"\x89PNG")


def test_without_a_compiler_there_is_nothing_to_time(tmp_path, capsys, monkeypatch):
    monkeypatch.setenv("CC", "no-such-compiler")
    path = tmp_path / "scene.toml"
    path.write_text(texts.SPRING)
    with pytest.warns(RuntimeWarning, match="pure NumPy"):
        assert main(["cost", str(path)]) == 2
    assert "cannot be compiled: no C compiler" in capsys.readouterr().err
