"""`coscrew cost`: options, measurements, tables, a figure."""

import argparse
from pathlib import Path

from coscrew_codegen.simulate.command import add_scene, scene_of


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add `cost` to the command line."""
    parser = commands.add_parser(
        "cost", help="measure what a scene costs, effect by effect",
        description="Measure operations and times of a scene's functions, with and without each "
        "effect, and what accuracy costs in time.")
    add_scene(parser)
    parser.add_argument("--plot", metavar="FILE", type=Path, help="a figure: .svg or .png")
    parser.add_argument("--digits", metavar="N", type=_digits,
                        help="compute the reference with N digits, 20 to 60: slow, and of smooth "
                             "scenes only")
    parser.set_defaults(run=run)


def _digits(text: str) -> int:
    if not (text.isascii() and text.isdecimal() and 20 <= int(text) <= 60):
        raise argparse.ArgumentTypeError(f"wanted a number from 20 to 60; got {text!r}")
    return int(text)


def run(options: argparse.Namespace) -> int:
    """Measure and print; returns the exit status."""
    from coscrew_codegen.cost import measure, plot, table
    from coscrew_codegen.cost.leaving_out import whole
    from coscrew_codegen.simulate.load import kernels_for
    from coscrew_codegen.simulate.outcome import RunOverrides
    from coscrew_codegen.simulate.write import FIGURES, check_target

    if options.plot:
        check_target(options.plot, FIGURES)
    scene = scene_of(options, "both")
    costs = measure.measure(kernels_for(scene, whole(scene)), RunOverrides(
        options.until, options.step, options.integrator, "both", tuple(options.settings)),
        options.digits)
    print(table.table(costs))
    if options.plot:
        plot.plot(costs, options.plot)
    return 0
