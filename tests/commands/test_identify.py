"""`coscrew identify`: estimates are within their standard errors of the parameters with which data
were made; physical arms are physical; exciting motions excite and keep limits."""

import csv
import runpy
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen import load_scene, run
from coscrew_codegen.__main__ import main
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.simulation.identification import (
    arm_regressor,
    base_estimate,
    consistent_estimate,
    measurements,
)
from coscrew_codegen.simulation.recordings import recording_writer

EXAMPLES = Path(__file__).parents[2] / "examples"
JOINTS = ("pan", "lift", "slide")
SCENE = """
[bodies]
base = { mass = 3, com = [0.1, 0, 0.2], inertia = [0.2, 0.3, 0.1] }
beam = { mass = 2, com = [0.3, 0, 0.1], inertia = [0.05, 0.2, 0.2] }
sled = { mass = 1, com = [0, 0.1, 0.2], inertia = [0.01, 0.02, 0.02] }
[joints]
pan = { type = "revolute", child = "base", axis = [0, 0, 1], limits = { lower = -2, upper = 1, \
velocity = 3, effort = 90 } }
lift = { type = "revolute", parent = "base", child = "beam", axis = [0, 1, 0], \
origin = { xyz = [0.2, 0, 0.3] }, limits = { lower = -1, upper = 2, velocity = 2, effort = 90 } }
slide = { type = "prismatic", parent = "beam", child = "sled", axis = [1, 0, 0], \
origin = { xyz = [0.4, 0, 0] }, limits = { lower = 0, upper = 0.5, velocity = 1, effort = 90 } }
[effects.gravity]
[effects.viscous]
joints = "all"
d = { pan = 1, lift = 2, slide = 3 }
[effects.coulomb]
joints = "all"
tau_c = 0.5
eps = 0.01
"""
REAL = SCENE.replace("mass = 2", "mass = 2.7").replace("com = [0, 0.1, 0.2]", "com = [0, 0.2, 0.1]"
                    ).replace("lift = 2, slide", "lift = 0.7, slide").replace("0.05, 0.2, 0.2",
                                                                              "0.09, 0.3, 0.3")
Columns = dict[str, np.ndarray]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two arms: the scene, and the real one; a motion that excites them."""
    folder = tmp_path_factory.mktemp("identify")
    (folder / "arm.toml").write_text(SCENE)
    (folder / "real.toml").write_text(REAL)
    assert main(["identify", str(folder / "arm.toml"), "--excite", str(folder / "motion.csv"),
                 "--duration", "5"]) == 0
    return folder


def columns(path: Path) -> Columns:
    """The columns of a file by name, without units."""
    with path.open(newline="") as file:
        header, *rows = csv.reader(file)
    return dict(zip((name.split(" ")[0] for name in header), np.array(rows, float).T, strict=True))


def states(given: Columns) -> list[np.ndarray]:
    """q, v, a."""
    return [np.stack([given[f"{x}.{joint}"] for joint in JOINTS], 1) for x in "qva"]


@pytest.fixture(scope="module")
def true_torques(folder: Path) -> np.ndarray:
    """The torques of the real arm in the motion, from its inverse dynamics."""
    real = load_scene(folder / "real.toml", functions=["inverse_dynamics"])
    return np.asarray(real.double.inverse_dynamics(*states(columns(folder / "motion.csv"))))


def write(path: Path, given: Mapping[str, np.ndarray]) -> Path:
    """A file of data."""
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(given)
        writer.writerows(np.stack(list(given.values()), 1).tolist())
    return path


def measured(folder: Path, tau: np.ndarray, leave_out: str = "") -> Columns:
    """The motion's columns, without those of some symbols, and torques."""
    motion = {name: x for name, x in columns(folder / "motion.csv").items()
              if name[0] not in leave_out}
    return {**motion, **{f"tau.{joint}": tau[:, k] for k, joint in enumerate(JOINTS)}}


def noisy(tau: np.ndarray, part: float, seed: int = 0) -> np.ndarray:
    """Torques with noise of a part of each joint's largest."""
    rng = np.random.default_rng(seed)
    return tau + part * np.abs(tau).max(0) * rng.normal(size=tau.shape)


