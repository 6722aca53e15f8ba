"""Inverse dynamics in fixed point: proved bounds beside the worst errors found, and instructions of
a call on cores with and without floating point, beside those of software's double and single."""

from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from tabulate import tabulate

from coscrew_codegen.accuracy.fixed_scene import FixedScene
from coscrew_codegen.accuracy.float_rounding import FloatRounding
from coscrew_codegen.accuracy.rounding_rules import ValueBounds
from coscrew_codegen.backends.fixed.c_integers import INTEGERS
from coscrew_codegen.backends.fixed.scene_c_fixed import c_name
from coscrew_codegen.backends.scene import scene_c
from coscrew_codegen.program.fixed.fixed_program import Products
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE, Precision
from coscrew_codegen.reports.cost.needs import cortex_m4
from coscrew_codegen.reports.cost.needs.core_costs import CORES
from tests.support.scenes import fixed_point as fx
from tests.support.scenes import fixed_robots

STATES, ROUNDS = 20_000, 12


def rows() -> Iterator[tuple[str, ...]]:
    """A line for each number format of each robot."""
    for robot in fixed_robots.ROBOTS:
        made = fixed_robots.fixed(robot, ("inverse_dynamics",))
        with TemporaryDirectory() as folder:
            for path, text in scene_c.files(made.plain, "for a benchmark").items():
                (Path(folder) / path).write_text(text)
            fx.written(made, Path(folder))
            for precision in (DOUBLE, SINGLE):
                yield (robot, precision.name, _proved(made, precision), "",
                       *_floats(made, precision, Path(folder)))
            for products in Products:
                bound = fx.bounds(made.functions[0], products).max()
                worst = fx.worst(made.functions[0], products, STATES, ROUNDS).max()
                yield (robot, f"fixed, {products.value}", f"{bound:.1e}", f"{worst:.1e}",
                       *_integers(made, products, Path(folder)))


def _proved(made: FixedScene, precision: Precision) -> str:
    """The bound of the plain function's errors in floating point."""
    (function,) = made.functions
    sizes = [dict(made.plain.box)[a.name] for a in function.plain.inputs]
    values = ValueBounds(function.plain.program, sizes, FloatRounding(precision))
    return f"{max(x.error for x in values.results):.1e}"


def _integers(made: FixedScene, products: Products, folder: Path) -> Iterator[str]:
    """Instructions of a call at one state on each core."""
    (function,) = made.functions
    row = [np.array([x[0] for x in parts], np.int32) for parts in fx.states(function, 1, 3)]
    for compiler in CORES.values():
        built = cortex_m4.built(folder, f"{made.stem}{fx.MARKS[products]}", INTEGERS, compiler)
        count, _ = cortex_m4.counted(built, made.stem, function.plain,
                                     c_name(made, function, products), row, INTEGERS, compiler)
        yield f"{count:,}"


def _floats(made: FixedScene, precision: Precision, folder: Path) -> Iterator[str]:
    """Instructions of a call of the plain function at this state."""
    (function,) = made.functions
    row = [np.array([x[0] / 2.0**value.bits for x, value in zip(parts, values, strict=True)],
                    np.float32)
           for parts, values in zip(fx.states(function, 1, 3), function.inputs, strict=True)]
    name = made.plain.name
    for compiler in CORES.values():
        built = cortex_m4.built(folder, name, precision, compiler)
        count, _ = cortex_m4.counted(built, name, function.plain,
                                     f"{name}_inverse_dynamics{precision.suffix}", row, precision,
                                     compiler)
        yield f"{count:,}"


def main() -> None:
    """Print the table."""
    print("\nInverse dynamics: errors in N m, instructions of a call")
    print(tabulate(rows(), ("robot", "format", "proved", "found", *CORES), disable_numparse=True))


if __name__ == "__main__":
    main()
