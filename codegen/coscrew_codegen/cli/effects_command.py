"""`coscrew effects`: prints the catalogue of effects and how scene files write them."""

import argparse

from coscrew_codegen.cli.name_lists import Names
from coscrew_codegen.scene.effects import EFFECTS
from coscrew_codegen.scene.names import did_you_mean
from coscrew_codegen.scene.readers.effect_syntax import described
from coscrew_codegen.scene.readers.scene_error import SceneError


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add `effects` to the command line."""
    parser = commands.add_parser("effects", help="print the effects for scenes",
                                 description="Print effects: equations, parameters, units.")
    parser.add_argument("names", metavar="NAME", nargs="*", action=Names,
                        help="only these (default: all)")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Print the named effects, or all.  Raises SceneError for an unknown name."""
    known = {effect.name: effect for effect in EFFECTS}
    for name in options.names:
        if name not in known:
            raise SceneError("coscrew effects", name,
                             f"no such effect; {did_you_mean(name, known)}")
    chosen = [known[name] for name in options.names] or EFFECTS
    print("\n\n".join("\n".join(described(effect)) for effect in chosen))
    return 0
