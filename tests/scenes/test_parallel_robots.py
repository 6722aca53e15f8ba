"""The examples with closed loops against mechanics written here once more: a Delta robot by
Lagrange's equations in six coordinates, a platform on six legs and ankles by virtual work."""

import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import root
from scipy.spatial.transform import Rotation

from coscrew_codegen import run

FOLDER = Path(__file__).parents[2] / "examples/scenes"
G = 9.81


def written(name: str) -> dict[str, Any]:
    """The tables of an example."""
    return tomllib.loads((FOLDER / f"{name}.toml").read_text(encoding="utf-8"))


def expected(name: str) -> dict[tuple[str, float], tuple[float, float]]:
    """(value, tolerance) of an example's figures."""
    figures = {key: x if isinstance(x, list) else [x] for key, x in written(name)["expect"].items()}
    return {(key, x["at"]): (x["value"], x["atol"]) for key, own in figures.items() for x in own}


# a Delta robot


ROD, ARM, BASE, PLATE = 0.4, 0.2, 0.15, 0.05
TARGETS = ((0.4, 6), (0.4, 8), (-0.4, 7))
RADIAL = np.array([[np.cos(a), np.sin(a), 0] for a in np.arange(3) * 2 * np.pi / 3])


def delta_rates(t: float, y: np.ndarray) -> np.ndarray:
    """(x', θ', x'', θ''): masses, and one constraint |d| = ROD an arm, since its rods are parallel.
    """
    tables = written("delta")["bodies"]
    arm, m = tables["arm1"], tables["platform"]["mass"]
    lever = arm["mass"] * arm["com"][0]
    I = arm["inertia"][1] + lever * arm["com"][0]
    x, angles, u, w = y[:3], y[3:6], y[6:9], y[9:]
    c, s, up = np.cos(angles)[:, None], np.sin(angles)[:, None], np.array([0, 0, 1])
    along, across = c * RADIAL - s * up, -s * RADIAL - c * up
    d = x + (PLATE - BASE) * RADIAL - ARM * along
    moved = u - ARM * w[:, None] * across
    J = np.hstack([d, np.diag(-ARM * (d * across).sum(1))])
    rates = (moved**2).sum(1) + ARM * w**2 * (d * along).sum(1)
    motors = [30 * (0.3 + a * np.sin(n * t) - q) - 0.4 * v
              for (a, n), q, v in zip(TARGETS, angles, w, strict=True)]
    forces = [0, 0, -m * G, *(motors + lever * G * c[:, 0])]
    M = np.diag([m] * 3 + [I] * 3)
    A = np.block([[M, J.T], [J, np.zeros((3, 3))]])
    return np.concatenate([u, w, np.linalg.solve(A, [*forces, *-rates])[:6]])


def delta_start() -> np.ndarray:
    out = BASE + ARM * np.cos(0.3) - PLATE
    return np.array([0, 0, -ARM * np.sin(0.3) - np.sqrt(ROD**2 - out**2), *[0.3] * 3, *[0] * 6])


def test_a_delta_robot_moves_as_lagranges_equations_say() -> None:
    figures = expected("delta")
    times = sorted({at for _, at in figures})
    y = solve_ivp(delta_rates, (0, times[-1]), delta_start(), "DOP853", times, rtol=1e-11,
                  atol=1e-12).y
    names = [*(f"position.platform.{k}" for k in range(3)), *(f"q.shoulder{k}" for k in (1, 2, 3))]
    known = {(name, t): y[i, k] for i, name in enumerate(names) for k, t in enumerate(times)}
    assert len(figures) >= 4
    for key, (value, atol) in figures.items():
        assert known[key] == pytest.approx(value, abs=atol / 2), key


# a platform on six legs


