"""Computes a chunk in a worker: from its number to its Parquet file."""

import functools
import json
import platform
import warnings
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib.metadata import version

import numpy as np

from coscrew_codegen.runtime import cache, sources
from coscrew_codegen.runtime.cache import packed, unpacked
from coscrew_codegen.runtime.lanes import PAYS
from coscrew_codegen.runtime.load import Kernels, restored
from coscrew_codegen.simulation.check.uniform_rotations import quaternions
from coscrew_codegen.simulation.sweep import SweepError
from coscrew_codegen.simulation.sweep.files.lock import held
from coscrew_codegen.simulation.sweep.files.part import sealed
from coscrew_codegen.simulation.sweep.specification import Specification
from coscrew_codegen.simulation.system import scene_of, system

_COMPILING = ".sweep-compiles"  # in the cache: workers of a machine compile one after the other


@dataclass(frozen=True)
class Job:
    """Data that a worker needs: the scene's kernels, pickled, which it compiles or finds in its
    cache."""

    kernels: bytes
    compiled: bool  # whether they are in C; if so, the worker's must be, too
    specification: Specification
    generator: str  # the hash of the sources that must run it

    @classmethod
    def of(cls, kernels: Kernels, specification: Specification) -> "Job":
        """The job of a sweep, for workers with these sources."""
        return cls(packed(kernels), kernels.compiled, specification, sources.generator())


@dataclass(frozen=True)
class ChunkCall:
    """Pickled call of `computed`, unpickled and made in the task.  So a worker without coscrew
    fails in the task, and not while it receives it, which would end the worker."""

    job: Job
    number: int

    def __reduce__(self) -> "tuple[Callable[[Job, int], Chunk], tuple[Job, int]]":
        return computed, (self.job, self.number)


@dataclass(frozen=True)
class Chunk:
    """A chunk's file, and how many of its members failed."""

    content: bytes
    members: int
    failed: int


def computed(job: Job, number: int) -> Chunk:
    """The chunk of this number: the same numbers wherever this runs.

    Raises SweepError if the worker has other sources than the command, cannot compile the scene
    although the command could, or has no disk or memory left."""
    worker = f"the worker on {platform.node()}"
    if sources.generator() != job.generator:
        raise SweepError(f"{worker} has another version of coscrew than this command; install the "
                         "same on both")
    try:
        return _computed(job, number)
    except _Uncompiled as error:
        raise SweepError(f"{worker} cannot compile the scene, as this command can: {error}"
                         ) from None
    except OSError as error:
        where = f" {error.filename}" if error.filename else ""
        raise SweepError(f"{worker} cannot use its disk:{where} {error.strerror or error}"
                         ) from None
    except MemoryError:
        raise SweepError(f"{worker} has too little memory for a chunk of "
                         f"{job.specification.chunk} members") from None


class _Uncompiled(Exception):
    """The compiler is missing, or fails."""


def _computed(job: Job, number: int) -> Chunk:
    from coscrew_codegen.simulation.sweep import batch, member_summary, member_values

    its, kernels = job.specification, _loaded(job)
    rows = its.members(number)
    values = member_values.values(its.varied, rows)
    runs = batch.run(kernels, its.conditions, **states(kernels, its, values))
    table = member_summary.table(scene_of(kernels), its, rows, values, runs)
    origin = json.dumps(provenance(kernels, its), ensure_ascii=False)
    return Chunk(sealed(table.replace_schema_metadata({"coscrew": origin})), len(rows),
                 len(runs.failed))


def _loaded(job: Job) -> Kernels:
    """The kernels, compiled by one worker of each machine; for many states, too, if that is
    worthwhile."""
    its = job.specification
    with (held(cache.folder() / _COMPILING, wait=True),
          warnings.catch_warnings(record=True) as notes):
        warnings.simplefilter("always")
        kernels: Kernels = unpacked(job.kernels)
        if job.compiled and not kernels.compiled:
            restored.cache_clear()  # the next chunk tries again
            raise _Uncompiled(*(_reason(str(x.message)) for x in notes[-1:]))
        if its.varied.members * its.conditions.until / its.conditions.step >= PAYS:
            kernels._lanes.function("", PAYS)
    return kernels


def _reason(warning: str) -> str:
    """The first line of a compiler's output with an error, or else the message on the missing
    compiler."""
    first, *lines = warning.splitlines()
    return next((x for x in lines if "error" in x.lower()), first.partition(": ")[2])


def states(kernels: Kernels, its: Specification, values: np.ndarray) -> Mapping[str, np.ndarray]:
    """The members' parameters and starts, a row each."""
    plain = system(kernels, its.conditions.precision, dict(its.conditions.settings))
    q, v = plain.written_start()
    arrays = {name: np.tile(np.asarray(row, float), (len(values), 1))
              for name, row in (("p", plain.p), ("q", q), ("v", v))}
    u = np.zeros((len(values), len(plain.quaternions), 3))
    varied = arrays | {"u": u.reshape(len(values), -1)}
    for column, x in zip(values.T, its.varied.columns, strict=True):
        varied[x.array][:, x.index] = column
    for n in sorted({x.index // 3 for x in its.varied.columns if x.array == "u"}):
        arrays["q"][:, plain.quaternions[n]] = quaternions(u[:, n])
    arrays["q"] = plain.with_rotors(arrays["q"], arrays["v"])
    return arrays


def provenance(kernels: Kernels, its: Specification) -> Mapping[str, str]:
    """Returns the origin of a chunk's numbers."""
    return {"scene": its.scene, "scene sha256": its.scene_sha256, "sweep sha256": its.sha256,
            "compiler": kernels.compiler or "none: NumPy", **_versions()}


@functools.cache
def _versions() -> Mapping[str, str]:
    return {name: version(name) for name in ("coscrew", "numpy", "scipy", "pyarrow")}

