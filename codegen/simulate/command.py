"""`coscrew simulate`: options, the run or runs, files, a short table.

Imports what simulates only when it is asked to, since the generator does without."""

import argparse
import math
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from coscrew_codegen.simulate import SimulateError

if TYPE_CHECKING:
    from coscrew_codegen.simulate.outcome import Outcome

NEEDED = "needs {}; run `pip install \"coscrew[simulate]\"`"


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add `simulate` to the command line."""
    parser = commands.add_parser(
        "simulate", help="integrate a scene's motion",
        description="Integrate a scene's motion, and write, plot or show what it records.")
    add_scene(parser)
    parser.add_argument("--output", metavar="FILE", type=Path,
                        help="what is recorded: .csv, .npz or .parquet; with --precision both, "
                             "single precision goes to FILE's name with .single before its ending")
    parser.add_argument("--plot", metavar="FILE", type=Path, help="a plot of it: .svg or .png")
    parser.add_argument("--view", metavar="FILE", type=Path, help="a playback in space: .html")
    parser.set_defaults(run=run)


def add_scene(parser: argparse.ArgumentParser) -> None:
    """Add the scene, and the options that replace what it says of its run."""
    parser.add_argument("scene", metavar="SCENE", type=Path, help="a scene file, .toml")
    parser.add_argument("--until", metavar="T", type=_positive, help="end, in s, of the run")
    parser.add_argument("--step", metavar="H", type=_positive,
                        help="longest step, in s, of the emitted integrators")
    parser.add_argument("--integrator", metavar="NAME",
                        help="semi-implicit-euler, linear-implicit-euler, rk4, dop853 or radau")
    parser.add_argument("--precision", choices=("double", "single", "both"),
                        help="precision of the dynamics")
    parser.add_argument("--set", metavar="NAME=VALUE", type=_setting, action="append", default=[],
                        dest="settings", help="a value of a `runtime` parameter; may be repeated")


def _positive(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not (math.isfinite(value) and value > 0):
        raise argparse.ArgumentTypeError(f"wanted a positive number of seconds; got {text!r}")
    return value


def _setting(text: str) -> tuple[str, float]:
    name, equals, number = text.partition("=")
    if not (name and equals):
        raise argparse.ArgumentTypeError(f"wanted NAME=VALUE, such as tool.mass=2; got {text!r}")
    try:
        value = float(number)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"{name}: wanted a finite number; got {number!r}")
    return name, value


def run(options: argparse.Namespace) -> int:
    """Simulate; returns the exit status: 0, 1 if a run stopped early, 130 if it was interrupted."""
    try:
        from coscrew_codegen.simulate.load import load_scene
        from coscrew_codegen.simulate import outcome, plot, view, write
    except ModuleNotFoundError as error:
        raise SimulateError(f"simulate {NEEDED.format(error.name)}") from None
    for path, endings in ((options.output, tuple(write.FORMATS)), (options.plot, plot.ENDINGS),
                          (options.view, (".html",))):
        if path:
            write.check_target(path, endings)
    kernels = load_scene(options.scene)
    if unused := len(kernels.scene.unused):
        print(f"coscrew: {unused} numbers of the model are not used; `coscrew generate "
              f"{options.scene} -o DIR` lists them", file=sys.stderr)
    outcomes = outcome.simulated(kernels, outcome.Asked(
        options.until, options.step, options.integrator, options.precision,
        tuple(options.settings)))
    recordings = [x.recording for x in outcomes]
    if options.output:
        for path, recording in zip(_outputs(options.output), recordings):
            write.write(recording, path)
    if options.plot:
        plot.plot(recordings, options.plot)
    if options.view:
        first = outcomes[0]
        view.view(first.system, first.trajectory, first.recording.provenance, options.view)
    print(outcome.summary(outcomes))
    return _status(outcomes)


def _outputs(path: Path) -> tuple[Path, Path]:
    """Where double (or the only) precision goes, and single beside it."""
    return path, path.with_name(f"{path.stem}.single{path.suffix}")


def _status(outcomes: "tuple[Outcome, ...]") -> int:
    """Say on standard error where runs stopped."""
    for x in outcomes:
        if x.trajectory.stopped:
            print(f"coscrew: {x.system.precision.name}: {x.trajectory.stopped}; "
                  f"{len(x.trajectory.t)} samples kept", file=sys.stderr)
    if any(x.trajectory.interrupted for x in outcomes):
        return 130
    return 1 if any(x.trajectory.stopped for x in outcomes) else 0
