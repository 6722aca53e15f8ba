"""`coscrew sweep`: varied quantities, the values of members, refusals, chunks; without workers."""

import argparse
import itertools
import tracemalloc
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pyarrow
import pytest
from mpmath import mp
from scipy.stats import qmc

from coscrew_codegen.__main__ import main
from coscrew_codegen.simulation.check.uniform_rotations import quaternions
from coscrew_codegen.simulation.run import integrate
from coscrew_codegen.simulation.run_summary import RunOverrides
from coscrew_codegen.simulation.sweep import (
    SweepError,
    chunk,
    member_summary,
    member_values,
    sweep_options,
)
from coscrew_codegen.simulation.sweep.files.folder import Folder
from coscrew_codegen.simulation.sweep.specification import Varied
from coscrew_codegen.simulation.system import system
from tests.support.scenes import scene_texts as texts
from tests.support.scenes.simulated import scene_file
from tests.support.scenes.sweeps import BALL, SLIDER, prepared, table

MASSES = "block.mass=1:7:3"


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    return tmp_path_factory.mktemp("sweep")


def values(varied: Varied, first: int = 0, last: int | None = None) -> np.ndarray:
    return member_values.values(varied, range(first, varied.members if last is None else last))


# What varies

def test_points_of_grids_are_the_decimals_that_one_writes(folder):
    its = prepared(folder, SLIDER, ("block.mass=0.1:1.1:11", "start.v.slide=1:16:5:log"))
    masses, speeds = (x.values for x in its.specification.varied.grids)
    assert masses == (0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1)
    assert speeds == (1, 2, 4, 8, 16)


def test_samples_are_those_of_the_sequence_at_each_point_of_the_grids(folder):
    its = prepared(folder, SLIDER, ("block.mass=1:7:3", "start.v.swivel=5:4:2"),
                   ("start.q.s*=-1:3", "block.inertia.xx=0.125:2:log"), 32, seed=7)
    with np.errstate(all="raise"):
        result = values(its.specification.varied)
    sequence = qmc.Sobol(3, scramble=True, bits=32, rng=np.random.default_rng(7)).random(32)
    wanted = [(*point, *(-1 + 4 * u[:2]), 16**u[2] / 8) for u in sequence
              for point in itertools.product((1, 4, 7), (5, 4))]
    assert [x.name for x in its.specification.varied.columns] == [
        "block.mass", "start.v.swivel", "start.q.slide", "start.q.swivel", "block.inertia.xx"]
    assert np.array_equal(result[:, :4], np.array(wanted)[:, :4])
    assert np.allclose(result[:, 4], np.array(wanted)[:, 4], rtol=4e-16, atol=0)


def test_values_of_a_member_depend_on_its_number_alone(folder):
    varied = prepared(folder, SLIDER, (MASSES, "start.v.slide=0:1:2"), ("start.q.s*=-1:3",),
                      100, seed=3).specification.varied
    whole = values(varied)
    for first, last in ((0, 1), (5, 6), (7, 23), (64, 128), (599, 600)):
        assert values(varied, first, last).tobytes() == whole[first:last].tobytes()
    assert values(replace(varied, seed=4)).tobytes() != whole.tobytes()


def test_rotations_are_uniform():
    """Averages of products of a rotation's components, by rules that are exact for those of degree
    4 (two Gauss points, 8 x 8 equal angles), are those over all rotations: <x^2> = 1/4, <x^4> =
    1/8, <x^2 y^2> = 1/24, others 0, within some roundings of numbers below 1."""
    radii, angles = (1 + np.array([-1, 1]) / np.sqrt(3)) / 2, np.arange(8) / 8
    q = quaternions(np.stack(np.meshgrid(radii, angles, angles), -1).reshape(-1, 3))
    for degree in range(1, 5):
        for places in itertools.combinations_with_replacement(range(4), degree):
            powers = tuple(sorted((places.count(i) for i in set(places)), reverse=True))
            wanted = {(2,): 1 / 4, (4,): 1 / 8, (2, 2): 1 / 24}.get(powers, 0)
            assert abs(q[:, places].prod(1).mean() - wanted) < 2**-51, places


