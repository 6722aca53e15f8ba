"""Calls of compiled functions on arrays, which C reads where they stand if it can; also of many
steps of an integrator at once: of one state or many, also under a controller."""

import ctypes
import operator
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import prod
from types import ModuleType
from typing import TYPE_CHECKING, Protocol, TypeGuard

import numpy as np
from numpy.typing import ArrayLike

from coscrew_codegen.program.scene_functions import Signature
from coscrew_codegen.runtime.caller_warnings import at_callers_line

if TYPE_CHECKING:
    from _ctypes import CFuncPtr

    from coscrew_codegen.runtime.load import Kernels


@dataclass(frozen=True)
class Rows:
    """Rows of numbers in memory."""

    array: np.ndarray
    step: int  # numbers from one row to the next


@dataclass(frozen=True)
class CompiledFunction:
    """A function of a library; `signs` are those of the numbers of p."""

    described: Signature
    kind: np.dtype
    in_c: Callable[..., object]  # declines, by NotImplemented, what it cannot take
    loop: Callable[..., None]  # of n states, wherever they stand
    checks: ModuleType
    signs: tuple[tuple[int, str, bool], ...]

    def __call__(self, arguments: Mapping[str, ArrayLike], out: object, threads: object,
                 prepare: Callable[[int], None]) -> object:
        """The results.  `prepare` is told the number of states if there are leading axes, and room
        for their results."""
        described, count = self.described, positive(threads)
        lead, arrays = self.checks.arrays(self.kind, **{
            x: (arguments[x], shape, *([self.signs] if x == "p" else []))
            for x, shape in described.inputs})
        shapes = [(*lead, *shape) for _, shape in described.outputs]
        if lead and out is None:
            _refuse_vast(shapes, self.kind)
            prepare(prod(lead))
        if not lead or out is None:
            outputs = self.in_c(*arrays, threads=count)
            if outputs is not NotImplemented:
                results = outputs if isinstance(outputs, tuple) else (outputs,)
                return self.checks.delivered(out, *results)
        given = dict(zip(arguments, arrays, strict=True))
        places = [x if x is not None and self._is_place(x, len(lead), arrays)
                   else np.empty(shape, self.kind)
                   for x, shape in zip(self.checks.places(out, shapes, self.kind), shapes,
                                       strict=True)]
        if lead and out is not None:
            prepare(prod(lead))
        if described.moved:
            for (x, _), result in zip(described.outputs, places, strict=True):
                result[...] = given[x]
        self._run([_rows(given[x], lead, len(shape)) for x, shape in described.inputs],
                  [Rows(x, _step(x, len(lead)) or 0) for x in places], prod(lead), count)
        return self.checks.delivered(out, *(x[()] for x in places))

    def _is_place(self, x: np.ndarray, lead: int, arrays: Sequence[np.ndarray]) -> bool:
        """Returns whether C may write to `x` while it reads the arrays."""
        step = _step(x, lead) if x.dtype == self.kind else None
        return (step is not None and (x.flags.c_contiguous or step >= prod(x.shape[lead:]))
                and not any(np.may_share_memory(x, array) for array in arrays))

    def _run(self, inputs: Sequence[Rows], outputs: Sequence[Rows], n: int, threads: int) -> None:
        taken = [x for rows in (inputs, outputs) for x in (
            (ctypes.c_void_p * len(rows))(*(x.array.ctypes.data for x in rows)),
            (ctypes.c_ssize_t * len(rows))(*(x.step for x in rows)))]
        self.loop(n, *taken, min(threads, n))


def _refuse_vast(shapes: Sequence[tuple[int, ...]], kind: np.dtype) -> None:
    """Raises MemoryError if there is no room for arrays of these shapes."""
    _ = [np.empty(shape, kind) for shape in shapes]


def positive(threads: object) -> int:
    """The number of threads.  Raises TypeError, ValueError."""
    message = f"threads: got {threads!r}; wanted a positive integer"
    try:
        count = operator.index(threads)  # type: ignore[arg-type]
    except TypeError:
        raise TypeError(message) from None
    if isinstance(threads, bool):
        raise TypeError(message)
    if count < 1:
        raise ValueError(message)
    return count


def _rows(array: np.ndarray, lead: tuple[int, ...], axes: int) -> Rows:
    """Rows of these leading axes: where they stand, or copied if C cannot read them there."""
    if array.ndim == axes:
        return Rows(np.require(array, None, ("C", "A")), 0)
    step = _step(array, len(lead)) if array.ndim == axes + len(lead) else None
    if step is not None and array.shape[:len(lead)] == lead:
        return Rows(array, step)
    array = np.broadcast_to(array, (*lead, *array.shape[array.ndim - axes:]))
    step = _step(array, len(lead))
    return Rows(array, step) if step is not None else Rows(
        np.require(array, None, ("C", "A")), prod(array.shape[len(lead):]))


