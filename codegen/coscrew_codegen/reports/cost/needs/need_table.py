"""Shows which tier and precision suffices, as a table for the terminal and the page."""

from collections.abc import Iterator, Sequence

from coscrew_codegen.backends.html.pages import Table
from coscrew_codegen.program.values.digits import three_digits
from coscrew_codegen.reports.cost.needs.answers import BOUNDED, PROVED, SEARCHED, Answer, Sufficient
from coscrew_codegen.simulation.result_units import in_unit

_HEADERS = ("needed", "on", "cheapest", "a call takes", "how sure", "at most")
_SURE = {SEARCHED: "found by search", BOUNDED: "bound at states", PROVED: "proved over ranges"}
_M4 = "Cortex-M4F"
_LEGEND = ("Found by search: the worst of {} states. Bound at states: it returns a bound with each "
           "result, here the largest. Proved over ranges: at all states between the limits, with "
           "accelerations up to the largest velocity in 0.1 s. Below the cheapest choice stand the "
           "cheapest that are surer.")


def table(answers: Sequence[Answer]) -> Table:
    """The answers on this machine, then on a Cortex-M4F."""
    states = max((x.row.states for a in answers for x in a.candidates), default=0)
    why = "".join(f" Instructions are estimated from operations, {x}." for x in dict.fromkeys(
        x.uncounted for x in answers) if x)
    return Table(_HEADERS, tuple(row for x in answers for row in _rows(x)),
                 notes=(_LEGEND.format(states) + why,) if states else (), title="What suffices",
                 texts=3)


def _rows(answer: Answer) -> Iterator[tuple[str, ...]]:
    head = (f"{answer.function} within "
            f"{' and '.join(x.named(answer.units) for x in answer.needs)}")
    if not answer.candidates:
        yield head, "", "no tier and precision", "", "", ""
        return
    names = " or ".join(x.row.name for x in answer.candidates)
    rows = [(x, "this machine", f"{three_digits(x.row.time.median)} ns") for x in answer.here]
    rows += [(x, _M4, f"{'' if x.counted else 'about '}{x.instructions:,} instructions")
             for x in answer.on_cortex_m4]
    if not answer.here:
        yield head, "this machine", f"none of the scene's precision; {names} would", "", "", ""
    for n, (x, where, cost) in enumerate(rows):
        yield ("" if n or not answer.here else head, where, x.row.name, cost, _SURE[x.sureness],
               _worst(x))


def _worst(x: Sufficient) -> str:
    return " and ".join(in_unit(size, unit) for unit, size in x.errors.items() if size) or "0"