def arms(folder: Path) -> tuple[arm_regressor.ArmRegressor, np.ndarray]:
    """The scene's arm, and the base parameters of the real one."""
    arm, real = (arm_regressor.arm_of(read_scene(folder / f"{x}.toml")) for x in ("arm", "real"))
    assert arm.base_names == real.base_names
    return arm, real.beta


def estimate(folder: Path, given: Columns, cutoff: float | None = None
             ) -> tuple[arm_regressor.ArmRegressor, base_estimate.Estimate, np.ndarray]:
    """(the arm, the estimate from data, the truth)."""
    arm, truth = arms(folder)
    data = measurements.read(write(folder / "data.csv", given), arm.coordinates, cutoff)
    return arm, base_estimate.estimated(arm, *base_estimate.stacked(arm, data, cutoff)), truth


def test_base_parameters_are_listed(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """With combinations and the scene's values: the slide's mass, and its friction."""
    assert main(["identify", str(folder / "arm.toml")]) == 0
    shown = capsys.readouterr().out
    arm, _ = arms(folder)
    assert shown.startswith(f"{len(arm.base_names)} base parameters of 36 parameters")
    assert all(name in shown for name in arm.base_names)
    assert "sled.m" in arm.base_names and "coulomb.slide.tau_c" in arm.base_names


def test_without_noise_parameters_are_exact(folder: Path, true_torques: np.ndarray) -> None:
    """To the rounding of the data times the condition."""
    _, result, truth = estimate(folder, measured(folder, true_torques))
    bound = 64 * 2.0**-53 * result.condition * np.abs(truth).max()
    assert np.abs(result.beta - truth).max() <= bound
    assert (result.explained > 1 - 1e-12).all()


def test_standard_errors_are_those_of_estimates(folder: Path, true_torques: np.ndarray) -> None:
    """Over 40 draws of noise, errors over standard errors have the deviation 1 and the mean 0, and
    residuals the deviation of the noise."""
    arm, truth = arms(folder)
    motion = columns(folder / "motion.csv")
    Y, rest = arm.at(motion["t"], *states(motion))
    scores, noise = [], 0.02 * np.abs(true_torques).max(0)
    for seed in range(40):
        result = base_estimate.estimated(
            arm, motion["t"], Y, noisy(true_torques, 0.02, seed) - rest)
        scores.append((result.beta - truth) / result.errors)
        assert np.abs(result.deviations / noise - 1).max() < 0.15
    z, count = np.array(scores), len(scores) * len(truth)
    assert abs(z.std() - 1) < 5 / np.sqrt(2 * count)
    assert np.abs(z.mean(0)).max() < 4 / np.sqrt(len(scores))


def test_velocities_and_accelerations_come_from_filtered_positions(
        folder: Path, true_torques: np.ndarray) -> None:
    """With noise of an encoder of 16 bits, and of torques: within 3 % of the largest parameters;
    without a filter the error is more than twice as large."""
    given = measured(folder, noisy(true_torques, 0.01), leave_out="va")
    rng = np.random.default_rng(2)
    for joint in JOINTS:
        given[f"q.{joint}"] = given[f"q.{joint}"] + 1e-4 * rng.normal(size=len(given["t"]))
    arm, result, truth = estimate(folder, given, cutoff=8.0)
    large = np.abs(truth) > 0.2 * np.abs(truth).max()
    assert large.sum() >= 5
    assert (np.abs(result.beta - truth)[large] <= 0.03 * np.abs(truth)[large]).all()
    _, worse, _ = estimate(folder, given)
    assert np.abs(worse.beta - truth).max() > 2 * np.abs(result.beta - truth).max()


def test_physical_arms_are_physical_and_nearer_the_truth(folder: Path, true_torques: np.ndarray
                                                         ) -> None:
    """Pseudo-inertias are positive definite and friction is not negative, where the estimate from
    much noise has neither; noise explains the distance."""
    nearer = 0
    for seed in range(5):
        arm, result, truth = estimate(folder, measured(folder, noisy(true_torques, 0.3, seed)))
        physical = consistent_estimate.nearest(arm, result)
        for k in range(3):
            m, hx, hy, hz, xx, yy, zz, xy, xz, yz = physical.pi[10 * k:10 * k + 10]
            I = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
            J = np.block([[np.trace(I) / 2 * np.eye(3) - I, np.array([[hx], [hy], [hz]])],
                          [np.array([[hx, hy, hz, m]])]])
            assert np.linalg.eigvalsh(J).min() > 0
        assert (physical.pi[30:] >= 0).all()
        assert np.allclose(arm.K @ physical.pi, physical.beta, rtol=1e-12, atol=1e-12)
        assert physical.within
        own, other = (np.linalg.norm(result.R @ (x - truth))
                      for x in (result.beta, physical.beta))
        nearer += other < own
    assert nearer >= 4


def test_an_arm_that_cannot_exist_is_told_by_the_exit_status(
        folder: Path, true_torques: np.ndarray, capsys: pytest.CaptureFixture[str]) -> None:
    """Friction that drives."""
    v = states(columns(folder / "motion.csv"))[1]
    data = write(folder / "odd.csv", measured(folder, noisy(true_torques, 1e-3) - 5 * v))
    assert main(["identify", str(folder / "arm.toml"), str(data)]) == 1
    assert "no physical arm has this estimate" in capsys.readouterr().out


def test_files_and_plots(folder: Path, true_torques: np.ndarray) -> None:
    """The estimate's file reads back; with --consistent it has all parameters of the arm."""
    data = write(folder / "data.csv", measured(folder, noisy(true_torques, 0.01)))
    words = ["identify", str(folder / "arm.toml"), str(data), "--output", str(folder / "out.csv")]
    arm, result, _ = estimate(folder, measured(folder, noisy(true_torques, 0.01)))
    assert main([*words, "--plot", str(folder / "residuals.svg")]) == 0
    assert "residual" in (folder / "residuals.svg").read_text()
    with (folder / "out.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["name"] for row in rows] == list(arm.base_names)
    assert [float(row["estimate"]) for row in rows] == result.beta.tolist()
    assert [float(row["standard error"]) for row in rows] == result.errors.tolist()
    assert main([*words, "--consistent"]) == 0
    with (folder / "out.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["name"] for row in rows] == [*arm.names, *arm.base_names]


def test_exciting_motions_keep_limits_and_excite(folder: Path) -> None:
    """They start and end at rest, are repeated, and are better than random ones."""
    motion = columns(folder / "motion.csv")
    q, v, a = states(motion)
    assert (q.min(0) >= [-2, -1, 0]).all() and (q.max(0) <= [1, 2, 0.5]).all()
    assert (np.abs(v).max(0) <= [3, 2, 1]).all()
    assert np.abs(v[0]).max() < 1e-12 and np.abs(a[0]).max() < 1e-12
    step = motion["t"][1]
    ends = np.concatenate((q[-1:], q[:2]))
    assert np.abs((ends[2] - ends[0]) / (2 * step)).max() < 0.05 * np.abs(v).max()
    inner = (q[2:] - q[:-2]) / (2 * step)
    assert np.abs(inner - v[1:-1]).max() < 0.02 * np.abs(v).max()


def test_a_better_conditioned_motion_is_written(folder: Path, capsys: pytest.CaptureFixture[str]
                                                 ) -> None:
    assert main(["identify", str(folder / "arm.toml"), "--excite", str(folder / "other.csv"),
                 "--duration", "5"]) == 0
    words = capsys.readouterr().out.split()
    condition, usual = float(words[-8].rstrip(",")), float(words[-7])
    assert 1 < condition < 0.8 * usual
    assert (folder / "other.csv").read_bytes() == (folder / "motion.csv").read_bytes()


def test_recordings_of_driven_arms_are_data(tmp_path: Path) -> None:
    """A run of an arm with motors: the torques of its motors determine its parameters."""
    motors = ('[effects.actuator]\nkind = "pd"\njoints = "all"\nkp = 400\nkd = 40\n'
              'target = { pan = "sin(3*t) - 0.5", lift = "cos(2*t)", slide = "0.2*sin(5*t)" }\n'
              '[outputs]\nrecord = ["q", "v", "actuator.*.torque"]\nevery = 0.005\n'
              "[run]\nduration = 6\n")
    (tmp_path / "arm.toml").write_text(SCENE + motors)
    recording_writer.write(run(tmp_path / "arm.toml").recording, tmp_path / "run.csv")
    arm = arm_regressor.arm_of(read_scene(tmp_path / "arm.toml"))
    data = measurements.read(tmp_path / "run.csv", arm.coordinates, None)
    result = base_estimate.estimated(arm, *base_estimate.stacked(arm, data, None))
    assert (result.explained > 0.999).all()
    large = np.abs(arm.beta) > 0.2 * np.abs(arm.beta).max()
    assert (np.abs(result.beta - arm.beta)[large] < 0.05 * np.abs(arm.beta)[large]).all()


def test_the_example_finds_friction_and_payload(tmp_path: Path) -> None:
    """The friction of the elbow, 8 N m s/rad, and the moment of the payload about the roll's axis,
    within 5 standard errors."""
    example = runpy.run_path(str(EXAMPLES / "identification/identify.py"))
    assert example["identify"](tmp_path) == 0
    with (tmp_path / "estimate.csv").open(newline="") as file:
        rows = {row["name"]: row for row in csv.DictReader(file) if row["kind"] != "parameter"}
    row = rows["viscous.elbow.d"]
    assert abs(float(row["estimate"]) - 8) < 5 * float(row["standard error"]) < 0.5
    row = rows["flange.mz"]  # -0.01 m of the payload's 3 kg
    assert abs(float(row["estimate"]) + 0.03) < 5 * float(row["standard error"]) < 0.01
    assert (tmp_path / "residuals.png").stat().st_size > 10_000


@pytest.mark.parametrize("change, message", (
    (lambda x: {k: y for k, y in x.items() if k != "tau.lift"}, "no column 'tau.lift'"),
    (lambda x: {k: y for k, y in x.items() if k[:3] != "tau"}, "no columns tau.pan"),
    (lambda x: {k.replace("q.pan", "q.pan [deg]"): y for k, y in x.items()},
     "column 'q.pan' is in deg; wanted rad"),
    (lambda x: {**x, "t": x["t"][::-1]}, "times do not increase"),
    (lambda x: {**x, "tau.pan": x["t"] * np.nan}, "column 'tau.pan' has 'nan'; wanted finite"),
    (lambda x: {k: y[:3] for k, y in x.items()}, "3 samples of 3 torques; wanted more"),
    (lambda x: {k: y if k == "t" or k[:3] == "tau" else y * 0 for k, y in x.items()},
     "the motion does not determine all base parameters, such as")))
def test_data_that_cannot_be_used_are_refused(folder, true_torques, capsys, change, message):
    data = write(folder / "bad.csv", change(measured(folder, true_torques)))
    assert main(["identify", str(folder / "arm.toml"), str(data)]) == 2
    assert message in capsys.readouterr().err


@pytest.mark.parametrize("words, message", (
    (["--output", "x.csv"], "are about an estimate; wanted DATA"),
    (["data.csv", "--cutoff", "99"], "--cutoff 99: wanted less than half of the 100 samples"),
    (["none.csv"], "cannot read")))
def test_options_that_cannot_be_used_are_refused(folder, true_torques, capsys, monkeypatch, words,
                                                 message):
    monkeypatch.chdir(folder)
    write(folder / "data.csv", measured(folder, true_torques))
    assert main(["identify", "arm.toml", *words]) == 2
    assert message in capsys.readouterr().err


def test_floating_bases_are_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "free.toml").write_text(
        "[bodies]\na = { mass = 1, inertia = [1, 1, 1] }\n[joints]\n"
        'j = { type = "free", child = "a" }\n')
    assert main(["identify", str(tmp_path / "free.toml")]) == 2
    assert "joint 'j' is free; wanted an arm" in capsys.readouterr().err
