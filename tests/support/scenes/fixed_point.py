"""A scene in fixed point on integers that check that nothing overflows, and as compiled C."""

import ctypes
from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np

from coscrew_codegen.accuracy.fixed_scene import FixedFunction, FixedScene
from coscrew_codegen.backends.fixed import scene_c_fixed
from coscrew_codegen.backends.fixed.c_integers import wide_steps
from coscrew_codegen.program import Constant, Instruction, Op, Program, Ref
from coscrew_codegen.program.fixed.fixed_arithmetic import ARITHMETIC
from coscrew_codegen.program.fixed.fixed_program import FixedProgram, Products
from coscrew_codegen.program.interpreter import Arithmetic, by_operation, evaluate, exactly
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Scene
from tests.support.compiled.c_harness import run

PANDA = Path(__file__).parents[3] / "examples/cost/panda.toml"
RANGES = "\n[ranges]\nv = 0.5\na = 1\n"
"""The ranges of a comparison with another generator."""
MARKS = {Products.FULL: "", Products.HIGH: "_high"}
POLYNOMIAL = ("inverse_dynamics", "gravity_torques", "mass_matrix", "body_poses", "energy",
              "momentum", "inverse_dynamics_derivatives")
Row = Sequence[np.ndarray]


def panda(folder: Path, ranges: str = RANGES, tiers: str = 'tiers = ["fixed"]\n') -> Scene:
    """The arm of examples/cost with these ranges."""
    path = folder / "panda.toml"
    path.write_text(tiers + PANDA.read_text() + ranges)
    return read_scene(path)


