"""Gufuncs of kernels that call elementary functions compute several elements at a time: with the
bits, and the floating-point flags, of each alone, in any layout."""

import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import coscrew
import coscrew.double
import coscrew.single
from coscrew_codegen.algebra.operations import OPERATIONS, Operation
from coscrew_codegen.program.elementary.elementary_calls import FUNCTION_OF
from tests.support.cases import for_all
from tests.support.truth.attack import plain_program

pytestmark = pytest.mark.filterwarnings("ignore::RuntimeWarning")

ROOT = Path(__file__).parents[2]
CHOSEN = tuple(op for op in OPERATIONS if plain_program(op).counts.keys() & FUNCTION_OF.keys())
TWINS = {np.float64: coscrew.double, np.float32: coscrew.single}
LANES = {np.float64: 4, np.float32: 8}  # of AVX2
SHORT = 19  # two vectors and a rest, and more than are computed one by one
LONG = 2100  # more than are computed before any is written
every = for_all(operation=CHOSEN, dtype=tuple(TWINS))

Arrays = tuple[np.ndarray, ...]


def tuple_of(result) -> Arrays:
    return result if isinstance(result, tuple) else (result,)


def hard_numbers(dtype) -> np.ndarray:
    """Zeros of either sign, subnormal, tiny, large and huge numbers, infinities, NaN."""
    type_ = np.finfo(dtype)
    return np.array([0, -0.0, type_.smallest_subnormal, -type_.smallest_subnormal, 3e-40,
                     type_.tiny, 1, -1, np.pi, 1e5, -1e8, 1e20, type_.max, -type_.max / 3, np.inf,
                     -np.inf, np.nan], dtype)


def inputs(operation: Operation, dtype, n: int, some: float = 0.1) -> Arrays:
    """Normal numbers, and hard ones in random places: that part of all."""
    random = np.random.default_rng((n, len(operation.name)))
    arrays = []
    for argument in operation.inputs:
        a = random.normal(size=(n, *argument.quantity.shape)).astype(dtype)
        at = random.random(a.shape) < some
        a[at] = random.choice(hard_numbers(dtype), np.count_nonzero(at))
        arrays.append(a)
    return tuple(arrays)


def one_by_one(call: Callable, arguments: Arrays) -> Arrays:
    """The results of calls with one element each."""
    each = [tuple_of(call(*(a[i] for a in arguments))) for i in range(len(arguments[0]))]
    return tuple(map(np.stack, zip(*each, strict=True)))


def assert_same(result, wanted: Arrays, message: object = "") -> None:
    """Asserts equal bits; NaN where wanted is NaN."""
    for x, y in zip(tuple_of(result), wanted, strict=True):
        assert x.dtype == y.dtype and x.shape == y.shape, message
        x, y = (np.where(np.isnan(a), a.dtype.type(np.nan), a) for a in (x, y))
        bits = f"u{x.dtype.itemsize}"
        at = np.argwhere(np.ascontiguousarray(x).view(bits) != np.ascontiguousarray(y).view(bits))
        assert not len(at), (message, [(tuple(map(int, i)), float(x[*i]).hex(), float(y[*i]).hex())
                                       for i in at[:5]])


def spread(a: np.ndarray) -> np.ndarray:
    """With a gap between any two numbers."""
    view = np.full([2 * n for n in a.shape], 7, a.dtype)[tuple(slice(None, None, 2)
                                                              for _ in a.shape)]
    view[...] = a
    return view


def backwards(a: np.ndarray) -> np.ndarray:
    """From the last number to the first."""
    turned = (slice(None, None, -1),) * a.ndim
    return a[turned].copy()[turned]


def planes(a: np.ndarray) -> np.ndarray:
    """Elements next to each other, components apart."""
    return np.asfortranarray(a)


def unaligned(a: np.ndarray) -> np.ndarray:
    """At an odd address."""
    raw = np.empty(a.nbytes + 1, np.uint8)
    view = np.ndarray(a.shape, a.dtype, raw.data, offset=1)
    view[...] = a
    return view


LAYOUTS = (np.ascontiguousarray, spread, backwards, planes, unaligned)


def test_loops_on_vectors_are_those_that_call_elementary_functions():
    texts = [path.read_text("utf-8") for path in (ROOT / "generated/gufunc").glob("*.c")]
    matches = re.findall(r"^INLINED int (\w+)_on_vectors\(", "\n".join(texts), re.MULTILINE)
    assert sorted(matches) == sorted(f"{op.name}_{name}" for op in CHOSEN
                                     for name in ("double", "single"))
    assert {"sincos", "SO3_exp", "SE3_log"} < {op.name for op in CHOSEN}


