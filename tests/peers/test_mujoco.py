"""MuJoCo simulates the same: arms and free bodies with gravity, springs, dampers and rotors.

Both read the same decimals, as MJCF and as TOML. Dry friction and limits are left out: MuJoCo
treats them as constraints, by another formula.  Both integrate by Runge and Kutta's method with
steps h and h/2.  For hinges and slides the method is the same, so that runs may differ by amplified
rounding errors (runs.py).  Rotations of a free base are integrated by different formulas, so that
the runs with h/2 may also differ by the sum of both programs' changes from h to h/2: at any order
above 1, the error of each is less than its change.
"""

import random
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.simulation.system import system
from tests.references.figures import Figure
from tests.support.scenes import runs
from tests.support.scenes.selecting import checked

mujoco = pytest.importorskip("mujoco", reason="no wheel for this platform")

STEP, DURATION = 1e-3, 1.0
STATES = 20
CASES = {"arm3": (False, "rrr"), "arm5": (False, "prrpr"), "arm7": (False, "rrrrrrr"),
         "body": (True, ""), "hopper": (True, "rpr")}
"""True if the base is free, and the joints: revolute, prismatic."""


@dataclass(frozen=True)
class Link:
    """A body and the joint it hangs on; decimals as both files hold them."""

    kind: str  # r, p; of a free base f
    place: str
    quaternion: str  # x y z w; MuJoCo's is w x y z
    axis: str
    mass: str
    com: str
    moments: str  # xx yy zz xy xz yz about the centre of mass
    damping: str
    stiffness: str
    rest: str
    armature: str
    q: str
    v: str


def links(name: str) -> tuple[Link, ...]:
    """A chain of the case's joints, its numbers drawn by its name."""
    free, kinds = CASES[name]
    return tuple(_drawn(random.Random(f"{name} {i}"), kind, i == 0)
                 for i, kind in enumerate(("f" if free else "") + kinds))


def _drawn(draw: random.Random, kind: str, first: bool) -> Link:
    def decimals(count: int, low: float, high: float) -> str:
        return " ".join(f"{draw.uniform(low, high):.3f}" for _ in range(count))

    half = np.array([draw.uniform(0.03, 0.2) for _ in range(3)])  # of a box in a random orientation
    turn = np.linalg.qr(np.array([[draw.gauss(0, 1) for _ in range(3)] for _ in range(3)]))[0]
    mass = draw.uniform(0.5, 3)
    I = turn @ np.diag((half @ half - half**2) * mass / 3) @ turn.T
    places = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
    moments = " ".join(f"{I[place]:.5f}" for place in places)
    unit = np.array([draw.gauss(0, 1) for _ in range(4)])
    quaternion = "0 0 0 1" if kind == "f" else " ".join(
        repr(float(x)) for x in np.roll(unit, -1) / np.linalg.norm(unit))
    place = "0 0 0" if first else decimals(3, -0.3, 0.3)
    return Link(kind, place, quaternion, decimals(3, 0.1, 1), f"{mass:.3f}",
                decimals(3, -0.1, 0.1), moments, decimals(1, 0.05, 0.5), decimals(1, 1, 30),
                decimals(1, -0.5, 0.5), decimals(1, 0.01, 0.1), decimals(1, -1, 1),
                decimals(6 if kind == "f" else 1, -1, 1))


def toml(chain: Sequence[Link], name: str) -> str:
    """Our scene."""
    free = chain[0].kind == "f"
    lines = [f'name = "{name}"', 'base = "free"' if free else "", "[effects.gravity]"]
    for i, x in enumerate(chain):
        lines += [f"[bodies.b{i}]", f"mass = {x.mass}", f"com = {_list(x.com)}",
                  f"inertia = {_list(x.moments)}"]
        if x.kind == "f":
            lines += ["[start.v]", f"base = {_list(x.v)}"]
            continue
        lines += [f"[joints.j{i}]", f'type = "{ {"r": "continuous", "p": "prismatic"}[x.kind] }"',
                  f'parent = "{f"b{i - 1}" if i else "world"}"', f'child = "b{i}"',
                  f"axis = {_list(x.axis)}",
                  f"origin = {{ xyz = {_list(x.place)}, quaternion = {_list(x.quaternion)} }}",
                  f"[effects.viscous.j{i}]", f"d = {x.damping}",
                  f"[effects.spring.j{i}]", f"k = {x.stiffness}", f"q0 = {x.rest}",
                  f"[effects.armature.j{i}]", f"inertia = {x.armature}"]
    moved = [(i, x) for i, x in enumerate(chain) if x.kind != "f"]
    lines += ["[start]", *(f"q.j{i} = {x.q}" for i, x in moved)]
    if not free:
        lines += [f"v.j{i} = {x.v}" for i, x in moved]
    else:
        lines[lines.index("[start.v]") + 1] += "".join(f"\nj{i} = {x.v}" for i, x in moved)
    return "\n".join([*lines, f"[run]\nstep = {STEP}\nduration = {DURATION}\n"])


def _list(decimals: str) -> str:
    return f"[{', '.join(decimals.split())}]"


