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
    ("Cortex-M0+", "single"): {"call": 240, "comparison": 779.5, "input": 43.13, "product": 140.4,
        "product error": 1134, "product with zero": 105, "sum": 45.22},
    ("Cortex-M0+", "double"): {"call": 120.6, "product": 296.7, "product error": 1967,
        "quotient": 8846, "sum": 133.4, "sum with zero": 103.1},
    ("Cortex-M3", "fixed, full"): {"narrowing": 6.701, "result": 1.668, "shift": 1.817,
        "sine and cosine": 78.43, "wide sum": 8.319},
    ("Cortex-M3", "fixed, high"): {"high product": 7.513, "result": 2.227,
        "sine and cosine": 73.89},
    ("Cortex-M3", "single"): {"comparison": 272.1, "input": 50.37, "product": 56.72,
        "product error": 638.2, "product with zero": 18.5, "result": 70.95, "sum": 26.31},
    ("Cortex-M3", "double"): {"call": 208.6, "product": 54.59, "product error": 720.2,
        "quotient": 2279, "sum": 62.4, "sum with zero": 18.92},
    ("Cortex-M4F", "fixed, full"): {"result": 2.031, "shift": 1.63, "sine and cosine": 49.31,
        "wide product": 7.435, "wide sum": 0.5279},
    ("Cortex-M4F", "fixed, high"): {"input": 2.665, "result": 2.21, "shift": 1.265,
        "sine and cosine": 57.46, "sum": 2.507},
    ("Cortex-M4F", "single"): {"call": 39.32, "comparison": 8.625, "move": 0.2135,
        "product": 0.8449, "product with zero": 0.3324, "result": 2.181, "sum": 1.965,
        "sum with zero": 0.9737},
    ("Cortex-M4F", "double"): {"call": 148.6, "product": 59.96, "product error": 734.8,
        "quotient": 2284, "sum": 57.48, "sum with zero": 18.38},
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
