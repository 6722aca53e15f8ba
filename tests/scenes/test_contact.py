"""Contact with the ground against closed forms: rolling, sliding, bouncing, sinking, standing."""

import math
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import coscrew
from coscrew_codegen import load_scene, run
from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.scene.contacts.contact_law import damping_of
from coscrew_codegen.scene.readers.scene_error import SceneError
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.references import bouncing_ball
from tests.references import figures as committed

SCENES = Path(__file__).parents[2] / "examples/scenes"
G, SLOPE = 9.81, math.radians(20)
BALL = """
[bodies]
ball = { mass = 1, inertia = [0.004, 0.004, 0.004] }
[joints]
free = { type = "free", child = "ball" }
[effects.contact.ball]
shape = "sphere"
radius = 0.1
mu = 0.5
"""
BOX = """
[bodies]
box = { mass = 1, inertia = [0.004, 0.004, 0.007] }
[joints]
free = { type = "free", child = "box" }
[effects.contact.box]
shape = "box"
size = [0.2, 0.2, 0.1]
mu = MU
"""
LEVEL = "[effects.gravity]\n"
DOWNHILL = f"[effects.gravity]\ng = [{G * math.sin(SLOPE)!r}, 0, {-G * math.cos(SLOPE)!r}]\n"
Made = Callable[[str], Path]


@pytest.fixture
def made(tmp_path: Path) -> Made:
    def written(text: str) -> Path:
        path = tmp_path / "thing.toml"
        path.write_text(text)
        return path
    return written


def started(z: float, *v: float) -> str:
    """At rest or moving, level."""
    speeds = f"[start.v]\nfree = {[*v, *[0.0] * (6 - len(v))]}\n" if v else ""
    return f"[start.q]\nfree = [0, 0, {z}, 0, 0, 0, 1]\n{speeds}"


def in_world(result: object, k: int = -1) -> np.ndarray:
    """The base's velocity in the world's axes."""
    q, v = (np.asarray(getattr(result, x)[k], float) for x in "qv")
    return np.asarray(coscrew.rotate_qv(q[3:7], v[:3]))


TIGHT = [("double", 1e-12), ("single", 1e-5)]


@pytest.mark.parametrize("step", [1e-3, 5e-3])
@pytest.mark.parametrize("precision, within", TIGHT)
def test_a_ball_rolls_downhill_at_five_sevenths(made: Made, precision: str, within: float,
                                                step: float) -> None:
    result = run(made(BALL + DOWNHILL + started(0.099)), until=2, step=step, precision=precision)
    wanted = 5 / 7 * G * math.sin(SLOPE) * 2
    assert abs(in_world(result)[0] / wanted - 1) < within


@pytest.mark.parametrize("step", [1e-3, 5e-3])
@pytest.mark.parametrize("precision, within", [("double", 1e-12), ("single", 1e-4)])
def test_a_sliding_ball_ends_rolling_at_five_sevenths(made: Made, precision: str, within: float,
                                                      step: float) -> None:
    result = run(made(BALL + LEVEL + started(0.099, 3)), until=2, step=step, precision=precision)
    assert abs(in_world(result)[0] / (5 / 7 * 3) - 1) < within


@pytest.mark.usefixtures("long_run")
@pytest.mark.parametrize("precision, within", [("double", 1e-9), ("single", 1e-5)])
def test_a_block_stays_on_a_slope_for_an_hour(made: Made, precision: str, within: float) -> None:
    text = BOX.replace("MU", "0.5") + DOWNHILL + started(0.049)
    result = run(made(text), until=3600, every=60, precision=precision)
    moved = np.asarray(result.q[-1, :3], float) - np.asarray(result.q[1, :3], float)
    assert np.abs(moved).max() < within


def test_a_block_slides_at_g_sin_less_mu_g_cos(made: Made) -> None:
    text = BOX.replace("MU", "0.2") + DOWNHILL + started(0.049)
    result = run(made(text), until=2)
    a = (in_world(result)[0] - in_world(result, 100)[0]) / (result.t[-1] - result.t[100])
    assert a == pytest.approx(G * (math.sin(SLOPE) - 0.2 * math.cos(SLOPE)), rel=1e-4)


@pytest.mark.parametrize("angle, tips", [(math.atan(0.5) - 0.05, False),
                                         (math.atan(0.5) + 0.05, True)])
