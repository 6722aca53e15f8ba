"""A notice says once that nothing holds a free base against gravity, where that is so."""

from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen import run
from coscrew_codegen.__main__ import main
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene

LINKED = """
[bodies]
trunk = { mass = 2, inertia = [1, 1, 1] }
leg = { mass = 1, inertia = [1, 1, 1] }
ball = { mass = 1, inertia = [1, 1, 1] }
wall = { mass = 1, inertia = [1, 1, 1] }
[joints]
float = { type = "free", child = "trunk" }
hip = { type = "revolute", parent = "trunk", child = "leg", axis = [0, 1, 0] }
throw = { type = "free", child = "ball" }
rail = { type = "prismatic", child = "wall", axis = [0, 0, 1] }
"""
FALLS = "[effects.gravity]\n"
BALL = "nothing holds body ball: it falls"
BOTH = "nothing holds 2 free bodies (trunk, ball): they fall"
HELD = {
    "wrench": '[effects.wrench.trunk]\nforce = [0, 0, "30*t"]\n',
    "contact": '[effects.contact.foot]\nbodies = ["leg"]\nmu = 0.5\n',
    "buoyancy": "[effects.buoyancy.leg]\nrho = 1000\nV = 1e-3\n",
    "field": "[effects.field.trunk]\nmu = 1\ncentre = [9, 9, 9]\n",
    "spring": "[effects.spring.float]\nk = 30\n",
    "rope": '[effects.spring_damper.a]\nbodies = ["world", "leg"]\nk = 3\n',
    "hung on another": '[effects.spring_damper.a]\nbodies = ["wall", "trunk"]\nk = 3\n',
    "blown": "[effects.drag.leg]\nkind = 'stokes'\nb = 1\n[effects.wind]\nvelocity = [0, 0, 9]\n"}
RESISTED = {
    "nothing": "",
    "between its bodies": '[effects.spring_damper.a]\nbodies = ["trunk", "leg"]\nk = 3\n',
    "in its joint": "[effects.actuator.hip]\nkind = 'torque'\ntorque = 1\n",
    "a spring in its joint": "[effects.spring.hip]\nk = 1\n",
    "damped": "[effects.viscous.float]\nd = 1\n[effects.coulomb.float]\ntau_c = 1\neps = 0.1\n",
    "in calm air": "[effects.drag.trunk]\nkind = 'stokes'\nb = 1\n",
    "heavier": "[effects.armature.float]\ninertia = 1\n"}


def notices(folder: Path, text: str, model: str = LINKED) -> list[str]:
    path = folder / "scene.toml"
    path.write_text(model + text)
    return [x for x in read_scene(path).unused if "nothing holds" in x]


@pytest.mark.parametrize("effects", HELD.values(), ids=HELD)
def test_what_exerts_a_force_from_outside_holds(tmp_path: Path, effects: str) -> None:
    (line,) = notices(tmp_path, FALLS + effects)
    assert line.startswith(BALL)


@pytest.mark.parametrize("effects", RESISTED.values(), ids=RESISTED)
def test_what_acts_inside_or_only_resists_motion_does_not_hold(tmp_path: Path, effects: str
                                                              ) -> None:
    (line,) = notices(tmp_path, FALLS + effects)
    assert line.startswith(BOTH)


@pytest.mark.parametrize("effects", RESISTED.values(), ids=RESISTED)
def test_what_is_not_held_falls(tmp_path: Path, effects: str) -> None:
    """A second after a start at rest the notice has come true: the trunk is lower, by 4.9 m unless
    its motion is resisted."""
    path = tmp_path / "scene.toml"
    path.write_text(LINKED + FALLS + effects)
    z = np.asarray(run(path).q, float)[-1, 2]
    assert z < (-1 if effects in (RESISTED["damped"], RESISTED["in calm air"],
                                  RESISTED["heavier"]) else -4.5)


@pytest.mark.parametrize("gravity", ["", "[effects.gravity]\ng = [0, 0, 0]\n"])
def test_without_gravity_nothing_falls(tmp_path: Path, gravity: str) -> None:
    assert not notices(tmp_path, gravity)


def test_a_scene_may_accept_it(tmp_path: Path) -> None:
    assert not notices(tmp_path, FALLS, 'falling = "accept"\n' + LINKED)
    assert notices(tmp_path, FALLS, 'falling = "warn"\n' + LINKED)
    with pytest.raises(SceneError, match="'yes'; wanted one of warn, accept"):
        notices(tmp_path, FALLS, 'falling = "yes"\n' + LINKED)


def test_bodies_fixed_to_the_world_do_not_fall(tmp_path: Path) -> None:
    """No more do those with a free joint to a body that the world's joints hold."""
    model = """
[bodies]
lift = { mass = 1, inertia = [1, 1, 1] }
ball = { mass = 1, inertia = [1, 1, 1] }
[joints]
rail = { type = "prismatic", child = "lift", axis = [0, 0, 1] }
loose = { type = "free", parent = "lift", child = "ball" }
"""
    assert not notices(tmp_path, FALLS, model)


def test_commands_say_it_once_beside_the_summary(tmp_path: Path,
                                                 capsys: pytest.CaptureFixture) -> None:
    """A line is printed apart from the summary of unused numbers, also for a model's file alone."""
    path = tmp_path / "ball.xml"
    path.write_text('<mujoco><worldbody><body name="ball"><freejoint name="base"/><geom size="1" '
                    'mass="1"/><body name="arm"><joint name="j" damping="1" frictionloss="1" '
                    'range="-1 1"/><geom size="1" mass="1"/></body></body></worldbody></mujoco>')
    assert main(["simulate", str(path), "--until", "0.01"]) == 0
    lines = capsys.readouterr().err.splitlines()
    assert [x for x in lines if "nothing holds" in x] == [
        "coscrew: nothing holds body ball: it falls; write an effect that does, as "
        '[effects.contact] with mu or [effects.wrench.LABEL], base = "fixed", or falling = '
        '"accept" where that is meant']
    assert any(x.startswith("coscrew: not used: ") for x in lines)
    assert main(["simulate", str(path), "--until", "0.01", "--verbose"]) == 0
    assert capsys.readouterr().err.count("nothing holds") == 1
