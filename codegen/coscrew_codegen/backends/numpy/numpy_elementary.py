"""The elementary functions in Python, on components: arrays or numbers."""

import textwrap
from collections.abc import Collection, Mapping
from typing import Any

from coscrew_codegen.backends.c.c_statements import WIDTH, listed
from coscrew_codegen.backends.c.tables import two_over_pi_table
from coscrew_codegen.backends.nesting import Nesting
from coscrew_codegen.backends.numpy import numpy_operations
from coscrew_codegen.backends.render import render
from coscrew_codegen.program import Constant, Op, Program, counts_in_words
from coscrew_codegen.program.elementary import ELEMENTARY, ERRORS, Elementary
from coscrew_codegen.program.values.formats import Precision


def module(precision: Precision, names: Collection[str], banner: str) -> str:
    """The module that holds the functions of these names."""
    wanted = [function for function in (*ELEMENTARY, *ERRORS) if function.name in names]
    programs = [p for function in wanted for p in _programs(function, precision).values()]
    used = {numpy_operations.NUMPY_NAMES[op] for p in programs for op in p.counts
            if op in numpy_operations.NUMPY_NAMES}
    used |= {"asarray", "errstate", precision.encoding, precision.numpy_type}
    angles = any(function.near for function in wanted)
    if angles:
        used |= {"absolute", "array", "int64", "where"}
    return render("python/_elementary.py", banner=banner, precision=precision,
                  two_over_pi=two_over_pi_table.holes(precision), angles=angles,
                  exact=numpy_operations.exactly_in(precision)[Op.PRODUCT_ERROR] if any(
                      Op.PRODUCT_ERROR in p.counts for p in programs) else "",
                  imports=listed("from numpy import (", sorted(used), ")"),
                  functions=[_function(x, precision) for x in wanted])


def _programs(function: Elementary, precision: Precision) -> Mapping[str, Program]:
    made = {"near": function.near, "far": function.far, "body": function.kernel}
    return {name: make(precision) for name, make in made.items() if make}


def _function(function: Elementary, precision: Precision) -> dict[str, Any]:
    programs = _programs(function, precision)
    kernel = programs["body"]
    holes: dict[str, Any] = {name: _body(program, precision) for name, program in programs.items()}
    if "near" in programs and function.limit:
        limit = function.limit(precision)
        holes["limit"] = precision.literal(Constant(limit, limit))
        outputs = [a.name for a in programs["near"].outputs]
        holes["reduced"] = ", ".join(outputs)
    words = f"{function.statement}.  {function.comment(precision)}  " \
            f"{counts_in_words(kernel).capitalize()}."
    return {"near": "", "name": function.name, **holes,
            "inputs": ", ".join(a.name for a in function.inputs),
            "taken": ", ".join(a.name for a in kernel.inputs),
            "docstring": "\n    ".join(textwrap.wrap(words, WIDTH - 8))}


def _body(program: Program, precision: Precision) -> str:
    text = Nesting(program, numpy_operations.language(precision.numpy_type, precision.literal),
                   lambda x: program.inputs[x.argument].name, WIDTH - 4,
                   named=lambda step: step.name == step.component)
    lines = [*text.lines, f"return {', '.join(text.results)}"]
    return "\n".join(f"    {row}" for line in lines for row in line.split("\n"))
