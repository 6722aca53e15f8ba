"""Planar and universal joints move as two slides and a hinge, and two hinges, with massless frames
between them do: in every function, precision, tier, integrator and language."""

from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np
import pytest

from coscrew_codegen import load_scene, run
from coscrew_codegen.__main__ import main
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.runtime.load import Kernels, kernels_for
from coscrew_codegen.scene.effects import EFFECTS
from coscrew_codegen.scene.integrators import ADAPTIVE, EMITTED
from coscrew_codegen.scene.mechanism.model import WORLD, Body, Joint, Model, Placement
from coscrew_codegen.scene.mechanism.rotations import from_rpy
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.each import each_precision
from tests.support.scenes.generated_scenes import imported
from tests.support.scenes.kinds import Kind
from tests.support.scenes.mechanisms import HERE
from tests.support.truth import newton_euler

G = (Fraction(1), Fraction(2), Fraction(-9))
ARM = """
[bodies]
pillar = { mass = 3, com = [0.1, 0.2, 0.3], inertia = [1, 2, 2.5, 0.1, 0.2, -0.1] }
puck = { mass = 2, com = [0.2, -0.1, 0.3], inertia = [0.5, 0.6, 0.7, 0.05, -0.1, 0.02] }
cross = { mass = 1.5, com = [-0.3, 0.1, 0.2], inertia = [0.4, 0.3, 0.5, 0, 0.1, 0.05] }
tip = { mass = 1, com = [0, 0.2, 0.4], inertia = [0.2, 0.3, 0.25] }
[joints]
turret = { type = "revolute", child = "pillar", axis = [1, 2, 3], \
origin = { xyz = [0.5, 0, 1], rpy = [0.3, 0.4, 0.5] } }
table = { type = "planar", parent = "pillar", child = "puck", axis = [1, -2, 0.5], \
origin = { xyz = [0.1, 0.2, 1], rpy = [-0.3, 0.2, 0.7] } }
wrist = { type = "universal", parent = "puck", child = "cross", axis = [2, 1, 0], \
axis2 = [-1, 2, 3], origin = { xyz = [0, 0.3, 0.2], rpy = [0.5, -0.4, 0.1] } }
slide = { type = "prismatic", parent = "cross", child = "tip", axis = [0, 1, 1], \
origin = { xyz = [0.2, 0, 0.1] } }
[effects.gravity]
g = [1, 2, -9]
"""
START = """
[start.q]
turret = 0.2
table = [0.1, -0.2, 0.3]
wrist = [0.4, -0.3]
[start.v]
turret = 0.5
table = [0.3, 0.2, -0.8]
wrist = [0.6, -0.7]
slide = 0.1
"""
COMPARED = ("inverse_dynamics", "forward_dynamics", "mass_matrix", "bias_torques", "energy",
            "power", "momentum", "body_poses", "body_twists", "jacobian_tip")
ROUNDED = 1e-48
"""What may be left of rounding axes and rotations to 50 digits."""
STEPS = tuple(x.step_name for x in EMITTED)


def expanded(model: Model) -> Model:
    """The model with slides and hinges, and massless frames between them."""
    bodies, joints = list(model.bodies), []
    for joint in model.joints:
        axes = joint.directions
        kinds = {Kind.PLANAR: (Kind.PRISMATIC, Kind.PRISMATIC, Kind.REVOLUTE),
                 Kind.UNIVERSAL: (Kind.REVOLUTE, Kind.REVOLUTE)}.get(joint.kind)
        if not kinds:
            joints.append(joint)
            continue
        names = [f"{joint.name}_{n}" for n in range(len(kinds) - 1)]
        bodies += [Body(name) for name in names]
        ends = (joint.parent, *names, joint.child)
        joints += [Joint(f"{joint.name}{n}", kind, ends[n], ends[n + 1],
                         joint.placement if n == 0 else HERE, axes[n])
                   for n, kind in enumerate(kinds)]
    return replace(model, bodies=tuple(bodies), joints=tuple(joints))


def states(count: int = 8) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """q, v, a of the arm: numbers of single precision."""
    rng = np.random.default_rng(5)
    return tuple(rng.uniform(-2, 2, (3, count, 7)).astype(np.float32).astype(float))


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("arm")
    (folder / "arm.toml").write_text(ARM + START)
    return folder


@pytest.fixture(scope="module")
def arm(folder: Path) -> Kernels:
    return load_scene(folder / "arm.toml", functions=[*COMPARED, *STEPS, "reaction_wrist"],
                      tiers=["accurate", "certified"])


