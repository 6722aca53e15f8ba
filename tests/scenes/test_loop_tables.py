"""Tables of closed loops: what is refused, and how starts are assembled."""

import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.__main__ import main
from coscrew_codegen.scene.function_selection import FunctionsError
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.simulation import SimulateError
from coscrew_codegen.simulation.api import run
from coscrew_codegen.simulation.system import system
from tests.support.scenes import closed_loops

FOUR_BAR = closed_loops.crank_rocker()
KNEE = FOUR_BAR[FOUR_BAR.index("[loops"):FOUR_BAR.index("[effects")]
Written = Callable[[str], Path]


@pytest.fixture
def written(tmp_path: Path) -> Written:
    def written(text: str) -> Path:
        path = tmp_path / "bars.toml"
        path.write_text(text, encoding="utf-8")
        return path

    return written


@pytest.mark.parametrize("before, after, problem", [
    ('"point"', '"pin"', "loops.knee0.kind: 'pin'; wanted one of point, frame, hinge, rod"),
    ('"rocker"]', '"rockr"]', "loops.knee0.bodies: no body 'rockr'; did you mean 'rocker'?"),
    ('"coupler", "rocker"]', '"coupler"]', "loops.knee0.bodies: a list of 1; wanted two bodies"),
    ('bodies = ["coupler", "rocker"]', "",
     "loops.knee0.bodies: missing; wanted a list of two bodies"),
    ("first", "frist", "loops.knee0.frist: unknown key; did you mean 'first'?"),
    ('"point"', '"rod"', "loops.knee0.length: missing; wanted a number"),
    ('"point"', '"rod"\nlength = 0', "loops.knee0.length: 0; wanted a positive number"),
    ('"point"', '"point"\nlength = 1', "loops.knee0.length: is for loops of kind rod"),
    ('"point"', '"frame"\naxis = [0, 0, 1]', "loops.knee0.axis: is for loops of kind hinge"),
    ('"point"', '"hinge"', "loops.knee0.axis: missing"),
    ('"point"', '"hinge"\naxis = [0, 0, 0]', "loops.knee0.axis: is zero; wanted a direction")])
def test_wrong_tables_are_refused_by_key(written: Written, before: str, after: str, problem: str
                                         ) -> None:
    assert before in KNEE
    text = FOUR_BAR.replace(KNEE, KNEE.replace(before, after))
    with pytest.raises(SceneError) as error:
        read_scene(written(text))
    assert problem in str(error.value)


def test_bodies_that_cannot_move_against_each_other_are_refused(written: Written) -> None:
    fixed = FOUR_BAR.replace('"rocker"]', '"tip"]') + '[frames.tip]\nto = "coupler"\n'
    with pytest.raises(SceneError, match="fixed joints connect 'coupler' and 'tip', both to "
                                         "'coupler'; wanted bodies that can move"):
        read_scene(written(fixed))


def test_a_scene_without_loops_keeps_its_hash(written: Written) -> None:
    """Recordings of scenes from before there were loops remain those of their scene."""
    text = FOUR_BAR.replace(KNEE, "")
    scene = read_scene(written(text))
    assert scene.model.loops == ()
    assert "loops" not in "\n".join(_hashed(scene))
    closed = read_scene(written(FOUR_BAR))
    longer = read_scene(written(FOUR_BAR.replace("first = [0.8", "first = [0.81")))
    assert len({x.motion_hash for x in (scene, closed, longer)}) == 3


def _hashed(scene: object) -> list[str]:
    from coscrew_codegen.scene.scene import _as_text

    return list(_as_text(scene))


# starts


def test_an_open_start_is_refused_with_one_that_is_assembled(written: Written) -> None:
    opened = FOUR_BAR.replace("elbow = 0.103283917", "elbow = 0.3")
    with pytest.raises(SimulateError, match="loop knee0 is open by 0.15. m at the start; wanted at "
                                            "most 0.001; assembled near it: start.q = ") as error:
        run(written(opened), until=0.1)
    remedy = str(error.value).partition("start.q = ")[2]
    lines = opened.splitlines()
    lines = [f"q = {remedy}" if x.startswith("q = ") else x for x in lines
             if not x.startswith("v = ")]
    assert len(run(written("\n".join(lines)), until=0.1).t) > 2


def test_a_start_that_no_position_closes_is_refused(written: Written) -> None:
    far = FOUR_BAR.replace("first = [0.8", "first = [3.8")
    with pytest.raises(SimulateError, match="no position near it closes all loops; wanted another "
                                            "q in .start., or lengths that fit"):
        run(written(far), until=0.1)


