"""A kind of joint is one file: CONTRIBUTING's universal joint, in a copy of the generator that
lacks it, is the one that ships; and so is a screw, which no other file knows."""

import re
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen.scene import joints
from coscrew_codegen.scene.joints import KINDS
from tests.support.scenes.kinds import Kind
from tests.support.walks import command, copied, run_in_copy, walk

SCENE = """
[bodies]
fork = { mass = 2, com = [0.1, 0, 0.3], inertia = [0.3, 0.2, 0.1] }
mug = { mass = 1, com = [0, 0.2, 0.1], inertia = [0.1, 0.2, 0.15] }
[joints]
rail = { type = "prismatic", child = "fork", axis = [1, 0, 0] }
cross = { type = "universal", parent = "fork", child = "mug", axis = [1, 0, 0], \
axis2 = [0, 1, 1] }
[effects.gravity]
[start.q]
cross = [0.3, -0.2]
[outputs]
record = ["q.cross", "v.cross"]
[run]
duration = 0.25
step = 1e-3
"""
HELICAL = '''"""A screw joint: its child moves along an axis, by 1/10 m for each rad."""

from fractions import Fraction

from coscrew_codegen.algebra.recording.numbers import (
    add,
    displacement,
    rotation,
    scaled,
    translation,
)
from coscrew_codegen.scene.mechanism.joint_kind import JointKind, numbers

PITCH = Fraction(1, 10)


def _displacement(x, placement):
    R = rotation(placement)
    along = x.rotated(R, scaled(x.q[0] / 10, x.axes[0]))
    return x.turned(displacement(R, add(translation(placement), along)),
                    x.rotation(x.axes[0], x.q[0]))


def _subspace(x):
    one, = x.numbers((1,))
    return ((*(one * n / 10 for n in x.axes[0]), *x.axes[0]),)


JOINT = JointKind("helical", 25, "screws along {0}", (numbers("angle", "rad"),), "in rad",
                  "in rad/s", _displacement, _subspace, axes=("axis of the screw",),
                  without_urdf="nothing moves alike", synonyms=("screw",))
'''
NUT = """
[bodies]
nut = { mass = 2, com = [0, 0, 0.5], inertia = [1, 1, 0.03] }
washer = { mass = 1, com = [0.2, 0, 0], inertia = [0.1, 0.1, 0.1] }
[joints]
hinge = { type = "revolute", child = "washer", axis = [0, 0, 1] }
thread = { type = "helical", parent = "washer", child = "nut", axis = [0, 0, 1], damping = 0.5, \
limits = { lower = -30, upper = 30 } }
[effects.gravity]
[effects.viscous.thread]
d = "model"
[outputs]
record = ["q.thread", "viscous.thread.torque"]
[run]
duration = 0.25
step = 1e-3
"""


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the generator without the universal joint, and scenes."""
    folder = tmp_path_factory.mktemp("site")
    (copied(folder) / "scene/joints/universal.py").unlink()
    (folder / "cross.toml").write_text(SCENE)
    (folder / "nut.toml").write_text(NUT)
    return folder


def test_the_walk_adds_the_joint_that_ships(site):
    done = command(site, "simulate", "cross.toml")
    assert done.returncode == 2
    assert "'universal'" in done.stderr and "wanted one of" in done.stderr, done.stderr
    path, = walk(site / "coscrew_codegen", "universal")
    shipped = Path(joints.__file__).parent / path.name
    assert path.read_text() == shipped.read_text()
    done = command(site, "generate", "cross.toml", "-o", "out", "--many")
    assert done.returncode == 0, done.stderr
    assert re.search(r"universal: q: angles about both axes in rad; v: rates of both angles",
                     re.sub(r"\s+\*?\s*", " ", (site / "out/cross.h").read_text()))
    done = command(site, "simulate", "cross.toml", "--output", "cross.csv")
    assert done.returncode == 0, done.stderr
    assert "q.cross.0 [rad],q.cross.1 [rad],v.cross.0 [rad/s]" in (site / "cross.csv").read_text()
    done = command(site, "check", "cross.toml")
    assert done.returncode == 0, done.stdout + done.stderr
    done = command(site, "schema")
    assert '"universal"' in done.stdout and '"axis2"' in done.stdout


def test_an_unknown_kind_works_in_every_place(site):
    """A nut on a vertical screw, which a washer carries that turns about the same axis: the mass
    matrix is [[J + I, I], [I, I + m p²]], and the thread's torque -m g p - d v."""
    (site / "coscrew_codegen/scene/joints/helical.py").write_text(HELICAL)
    result = run_in_copy(site, (
        "import coscrew_codegen as c, numpy as np\n"
        "its = c.load_scene('nut.toml', functions=['forward_dynamics', 'mass_matrix', "
        "'inverse_dynamics', 'jacobian_nut', 'step_rk4'], tiers=['certified'])\n"
        "q, v = np.array([0.4, 0.3]), np.array([0.0, 0.7])\n"
        "for x in (its.double.mass_matrix(q), its.double.forward_dynamics(q, v, np.zeros(2)),\n"
        "          its.single.mass_matrix(q), its.certified.double.mass_matrix(q)[0]):\n"
        "    print(*np.ravel(x))\n"))
    M, a, single, certified = (np.array(line.split(), float) for line in result.splitlines())
    J, I = 0.1 + 0.2**2, 0.03  # of the washer, of the nut about the axis
    wanted = np.array([J + I, I, I, I + 2 * 0.1**2])
    for masses, within in ((M, 1e-15), (single, 1e-7), (certified, 1e-15)):
        assert np.abs(masses - wanted).max() <= within
    torques = np.array([0, -2 * 9.81 * 0.1 - 0.5 * 0.7])
    assert np.abs(np.linalg.solve(wanted.reshape(2, 2), torques) - a).max() < 1e-12
    for words in (("simulate", "nut.toml", "--output", "nut.csv", "--view", "nut.html"),
                  ("check", "nut.toml"), ("cost", "nut.toml", "--function", "inverse_dynamics")):
        done = command(site, *words)
        assert done.returncode == 0, done.stdout + done.stderr
    assert "q.thread [rad],viscous.thread.torque [N m]" in (site / "nut.csv").read_text()
    (site / "typo.toml").write_text(NUT.replace('"helical"', '"screw"'))
    assert "did you mean 'helical'?" in command(site, "simulate", "typo.toml").stderr


def test_the_page_of_joints_lists_all():
    page = (Path(__file__).parents[2] / "generated/docs/joints.md").read_text()
    rows = re.findall(r"^\| `(\w+)`", page, re.MULTILINE)
    assert rows == ["type", *(kind.name for kind in KINDS)] and Kind.PLANAR.name in rows
