"""Each emitted function, in C and in Python, is identically its operation's formula."""

import ast
import inspect
import operator
import textwrap
from collections.abc import Callable, Iterator
from functools import cache
from itertools import product
from types import FunctionType, SimpleNamespace

import pytest
import sympy as sp
from sympy.core.relational import Relational

import coscrew
from coscrew_codegen.algebra.operations import FAMILIES, NORM_THRESHOLD, OPERATIONS, Operation
from coscrew_codegen.program.values.formats import DOUBLE, PRECISIONS, SINGLE, Precision
from tests.support.cases import for_all
from tests.support.compiled.c_reader import FAMILIES as HEADERS
from tests.support.compiled.c_reader import Header, Place, Value, functions_in, header, sign_flips
from tests.support.each import each_precision
from tests.support.truth.multiprecision import NUMERIC

THRESHOLDS = {DOUBLE: sp.Rational(1, 10**9), SINGLE: sp.Rational(1, 10**6)}
SHAPES = {"vec3": (3,), "vec4": (4,), "mat3x3": (3, 3), "mat4x4": (4, 4), "SE3": (3, 4),
          "screw": (6,), "coscrew": (6,), "mat6x6": (6, 6), "quaternion": (4,),
          "inertia": (10,), "spatial_inertia": (10,)}  # of the C types, row by row
NAMES = {"vec3": ["x", "y", "z"], "vec4": ["x", "y", "z", "w"],
         "quaternion": ["x", "y", "z", "w"],
         "spatial_inertia": ["m", "hx", "hy", "hz", "xx", "yy", "zz", "xy", "xz", "yz"]}

FORMULAS = tuple(op for op in OPERATIONS if op.family != "elementary")
"""The others: tests/elementary."""
COMPARED = tuple(op for op in FORMULAS if op not in NUMERIC)
"""The others: test_numeric_truth."""
each_compared = pytest.mark.parametrize("operation", COMPARED, ids=lambda op: op.name)


@cache
def truth(operation: Operation) -> tuple[sp.Expr, ...]:
    return operation.truth()


def c_name(name: str, precision: Precision) -> str:
    """Single-precision names have an f after the type with which they start (ksl_screwf_copy), also
    after the second type of a conversion (ksl_mat4x4f_toSE3f), else at the end."""
    joined = name.replace("spatial_inertia", "spatial~inertia")
    head, *tail = (x.replace("~", "_") for x in joined.split("_", 1))
    if name.startswith("quaternion_product") and precision is SINGLE:
        head, tail = "", []
        name = name.removeprefix("quaternion_")  # as in KSL
    if tail and tail[0].removeprefix("from").removeprefix("to") in ("SE3", "Mat4x4"):
        tail = [tail[0] + precision.suffix]
    return f"ksl_{'_'.join([head + precision.suffix, *tail])}" if head in SHAPES \
        else f"ksl_{name}{precision.suffix}"


def difference(results: tuple[sp.Expr, ...], operation: Operation) -> sp.Expr | None:
    """The error of the first wrong component, under any conditions; None if all are right."""
    wanted = truth(operation)
    assert len(results) == len(wanted)
    differences = (sp.expand(branch[i] - branch[i + len(wanted)])
                   for branch in branches(sp.Tuple(*results, *wanted)) for i in range(len(wanted)))
    return next((d for d in differences if d != 0), None)


def is_wrong(results: tuple[sp.Expr, ...], operation: Operation) -> bool:
    """Returns whether there is a difference: where numbers show none, by algebra."""
    symbols = sorted({s for a in operation.inputs for s in a.symbols}, key=str)
    values = {s: sp.Rational(7 * n + 3, 5) for n, s in enumerate(symbols)}
    values[NORM_THRESHOLD] = THRESHOLDS[DOUBLE]
    numbers = (x.xreplace(values) - y.xreplace(values)
               for x, y in zip(results, truth(operation), strict=True))
    return any(x.is_Rational and x != 0 for x in numbers) or difference(results,
                                                                        operation) is not None