def _step(array: np.ndarray, lead: int) -> int | None:
    """Returns how many numbers apart the rows of an array are; None if C cannot read them."""
    size, each = prod(array.shape[lead:]), array.itemsize
    if array.flags.c_contiguous and array.flags.aligned:
        return size
    inner = np.empty((0, *array.shape[lead:]), array.dtype).strides[1:]
    regular = lead == 1 and array.strides[1:] == inner and array.flags.aligned
    return array.strides[0] // each if regular and not array.strides[0] % each else None


class Owner(Protocol):
    """Owner of a step: functions of kernels, which know their lanes."""

    @property
    def _kernels(self) -> "Kernels | None": ...


@dataclass(frozen=True)
class InC:
    """A controller in C, and when it is called: before a step, after the first `wait` steps and
    then after every `every`.  `places` are the indices in p of what it sets."""

    law: int  # an address
    context: int | ctypes.c_void_p | None
    every: int
    places: np.ndarray
    wait: int


@dataclass(frozen=True)
class RefusedStep:
    """The first value of a member that is not finite: its number among those that are set."""

    member: int
    number: int
    t: float
    value: float


Take = tuple[int, float, float]
"""n steps from t on of h."""
Driven = tuple[np.ndarray, np.ndarray, np.ndarray, tuple[RefusedStep, ...]]
"""p, q, v and what was refused."""


class _Controller(ctypes.Structure):
    _fields_ = (("law", ctypes.c_void_p), ("context", ctypes.c_void_p),
                ("every", ctypes.c_ssize_t), ("count", ctypes.c_ssize_t),
                ("places", ctypes.c_void_p))


MOST = 256  # threads, as in runtime/calls/threads.h
_REFUSED = np.dtype([("number", np.intp), ("t", float), ("value", float)], align=True)


