"""Writes a scene's costs as JSON; docs/accuracy.md lists the fields."""

import json
from collections.abc import Sequence
from pathlib import Path

from coscrew_codegen.backends import version
from coscrew_codegen.program.values.json_values import Json, finite
from coscrew_codegen.reports.cost.cost_measurement import Costs
from coscrew_codegen.reports.cost.function_errors import Bounds, ErrorStatistics, FunctionErrors
from coscrew_codegen.reports.cost.measured import DIGITS
from coscrew_codegen.reports.cost.needs.answers import SURENESS, Answer, Sufficient
from coscrew_codegen.reports.cost.recommendations import recommended, sentences, undominated
from coscrew_codegen.reports.cost.run_errors import DIGITS as RUN_DIGITS
from coscrew_codegen.reports.cost.run_errors import RunErrors
from coscrew_codegen.reports.processor import processor, system
from coscrew_codegen.reports.timing.intervals import Interval
from coscrew_codegen.simulation.recordings.recording_writer import delivered

SCHEMA = 1


def write(costs: Costs, path: Path, command: str) -> None:
    """Writes the JSON, in which numbers that are not finite are null.  Raises SimulateError."""
    with delivered(path) as temporary:
        temporary.write_text(json.dumps(
            finite(data(costs, command), lambda x: None), ensure_ascii=False, allow_nan=False,
            indent=1) + "\n", encoding="utf-8")


def data(costs: Costs, command: str) -> dict[str, Json]:
    """All figures; times are in ns per call, those of runs in s."""
    truth = costs.reference
    return {
        "schema": SCHEMA, "scene": costs.scene, "command": command,
        "version": version.described(), "cpu": processor(),
        "system": system(), "compiler": costs.compiler,
        "reference_digits": DIGITS,
        "functions": [_function(rows) for rows in costs.accuracy],
        "needs": [_need(x) for x in costs.answers],
        "fixed_point": [{"function": x.function, "format": x.format, "bounds": x.bounds,
                         "found": dict(x.worst), "instructions": x.instructions,
                         "counted": x.counted,
                         "time": _time(x.time) if x.time else None} for x in costs.cores],
        "load": None if costs.load is None else {
            "share": costs.load.share, "tasks": costs.load.tasks,
            "processors": costs.load.processors},
        "operations": [{
            "part": x.part, "function": x.function, "flops": x.flops, "operations": x.words,
            "double": _time(x.times[0]), "single": _time(x.times[1])} for x in costs.rows],
        "run_reference": {"method": truth.words, "t": truth.t, "error": truth.error}
        if truth else None,
        "runs": [{
            "integrator": x.integrator, "precision": x.precision, "step": x.step, "steps": x.steps,
            "language": x.by, "time": _time(x.time), "error": x.error,
            "error_known": costs.known(x), "best": costs.best(x)} for x in costs.points],
        "run_errors": _run_errors(costs.run_errors)}


def _function(rows: Sequence[FunctionErrors]) -> dict[str, Json]:
    choice, undefeated = recommended(rows), undominated(rows)
    return {
        "function": choice.function, "states": choice.states,
        "recommended": {"tier": choice.tier, "precision": choice.precision},
        "sentences": sentences(rows),
        "choices": [{
            "tier": x.tier, "precision": x.precision, "time": _time(x.time),
            "emitted": x.emitted, "best": x in undefeated, "errors": [_errors(e) for e in x.errors],
            "worst_at": x.worst_at} for x in rows]}


def _need(x: Answer) -> dict[str, Json]:
    def listed(candidates: Sequence[Sufficient]) -> list[dict[str, Json]]:
        return [{"tier": c.row.tier, "precision": c.row.precision, "sureness": SURENESS[c.sureness],
                 "worst": c.errors, "ns": c.row.time.median, "instructions": c.instructions,
                 "counted": c.counted} for c in candidates]

    return {"function": x.function, "within": [{"number": need.within, "unit": need.unit or None}
                                               for need in x.needs],
            "here": listed(x.here), "cortex_m4": listed(x.on_cortex_m4)}


def _errors(x: ErrorStatistics) -> dict[str, Json]:
    return {
        "unit": x.unit, "typical": x.typical, "worst": x.worst,
        "typical_digits": x.typical_digits, "worst_digits": x.worst_digits,
        "largest_result": x.largest, "found_in": x.place, "bound": _bounds(x.bounds),
        **({} if x.proved is None else {"proved": x.proved})}


def _bounds(x: Bounds | None) -> dict[str, Json] | None:
    return None if x is None else {
        "worst": x.worst, "least_ratio": x.least_ratio, "typical_ratio": x.typical_ratio,
        "worst_ratio": x.worst_ratio}


def _run_errors(x: RunErrors | None) -> dict[str, Json] | None:
    return None if x is None else {
        "integrator": x.integrator, "step": x.step, "until": x.until, "times": x.times,
        "reference_digits": RUN_DIGITS,
        "whole": x.whole, "rows": [{"cause": row.cause, "of": row.of, "errors": row.errors,
                                     "gone": row.gone} for row in x.rows]}


def _time(x: Interval) -> dict[str, Json]:
    return {"median": x.median, "low": x.low, "high": x.high}