def branches(expressions: sp.Tuple) -> Iterator[sp.Tuple]:
    """The expressions for every assignment of true and false to their conditions."""
    relations = [r for r in expressions.atoms(Relational) if not r.has(sp.Piecewise)]
    if not relations:
        assert not expressions.has(sp.Piecewise)
        yield expressions
        return
    first = min(relations, key=sp.default_sort_key)
    for value in (sp.true, sp.false):
        yield from branches(expressions.xreplace({first: value}))


def named(expressions: list[sp.Expr], precision: Precision) -> tuple[sp.Expr, ...]:
    """With the threshold of this precision, and no other number, under its name."""
    names = {THRESHOLDS[precision]: NORM_THRESHOLD}
    return tuple(sp.sympify(x).xreplace(names) for x in expressions)


# C


def run_c(functions: Header, operation: Operation, precision: Precision,
          shared: dict[str, str] | None = None) -> tuple[sp.Expr, ...]:
    """Every component of every output; `shared` says which output is which input's object."""
    name, shared = c_name(operation.name, precision), shared or {}
    types = functions.parameters(name)
    memory: dict[str, Value] = {n: Place.new(kind) for n, kind in types.items()}
    for argument in operation.inputs:
        if not argument.quantity.shape:
            memory[argument.name] = argument.value
        elif argument.name not in shared:
            for symbol, i in zip(argument.symbols, places(argument.quantity.shape), strict=True):
                memory[argument.name].entry(*i).write(symbol)
    memory |= {output: memory[source] for output, source in shared.items()}
    value = functions.call(name, *(memory[n] for n in types))
    results = [memory[a.name] if value is None else value for a in operation.outputs]
    return named([x.entry(*index).read() if isinstance(x, Place) else x
                  for x, a in zip(results, operation.outputs, strict=True)
                  for index in places(a.quantity.shape)], precision)


def places(shape: tuple[int, ...]) -> list[tuple[int, ...]]:
    """(i), or (row, column), of every component, row by row."""
    return list(product(*map(range, shape)))


@each_compared
@for_all(precision=PRECISIONS)
def test_c_function_is_its_truth(operation, precision):
    assert difference(run_c(header(), operation, precision), operation) is None


@for_all(operation=COMPARED)
def test_c_output_may_be_an_input(operation):
    apart = run_c(header(), operation, DOUBLE)
    for output in operation.outputs:
        for source in operation.inputs:
            if source.quantity == output.quantity and source.name != output.name:
                together = run_c(header(), operation, DOUBLE, {output.name: source.name})
                same = dict(zip(output.symbols, source.symbols, strict=True))
                assert together == tuple(x.xreplace(same) for x in apart)


@for_all(operation=FORMULAS, precision=PRECISIONS)
def test_c_parameters_are_inputs_then_outputs(operation, precision):
    name, outputs = c_name(operation.name, precision), {a.name for a in operation.outputs}
    names = list(dict.fromkeys(a.name for a in (*operation.inputs, *operation.outputs)))
    parameters = list(header().parameters(name))
    assert parameters == (list(operation.order) or [n for n in names if n in parameters])
    pointers = {a.name for a in operation.inputs if a.quantity.shape and not operation.by_value}
    assert header().constant_parameters(name) == pointers - outputs


with_sums = pytest.mark.parametrize("operation", [
    op for op in COMPARED if any(sign_flips(header().texts[c_name(op.name, DOUBLE)]))],
    ids=lambda op: op.name)


@with_sums
def test_c_comparison_notices_any_flipped_sign(operation):
    name = c_name(operation.name, DOUBLE)
    for wrong in header().flips(name):
        assert is_wrong(run_c(wrong, operation, DOUBLE), operation), wrong.text(name)


