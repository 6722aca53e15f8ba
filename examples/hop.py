"""Makes a leg hop to a height: hop.c, a controller that reads the force under the foot, compiled
with the C that is generated for examples/scenes/hopper.toml without its own motor.

Usage: python examples/hop.py
"""

import subprocess
import tempfile
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from coscrew_codegen.__main__ import main as coscrew

HERE = Path(__file__).parent
MOTOR = '[effects.actuator.leg]\nkind = "torque"\ntorque = "-60*sin(5*pi*t)"\n'


def scene() -> str:
    """The hopper, whose leg is moved by torques alone."""
    text = (HERE / "scenes/hopper.toml").read_text(encoding="utf-8")
    text, _, _ = text.replace(MOTOR, "").partition("[outputs]")
    return text.replace('precision = "both"', 'functions = ["contacts", "step_leapfrog_tau"]')


def run(folder: Path, compiler: str = "cc") -> NDArray[np.float64]:
    """A line for each half millisecond: time in s, height in m, force under the foot and of the
    motor in N."""
    (folder / "hopper.toml").write_text(scene(), encoding="utf-8")
    coscrew(["generate", str(folder / "hopper.toml"), "--output", str(folder)])
    subprocess.run([compiler, "-O3", "-ffp-contract=off", "-I", folder, folder / "hopper.c",
                    HERE / "hop.c", "-o", folder / "hop", "-lm"], check=True)
    done = subprocess.run([folder / "hop"], check=True, capture_output=True, text=True)
    return np.array([line.split() for line in done.stdout.splitlines()], float)


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        t, height, press, _ = run(Path(folder)).T
    last = height[t > t[-1] - 1]
    print(f"it hops to {last.max():.4f} m, and presses with {press[t > 10].mean():.3f} N, on "
          "average")


if __name__ == "__main__":
    main()
