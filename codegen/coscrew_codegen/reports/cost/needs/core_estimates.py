"""Estimates the instructions of a call on each core, from the operations of the function's Program.

Operations of a kind take the same number of instructions, zeros apart: those of software's floating
point depend on the numbers, so that these are averages.  The numbers are fitted, the largest
relative error least, to counts for five robots (`python -m tests.benchmarks.core_counts`)."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import accumulate, pairwise

from coscrew_codegen.backends.fixed.c_integers import integer, narrows, wide_steps
from coscrew_codegen.program import Op, Program
from coscrew_codegen.program.fixed.fixed_program import Products
from coscrew_codegen.program.roundoff import CIRCULAR
from coscrew_codegen.program.scene_functions import FunctionProgram
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE, Precision
from coscrew_codegen.reports.cost.needs.operations_at import Row, counts_at

LEAST = 200
"""Fewest instructions that are estimated: below, the compiler's choice of registers decides."""
INSTRUCTIONS: Mapping[tuple[str, str], Mapping[str, float]] = {
    ("Cortex-M0+", "fixed, full"): {"input": 16.86, "narrowing": 36.14, "result": 3.457,
        "sine and cosine": 470.8, "wide shift": 6.075, "wide sum": 42.48},
    ("Cortex-M0+", "fixed, high"): {"call": 14.72, "high product": 36.99, "input": 8.977,
        "result": 3.006, "sine and cosine": 456.7},
    ("Cortex-M0+", "single"): {"product": 124.7, "product error": 982.6,
        "product with zero": 42.59, "quotient": 1333, "sum": 70.85, "sum with zero": 57.35},
    ("Cortex-M0+", "double"): {"product": 325.7, "product error": 2055, "quotient": 8928,
        "sum": 92.6, "sum with zero": 144.5},
    ("Cortex-M3", "fixed, full"): {"narrowing": 6.701, "result": 1.668, "shift": 1.817,
        "sine and cosine": 78.43, "wide sum": 8.319},
    ("Cortex-M3", "fixed, high"): {"high product": 7.513, "result": 2.227,
        "sine and cosine": 73.89},
    ("Cortex-M3", "single"): {"comparison": 41.58, "product": 35.66, "product error": 501.9,
        "product with zero": 37.79, "quotient": 320.9, "sum": 56.55},
    ("Cortex-M3", "double"): {"call": 146.1, "product": 83.7, "product error": 801.5,
        "quotient": 1831, "sum": 37.58, "sum with zero": 18},
    ("Cortex-M4F", "fixed, full"): {"result": 2.031, "shift": 1.63, "sine and cosine": 49.31,
        "wide product": 7.435, "wide sum": 0.5279},
    ("Cortex-M4F", "fixed, high"): {"input": 2.665, "result": 2.21, "shift": 1.265,
        "sine and cosine": 57.46, "sum": 2.507},
    ("Cortex-M4F", "single"): {"call": 43.08, "move": 1.065, "product": 1.004,
        "product error": 2.199, "product with zero": 2.303, "result": 1.559, "sum": 1.753},
    ("Cortex-M4F", "double"): {"comparison": 38.94, "product": 104.7, "product error": 848.9,
        "quotient": 1740, "sum": 17.71, "sum with zero": 26.45},
}
"""Instructions of an operation of each kind; those that are not named take none of their own."""


@dataclass(frozen=True)
class Operations:
    """The operations of a call by kind; `before` has those of a plain function in single precision
    that it calls."""

    format: str  # of its numbers
    counts: Mapping[str, int]
    before: Mapping[str, int] = field(default_factory=dict)

    def on(self, core: str) -> int | None:
        """The instructions on a core; None below LEAST."""
        total = round(instructions(INSTRUCTIONS, core, self))
        return total if total >= LEAST else None


def instructions(table: Mapping[tuple[str, str], Mapping[str, float]], core: str, x: Operations
                 ) -> float:
    """The sum over all operations by this table."""
    return sum(table.get((core, kind), {}).get(name, 0) * count
               for kind, counts in ((x.format, x.counts), (SINGLE.name, x.before))
               for name, count in counts.items())


def of_function(function: FunctionProgram, precision: Precision,
                given: Sequence[Row]) -> Operations:
    """The operations of a function of floating point at a state."""
    before, inputs = Counter[str](), list(given)
    if function.plain:  # computed first
        before, results = counts_at(function.plain, precision, given)
        sizes = accumulate((a.quantity.size for a in function.computed), initial=0)
        inputs += [results[first:end] for first, end in pairwise(sizes)]
    counts, _ = counts_at(function.program, precision, inputs)
    return Operations((DOUBLE if function.program.wide else precision).name, counts, before)


def of_fixed(program: Program, products: Products) -> Operations:
    """The operations of a function in fixed point; sine and cosine of an angle are one."""
    wide = wide_steps(program)
    counts = Counter(call=1, input=len(program.used_inputs()), result=len(program.results))
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
    return Operations(f"fixed, {products.value}", counts)
