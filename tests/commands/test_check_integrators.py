"""`coscrew check` judges every example, and a scene with a limit, by every integrator."""

from pathlib import Path

import pytest

from coscrew_codegen.__main__ import main
from coscrew_codegen.scene.integrators import NAMES

EXAMPLES = sorted((Path(__file__).parents[2] / "examples" / "scenes").glob("*.toml"))
FALL = """
[bodies]
ball = { mass = 1, inertia = [0.004, 0.004, 0.004] }
[joints.up]
type = "prismatic"
child = "ball"
axis = [0, 0, 1]
limits = { lower = 0, upper = 5 }
[effects.gravity]
[effects.limit.up]
k = 1e7
alpha = 0.1
[start.q]
up = 0.02
[run]
duration = 0.1
"""


@pytest.mark.parametrize("integrator", NAMES)
@pytest.mark.parametrize("example", EXAMPLES, ids=lambda x: x.stem)
def test_every_integrator_is_judged_on_every_example(example, integrator, capsys):
    """It passes or says what is false.  Expectations are of later times than these 0.02 s."""
    status = main(["check", str(example), "--integrator", integrator, "--precision", "double",
                   "--until", "0.02"])
    output = capsys.readouterr().out
    assert status in (0, 1) and "largest error of the motion" in output
    assert (status == 1) == any(word in output for word in ("FAIL ", "FALSE: ", "double: "))


@pytest.mark.parametrize("integrator", ("leapfrog", "dop853", "radau"))
def test_a_bounce_is_right_by_integrators_that_resolve_it(tmp_path, capsys, integrator):
    path = tmp_path / "fall.toml"
    path.write_text(FALL)
    words = ["check", str(path), "--integrator", integrator, "--strict", "--precision", "double"]
    assert main(words) == 0, \
        capsys.readouterr().out
