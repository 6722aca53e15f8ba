"""`coscrew simulate`: options, the run or runs, files, a short table.

Imports the simulation only when it runs, since the generator does not need it."""

import argparse
import math
import sys
from collections import Counter
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from coscrew_codegen.program.values.formats import CHOICES
from coscrew_codegen.scene.integrators import in_words

if TYPE_CHECKING:
    from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides
    from coscrew_codegen.scene.scene import Scene
    from coscrew_codegen.simulation.recordings.result import Result


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add `simulate` to the command line."""
    parser = commands.add_parser(
        "simulate", help="integrate a scene's motion",
        description="Integrate a scene's motion, and write, plot or play back what it records.")
    add_scene(parser)
    parser.add_argument("--start", metavar="FILE", type=Path,
                        help="continue, with the same bits, from the end of a recording that "
                             "--output wrote, with its parameters unless --set")
    parser.add_argument("--again", metavar="FILE", type=Path,
                        help="repeat the run that made a recording, with its settings and, when "
                             "written, its bytes")
    parser.add_argument("--output", metavar="FILE", type=Path,
                        help="write the recording: .csv, .npz or .parquet; with --precision both, "
                             "single precision goes to FILE's name with .single before its ending")
    parser.add_argument("--plot", metavar="FILE", type=Path, help="write a plot: .svg or .png")
    parser.add_argument("--view", metavar="FILE", type=_seen, nargs="+", action="extend",
                        default=[],
                        help="write a 3D playback: .html, .rrd for Rerun or .mcap for Foxglove; "
                             "recordings after it (.csv, .npz, .parquet) are shown in it, too, as "
                             "ghosts")
    parser.set_defaults(run=run)


def add_scene(parser: argparse.ArgumentParser) -> None:
    """Add the scene, and the options that replace its own settings of the run."""
    parser.add_argument("scene", metavar="SCENE", type=Path,
                        help="a scene file (.toml), or a model's file alone, as a URDF: gravity "
                             "acts, and what the file declares")
    parser.add_argument("--until", metavar="T", type=positive, help="end of the run, in s")
    parser.add_argument("--step", metavar="H", type=positive,
                        help="longest step, in s, of the emitted integrators")
    parser.add_argument("--integrator", metavar="NAME",
                        help=in_words())
    parser.add_argument("--precision", choices=CHOICES,
                        help="precision of the dynamics")
    add_model(parser)
    add_verbose(parser)
    parser.add_argument("--set", metavar="NAME=VALUE", type=_setting, action="append", default=[],
                        dest="settings", help="a value of a `runtime` parameter; may be repeated")


def add_implausible(parser: argparse.ArgumentParser) -> None:
    """Add the option for bodies that cannot exist."""
    parser.add_argument("--implausible", choices=("error", "warn"),
                        help="for inertias that are impossible, massless or incomplete: refuse "
                             "the scene (error) or report them (warn)")


def add_model(parser: argparse.ArgumentParser) -> None:
    """Add the options on how a model's file is read."""
    add_implausible(parser)
    parser.add_argument("--argument", metavar="NAME=VALUE", type=_pair, action="append", default=[],
                        dest="arguments", help="an argument of a file of xacro; may be repeated")
    parser.add_argument("--package", metavar="NAME=FOLDER", type=_pair, action="append", default=[],
                        dest="packages", help="the folder of a package that a file of xacro finds "
                        "by $(find NAME); may be repeated")
    parser.add_argument("--leave-out", metavar="GROUP", action="append", default=[],
                        help="elements of a file of MuJoCo to do without, as errors name them; may "
                        "be repeated")


def _pair(text: str) -> tuple[str, str]:
    name, equals, word = text.partition("=")
    if not (name and equals):
        raise argparse.ArgumentTypeError(f"wanted NAME=…; got {text!r}")
    return name, word


def add_verbose(parser: argparse.ArgumentParser) -> None:
    """Adds the option that lists the numbers that `tell_unused` sums up."""
    parser.add_argument("--verbose", action="store_true",
                        help="list all unused content of the model's file, one item a line, "
                             "instead of summing it up")