def test_a_box_tips_where_its_weight_leaves_the_base(made: Made, angle: float, tips: bool) -> None:
    """Width 0.1, height 0.2: at tan α = 1/2; after 2 s it stands level or lies on its side."""
    text = BOX.replace("[0.2, 0.2, 0.1]", "[0.1, 0.1, 0.2]").replace("MU", "2\ndepth = 2e-5")
    g = f"[effects.gravity]\ng = [{G * math.sin(angle)!r}, 0, {-G * math.cos(angle)!r}]\n"
    result = run(made(text + g + started(0.1)), until=2, step=2e-4)
    assert not result.failed and result.t[-1] == 2
    assert abs(result.q[-1][4]) == pytest.approx(math.sqrt(0.5) if tips else 0, abs=1e-3)


def test_it_sinks_by_hertz_and_presses_with_its_weight(made: Made) -> None:
    record = '[outputs]\nrecord = ["q", "contact.ball.force", "contact.ball.energy"]\n'
    text = BALL.replace("mu = 0.5", "mu = 0.5\nk = 2e5") + LEVEL + started(0.0999) + record
    result = run(made(text), until=3)
    depth = (G / 2e5)**(2 / 3)
    assert 0.1 - result.q[-1, 2] == pytest.approx(depth, rel=1e-9)
    assert result.recorded["contact.ball.force.2"][-1] == pytest.approx(G, rel=1e-9)
    assert result.recorded["contact.ball.energy"][-1] == pytest.approx(
        0.4 * 2e5 * depth**2.5, rel=1e-9)


@pytest.mark.parametrize("k", [1e5, 1e7, 1e9])
@pytest.mark.parametrize("e", [0.9, 0.7, 0.5])
def test_a_bounce_keeps_the_share_that_is_wanted(made: Made, k: float, e: float) -> None:
    """Without gravity, at eleven phases of the step."""
    more = f"load = 10\nk = {k}\nrestitution = {e}\nspeed = 4.4\n"
    kernels, n, v = load_scene(made(BALL + more)), 11, 4.4
    q0, v0 = np.zeros((n, 10)), np.zeros((n, 6))
    q0[:, 2], q0[:, 6], v0[:, 2] = 0.1 + 1e-3 * v * (3 + np.arange(n) / n), 1, -v
    kept = run(kernels, until=0.05, every=0.05, q0=q0, v0=v0).v[:, -1, 2] / v
    assert np.abs(kept / e - 1).max() < 5e-3


@pytest.mark.parametrize("e", [0.2, 0.5, 0.9, 0.999])
def test_damping_of_a_restitution_solves_its_equation(e: float) -> None:
    y = 1.5 * damping_of(e, 2.0) * 2.0
    assert (1 + e) * y == pytest.approx(math.log((1 + y) / (1 - e * y)), rel=1e-9)
    assert damping_of(1.0, 2.0) == 0


def test_an_elastic_bounce_on_smooth_ground_keeps_its_energy(made: Made) -> None:
    text = BALL.replace("mu = 0.5", "mu = 0\nalpha = 0") + LEVEL + started(0.5, 1)
    result = run(made(text + '[outputs]\nrecord = ["energy"]\n'), until=3)
    energy = result.recorded["energy.total"]
    assert np.abs(energy / energy[0] - 1).max() < 5e-3


def test_tilted_ground_is_tilted_gravity(made: Made) -> None:
    """A ball on a plane of 20°, under gravity along -z, rolls as on level ground under tilted
    gravity."""
    n = [math.sin(SLOPE), 0, math.cos(SLOPE)]
    ground = f"[effects.ground]\nnormal = {n}\noffset = 2\n"
    start = f"[start.q]\nfree = {[2.099 * x for x in n] + [0, 0, 0, 1]}\n"
    result = run(made(BALL + LEVEL + ground + start), until=2)
    downhill = in_world(result) @ [math.cos(SLOPE), 0, -math.sin(SLOPE)]
    assert abs(downhill / (5 / 7 * G * math.sin(SLOPE) * 2) - 1) < 1e-11


def test_heights_of_a_slope_are_a_tilted_plane(made: Made) -> None:
    ends = []
    start = f"[start.q]\nfree = [0, 0, {0.0995 / math.cos(SLOPE)!r}, 0, 0, 0, 1]\n"
    for ground in (f'height = "{-math.tan(SLOPE)!r}*x"',
                   f"normal = [{math.sin(SLOPE)!r}, 0, {math.cos(SLOPE)!r}]"):
        text = f"{BALL}{LEVEL}[effects.ground]\n{ground}\n{start}"
        ends.append(run(made(text), until=1).q[-1])
    assert np.abs(ends[0] - ends[1]).max() < 1e-12


