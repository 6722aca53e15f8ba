"""The command line: `coscrew generate`, `simulate`, …: options, and what they call."""

import argparse
import sys
from pathlib import Path

from tqdm import tqdm

from coscrew_codegen.cost import CostError
from coscrew_codegen.cost import command as cost
from coscrew_codegen.documentation import reference_files, schema
from coscrew_codegen.emit import (
    EmitError,
    differences,
    refuse_others,
    stale_files,
    write,
)
from coscrew_codegen.layout import Files, Programs, generated_files
from coscrew_codegen.mechanics import derive
from coscrew_codegen.mechanics.ranges import RangeError
from coscrew_codegen.operations import FAMILIES
from coscrew_codegen.programs import program_of
from coscrew_codegen.report import ReportError, command
from coscrew_codegen.scene.asked import AskedError
from coscrew_codegen.scene.assembly import ModelError
from coscrew_codegen.scene_files import catalogue
from coscrew_codegen.scene_files.errors import SceneError
from coscrew_codegen.scene_layout import scene_files
from coscrew_codegen.selection import LANGUAGES, Selection, SelectionError, select
from coscrew_codegen.simulate import SimulateError, check_command
from coscrew_codegen.simulate import command as simulate
from coscrew_codegen.version import VERSION

ERRORS = (SelectionError, EmitError, ReportError, SceneError, SimulateError, CostError, RangeError,
          ModelError, AskedError)
DEFAULT_OUTPUT = "generated"


def run(arguments: list[str] | None) -> int:
    """Run the command line; returns the exit status: 0, or 1 out of date, 2 for an error."""
    options = _parser().parse_args(arguments)
    try:
        return options.run(options)
    except ERRORS as error:
        print(f"coscrew: {error}", file=sys.stderr)
        return 2


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="coscrew", description="Derives spatial algebra and emits C and Python kernels.")
    parser.add_argument("--version", action="version", version=f"coscrew {VERSION}",
                        help="print the version")
    commands = parser.add_subparsers(required=True, dest="command", metavar="COMMAND")
    generate = commands.add_parser("generate", help="write the kernels, or check them",
                                   description="Write the kernels, or check that they are current.")
    generate.add_argument("scene", metavar="SCENE", nargs="?", type=Path,
                          help="a scene file: write its dynamics instead of the library's kernels")
    generate.add_argument("-o", "--output", metavar="DIR",
                          help=f"folder to write to (default: {DEFAULT_OUTPUT}; scenes need one)")
    generate.add_argument("--check", action="store_true",
                          help="write nothing; print what is out of date as a diff and exit 1")
    generate.add_argument("--family", metavar="NAME", nargs="+", action="extend",
                          help=f"only these families, of {', '.join(FAMILIES)}")
    generate.add_argument("--precision", metavar="NAME",
                          help="double, single or both (default)")
    generate.add_argument("--language", metavar="NAME",
                          help=f"{' or '.join(LANGUAGES)} (default: both, and the extension)")
    generate.add_argument("--functions", metavar="NAME", nargs="+", action="extend",
                          help="of a scene, only these functions; default and all stand for "
                               "several")
    simulate.add_implausible(generate)
    generate.set_defaults(run=_generate)
    for subcommand in (simulate, check_command, cost, catalogue, schema, command):
        subcommand.add_parser(commands)
    return parser


def _generate(options: argparse.Namespace) -> int:
    if options.scene:
        return _generate_scene(options)
    if options.functions:
        raise SelectionError("--functions selects functions of a scene, and no scene is given")
    selection = select(options.family or [], options.precision or "both", options.language)
    folder, check = Path(options.output or DEFAULT_OUTPUT), options.check
    programs = _programs(selection)
    files = generated_files(selection, programs)
    whole = selection == Selection()
    files |= reference_files(programs, selection.banner) if whole else {}
    stale = stale_files(files, folder) if whole else ()
    option = "" if folder == Path(DEFAULT_OUTPUT) else f" --output {folder}"
    return _deliver(selection.command + option, files, folder, stale, check, str(folder))


def _generate_scene(options: argparse.Namespace) -> int:
    """Write a scene's dynamics; what its model says and nothing uses goes to standard error."""
    given = [name for name in ("family", "language") if getattr(options, name)]
    if options.precision not in (None, "double", "both"):
        raise SelectionError(f"--precision {options.precision}: a scene's files hold double "
                             "precision, or both")
    if given:
        raise SelectionError(f"--{given[0]} selects kernels of the library; a scene's files are "
                             f"always whole")
    if not options.output:
        raise SelectionError(f"where to?  Wanted: coscrew generate {options.scene} -o DIR")
    scene = simulate.scene_of(options, options.precision, tuple(options.functions or ()))
    for line in scene.unused:
        print(f"{options.scene.name}: {line}", file=sys.stderr)
    said = "".join(f" --{name} {word}" for name in ("precision", "implausible")
                   if (word := getattr(options, name)))
    said += f" --functions {' '.join(options.functions)}" if options.functions else ""
    files = scene_files(scene, derive(scene), f"coscrew generate {options.scene.name}{said}")
    folder = Path(options.output)
    if not options.check:
        refuse_others(files, folder)
    return _deliver(f"coscrew generate {options.scene} -o {folder}{said}", files, folder,
                    stale_files(files, folder), options.check, str(folder))


def _deliver(command: str, files: Files, folder: Path, stale: tuple[str, ...],
             check: bool, output: str) -> int:
    """Write the files, or show what is out of date and the command that mends it."""
    if not check:
        changed = write(files, folder, stale)
        print(f"{output}: {len(files)} files, {len(changed)} changed")
        return 0
    diffs = differences(files, folder, stale)
    if not diffs:
        print(f"{output}: {len(files)} files are current")
        return 0
    sys.stdout.write("".join(diffs))
    print(f"{output}: {len(diffs)} files are out of date; run `{command}`", file=sys.stderr)
    return 1


def _programs(selection: Selection) -> Programs:
    progress = tqdm(selection.operations, desc="deriving", unit="operation", leave=False,
                    disable=None, file=sys.stderr)
    return {operation.name: program_of(operation) for operation in progress}
