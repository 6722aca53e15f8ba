"""`coscrew sweep`: each member has the bits of `run`, fails where it does, and runs alone."""

import re
import shutil
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen import run
from coscrew_codegen.__main__ import main
from coscrew_codegen.cli import command_line, sweep_command
from coscrew_codegen.scene.parameter_units import parameter_units
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.simulation import sweep
from coscrew_codegen.simulation.sweep import chunk, member_summary, member_values
from coscrew_codegen.simulation.sweep.candidates import Candidate
from coscrew_codegen.simulation.sweep.files.folder import opened
from coscrew_codegen.simulation.sweep.prepare import Prepared
from coscrew_codegen.simulation.sweep.specification import Grid
from coscrew_codegen.simulation.sweep.statistics import axis
from tests.support.scenes import scene_texts as texts
from tests.support.scenes.simulated import scene_file
from tests.support.scenes.sweeps import BALL, SLIDER, UNITS, prepared, table

UNSTABLE = texts.UNSTABLE.replace("duration = 2", "duration = 0.5").replace(
    'precision = "both"', 'precision = "double"')
MANY_KINDS = 'runtime = ["ball.mass", "cup.com.x"]' + BALL + """
[outputs]
record = ["q", "v", "energy", "momentum", "position.cup", "a.socket"]
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    return tmp_path_factory.mktemp("sweep")


def test_members_fail_where_runs_do_and_the_others_go_on(folder):
    """At the same time and joint, of the same cause: not finite, the step too long.  Only runs of
    their own try what helps."""
    result = table(prepared(folder, UNSTABLE, ("block.mass=1e-6:1e6:7:log",))).to_pylist()
    for row in result:
        alone = run(folder / "scene.toml", p={"block.mass": row["block.mass"]})
        messages = [(x.t, x.joint, x.cause.rpartition("; ")[0]) for x in alone.failed]
        assert messages == [(row["failed.t"], row["failed.joint"],
                             (row["failed"] or "").rpartition("; ")[0])] * len(messages)
        assert bool(messages) == (row["failed"] is not None) == (row["q.slide.final"] is None)
        if not messages:
            assert row["energy.total.final"] == alone.recorded["energy.total"][-1]
    kinds = [x["failed"] and x["failed"].partition(" at t")[0] for x in result]
    assert kinds == ["not finite"] * 5 + ["the step is too large", None]


@pytest.mark.parametrize(("text", "options", "member"), (
    (MANY_KINDS, "--grid ball.mass=1:2:2 --sobol start.?.base.[0-2]=-1:1 --sobol start.v.s*=-2:2 "
     "--samples 3 --set cup.com.x=0.1 --precision single", 3),
    *((MANY_KINDS, "--sobol start.q.*=uniform --sobol start.v.*=-2:2 --samples 5", k)
      for k in range(5)),
    (SLIDER, "--grid block.mass=0.7:1.1:5:log --sobol start.?.slide=limits --samples 9 --seed 5",
     44)))
def test_one_member_alone_has_the_bits_that_the_sweep_wrote(text, options, member, folder, capsys):
    """By the command, and by the Python that it prints."""
    words = ["sweep", str(scene_file(folder, text)), *options.split()]
    assert main([*words, "--member", str(member)]) == 0
    call, printed = capsys.readouterr().out.split("\n\nrecorded")
    requested = command_line._parser("sweep").parse_args([*words, "--series", "--out", "x"])
    row = table(sweep_command._prepared(requested)).to_pylist()[member]
    exec(call, given := {})
    columns = given["member"].recorded
    for name, values in columns.items():
        assert np.array(row[name], values.dtype).tobytes() == values.tobytes(), name
    lines = [x.split() for x in printed.splitlines()[2:]]
    assert [x[0] for x in lines] == list(columns)
    for name, *_, final, least, most, mean in lines:
        kind = columns[name].dtype.type
        assert [kind(final), kind(least), kind(most), float(mean)] == [
            row[f"{name}.{word}"] for word in member_summary.STATISTICS]


def test_a_member_that_failed_fails_alone(folder, capsys):
    words = ["sweep", str(scene_file(folder, UNSTABLE)), "--grid", "block.mass=1:9:3"]
    assert main([*words, "--member", "1"]) == 1
    assert "failed: not finite at t = 0.138 s: joint slide: q is inf" in capsys.readouterr().out
    assert main([*words, "--member", "3"]) == 2
    assert "--member 3: wanted 0 to 2" in capsys.readouterr().err


def reported(its: Prepared, folder: Path) -> str:
    """The page of a sweep of one chunk."""
    with opened(folder, its.specification, {}) as target:
        target.write(0, chunk.computed(chunk.Job.of(its.kernels, its.specification), 0).content)
        assert sweep_command._report(its, target, "coscrew sweep x.toml") == 1
    return (folder / "summary.html").read_text("utf-8")


def test_xarray_tells_why_members_failed(folder, tmp_path, capsys):
    its = prepared(folder, UNSTABLE, ("block.mass=1e-6:1e6:7:log",), ("start.v.slide=0:1",), 3)
    reported(its, tmp_path)
    result, rows = sweep.opened(tmp_path), table(its).to_pylist()
    for name, column in (("failed.cause", "failed"), ("failed.joint", "failed.joint")):
        assert result[name].dims == ("sample", "block.mass")
        assert result[name].values.ravel().tolist() == [row[column] or "" for row in rows]
    assert {bool(row["failed"]) for row in rows} == {False, True}
    shutil.rmtree(tmp_path / "members")  # then the numbers are left
    assert "failed.cause" not in sweep.opened(tmp_path) and "failed.t" in sweep.opened(tmp_path)


def test_maps_mark_where_members_failed(folder, tmp_path, capsys):
    """Marks are at their values of the varied quantities, with any spacing."""
    its = prepared(folder, UNSTABLE, ("block.mass=1e-6:1e6:7:log",), ("start.v.slide=0:1",), 8)
    page, failed = reported(its, tmp_path), table(its).to_pylist()
    assert "Crosses mark where members failed." in page
    figures = re.findall(r"<svg .*?</svg>", page, re.S)
    maps = [x for x in figures if "<image" in x]
    assert len(maps) == 3 * (len(figures) // 4) > 0  # against each axis, and both
    for text in maps:
        (cross,) = re.findall(r'<path id="(\S+)" d="M -2.5 2.5 ', text)
        crosses = text.count(f'href="#{cross}"')
        assert crosses == len({x["block.mass"] for x in failed if x["failed"]}) or (
            "against block.mass" not in text and crosses)


def test_axes_of_geometric_grids_are_in_logarithms():
    mass = Candidate("mass", "p", 0, "kg")
    result = axis.of_varied(Grid(mass, (100.0, 10.0, 1.0)), 8)
    assert result.log and result.middles.tolist() == [1, 10, 100]
    assert np.allclose(result.edges, [10**-0.5, 10**0.5, 10**1.5, 10**2.5], rtol=1e-15, atol=0)
    many = axis.of_varied(Grid(mass, tuple(2.0**k for k in range(50))), 7)
    assert many.log and np.allclose(many.edges, [2**(7 * k) for k in range(8)], rtol=1e-14, atol=0)
    huge = axis.Axis("mass", "kg", 1e-300, 1e300, 2, log=True)  # squares would overflow
    assert np.allclose(huge.middles, [1e-150, 1e150], rtol=1e-12, atol=0)
    for values in ((1.0, 2.0, 3.0), (-1.0, 0.0, 1.0), (1.0, 2.0), (1.0,)):
        assert not axis.of_varied(Grid(mass, values), 8).log


def test_the_page_says_how_to_run_failed_members_alone(folder, tmp_path, capsys):
    """Their numbers and values, in all digits, the seed, and a command."""
    its = prepared(folder, UNSTABLE, ("block.mass=1:2:2",), ("start.v.slide=0:1",), 2, seed=12)
    text = reported(its, tmp_path)
    assert capsys.readouterr().out == "4 of 4 members failed: 4 at slide\n"
    assert "Recorded quantities" not in text  # there are none
    assert "The seed of the Sobol sequence is 12." in text
    assert ("The first is run alone, with the same bits, by: coscrew sweep x.toml --member 0</p>"
            in text)
    assert re.search(r"block\.mass \[kg\]</th><th[^>]*>start\.v\.slide \[m/s\]</th>", text)
    for k, (mass,
            speed) in enumerate(member_values.values(its.specification.varied, range(4)).tolist()):
        assert re.search(rf"<td>{k}</td><td[^>]*>{mass}</td><td[^>]*>{speed}</td><td[^>]*>0\.1",
                         text)


def test_parameters_have_the_units_of_bodies_and_of_effects_on_their_joint(folder):
    moments = (f"block.inertia.{x}" for x in ("xx", "yy", "zz", "xy", "xz", "yz"))
    wanted = {"block.mass": "kg", **{f"block.com.{x}": "m" for x in "xyz"},
              **dict.fromkeys(moments, "kg m^2"), **{f"gravity.g.{x}": "m/s^2" for x in "xyz"},
              "spring.slide.k": "N/m", "spring.swivel.k": "N m/rad",
              "actuator.slide.gear": "rad/m", "actuator.swivel.gear": "1",
              **{f"wrench.block.force.{x}": "N" for x in "xyz"}}
    assert parameter_units(read_scene(scene_file(folder, UNITS))) == wanted
    fields = table(prepared(folder, UNITS, ("spring.swivel.k=1:2:2", "gravity.g.z=-9:9:2"))).schema
    assert fields.field("spring.swivel.k").metadata == {b"unit": b"N m/rad"}
    assert fields.field("gravity.g.z").metadata == {b"unit": b"m/s^2"}