def test_a_ball_on_smooth_hills_keeps_its_energy(made: Made) -> None:
    ground = '[effects.ground]\nheight = "0.03*sin(6*x)*cos(6*y)"\n'
    text = BALL.replace("mu = 0.5", "mu = 0\nalpha = 0") + LEVEL + ground
    result = run(made(text + started(0.16, 0.3, 0.2) + '[outputs]\nrecord = ["energy"]\n'), until=3)
    energy = result.recorded["energy.total"]
    assert np.abs(energy / energy[0] - 1).max() < 1e-2
    assert np.ptp(result.q[:, 0]) > 0.1


@pytest.mark.parametrize("ground, words", [
    ('height = "0.1*x"\nnormal = [0, 0, 1]', "height and normal are given; wanted heights or a"),
    ('height = "0.1*z"', "unknown name 'z'.*; formulas know x, y, pi"),
    ("height = 3", "wanted a function of x and y"),
    ('height = "1/x"', "is not finite at x = y = 0")])
def test_ground_that_cannot_be_is_refused(made: Made, ground: str, words: str) -> None:
    with pytest.raises(SceneError, match=words):
        read_scene(made(f"{BALL}{LEVEL}[effects.ground]\n{ground}\n"))


def test_a_disc_rolls_at_two_thirds(made: Made) -> None:
    """A wheel with I = m r²/2 on its rim: g sin α/(1 + 1/2)."""
    text = """
[bodies]
wheel = { mass = 1, inertia = [0.0025, 0.005, 0.0025] }
[joints]
free = { type = "free", child = "wheel" }
[effects.contact.wheel]
shape = "disc"
radius = 0.1
axis = [0, 1, 0]
mu = 0.5
"""
    result = run(made(text + DOWNHILL + started(0.099)), until=1)
    assert abs(in_world(result)[0] / (2 / 3 * G * math.sin(SLOPE)) - 1) < 1e-11


def test_a_capsule_has_two_ends_and_a_box_eight_corners(made: Made) -> None:
    scene = read_scene(made(BALL.replace('"sphere"', '"capsule"\nlength = 0.4\naxis = [0, 2, 0]')
                            + LEVEL))
    ends = [x for x in scene.effects if x.effect.name == "contact"]
    assert [x.name for x in ends] == ["contact.ball.0", "contact.ball.1"]
    assert [x.values["point"] for x in ends] == [(0, Fraction(-1, 5), 0), (0, Fraction(1, 5), 0)]
    corners = read_scene(made(BOX.replace("MU", "1") + LEVEL)).effects
    points = {x.values["point"] for x in corners if x.effect.name == "contact"}
    assert points == {(x, y, z) for x in (Fraction(-1, 10), Fraction(1, 10))
                      for y in (Fraction(-1, 10), Fraction(1, 10))
                      for z in (Fraction(-1, 20), Fraction(1, 20))}


def test_the_load_is_the_weight_over_the_contacts(made: Made) -> None:
    corners = [x.values for x in read_scene(made(BOX.replace("MU", "1") + LEVEL)).effects
               if x.effect.name == "contact"]
    assert len(corners) == 8
    for values in corners:
        assert values["load"] == Fraction("9.81") / 8
        assert float(values["k"]) == pytest.approx(G / 8 / 1e-3**1.5, rel=1e-12)
        assert values["k_t"] == Fraction("9.81") / 8 * 1000
        assert float(values["d_t"]) == pytest.approx(
            0.4 * math.sqrt(G / 8 * 1000 * G / 8 / G), rel=1e-12)


@pytest.mark.parametrize("more, words", [
    ("", "without gravity no weight presses on the ground; wanted load in N"),
    ("load = 1\nk = 1e5\ndepth = 1e-3\n", "depth and k are given; wanted one"),
    ("load = 1\nalpha = 1\nrestitution = 0.5\n", "restitution and alpha are given; wanted one"),
    ("load = 1\nrestitution = 1.5\n", "wanted a restitution of at most 1"),
    ("load = 1\nsize = [1, 1, 1]\n", "is for shape = 'box'; the shape is 'sphere'"),
    ("load = 1\nbodies = []\n", "wanted names of bodies, each once"),
    ("load = 1\nshap = 3\n", "did you mean 'shape'")])
