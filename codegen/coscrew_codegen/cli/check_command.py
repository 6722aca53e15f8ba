"""`coscrew check`: options, the checks, a table."""

import argparse

from coscrew_codegen.cli.simulate_command import add_scene, scene_of, tell_unused
from coscrew_codegen.simulation.check.error_limits import ALLOWED, ENERGY, STRICTLY


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add `check` to the command line."""
    parser = commands.add_parser(
        "check", help="check a scene's run",
        description="Check a scene's run: its expectations, the balance of energy, both "
        "precisions, inverse and forward dynamics, their rounding errors.",
        epilog="The exit status is 0 if all expectations are met; 1 if one is not, or a run stops "
        f"before its end, is off by more than {ALLOWED:g} of the way a part moves, or cannot be "
        f"resolved, or energies do not balance within {ENERGY:g}, or a certified bound does not "
        "hold; 2 for an error; 130 for an interrupt.")
    add_scene(parser)
    parser.add_argument("--strict", action="store_true",
                        help=f"also exit with 1 if a part is off by more than {STRICTLY:g} of "
                             "the way it moves")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Check the scene; returns the exit status: 0, or 1 if an expectation is not met, a run stops
    early or is wrong (with --strict, by less), energies do not balance, or a certified bound does
    not hold."""
    from coscrew_codegen.runtime import compilation

    compilation.ask()
    from coscrew_codegen.runtime.load import kernels_for
    from coscrew_codegen.simulation import required_functions, run_summary
    from coscrew_codegen.simulation.check import check, check_report

    scene = scene_of(options, options.precision)
    kernels = kernels_for(scene, required_functions.of_check(scene, options.integrator))
    findings = check.check(kernels, run_summary.RunOverrides(
        options.until, options.step, options.integrator, options.precision,
        tuple(options.settings)), rounding=True)
    tell_unused(scene, options.verbose)
    print(check_report.table(findings, options.strict))
    return 0 if (findings.strictly_passed if options.strict else findings.passed) else 1
