"""The compiled ufuncs: signatures, precisions, broadcasting, strides, refusals, subclasses."""

import os
import platform
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor
from itertools import product
from pathlib import Path

import dask.array
import numpy as np
import pytest

import coscrew
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from tests.support.cases import for_all
from tests.support.truth.attack import TIERED

pytestmark = pytest.mark.filterwarnings("ignore::RuntimeWarning")

DTYPES, NAMESPACES = (np.float64, np.float32), ("gufunc", "dispatch")
every_way = for_all(operation=OPERATIONS, dtype=DTYPES, namespace=NAMESPACES)


def inputs(operation: Operation, lead: tuple[int, ...], dtype=np.float64) -> list[np.ndarray]:
    random = np.random.default_rng(len(operation.name))
    return [random.normal(size=(*lead, *a.quantity.shape)).astype(dtype) for a in operation.inputs]


def gufunc(operation: Operation) -> np.ufunc:
    """The compiled function, of any matrices."""
    return coscrew.unchecked(getattr(coscrew, operation.name))


def function(namespace: str, name: str):
    """The compiled function, or the one used without a compiler; of any matrices."""
    from coscrew import _dispatch
    return coscrew.unchecked(getattr(coscrew if namespace == "gufunc" else _dispatch, name))


def tuple_of(result) -> tuple[np.ndarray, ...]:
    return result if isinstance(result, tuple) else (result,)


def same_bits(a, b) -> bool:
    return all(x.dtype == y.dtype and x.shape == y.shape and x.tobytes() == y.tobytes()
               for x, y in zip(tuple_of(a), tuple_of(b), strict=True))


def test_the_extension_is_compiled():
    assert coscrew.COMPILED


@for_all(operation=OPERATIONS)
def test_the_signature_is_the_operations(operation):
    ufunc = gufunc(operation)
    assert isinstance(ufunc, np.ufunc)
    # NumPy keeps no signature for an operation on scalars alone.
    scalars = "->".join(",".join(["()"] * n) for n in (ufunc.nin, ufunc.nout))
    assert (ufunc.signature or scalars) == operation.signature
    assert sorted(ufunc.types) == sorted(
        f"{letter * ufunc.nin}->{letter * ufunc.nout}" for letter in "df")
    assert " ".join(operation.statement.split()) in " ".join(ufunc.__doc__.split())


@for_all(operation=OPERATIONS, namespace=NAMESPACES)
def test_float32_stays_float32_and_everything_else_becomes_float64(operation, namespace):
    call = function(namespace, operation.name)

    def result(*dtypes):
        arguments = inputs(operation, (4,))
        return {r.dtype for r in tuple_of(call(*(
            a.astype(d) for a, d in zip(arguments, dtypes, strict=True))))}

    count = len(operation.inputs)
    assert result(*[np.float32] * count) == {np.dtype(np.float32)}
    for other in (np.float64, np.int64, np.int8, np.uint16):
        assert result(*[other] * count) == {np.dtype(np.float64)}
        for place in range(count if count > 1 else 0):
            mixed = [np.float32] * count
            mixed[place] = other
            assert result(*mixed) == {np.dtype(np.float64)}


@for_all(namespace=NAMESPACES)
def test_python_numbers_take_the_precision_of_the_arrays_beside_them(namespace):
    product_ac = function(namespace, "product_ac")
    c = np.ones(6, np.float32)
    assert product_ac(2.0, c).dtype == product_ac(2, c).dtype == np.float32
    assert product_ac(np.float64(2.0), c).dtype == np.float64
    assert product_ac(2.0, [1, 2, 3, 4, 5, 6]).dtype == np.float64


@every_way
def test_leading_axes_broadcast(operation, dtype, namespace):
    call = function(namespace, operation.name)
    arguments = inputs(operation, (5, 3), dtype)
    whole = tuple_of(call(*arguments))
    for i, j in np.ndindex(5, 3):
        one = tuple_of(call(*(a[i, j] for a in arguments)))
        assert same_bits(one, tuple(r[i, j] for r in whole))
    for place in range(len(arguments)):
        fixed = [a[2, 1] if n == place else a for n, a in enumerate(arguments)]
        repeated = [np.broadcast_to(a[2, 1], a.shape).copy() if n == place else a
                    for n, a in enumerate(arguments)]
        if len(arguments) > 1:
            assert same_bits(call(*fixed), call(*repeated))


@every_way
def test_any_strides_give_the_same_bits(operation, dtype, namespace):
    call = function(namespace, operation.name)
    arguments = inputs(operation, (7,), dtype)
    expected = call(*arguments)

    def spread(a):  # every axis with a gap and backwards
        wide = np.zeros([2 * n for n in a.shape], dtype)
        view = wide[tuple(slice(None, None, 2) for _ in a.shape)]
        view = view[tuple(slice(None, None, -1) for _ in a.shape)]
        view[...] = a
        return view

    def fortran(a):
        return np.asfortranarray(a)

    def unaligned(a):
        raw = np.empty(a.nbytes + 1, np.uint8)[1:].view(np.uint8)
        view = np.frombuffer(raw.data, np.uint8, a.nbytes).view()
        view[:] = np.frombuffer(a.tobytes(), np.uint8)
        return np.ndarray(a.shape, dtype, view.data)

    def swapped(a):
        return a.astype(a.dtype.newbyteorder())

    for layout in (spread, fortran, unaligned, swapped):
        assert same_bits(call(*map(layout, arguments)), expected), layout.__name__
    outs = tuple(spread(np.zeros_like(r)) for r in tuple_of(expected))
    call(*arguments, out=outs)
    assert same_bits(tuple(map(np.ascontiguousarray, outs)), expected)


