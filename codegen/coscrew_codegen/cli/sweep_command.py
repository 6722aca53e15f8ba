"""`coscrew sweep`: options, the members on workers, files, tables, a page."""

import argparse
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from coscrew_codegen.cli.name_lists import Names
from coscrew_codegen.cli.simulate_command import add_scene, scene_of, tell_unused
from coscrew_codegen.runtime.console import Tenths
from coscrew_codegen.simulation.sweep import SweepError, sweep_options

if TYPE_CHECKING:
    from distributed import Client

    from coscrew_codegen.simulation.sweep.files.folder import Folder
    from coscrew_codegen.simulation.sweep.prepare import Prepared

_ROUNDS = 4  # of computing missing parts, while parts are damaged as soon as they are written


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add `sweep` to the command line."""
    parser = commands.add_parser(
        "sweep", help="run a scene many times with varied parameters and starts",
        description="Run a scene many times, with varied parameters and starts, on the cores of "
                    "this machine or a Dask cluster, into a folder.  The same command continues "
                    "where it stopped.")
    add_scene(parser)
    parser.add_argument("--grid", metavar="NAME=FROM:TO:COUNT", type=sweep_options.grid,
                        action="append",
                        default=[], help="vary a `runtime` parameter, or a start such as "
                        "start.q.elbow, over a grid; FROM:TO:COUNT:log is a geometric one; may be "
                        "repeated: grids multiply")
    parser.add_argument("--sobol", metavar="PATTERN=LOW:HIGH", type=sweep_options.sobol,
                        action="append",
                        default=[], help="sample all names that match the pattern by a scrambled "
                                         "Sobol sequence; LOW:HIGH:log samples logarithms; "
                                         "start.q.*=limits takes the joints' limits, "
                                         "start.q.base=uniform all rotations of a joint with a "
                                         "quaternion; may be repeated")
    parser.add_argument("--samples", metavar="N", type=sweep_options.samples,
                        help="points of the Sobol sequence, each run at every point of the grids")
    parser.add_argument("--seed", metavar="N", type=sweep_options.seed,
                        help="of the sequence's scrambling (default: 0)")
    parser.add_argument("--record", metavar="QUANTITY", action=Names, default=[],
                        help="quantities instead of the scene's `record`, as there, also by "
                             "patterns; several with commas, or repeated")
    parser.add_argument("--series", action="store_true",
                        help="keep all samples of each run, besides their statistics")
    parser.add_argument("--workers", metavar="N", type=lambda text: sweep_options.whole(text, 1),
                        help="processes on this machine (default: one for each core)")
    parser.add_argument("--scheduler", metavar="ADDRESS",
                        help="the scheduler of a Dask cluster, such as tcp://host:8786, instead of "
                             "processes on this machine")
    kept = parser.add_mutually_exclusive_group(required=True)
    kept.add_argument("--out", metavar="FOLDER", type=Path,
                      help="a new folder, or that of the same sweep")
    kept.add_argument("--member", metavar="K", type=lambda text: sweep_options.whole(text, 0),
                      help="run member K alone, print the numbers that the sweep keeps of it, and "
                           "the Python call that runs it")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Run the sweep; returns the exit status: 0, 1 if members failed, 130 if it was interrupted."""
    from coscrew_codegen.runtime import compilation

    compilation.ask()
    if options.scheduler and options.workers:
        raise SweepError("--workers and --scheduler: wanted one of the two")
    from coscrew_codegen.simulation.sweep.chunk import provenance
    from coscrew_codegen.simulation.sweep.files.folder import opened

    prepared = _prepared(options)
    if options.member is not None:
        return _alone(prepared, options)
    specification = prepared.specification
    about = provenance(prepared.kernels, specification)
    try:
        with (opened(options.out, specification, {"provenance": about}) as folder,
              _going_on(folder)):
            return _finished(prepared, folder, options)
    except KeyboardInterrupt as stopped:
        print(f"coscrew: {stopped}", file=sys.stderr)
        return 130


def _prepared(options: argparse.Namespace) -> "Prepared":
    from coscrew_codegen.simulation.run_summary import RunOverrides
    from coscrew_codegen.simulation.sweep.prepare import SweepRequest, prepared

    scene = scene_of(options, options.precision)
    result = prepared(scene, SweepRequest(
        options.grid, options.sobol, options.samples, options.seed, options.record, options.series,
        RunOverrides(options.until, options.step, options.integrator, options.precision,
                     tuple(options.settings))))
    tell_unused(scene, options.verbose)
    return result


def _alone(prepared: "Prepared", options: argparse.Namespace) -> int:
    """Run a member and print it; returns the exit status."""
    from coscrew_codegen.simulation.sweep import single_member

    member = single_member.member(prepared, options.member)
    print(member.call(options.scene, options.implausible), end="\n\n", flush=True)
    result = single_member.result(prepared, member)
    print(single_member.text(result))
    return 1 if result.failed else 0


