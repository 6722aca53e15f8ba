"""Workers: processes of this machine, or those of a Dask cluster; chunks in a moving window.

Chunks are submitted as others finish, so that neither the scheduler nor this process ever holds
more than a few, however many there are.  Dask repeats the chunks of workers that are killed."""

import logging
import os
import signal
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from multiprocessing import resource_tracker
from typing import TYPE_CHECKING

from coscrew_codegen.runtime.cache import standard
from coscrew_codegen.simulation.sweep import SweepError
from coscrew_codegen.simulation.sweep.chunk import Chunk, ChunkCall, Job

if TYPE_CHECKING:
    from distributed import Client, Future, Worker

_AHEAD = 3  # chunks in flight for each thread of the workers: one runs, others are ready
_ANY_PORT = {"dashboard_address": "127.0.0.1:0"}  # Dask serves its state; without it, at 8787
_PATIENCE = "10s"  # for a scheduler to answer


class SchedulerError(SweepError):
    """The scheduler cannot be reached, or is no longer there."""


def cores() -> int:
    """The number of cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


@contextmanager
def local(workers: int) -> Iterator["Client"]:
    """A client of so many processes of this machine, which leave Ctrl-C to this one."""
    from distributed import Client, LocalCluster

    with _starting():
        cluster = LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None,
                               scheduler_kwargs=_ANY_PORT, silence_logs=logging.CRITICAL)
    with cluster, Client(cluster) as client:
        client.register_plugin(_heedless())
        yield client


@contextmanager
def _starting() -> Iterator[None]:
    """Blocks SIGINT, here and in processes that start in the block, which would print tracebacks;
    it is delivered here on exit."""
    if not hasattr(signal, "pthread_sigmask"):  # Windows
        yield
        return
    resource_tracker.ensure_running()  # of multiprocessing, whose start unblocks signals
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _heedless() -> object:
    from distributed import WorkerPlugin

    class Heedless(WorkerPlugin):
        """Makes workers ignore Ctrl-C, which a terminal sends to all processes."""

        def setup(self, worker: "Worker") -> None:
            signal.signal(signal.SIGINT, signal.SIG_IGN)

    return Heedless()


@contextmanager
def remote(address: str) -> Iterator["Client"]:
    """A client of the scheduler at this address.  Raises SchedulerError if none answers."""
    from distributed import Client

    logging.getLogger("distributed.client").setLevel(logging.CRITICAL)  # the errors below say so
    try:
        client = Client(address, timeout=_PATIENCE)
    except (OSError, ValueError) as error:
        raise SchedulerError(f"--scheduler {address}: {error}") from None
    try:
        yield client
    finally:
        with suppress(RuntimeError):  # logs of timeouts if the scheduler is gone
            client.close()


def finished(client: "Client", job: Job, numbers: Iterable[int],
             ahead: Callable[[], int] | None = None) -> Iterator[tuple[int, Chunk]]:
    """(number, chunk) of all chunks with these numbers, in the order in which they finish.

    Raises SchedulerError if the scheduler is lost, SweepError for chunks that kill workers."""
    from distributed import CancelledError, KilledWorker, as_completed

    rest, flying, done = iter(numbers), dict["Future[Chunk]", int](), as_completed()
    ahead = ahead or (lambda: _AHEAD * max(1, sum(client.nthreads().values())))

    def fill() -> None:
        for number in _first(rest, ahead() - len(flying)):
            future = client.submit(*standard(ChunkCall(job, number)), pure=False,
                                   key=f"coscrew-{job.specification.sha256[:16]}-{number}")
            flying[future] = number
            done.add(future)

    try:
        fill()
        while flying:
            future = next(done)
            chunk = future.result()
            yield flying.pop(future), chunk
            fill()
    except KilledWorker as error:
        raise SweepError(f"workers die of a chunk of members: {error}") from None
    except ImportError as error:
        raise SweepError(f"a worker lacks what this command has: {error}; install the same "
                         "coscrew[sweep] on both") from None
    except (CancelledError, OSError) as error:
        raise SchedulerError("the scheduler is gone") from error
    finally:
        client.cancel(list(flying))


def _first(numbers: Iterator[int], count: int) -> Iterator[int]:
    for _ in range(count):
        if (number := next(numbers, None)) is None:
            return
        yield number