def test_rotations_are_those_of_three_numbers_of_the_sequence(folder):
    its = prepared(folder, BALL, (), ("start.q.*=uniform", "start.v.socket.1=-1:1"), 8, seed=3)
    names = [x.name for x in its.specification.varied.columns]
    assert names == [*(f"start.q.{joint}.uniform.{k}" for joint in ("base", "socket")
                       for k in range(3)), "start.v.socket.1"]
    result = values(its.specification.varied)
    sequence = qmc.Sobol(7, scramble=True, bits=32, rng=np.random.default_rng(3)).random(8)
    assert np.array_equal(result[:, :6], sequence[:, :6])
    starts = chunk.states(its.kernels, its.specification, result)
    for n, places in enumerate((slice(3, 7), slice(7, 11))):
        for u, q in zip(sequence[:, 3 * n:3 * n + 3].tolist(), starts["q"][:, places].tolist(),
                        strict=True):
            with mp.workdps(50):
                r, s, a, b = mp.sqrt(1 - u[0]), mp.sqrt(u[0]), 2 * u[1], 2 * u[2]
                exact = (r * mp.sinpi(a), r * mp.cospi(a), s * mp.sinpi(b), s * mp.cospi(b))
            assert all(abs(x - y) < 2**-49 for x, y in zip(q, exact, strict=True))
    assert not starts["q"][:, :3].any()


def test_limits_are_those_of_the_limit_effect_or_else_of_the_model(folder):
    def ends(text: str, pattern: str) -> dict[str, tuple[float, float]]:
        return prepared(folder, text, (), (f"{pattern}=limits",), 1).specification.varied.ends

    assert ends(SLIDER, "start.?.slide") == {"start.q.slide": (-20, 200), "start.v.slide": (-3, 3)}
    model = SLIDER.replace("lower = -20\nupper = 200\n", "")
    assert ends(model, "start.q.slide") == {"start.q.slide": (-1, 2)}


def test_a_sweep_is_known_by_all_that_its_results_depend_on(folder):
    def known(text: str = SLIDER, sobols: tuple[str, ...] = ("start.q.s*=-1:3",), **others) -> str:
        given = {"samples": 8, "seed": 0} | others
        return prepared(folder, text, (MASSES,), sobols, **given).specification.sha256

    others = (known(SLIDER.replace("3, 0, 0", "4, 0, 0")), known(sobols=("start.q.s*=-1:4",)),
              known(samples=9), known(seed=1), known(record=("v",)), known(series=True),
              known(overrides=RunOverrides(until=2.0)), known(overrides=RunOverrides(step=0.01)),
              known(overrides=RunOverrides(integrator="leapfrog")),
              known(overrides=RunOverrides(precision="single")),
              known(overrides=RunOverrides(settings=(("block.inertia.xy", 0.1),))))
    assert len({known(), *others}) == 1 + len(others)
    assert known() == known()


# Refusals, before anything starts

@pytest.mark.parametrize(("words", "message"), (
    ("", "nothing varies; wanted --grid NAME=FROM:TO:COUNT or --sobol"),
    ("--grid block.mas=1:2:3", "did you mean 'block.mass'?"),
    ("--grid needle.mass=1:2:3", 'runtime = ["block.mass", "block.inertia.xx"'),
    ("--sobol needle.*=1:2 --samples 4", '"needle.mass", "needle.com.x"'),
    ("--sobol wrench.*=1:2 --samples 4", '"wrench.block.force.x"'),
    ("--sobol nothing*=1:2 --samples 4", "matches nothing; wanted one of block.inertia.xx"),
    ("--sobol start.q.*=limits --samples 4", "start.q.swivel: its joint has no range with two"),
    ("--sobol start.v.*=limits --samples 4", "start.v.swivel: its joint has no velocity limit"),
    ("--sobol block.mass=limits --samples 4", "block.mass: a parameter has no limits"),
    ("--sobol start.q.*=uniform --samples 4", "matches no start of a joint with a quaternion; "
     "there are none"),
    ("--sobol block.mass=1:2", "--sobol wants --samples N"),
    ("--grid block.mass=1:2:3 --samples 4", "--samples and --seed want --sobol"),
    ("--grid block.mass=1:2:3 --seed 4", "--samples and --seed want --sobol"),
    ("--grid block.mass=1:2:3 --sobol block.*=1:2 --samples 4", "varies by two options"),
    ("--grid block.mass=1:2:3 --set block.mass=1", "--set block.mass: it varies"),
    ("--grid block.mass=1:2:3 --set block.mas=1", "wanted a parameter that the scene lists"),
    ("--grid start.q.slide=0:1e39:3 --precision single", "1e+39 overflows in single precision"),
    ("--grid block.mass=-1:2:3", "ranges: block.mass=-1: wanted a positive number"),
    ("--sobol block.mass=1:2 --sobol block.inertia.xx=1:2.5 --samples 4", "block.inertia.xx=2.5"),
    ("--grid block.mass=1:2:3 --record q.slid", "did you mean 'slide'?"),
    ("--grid block.mass=1:2:3 --until 0", "wanted a positive number of seconds"),
    ("--grid block.mass=1:2:3 --integrator dop853", "a sweep wants an emitted one"),
    ("--grid block.mass=1:2:3 --integrator rk5", "did you mean 'rk4'?"),
    ("--grid block.mass=1:2:3 --precision both", "a sweep runs in one; wanted double or single"),
    ("--grid block.mass=1:2:3 --workers 1 --scheduler tcp://x:1", "wanted one of the two"),
))
def test_what_is_wrong_is_refused_and_nothing_is_made(words, message, tmp_path, capsys):
    command = ["sweep", str(scene_file(tmp_path, SLIDER)), *words.split()]
    try:
        status = main([*command, "--out", str(tmp_path / "out")])
    except SystemExit as usage:
        status = usage.code
    assert status == 2
    assert message in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(("pattern", "message"), (
    ("start.q.socket", "components of a quaternion"),
    ("start.q.socket.*", "components of a quaternion"),
    ("start.q.base.5", "components of a quaternion")))
