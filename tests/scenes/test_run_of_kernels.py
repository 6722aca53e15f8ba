"""`run` of kernels that `load_scene` returned, whatever functions were selected: the motion is that
of the file, since missing functions are compiled on first use."""

import numpy as np
import pytest

from coscrew_codegen import load_scene, run
from coscrew_codegen.simulation import SimulateError

PENDULUM = """
[bodies]
link = { mass = 2, com = [0, 0, -0.25], inertia = [0.04, 0.04, 0.002] }
[joints]
hinge = { type = "revolute", child = "link", axis = [0, 1, 0] }
[effects.gravity]
[start.q]
hinge = 0.5
[outputs]
record = ["q", "position.link", "momentum", "reaction.hinge"]
[run]
duration = 0.1
integrator = "rk4"
"""


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory):
    path = tmp_path_factory.mktemp("kernels") / "pendulum.toml"
    path.write_text(PENDULUM)
    return path


@pytest.mark.parametrize("functions, given", (
    (["step_rk4"], {}), (["step_rk4", "energy"], {"record": ["energy.total"]}),
    (["step_*"], {"integrator": "leapfrog"}), (["energy"], {"integrator": "radau"})))
def test_what_a_run_needs_is_compiled(file, functions, given):
    loaded, read = run(load_scene(file, functions=functions), **given), run(file, **given)
    assert loaded.recorded.keys() == read.recorded.keys() and loaded.recorded
    for name, values in loaded.recorded.items():
        assert np.array_equal(values, read.recorded[name]), name


def test_a_step_that_was_not_selected_is_refused(file):
    with pytest.raises(SimulateError, match="step_rk4 is not among the selected functions"):
        run(load_scene(file, functions=["energy"]))


def test_a_precision_that_was_not_loaded_is_refused(file):
    with pytest.raises(SimulateError, match="the scene is of double precision alone"):
        run(load_scene(file, precision="double"), precision="single")
