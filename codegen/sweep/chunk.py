"""From the number of a chunk to its Parquet file: what workers do."""

import functools
import json
import pickle
from collections.abc import Mapping
from dataclasses import dataclass
from importlib.metadata import version

import numpy as np
import pyarrow
import pyarrow.parquet

from coscrew_codegen.native import cache
from coscrew_codegen.simulate.load import Kernels
from coscrew_codegen.simulate.system import scene_of, system
from coscrew_codegen.sweep import SweepError
from coscrew_codegen.sweep.lock import held
from coscrew_codegen.sweep.specification import Specification

_COMPILING = ".sweep-compiles"  # in the cache: workers of a machine compile one after the other
_PAYS = 1_000_000  # states, for which the functions of many states are compiled at once


@dataclass(frozen=True)
class Job:
    """What a worker needs: the scene's kernels, pickled, which it compiles or finds in its cache.
    """

    kernels: bytes
    specification: Specification
    generator: str  # the hash of the sources that must run it

    @classmethod
    def of(cls, kernels: Kernels, specification: Specification) -> "Job":
        """The job of a sweep, for workers with these sources."""
        return cls(pickle.dumps(kernels), specification, cache.generator())


@dataclass(frozen=True)
class Chunk:
    """A chunk's file, and how many of its members failed."""

    content: bytes
    members: int
    failed: int


def computed(job: Job, number: int) -> Chunk:
    """The chunk of this number: the same numbers wherever this runs.

    Raises SweepError if the worker has other sources than the command."""
    from coscrew_codegen.sweep import batch, members, summary

    if cache.generator() != job.generator:
        raise SweepError("a worker has another version of coscrew than this command; install the "
                         "same on both")
    its, kernels = job.specification, _loaded(job)
    rows = its.members(number)
    values = members.values(its.varied, rows)
    found = batch.run(kernels, its.conditions, **states(kernels, its, values))
    table = summary.table(scene_of(kernels), its, rows, values, found)
    told = json.dumps(provenance(kernels, its), ensure_ascii=False)
    return Chunk(_parquet(table.replace_schema_metadata({"coscrew": told})), len(rows),
                 len(found.failed))


def _loaded(job: Job) -> Kernels:
    """The kernels; compiled, also for many states at once if that pays, by one worker of a machine.
    """
    its = job.specification
    with held(cache.folder() / _COMPILING, wait=True):
        kernels: Kernels = pickle.loads(job.kernels)
        if its.varied.members * its.conditions.until / its.conditions.step >= _PAYS:
            kernels._lanes.function("", _PAYS)
    return kernels


def states(kernels: Kernels, its: Specification, values: np.ndarray) -> Mapping[str, np.ndarray]:
    """The members' parameters and starts, a row each."""
    plain = system(kernels, its.conditions.precision, dict(its.conditions.settings))
    q, v = plain.start()
    arrays = {name: np.tile(np.asarray(row, float), (len(values), 1))
              for name, row in (("p", plain.p), ("q", q), ("v", v))}
    for column, x in zip(values.T, its.varied.columns, strict=True):
        arrays[x.array][:, x.index] = column
    return arrays


def provenance(kernels: Kernels, its: Specification) -> Mapping[str, str]:
    """Where a chunk's numbers come from."""
    return {"scene": its.scene, "scene sha256": its.scene_sha256, "sweep sha256": its.sha256,
            "compiler": kernels.compiler or "none: NumPy", **_versions()}


@functools.cache
def _versions() -> Mapping[str, str]:
    return {name: version(name) for name in ("coscrew", "numpy", "scipy", "pyarrow")}


def _parquet(table: pyarrow.Table) -> bytes:
    sink = pyarrow.BufferOutputStream()
    pyarrow.parquet.write_table(table, sink, compression="zstd")
    return bytes(sink.getvalue())