@every_way
def test_out_may_be_an_input(operation, dtype, namespace):
    call = function(namespace, operation.name)
    for place, argument in enumerate(operation.inputs):
        for number, output in enumerate(operation.outputs):
            if output.quantity.shape != argument.quantity.shape:
                continue
            for rows, order in product((1, 9, 300), "CF"):
                arguments = [np.asarray(a, order=order) for a in inputs(operation, (rows,), dtype)]
                expected = tuple_of(call(*arguments))[number]
                outs: list[np.ndarray | None] = [None] * len(operation.outputs)
                outs[number] = arguments[place]
                result = tuple_of(call(*arguments, out=tuple(outs)))[number]
                assert result is arguments[place]
                assert same_bits(np.ascontiguousarray(result), np.ascontiguousarray(expected))


@for_all(operation=OPERATIONS, namespace=NAMESPACES)
def test_zero_elements_give_zero_results(operation, namespace):
    arguments = inputs(operation, (0, 4))
    for result, output in zip(tuple_of(function(namespace, operation.name)(*arguments)),
                              operation.outputs, strict=True):
        assert result.shape == (0, 4, *output.quantity.shape)


@for_all(operation=OPERATIONS, namespace=NAMESPACES)
def test_bad_arguments_are_refused(operation, namespace):
    call = function(namespace, operation.name)
    good = inputs(operation, (2,))
    with pytest.raises(TypeError):
        call(*good * 5)
    with pytest.raises(TypeError):
        call(*(a.astype(complex) for a in good))
    with pytest.raises((TypeError, ValueError)):
        call(*(np.full(a.shape, "screw") for a in good))
    for place, argument in enumerate(operation.inputs):
        if argument.quantity.shape:
            short = [a[..., :-1] if n == place else a for n, a in enumerate(good)]
            with pytest.raises(ValueError, match=operation.name):
                call(*short)
            with pytest.raises(ValueError, match=operation.name):
                call(*(np.float64(1) if n == place else a for n, a in enumerate(good)))
    results = tuple_of(call(*good))
    read_only = tuple(np.zeros_like(r) for r in results)
    for r in read_only:
        r.flags.writeable = False
    with pytest.raises(ValueError, match="read-only"):
        call(*good, out=read_only)
    with pytest.raises((ValueError, TypeError)):
        call(*good, out=tuple(np.zeros((3, *r.shape[1:])) for r in results))
    with pytest.raises(TypeError):
        call(*good, out=tuple(np.zeros(r.shape, np.int32) for r in results))
    if len(good) > 1:
        with pytest.raises(ValueError):
            call(good[0], *(np.concatenate((a, a[:1])) for a in good[1:]))


def test_nan_and_inf_pass_through():
    D, c = np.eye(3, 4), np.array([np.inf, 1, 2, np.nan, 3, 4])
    D[:, 3] = 1, 2, 3
    result = coscrew.product_CoAdc(D, c)
    # R f holds 0 · inf; so do the moments: IEEE arithmetic, component by component.
    assert result[0] == np.inf and np.isnan(result[1:]).all()
    assert np.isinf(coscrew.add_cc(c, c)[0]) and np.isnan(coscrew.add_cc(c, c)[3])


class Tagged(np.ndarray):
    """A subclass as NumPy ufuncs support it."""


def test_subclasses_are_kept():
    D, c = np.eye(3, 4).view(Tagged), np.arange(12.0).reshape(2, 6).view(Tagged)
    assert type(coscrew.product_CoAdc(D, c)) is Tagged

    class Override:
        def __array_ufunc__(self, ufunc, method, *arguments, **keywords):
            return ufunc.__name__, method

    assert coscrew.product_CoAdc(D, Override()) == ("product_CoAdc", "__call__")


@for_all(operation=OPERATIONS)
def test_dask_applies_every_operation(operation):
    signature = operation.signature
    sizes = {str(n): n for output in operation.outputs for n in output.quantity.shape}
    known = {str(n) for a in operation.inputs for n in a.quantity.shape}
    arguments = inputs(operation, (12,))
    chunked = [dask.array.from_array(a, chunks=(5, *a.shape[1:])) for a in arguments]
    result = dask.array.apply_gufunc(
        gufunc(operation), signature, *chunked,
        output_dtypes=[float] * len(operation.outputs) if len(operation.outputs) > 1 else float,
        output_sizes={name: n for name, n in sizes.items() if name not in known})
    assert same_bits(tuple(r.compute() for r in tuple_of(result)), gufunc(operation)(*arguments))


