"""Fixed point beside software's floating point, on cores for which fixed point is made: proved
bounds over the stated ranges, and counted instructions."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from coscrew_codegen.accuracy.fixed_scene import FixedFunction, FixedScene, fixed_of
from coscrew_codegen.accuracy.float_rounding import FloatRounding
from coscrew_codegen.accuracy.rounding_rules import ValueBounds
from coscrew_codegen.accuracy.scene_tiers import NoFunctionsError
from coscrew_codegen.accuracy.tiers import tier_named
from coscrew_codegen.backends.fixed import scene_c_fixed
from coscrew_codegen.backends.fixed.c_integers import INTEGERS
from coscrew_codegen.backends.html.pages import Table
from coscrew_codegen.backends.scene import scene_c
from coscrew_codegen.backends.scene.scene_text import banner_of
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.fixed.fixed_program import Products
from coscrew_codegen.program.scene_functions import FunctionProgram
from coscrew_codegen.program.values.formats import Precision, named
from coscrew_codegen.reports.cost.needs import cortex_m4
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation.result_units import in_unit

CORES = {**cortex_m4.WITHOUT_FLOATS, "Cortex-M4F": cortex_m4.COMPILER}
_STATE = 0.4  # of the largest arguments
_ABOVE = ("Proved: no error exceeds it while arguments are in the stated ranges, where fixed point "
          "cannot overflow.  Instructions of a call with its sines, at one state; double is "
          "software on all three cores, single on the first two.")


@dataclass(frozen=True)
class CoreCost:
    """A function in one number format: its bound by unit, and instructions by core."""

    function: str
    format: str  # double, single; fixed, high products of fixed
    bounds: dict[str, float]
    instructions: dict[str, int]  # {} if nothing counts them


def on_cores(scene: Scene, names: Sequence[str]) -> tuple[CoreCost, ...]:
    """The costs of these functions, if the scene selects fixed point; () if it does not.  Raises
    CountError."""
    if not any(tier.fixed for tier in map(tier_named, scene.tiers)) or not names:
        return ()
    plain = derive(scene, tuple(names))
    try:
        (made,) = fixed_of(plain)
    except NoFunctionsError:
        return ()
    with TemporaryDirectory() as folder:
        banner = banner_of(plain.name)
        files = scene_c.files(plain, banner) | scene_c_fixed.files(made, banner)
        for path, text in files.items():
            (Path(folder) / path).write_text(text, encoding="utf-8")
        return tuple(row for f in made.functions for row in _rows(made, f, Path(folder)))


def _rows(made: FixedScene, f: FixedFunction, folder: Path) -> Iterator[CoreCost]:
    name, sizes = made.plain.name, [dict(made.plain.box)[a.name] for a in f.plain.inputs]
    integers = [np.array([int(_STATE * x.largest) for x in values], np.int32)
                for values in f.inputs]
    real = [np.array([x / 2.0**value.bits for x, value in zip(parts, values, strict=True)],
                     np.float32) for parts, values in zip(integers, f.inputs, strict=True)]
    for precision in named(made.plain.precisions):
        bounds = ValueBounds(f.plain.program, sizes, FloatRounding(precision))
        errors = [x.error for x in bounds.results]
        yield CoreCost(f.plain.name, precision.name, _by_unit(f.plain, errors), _counted(
            folder, name, name, f.plain, f"{name}_{f.plain.name}{precision.suffix}", real,
            precision))
    for products, fixed in f.programs.items():
        mark = scene_c_fixed.MARK[products]
        yield CoreCost(f.plain.name, f"{INTEGERS.name}{' (high)' * (products is Products.HIGH)}",
                       _by_unit(f.plain, [x.error for x in fixed.results]), _counted(
            folder, f"{made.stem}{mark}", made.stem, f.plain,
            scene_c_fixed.c_name(made, f, products), integers, INTEGERS))


def _by_unit(f: FunctionProgram, errors: Sequence[float]) -> dict[str, float]:
    """The largest error of each unit."""
    pairs = list(zip(f.units, errors, strict=True))
    return {unit: max(float(x) for other, x in pairs if other == unit)
            for unit in dict.fromkeys(f.units)}


def _counted(folder: Path, stem: str, header: str, f: FunctionProgram, name: str,
             given: Sequence[np.ndarray], precision: Precision) -> dict[str, int]:
    """Instructions of a call on each core; {} without compiler or emulator."""
    if cortex_m4.missing():
        return {}
    return {core: cortex_m4.counted(cortex_m4.built(folder, stem, precision, compiler), header, f,
                                    name, given, precision, compiler)[0]
            for core, compiler in CORES.items()}


def table(costs: Sequence[CoreCost]) -> Table:
    """A line for each function and format."""
    rows = tuple(
        (x.function if n == 0 or costs[n - 1].function != x.function else "", x.format,
         " and ".join(in_unit(bound, unit) for unit, bound in x.bounds.items()),
         *(f"{x.instructions[core]:,}" if x.instructions else "not counted" for core in CORES))
        for n, x in enumerate(costs))
    missing = cortex_m4.missing()
    return Table(("in the stated ranges", "format", "proved", *CORES), rows, (_ABOVE, *(
        (f"Not counted without {' and '.join(missing)}.",) if missing else ())),
                 title="Fixed point", texts=3)