def test_components_of_quaternions_do_not_vary(pattern, message, folder):
    with pytest.raises(SweepError, match=message):
        prepared(folder, BALL, (), (f"{pattern}=0:1",), 4)


@pytest.mark.parametrize(("parse", "text", "message"), (
    (sweep_options.grid, "block.mass", "wanted NAME=FROM:TO:COUNT"),
    (sweep_options.grid, "block.mass=1:2", "wanted FROM:TO:COUNT or FROM:TO:COUNT:log; got '1:2'"),
    (sweep_options.grid, "block.mass=1:2:3:lin", "got '1:2:3:lin'"),
    (sweep_options.grid, "block.mass=1:2:2.5", "wanted a whole number, 1 to 1000000; got '2.5'"),
    (sweep_options.grid, "block.mass=1:2:0", "wanted a whole number, 1 to 1000000; got '0'"),
    (sweep_options.grid, "block.mass=1:2:1e7", "1 to 1000000; got '1e7'"),
    (sweep_options.grid, f"block.mass=1:1.{'0' * 30}1:3", "wanted 1 if both ends are the same"),
    (sweep_options.grid, "block.mass=1:2:1", "wanted 1 if both ends are the same"),
    (sweep_options.grid, "block.mass=1:1:2", "wanted 1 if both ends are the same"),
    (sweep_options.grid, "block.mass=x:1:2", "'x' is no number"),
    (sweep_options.grid, "block.mass=1:inf:2", "inf is not finite"),
    (sweep_options.grid, "block.mass=0:1:2:log", "log wants positive ends"),
    (sweep_options.sobol, "start.q.*=1", "wanted LOW:HIGH"),
    (sweep_options.sobol, "start.q.*=2:1", "wanted LOW below HIGH; got 2 and 1"),
    (sweep_options.sobol, "=2:1", "wanted PATTERN=LOW:HIGH"),
    (sweep_options.samples, "1.5", "wanted a whole number, 1 to 4294967296; got '1.5'"),
    (sweep_options.samples, "1e10", "wanted a whole number, 1 to 4294967296; got '1e10'"),
    (sweep_options.samples, "1e9999", "got '1e9999'"),
    (sweep_options.seed, "-1", "wanted a whole number, 0 to")))
def test_words_of_options_are_refused(parse, text, message):
    with pytest.raises(argparse.ArgumentTypeError) as refused:
        parse(text)
    assert message in str(refused.value)


def test_samples_may_have_an_exponent():
    assert sweep_options.samples("1e6") == sweep_options.samples("1000000") == 10**6


# Chunks

def test_members_move_as_the_closed_form_says_to_the_bit(folder):
    its = prepared(folder, SLIDER, (MASSES, "start.q.slide=-0.5:0.5:3", "start.v.slide=-2:2:2"),
                   series=True)
    result = table(its)
    for row in result.to_pylist():
        m, q, v = (row[name] for name in ("block.mass", "start.q.slide", "start.v.slide"))
        if m + 1 in (2, 8):  # q and v are binary fractions then
            wanted = [q + v * t + 1.5 * t**2 / (m + 1) for t in (0, 0.25, 0.5, 0.75, 1)]
            assert row["q.slide"] == wanted
            assert row["q.slide.final"] == wanted[-1]
            assert (row["q.slide.minimum"], row["q.slide.maximum"]) == (min(wanted), max(wanted))
            assert row["v.slide.mean"] == v + 1.5 / (m + 1)
        assert row["failed"] is None
    assert result["member"].to_pylist() == list(range(18))
    units = {x.name: (x.metadata or {}).get(b"unit") for x in result.schema}
    assert (units["v.slide.mean"], units["start.q.slide"], units["member"]) == (b"m/s", b"m", None)


