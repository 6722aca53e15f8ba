"""Bodies that cannot exist are refused, or accepted with a warning, on joints and fixed to the
world."""


import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.__main__ import main
from coscrew_codegen.dynamics import derive
from coscrew_codegen.scene.mechanism.inertia_checks import why_singular
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides, read_scene
from tests.support.scenes.evaluation import DOUBLE, evaluator
from tests.support.scenes.implausible import BODIES, robot
from tests.support.scenes.robots import path_of

WARN = SceneOverrides(implausible="warn")

WELDED = """
[bodies.foot]
mass = 1
inertia = [1, 1, 3]
[bodies.bob]
mass = 1
inertia = [1, 1, 1]
[joints.weld]
type = "fixed"
child = "foot"
[joints.pin]
type = "revolute"
parent = "foot"
child = "bob"
axis = [0, 0, 1]
[run]
duration = 0.01
"""


@pytest.fixture
def written(tmp_path):
    def written(text, name="robot.urdf"):
        (tmp_path / name).write_text(text)
        return tmp_path / name
    return written


@pytest.mark.parametrize("body", BODIES)
def test_implausible_bodies_are_refused_with_the_way_round(written, body):
    with pytest.raises(SceneError) as caught:
        read_scene(written(robot(body)))
    assert caught.value.where.endswith(f"body {body!r}") and "line 3" in caught.value.where
    assert BODIES[body][1] in str(caught.value)
    assert str(caught.value).endswith('implausible = "warn" accepts it')


def test_load_scene_accepts_them_and_warns(written):
    path = written(robot(next(iter(BODIES))))
    with pytest.raises(SceneError, match="accepts it"):
        load_scene(path)
    with pytest.warns(RuntimeWarning, match=rf"^{path.name}: .*{next(iter(BODIES))!r}"):
        its = load_scene(path, implausible="warn", precision="double")
    assert list(its.double) and not list(its.single)
    imp = path.rename(path.with_name("imp" + path.suffix))  # imp alone is no name of a scene
    with pytest.warns(RuntimeWarning, match=rf"^imp{path.suffix}: "):
        load_scene(imp, implausible="warn", precision="double")
    path = imp
    with pytest.raises(ValueError, match="implausible = 'warm'; wanted one of error, warn"):
        load_scene(path, implausible="warm")
    with pytest.raises(TypeError, match="precision is for a file"):
        load_scene(its.scene, precision="both")


@pytest.mark.parametrize("body", BODIES)
def test_implausible_bodies_that_are_accepted_move_as_pinocchio_says(written, body):
    """Accelerations are finite and equal Pinocchio's, which accepts such bodies, within 1e-12."""
    pinocchio = pytest.importorskip("pinocchio")
    path = written(robot(body))
    scene = read_scene(path, overrides=WARN)
    messages = scene.model.implausible
    assert messages and all(line.startswith(f"body {body!r}: ") for line in messages)
    assert BODIES[body][1] in messages[0]
    (forward,) = (f for f in derive(scene).functions if f.name == "forward_dynamics")
    whole = path.read_text()
    if "<mass" not in BODIES[body][0]:
        whole = whole.replace("<inertial><inertia", '<inertial><mass value="0"/><inertia', 1)
    if "<inertia " not in BODIES[body][0]:
        whole = whole.replace('0.05"/></inertial>', '0.05"/><inertia ixx="0" iyy="0" izz="0" '
                              'ixy="0" ixz="0" iyz="0"/></inertial>', 1)
    theirs = pinocchio.buildModelFromXML(whole)
    theirs.gravity.linear = np.array([0, 0, -9.81])
    for q, v, tau in np.random.default_rng(1).uniform(-1, 1, (5, 3, 2)):
        ours = np.array(evaluator(forward.program, DOUBLE)([q, v, tau]))
        truth = pinocchio.aba(theirs, theirs.createData(), q, v, tau)
        assert np.isfinite(ours).all()
        assert np.abs(ours - truth).max() <= 1e-12 * np.abs(truth).max()


def test_faults_of_what_is_welded_to_the_world_are_seen(written):
    with pytest.raises(SceneError, match="body 'foot': moments .* no distribution of mass"):
        read_scene(written(WELDED, "a.toml"))
    scene = read_scene(written('implausible = "warn"\n' + WELDED, "a.toml"))
    assert len(scene.model.implausible) == 1
    with pytest.raises(SceneError, match="implausible: 'ignore'; wanted one of error, warn"):
        read_scene(written('implausible = "ignore"\n' + WELDED, "a.toml"))


