"""Identifies an arm whose payload and friction differ from its scene's, from noisy torques.

Usage: python examples/identification/identify.py FOLDER, where it writes the scene, a motion that
excites all base parameters, the torques measured in it, the estimate and a plot of residuals.
"""

import csv
import sys
from pathlib import Path

import numpy as np

import coscrew_codegen
from coscrew_codegen.__main__ import main

ARM = Path(__file__).parents[1] / "scenes/arm6.toml"
NOISE = 0.01  # of the largest torque of each joint


def real_torques(scene: str, folder: Path, columns: np.ndarray) -> np.ndarray:
    """The torques of the arm's motors: 3 kg as payload, twice the friction in the elbow."""
    real = folder / "real.toml"
    real.write_text(scene.replace("damping = 4.0", "damping = 8.0"), encoding="utf-8")
    its = coscrew_codegen.load_scene(real, functions=["inverse_dynamics"])
    q, v, a = np.split(columns, 3, axis=1)
    tau = np.asarray(its.double.inverse_dynamics([3.0], q, v, a))
    noise = np.random.default_rng(0).normal(size=tau.shape)
    return tau + NOISE * np.abs(tau).max(0) * noise


def measure(scene: str, folder: Path) -> None:
    """Write data.csv: the motion with the torques measured in it."""
    with (folder / "motion.csv").open(encoding="utf-8", newline="") as file:
        header, *rows = csv.reader(file)
    numbers = np.array(rows, float)
    tau = real_torques(scene, folder, numbers[:, 1:])
    joints = [name[2:].split(" ")[0] for name in header if name.startswith("q.")]
    with (folder / "data.csv").open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow([*header, *(f"tau.{joint} [N m]" for joint in joints)])
        writer.writerows(np.column_stack((numbers, tau)).tolist())


def identify(folder: Path) -> int:
    """Write everything to the folder; returns the exit status."""
    scene = ARM.read_text(encoding="utf-8").partition("[effects.actuator]")[0]
    arm = folder / "arm.toml"
    arm.write_text(scene, encoding="utf-8")
    main(["identify", str(arm), "--excite", str(folder / "motion.csv"), "--rate", "50"])
    measure(scene, folder)
    return main(["identify", str(arm), str(folder / "data.csv"), "--consistent", "--output",
                 str(folder / "estimate.csv"), "--plot", str(folder / "residuals.png")])


if __name__ == "__main__":
    sys.exit(identify(Path(sys.argv[1])))