def test_chunks_are_of_the_same_numbers_whatever_their_size(folder):
    its = prepared(folder, SLIDER, (MASSES,), ("start.?.slide=limits",), 25)
    whole, small = (replace(its, specification=replace(its.specification, chunk=n))
                    for n in (75, 8))
    parts = [table(small, n) for n in range(small.specification.chunks)]
    assert [len(x) for x in parts] == [8] * 9 + [3]
    assert pyarrow.concat_tables(parts).equals(table(whole))


def test_a_member_is_what_simulate_computes(folder, capsys):
    text = SLIDER.replace("[outputs]", "[start.q]\nslide = 0.5\n[outputs]")
    row = table(prepared(folder, text, ("block.mass=1:2:3",))).to_pylist()[1]
    out = folder / "run.csv"
    assert main(["simulate", str(scene_file(folder, text)), "--set", "block.mass=1.5", "--output",
                 str(out)]) == 0
    lines = [x.split(",") for x in out.read_text().splitlines() if not x.startswith("#")]
    assert [row["q.slide.final"], row["v.slide.final"]] == [float(x) for x in lines[-1][1:]]


def test_members_with_a_floating_base_keep_momentum_as_simulate_does(folder):
    """To the bit: rounding errors are removed after the same steps."""
    its = prepared(folder, texts.BRICK, (), ("start.v.*=-2:2",), 5, series=True,
                   record=("q", "v"), overrides=RunOverrides(until=0.5, integrator="leapfrog"))
    result, columns = table(its), its.specification.varied.columns
    for row in result.to_pylist():
        start = {int(x.name.rpartition(".")[2]): row[x.name] for x in columns}
        scene = replace(its.scene, start_v={"base": tuple(start[k] for k in range(6))})
        wanted = replace(its.kernels.request, scene=scene)
        alone = system(replace(its.kernels, request=wanted), "double")
        assert np.array_equal(integrate(alone, its.plan).v[:, 3],
                              np.array(row["v.base.3"]))


def test_statistics_are_exact_where_they_can_be():
    t = np.array([0, 0.5, 1, 1.25])
    samples = np.array([[1, -3], [2, 5], [-4, 5], [0, 8]], np.float32)
    result = member_summary.statistics(t, samples)
    for k, x in enumerate(samples.T.tolist()):
        pairs = zip(itertools.pairwise(t.tolist()), itertools.pairwise(x), strict=True)
        area = sum(Fraction(b - a) * Fraction(y + z) / 2 for (a, b), (y, z) in pairs)
        assert result["mean"][k] == float(area / Fraction(1.25))
        assert [result[name][k] for name in ("final", "minimum", "maximum")] == [
            x[-1], min(x), max(x)]


def test_workers_with_other_sources_refuse(folder):
    its = prepared(folder, SLIDER, (MASSES,))
    job = replace(chunk.Job.of(its.kernels, its.specification), generator="other")
    with pytest.raises(SweepError, match="has another version of coscrew"):
        chunk.computed(job, 0)


def test_a_worker_without_memory_for_a_chunk_says_so(folder):
    """A chunk of 4e15 members is more than a process can address."""
    its = prepared(folder, SLIDER, ("block.mass=1:7:1e6",), ("start.q.slide=0:1",), 4 * 10**9)
    job = chunk.Job.of(its.kernels, replace(its.specification, chunk=4 * 10**15))
    with pytest.raises(SweepError, match="has too little memory for a chunk of 4000000000000000 m"):
        chunk.computed(job, 0)


def test_memory_does_not_grow_with_the_members(folder, tmp_path):
    """5e11 members: {peak}."""
    its = prepared(folder, SLIDER, ("block.mass=1:7:5000",), ("start.q.slide=0:1",), 10**8)
    place = Folder(tmp_path, its.specification)
    assert its.specification.varied.members == 5e11
    values(its.specification.varied, 0, 1)  # imports
    tracemalloc.start()
    try:
        last = its.specification.chunks - 1
        rows = member_values.values(its.specification.varied, its.specification.members(last))
        assert next(place.missing()) == 0
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert len(rows) <= its.specification.chunk and peak < 3e6
