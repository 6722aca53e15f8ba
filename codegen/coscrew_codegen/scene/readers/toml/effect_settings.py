"""Reads the values of effects' parameters, according to their kinds."""

import math
from fractions import Fraction
from typing import TypeGuard

from coscrew_codegen.scene.effect import ParameterOf
from coscrew_codegen.scene.formulas import PLACE, Formula, FormulaError
from coscrew_codegen.scene.mechanism.model import WORLD
from coscrew_codegen.scene.readers.scene_error import shown
from coscrew_codegen.scene.readers.toml.tables.height_table import height_grid
from coscrew_codegen.scene.readers.toml.toml_tables import Decimals, TomlTable, described
from coscrew_codegen.scene.readers.toml.trajectories.trajectory_table import trajectory
from coscrew_codegen.scene.scene import Setting


def setting(table: TomlTable, parameter: ParameterOf, value: object, bodies: tuple[str, ...]
            ) -> Setting:
    """The value of a parameter from the file's value.  Raises SceneError if the kind is wrong."""
    key, kind = parameter.name, parameter.kind
    if kind == "vector":
        vector = table.as_numbers(key, value, (3,))
        for component in vector:
            refuse_sign(table, parameter, component)
        return vector
    if kind == "matrix":
        return _matrix(table, key, value)
    if kind == "formula":
        return _formula(table, parameter, value)
    if kind == "height":
        return _height(table, parameter, value)
    if kind == "formulas":
        if not isinstance(value, list) or len(value) != 3:
            table.refuse(key, f"{described(value)}; wanted a list of 3 numbers or functions of t")
        return tuple(_formula(table, parameter, item) for item in value)
    if kind == "choice":
        return table.as_choice(key, value, parameter.choices)
    if kind == "body":
        return table.known(key, table.as_text(key, value), "body", (WORLD, *bodies))
    if kind == "flag":
        if not isinstance(value, bool):
            table.refuse(key, f"{described(value)}; wanted true or false")
        return "true" if value else None
    number = _number(table, parameter, value)
    refuse_sign(table, parameter, number)
    return number


def _matrix(table: TomlTable, key: str, value: object) -> tuple[Fraction, ...]:
    """The rows on and below the diagonal of a symmetric matrix without negative eigenvalues."""
    rows = value if isinstance(value, list) else []
    if len(rows) != 6:
        table.refuse(key, f"{described(value)}; wanted six rows of six numbers")
    matrix = [list(table.as_numbers(key, row, (6,))) for row in rows]
    for i in range(6):
        for j in range(i):
            if matrix[i][j] != matrix[j][i]:
                table.refuse(key, f"{float(matrix[i][j]):g} in row {i + 1}, column {j + 1}, and "
                             f"{float(matrix[j][i]):g} opposite; wanted a symmetric matrix")
    if (k := negative_pivot(matrix)) is not None:
        table.refuse(key, f"its first {k + 1} rows and columns are not positive semidefinite: a "
                     "motion along them would have a negative energy; wanted the added masses with "
                     "positive signs, as -X_u', -Y_v'")
    return tuple(matrix[i][j] for i in range(6) for j in range(i + 1))


def negative_pivot(matrix: list[list[Fraction]]) -> int | None:
    """The number of the first row that makes a symmetric matrix indefinite; None if it is positive
    semidefinite.  By elimination in exact fractions."""
    left = [list(row) for row in matrix]
    for k, row in enumerate(left):
        if row[k] < 0 or not row[k] and any(row[k + 1:]):
            return k
        for i in range(k + 1, len(left)) if row[k] else ():
            factor = left[i][k] / row[k]
            left[i] = [x - factor * y for x, y in zip(left[i], row, strict=True)]
    return None


def _number(table: TomlTable, parameter: ParameterOf, value: object) -> Fraction:
    if parameter.model and _is_text(value):
        try:
            from coscrew_codegen.scene.constants import constant
            return constant(value)
        except FormulaError:
            table.refuse(parameter.name, f"the text {shown(value)}; wanted a number without "
                                         'quotes, a constant formula, or "model"')
    return table.as_number(parameter.name, value)


def default(table: TomlTable, parameter: ParameterOf) -> Setting:
    """The default value of a parameter.  Raises SceneError if it is required."""
    value = parameter.default
    if value is None:
        if parameter.required:
            unit = f" in {parameter.unit}" if parameter.unit else ""
            choices = f": {', '.join(parameter.choices)}" if parameter.choices else ""
            table.missing(parameter.name, f"{parameter.words}{unit}{choices}")
        return None
    if isinstance(value, tuple):
        return tuple(Fraction(component) for component in value)
    return value if isinstance(value, str) else Fraction(value)


def refuse_sign(table: TomlTable, parameter: ParameterOf, number: Fraction,
                where: str = "") -> None:
    """Refuse numbers below zero, or zero, as the parameter demands."""
    if parameter.sign and parameter.sign.refuses(number):
        table.refuse(parameter.name, f"{float(number):g}{where}; wanted {parameter.sign.value}")


def _formula(table: TomlTable, parameter: ParameterOf, value: object) -> Fraction | Formula:
    if isinstance(value, dict):
        return trajectory(TomlTable(table.file, table.key(parameter.name), value))
    if not _is_text(value):
        if isinstance(value, bool) or not isinstance(value, int | Decimals):
            table.refuse(parameter.name, f"{described(value)}; wanted a number or a function of t")
        number = table.as_number(parameter.name, value)
        refuse_sign(table, parameter, number)
        return number
    try:
        formula = Formula(value)
    except FormulaError as error:
        table.refuse(parameter.name, str(error))
    if formula.is_number:
        table.refuse(parameter.name, f"the text {shown(value)}; wanted the number, without quotes")
    if math.isnan(formula.at(0.0)):
        table.refuse(parameter.name, f"formula {shown(value)} is not finite at t = 0")
    return formula


def _height(table: TomlTable, parameter: ParameterOf, value: object) -> Formula:
    """A function of x and y, or a grid of heights."""
    if isinstance(value, dict):
        return height_grid(TomlTable(table.file, table.key(parameter.name), value))
    if not _is_text(value):
        table.refuse(parameter.name, f"{described(value)}; wanted a function of x and y, as "
                                     f"{parameter.example}, or {{ file = \"ground.csv\" }}")
    try:
        formula = Formula(value, of=PLACE)
    except FormulaError as error:
        table.refuse(parameter.name, str(error))
    if math.isnan(formula.at(0.0)):
        table.refuse(parameter.name, f"formula {shown(value)} is not finite at x = y = 0")
    return formula


def _is_text(value: object) -> TypeGuard[str]:
    return isinstance(value, str) and not isinstance(value, Decimals)
