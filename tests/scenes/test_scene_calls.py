"""Calls of compiled functions from Python: C takes arrays of one state and rows of many without
Python's checks, with the same bits in any layout and number of threads; and leaks nothing."""

import gc
import inspect
import sys
import tracemalloc
from collections.abc import Iterator
from contextlib import suppress

import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.backends.python_extension import scene_calls
from coscrew_codegen.program.values.formats import DOUBLE, SINGLE, Precision
from coscrew_codegen.runtime import callables, lanes, source_text
from coscrew_codegen.runtime.load import Kernels, kernels_of
from tests.support.each import each_precision
from tests.support.scenes.generated_scenes import ARGUMENTS, slider
from tests.support.scenes.scene_values import same_bits

pytestmark = pytest.mark.usefixtures("users_compiler")

COUNT = 60
FLOATING = """
[bodies]
body = { mass = 2, com = [0, 0.1, -0.2], inertia = [0.3, 0.4, 0.5] }
[joints]
base = { type = "free", child = "body" }
"""


@pytest.fixture(scope="module")
def kernels(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Kernels]:
    """The slider's kernels, which compute in lanes from the first state on."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
        patch.setattr(lanes, "PAYS", 1)
        made = kernels_of(slider())
        for precision in ("double", "single"):
            for described, function in every(made, precision):
                function(*(np.ones((2, *shape)) for _, shape in described.inputs))
        yield made


@pytest.fixture
def unchecked(monkeypatch: pytest.MonkeyPatch) -> None:
    """Arguments are not checked in Python."""
    def refuse(*_: object, **__: object):
        raise AssertionError("checked in Python")

    monkeypatch.setattr(callables.checks(source_text.checks()), "arrays", refuse)


def every(kernels: Kernels, precision: str):
    """(description, function) of all functions."""
    for described in scene_calls.callables(kernels.functions):
        yield described, getattr(getattr(kernels, precision), described.name)


def states(described, count: int, precision: Precision, seed: int = 5) -> list[np.ndarray]:
    draw = np.random.default_rng(seed)
    return [draw.uniform(0.1, 2, (count, *shape)).astype(precision.numpy_type)
            for _, shape in described.inputs]


def tuple_of(result: object) -> tuple:
    return result if isinstance(result, tuple) else (result,)


def of_each(function, given: list[np.ndarray]) -> tuple[np.ndarray, ...]:
    """The results of one state after the other."""
    results = [tuple_of(function(*(x[k] for x in given))) for k in range(len(given[0]))]
    return tuple(map(np.array, zip(*results, strict=True)))


def columns(x: np.ndarray) -> np.ndarray:
    """Returns equal rows, as some columns of a wider array."""
    wide = np.full((len(x), x[0].size + 3), np.nan, x.dtype)
    wide[:, 1:-2] = x.reshape(len(x), -1)
    return wide[:, 1:-2] if x.ndim > 1 else wide[:, 1]


LAYOUTS = {"in a row": lambda x: x, "columns": columns,
           "every second": lambda x: np.repeat(x, 2, 0)[::2],
           "backwards": lambda x: x[::-1].copy()[::-1],
           "shared": lambda x: np.broadcast_to(x[0], x.shape)}


@pytest.mark.parametrize("layout", LAYOUTS)
@each_precision
def test_rows_are_read_where_they_stand(kernels: Kernels, unchecked, precision, layout: str):
    for described, function in every(kernels, precision.name):
        given = [LAYOUTS[layout](x) for x in states(described, COUNT, precision)]
        wanted = of_each(function, given)
        assert same_bits(tuple_of(function(*given)), wanted), described.name
        one = [x[3] if n % 2 else x for n, x in enumerate(given)]  # some of them the same for all
        spread = [np.broadcast_to(x, y.shape) for x, y in zip(one, given, strict=True)]
        assert same_bits(tuple_of(function(*one)), of_each(function, spread)), described.name


@each_precision
def test_several_axes_are_rows(kernels: Kernels, unchecked, precision):
    for described, function in every(kernels, precision.name):
        given = states(described, COUNT, precision)
        wanted = tuple_of(function(*given))
        result = tuple_of(function(*(x.reshape(3, 4, 5, *x.shape[1:]) for x in given)))
        assert all(x.shape[:3] == (3, 4, 5) for x in result)
        assert same_bits(tuple(x.reshape(y.shape) for x, y in zip(result, wanted, strict=True)),
                         wanted), described.name


@each_precision
def test_checked_rows_have_the_same_bits(kernels: Kernels, precision):
    """Layouts and types that C does not take."""
    for described, function in every(kernels, precision.name):
        given = states(described, COUNT, precision)
        wanted = tuple_of(function(*given))
        for layout in (np.asfortranarray, lambda x: x.astype(x.dtype.newbyteorder()),
                       np.ndarray.tolist, lambda x: x[:, None][:, 0]):
            assert same_bits(tuple_of(function(*map(layout, given))), wanted), described.name
        if len(given) > 1:
            grid = [np.expand_dims(x[:6], n % 2) for n, x in enumerate(given)]
            full = [np.broadcast_to(x, (6, 6, *y.shape[1:])).reshape(36, *y.shape[1:])
                    for x, y in zip(grid, given, strict=True)]
            result = tuple_of(function(*grid))
            assert same_bits(tuple(x.reshape(36, *x.shape[2:]) for x in result),
                             of_each(function, full)), described.name


@pytest.mark.parametrize("count", (0, 1, 2047, 2048, 5000))
def test_threads_change_no_bit(kernels: Kernels, count: int):
    for described, function in every(kernels, "double"):
        given = states(described, count, DOUBLE)
        wanted = tuple_of(function(*given))
        mixed = [given[0].astype(np.float32).astype(float), *given[1:]]
        also = tuple_of(function(*mixed))
        for threads in (1, 2, 3, np.int64(7), 10**30):
            assert same_bits(tuple_of(function(*given, threads=threads)), wanted), described.name
            checked = [mixed[0].astype(np.float32), *mixed[1:]]
            assert same_bits(tuple_of(function(*checked, threads=threads)), also), described.name


@pytest.mark.parametrize("wrong, error", (
    (0, ValueError), (-1, ValueError), (2.5, TypeError), (True, TypeError), ("2", TypeError),
    (None, TypeError), (-10**30, ValueError)))
def test_wrong_threads_are_refused(kernels: Kernels, wrong: object, error: type[Exception]):
    message = f"^threads: got {wrong!r}; wanted a positive integer$"
    for arguments in (ARGUMENTS, [np.ones((3, *np.shape(x))) for x in ARGUMENTS]):
        with pytest.raises(error, match=message.replace("(", r"\(")):
            kernels.double.forward_dynamics(*arguments, threads=wrong)


def test_rows_of_out_are_written_where_they_stand(kernels: Kernels):
    given = states(next(x for x, f in every(kernels, "double") if x.name == "forward_dynamics"),
                   COUNT, DOUBLE)
    wanted = kernels.double.forward_dynamics(*given)
    for wide in (np.zeros((COUNT, 9)), np.zeros((9, COUNT)).T, np.zeros((2 * COUNT, 9))[::-2]):
        put = wide[:, 3:5]
        assert kernels.double.forward_dynamics(*given, out=put) is put
        assert same_bits(put, wanted) and not wide[:, :3].any() and not wide[:, 5:].any()
    room = np.zeros((2 * COUNT, 2))
    for read, put in ((room[:COUNT], room[:COUNT]), (room[:COUNT], room[1:COUNT + 1]),
                      (room[::2], room[1::2]), (room[1:COUNT + 1], room[:COUNT])):
        read[...] = given[2]
        assert kernels.double.forward_dynamics(*given[:2], read, *given[3:], out=put) is put
        assert same_bits(put, wanted)


@pytest.mark.parametrize("precision, kind", (("double", np.longdouble), ("single", np.float64)))
def test_rows_of_a_wider_out_hold_the_same_numbers(kernels: Kernels, precision: str,
                                                   kind: type[np.floating]):
    """C writes numbers of its own size, elsewhere."""
    function = getattr(kernels, precision).forward_dynamics
    given = states(next(x for x, f in every(kernels, precision) if x.name == "forward_dynamics"),
                   COUNT, DOUBLE if precision == "double" else SINGLE)
    put = np.full((COUNT, 2), 7, kind)
    assert function(*given, out=put) is put
    assert (put == function(*given)).all()


def test_names_outputs_and_numbers_reach_c(kernels: Kernels, unchecked):
    t, p, q, v, tau = map(np.array, ARGUMENTS)
    out, function = np.empty(2), kernels.double.forward_dynamics
    wanted = function(2.0, p, q, v, tau)
    for time in (2.0, np.float64(2), np.float32(2), np.int64(2), np.int32(2), t, np.float32(t)):
        assert same_bits(function(tau=tau, v=v, q=q, p=p, t=time), wanted)
        assert function(time, p, q, out=out, threads=1, tau=tau, v=v) is out
        assert same_bits(out, wanted) and same_bits(function(t, p, q, v, tau, out=None), wanted)


@each_precision
def test_inputs_of_several_axes_reach_c(precision, tmp_path, request):
    """A run of floating bases passes their momenta at every sample."""
    (tmp_path / "floating.toml").write_text(FLOATING)
    its = load_scene(tmp_path / "floating.toml",
                     functions=["free_momentum", "with_free_momentum"])
    functions = getattr(its, precision.name)
    q, v = (np.array(x, precision.numpy_type) for x in ((1, 2, 3, 0, 0.6, 0, 0.8), range(6)))
    c = functions.free_momentum(q, v)
    wanted = functions.with_free_momentum(0.5, q, v, c.tolist())
    assert not np.array_equal(wanted[0], q)
    for wrong in (c.reshape(9, 1), c[:, :8], c[0]):
        with pytest.raises(ValueError, match="wanted shape"):
            functions.with_free_momentum(0.5, q, v, wrong)
    request.getfixturevalue("unchecked")
    assert same_bits(functions.with_free_momentum(0.5, q, v, c), wanted)


def test_signatures_are_told(kernels: Kernels):
    function = kernels.double.forward_dynamics
    assert str(inspect.signature(function)) == "(t, p, q, v, tau, *, out=None, threads=1)"
    assert inspect.getdoc(function) and repr(function).startswith("<forward_dynamics of slider")


# Memory

def answers(kernels: Kernels):
    """Calls of every kind, also those that fail."""
    for precision in ("double", "single"):
        for described, function in every(kernels, precision):
            one = [x[0] for x in states(described, 3, DOUBLE)]
            many = states(described, 40, DOUBLE if precision == "double" else SINGLE)
            outs = tuple(np.empty_like(x) for x in tuple_of(function(*many)))
            out = outs if len(outs) > 1 else outs[0]
            yield from ((function, one, {}), (function, many, {}),
                        (function, many, {"out": out, "threads": 2}),
                        (function, [x.tolist() for x in many], {}), (function, one[:-1], {}),
                        (function, one, {"out": 3}), (function, one, {"none": 1}),
                        (function, one, {"threads": 0}), (function, [*one[:-1], one], {}),
                        (function, [*one[:-1], np.ones(17)], {}), (function, [None] * 9, {}),
                        (function, [-x for x in one], {}), (function, [1e300 * x for x in one], {}))


def rounds(count: int, all_of_them) -> None:
    for _ in range(count):
        for function, arguments, named in all_of_them:
            with suppress(TypeError, ValueError):
                function(*arguments, **named)


def test_calls_leak_nothing(kernels: Kernels):
    given = list(answers(kernels))
    held = [x for _, arguments, named in given for x in (*arguments, named.get("out"))
            if isinstance(x, np.ndarray)]
    before = [sys.getrefcount(x) for x in held]
    tracemalloc.start()
    held_bytes = []
    for _ in range(7):  # Python and NumPy keep some memory for use again, and no more after a while
        rounds(6, given)
        gc.collect()
        held_bytes.append(tracemalloc.get_traced_memory()[0])
    tracemalloc.stop()
    assert [sys.getrefcount(x) for x in held] == before
    assert min(np.diff(held_bytes)) < 12 * len(given)  # 2 bytes a call
