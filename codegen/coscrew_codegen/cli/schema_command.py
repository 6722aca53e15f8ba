"""`coscrew schema`: prints the JSON Schema of scene files.

Imports the tables of effects and keys only when it runs, so that help needs no SymPy."""

import argparse


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add `schema` to the command line."""
    parser = commands.add_parser(
        "schema", help="print the JSON Schema of scene files",
        description="Print the JSON Schema of scene files, by which editors complete and check.")
    parser.set_defaults(run=run)


def run(_: argparse.Namespace) -> int:
    """Print the schema."""
    from coscrew_codegen.backends.selection import Selection
    from coscrew_codegen.reports.reference.scene_schema import schema_text

    print(schema_text(Selection().banner), end="")
    return 0
