"""Emitted functions that cannot be compared symbolically, in C and Python, are compared in 60
digits.

Their text equals their kernel, to the last of 50 digits; their text, with constants as emitted but
nothing else rounded, is their truth except for a fraction of u.
"""

import ast
import inspect
import textwrap
from collections.abc import Callable
from fractions import Fraction
from functools import cache, partial
from types import FunctionType

import gmpy2
import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from gmpy2 import is_nan, mpfr

import coscrew
from coscrew_codegen.algebra.lowering.kernel import Kernel, kernel_of, simplified
from coscrew_codegen.algebra.operations import Operation
from coscrew_codegen.backends.c.c_operations import c_name
from coscrew_codegen.program import Op
from coscrew_codegen.program.values.formats import DOUBLE, PRECISIONS, SINGLE, Precision
from tests.support.cases import for_all
from tests.support.compiled.c_reader import Header, Place, header, sign_flips
from tests.support.each import each_precision
from tests.support.motion_inputs import motions_of
from tests.support.sampling import inputs_of
from tests.support.truth.attack import plain_program
from tests.support.truth.motion_errors import as_arrays, errors, multiprecise, truth_of, unit
from tests.support.truth.motions import TRUTHS, matrix_of, nearest_quaternion, norm
from tests.support.truth.multiprecision import (
    DIGITS,
    NAN,
    NUMERIC,
    WIDE,
    Evaluator,
    Number,
    Rules,
    c_arithmetic,
    can_evaluate,
    python_function,
    wide,
)

Row = tuple[list[mpfr], ...]  # components of every input
TOLERATED = mpfr("1e-40")
Run = Callable[[Operation, Rules, Row], list[mpfr]]

# That they suffice, branches taken and signs flipped show.
ROWS = 36

# Later turns of columns mend what earlier ones spoil, and hardly any takes every branch: what is
# looked at are results, in tests/laws/test_nearest_rotations.py.
MENDING = ("mat3x3_nearest_rotation",)

# The last row of L times its pivot enters only squared, so that its sign is free there.
SIGNED = tuple(op for op in NUMERIC if op.name not in ("spatial_inertia_consistency", *MENDING))
BRANCHED = tuple(op for op in NUMERIC if op.name not in MENDING)

# grid ± θ leave ±θ in few digits, which enters only squared; sums of sizes are thresholds.
FREE = ("theta_shifted", "exp_theta_shifted", "permanent")

each_operation = pytest.mark.parametrize("operation", NUMERIC, ids=lambda op: op.name)


@pytest.fixture(autouse=True)
def digits():
    with mp.workdps(DIGITS), gmpy2.context(WIDE):
        yield


def run_c(operation: Operation, rules: Rules, row: Row, functions: Header | None = None,
          shared: tuple[str, str] | None = None) -> list[mpfr]:
    """Every component of every output of the C function; `shared`: an output and the input whose
    object it is."""
    functions = (functions or header()).with_arithmetic(c_arithmetic(rules))
    name = c_name(operation.name, rules.precision)
    types = functions.parameters(name)
    memory: dict[str, object] = {n: Place.new(kind) for n, kind in types.items()}
    for argument, values in zip(operation.inputs, row, strict=True):
        numbers = [rules.number(x) for x in values]
        if not argument.quantity.shape:
            memory[argument.name] = numbers[0]
            continue
        for index, number in zip(np.ndindex(argument.quantity.shape), numbers, strict=True):
            memory[argument.name].entry(*index).write(number)
    if shared:
        memory[shared[0]] = memory[shared[1]]
    value = functions.call(name, *(memory[n] for n in types))
    if value is not None:
        memory[operation.outputs[0].name] = value
    results = []
    for output in operation.outputs:
        place = memory[output.name]
        results += ([place.entry(*index).read() for index in np.ndindex(output.quantity.shape)]
                    if isinstance(place, Place) else [place])
    return values_of(results, rules)