def tell_unused(scene: "Scene", verbose: bool, prefix: str = "coscrew") -> None:
    """Prints on standard error the content of the model's file that the scene does not use, in one
    line or in one for each number, and the bodies that nothing holds."""
    from coscrew_codegen.scene.mechanism.notices import lines

    for line in lines(scene.notices, verbose):
        print(f"{prefix}: {line}", file=sys.stderr)


def overrides_of(options: argparse.Namespace) -> "SceneOverrides":
    """The options' settings for reading the model's file."""
    from coscrew_codegen.scene.readers.toml.toml_scene import SceneOverrides

    return SceneOverrides(
        implausible=options.implausible, arguments=tuple(options.arguments),
        packages=tuple(options.packages), leave_out=tuple(options.leave_out))


def scene_of(options: argparse.Namespace, precision: str | None,
             functions: tuple[str, ...] = (), tiers: tuple[str, ...] = ()) -> "Scene":
    """The scene of the options, with `functions` and `tiers` instead of its own if there are any.

    Implausible bodies that the scene allows are reported on standard error."""
    from coscrew_codegen.scene.readers.model_formats import SCENE_SUFFIX
    from coscrew_codegen.scene.readers.toml.toml_scene import read_scene

    overrides = replace(overrides_of(options), precision=precision, functions=functions,
                        tiers=tiers)
    scene = read_scene(options.scene, overrides=overrides)
    if options.scene.suffix.lower() != SCENE_SUFFIX:
        print(f"coscrew: {options.scene.name} alone: {_acting(scene)}", file=sys.stderr)
    for line in scene.model.implausible:
        print(f"coscrew: warning: {line}", file=sys.stderr)
    return scene


_SEVERAL = {"sum": "sums", "joint": "joints", "body": "bodies"}


def _acting(scene: "Scene") -> str:
    """The effects of a scene, and at how many places each acts: "gravity, viscous at 6 joints"."""
    joints = {x.name for x in scene.model.joints}
    places: dict[str, Counter[str]] = {}
    for x in scene.effects:
        where = "sum" if x.terms else "joint" if x.on in joints else "body" if x.on else ""
        places.setdefault(x.effect.name, Counter())[where] += 1
    words = [" at ".join((name, " and ".join(
        f"{count} {where if count == 1 else _SEVERAL[where]}" for where, count in of.items())))
        if any(of) else name for name, of in places.items()]
    verb = "act" if len(words) > 1 else "acts"
    lacking = "limits and friction" if "actuator" in places else "limits, friction and drives"
    return f"{', '.join(words)} {verb}; {lacking} take a scene file"


def _seen(text: str) -> Path:
    """A file of `--view`, by its ending."""
    from coscrew_codegen.simulation.recordings.recording_reader import TABLES
    from coscrew_codegen.simulation.view.view_files import FORMATS

    path = Path(text)
    if path.suffix not in (*FORMATS, *TABLES):
        raise argparse.ArgumentTypeError(
            f"{text}: wanted a file to write ({', '.join(FORMATS)}) or recordings to show in it "
            f"({', '.join(TABLES)}); SCENE stands before --view")
    return path


def positive(text: str) -> float:
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
        hint = f"; components one by one, as {name}.x=1" if "," in number else ""
        raise argparse.ArgumentTypeError(f"{name}: wanted a finite number; got {number!r}{hint}")
    return name, value