def states(function: FixedFunction, count: int, seed: int = 0) -> list[list[np.ndarray]]:
    """Integers of arguments, by component: random ones, a third at a limit; the first
    states are corners."""
    draw = np.random.default_rng(seed)
    given = []
    for values in function.inputs:
        parts = []
        for x in values:
            most = int(x.largest)
            numbers = draw.integers(-most, most + 1, count)
            ends = draw.random(count) < 1 / 3
            ends[:count // 8] = True
            parts.append(np.where(ends, np.where(numbers < 0, -most, most), numbers))
        given.append(parts)
    return given


def _within(x: Any, bits: int, words: str) -> Any:
    """The integers, which must be of so many bits."""
    assert np.all(np.abs(x) < 2**(bits - 1)), words
    return x


def checked(program: Program) -> Arithmetic[Any]:
    """Arithmetic of integers that fails where a result overflows, or the sum that a rounded shift
    shifts.  Products of 64 bits are checked by floats."""
    wide = wide_steps(program)

    def function(step: Instruction, number: int) -> Callable[..., Any]:
        apply = ARITHMETIC.function(step, number)

        def apply_checked(*x: Any) -> Any:
            if step.op is Op.WIDE_PRODUCT:
                _within(np.asarray(x[0], float) * np.asarray(x[1], float) * 2.0**int(x[2]), 64,
                        step.name)
            if step.op is Op.ROUNDED_SHIFT:
                long = isinstance(step.operands[0], Ref) and step.operands[0].name in wide
                _within(np.asarray(x[0], float) + 2.0**int(x[1]) / 2, 64 if long else 32, step.name)
            return _within(apply(*x), 64 if step.name in wide else 32, step.name)
        return apply_checked

    return Arithmetic(ARITHMETIC.constant, function)


JUDGE: Arithmetic[Any] = by_operation(
    lambda x: np.longdouble(x.double.numerator) / np.longdouble(x.double.denominator),
    exactly(np))
"""64 bits: its roundings are less than a millionth of any bound here."""


def results(program: FixedProgram, given: Sequence[Row],
            arithmetic: Arithmetic[Any] = ARITHMETIC) -> np.ndarray:
    """Integers of results, a row for each component."""
    count = max(np.size(x) for parts in given for x in parts)
    return np.stack([np.broadcast_to(x, count)
                     for x in evaluate(program.program, given, arithmetic)])


def errors(function: FixedFunction, products: Products, given: Sequence[Row]) -> np.ndarray:
    """Errors of results, a row for each component."""
    fixed = function.programs[products]
    real = [[np.asarray(x, np.longdouble) / np.longdouble(2)**value.bits
             for x, value in zip(parts, values, strict=True)]
            for parts, values in zip(given, function.inputs, strict=True)]
    made = results(fixed, given)
    true = evaluate(function.plain.program, real, JUDGE)
    return np.stack([np.abs(x / np.longdouble(2)**value.bits - y).astype(float)
                     for x, y, value in zip(made, true, fixed.results, strict=True)])


def bounds(function: FixedFunction, products: Products) -> np.ndarray:
    """The stated bounds of the errors."""
    return np.array([float(x.error) for x in function.programs[products].results])


def worst(function: FixedFunction, products: Products, count: int, rounds: int, seed: int = 0
          ) -> np.ndarray:
    """The largest errors found of each component: at states, a third of whose numbers are at
    limits, an eighth of them corners, and at neighbours that rounds of climbing try."""
    draw, scale = np.random.default_rng(seed), bounds(function, products)[:, None]
    scale = np.where(scale == 0, np.inf, scale)
    most = [[int(x.largest) for x in values] for values in function.inputs]
    given = states(function, count, seed)
    now = errors(function, products, given)
    largest, best = now.max(1), (now / scale).max(0)
    for number in range(rounds):
        size = 0.3 * 0.8**number
        other = [[np.clip(x + np.rint(draw.normal(size=count) * size * m).astype(np.int64)
                          * (draw.random(count) < 0.3), -m, m)
                  for x, m in zip(parts, ms, strict=True)]
                 for parts, ms in zip(given, most, strict=True)]
        now = errors(function, products, other)
        largest = np.maximum(largest, now.max(1))
        better = (now / scale).max(0) > best
        best = np.where(better, (now / scale).max(0), best)
        given = [[np.where(better, y, x) for x, y in zip(*pair, strict=True)]
                 for pair in zip(given, other, strict=True)]
    return largest


def written(made: FixedScene, folder: Path) -> None:
    """Writes the scene's files."""
    for path, text in scene_c_fixed.files(made, "for a test").items():
        (folder / path).write_text(text)


def many(made: FixedScene, function: FixedFunction, products: Products) -> str:
    """C that calls the function for a number of states that lie one behind another."""
    name = scene_c_fixed.c_name(made, function, products)
    inputs = [(a.name, len(x)) for a, x in zip(function.plain.inputs, function.inputs,
                                               strict=True)]
    outputs = [(f"{a.name}_made", a.quantity.size) for a in function.plain.program.outputs]
    head = ", ".join([*(f"const int32_t *{x}" for x, _ in inputs),
                      *(f"int32_t *{x}" for x, _ in outputs)])
    call = ", ".join(f"{x} + {n} * i" for x, n in (*inputs, *outputs))
    return (f'#include "{made.stem}.h"\n'
            f"void many(long count, {head});\n"
            f"void many(long count, {head}) {{\n"
            f"  for (long i = 0; i < count; i++) {name}({call});\n}}\n")


def compiled(made: FixedScene, function: FixedFunction, products: Products, folder: Path,
             given: Sequence[Row], command: Sequence[str]) -> np.ndarray:
    """The results of compiled C, a row for each component."""
    written(made, folder)
    (folder / "many.c").write_text(many(made, function, products))
    library = folder / "many.so"
    run((*command, "-shared", "-fPIC", "-I", folder, folder / "many.c",
         folder / f"{made.stem}{MARKS[products]}.c", "-o", library))
    count = len(given[0][0])
    rows = [np.ascontiguousarray(np.stack(parts).T.astype(np.int32)) for parts in given]
    made_rows = [np.zeros((count, a.quantity.size), np.int32)
                 for a in function.plain.program.outputs]
    ctypes.CDLL(str(library)).many(ctypes.c_long(count), *(
        x.ctypes.data_as(ctypes.c_void_p) for x in (*rows, *made_rows)))
    return np.concatenate([x.T for x in made_rows])


def with_constant(program: FixedProgram, number: int, place: int, value: int) -> FixedProgram:
    """The program with another integer as an operand of an instruction."""
    steps = list(program.program.instructions)
    operands = list(steps[number].operands)
    operands[place] = Constant(Fraction(value), Fraction(value))
    steps[number] = steps[number]._replace(operands=tuple(operands))
    return replace(program, program=replace(program.program, instructions=tuple(steps)))
