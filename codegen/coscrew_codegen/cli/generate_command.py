"""`coscrew generate`: options; writes the library's kernels or a scene's dynamics, or checks them.

Imports the modules that derive only when it runs, so that other commands start at once."""

import argparse
import sys
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from coscrew_codegen.cli.name_lists import Names
from coscrew_codegen.cli.simulate_command import add_model, add_verbose, scene_of, tell_unused
from coscrew_codegen.program.values.formats import CHOICES
from coscrew_codegen.runtime import sources
from coscrew_codegen.runtime.console import doing

if TYPE_CHECKING:
    from coscrew_codegen.backends.target import Files

DEFAULT_OUTPUT = "generated"


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add `generate` to the command line."""
    parser = commands.add_parser("generate", help="write the kernels, or check them",
                                 description="Write the kernels, or check that they are current.")
    parser.add_argument("scene", metavar="SCENE", nargs="?", type=Path,
                        help="a scene file: write its dynamics instead of the library's kernels")
    parser.add_argument("-o", "--output", metavar="DIR",
                        help=f"folder to write to (default: {DEFAULT_OUTPUT}; scenes need one)")
    parser.add_argument("--check", action="store_true",
                        help="write nothing; print what is out of date as a diff and exit 1")
    parser.add_argument("--anew", action="store_true",
                        help="derive everything, even unchanged families that are in the cache")
    parser.add_argument("--family", metavar="NAME", nargs="+", action=Names,
                        help="only these families: vec3, SE3, …, as the headers are called")
    parser.add_argument("--precision", metavar="NAME",
                        help="double, single or both (default)")
    parser.add_argument("--language", metavar="NAME",
                        help="c, python, … (default: all, and files for several languages); an "
                             "unknown name lists the known ones")
    parser.add_argument("--functions", metavar="NAME", nargs="+", action=Names,
                        help="for a scene, only these functions, also by patterns, as jacobian_*; "
                             "`default` and `all` select several")
    parser.add_argument("--tier", metavar="NAME", nargs="+", action=Names,
                        help="for a scene, these tiers besides plain: accurate, certified, mixed, "
                             "pairs")
    parser.add_argument("--many", action="store_true",
                        help="also functions of many elements at once, in C; for a scene, of many "
                             "states")
    parser.add_argument("--amalgamate", metavar="TIER", nargs="+", action=Names,
                        help="of the library, also all C headers of these tiers in one file each: "
                             "c/coscrew_accurate.h, …; plain's, c/coscrew.h, is always written")
    parser.add_argument("--cuda", action="store_true",
                        help="for a scene, also its functions for CUDA")
    add_model(parser)
    add_verbose(parser)
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Write, or check; returns the exit status: 0, or 1 if something is out of date."""
    return _scene(options) if options.scene else _library(options)


def _library(options: argparse.Namespace) -> int:
    stands = None if options.check else _sources()

    from coscrew_codegen.backends.emit import stale_files
    from coscrew_codegen.backends.output_files import generated_files
    from coscrew_codegen.backends.selection import SelectionError, select
    from coscrew_codegen.reports.reference import reference_files
    from coscrew_codegen.runtime.family_cache import FamilyCache

    if options.functions:
        raise SelectionError("--functions selects functions of a scene, and no scene is given")
    if options.tier:
        raise SelectionError("--tier selects tiers of a scene, and no scene is given; the library "
                             "has all tiers")
    if options.cuda:
        raise SelectionError("--cuda selects functions of a scene, and no scene is given")
    selection = select(options.family or [], options.precision or "both", options.language,
                       options.amalgamate or [], options.many)
    folder, check = Path(options.output or DEFAULT_OUTPUT), options.check
    whole = selection.whole
    with doing("generating") as tell:
        kept = FamilyCache(stands, selection.base, tell, options.anew)
        library = selection.library(kept)
        files = generated_files(library) | (reference_files(library) if whole else {})
    kept.save()
    stale = stale_files(files, folder) if whole else ()
    option = "" if folder == Path(DEFAULT_OUTPUT) else f" --output {folder}"
    return _deliver(selection.command + option, files, folder, stale, check, str(folder),
                    kept.derived)


def _scene(options: argparse.Namespace) -> int:
    """Write a scene's dynamics."""
    from coscrew_codegen.accuracy.scene_tiers import savings
    from coscrew_codegen.backends.emit import refuse_others, stale_files
    from coscrew_codegen.backends.output_files import scene_files
    from coscrew_codegen.backends.selection import SelectionError
    from coscrew_codegen.dynamics import derive
    from coscrew_codegen.scene.function_selection import left_out
    from coscrew_codegen.simulation.result_units import units

    given = [name for name in ("family", "language", "amalgamate") if getattr(options, name)]
    if options.precision not in (None, *CHOICES):
        raise SelectionError(f"--precision {options.precision}: wanted one of "
                             f"{', '.join(CHOICES)}")
    if given:
        raise SelectionError(f"--{given[0]} selects kernels of the library; of a scene, "
                             "--functions, --tier and --precision select")
    if options.anew:
        raise SelectionError("--anew derives kernels of the library; a scene is always derived")
    if not options.output:
        raise SelectionError(f"where to?  Wanted: coscrew generate {options.scene} -o DIR")
    scene = scene_of(options, options.precision, tuple(options.functions or ()),
                     tuple(options.tier or ()))
    if scene.precision == "single":
        scene = replace(scene, precisions=("single",))
    if line := left_out(scene):
        print(f"{options.scene.name}: {line}", file=sys.stderr)
    flags = "".join(f" --{name} {word}" for name in ("precision", "implausible")
                    if (word := getattr(options, name)))
    flags += f" --functions {' '.join(options.functions)}" if options.functions else ""
    flags += f" --tier {' '.join(options.tier)}" if options.tier else ""
    flags += "".join(f" --{name}" for name in ("many", "cuda") if getattr(options, name))
    functions = derive(scene)
    files = scene_files(functions, f"coscrew generate {options.scene.name}{flags}", options.many,
                        options.cuda)
    folder = Path(options.output)
    if not options.check:
        for line in savings(functions, units):
            print(line)
        refuse_others(files, folder)
    status = _deliver(f"coscrew generate {options.scene} -o {folder}{flags}", files, folder,
                      stale_files(files, folder), options.check, str(folder))
    tell_unused(scene, options.verbose, options.scene.name)
    return status


def _deliver(command: str, files: "Files", folder: Path, stale: tuple[str, ...],
             check: bool, output: str, derived: tuple[str, ...] = ()) -> int:
    """Writes the files, or shows a diff of outdated ones and the command that updates them."""
    from coscrew_codegen.backends.emit import differences, write

    if not check:
        changed = write(files, folder, stale)
        again = f"; derived: {', '.join(derived)}" if derived else ""
        print(f"{output}: {len(files)} files, {len(changed)} changed{again}")
        return 0
    diffs = differences(files, folder, stale)
    if not diffs:
        print(f"{output}: {len(files)} files are current")
        return 0
    sys.stdout.write("".join(diffs))
    print(f"{output}: {len(diffs)} files are out of date; run `{command}`", file=sys.stderr)
    return 1


def _sources() -> sources.Contents | None:
    """The generator's sources as they stand; None if this process has imported operations, which
    may be older."""
    return None if "coscrew_codegen.algebra.operations" in sys.modules else sources.read()
