"""Builds the table of a chunk's runs: a row for each member."""

from collections.abc import Mapping

import numpy as np
import pyarrow

from coscrew_codegen.scene.recorded_quantities import recorded
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.simulation.sweep.batch import Batch
from coscrew_codegen.simulation.sweep.specification import Specification

STATISTICS = ("final", "minimum", "maximum", "mean")
"""Statistics of each recorded column: at the end, over the samples, and over time."""
MEMBER, FAILED = "member", "failed"


def units(scene: Scene, record: tuple[str, ...]) -> Mapping[str, str]:
    """The recorded columns and their units."""
    kinds = [recorded(text, scene) for text in record]
    return {name: unit for x in kinds for name, unit in zip(x.names, x.units, strict=True)}


def table(scene: Scene, specification: Specification, members: range, values: np.ndarray,
          batch: Batch) -> pyarrow.Table:
    """Columns: member; varied quantities; failed (the cause, null if the run reached its end),
    failed.t, failed.joint; statistics, null if it failed; whole series if requested."""
    failed = np.zeros(len(members), bool)
    failed[list(batch.failed)] = True
    columns = [("member", "", pyarrow.array(np.arange(members.start, members.stop)))]
    columns += [(x.name, x.unit, pyarrow.array(np.ascontiguousarray(values[:, i])))
                for i, x in enumerate(specification.varied.columns)]
    columns += _failures(len(members), batch)
    for name, unit in units(scene, specification.conditions.record).items():
        result = statistics(batch.t, batch.recorded[name])
        columns += [(f"{name}.{word}", unit, pyarrow.array(result[word], mask=failed))
                    for word in STATISTICS]
        if specification.conditions.series:
            columns.append((name, unit, _series(batch.recorded[name])))
    return pyarrow.table([x for _, _, x in columns], pyarrow.schema([
        pyarrow.field(name, x.type, metadata={"unit": unit} if unit else None)
        for name, unit, x in columns]))


def statistics(t: np.ndarray, samples: np.ndarray) -> Mapping[str, np.ndarray]:
    """Returns statistics of samples at the times t, (n, members), in this order of additions, which
    every processor keeps: the mean is the integral by the trapezoidal rule, divided by the time."""
    total = np.zeros(samples.shape[1])
    with np.errstate(all="ignore"):
        for i, h in enumerate(np.diff(t)):
            total += h / 2 * (samples[i].astype(float) + samples[i + 1])
    return {"final": samples[-1], "minimum": samples.min(0), "maximum": samples.max(0),
            "mean": total / (t[-1] - t[0])}


def _failures(count: int, batch: Batch) -> list[tuple[str, str, pyarrow.Array]]:
    results = [batch.failed.get(k) for k in range(count)]
    return [(FAILED, "", pyarrow.array([x and x.cause for x in results], pyarrow.string())),
            (f"{FAILED}.t", "s", pyarrow.array([x and x.t for x in results], pyarrow.float64())),
            (f"{FAILED}.joint", "", pyarrow.array([x and x.joint for x in results],
                                                  pyarrow.string()))]


def _series(samples: np.ndarray) -> pyarrow.Array:
    """A list of the samples for each member; samples after its failure are not finite."""
    flat = pyarrow.array(np.ascontiguousarray(samples.T).ravel())
    return pyarrow.FixedSizeListArray.from_arrays(flat, len(samples))