@pytest.mark.parametrize("wrong", [("1e-06f", "1e-06"), ("fabsf(", "fabs("), ("float", "double")])
def test_c_reader_refuses_double_in_single_precision(wrong):
    text = header().texts["ksl_screwf_norm"].replace(*wrong, 1)
    with pytest.raises(TypeError, match="mixes double and float"):
        header().with_text("ksl_screwf_norm", text).parameters("ksl_screwf_norm")


@pytest.mark.parametrize("family", sorted(set(FAMILIES) - {"elementary"}))
def test_c_header_holds_its_family_and_no_more(family):
    wanted = {c_name(op.name, p) for op in OPERATIONS if op.family == family for p in PRECISIONS}
    for p in PRECISIONS:
        stem = f"ksl_{family}{p.suffix}"
        wanted |= {f"{stem}_alloc"} if family in SHAPES else set()
        wanted |= {stem} if family in set(SHAPES) - {"mat6x6"} else set()
        wanted |= {f"{stem}_cmo"} if family in ("mat3x3", "mat4x4", "SE3") else set()
        wanted |= {f"{stem}_identity"} if family == "SE3" else set()
        wanted |= {f"{stem}_get", f"{stem}_set"} if len(SHAPES.get(family, ())) == 2 else set()
    assert set(functions_in(family)) == wanted


def test_every_family_has_a_header():
    assert set(HEADERS) == {*FAMILIES, "axis", "array"} - {"elementary"}


def test_every_double_function_has_its_single_twin():
    double, single = ({name for name in header().texts if header().precisions(name) == {c_type}}
                      for c_type in ("double", "float"))
    assert double | single == set(header().texts)
    assert single == {c_name(name.removeprefix("ksl_"), SINGLE) for name in double}


# C functions that only move numbers


@pytest.mark.parametrize("kind, by_columns", [
    ("vec3", False), ("screw", False), ("coscrew", False), ("quaternion", False),
    ("spatial_inertia", False), ("mat3x3", False), ("mat3x3", True), ("SE3", False), ("SE3", True)])
@each_precision
def test_constructor_puts_entries_where_their_names_say(kind, by_columns, precision):
    name = f"ksl_{kind}{precision.suffix}{'_cmo' if by_columns else ''}"
    order = sorted(places(SHAPES[kind]), key=lambda i: i[::-1] if by_columns else i)
    names = NAMES.get(kind) or ["m" + "".join(map(str, i)) for i in order]
    assert list(header().parameters(name)) == names
    value = header().call(name, *sp.symbols(names))
    for parameter, index in zip(names, order, strict=True):
        place = value.member("h").member(parameter[1]) if parameter[0] == "h" else \
            value.member(parameter)
        assert place.read() == value.entry(*index).read() == sp.Symbol(parameter)


@each_precision
def test_identity_displacement(precision):
    value = header().call(f"ksl_SE3{precision.suffix}_identity")
    for i, j in places((3, 4)):
        assert value.entry(i, j).read() == int(i == j)


@pytest.mark.parametrize("kind", ["mat3x3", "SE3", "mat6x6"])
@each_precision
def test_get_and_set_reach_every_entry_and_nothing_else(kind, precision):
    stem, (rows, columns) = f"ksl_{kind}{precision.suffix}", SHAPES[kind]
    value = Place.new(header().types[f"{stem}_t"])
    for row, column in places((rows + 2, columns + 2)):
        header().call(f"{stem}_set", value, row - 1, column - 1, sp.Symbol(f"x{row}{column}"))
    for row, column in places((rows + 2, columns + 2)):
        inside = 1 <= row <= rows and 1 <= column <= columns
        wanted = sp.Symbol(f"x{row}{column}") if inside else sp.nan
        assert header().call(f"{stem}_get", value, row - 1, column - 1) == wanted
        assert not inside or value.entry(row - 1, column - 1).read() == wanted


