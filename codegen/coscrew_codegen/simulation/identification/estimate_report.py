"""Tables and files of estimates."""

import csv
from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np
from tabulate import tabulate

from coscrew_codegen.scene import units
from coscrew_codegen.simulation.identification.arm_regressor import ArmRegressor
from coscrew_codegen.simulation.identification.base_estimate import Estimate
from coscrew_codegen.simulation.identification.consistent_estimate import SURE, ConsistentArm
from coscrew_codegen.simulation.identification.excitation import Excitation
from coscrew_codegen.simulation.recordings.recording_writer import delivered

_LONGEST = 50
"""Characters of a name in the table of an estimate."""
Row = tuple[str, ...]


def base_table(arm: ArmRegressor) -> str:
    """The base parameters, and the scene's values."""
    rows = [(str(n), f"{x:.6g}", unit, name) for n, (name, x, unit) in enumerate(zip(
        arm.base_names, arm.beta, arm.base_units, strict=True))]
    table = tabulate(rows, ("", "scene", "unit", "base parameter"), disable_numparse=True)
    return f"{len(arm.base_names)} base parameters of {len(arm.names)} parameters\n\n{table}"


def estimate_table(arm: ArmRegressor, x: Estimate, y: ConsistentArm) -> str:
    """Base parameters with standard errors, fit of each joint, and the nearest physical arm."""
    rows = [(f"{own:.6g}", f"{value:.6g}", f"{error:.2g}", f"{physical:.6g}", unit, _short(name))
            for name, own, value, error, physical, unit in zip(
                arm.base_names, arm.beta, x.beta, x.errors, y.beta, arm.base_units, strict=True)]
    joints = [(c.joint, f"{deviation:.4g}", f"{100 * part:.4f} %") for c, deviation, part in zip(
        arm.coordinates, x.deviations, x.explained, strict=True)]
    verdict = (f"the nearest physical arm fits worse by {y.distance:.3g}; noise alone explains "
               f"{y.allowed:.3g} with {SURE:.0%} probability"
               + ("" if y.within else ": no physical arm has this estimate"))
    return "\n\n".join((
        tabulate(rows, ("scene", "estimate", "standard error", "physical", "unit",
                        "base parameter"), disable_numparse=True),
        tabulate(joints, ("joint", "deviation of the residual", "explained"),
                 disable_numparse=True),
        f"condition of the weighted regressor: {x.condition:.3g}\n{verdict}"))


def _short(name: str) -> str:
    """The name, or its first terms: tables of base parameters and files have all."""
    return name if len(name) <= _LONGEST else f"{name[:_LONGEST].rpartition(' ')[0]} …"


def write_estimate(arm: ArmRegressor, x: Estimate, y: ConsistentArm | None, path: Path) -> None:
    """Base parameters, or, of a physical arm, all parameters and the base parameters, as CSV."""
    header = ("kind", "name", "unit", "scene", "estimate", "standard error")
    rows: list[Row] = []
    if y:
        rows += [("parameter", name, unit, repr(float(own)), repr(float(value)), "")
                 for name, unit, own, value in zip(arm.names, arm.units, arm.pi, y.pi, strict=True)]
    beta = y.beta if y else x.beta
    rows += [("base parameter", name, unit, repr(float(own)), repr(float(value)),
              repr(float(error))) for name, unit, own, value, error in zip(
                  arm.base_names, arm.base_units, arm.beta, beta, x.errors, strict=True)]
    _write(path, header, rows)


def write_excitation(arm: ArmRegressor, x: Excitation, path: Path) -> None:
    """t, q, v and a as CSV, with columns as recordings have them."""
    names = [c.joint for c in arm.coordinates]
    own = [unit for c in arm.coordinates for unit in units.coordinates((c.kind,))]
    header = ("t [s]", *(f"{symbol}.{name} [{unit}{per}]" for symbol, per in (
        ("q", ""), ("v", "/s"), ("a", "/s^2")) for name, unit in zip(names, own, strict=True)))
    numbers = np.column_stack((x.t, x.q, x.v, x.a)).tolist()
    _write(path, header, (tuple(map(repr, row)) for row in numbers))


def _write(path: Path, header: Sequence[str], rows: Iterable[Row]) -> None:
    with delivered(path) as temporary, temporary.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)
