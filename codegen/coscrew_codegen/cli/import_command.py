"""`coscrew import`: writes a model's file as a scene of plain tables, which needs no extra."""

import argparse
import sys
from pathlib import Path

from coscrew_codegen.cli.simulate_command import add_model
from coscrew_codegen.program.reported_error import ReportedError


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add `import` to the command line."""
    parser = commands.add_parser(
        "import", help="write a model's file as a scene of plain tables",
        description="Write a model's file as a scene file of plain tables, with the effects that "
                    "act in it alone; what the scene does not hold stands in comments.")
    parser.add_argument("file", metavar="FILE", type=Path, help="a model's file, as a URDF")
    parser.add_argument("-o", "--output", metavar="SCENE", type=Path,
                        help="the file to write, .toml, which must not be there yet; by default "
                             "the scene is printed")
    add_model(parser)
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Write or print the scene."""
    from coscrew_codegen.cli.simulate_command import overrides_of
    from coscrew_codegen.scene.readers.toml.toml_scene import imported

    target: Path | None = options.output
    if target and target.suffix != ".toml":
        raise ReportedError(f"--output {target}: wanted a name that ends in .toml")
    if target and target.exists():
        raise ReportedError(f"--output {target}: is there already; wanted another name")
    text = imported(options.file, overrides_of(options))
    if target is None:
        print(text, end="")
        return 0
    target.write_text(text, encoding="utf-8")
    count = sum(line.startswith("#") for line in text.splitlines())
    print(f"{target}: written, with {count} line{'s' * (count > 1)} of "
          "comments", file=sys.stderr)
    return 0
