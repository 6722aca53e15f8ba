"""`coscrew identify`: base parameters of an arm, their estimate from data, exciting motions."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from coscrew_codegen.cli.simulate_command import add_model, positive, scene_of

if TYPE_CHECKING:
    from coscrew_codegen.simulation.identification.arm_regressor import ArmRegressor


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add `identify` to the command line."""
    parser = commands.add_parser(
        "identify", help="identify an arm's parameters from measured torques",
        description="Print the base parameters of an arm; with DATA, estimate them by weighted "
        "least squares, with standard errors, and find the nearest physical arm.",
        epilog="The exit status is 0; 1 if no physical arm has the estimate, beyond noise; 2 for "
        "an error.")
    parser.add_argument("scene", metavar="SCENE", type=Path,
                        help="a scene file (.toml) or a model's file; its actuators are left out")
    parser.add_argument("data", metavar="DATA", nargs="?", type=Path,
                        help="a CSV file with columns t, q.JOINT, tau.JOINT or "
                             "actuator.JOINT.torque, and, unless they are to be derived from q, "
                             "v.JOINT and a.JOINT")
    parser.add_argument("--cutoff", metavar="HZ", type=positive,
                        help="filter motion, torques and regressor without shifts of phase")
    parser.add_argument("--consistent", action="store_true",
                        help="write the nearest physical arm to --output, all of its parameters")
    parser.add_argument("--output", metavar="FILE", type=Path, help="write the estimate: .csv")
    parser.add_argument("--plot", metavar="FILE", type=Path,
                        help="plot torques and residuals: .svg or .png")
    parser.add_argument("--excite", metavar="FILE", type=Path,
                        help="write a motion that excites all base parameters: .csv")
    parser.add_argument("--duration", metavar="T", type=positive, default=10.0,
                        help="of that motion, in s (default: 10)")
    parser.add_argument("--rate", metavar="HZ", type=positive, default=100.0,
                        help="samples a second of that motion (default: 100)")
    parser.add_argument("--harmonics", metavar="N", type=_count, default=5,
                        help="in that motion (default: 5)")
    add_model(parser)
    parser.set_defaults(run=run)


def _count(text: str) -> int:
    number = int(text) if text.isdecimal() else 0
    if number < 2:
        raise argparse.ArgumentTypeError(f"wanted a whole number from 2; got {text!r}")
    return number


def run(options: argparse.Namespace) -> int:
    """Print, excite or estimate; returns the exit status: 0, or 1 if no physical arm has the
    estimate."""
    from coscrew_codegen.runtime import compilation
    from coscrew_codegen.simulation import SimulateError

    compilation.ask()
    from coscrew_codegen.simulation.identification import arm_regressor, estimate_report
    from coscrew_codegen.simulation.recordings import recording_writer

    for path, endings in ((options.output, (".csv",)), (options.excite, (".csv",)),
                          (options.plot, recording_writer.FIGURES)):
        if path:
            recording_writer.check_target(path, endings)
    if not options.data and (options.output or options.plot or options.cutoff):
        raise SimulateError("--output, --plot and --cutoff are about an estimate; wanted DATA")
    arm = arm_regressor.arm_of(scene_of(options, None))
    if options.excite:
        _excite(arm, options)
    if options.data:
        return _estimate(arm, options)
    if not options.excite:
        print(estimate_report.base_table(arm))
    return 0


def _excite(arm: "ArmRegressor", options: argparse.Namespace) -> None:
    from coscrew_codegen.simulation.identification import estimate_report, excitation

    motion = excitation.exciting(arm, options.duration, options.rate, options.harmonics)
    estimate_report.write_excitation(arm, motion, options.excite)
    print(f"{options.excite}: {len(motion.t)} states; condition of the weighted regressor "
          f"{motion.condition:.3g}, {motion.usual:.3g} for the median of random motions")


def _estimate(arm: "ArmRegressor", options: argparse.Namespace) -> int:
    from coscrew_codegen.simulation.identification import (
        base_estimate,
        consistent_estimate,
        estimate_report,
        measurements,
        residual_plot,
    )

    data = measurements.read(options.data, arm.coordinates, options.cutoff)
    estimate = base_estimate.estimated(arm, *base_estimate.stacked(arm, data, options.cutoff))
    physical = consistent_estimate.nearest(arm, estimate)
    print(estimate_report.estimate_table(arm, estimate, physical))
    if options.output:
        estimate_report.write_estimate(arm, estimate, physical if options.consistent else None,
                                       options.output)
    if options.plot:
        residual_plot.plot_residuals(arm, estimate, options.plot)
    return 0 if physical.within else 1