@pytest.fixture(scope="module")
def chain(folder: Path) -> Kernels:
    """The chain with slides and hinges."""
    scene = read_scene(folder / "arm.toml", EFFECTS)
    return kernels_for(replace(scene, model=expanded(scene.model), start_q={}, start_v={}),
                       (*COMPARED, *STEPS))


@pytest.fixture(scope="module")
def truth(arm: Kernels) -> list[tuple[mpmath.matrix, mpmath.matrix]]:
    """(τ, M) at each state, by Newton's and Euler's laws to 70 digits."""
    model, result = expanded(arm.scene.model), []
    with mpmath.workdps(70):
        for q, v, a in zip(*states(), strict=True):
            q, v, a = ([mpmath.mpf(x) for x in y] for y in (q, v, a))
            none = [mpmath.mpf(0)] * 7
            still = (Fraction(0),) * 3
            columns = [newton_euler.inverse_dynamics(
                model, still, q, none, [mpmath.mpf(int(i == k)) for i in range(7)])
                for k in range(7)]
            result.append((mpmath.matrix(newton_euler.inverse_dynamics(model, G, q, v, a)),
                           mpmath.matrix(columns).T))
    return result


def off(result: np.ndarray, wanted: mpmath.matrix) -> float:
    """The largest difference relative to the largest component."""
    with mpmath.workdps(70):
        other = mpmath.matrix(result.tolist())
        apart = [abs(x - y) for x, y in zip(other, wanted, strict=True)]
        return float(max(apart) / max(abs(x) for x in wanted))


@each_precision
def test_inverse_dynamics_and_the_mass_matrix_are_newton_s_and_euler_s(arm, truth, precision):
    kernels, u = getattr(arm, precision.name), float(precision.u)
    for (tau, M), q, v, a in zip(truth, *states(), strict=True):
        assert off(np.array(kernels.inverse_dynamics(q, v, a)), tau) < 16 * u
        assert off(np.array(kernels.mass_matrix(q)), M) < 16 * u


@each_precision
def test_forward_dynamics_is_the_inverse(arm, truth, precision):
    """The error is that of a stable solution: u times the condition of M."""
    kernels, u = getattr(arm, precision.name), float(precision.u)
    for (tau, M), q, v, a in zip(truth, *states(), strict=True):
        rounded = np.array([float(x) for x in tau], precision.numpy_type)
        with mpmath.workdps(70):
            more = mpmath.lu_solve(M, mpmath.matrix(rounded.tolist()) - tau)
            wanted = mpmath.matrix(a.tolist()) + more
        condition = float(np.linalg.cond(np.array(M.tolist(), float)))
        assert off(np.array(kernels.forward_dynamics(q, v, rounded)), wanted) < 4 * condition * u


@pytest.mark.parametrize("tier", ("accurate", "certified"))
@each_precision
def test_tiers_keep_their_promises(arm, truth, precision: Precision, tier: str):
    """Accurate results are right to the last bit or so; certified ones are within their bounds."""
    kernels, u = getattr(getattr(arm, tier), precision.name), float(precision.u)
    for (tau, M), q, v, a in zip(truth, *states(), strict=True):
        for result, wanted in ((kernels.inverse_dynamics(q, v, a), tau),
                               (kernels.mass_matrix(q), M)):
            if tier == "accurate":
                assert off(np.array(result), wanted) < 2 * u
                continue
            values, bounds = (np.ravel(x).tolist() for x in result)
            with mpmath.workdps(70):
                most = 1e3 * u * max(abs(x) for x in wanted)
                assert all(abs(mpmath.mpf(x) - y) <= bound + ROUNDED and bound <= most
                           for x, y, bound in zip(values, wanted, bounds, strict=True))


def test_all_functions_are_those_of_slides_and_hinges(arm, chain):
    """Poses, twists and Jacobians of the bodies that both have."""
    q, v, a = states(64)
    for name in COMPARED:
        one, other = (getattr(x.double, name) for x in (arm, chain))
        given = {"mass_matrix": (q,), "body_poses": (q,), "jacobian_tip": (q,), "energy": (q, v),
                 "inverse_dynamics": (q, v, a), "forward_dynamics": (q, v, a)}.get(name, (q, v))
        result, wanted = (np.asarray(f(*given)) for f in (one, other))
        if name.startswith("body_"):
            names = [x.name for x in chain.scene.model.bodies]
            wanted = wanted[:, [names.index(x.name) for x in arm.scene.model.bodies]]
        size = np.abs(wanted).max(axis=tuple(range(1, wanted.ndim)), keepdims=True)
        assert (np.abs(result - wanted) <= 1e-11 * np.maximum(size, 1)).all(), name