def run(options: argparse.Namespace) -> int:
    """Simulate the scene; returns the exit status: 0, 1 if a run stopped early, 130 if it was
    interrupted."""
    from coscrew_codegen.runtime import compilation

    compilation.ask()
    from coscrew_codegen.simulation import run_summary
    from coscrew_codegen.simulation.loops import loop_closing
    from coscrew_codegen.simulation.recordings import recording_writer
    from coscrew_codegen.simulation.view import view_files

    for path, endings in ((options.output, tuple(recording_writer.FORMATS)),
                          (options.plot, recording_writer.FIGURES)):
        if path:
            recording_writer.check_target(path, endings)
    pages, shown = view_files.sorted_files(options.view)
    results = _again(options) if options.again else _runs(options)
    first = results[0]
    for note in ("" if options.start or options.again else
                 run_summary.outside(first.system, first.trajectory.q[0]),
                 loop_closing.mobility(first.system), run_summary.bounces(first),
                 run_summary.overspeed(first)):
        if note:
            print(f"coscrew: {note}", file=sys.stderr)
    recordings = [x.recording for x in results]
    if options.output:
        for path, recording in zip(_outputs(options.output), recordings, strict=False):
            recording_writer.write(recording, path)
    if options.plot:
        from coscrew_codegen.simulation.recordings import recording_plot  # imports Matplotlib
        from coscrew_codegen.simulation.recordings.targets import targets

        recording_plot.plot(recordings, options.plot,
                            targets=targets(first.system, first.recording))
    if pages and (lacking := view_files.view(results, pages, shown)):
        print(f"coscrew: {lacking}", file=sys.stderr)
    print(run_summary.summary(results))
    return _status(results, options)


def _runs(options: argparse.Namespace) -> "tuple[Result, ...]":
    """Makes the runs with the settings of the options."""
    from coscrew_codegen.runtime.load import kernels_for
    from coscrew_codegen.runtime.request import BOTH
    from coscrew_codegen.simulation import required_functions, run_summary

    scene = scene_of(options, options.precision)
    one = options.precision or scene.precision
    kernels = kernels_for(scene,
                          required_functions.of_run(scene, options.integrator, bool(options.view)),
                          BOTH if one == "both" else (one,))
    if all(applied.effect.reaction for applied in scene.effects):
        print("coscrew: no effects: nothing acts, gravity included", file=sys.stderr)
    tell_unused(scene, options.verbose)
    return run_summary.simulated(kernels, run_summary.RunOverrides(
        options.until, options.step, options.integrator, options.precision,
        tuple(options.settings), options.start),
        with_provenance=bool(options.output or options.plot or options.view))


def _again(options: argparse.Namespace) -> "tuple[Result, ...]":
    """Repeats the run of a recording.  Raises SimulateError for further settings."""
    from coscrew_codegen.runtime.load import kernels_for
    from coscrew_codegen.simulation import SimulateError, required_functions
    from coscrew_codegen.simulation.execution import complete, motion
    from coscrew_codegen.simulation.replay import metadata_of

    given = [name for name in ("until", "step", "integrator", "precision", "settings", "start")
             if getattr(options, name)]
    if given:
        name = "set" if given[0] == "settings" else given[0]
        raise SimulateError(f"--again: the recording has all settings; wanted no --{name}")
    past = metadata_of(options.again)
    scene = scene_of(options, past.precision)
    past.refuse(scene, None)
    recording = replace(scene, record=past.record)
    kernels = kernels_for(scene,
                          required_functions.of_run(recording, past.integrator, bool(options.view)),
                          (past.precision,))
    request = past.request()
    return (motion(complete(kernels, request), past.precision, request, shown=True),)


def _outputs(path: Path) -> tuple[Path, Path]:
    """The files for double (or the only) precision and for single."""
    return path, path.with_name(f"{path.stem}.single{path.suffix}")


def _status(results: "tuple[Result, ...]", options: argparse.Namespace) -> int:
    """The exit status; reports on standard error where runs stopped, and which samples were kept.
    """
    from coscrew_codegen.simulation.view.view_files import FORMATS

    files: tuple[Path | None, ...] = _outputs(options.output) if options.output else (None,) * 2
    for x, path in zip(results, files, strict=False):
        if x.trajectory.stopped:
            pages = [y for y in options.view if y.suffix in FORMATS] if x is results[0] else []
            written = [str(y) for y in (path, options.plot, *pages) if y]
            where = f" in {', '.join(written)}" if written else ""
            print(f"coscrew: {x.system.precision.name}: {x.trajectory.stopped}; "
                  f"{len(x.trajectory.t)} samples kept{where}", file=sys.stderr)
    if any(x.trajectory.interrupted for x in results):
        return 130
    return 1 if any(x.trajectory.stopped for x in results) else 0