def test_what_cannot_be_is_refused(made: Made, more: str, words: str) -> None:
    with pytest.raises(SceneError, match=words):
        read_scene(made(BALL + more))


def test_friction_has_no_default(made: Made) -> None:
    with pytest.raises(SceneError, match="effects.contact.ball.mu: missing"):
        read_scene(made(BALL.replace("mu = 0.5", "") + LEVEL))


def test_ground_that_nothing_touches_is_told(made: Made) -> None:
    text = BALL[:BALL.index("[effects")] + "[effects.ground]\n" + LEVEL
    assert any("nothing touches it" in x for x in read_scene(made(text)).unused)


def test_a_ball_bounces_as_by_another_solver(made: Made) -> None:
    """With small steps, to 1e-7 m over four bounces; the other solver's figures are those of its
    module."""
    known = committed.read("bouncing_ball")
    assert [x.value for x in bouncing_ball.figures(bouncing_ball.TIMES[:2])] == [
        x.value for x in known[:4]]
    text = (SCENES / "bouncing_ball.toml").read_text()
    result = run(made(text), step=2e-5, precision="double")
    for x in known:
        place = result.q if x.quantity == "q.free.2" else result.v
        ours = place[round(float(x.at) / 0.01), 2]
        assert abs(ours - float(x.value)) < (1e-7 if x.quantity == "q.free.2" else 2e-4)


def feet(kernels: Kernels, q: np.ndarray) -> np.ndarray:
    """The places of the quadruped's feet."""
    poses = kernels.double.body_poses(np.asarray(q, float))
    return np.array([pose[:, :3] @ (0, 0, -0.21) + pose[:, 3] for name, pose in zip(
        kernels.interface.bodies, poses, strict=True) if name.endswith("shank")])


def test_a_robot_lands_and_its_feet_stay_where_they_stand() -> None:
    """Ten seconds after it has come to rest: less than a nanometre, and its weight is carried."""
    kernels = load_scene(SCENES / "landing.toml")
    landed = run(kernels, until=6, every=6, precision="double")
    later = run(kernels, until=16, every=1, start=landed, precision="double")
    assert np.abs(feet(kernels, later.q[-1]) - feet(kernels, later.q[0])).max() < 1e-9
    record = kernels.double
    forces = sum(getattr(record, name)(later.q[-1], later.v[-1])[0] for name in dir(record)
                 if name.startswith("effect_contact_feet"))
    assert forces == pytest.approx([0, 0, 16.4 * G], abs=1e-9)


@pytest.mark.parametrize("base", [(0, 0), (1000, 500)], ids=["here", "1 km away"])
def test_a_robot_stands_for_a_minute_in_single_precision(made: Made, base: tuple[float, float]
                                                         ) -> None:
    """On bent legs, no two alike: its feet move by some micrometres, although joints rest between
    two numbers; nor does the run stop as if rounding froze them."""
    text = (SCENES / "landing.toml").read_text().partition("[expect]")[0].replace(
        '"quadruped.urdf"', f'"{SCENES / "quadruped.urdf"}"')
    for name, old, new in (("fl_abduct", 0, 0.1), ("rr_abduct", 0, -0.15), ("fr_swing", 0.9, 1.1),
                           ("fr_knee", -1.6, -1.9)):
        text = text.replace(f"{name} = {old}", f"{name} = {new}", 1)
    kernels = load_scene(made(text))
    start = run(kernels, until=6, every=6, precision="double")
    q = np.asarray(start.q[-1])
    q[:2] += base
    later = run(kernels, until=60, every=10, q0=q, v0=start.v[-1], precision="single")
    assert not later.failed and later.t[-1] == 60
    assert np.abs(feet(kernels, later.q[-1]) - feet(kernels, later.q[1])).max() < 1e-5


@pytest.mark.parametrize("precision", ["double", "single"])
def test_batches_have_the_bits_of_one_state(precision: str) -> None:
    kernels, n = load_scene(SCENES / "landing.toml"), 5
    one = run(kernels, until=0.35, precision=precision)
    q0 = np.repeat(one.q[:1].astype(float), n, 0)
    q0[:, 2] += 0.01 * np.arange(n)
    many = run(kernels, until=0.35, precision=precision, q0=q0)
    alone = run(kernels, until=0.35, precision=precision, q0=q0[3])
    assert many.q[3].tobytes() == alone.q.tobytes()
    assert many.q[0].tobytes() == one.q.tobytes()