def run_python(operation: Operation, rules: Rules, row: Row,
               function: FunctionType | None = None) -> list[mpfr]:
    """Every component of every output of the Python function."""
    module = getattr(coscrew, rules.precision.name)
    function = function or getattr(module, operation.name).__wrapped__
    arguments = [tuple(map(rules.number, x)) if a.quantity.shape else rules.number(x[0])
                 for a, x in zip(operation.inputs, row, strict=True)]
    result = python_function(function, rules)(*arguments)
    return values_of(result if isinstance(result, tuple) else (result,), rules)


def values_of(results: list[Number | int | sp.Basic], rules: Rules) -> list[mpfr]:
    return [NAN if x is sp.nan else rules.number(x).value for x in results]


@cache
def kernel(operation: Operation) -> Kernel:
    return simplified(kernel_of(operation))


def run_kernel(operation: Operation, rules: Rules, row: Row,
               seen: set | None = None) -> list[mpfr]:
    """Every component of every output of the kernel; adds the conditions met to `seen`."""
    evaluator = evaluator_of(operation, rules, row)
    results = evaluator.kernel(kernel(operation))
    if seen is not None:
        seen |= evaluator.seen
    return [x.value for x in results]


def evaluator_of(operation: Operation, rules: Rules, row: Row) -> Evaluator:
    symbols = [s for a in operation.inputs for s in a.symbols]
    numbers = [rules.number(x) for values in row for x in values]
    return Evaluator(rules, dict(zip(symbols, numbers, strict=True)))


@cache
def rows(operation: Operation, precision: Precision) -> list[Row]:
    """Floats that take every branch: motions if the operation has them, arbitrary finite numbers,
    zeros, and among zeros a one or a small number."""
    groups = [inputs_of(operation, precision, ROWS)]
    if operation.name in TRUTHS:
        motions = motions_of(operation, precision, ROWS)
        groups += [motions, tuple(4 * x[:10] for x in motions)]
        if operation.inputs[0].name in ("v", "s"):  # below the end of series, where all terms count
            turns = np.random.default_rng(1).uniform(-1, 1, (12, motions[0].shape[1])) / 2
            groups += [tuple(c * turns.astype(precision.numpy_type) if n == 0 else x[:12]
                             for n, x in enumerate(motions)) for c in (1, 2)]
    if operation.family == "symmetric":
        A, *others = inputs_of(operation, precision, 240)
        A, *others = (x[:20] for x in (A, *others))  # the ordinary ones
        definite = A @ A.swapaxes(1, 2)
        spoiled = definite.copy()  # each in one pivot, the first that is not positive
        places = np.arange(len(A)) % A.shape[1]
        spoiled[np.arange(len(A)), places, places] = -1
        singular = np.array([singular_at(k, M) for k, M in zip(places, definite, strict=True)])
        groups = [(x, *others) for x in (definite, A, spoiled, singular)]
    if operation.name == "mat3x3_inverse":  # of every size
        info = np.finfo(precision.numpy_type)
        exponents = np.linspace(info.minexp, info.maxexp - 3, 20).astype(int)[:, None, None]
        (matrices,) = inputs_of(operation, precision, 240)
        groups.append((np.ldexp(matrices[:20], exponents),))  # the ordinary ones
    if operation.name == "mat3x3_rotation_defect":  # each pair of columns along each other
        (matrices,) = inputs_of(operation, precision, 240)
        for i, j in ((0, 1), (0, 2), (1, 2)):
            sheared = matrices[:10].copy()  # the ordinary ones
            sheared[:, :, j] = sheared[:, :, i]
            groups.append((1.2 * sheared / np.linalg.norm(sheared, axis=1, keepdims=True),))
    sizes = np.cumsum([a.quantity.size for a in operation.inputs])
    units = np.vstack([np.zeros(sizes[-1]), np.eye(sizes[-1])])
    groups += [np.split(size * units, sizes[:-1], axis=1) for size in (1, 2.0**-70)]
    results = [tuple([mpfr(float(c)) for c in np.ravel(x)] for x in row)
               for group in groups for row in zip(*group, strict=True)]
    # For the sine of larger angles 60 digits are not enough.
    largest = [1e6 if a.name in ("v", "s", "k", "angle") and Op.SIN in
               plain_program(operation).counts else np.inf for a in operation.inputs]
    return [row for row in results
            if all(abs(c) < limit for x, limit in zip(row, largest, strict=True) for c in x)]


