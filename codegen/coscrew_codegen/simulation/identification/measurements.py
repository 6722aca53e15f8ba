"""Measured motions and torques of an arm, from a CSV file."""

import csv
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from coscrew_codegen.program.scene_functions import Coordinate
from coscrew_codegen.scene import units
from coscrew_codegen.scene.names import did_you_mean
from coscrew_codegen.simulation import SimulateError

Reals = NDArray[np.float64]
ORDER = 4
"""Of the low-pass filter, which runs forwards and backwards and so shifts no phase."""


@dataclass(frozen=True)
class Measurements:
    """Times (n), and q, v, a, tau of the joints, a state a row (n, NV)."""

    t: Reals
    q: Reals
    v: Reals
    a: Reals
    tau: Reals
    rate: float  # samples a second


def read(path: Path, joints: Sequence[Coordinate], cutoff: float | None) -> Measurements:
    """The file's columns t, q.JOINT, tau.JOINT (or actuator.JOINT.torque), v.JOINT and a.JOINT, as
    recordings write them.  Missing velocities and accelerations are differences of q, which a
    low-pass filter of this `cutoff` in Hz smooths before.

    Raises SimulateError for columns that are missing, of another unit, or no numbers."""
    columns, own = _columns(path), _units(joints)

    def of(symbol: str, spelling: str = "{}.{}") -> Reals | None:
        names = [spelling.format(symbol, c.joint) for c in joints]
        if not any(name in columns for name in names):
            return None
        return np.stack([_column(path, columns, name, unit) for name, unit in zip(
            names, own[symbol], strict=True)], 1)

    t = _column(path, columns, "t", "s")
    q, tau = of("q"), of("tau")
    tau = of("tau", "actuator.{1}.torque") if tau is None else tau
    for values, name in ((q, "q"), (tau, "tau")):
        if values is None:
            raise SimulateError(f"{path}: no columns {name}.{joints[0].joint}, …; it has "
                                f"{', '.join(columns)}")
    assert q is not None and tau is not None
    rate = _rate(path, t, cutoff)
    v, a = of("v"), of("a")
    if v is None:
        q = smoothed(q, rate, cutoff)
        v = np.gradient(q, t, axis=0, edge_order=2)
    if a is None:
        a = np.gradient(smoothed(v, rate, cutoff), t, axis=0, edge_order=2)
    return Measurements(t, q, v, a, tau, rate)


def smoothed(x: Reals, rate: float, cutoff: float | None) -> Reals:
    """The signals along the first axis without their parts above the cutoff."""
    if cutoff is None:
        return x
    from scipy.signal import butter, sosfiltfilt

    return np.asarray(sosfiltfilt(butter(ORDER, cutoff, fs=rate, output="sos"), x, axis=0))


def _units(joints: Sequence[Coordinate]) -> dict[str, tuple[str, ...]]:
    kinds = [c.kind for c in joints]
    return {"q": units.coordinates(kinds), "v": units.velocities(kinds),
            "a": units.accelerations(kinds), "tau": units.torques(kinds)}


def _columns(path: Path) -> dict[str, tuple[str, list[str]]]:
    """(unit or "", cells) of each column by name."""
    try:
        with path.open(encoding="utf-8", newline="") as file:
            rows = list(csv.reader(_without_comments(file)))
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise SimulateError(f"cannot read {path}: {error}") from None
    if len(rows) < 4:
        raise SimulateError(f"{path}: {len(rows)} lines; wanted names of columns and samples")
    results = {}
    for k, title in enumerate(rows[0]):
        name, bracket, unit = title.strip().partition(" [")
        if any(len(row) != len(rows[0]) for row in rows):
            raise SimulateError(f"{path}: lines have different numbers of columns")
        results[name] = (unit.removesuffix("]") if bracket else "", [row[k] for row in rows[1:]])
    return results


def _without_comments(lines: Iterator[str]) -> Iterator[str]:
    return (line for line in lines if not line.startswith("#") and line.strip())


def _column(path: Path, columns: dict[str, tuple[str, list[str]]], name: str, wanted: str) -> Reals:
    if name not in columns:
        raise SimulateError(f"{path}: no column {name!r}; {did_you_mean(name, tuple(columns))}")
    unit, cells = columns[name]
    if unit not in ("", wanted):
        raise SimulateError(f"{path}: column {name!r} is in {unit}; wanted {wanted}")
    return np.array([_number(path, name, cell) for cell in cells])


def _number(path: Path, name: str, cell: str) -> float:
    try:
        value = float(cell)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise SimulateError(f"{path}: column {name!r} has {cell!r}; wanted finite numbers")
    return value


def _rate(path: Path, t: Reals, cutoff: float | None) -> float:
    """Samples a second.  Raises SimulateError unless times increase, evenly if they are filtered,
    twice as fast as the cutoff."""
    steps = np.diff(t)
    if not (steps > 0).all():
        raise SimulateError(f"{path}: times do not increase after t = {t[:-1][steps <= 0][0]:g} s")
    rate = 1 / float(np.mean(steps))
    if cutoff is None:
        return rate
    if np.ptp(steps) * rate > 0.01:
        raise SimulateError(f"{path}: steps between {steps.min():g} and {steps.max():g} s; "
                            "--cutoff takes even ones")
    if not 0 < cutoff < rate / 2:
        raise SimulateError(f"--cutoff {cutoff:g}: wanted less than half of the {rate:g} samples "
                            "a second")
    return rate
