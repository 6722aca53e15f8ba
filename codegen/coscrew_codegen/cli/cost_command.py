"""`coscrew cost`: options, measurements, tables, JSON, a figure, a page."""

import argparse
import shlex
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from coscrew_codegen.cli.name_lists import Names
from coscrew_codegen.cli.simulate_command import add_scene, scene_of, tell_unused

if TYPE_CHECKING:
    from coscrew_codegen.reports.cost.needs.need import Need

_LEAST, _MOST = 4, 10_000  # states


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add `cost` to the command line."""
    parser = commands.add_parser(
        "cost", help="measure what accuracy and effects cost in a scene",
        description="Measure the errors and times of a scene's functions in every tier and "
        "precision and recommend one; operations and times with and without each effect; errors "
        "and times of runs.")
    add_scene(parser)
    parser.add_argument("--function", "--functions", metavar="NAME", action=Names, default=[],
                        dest="functions", help="measure only the errors and times of this "
                                               "function in all tiers; several with commas, or "
                                               "repeated; \"all\" stands for all functions")
    parser.add_argument("--need", metavar="FUNCTION=NUMBER", type=_need, action="append",
                        default=[], dest="needs",
                        help="name the cheapest tier and precision in which this function errs by "
                        "at most NUMBER, in its unit, here and on a Cortex-M4F; with a unit, as "
                        "\"inverse_dynamics=1e-3 N m\", of the results in it; may be repeated")
    parser.add_argument("--states", metavar="N", type=_states, default=64,
                        help="compare with 50 digits at about N states: a quarter of the run, half "
                        "between the limits, a quarter that a search finds, of these at least one "
                        "for each tier, precision and unit (default: 64)")
    parser.add_argument("--json", metavar="FILE", type=Path, help="write all figures: .json")
    parser.add_argument("--page", metavar="FILE", type=Path,
                        help="write a page with plots and tables: .html")
    parser.add_argument("--plot", metavar="FILE", type=Path, help="write a figure: .svg or .png")
    parser.add_argument("--digits", metavar="N", type=_digits,
                        help="compute the reference of runs with N digits, 20 to 60: slow, and of "
                             "smooth scenes only")
    parser.set_defaults(run=run)


def _digits(text: str) -> int:
    return _number(text, 20, 60)


def _need(text: str) -> "Need":
    from coscrew_codegen.reports.cost.needs.need import read

    try:
        return read(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def _states(text: str) -> int:
    return _number(text, _LEAST, _MOST)


def _number(text: str, least: int, most: int) -> int:
    if not (text.isascii() and text.isdecimal() and least <= int(text) <= most):
        raise argparse.ArgumentTypeError(f"wanted a number from {least} to {most}; got {text!r}")
    return int(text)


def run(options: argparse.Namespace) -> int:
    """Measure, print and write; returns the exit status."""
    from coscrew_codegen.program.values.formats import BY_NAME
    from coscrew_codegen.reports.cost import cost_json, cost_measurement
    from coscrew_codegen.reports.cost.cost_request import CostRequest
    from coscrew_codegen.reports.cost.figures import cost_figure, cost_page
    from coscrew_codegen.reports.cost.measured import Counts
    from coscrew_codegen.runtime.load import kernels_for
    from coscrew_codegen.simulation.recordings.recording_writer import FIGURES, check_target
    from coscrew_codegen.simulation.run_summary import RunOverrides

    for path, endings in ((options.json, (".json",)), (options.page, (".html",)),
                          (options.plot, FIGURES)):
        if path:
            check_target(path, endings)
    read = scene_of(options, None)
    emitted = ("single",) if read.precision == "single" else read.precisions
    scene = replace(read, precision="both", precisions=tuple(BY_NAME))
    request = CostRequest(tuple(options.functions), Counts.of(options.states), options.digits,
                          emitted, tuple(options.needs))
    costs = cost_measurement.measure(
        kernels_for(scene, request.needed(scene, options.integrator)),
        RunOverrides(options.until, options.step, options.integrator, "both",
                     tuple(options.settings)), request)
    tell_unused(read, options.verbose)
    print(cost_page.page(costs, _words(options)).text())
    if options.json:
        cost_json.write(costs, options.json, _words(options))
    if options.page:
        cost_page.write(costs, options.page, _words(options))
    if options.plot:
        cost_figure.plot(costs, options.plot)
    return 0


def _words(options: argparse.Namespace) -> str:
    """The command, without folders and files that it writes."""
    given = {"until": options.until, "step": options.step, "integrator": options.integrator,
             "digits": options.digits, "states": options.states if options.states != 64 else None}
    return " ".join(("coscrew cost", options.scene.name,
                     *(f"--function {name}" for name in options.functions),
                     *(f"--need {shlex.quote(str(need))}" for need in options.needs),
                     *(f"--set {name}={value:g}" for name, value in options.settings),
                     *(f"--{name} {value}" for name, value in given.items() if value)))