def singular_at(k: int, M: np.ndarray) -> np.ndarray:
    """M without the entries that couple its first k + 1 rows to the others, and with a pivot k that
    vanishes except for the rounding of its diagonal entry: only the threshold for regular matrices
    refuses it."""
    result = M.copy()
    result[:k + 1, k + 1:] = result[k + 1:, :k + 1] = 0
    rest = [[Fraction(x) for x in row[:k + 1]] for row in result[:k + 1].tolist()]
    for _ in range(k):
        rest = [[x - row[0] * y / rest[0][0] for x, y in zip(row[1:], rest[0][1:], strict=True)]
                for row in rest[1:]]
    result[k, k] = float(Fraction(float(result[k, k])) - rest[0][0])
    return result


def differs(results: list[mpfr], wanted: list[mpfr]) -> bool:
    """By more than 1e-40 of the largest."""
    size = max([abs(x) for x in wanted if not is_nan(x)], default=mpfr(0))
    return any(is_nan(x) != is_nan(y) or abs(x - y) > size * TOLERATED
               for x, y in zip(results, wanted, strict=True))


RUNS = {"C": run_c, "Python": run_python}


@each_operation
@for_all(precision=PRECISIONS, language=RUNS)
def test_text_is_its_kernel(operation, precision, language):
    rules = Rules(precision, rounds=True)
    for row, wanted in zip(rows(operation, precision), results(operation, precision), strict=True):
        result = RUNS[language](operation, rules, row)
        assert not differs(result, wanted), [[float(x).hex() for x in part] for part in row]


@pytest.mark.parametrize("operation", BRANCHED, ids=lambda op: op.name)
@for_all(precision=PRECISIONS)
def test_rows_take_every_branch(operation, precision):
    _, seen = evaluated(operation, precision)
    conditions = {test for test, _ in seen}
    assert {(test, value) for test in conditions for value in (True, False)} == seen


@each_operation
def test_c_output_may_be_an_input(operation):
    rules, row = Rules(DOUBLE), rows(operation, DOUBLE)[0]
    moved = {output.name for output in operation.outputs}
    for output in operation.outputs:
        for source in operation.inputs:
            of_its_own = source.name == output.name or not {source.name, output.name} <= moved
            if source.quantity == output.quantity and source.quantity.shape and of_its_own:
                together = run_c(operation, rules, row, shared=(output.name, source.name))
                assert together == run_c(operation, rules, row)


def test_another_threshold_is_noticed():
    operation, name = next(op for op in NUMERIC if op.name == "coscrew_norm"), "ksl_coscrew_norm"
    rules, row = Rules(DOUBLE), ([mpfr(5e-9)] * 3 + [mpfr(1)] * 3,)
    wrong = header().with_text(name, header().texts[name].replace("1e-09", "1e-08"))
    wanted = run_kernel(operation, rules, row)
    assert not fails(run_c, operation, rules, row, wanted)
    assert fails(partial(run_c, functions=wrong), operation, rules, row, wanted)


@pytest.mark.parametrize("operation", SIGNED, ids=lambda op: op.name)
def test_any_flipped_sign_in_c_is_noticed(operation):
    name, tried = c_name(operation.name, DOUBLE), compared(operation, DOUBLE)
    for wrong in header().flips(name, FREE):
        assert noticed(operation, DOUBLE, partial(run_c, functions=wrong), tried), wrong.text(name)


@pytest.mark.parametrize("operation", SIGNED, ids=lambda op: op.name)
def test_any_flipped_sign_in_python_is_noticed(operation):
    function = getattr(coscrew.single, operation.name).__wrapped__
    tree = ast.parse(textwrap.dedent(inspect.getsource(function))).body[0]
    tree.decorator_list, tree.body = [], tree.body[1:]  # without its docstring
    tried = compared(operation, SINGLE)
    for text in sign_flips(ast.unparse(tree), FREE):
        scope = dict(function.__globals__)
        exec(text, scope)
        wrong = scope[operation.name]
        assert noticed(operation, SINGLE, partial(run_python, function=wrong), tried), text