@dataclass(frozen=True)
class StepCalls:
    """The functions in C of one integrator's steps; `several` is the name of that in lanes."""

    described: Signature
    kind: np.dtype
    run: "CFuncPtr"
    finer: "CFuncPtr | None"  # where steps may be split into parts
    drive: "CFuncPtr | None"  # where there are parameters that a controller could set
    several: str
    checks: ModuleType
    signs: tuple[tuple[int, str, bool], ...]

    def repeated(self, of: Owner, n: int, t: float, h: float, p: ArrayLike, q: ArrayLike,
                 v: ArrayLike, threads: int) -> tuple[np.ndarray, np.ndarray]:
        """q and v after n steps; leading axes of p, q and v are states."""
        if n > 0 and type(threads) is int and threads == 1 and self._ready(one := (p, q, v)):
            return self._of_one(n, t, h, *one)
        given = {"p": p, "q": q, "v": v}
        self.checks.arrays(self.kind, **{
            x: (given[x], shape, *([self.signs] if x == "p" else []))
            for x, shape in self.described.inputs if x in given})
        if operator.index(n) < 0:
            raise ValueError(f"n: got {n}; wanted a number of steps, not negative")
        count = positive(threads)
        p, q, v = (np.array(x, self.kind, order="C", ndmin=1) for x in (p, q, v))
        lead = np.broadcast_shapes(*(x.shape[:-1] for x in (p, q, v)))
        q, v = _over_all(q, lead), _over_all(v, lead)
        p = _over_all(p, lead) if p.ndim > 1 else p
        starts = {"p": p, "q": q, "v": v}
        strides = {x: a.shape[-1] if a.ndim > 1 else 0 for x, a in starts.items()}
        states = prod(lead)
        lanes = self._lanes(of, states * n) if lead else None

        def work(first: int, states: int) -> None:
            at = {x: a.ctypes.data + first * strides[x] * self.kind.itemsize
                  for x, a in starts.items()}
            if lanes:
                lanes(*self._of_lanes(states, n, t, h, at, strides))
            else:
                for k in range(states):
                    self.run(n, t, h, *(at[x] + k * strides[x] * self.kind.itemsize for x in at))

        _shared(work, states, count)
        return q, v

    @cached_property
    def _shapes(self) -> tuple[tuple[int, ...], ...]:
        """The shapes of p, q and v of one state."""
        return tuple(dict(self.described.inputs).get(x, (0,)) for x in "pqv")

    def _ready(self, given: tuple[ArrayLike, ...]
               ) -> TypeGuard[tuple[np.ndarray, np.ndarray, np.ndarray]]:
        """Returns whether p, q and v are right and of one state, and none of them has to be
        converted."""
        for x, shape in zip(given, self._shapes, strict=True):
            if type(x) is not np.ndarray or x.dtype != self.kind or x.shape != shape:
                return False
        p = np.asarray(given[0])
        return not any(p[at] < 0 if zero else p[at] <= 0 for at, _, zero in self.signs)

    def _of_one(self, n: int, t: float, h: float, p: np.ndarray, q: np.ndarray, v: np.ndarray
                ) -> tuple[np.ndarray, np.ndarray]:
        """q and v after n steps of one state: in a quarter of the time that arrays of any type and
        shape take, which counts in runs with a call per sample."""
        p, q, v = (x.copy() for x in (p, q, v))
        self.run(n, t, h, p.ctypes.data, q.ctypes.data, v.ctypes.data)
        return q, v

    def sampled(self, takes: Sequence[Take], p: np.ndarray, q: np.ndarray, v: np.ndarray,
                finer: int = 1) -> tuple[np.ndarray, np.ndarray]:
        """q and v of one state after each of consecutive steps: (…, nq), (…, nv).  Each step is
        split as one longer by the factor `finer` would be."""
        p, q, v = (np.array(x, self.kind, order="C") for x in (p, q, v))
        at, run = tuple(x.ctypes.data for x in (p, q, v)), self.run
        if finer > 1:
            assert self.finer
            at, run = (*at, finer), self.finer
        all_q, all_v = (np.empty((len(takes), *x.shape), self.kind) for x in (q, v))
        for k, take in enumerate(takes):
            run(*take, *at)
            all_q[k], all_v[k] = q, v
        return all_q, all_v

    def driven(self, of: Owner, by: InC, n: int, t: float, h: float, p: np.ndarray, q: np.ndarray,
               v: np.ndarray) -> Driven:
        """p, q and v after n steps under a controller, and what it must not have returned.
        (…, np), (…, nq), (…, nv), all with the same leading axes."""
        assert self.drive
        p, q, v = (np.array(x, self.kind, order="C") for x in (p, q, v))
        states = prod(q.shape[:-1])
        refused = np.zeros(states, _REFUSED)
        refused["number"] = -1
        lanes = self._lanes(of, states * n) if q.ndim > 1 else None
        places = np.ascontiguousarray(by.places, np.intp)
        controller = _Controller(by.law, by.context, by.every, len(places), places.ctypes.data)
        self.drive(ctypes.byref(controller), self.run, lanes, states, n, by.wait, t, h,
                   *(x.ctypes.data for x in (p, q, v)), refused.ctypes.data)
        refused_steps = tuple(RefusedStep(int(k), *refused[k].item())
                              for k in np.flatnonzero(refused["number"] >= 0))
        return p, q, v, refused_steps

    def _lanes(self, of: Owner, states: int) -> "CFuncPtr | None":
        if not of._kernels:
            return None
        with at_callers_line(above=2):  # the methods here and of the callable
            return of._kernels._lanes.function(self.several, states)

    def _of_lanes(self, states: int, n: int, t: float, h: float, at: Mapping[str, int],
                  strides: Mapping[str, int]) -> tuple[object, ...]:
        """The arguments of the function in lanes."""
        names = [x for x, _ in self.described.inputs]
        return (*map(ctypes.c_ssize_t, (states, n)),
                *(ctypes.c_double(x) for name, x in (("t", t), ("h", h)) if name in names),
                *(ctypes.c_ssize_t(x) for name in names if name in at
                  for x in (at[name], strides[name])))


def steps(library: ctypes.CDLL, name: str, several: str, described: Signature, kind: np.dtype,
          checks: ModuleType, signs: tuple[tuple[int, str, bool], ...],
          precision: str) -> StepCalls:
    """The steps of this name in C, in a library whose functions run without Python's global lock.
    """
    run, drive = getattr(library, f"run_{name}"), getattr(library, f"drive_{precision}", None)
    finer = getattr(library, f"finer_{name}", None)
    size, real, address = ctypes.c_ssize_t, ctypes.c_double, ctypes.c_void_p
    run.restype, run.argtypes = None, [size, real, real, *[address] * 3]
    if finer:
        finer.restype, finer.argtypes = None, [*run.argtypes, size]
    if drive:
        drive.restype = None
        drive.argtypes = [*[address] * 3, *[size] * 3, real, real, *[address] * 4]
    return StepCalls(described, kind, run, finer, drive, several, checks, signs)


def _over_all(rows: np.ndarray, lead: tuple[int, ...]) -> np.ndarray:
    """A row for every state, each of its own."""
    return np.array(np.broadcast_to(rows, (*lead, rows.shape[-1])), order="C")


def _shared(work: Callable[[int, int], None], states: int, threads: int) -> None:
    """work(first, number) on all states, shared among threads."""
    threads = min(threads, states, MOST)
    if threads < 2:
        work(0, states)
        return
    from concurrent.futures import ThreadPoolExecutor  # slow, and seldom needed

    each = -(-states // threads)
    with ThreadPoolExecutor(threads) as pool:
        for done in [pool.submit(work, first, min(each, states - first))
                     for first in range(0, states, each)]:
            done.result()
