"""`coscrew check`: options, the checks, a table."""

import argparse

from coscrew_codegen.simulate.command import add_scene, scene_of


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add `check` to the command line."""
    parser = commands.add_parser(
        "check", help="check a scene's run",
        description="Check a scene's run: its expectations, the balance of energy, both "
        "precisions, inverse and forward dynamics.",
        epilog="The exit status is 0 if all expectations are met; 1 if one is not, or a run stops "
        "before its end, or energy or the momentum of what floats free is off by more than 0.001; "
        "2 for an error; 130 for an interrupt.")
    add_scene(parser)
    parser.add_argument("--strict", action="store_true",
                        help="exit with 1 also if energy is off by more than rounding and more "
                             "than 1e-5, or no less with smaller steps")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Check; returns the exit status: 0, or 1 if an expectation is not met, a run stops early,
    energy or momentum is not kept, or with --strict not kept well."""
    from coscrew_codegen.simulate import check, needs, outcome, verdict
    from coscrew_codegen.simulate.load import kernels_for

    scene = scene_of(options, options.precision)
    kernels = kernels_for(scene, needs.of_check(scene, options.integrator))
    findings = check.check(kernels, outcome.Asked(
        options.until, options.step, options.integrator, options.precision,
        tuple(options.settings)))
    print(verdict.table(findings))
    return 0 if (findings.strictly_passed if options.strict else findings.passed) else 1
