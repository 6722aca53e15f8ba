"""`coscrew certificate`: writes certificates of bounds over stated ranges, and their checker."""

import argparse
import json
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from coscrew_codegen.cli.name_lists import Names
from coscrew_codegen.cli.simulate_command import add_model, scene_of
from coscrew_codegen.program.reported_error import ReportedError
from coscrew_codegen.program.values.formats import CHOICES

if TYPE_CHECKING:
    from coscrew_codegen.program.scene_functions import FunctionProgram
    from coscrew_codegen.program.values.formats import Precision

CHECKER = "check_bounds.py"


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add `certificate` to the command line."""
    parser = commands.add_parser(
        "certificate", help="write certificates of the bounds over a scene's ranges",
        description="Write for each function the bounds of all values over the scene's [ranges], "
                    f"a line each, and {CHECKER}, which checks them with fractions alone: python "
                    f"{CHECKER} < FILE.  bounds.json has the bounds of all results.")
    parser.add_argument("scene", metavar="SCENE", type=Path, help="a scene file with [ranges]")
    parser.add_argument("-o", "--output", metavar="DIR", type=Path, required=True,
                        help="folder to write to")
    parser.add_argument("--functions", metavar="NAME", nargs="+", action=Names,
                        help="only these functions, also by patterns, as jacobian_*")
    parser.add_argument("--precision", metavar="NAME", choices=CHOICES,
                        help="double, single or both (default)")
    add_model(parser)
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Write the files; prints a line for each function, with the reason if it has no bound."""
    from coscrew_codegen.accuracy.range_statements import reason
    from coscrew_codegen.backends.emit import write
    from coscrew_codegen.backends.render import copied
    from coscrew_codegen.dynamics import derive
    from coscrew_codegen.program.values.formats import named

    scene = scene_of(options, options.precision, tuple(options.functions or ()))
    if scene.ranges is None:
        raise ReportedError(f"{options.scene}: states no ranges, over which bounds could be "
                            "proved; wanted a table, as [ranges] with v = 3 and a = 20")
    precisions = named((scene.precision,) if scene.precision == "single" else scene.precisions)
    files = {CHECKER: copied(f"certificate/{CHECKER}")}
    bounds = {}
    for function in derive(scene).functions:
        if function.internal or not function.ranges:
            continue
        made = dict(_certificates(function, precisions))
        files |= made
        bounds[function.name] = {p.name: _numbers(function, p) for p in precisions}
        lines = next((x.count("\n") for x in made.values()), 0)
        print(f"{function.name}: " + (f"{len(made)} certificates of {lines} lines" if made else
                                      f"no bound: {reason(function)}"))
    files["bounds.json"] = json.dumps(bounds, indent=1) + "\n"
    write(files, options.output)
    return 0


def _certificates(function: "FunctionProgram", precisions: "tuple[Precision, ...]"
                  ) -> Iterator[tuple[str, str]]:
    """The names and texts of the function's certificates."""
    from coscrew_codegen.accuracy.certificate import certificate

    for p in precisions:
        if text := certificate(function, p):
            yield f"{function.name}_{p.name}.txt", text


def _numbers(function: "FunctionProgram", precision: "Precision") -> dict[str, object]:
    """Bounds of the sizes and errors of each output's components; null without one."""
    from math import isfinite

    from coscrew_codegen.accuracy.range_proofs import of_plain

    bounds, start = of_plain(function, precision), 0
    result: dict[str, object] = {}
    for a in function.program.outputs:
        each = bounds[start:start + a.quantity.size]
        start += a.quantity.size
        result[a.name] = {name: [float(x) if isfinite(x) else None for x in numbers]
                          for name, numbers in (("size", [x.size + x.error for x in each]),
                                                ("error", [x.error for x in each]))}
    return result
