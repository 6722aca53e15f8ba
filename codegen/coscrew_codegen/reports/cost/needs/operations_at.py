"""Counts the operations of a call at a state by kind, those of elementary functions included.

Software's floating point has short ways for zeros, so that an operation on a zero is a kind of its
own: sines of small angles multiply by many."""

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from coscrew_codegen.program import Instruction, Op, Program
from coscrew_codegen.program.elementary import ELEMENTARY, ERRORS, Elementary
from coscrew_codegen.program.elementary.elementary_calls import FUNCTION_OF
from coscrew_codegen.program.interpreter import Arithmetic, evaluate, exactly
from coscrew_codegen.program.ops import COMPARISONS
from coscrew_codegen.program.tables import TableColumn
from coscrew_codegen.program.values.formats import DOUBLE, Precision

KINDS = {
    **dict.fromkeys((Op.ADD, Op.SUB, Op.EXACT_ADD, Op.EXACT_SUB), "sum"),
    **dict.fromkeys((Op.MUL, Op.SCALE), "product"),
    **dict.fromkeys((Op.DIV, Op.SQRT), "quotient"),
    **dict.fromkeys(COMPARISONS, "comparison"),
    **dict.fromkeys((Op.PRODUCT_ERROR, Op.PRODUCT_REST), "product error")}
"""Kinds of operations of floating point; all others are moves."""
_FUNCTIONS = {function.name: function for function in (*ELEMENTARY, *ERRORS)}
_SECOND = frozenset({Op.COS, Op.COS_ERROR})  # results of functions that have two
Row = Sequence[float] | np.ndarray
"""The components of an argument."""
_EXACTLY = {Op.PRODUCT_ERROR, Op.PRODUCT_REST}


def counts_at(program: Program, precision: Precision, given: Sequence[Row]
              ) -> tuple[Counter[str], list[float]]:
    """The operations of a call by kind, with the call itself and the numbers that it reads and
    writes; and its results."""
    working = DOUBLE if program.wide else precision
    counts = Counter(call=1, input=len(program.used_inputs()), result=len(program.results))
    number = getattr(np, working.numpy_type)
    with np.errstate(all="ignore"):
        results = _run(program, working, [[number(x) for x in np.ravel(part)] for part in given],
                       counts)
    return counts, [float(x) for x in results]


def _run(program: Program, precision: Precision, given: Sequence[Sequence[Any]],
         counts: Counter[str]) -> list[Any]:
    """The results, and the operations added to these counts."""
    number: Callable[..., Any] = getattr(np, precision.numpy_type)
    known: Mapping[Op, Callable[..., Any]] = {**exactly(np), Op.GATHER: TableColumn.at}
    called: dict[object, list[Any]] = {}

    def function(step: Instruction, _: int) -> Callable[..., Any]:
        kind = KINDS.get(step.op, "move")
        if step.op in FUNCTION_OF:
            of = _FUNCTIONS[FUNCTION_OF[step.op]]
            size = 2 if of.name.startswith("atan2") else 1
            return lambda *x: _call(of, step, x[:size])
        apply = known[step.op]

        def counting(*x: Any) -> Any:
            zero = kind in ("sum", "product") and not (x[0] and x[1])
            counts[f"{kind} with zero" if zero else kind] += 1
            if step.op in _EXACTLY and np.isfinite(x).all():
                return number(float(apply(*map(Fraction, map(float, x)))))
            result = apply(*x)
            return result if step.op in COMPARISONS else number(result)

        return counting

    def _call(of: Elementary, step: Instruction, x: Sequence[Any]) -> Any:
        key = of.name, step.operands[:len(x)]
        if key not in called:
            called[key] = _elementary(of, precision, x, counts)
        return called[key][step.op in _SECOND]

    return evaluate(program, given, Arithmetic(
        lambda x: number(float(precision.value(x))), function, number(np.nan)))


def _elementary(of: Elementary, precision: Precision, x: Sequence[Any], counts: Counter[str]
                ) -> list[Any]:
    """The results of an elementary function, or of the errors of one."""
    arguments = [[y] for y in x]
    if of in ERRORS:
        true = _FUNCTIONS[of.name.removesuffix("_error")]
        arguments += [[y] for y in _elementary(true, precision, x, Counter())]
    if of.near and of.far and of.limit:
        reduce = of.near if abs(x[0]) <= of.limit(precision) else of.far
        reduced = _run(reduce(precision), precision, [arguments[0]], counts)
        arguments[:1] = [[y] for y in reduced]
    return _run(of.kernel(precision), precision, arguments, counts)