def mjcf(chain: Sequence[Link]) -> str:
    """MuJoCo's model; its own additional forces are switched off."""
    inner = ""
    for i, x in reversed(tuple(enumerate(chain))):
        joint = "<freejoint/>" if x.kind == "f" else (
            f'<joint type="{ {"r": "hinge", "p": "slide"}[x.kind] }" axis="{x.axis}" '
            f'damping="{x.damping}" stiffness="{x.stiffness}" springref="{x.rest}" '
            f'armature="{x.armature}"/>')
        *vector, scalar = x.quaternion.split()
        quaternion = " ".join((scalar, *vector))
        inner = (f'<body name="b{i}" pos="{x.place}" quat="{quaternion}">{joint}<inertial '
                 f'pos="{x.com}" mass="{x.mass}" fullinertia="{x.moments}"/>{inner}</body>')
    return ('<mujoco><compiler angle="radian" balanceinertia="false" autolimits="false"/>'
            f'<option gravity="0 0 -9.81" integrator="RK4" timestep="{STEP}">'
            '<flag contact="disable" constraint="disable"/></option>'
            f'<worldbody>{inner}</worldbody></mujoco>')


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    return tmp_path_factory.mktemp("scenes")


@cache
def ours(name: str, folder: Path) -> Kernels:
    path = folder / f"{name}.toml"
    path.write_text(toml(links(name), name))
    return checked(path, "rk4", others=("bias_torques",), precisions=("double",))


@cache
def theirs(name: str) -> "mujoco.MjModel":
    return mujoco.MjModel.from_xml_string(mjcf(links(name)))


def reordered(free: bool, q: np.ndarray, by: int) -> np.ndarray:
    """q with a free base's quaternion rolled by 1 into MuJoCo's order w, x, y, z; by −1 back."""
    return np.concatenate((q[:3], np.roll(q[3:7], by), q[7:])) if free else q


def frames(free: bool, q: np.ndarray, nv: int) -> np.ndarray:
    """T with v_MuJoCo = T v: MuJoCo has a free base's velocity in the world's axes. (nv, nv)."""
    T = np.eye(nv)
    if free:
        R = np.zeros(9)
        mujoco.mju_quat2Mat(R, np.roll(q[3:7], 1))
        T[:3, :3] = R.reshape(3, 3)
    return T


def states(its: Kernels, free: bool) -> list[tuple[np.ndarray, np.ndarray]]:
    """The initial state, and random ones."""
    draw, first = np.random.default_rng(0), system(its, "double").start()
    results = [first]
    for _ in range(STATES - 1):
        q, v = (draw.uniform(-1.5, 1.5, x.shape) for x in first)
        if free:
            q[3:7] /= np.linalg.norm(q[3:7])
        results.append((q, v))
    return results


@pytest.mark.parametrize("name", CASES)
def test_mass_matrix_and_bias_are_mujocos(name, folder):
    """To 1e-12 of the largest entry; our bias includes springs and dampers, which MuJoCo keeps
    separate."""
    its, model, free = ours(name, folder), theirs(name), CASES[name][0]
    data, mine = mujoco.MjData(model), system(its, "double")
    for q, v in states(its, free):
        T, coriolis = frames(free, q, model.nv), np.zeros(model.nv)
        data.qpos, data.qvel = reordered(free, q, 1), T @ v
        mujoco.mj_forward(model, data)
        M = np.zeros((model.nv, model.nv))
        mujoco.mj_fullM(model, data, M)
        if free:  # d/dt (R v) = R (v' + ω × v)
            coriolis[:3] = T[:3, :3] @ np.cross(v[3:6], v[:3])
        bias = T.T @ (data.qfrc_bias - data.qfrc_passive + M @ coriolis)
        M = T.T @ M @ T
        mass = mine.call("mass_matrix", q=q)
        assert np.max(np.abs(mass - M)) <= 1e-12 * np.max(np.abs(M))
        tau = mine.call("bias_torques", t=0, q=q, v=v)
        assert np.max(np.abs(tau - bias)) <= 1e-12 * np.max(np.abs(bias))


def run(name: str, step: float, folder: Path) -> tuple[Figure, ...]:
    """MuJoCo's results after DURATION, in our quantities."""
    model, free = theirs(name), CASES[name][0]
    data, its = mujoco.MjData(model), system(ours(name, folder), "double")
    q, v = its.start()
    data.qpos, data.qvel = reordered(free, q, 1), frames(free, q, model.nv) @ v
    model.opt.timestep = step
    for _ in range(round(DURATION / step)):
        mujoco.mj_step(model, data)
    q = reordered(free, data.qpos, -1)
    v = frames(free, q, model.nv).T @ data.qvel
    columns = []
    for c in its.functions.coordinates:
        for kind, state, places in (("q", q, c.q), ("v", v, c.v)):
            columns += [Figure(f"{kind}.{c.joint}" + (f".{i}" if len(places) > 1 else ""),
                               str(DURATION), repr(float(state[k]))) for i, k in enumerate(places)]
    return tuple(columns)


@pytest.mark.parametrize("name", CASES)
def test_runs_of_a_second_are_mujocos(name, folder):
    rough, fine = (run(name, step, folder) for step in (STEP, STEP / 2))
    result = runs.compared(ours(name, folder), fine, "double", "rk4", STEP)
    for x in result:
        change = max(abs(float(a.value) - float(b.value)) for a, b in zip(rough, fine, strict=True)
                     if a.quantity[0] == x.quantity)
        print(f"{x.quantity}: {x.error:.2g} of {change:.2g} + {x.integration:.2g}"
              f" + {x.rounding:.2g}")
        halving = change + x.integration if CASES[name][0] else 0
        assert x.error <= halving + 2 * x.rounding < 1e-6, x
