"""An operation's formula in LaTeX, component by component, from SymPy."""

import sympy as sp
from sympy.printing.latex import LatexPrinter

from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.program.values.quantity import Argument
from coscrew_codegen.reports.reference.notation import latex_name

_WIDEST = 130  # characters in a row of the result, as SymPy writes it: longer ones are unreadable
_KNOWN = (sp.sin, sp.cos)
_AXES = {"vec3": "xyz", "vec4": "xyzw", "quaternion": "xyzw"}


def formulas(operation: Operation) -> tuple[str, ...]:
    """'\\mathrm{vo} = \\begin{pmatrix} … \\end{pmatrix}' for each output; () if components are too
    long to read, or are piecewise."""
    values = operation.formula(*(a.value for a in operation.inputs))
    values = values if isinstance(values, tuple) else (values,)
    rows = [row for value in values for row in _rows(value)]
    if any(x.atoms(sp.Function) - x.atoms(*_KNOWN) or x.has(sp.Piecewise)
           for row in rows for x in row):
        return ()
    if any(sum(len(str(x)) for x in row) > _WIDEST for row in rows):
        return ()
    names = {symbol: _component(argument, i) for argument in operation.inputs
             for i, symbol in enumerate(argument.symbols)}
    taken = {argument.name for argument in operation.inputs}
    printer = LatexPrinter({"symbol_names": names})
    return tuple(_equation(output, value, printer, output.name in taken)
                 for output, value in zip(operation.outputs, values, strict=True))


def _equation(output: Argument, value: sp.Matrix | sp.Expr, printer: LatexPrinter,
              in_place: bool) -> str:
    sign = r"\leftarrow" if in_place else "="
    rows = [" & ".join(printer.doprint(x) for x in row) for row in _rows(value)]
    inner = r" \\ ".join(rows)
    if len(rows) > 1 or "&" in inner:
        inner = rf"\begin{{pmatrix}} {inner} \end{{pmatrix}}"
    return f"{latex_name(output.name)} {sign} {inner}"


def _rows(value: sp.Matrix | sp.Expr) -> list[list[sp.Expr]]:
    return value.tolist() if isinstance(value, sp.MatrixBase) else [[sp.sympify(value)]]


def _component(argument: Argument, index: int) -> str:
    """v_{x}, c_{3}, D_{03}: components are counted from 0."""
    quantity = argument.quantity
    if not quantity.shape:
        return latex_name(argument.name)
    if quantity.name in _AXES:
        return latex_name(argument.name, _AXES[quantity.name][index])
    row, column = quantity.indices[index]
    return latex_name(argument.name, f"{row}{column}" if len(quantity.shape) == 2 else str(row))
