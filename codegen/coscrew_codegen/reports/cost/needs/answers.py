"""Names the cheapest tier and precision that meets a request, on this machine and on a Cortex-M4F,
and how sure that is."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from coscrew_codegen.reports.cost.error_states import Box
from coscrew_codegen.reports.cost.function_errors import FunctionErrors
from coscrew_codegen.reports.cost.loops import CompiledLoops
from coscrew_codegen.reports.cost.measured import CERTIFIED, TierChoice, choices
from coscrew_codegen.reports.cost.needs import cortex_m4
from coscrew_codegen.reports.cost.needs.m4_functions import FunctionOnM4
from coscrew_codegen.reports.cost.needs.need import Need
from coscrew_codegen.reports.cost.needs.proved import proved

SEARCHED, BOUNDED, PROVED = range(3)
"""How sure it is that a choice meets a request: no state that was tried exceeds it; it returns a
bound at every state, which exceeds it at none that was tried; proved for all states."""
SURENESS = ("search", "bound", "proof")
_NEAR = 1.5  # counted are all choices whose estimates are at most this many times the least


@dataclass(frozen=True)
class Sufficient:
    """A choice that meets the requests: how sure that is, the largest errors or bounds by unit, and
    the instructions of a call on a Cortex-M4F."""

    row: FunctionErrors
    sureness: int
    errors: Mapping[str, float]
    instructions: int
    counted: bool = False  # else estimated


@dataclass(frozen=True)
class Answer:
    """The choices that meet a function's requests."""

    function: str
    needs: tuple[Need, ...]
    units: tuple[str, ...]
    candidates: tuple[Sufficient, ...]
    uncounted: str = ""  # reason why instructions are estimated

    @property
    def here(self) -> tuple[Sufficient, ...]:
        """The fastest on this machine in the scene's precisions, then the fastest that are surer.
        """
        return _surer([x for x in self.candidates if x.row.emitted], lambda x: x.row.time.median)

    @property
    def on_cortex_m4(self) -> tuple[Sufficient, ...]:
        """The choice of the fewest instructions on a Cortex-M4F, then those that are surer."""
        return _surer(self.candidates, lambda x: x.instructions)


def answer(needs: Sequence[Need], rows: Sequence[FunctionErrors], built: CompiledLoops, box: Box
           ) -> Answer:
    """The answer to all requests of the function that was measured in these rows."""
    name = rows[0].function
    its = tuple(need for need in needs if need.function == name)
    measured = dict(zip(choices(built, name), rows, strict=True))
    on_m4, function = FunctionOnM4(built, name), built.part.functions.named(name)
    results = {}
    for choice, row in measured.items():
        if not all(_met(its, errors) for _, errors in _measured(row)):
            continue
        bounds = tuple(zip(proved(function, choice, box), function.units, strict=True))
        sure = {x.unit: max(b for b, unit in bounds if unit == x.unit) for x in row.errors}
        sureness, errors = next(x for x in ((PROVED, sure), *_measured(row)) if _met(its, x[1]))
        results[choice] = Sufficient(row, sureness, _concerned(its, errors),
                                    on_m4.estimated(choice))
    reply = Answer(name, its, tuple(x.unit for x in rows[0].errors), tuple(results.values()))
    if missing := cortex_m4.missing():
        return replace(reply, uncounted=f"without {' and '.join(missing)}")
    try:
        return replace(reply, candidates=tuple(_counted(results, on_m4)))
    except cortex_m4.CountError as error:
        return replace(reply, uncounted=f"since {error}")


def _measured(row: FunctionErrors) -> Iterator[tuple[int, Mapping[str, float]]]:
    if row.tier == CERTIFIED:
        yield BOUNDED, {x.unit: x.bounds.worst for x in row.errors if x.bounds}
    yield SEARCHED, {x.unit: x.worst for x in row.errors}


def _met(needs: Sequence[Need], errors: Mapping[str, float]) -> bool:
    return all(size <= need.within for need in needs
               for size in _concerned((need,), errors).values())


def _concerned(needs: Sequence[Need], errors: Mapping[str, float]) -> Mapping[str, float]:
    return {unit: size for unit, size in errors.items()
            if any(need.concerns(unit) for need in needs)}


def _counted(results: Mapping[TierChoice, Sufficient], on_m4: FunctionOnM4) -> Iterator[Sufficient]:
    """Counts the instructions of the choices that may be the cheapest of their sureness."""
    for choice, x in results.items():
        rivals = [y.instructions for y in results.values() if y.sureness >= x.sureness]
        if x.instructions > _NEAR * min(rivals):
            yield x
        else:
            count = on_m4.counted(choice, [*x.row.worst_at.values()])
            yield replace(x, instructions=count, counted=True)


def _surer(candidates: Sequence[Sufficient], cost: Callable[[Sufficient], float]
           ) -> tuple[Sufficient, ...]:
    """The cheapest, then the cheapest of those that are surer than all before."""
    results: list[Sufficient] = []
    for x in sorted(candidates, key=lambda x: (cost(x), -x.sureness)):
        if all(x.sureness > y.sureness for y in results):
            results.append(x)
    return tuple(results)