@each_precision
def test_views_of_a_displacement_are_the_same_cells(precision):
    D = header().call(f"ksl_SE3{precision.suffix}", *(10 * i + j for i, j in places((3, 4))))
    assert D.member("m13") == D.member("t").member("y") == D.member("v3").member("y")
    assert [D.member("as_array").element(n).read() for n in (0, 1, 3, 11)] == [0, 10, 1, 23]
    assert D.member("R").member("m21").read() == 21 == D.member("v").element(1).entry(2).read()


# Python


def _lifted(function: Callable[..., sp.Basic]) -> Callable[..., "Symbolic"]:
    return lambda *values: Symbolic(function(*(Symbolic(x).expression for x in values)))


def _swapped(function: Callable[..., sp.Basic]) -> Callable[..., "Symbolic"]:
    return _lifted(lambda a, b: function(b, a))


class Symbolic:
    """A SymPy expression on which == and < make conditions, as they do on arrays."""

    def __init__(self, value: "Symbolic | sp.Expr | float"):
        self.expression = value.expression if isinstance(value, Symbolic) else \
            sp.Rational(str(value)) if isinstance(value, float) else sp.sympify(value)

    __add__, __radd__ = _lifted(operator.add), _swapped(operator.add)
    __sub__, __rsub__ = _lifted(operator.sub), _swapped(operator.sub)
    __mul__, __rmul__ = _lifted(operator.mul), _swapped(operator.mul)
    __truediv__, __rtruediv__ = _lifted(operator.truediv), _swapped(operator.truediv)
    __neg__, __lt__, __eq__ = _lifted(operator.neg), _lifted(operator.lt), _lifted(sp.Eq)


_SINE, _COSINE = _lifted(sp.sin), _lifted(sp.cos)
SYMPY = {"absolute": _lifted(sp.Abs), "sqrt": _lifted(sp.sqrt),
         "elementary": SimpleNamespace(sin=_SINE, cos=_COSINE,
                                       sincos=lambda x: (_SINE(x), _COSINE(x))),
         "where": _lifted(lambda test, x, y: sp.Piecewise((x, test), (y, True)))}


def twin(operation: Operation, precision: Precision) -> FunctionType:
    """The emitted Python function under its decorator, computing on SymPy expressions."""
    function = getattr(getattr(coscrew, precision.name), operation.name).__wrapped__
    return FunctionType(function.__code__, function.__globals__ | SYMPY, operation.name)


def run_python(function: FunctionType, operation: Operation,
               precision: Precision) -> tuple[sp.Expr, ...]:
    """Every component of every output."""
    arguments = [tuple(map(Symbolic, a.symbols)) if a.quantity.shape else Symbolic(a.value)
                 for a in operation.inputs]
    result = function(*arguments)
    result = result if isinstance(result, tuple) else (result,)
    return named([Symbolic(x).expression for x in result], precision)


@for_all(operation=COMPARED, precision=PRECISIONS)
def test_python_kernel_is_its_truth(operation, precision):
    result = run_python(twin(operation, precision), operation, precision)
    assert difference(result, operation) is None


@with_sums
def test_python_comparison_notices_any_flipped_sign(operation):
    function = twin(operation, SINGLE)
    source = inspect.getsource(getattr(coscrew.single, operation.name).__wrapped__)
    tree = ast.parse(textwrap.dedent(source)).body[0]
    tree.decorator_list, tree.body = [], tree.body[1:]  # without its docstring
    flipped = list(sign_flips(ast.unparse(tree)))
    assert flipped
    for text in flipped:
        scope = dict(function.__globals__)
        exec(text, scope)
        result = run_python(scope[operation.name], operation, SINGLE)
        assert is_wrong(result, operation), text


@each_precision
def test_python_module_holds_the_table_and_no_more(precision):
    module = getattr(coscrew, precision.name)
    functions = {name for name, value in vars(module).items() if isinstance(value, FunctionType)}
    assert functions == {op.name for op in OPERATIONS} | {"SE3", "screw", "coscrew"}
