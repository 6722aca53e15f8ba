"""The command line `coscrew generate`, `coscrew simulate`, …: parses options, runs the command.

Only the command that runs is imported.  Modules of commands import packages besides NumPy only when
they run, so that help needs no extra."""

import argparse
import sys
from importlib import import_module

from coscrew_codegen.program.reported_error import ReportedError
from coscrew_codegen.runtime import extras

COMMANDS = {
    "generate": "coscrew_codegen.cli.generate_command",
    "simulate": "coscrew_codegen.cli.simulate_command",
    "check": "coscrew_codegen.cli.check_command",
    "certificate": "coscrew_codegen.cli.certificate_command",
    "cost": "coscrew_codegen.cli.cost_command",
    "sweep": "coscrew_codegen.cli.sweep_command",
    "identify": "coscrew_codegen.cli.identify_command",
    "import": "coscrew_codegen.cli.import_command",
    "effects": "coscrew_codegen.cli.effects_command",
    "schema": "coscrew_codegen.cli.schema_command",
    "report": "coscrew_codegen.cli.report_command",
    "cache": "coscrew_codegen.cli.cache_command"}
"""The module of each command, which adds its options and runs it."""


def run(arguments: list[str] | None) -> int:
    """Run the command line; returns the exit status: the command's, or 2 for an error."""
    words = sys.argv[1:] if arguments is None else arguments
    try:
        _refuse_unknown(words[0] if words else "")
        options = _parser(words[0] if words else "").parse_args(words)
        return int(options.run(options))
    except ReportedError as error:
        print(f"coscrew: {error}", file=sys.stderr)
        return 2


def _refuse_unknown(word: str) -> None:
    """Raises ReportedError for a word that is neither a command nor an option."""
    if word and not word.startswith("-") and word not in COMMANDS:
        from coscrew_codegen.scene.names import did_you_mean

        raise ReportedError(f"there is no command {word!r}; {did_you_mean(word, COMMANDS)}")


def _parser(command: str = "") -> argparse.ArgumentParser:
    """The parser of one command; of all commands if `command` is not one."""
    parser = argparse.ArgumentParser(
        prog="coscrew", description="Derives spatial algebra and emits C and Python kernels.",
        epilog=_installation(), formatter_class=argparse.RawDescriptionHelpFormatter)
    if command not in COMMANDS:
        from coscrew_codegen.backends.version import VERSION

        parser.add_argument("--version", action="version", version=f"coscrew {VERSION}",
                            help="print the version")
    commands = parser.add_subparsers(required=True, dest="command", metavar="COMMAND")
    for name in (command,) if command in COMMANDS else COMMANDS:
        import_module(COMMANDS[name]).add_parser(commands)
    if command in COMMANDS:
        its = commands.choices[command]
        its.epilog = " ".join(x for x in (its.epilog, _needed(command)) if x)
    return parser


def _needed(command: str) -> str:
    """Returns the command that installs the missing packages, and their names."""
    extra = extras.COMMANDS[command]
    return extras.lacking(f"not installed: {command}", extra) or f"Needs {extras.pip(extra)}."


def _installation() -> str:
    """The commands by their extras, and how to install these."""
    lines = ["packages that the commands need:"]
    for extra in dict.fromkeys(extras.COMMANDS.values()):
        names = ", ".join(name for name, its in extras.COMMANDS.items() if its == extra)
        here = "not installed" if extras.lacking(names, extra) else "installed"
        lines.append(f"  {names:<31} {extras.pip(extra)}  ({here})")
    return "\n".join(lines)