@contextmanager
def _going_on(folder: "Folder") -> Iterator[None]:
    """Makes errors and interrupts in the block also say what is kept, and how to continue, unless a
    file needs a person's help first."""
    from coscrew_codegen.simulation.sweep.files.part import BlockedError

    def kept(words: object) -> str:
        return (f"{words}; {folder.members()} of {folder.specification.varied.members} members are "
                f"written into {folder.path}; the same command continues")

    try:
        yield
    except KeyboardInterrupt:
        raise KeyboardInterrupt(kept("interrupted")) from None
    except BlockedError:
        raise
    except SweepError as error:
        raise SweepError(kept(error)) from error
    except BrokenPipeError:  # the reader of standard error has ended
        raise
    except OSError as error:
        raise SweepError(kept(f"cannot write {error.filename or folder.path}: "
                              f"{error.strerror or error}")) from error


def _finished(prepared: "Prepared", folder: "Folder", options: argparse.Namespace) -> int:
    """Computes and writes missing or damaged parts, and reports; returns the exit status."""
    from coscrew_codegen.simulation.sweep.files.part import DamagedError

    for n in range(_ROUNDS):
        folder.put_aside(finished=n > 0)
        _compute(prepared, folder, options)
        try:
            status = _report(prepared, folder, _words(options))
        except DamagedError as error:  # since it was written
            last = error
            continue
        folder.put_strangers_aside()
        folder.describe()
        return status
    raise SweepError(f"{last.path}: {last.why}, again and again; is the disk in order?") from last


def _compute(prepared: "Prepared", folder: "Folder", options: argparse.Namespace) -> None:
    """Computes and writes missing parts."""
    members, there = folder.specification.varied.members, folder.members()
    print(f"coscrew: {members} members, {there} of them written", file=sys.stderr)
    if there == members:
        return
    from tqdm import tqdm

    from coscrew_codegen.simulation.sweep import cluster
    from coscrew_codegen.simulation.sweep.chunk import Job

    job, failed, tenths = Job.of(prepared.kernels, prepared.specification), 0, Tenths()
    with (_client(options, prepared.specification.chunks) as client,
          tqdm(total=members, initial=there, unit=" runs", unit_scale=True, disable=None) as bar):
        for number, chunk in cluster.finished(client, job, folder.missing()):
            folder.write(number, chunk.content)
            failed, there = failed + chunk.failed, there + chunk.members
            lost = f", {failed} failed" if failed else ""
            tenths(there / members, f"{there} of {members} members written{lost}".__str__)
            bar.update(chunk.members)
            if failed:
                bar.set_postfix_str(f"{failed} failed")
    print(f"coscrew: {there} of {members} members written into {folder.path}", file=sys.stderr)


@contextmanager
def _client(options: argparse.Namespace, most: int) -> "Iterator[Client]":
    """Connects to the scheduler, or to at most `most` processes of its own."""
    from coscrew_codegen.simulation.sweep import cluster

    with (cluster.remote(options.scheduler) if options.scheduler else
          cluster.local(min(options.workers or cluster.cores(), most))) as client:
        if not client.nthreads():
            print(f"coscrew: {options.scheduler} has no workers yet", file=sys.stderr)
        yield client


def _report(prepared: "Prepared", folder: "Folder", words: str) -> int:
    """Write arrays and page, print the table; returns the exit status."""
    from coscrew_codegen.simulation.sweep.chunk import provenance
    from coscrew_codegen.simulation.sweep.files import zarr_store
    from coscrew_codegen.simulation.sweep.files.folder import PAGE, whole
    from coscrew_codegen.simulation.sweep.files.quarantine import make_way
    from coscrew_codegen.simulation.sweep.member_summary import units
    from coscrew_codegen.simulation.sweep.statistics import sweep_page
    from coscrew_codegen.simulation.sweep.statistics.aggregate import aggregate

    its = prepared.specification
    about = provenance(prepared.kernels, its)
    zarr_store.write(folder, about, prepared.plan)
    totals = aggregate(its, units(prepared.scene, its.conditions.record),
                       map(folder.of, range(its.chunks)))
    make_way(folder.path, folder.path / PAGE)
    whole(folder.path / PAGE, sweep_page.html(its, about, totals, words).encode())
    print(sweep_page.text(totals))
    return 1 if totals.failed else 0


def _words(options: argparse.Namespace) -> str:
    """The command, without folders and workers."""
    import shlex

    given = {"samples": options.samples, "seed": options.seed, "until": options.until,
             "step": options.step, "integrator": options.integrator,
             "precision": options.precision, "implausible": options.implausible}
    words = ["coscrew", "sweep", options.scene.name]
    words += [x for option in options.grid for x in ("--grid", option.text)]
    words += [x for option in options.sobol for x in ("--sobol", option.text)]
    words += [x for name, value in given.items() if value is not None
              for x in (f"--{name}", str(value))]
    words += [x for name, value in options.settings for x in ("--set", f"{name}={value}")]
    words += [x for name in options.record for x in ("--record", name)]
    return shlex.join(words + ["--series"] * options.series)