def test_velocities_that_open_a_loop_are_refused_with_some_that_keep_it(written: Written) -> None:
    """The given velocities stay, if others can follow."""
    driven = FOUR_BAR.replace("v = { drive = 9, elbow = -12.616119075, pivot = -0.578448498 }",
                              "v = { drive = 9 }")
    with pytest.raises(SimulateError, match=r"loop knee0 opens at 9\.\d+ m/s at the start; wanted "
                       r"velocities that keep it closed, as start\.v = \{ drive = 9, "
                       r"elbow = -12\.6161\d*, pivot = -0\.57844\d* \}"):
        run(written(driven), until=0.1)


def test_a_start_that_is_almost_closed_is_moved_onto_the_closures(written: Written) -> None:
    near = FOUR_BAR.replace("elbow = 0.103283917", "elbow = 0.1041")
    kernels = load_scene(written(near))
    its = system(kernels, "double")
    q, v = its.start()
    phi, E = its.outputs("closure", q=its.written_start()[0])
    assert 1e-4 < abs(phi).max() < 1e-3
    phi, E = its.outputs("closure", q=q)
    assert abs(phi).max() < 1e-14
    assert abs(E @ v).max() < 1e-13
    result = run(kernels, until=0.01)
    assert np.array_equal(result.q[0], q)


def test_members_of_a_batch_are_assembled_or_refused(written: Written) -> None:
    kernels = load_scene(written(FOUR_BAR))
    q, _ = system(kernels, "double").start()
    starts = q + np.array([[0, 1e-4, 0], [0, 0, 2e-4]])
    result = run(kernels, q0=starts, v0=np.zeros(3), until=0.01)
    assert abs(result.system.outputs("closure", q=result.q[:, 0])[0]).max() < 1e-14
    with pytest.raises(SimulateError, match="loop knee0 is open by"):
        run(kernels, q0=starts + [[0, 0, 0], [0, 0.1, 0]], v0=np.zeros(3), until=0.01)


def test_a_body_on_a_rod_is_held(written: Written) -> None:
    """Without the loop, a notice says that the body falls."""
    rope = f"{closed_loops.rope()}[effects.gravity]\n"
    loop = rope[rope.index("[loops"):rope.index("[start]")]
    assert not read_scene(written(rope)).unused
    assert "it falls" in "".join(read_scene(written(rope.replace(loop, ""))).unused)


# functions and commands


@pytest.mark.parametrize("name", [
    "torque_regressor", "base_parameters", "linear_parameters", "base_regressor_adjoint"])
def test_functions_that_do_not_know_loops_are_refused(written: Written, name: str) -> None:
    with pytest.raises((FunctionsError, SceneError), match=f"{name} does not know closed loops "
                                                           r"\(knee0\); wanted a scene without"):
        load_scene(written(FOUR_BAR), functions=[name])
    load_scene(written(FOUR_BAR.replace(KNEE, "")), functions=[name])


def test_commands_print_the_mobility(written: Written, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["simulate", str(written(FOUR_BAR)), "--until", "0.01"]) == 0
    assert ("coscrew: closed loops: 3 rows of rank 2 leave 1 of 3 velocities free"
            in capsys.readouterr().err)


def test_check_judges_closures(written: Written, capsys: pytest.CaptureFixture[str]) -> None:
    path = written(f"{closed_loops.linked_four_bars()}[run]\nduration = 1\n")
    assert main(["check", str(path), "--precision", "double"]) == 0
    out = capsys.readouterr().out
    assert "largest gap of closed loops, in m or rad" in out
    assert "6 rows of rank 4 leave 1 of 5 velocities free" in out


def test_forces_that_close_loops_are_recorded(written: Written) -> None:
    """The rocker turns as the moments of its weight and of the force that closes the loop say."""
    result = run(written(FOUR_BAR), until=0.02, record=["closing.knee0", "a"])
    names = [x.name for x in result.recording.columns]
    assert names[:6] == [f"closing.knee0.{k}" for k in range(6)]
    f, a = result.recording.values[0, :3], result.recording.values[0, 6:]
    q, _ = result.q[0], result.v[0]
    arm = [0.6 * math.cos(q[2]), 0.6 * math.sin(q[2])]
    turned = q[0] + q[1]
    world = (-f[0] * math.cos(turned) + f[1] * math.sin(turned),
             -f[0] * math.sin(turned) - f[1] * math.cos(turned))
    moment = arm[0] * world[1] - arm[1] * world[0] - 9.81 * 0.3 * math.cos(q[2])
    assert moment == pytest.approx((0.03 + 0.3**2) * a[2], rel=1e-9)
