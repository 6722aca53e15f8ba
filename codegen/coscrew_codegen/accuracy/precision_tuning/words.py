"""Sentences on a mixture: its certified bounds, their states, and its savings."""

from collections.abc import Sequence
from math import isfinite

from coscrew_codegen.accuracy.precision_tuning.choice import (
    DRAWN,
    SEARCHES,
    PrecisionChoice,
    operations,
)
from coscrew_codegen.accuracy.precision_tuning.error_search import CLIMBED
from coscrew_codegen.accuracy.range_statements import domain
from coscrew_codegen.program.scene_functions import FunctionProgram
from coscrew_codegen.program.values.digits import two_digits_up


def in_words(choice: PrecisionChoice, function: FunctionProgram) -> str:
    """Describes the mixture for the comment of the function."""
    plain, mixture, pairs = _operations(choice, function)
    count = len(function.program.instructions)
    sure = (f"Certified at {2 * DRAWN:,} states drawn between the joints' limits and at the worst "
            f"that {SEARCHES} searches among {SEARCHES * CLIMBED:,} others found, not proved "
            "between them")
    if function.accuracy and function.accuracy.stated:
        sure = f"Proved for every {domain(function)}"
    return (f"{sure}: rounding moves {_moved(choice, function)}.  Of {count:,} instructions "
            f"{choice.paired:,} are in pairs ({100 * choice.paired / count:.0f} %).  A call takes "
            f"{mixture:,} operations, those of elementary functions included; all in single "
            f"precision {plain:,}, all in pairs {pairs:,}.")


def saving(choice: PrecisionChoice, function: FunctionProgram, units: Sequence[str]) -> str:
    """A line for the user who generates the function; `units` are those of the results' components.
    """
    plain, mixture, pairs = _operations(choice, function)
    moves = "is proved" if function.accuracy and function.accuracy.stated else "was found"
    return (f"{function.name}: a call takes {mixture:,} operations in the mixed tier, {plain:,} in "
            f"single precision, {pairs:,} in pairs; rounding {moves} to move "
            f"{_moved(choice, function, units)}")


def _moved(choice: PrecisionChoice, function: FunctionProgram, units: Sequence[str] = ()) -> str:
    assert function.accuracy
    tolerances, components = function.accuracy.tolerances, function.accuracy.components
    outputs = {name: [k for k, (x, _) in enumerate(components) if x == name]
               for name, _ in components}
    of = {name: " " + " or ".join(dict.fromkeys(units[k] for k in places)) if units else ""
          for name, places in outputs.items()}
    return "; ".join(f"{name} by at most {two_digits_up(max(choice.worst[k] for k in places))}"
                     f"{of[name]} (asked: {tolerances[places[0]]:g})".replace("e-0", "e-")
                     for name, places in outputs.items() if isfinite(tolerances[places[0]]))


def _operations(choice: PrecisionChoice, function: FunctionProgram) -> tuple[int, ...]:
    return tuple(map(operations, (function.program, choice.program, choice.pairs)))