def legs(tables: dict[str, Any]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Feet on the world, balls on the platform, lengths that motors want."""
    feet = [tables["joints"][f"foot{k}"]["origin"]["xyz"] for k in range(1, 7)]
    balls = [tables["loops"][f"ball{k}"]["second"] for k in range(1, 7)]
    targets = tables["effects"]["actuator"]["target"]  # "length - change*exp(-4*t*t)"
    wanted = [float(targets[f"slide{k}"].split()[0]) for k in range(1, 7)]
    return np.array(feet), np.array(balls), np.array(wanted)


def turned(n: np.ndarray) -> np.ndarray:
    """R = (1 - n~)⁻¹ (1 + n~), by Cayley; also of complex numbers."""
    x, y, z = n
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.linalg.solve(np.eye(3) - K, np.eye(3) + K)


def lengths(tables: dict[str, Any], pose: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Lengths of the legs at a pose, in closed form, and the heights of their directions."""
    feet, balls, _ = legs(tables)
    d = balls @ turned(pose[3:]).T + pose[:3] - feet
    l = np.sqrt((d**2).sum(1))
    return l, d[:, 2] / l


def potential(tables: dict[str, Any], pose: np.ndarray) -> complex:
    """Weights of platform, tubes and rods, and the motors' springs."""
    bodies, k = tables["bodies"], tables["effects"]["actuator"]["kp"]
    l, up = lengths(tables, pose)
    com = turned(pose[3:]) @ bodies["platform"]["com"] + pose[:3]
    tube, rod = bodies["tube1"], bodies["rod1"]
    weights = tube["mass"] * tube["com"][2] * up + rod["mass"] * (l + rod["com"][2]) * up
    springs = k * (legs(tables)[2] - l)**2 / 2
    return G * (bodies["platform"]["mass"] * com[2] + weights.sum()) + springs.sum()


def at_rest(tables: dict[str, Any]) -> np.ndarray:
    """The pose at which the potential energy is stationary, by complex steps."""
    def gradient(pose: np.ndarray) -> list[float]:
        return [potential(tables, pose + 1e-30j * unit).imag / 1e-30 for unit in np.eye(6)]

    solved = root(gradient, [0, 0, 0.9, 0, 0, 0.1], tol=1e-13)
    assert abs(np.array(gradient(solved.x))).max() < 1e-9
    return solved.x


def test_a_platform_on_six_legs_rests_where_virtual_work_is_zero() -> None:
    tables, figures = written("stewart"), expected("stewart")
    pose = at_rest(tables)
    l, _ = lengths(tables, pose)
    forces = tables["effects"]["actuator"]["kp"] * (legs(tables)[2] - l)
    n = pose[3:] / np.sqrt(1 + pose[3:] @ pose[3:])
    known = {f"q.plate.{k}": x for k, x in enumerate(
        [*pose[:3], *n, 1 / np.sqrt(1 + pose[3:] @ pose[3:])])}
    for k in range(6):
        known[f"q.slide{k + 1}"] = l[k]
        known[f"actuator.slide{k + 1}.torque"] = forces[k]
    assert len(figures) >= 9
    for (name, _), (value, atol) in figures.items():
        assert known[name] == pytest.approx(value, abs=atol / 2), name


# a biped with parallel ankles


SIDES, RODS = {"left": 1, "right": -1}, {"inner": -1, "outer": 1}
CORNERS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) / 2
STEP = 1e-5  # rad


def turn(angle: float, axis: str) -> np.ndarray:
    """R about an axis."""
    return np.asarray(Rotation.from_euler(axis, angle).as_matrix())


