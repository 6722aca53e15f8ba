"""Moves a six-joint arm by model-predictive control at 1 kHz: predictive.c, compiled with the C
that is generated for the arm of examples/scenes/arm6.toml, without its motors' own controllers.

Usage: python examples/predictive.py [FIGURE]
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from coscrew_codegen.__main__ import main as coscrew

HERE = Path(__file__).parent
FUNCTIONS = 'functions = ["inverse_dynamics", "step_leapfrog_tau", "step_leapfrog_tau_derivatives"]'


def scene() -> str:
    """The arm with friction and payload, moved by torques alone."""
    text, _, _ = (HERE / "scenes/arm6.toml").read_text(encoding="utf-8").partition(
        "[effects.actuator]")
    return text.replace('runtime = ["payload.mass"]', FUNCTIONS).replace('"both"', '"double"')


def run(folder: Path, compiler: str = "cc") -> NDArray[np.float64]:
    """A line for each millisecond: time in s, 6 coordinates, 6 torques, µs that control took."""
    (folder / "arm.toml").write_text(scene(), encoding="utf-8")
    coscrew(["generate", str(folder / "arm.toml"), "--output", str(folder)])
    subprocess.run([compiler, "-O3", "-march=native", "-ffp-contract=off", "-I", folder,
                    folder / "arm.c", HERE / "predictive.c", "-o", folder / "predictive", "-lm"],
                   check=True)
    done = subprocess.run([folder / "predictive"], check=True, capture_output=True, text=True)
    return np.array([line.split() for line in done.stdout.splitlines()], float)


def draw(log: NDArray[np.float64], path: Path) -> None:
    """Writes a figure of the motion."""
    from matplotlib.figure import Figure
    figure = Figure(figsize=(8, 3), layout="constrained")
    of_q, of_tau = figure.subplots(1, 2)
    of_q.plot(log[:, 0], log[:, 1:7])
    of_tau.plot(log[:, 0], log[:, 7:13] / [150, 150, 150, 28, 28, 28])
    of_q.set(xlabel="t in s", ylabel="q in rad")
    of_tau.set(xlabel="t in s", ylabel="torque / limit")
    of_q.legend(["pan", "lift", "elbow", "bend", "swing", "roll"], fontsize="small")
    figure.savefig(path)


def main(*figure: str) -> None:
    with tempfile.TemporaryDirectory() as folder:
        log = run(Path(folder))
    print(f"control takes {np.median(log[:, 13]):.0f} µs of one core a millisecond, the median; at "
          f"most {log[:, 13].max():.0f}")
    for path in figure:
        draw(log, Path(path))


if __name__ == "__main__":
    main(*sys.argv[1:])