def test_a_homogeneous_matrix_is_used_by_slicing():
    T = np.eye(4)
    T[:3, 3] = 1, 2, 3
    c = np.arange(6.0)
    assert same_bits(coscrew.product_CoAdc(T[:3], c), coscrew.product_CoAdc(T[:3].copy(), c))


def test_constructors_and_angular_first_order():
    R, t = np.eye(3), np.array([1.0, 2, 3])
    assert (coscrew.SE3(R, t) == np.column_stack((R, t))).all()
    assert (coscrew.screw([1, 2, 3], [4, 5, 6]) == [1, 2, 3, 4, 5, 6]).all()
    assert (coscrew.coscrew([1, 2, 3], [4, 5, 6]) == [1, 2, 3, 4, 5, 6]).all()
    s = np.arange(6.0)
    assert (coscrew.screw_to_angular_first(s) == [3, 4, 5, 0, 1, 2]).all()
    assert (coscrew.coscrew_from_angular_first(s) == [3, 4, 5, 0, 1, 2]).all()


def test_the_loops_for_every_processor_give_the_same_bits():
    """The extension uses AVX2 loops if it can; COSCREW_BASELINE selects the others."""
    program = """
import coscrew, hashlib, importlib, numpy as np
from coscrew_codegen.algebra.operations import OPERATIONS
from coscrew_codegen.accuracy.tiers import TIERS
packages = [importlib.import_module(tier.package) for tier in TIERS]
random = np.random.default_rng(11)
np.seterr(all="ignore")
for op in OPERATIONS:
    arguments = [random.normal(size=(137, *a.quantity.shape)) for a in op.inputs]
    for a in arguments:
        a[37:] = random.choice([0, -0., 1, -1, .3, -2.5, 7, 1e-310, 1e-40, 1e30], a[37:].shape)
    for dtype in (np.float64, np.float32):
        for fixed in (slice(None), 5):
            first, *rest = (a.astype(dtype) for a in arguments)
            for tier in packages:
                if hasattr(tier, op.name):
                    results = coscrew.unchecked(getattr(tier, op.name))(first[fixed], *rest)
                    for x in results if isinstance(results, tuple) else (results,):
                        numbers = np.where(np.isnan(x), np.nan, x).tobytes()
                        digest = hashlib.sha256(numbers).hexdigest()
                        print(tier.__name__, op.name, dtype.__name__, fixed, digest)
"""
    best, baseline = (
        subprocess.run([sys.executable, "-c", program], env={**os.environ, **environment},
                       capture_output=True, text=True, check=True).stdout
        for environment in ({}, {"COSCREW_BASELINE": "1"}))
    assert best.count("\n") >= 4 * (len(OPERATIONS) + 2 * len(TIERED))
    assert best == baseline


@pytest.mark.skipif(platform.machine() not in ("x86_64", "AMD64"), reason="no choice elsewhere")
def test_loops_that_compute_rounding_errors_take_fma_where_the_processor_has_it():
    """Only those do: others need none."""
    flags = Path("/proc/cpuinfo").read_text().partition("flags")[2].partition("\n")[0].split()
    program = ("from coscrew import _gufunc as plain; from coscrew.accurate import _gufunc as a; "
               "from coscrew.certified import _gufunc as c; print(plain.LOOPS, a.LOOPS, c.LOOPS, "
               "sep=', ')")
    for requested, wanted in (({}, ["AVX2", *["AVX2 with FMA"] * 2]),
                              ({"COSCREW_BASELINE": "1"}, ["baseline"] * 3)):
        done = subprocess.run([sys.executable, "-c", program], env={**os.environ, **requested},
                              capture_output=True, text=True, check=True)
        has = [set(x.lower().split(" with ")) <= {"baseline", *flags} for x in wanted]
        assert done.stdout.strip().split(", ") == [
            x if there else "baseline" for x, there in zip(wanted, has, strict=True)]


def test_many_threads_agree():
    random = np.random.default_rng(5)
    D, c = coscrew.SE3_exp(random.normal(size=(20000, 6))), random.normal(size=(20000, 6))
    expected = coscrew.product_CoAdc(D, c)
    with ThreadPoolExecutor(4) as pool:
        for result in pool.map(lambda _: coscrew.product_CoAdc(D, c), range(32)):
            assert same_bits(result, expected)


def test_the_gil_is_released():
    """A thread of Python counts while one long call runs in another."""
    c = np.broadcast_to(np.arange(6.0), (5_000_000, 6))
    out, count, stop = np.empty(len(c)), [0], threading.Event()

    def counting():
        while not stop.is_set():
            count[0] += 1

    def counted_during_one_call() -> int:
        before = count[0]
        coscrew.dot_cs(c, c, out=out)
        return count[0] - before

    counter = threading.Thread(target=counting)
    interval = sys.getswitchinterval()
    sys.setswitchinterval(0.5)  # far longer than the call: the lock must be given up
    counter.start()
    try:
        assert max(counted_during_one_call() for _ in range(2)) > 1000
    finally:
        stop.set()
        sys.setswitchinterval(interval)
        counter.join()
