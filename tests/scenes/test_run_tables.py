"""Results as tables of xarray and pandas, and in notebooks, hold the recorded quantities."""

from xml.etree import ElementTree

import numpy as np
import pytest

from coscrew_codegen import run
from coscrew_codegen.simulation import SimulateError
from tests.support.scenes.swing import SWING


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    """One run, and a batch with a member that stops."""
    path = tmp_path_factory.mktemp("tables") / "swing.toml"
    path.write_text(SWING)
    return run(path, until=0.1), run(path, v0=[[0], [1], [1e308]], until=0.1)


@pytest.mark.parametrize("batch", (False, True))
def test_tables_hold_what_was_recorded(runs, batch):
    result = runs[batch]
    data, frame = result.to_xarray(), result.to_pandas()
    assert list(data.data_vars) == list(result.recorded) == list(frame.columns)
    for name, values in result.recorded.items():
        assert data[name].values.tobytes() == values.tobytes()
        assert frame[name].to_numpy().tobytes() == values.tobytes()
        assert data[name].attrs["units"] == frame.attrs["units"][name]
    assert data["v.pivot"].attrs["units"] == "rad/s" and data.t.attrs["units"] == "s"
    assert dict(data.attrs) == dict(result.provenance)
    assert data["q.pivot"].dims == (("member", "t") if batch else ("t",))
    assert frame.index.names == (["member", "t"] if batch else ["t"])
    assert (frame.index.get_level_values("t").to_numpy().reshape(-1, 11) == result.t).all()


def test_a_batch_tells_why_members_stopped(runs):
    data = runs[1].to_xarray()
    assert [bool(x) for x in data.cause.values] == [False, False, True]
    assert str(data.cause.values[2]) == runs[1].failed[0].cause
    after = data.t.values >= runs[1].failed[0].t
    assert (np.isnan(data["q.pivot"].sel(member=2).values) == after).all()


def test_members_are_recordings_of_their_runs(runs):
    one, many = runs
    assert many.member(0).values.tobytes() == one.recording.values.tobytes()
    with pytest.raises(SimulateError, match="wanted a batch"):
        one.member(0)


def test_notebooks_show_a_plot_of_a_batch_with_the_origin(runs):
    result = runs[True]
    shown = ElementTree.fromstring(f"<div>{result._repr_html_()}</div>")
    svg = shown.find("{http://www.w3.org/2000/svg}svg")
    lines = [x for x in svg.iter() if x.get("id", "").startswith("q.pivot")]
    assert len(lines) == 3
    messages = {row[0].text: row[1].text for row in shown.iter("tr")}
    assert messages["scene"] == "swing"
    assert "member 2" in messages


@pytest.mark.parametrize(("name", "message"), (
    ("q.pivt", "'q.pivt' is no recorded column (record=[…] of a run adds quantities); did you mean "
               "'q.pivot'?"),
    ("q", "q: its columns are q.pivot"), ("", "'' is no recorded column")))
def test_a_column_that_is_not_there_is_refused_with_what_is(runs, name, message):
    with pytest.raises(KeyError) as error:
        runs[0].recorded[name]
    assert message in error.value.args[0]
    assert runs[0].recorded.get(name) is None