def test_all_implausible_bodies_are_named_at_once(written):
    text = WELDED.replace("[joints.weld]", "[bodies.fin]\nmass = 1\ninertia = [1, 1, 3]\n"
                          '[joints.hinge]\ntype = "revolute"\nparent = "bob"\nchild = "fin"\n'
                          "axis = [1, 0, 0]\n[joints.weld]")
    with pytest.raises(SceneError) as caught:
        read_scene(written(text, "a.toml"))
    assert "body 'foot'" in caught.value.where
    assert str(caught.value).endswith(
        '; impossible, too: body \'fin\'; implausible = "warn" accepts them')


def test_a_negative_mass_is_never_accepted(written):
    with pytest.raises(SceneError, match="mass -2 kg; wanted a positive mass"):
        read_scene(written(robot("lwa_link").replace('"2"', '"-2"')), overrides=WARN)


def test_massless_bodies_of_scene_files_are_accepted_by_name(written):
    text = WELDED.replace("mass = 1\ninertia = [1, 1, 3]", "mass = 0")
    with pytest.raises(SceneError, match="bodies.foot.mass: 0; wanted a positive number"):
        read_scene(written(text, "a.toml"))
    scene = read_scene(written(text, "a.toml"), overrides=WARN)
    assert scene.model.implausible == ("body 'foot': its mass is zero, and so are its moments",)


@pytest.mark.parametrize("body, kind", [("torso_1", "prismatic"), ("lwa_link", "spherical")])
def test_what_would_divide_by_zero_is_left_out_all_the_same(written, body, kind):
    """A slider of mass zero, a point mass at the centre of a ball joint: their mass matrices are
    singular."""
    text = robot(body).replace('name="second" type="revolute"', 'name="second" type="fixed"')
    text = text.replace('name="first" type="revolute"', f'name="first" type="{kind}"')
    text = text.replace('<mass value="1"/>', '<mass value="0"/>').replace('"0.02"', '"0"')
    scene = read_scene(written(text), overrides=WARN)
    assert "so that the mass matrix is singular; wanted" in why_singular(scene)
    assert not derive(scene).has("forward_dynamics")


def test_a_mass_matrix_that_is_singular_for_every_q_is_told(written, capsys, tmp_path):
    """Two parallel joints at the same place, without a mass between them."""
    text = WELDED.replace("mass = 1\ninertia = [1, 1, 3]", "").replace(
        'type = "fixed"', 'type = "revolute"\naxis = [0, 0, 1]')
    path = written(text, "a.toml")
    assert main(["generate", str(path), "-o", str(tmp_path)]) == 0
    output = capsys.readouterr().err
    assert "left out: joints 'weld', 'pin' can move together without inertia" in output
    assert "the mass matrix is singular" in output and output.count("\n") == 1
    assert main(["generate", str(path), "-o", str(tmp_path), "--functions", "step_rk4"]) == 2


def test_romeo_is_accepted_with_a_warning():
    path = path_of("romeo_description/urdf/romeo_small.urdf")
    scene = read_scene(path, overrides=WARN)
    assert any("RShoulderYawLink" in line for line in scene.model.implausible)
    (forward,) = (f for f in derive(scene).functions if f.name == "forward_dynamics")
    q, v, tau = np.random.default_rng(1).uniform(-1, 1, (3, len(scene.model.joints)))
    assert np.isfinite(np.array(evaluator(forward.program, DOUBLE)([q, v, tau]), float)).all()


def test_load_scene_warns_and_commands_take_the_option(written, capsys):
    path = written('implausible = "warn"\n' + WELDED, "a.toml")
    with pytest.warns(RuntimeWarning, match=r"^a\.toml: body 'foot': moments"):
        load_scene(path)
    path = written(WELDED, "b.toml")
    assert main(["simulate", str(path)]) == 2
    assert main(["simulate", str(path), "--implausible", "warn"]) == 0
    assert "coscrew: warning: body 'foot': moments" in capsys.readouterr().err
    out = str(path.parent / "out")
    assert main(["generate", str(path), "-o", out, "--implausible", "warn"]) == 0
    first = (path.parent / "out" / "b.h").read_text().partition("\n")[0]
    assert "`coscrew generate b.toml --implausible warn`" in first
