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
        "before its end, or with --strict a balance of energy is doubtful; 2 for an error; 130 "
        "for an interrupt.")
    add_scene(parser)
    parser.add_argument("--strict", action="store_true",
                        help="exit with 1 also if a balance of energy is doubtful: off by more "
                             "than rounding, and no less with smaller steps")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Check; returns the exit status: 0, or 1 if an expectation is not met, a run stops early, or
    with --strict a balance of energy is doubtful."""
    from coscrew_codegen.simulate.load import load_scene
    from coscrew_codegen.simulate import check, outcome

    findings = check.check(load_scene(scene_of(options, options.precision)), outcome.Asked(
        options.until, options.step, options.integrator, options.precision,
        tuple(options.settings)))
    print(check.table(findings))
    return 1 if not findings.passed or options.strict and findings.doubtful else 0
