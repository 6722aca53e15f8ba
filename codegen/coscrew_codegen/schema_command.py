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
    from coscrew_codegen.documentation.schema import schema_text
    from coscrew_codegen.selection import Selection

    print(schema_text(Selection().banner), end="")
    return 0