@every
def test_any_number_of_elements(operation, dtype):
    call = coscrew.unchecked(getattr(coscrew, operation.name))
    for n in range(2 * LANES[dtype] + 2):
        arguments = inputs(operation, dtype, n)
        wanted = one_by_one(call, arguments) if n else tuple(
            np.empty((0, *a.quantity.shape), dtype) for a in operation.outputs)
        assert_same(call(*arguments), wanted, n)


@every
def test_many_elements_have_the_bits_of_the_twin(operation, dtype):
    for some in (0, 0.01, 0.3):
        arguments = inputs(operation, dtype, LONG, some)
        wanted = tuple_of(getattr(TWINS[dtype], operation.name)(*arguments))
        assert_same(coscrew.unchecked(getattr(coscrew, operation.name))(*arguments), wanted, some)


@every
def test_any_layout(operation, dtype):
    call = coscrew.unchecked(getattr(coscrew, operation.name))
    arguments = inputs(operation, dtype, SHORT)
    wanted = one_by_one(call, arguments)
    for layout in LAYOUTS:
        assert_same(call(*map(layout, arguments)), wanted, layout.__name__)
        outs = tuple(layout(np.zeros_like(x)) for x in wanted)
        call(*arguments, out=outs)
        assert_same(outs, wanted, f"out: {layout.__name__}")


@every
def test_nothing_is_written_between_results(operation, dtype):
    arguments = inputs(operation, dtype, SHORT)
    wholes = [np.full([2 * n for n in (SHORT, *a.quantity.shape)], 7, dtype)
              for a in operation.outputs]
    outs = tuple(x[tuple(slice(None, None, 2) for _ in x.shape)] for x in wholes)
    coscrew.unchecked(getattr(coscrew, operation.name))(*arguments, out=outs)
    for whole, out in zip(wholes, outs, strict=True):
        out[...] = 7
        assert (whole == 7).all()


@every
def test_shared_elements(operation, dtype):
    call = coscrew.unchecked(getattr(coscrew, operation.name))
    arguments = inputs(operation, dtype, SHORT)
    for place in range(len(arguments)):
        shared = tuple(np.broadcast_to(a[3], a.shape) if k == place else a
                       for k, a in enumerate(arguments))
        assert_same(call(*shared), one_by_one(call, shared), place)
        alone = tuple(a[3] if k == place else a for k, a in enumerate(arguments))
        if len(arguments) > 1:
            assert_same(call(*alone), one_by_one(call, shared), place)


@every
def test_results_in_place(operation, dtype):
    """More elements than are computed before any is written are included."""
    call = coscrew.unchecked(getattr(coscrew, operation.name))
    for number, output in enumerate(operation.outputs):
        for place, argument in enumerate(operation.inputs):
            if output.quantity.shape != argument.quantity.shape:
                continue
            for layout in LAYOUTS[:-1]:
                for n in (SHORT, LONG):
                    arguments = [layout(a) for a in inputs(operation, dtype, n)]
                    wanted = tuple_of(call(*arguments))
                    outs = [np.empty_like(x) for x in wanted]
                    outs[number] = arguments[place]
                    call(*arguments, out=tuple(outs))
                    assert_same(tuple(outs), wanted, layout.__name__)


@every
def test_flags_are_those_of_one_element_each(operation, dtype):
    """NumPy warns of those except underflow; kernels on vectors evaluate branches that are not
    chosen, too.  Underflow is left out: clang's code for one element raises it from old contents of
    registers."""
    call = coscrew.unchecked(getattr(coscrew, operation.name))

    def flags(*arguments) -> set[str]:
        results = set()
        with np.errstate(all="call", under="ignore", call=lambda kind, _: results.add(kind)):
            call(*arguments)
        return results

    for number in hard_numbers(dtype):
        arguments = inputs(operation, dtype, SHORT, 0)
        for a in arguments:
            a.reshape(SHORT, -1)[::3, -1] = number
        each = [flags(*(a[i] for a in arguments)) for i in range(SHORT)]
        assert flags(*arguments) == set().union(*each), number


@pytest.mark.skipif(coscrew._gufunc.LOOPS == "baseline", reason="these are the baseline's")
def test_the_baseline_too():
    """All of these, in the loops for any processor."""
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-n", "0", "-p", "no:cacheprovider", __file__],
        env={**os.environ, "COSCREW_BASELINE": "1"}, cwd=ROOT, text=True, capture_output=True)
    assert done.returncode == 0 and "1 skipped" in done.stdout, done.stdout + done.stderr
