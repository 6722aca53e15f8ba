"""`coscrew certificate`: writes certificates of bounds over stated ranges, and their checkers."""

import argparse
import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from coscrew_codegen.cli.name_lists import Names
from coscrew_codegen.cli.simulate_command import add_model, scene_of
from coscrew_codegen.program.reported_error import ReportedError
from coscrew_codegen.program.values.formats import CHOICES

if TYPE_CHECKING:
    from coscrew_codegen.accuracy.fixed_scene import FixedScene
    from coscrew_codegen.program.scene_functions import FunctionProgram
    from coscrew_codegen.program.values.formats import Precision

CHECKER, FIXED_CHECKER = "check_bounds.py", "check_fixed.py"


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add `certificate` to the command line."""
    parser = commands.add_parser(
        "certificate", help="write certificates of the bounds over a scene's ranges",
        description="Write for each function the bounds of all values over the scene's [ranges], "
                    f"a line each, and {CHECKER}, which checks them with fractions alone: python "
                    f"{CHECKER} < FILE.  bounds.json has the bounds of all results.  Functions in "
                    f"fixed point have {FIXED_CHECKER}.")
    parser.add_argument("scene", metavar="SCENE", type=Path, help="a scene file with [ranges]")
    parser.add_argument("-o", "--output", metavar="DIR", type=Path, required=True,
                        help="folder to write to")
    parser.add_argument("--functions", metavar="NAME", nargs="+", action=Names,
                        help="only these functions, also by patterns, as jacobian_*")
    parser.add_argument("--tier", metavar="NAME", nargs="+", action=Names,
                        help="these tiers besides plain instead of the scene's: accurate, pairs, "
                             "mixed, fixed")
    parser.add_argument("--precision", metavar="NAME", choices=CHOICES,
                        help="double, single or both (default)")
    add_model(parser)
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Write the files; prints a line for each function, with the reason if it has no bound."""
    from coscrew_codegen.accuracy.fixed_scene import fixed_of
    from coscrew_codegen.accuracy.range_statements import reason
    from coscrew_codegen.backends.emit import write
    from coscrew_codegen.backends.render import copied
    from coscrew_codegen.dynamics import derive
    from coscrew_codegen.program.values.formats import named

    scene = scene_of(options, options.precision, tuple(options.functions or ()),
                     tuple(options.tier or ()))
    if scene.ranges is None:
        raise ReportedError(f"{options.scene}: states no ranges, over which bounds could be "
                            "proved; wanted a table, as [ranges] with v = 3 and a = 20")
    precisions = named((scene.precision,) if scene.precision == "single" else scene.precisions)
    files = {CHECKER: copied(f"certificate/{CHECKER}")}
    bounds = {}
    functions = derive(scene)
    for function in functions.functions:
        if function.internal or not function.ranges:
            continue
        made = dict(_certificates(function, precisions))
        files |= made
        bounds[function.name] = {p.name: _numbers(function, p) for p in precisions}
        lines = next((x.count("\n") for x in made.values()), 0)
        print(f"{function.name}: " + (f"{len(made)} certificates of {lines} lines" if made else
                                      f"no bound: {reason(function)}"))
    for f in functions.functions:
        if f.ranges and not f.internal:
            files |= _of_tiers(f, scene.tiers, precisions)
    for fixed in fixed_of(functions):
        files |= {FIXED_CHECKER: copied(f"certificate/{FIXED_CHECKER}"), **dict(_of_fixed(fixed))}
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


def _of_tiers(function: "FunctionProgram", tiers: Sequence[str],
              precisions: "tuple[Precision, ...]") -> Iterator[tuple[str, str]]:
    """The names and texts of the certificates of the function in tiers of pairs."""
    from coscrew_codegen.accuracy.certificate import of_tier
    from coscrew_codegen.accuracy.tiers import tier_named

    for tier in map(tier_named, tiers):
        for p in (p for p in precisions if p in tier.precisions):
            if text := of_tier(function, tier, p):
                name = f"{function.name}_{tier.mark}_{p.name}"
                yield f"{name}.txt", text
                print(f"{name}: 1 certificate of {text.count(chr(10))} lines")


def _of_fixed(scene: "FixedScene") -> Iterator[tuple[str, str]]:
    """The names and texts of the certificates of functions in fixed point."""
    from coscrew_codegen.accuracy.certificate import of_fixed
    from coscrew_codegen.program.fixed.fixed_program import Products

    for f in scene.functions:
        for products, fixed in f.programs.items():
            text, mark = of_fixed(f.plain, fixed), "_high" if products is Products.HIGH else ""
            name = f"{f.plain.name}_{scene.tier.mark}{mark}"
            yield f"{name}.txt", text
            print(f"{name}: 1 certificate of {text.count(chr(10))} lines")


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
