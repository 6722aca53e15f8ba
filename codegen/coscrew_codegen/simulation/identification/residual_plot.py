"""Plots measured and estimated torques, and their residuals."""

from pathlib import Path

from matplotlib.figure import Figure

from coscrew_codegen.backends.html import plots
from coscrew_codegen.scene import units
from coscrew_codegen.simulation.identification.arm_regressor import ArmRegressor
from coscrew_codegen.simulation.identification.base_estimate import Estimate
from coscrew_codegen.simulation.recordings.recording_writer import delivered


@plots.styled
def plot_residuals(arm: ArmRegressor, x: Estimate, path: Path) -> None:
    """Draw torques, and residuals with two deviations to either side, a row for each joint, to an
    SVG or PNG.  Raises SimulateError."""
    count = len(arm.coordinates)
    figure = Figure(figsize=(9, 1.6 * count + 0.8), layout="constrained")
    axes = figure.subplots(count, 2, sharex=True, squeeze=False)
    for k, c in enumerate(arm.coordinates):
        left, right = axes[k]
        left.plot(x.t, x.measured[:, k], ".", color=plots.QUIET, markersize=2, label="measured")
        left.plot(x.t, x.measured[:, k] - x.residuals[:, k], linewidth=1, label="estimated")
        unit, *_ = units.torques((c.kind,))
        left.set_ylabel(f"{c.joint} [{unit}]")
        right.plot(x.t, x.residuals[:, k], ".", color="C1", markersize=2)
        for side in (-2, 2):
            right.axhline(side * x.deviations[k], color=plots.INK, linewidth=0.8, linestyle="--")
    axes[0][0].set_title("torque")
    axes[0][1].set_title("residual, and 2 deviations to either side")
    axes[0][0].legend(fontsize=7, loc="upper right")
    for axis in axes[-1]:
        axis.set_xlabel("t [s]")
    with delivered(path) as temporary:
        plots.write(figure, temporary)