class Leg:
    """A shank with its foot: points in the shank's frame, from the tables of the example."""

    def __init__(self, tables: dict[str, Any], side: str):
        self.bodies, self.side = tables["bodies"], side
        joints, sole = tables["joints"], tables["effects"]["contact"]["soles"]
        self.ankle = np.array(joints[f"{side}_ankle"]["origin"]["xyz"])
        self.hubs = {x: np.array(joints[f"{side}_{x}_crank"]["origin"]["xyz"]) for x in RODS}
        self.rods = {x: tables["loops"][f"{side}_{x}"] for x in RODS}
        self.corners = np.array(sole["point"]) + CORNERS * sole["size"]

    def foot(self, ankle: np.ndarray, points: np.ndarray) -> np.ndarray:
        """Points of the foot."""
        return self.ankle + points @ (turn(ankle[0], "y") @ turn(ankle[1], "x")).T

    def crank(self, rod: str, ankle: np.ndarray) -> float:
        """The angle at which the rod has its length: a c + b s = w, the larger solution."""
        heel = self.foot(ankle, np.array(self.rods[rod]["second"])) - self.hubs[rod]
        tip = np.array(self.rods[rod]["first"])
        w = (heel @ heel + tip @ tip - self.rods[rod]["length"]**2) / 2
        a, b = tip[0] * heel[0], -tip[0] * heel[2]
        ways = np.arctan2(b, a) + np.array([1, -1]) * np.arccos(w / np.hypot(a, b))
        return float(min((ways + np.pi) % (2 * np.pi) - np.pi, key=abs))

    def positions(self, ankle: np.ndarray) -> np.ndarray:
        """Corners of the sole, centres of mass of the foot and of both cranks."""
        foot = self.foot(ankle, np.array([*self.corners, self.bodies[f"{self.side}_foot"]["com"]]))
        arms = [self.hubs[x] + turn(self.crank(x, ankle), "y")
                @ self.bodies[f"{self.side}_{x}"]["com"] for x in RODS]
        return np.array([*foot, *arms])

    @property
    def weights(self) -> list[float]:
        """The weights of the foot and of both cranks."""
        return [G * self.bodies[f"{self.side}_{x}"]["mass"] for x in ("foot", *RODS)]


def last(values: Any, name: str, count: int) -> np.ndarray:
    """The components of a recorded quantity at the end."""
    return np.array([values[f"{name}.{i}"][-1] for i in range(count)])


def test_motors_of_ankles_hold_what_virtual_work_says() -> None:
    """A foot that turns about one of the ankle's axes, while the shank stands and rods keep their
    lengths: the ground's forces, weights and both motors do no work."""
    record = ["contact.soles.*.force", "actuator.*_crank.torque", "pose.*_shank"]
    result = run(FOLDER / "biped.toml", until=30, every=1, precision="double", record=record)
    its, q, values = result.system, result.q[-1], result.recorded
    assert abs(result.v[-1]).max() < 1e-6
    places, upwards = {c.joint: c.q for c in its.functions.coordinates}, 0.0
    for side in SIDES:
        leg, ankle = Leg(written("biped"), side), q[places[f"{side}_ankle"]]
        R = last(values, f"pose.{side}_shank", 12).reshape(3, 4)[:, :3]
        forces = [last(values, f"contact.soles.{side}_foot.{k}.force", 3) for k in range(8)]
        upwards += sum(f[2] for f in forces)
        forces += [[0, 0, -weight] for weight in leg.weights]
        motors = [values[f"actuator.{side}_{x}_crank.torque"][-1] for x in RODS]
        for x in RODS:
            own = q[places[f"{side}_{x}_crank"]][0]
            assert leg.crank(x, ankle) == pytest.approx(own, abs=1e-12)
        for axis in np.eye(2):
            ahead, behind = (ankle + sign * STEP * axis for sign in (1, -1))
            moved = (leg.positions(ahead) - leg.positions(behind)) @ R.T / (2 * STEP)
            turned_by = [(leg.crank(x, ahead) - leg.crank(x, behind)) / (2 * STEP) for x in RODS]
            outer, own = (moved * forces).sum(), np.dot(turned_by, motors)
            assert outer == pytest.approx(-own, abs=1e-6)
        assert abs(motors[0]) > 0.5
    weight = G * sum(x["mass"] for x in written("biped")["bodies"].values())
    assert upwards == pytest.approx(weight, abs=1e-5)
