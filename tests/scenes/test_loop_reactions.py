"""Joints of closed loops transmit what they transmit in the open tree when the wrenches that close
the loops act on its bodies as outer ones do."""

from collections.abc import Iterator, Sequence
from pathlib import Path

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from coscrew_codegen import load_scene, run
from coscrew_codegen.scene.mechanism.loop import LOOP_KINDS
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.simulation.system import system
from tests.support.scenes import closed_loops
from tests.support.scenes.closed_states import CASES, TAU, Closed, V
from tests.support.scenes.evaluation import MULTIPRECISE, Evaluated

SCENES = Path(__file__).parents[2] / "examples/scenes"
JOINTS = ("root", "shoulder", "elbow", "rail", "cross")


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(50):
        yield


@pytest.mark.parametrize("kind", [x for x in LOOP_KINDS if x != "law"])
@CASES
def test_joints_transmit_what_outer_wrenches_would_make_them(tmp_path: Path, kind: str, second: str
                                                             ) -> None:
    path = tmp_path / "loop.toml"
    at = Closed(path, kind, second)
    state = {"q": at.q, "v": V, "tau": TAU}
    text = path.read_text(encoding="utf-8")
    loop = text[text.index("[loops"):text.index("[effects")]
    point, other = (next(x for x in loop.splitlines() if x.startswith(end)).split(" = ")[1]
                    for end in ("first", "second"))
    f = at.f.components("closing_closing", **state)
    outer = _wrench("end", point, f)
    if second != "world":
        outer += _wrench("other", other, _turned(at, f))
    path.write_text(text.replace(loop, "") + outer, encoding="utf-8")
    opened = Evaluated(read_scene(path), MULTIPRECISE)
    a = at.f.components("forward_dynamics", **state)
    assert max(map(abs, f)) > 1
    for joint in JOINTS:
        ours = at.f.components(f"reaction_{joint}", **state)
        wanted = opened.components(f"reaction_{joint}", q=at.q, v=V, a=a)
        assert max(map(abs, wanted)) > 1
        for x, y in zip(ours, wanted, strict=True):
            assert abs(x - y) < mpf(10)**-20, joint


def _turned(at: Closed, f: Sequence[mpf]) -> list[mpf]:
    """-f in the frame of the other body."""
    names = [x.name for x in at.f.scene.model.bodies]
    poses = at.f.components("body_poses", q=at.q)
    first, second = (mpmath.matrix([poses[12 * k + 4 * i:12 * k + 4 * i + 3] for i in range(3)])
                     for k in map(names.index, ("end", "other")))
    R = -second.T * first
    return [*(R * mpmath.matrix(f[:3])), *(R * mpmath.matrix(f[3:]))]


def _wrench(body: str, point: str, f: Sequence[mpf]) -> str:
    digits = [mpmath.nstr(mpmath.chop(x, 1e-40), 45) for x in f]
    force, torque = ", ".join(digits[:3]), ", ".join(digits[3:])
    return (f'[effects.wrench.{body}]\nframe = "body"\npoint = {point}\nforce = [{force}]\n'
            f"torque = [{torque}]\n")


def test_joints_of_a_cut_beam_transmit_what_those_of_a_whole_one_do(tmp_path: Path) -> None:
    results = []
    for cut in (True, False):
        path = tmp_path / "beam.toml"
        path.write_text(closed_loops.beam(cut), encoding="utf-8")
        its = system(load_scene(path, functions=["default", "reaction_*"]), "double")
        q, v = its.start()
        given = {"q": q, "v": v, "tau": np.zeros(len(v))}
        given["a"] = its.call("forward_dynamics", t=0.0, **given)
        results.append([its.call(f"reaction_{name}", t=0.0, **given)
                        for name in ("first", "second")])
    assert np.allclose(*results, rtol=0, atol=1e-9)
    assert abs(np.array(results)).max() > 10


def test_reactions_are_recorded(tmp_path: Path) -> None:
    """At rest the ground carries the weight of a four-bar linkage in two pins."""
    path = tmp_path / "bars.toml"
    text = closed_loops.crank_rocker()
    start = text[text.index("v = {"):]
    path.write_text(text.replace(start, "") + "[effects.viscous]\njoints = 'all'\nd = 1e9\n",
                    encoding="utf-8")
    result = run(path, until=0.02, record=["reaction.drive", "reaction.pivot"])
    columns = [x.name for x in result.recording.columns]
    assert columns[:6] == [f"reaction.drive.{k}" for k in range(6)]
    upwards = 0.0
    for k, angle in ((0, 0), (6, 2)):
        fx, fy = result.recording.values[-1, k:k + 2]
        q = result.q[-1][angle]
        upwards += fx * np.sin(q) + fy * np.cos(q)
    assert upwards == pytest.approx(3 * 9.81, rel=1e-7)


@pytest.mark.parametrize("name", ["delta", "four_bars"])
def test_all_closings_are_those_of_single_loops(name: str) -> None:
    """To the bit in both precisions, with the accelerations, and by little more than their cost."""
    scene = read_scene(SCENES / f"{name}.toml")
    loops = [f"closing_{x.name}" for x in scene.model.loops]
    kernels = load_scene(scene, functions=["forward_dynamics", "closings", *loops])
    rng = np.random.default_rng(1)
    for functions, kind in ((kernels.double, np.float64), (kernels.single, np.float32)):
        q, v, tau = (rng.uniform(-0.3, 0.3, n).astype(kind) for n in (
            kernels.interface.nq, kernels.interface.nv, kernels.interface.nv))
        given = [*([0.2] if kernels.interface.timed else []), q, v, tau]
        a, f = functions.closings(*given)
        assert f.shape == (len(loops), 6) and np.abs(f).max() > 0
        assert a.tobytes() == functions.forward_dynamics(*given).tobytes()
        for own, loop in zip(f, loops, strict=True):
            assert own.tobytes() == getattr(functions, loop)(*given).tobytes()
    made = {x.name: len(x.program.instructions) for x in kernels.functions.functions}
    assert made["closings"] < 1.1 * made["forward_dynamics"]