def compared(operation: Operation, precision: Precision) -> list[tuple[Row, list[mpfr]]]:
    """Rows, and the kernel's results."""
    return list(zip(rows(operation, precision), results(operation, precision), strict=True))


def noticed(operation: Operation, precision: Precision, run: Run,
            tried: list[tuple[Row, list[mpfr]]]) -> bool:
    """Returns whether any row shows a difference.  The row that does becomes the first to be tried:
    the next sign is likely to be in the same branch."""
    rules = Rules(precision, rounds=True)
    for number, (row, wanted) in enumerate(tried):
        if fails(run, operation, rules, row, wanted):
            tried.insert(0, tried.pop(number))
            return True
    return False


def results(operation: Operation, precision: Precision) -> list[list[mpfr]]:
    """The kernel's results for each row."""
    return evaluated(operation, precision)[0]


@cache
def evaluated(operation: Operation, precision: Precision) -> tuple[list[list[mpfr]], set]:
    """The kernel's results for each row, and the conditions met."""
    rules, seen = Rules(precision, rounds=True), set()
    return [run_kernel(operation, rules, row, seen) for row in rows(operation, precision)], seen


def fails(run: Run, operation: Operation, rules: Rules, row: Row, wanted: list[mpfr]) -> bool:
    """Returns whether the result differs, or there is a division by zero."""
    try:
        return differs(run(operation, rules, row), wanted)
    except ZeroDivisionError:
        return True


# against the truth


@each_precision
@pytest.mark.parametrize("operation", [op for op in NUMERIC if op.name in TRUTHS],
                         ids=lambda op: op.name)
def test_series_and_text_are_their_truth(operation, precision):
    """Rotations and axes are exact to the last digit.  With exact constants, the truncation error
    of series is below u / 2; rounded constants add less than a third of the stated bound."""
    u, bounds = unit(precision), {b.part: b.k for b in operation.normwise}
    runs = [(run_kernel, Rules(precision, exact=True), lambda part: u / 2),
            *((run, Rules(precision), lambda part: bounds[part] * u / 3) for run in RUNS.values())]
    for given in zip(*motions_of(operation, precision, 30), strict=True):
        arguments = [orthonormal(a.name, multiprecise(x))
                     for a, x in zip(operation.inputs, given, strict=True)]
        inputs = [as_arrays(x)[0] for x in arguments]
        row = tuple([wide(c) for c in np.ravel(x)] for x in inputs)
        truths = truth_of(operation, tuple(arguments), mp.mpf(10)**-40)
        for run, rules, bound in runs:
            results = (mp.mpf(x.as_mantissa_exp()) for x in run(operation, rules, row))
            outputs = [np.array([next(results) for _ in range(a.quantity.size)], dtype=object)
                       .reshape(a.quantity.rows_columns) for a in operation.outputs]
            for part, error in errors(operation, inputs, outputs, truths).items():
                assert error <= bound(part), (part, float(error / u), given)


def orthonormal(name: str, x: mp.matrix | mp.mpf) -> mp.matrix | mp.mpf:
    """The rotation, displacement, quaternion or axis next to x, where the input stands for one."""
    if name in ("R", "D", "D1", "D2"):
        x[0:3, 0:3] = matrix_of(nearest_quaternion(x[0:3, 0:3]))
    return x / norm(x) if name in ("q1", "q2", "axis") else x


@pytest.mark.parametrize("operation", [op for op in NUMERIC if op.name not in TRUTHS and
                                       all(map(can_evaluate, op.truth()))], ids=lambda op: op.name)
@for_all(precision=PRECISIONS, language=RUNS)
def test_text_is_its_formula(operation, precision, language):
    """Norms and angles: scaling is undone to the last digit."""
    rules, truth = Rules(precision), operation.truth()
    for row in rows(operation, precision):
        evaluator = evaluator_of(operation, rules, row)
        wanted = [evaluator(x).value for x in truth]
        assert not differs(RUNS[language](operation, rules, row), wanted)
