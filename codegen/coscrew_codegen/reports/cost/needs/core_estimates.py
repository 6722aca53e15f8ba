"""Estimates the instructions of a call on each core, from the operations of the function's Program.

Operations of a kind take the same number of instructions: those of software's floating point
depend on the numbers, so that these are averages.  The numbers are fitted, relative errors least,
to counts for a gimbal and a UR5 (`python -m tests.benchmarks.core_counts`)."""

from collections import Counter
from collections.abc import Callable, Mapping

from coscrew_codegen.backends.fixed.c_integers import integer, narrows, wide_steps
from coscrew_codegen.program import Op, Program
from coscrew_codegen.program.fixed.fixed_program import Products
from coscrew_codegen.program.roundoff import CIRCULAR
from coscrew_codegen.program.scene_functions import FunctionProgram
from coscrew_codegen.program.values.formats import DOUBLE, Precision
from coscrew_codegen.program.whole_cost import whole_counts

KINDS = {
    **dict.fromkeys((Op.ADD, Op.SUB, Op.EXACT_ADD, Op.EXACT_SUB), "sum"),
    **dict.fromkeys((Op.MUL, Op.SCALE), "product"),
    **dict.fromkeys((Op.DIV, Op.SQRT), "quotient"),
    **dict.fromkeys((Op.LESS, Op.EQUAL), "comparison"),
    **dict.fromkeys((Op.PRODUCT_ERROR, Op.PRODUCT_REST), "product error")}
"""Kinds of operations of floating point; all others are moves."""
INSTRUCTIONS: Mapping[tuple[str, str], Mapping[str, float]] = {
    ("Cortex-M0+", "single"): {"comparison": 37.38, "memory": 18.98, "product": 157.5,
        "product error": 1239, "sum": 28.32},
    ("Cortex-M0+", "double"): {"product": 356.4, "product error": 2388, "sum": 67.75},
    ("Cortex-M0+", "fixed, full"): {"memory": 53.84, "sine and cosine": 131.3,
        "wide product": 29.21, "wide sum": 41.69},
    ("Cortex-M0+", "fixed, high"): {"high product": 37.98, "memory": 5.732, "sine and cosine": 407,
        "sum": 0.5368},
    ("Cortex-M3", "single"): {"memory": 11.24, "product": 55.38, "product error": 642.7,
        "sum": 27.62},
    ("Cortex-M3", "double"): {"product": 84.62, "product error": 841.4, "sum": 33.56},
    ("Cortex-M3", "fixed, full"): {"memory": 12.92, "wide product": 6.043, "wide shift": 0.5063,
        "wide sum": 6.47},
    ("Cortex-M3", "fixed, high"): {"high product": 7.904, "memory": 11.59},
    ("Cortex-M4F", "single"): {"memory": 0.8583, "product": 1.374, "product error": 2.545,
        "sum": 1.475},
    ("Cortex-M4F", "double"): {"product": 84.96, "product error": 841.2, "sum": 33.25},
    ("Cortex-M4F", "fixed, full"): {"memory": 10.17, "shift": 1.446, "wide product": 7.041,
        "wide shift": 2.6},
    ("Cortex-M4F", "fixed, high"): {"high product": 3.682, "memory": 2.932, "shift": 1.378,
        "sine and cosine": 43.85},
}
"""Instructions of an operation of each kind; those that are not named take none of their own."""


def counts_in_floats(program: Program, precision: Precision) -> Counter[str]:
    """The operations of a Program by kind, elementary functions included; and the numbers that it
    reads and writes."""
    counts: Counter[str] = Counter()
    for op, count in whole_counts(program, precision).items():
        counts[KINDS.get(op, "move")] += count
    counts["memory"] = len(program.used_inputs()) + len(program.results)
    return counts


def counts_in_integers(program: Program) -> Counter[str]:
    """Counts operations on integers by kind; sine and cosine of an angle are one operation."""
    wide = wide_steps(program)
    counts: Counter[str] = Counter()
    angles = set()
    for step in program.instructions:
        if step.op in CIRCULAR:
            angles.add(step.operands[0])
        elif step.op is Op.WIDE_PRODUCT:
            counts["wide product"] += 1
            counts["wide shift"] += integer(step.operands[2]) != 0
        elif step.op is Op.ROUNDED_SHIFT:
            counts["narrowing" if narrows(step, wide) else "shift"] += 1
        elif step.op is Op.HIGH_PRODUCT:
            counts["high product"] += 1
        else:
            counts["wide sum" if step.name in wide else "sum"] += 1
    counts["sine and cosine"] = len(angles)
    counts["memory"] = len(program.used_inputs()) + len(program.results)
    return counts


def of_function(function: FunctionProgram, precision: Precision) -> Callable[[str], int]:
    """The instructions of a function of floating point, by core."""
    def estimate(core: str) -> int:
        working = DOUBLE if function.program.wide else precision
        total = _total(core, working.name, counts_in_floats(function.program, precision))
        if function.plain:  # computed first
            total += _total(core, precision.name, counts_in_floats(function.plain, precision))
        return round(total)

    return estimate


def of_fixed(program: Program, products: Products) -> Callable[[str], int]:
    """The instructions of a function in fixed point, by core."""
    return lambda core: round(_total(core, f"fixed, {products.value}", counts_in_integers(program)))


def _total(core: str, kind: str, counts: Mapping[str, int]) -> float:
    return sum(INSTRUCTIONS[core, kind].get(x, 0) * count for x, count in counts.items())