@pytest.mark.parametrize("name", STEPS)
@each_precision
def test_steps_are_those_of_slides_and_hinges(arm, chain, precision, name):
    (q, v, _), u = states(4), float(precision.u)
    runs = []
    for kernels in (arm, chain):
        x, y = (part.astype(precision.numpy_type) / 4 for part in (q, v))
        for _ in range(50):
            x, y = getattr(getattr(kernels, precision.name), name)(1e-3, x, y)
        runs.append((x, y))
    for result, wanted in zip(*runs, strict=True):
        assert np.abs(result - wanted).max() < 1e4 * u


@pytest.mark.parametrize("name", ADAPTIVE)
def test_runs_of_scipy_end_where_ours_do(folder, name):
    """Within the tolerance, and the error of 2000 steps of rk4, which is less."""
    path = folder / f"{name}.toml"
    path.write_text(ARM + START + "[run]\nrtol = 1e-10\natol = 1e-12\n")
    wanted = run(path, until=0.5, integrator="rk4", step=2.5e-4)
    result = run(path, until=0.5, integrator=name)
    assert np.abs(result.q[-1] - wanted.q[-1]).max() < 1e-8
    assert np.abs(result.v[-1] - wanted.v[-1]).max() < 1e-7


@each_precision
def test_c_and_numpy_compute_the_same_bits(arm, tmp_path, precision):
    twin = getattr(imported(arm.functions, tmp_path), precision.name)
    q, v, a = (x.astype(precision.numpy_type) for x in states())
    for name in (*COMPARED, "reaction_wrist"):
        compiled = getattr(getattr(arm, precision.name), name)
        for args in ((q,), (q, v), (q, v, a)):
            if len(args) == len(arm.functions.named(name).inputs):
                assert np.asarray(compiled(*args)).tobytes() == \
                    np.asarray(getattr(twin, name)(*args)).tobytes(), name
    for name in STEPS:
        h = np.array(0.01, precision.numpy_type)
        for one, other in zip(getattr(getattr(arm, precision.name), name)(h, q, v),
                              getattr(twin, name)(h, q, v), strict=True):
            assert np.asarray(one).tobytes() == np.asarray(other).tobytes(), name


FLOATING = ARM.replace('turret = { type = "revolute", child = "pillar", axis = [1, 2, 3], ',
                       'base = { type = "free", child = "pillar", ').partition("[effects")[0]
START_FLOATING = START.replace("turret = 0.2\n", "").replace(
    "turret = 0.5", "base = [1, 2, 3, 0.5, -0.6, 0.7]")
RUN = '[outputs]\nrecord = ["momentum", "energy", "q"]\n[run]\nduration = 1\nstep = 5e-4\n'


@pytest.mark.parametrize("integrator", [x.name for x in EMITTED if x.order > 1])
def test_momentum_and_energy_are_kept_where_nothing_acts(tmp_path, integrator):
    path = tmp_path / "floating.toml"
    path.write_text(FLOATING + START_FLOATING + RUN)
    trajectory = run(path, integrator=integrator).recorded
    momentum = np.stack([trajectory[f"momentum.{k}"] for k in range(6)], -1)
    energy = trajectory["energy.kinetic"]
    assert np.abs(momentum - momentum[0]).max() < 1e-5 * np.abs(momentum[0]).max()
    assert np.abs(energy - energy[0]).max() < 1e-5 * energy[0]
    assert np.ptp(trajectory["q.wrist.1"]) > 0.1 and np.ptp(trajectory["q.table.2"]) > 0.1


@pytest.mark.parametrize("text", [ARM + START, FLOATING + START_FLOATING], ids=["arm", "floating"])
@pytest.mark.parametrize("precision", ["double", "single"])
def test_checks_pass(tmp_path, capsys, text, precision):
    path = tmp_path / "checked.toml"
    path.write_text(text + RUN)
    assert main(["check", str(path), "--precision", precision]) == 0, capsys.readouterr().out


def test_placements_are_used(arm):
    """The joints' frames are oblique, so that nothing above holds by chance."""
    assert all(x.placement.R != Placement(from_rpy(*[Fraction(0)] * 3), HERE.t).R
               for x in arm.scene.model.joints if x.parent != "cross")
    assert arm.scene.model.joints[0].parent == WORLD
