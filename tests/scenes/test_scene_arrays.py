"""Arrays that scenes' functions take and fill: out=, both precisions, any strides; and pickling."""

import copy
import pickle
import warnings
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import cloudpickle
import dask.array
import numpy as np
import pytest

import coscrew_codegen
from coscrew_codegen.backends.python_extension import scene_calls
from coscrew_codegen.program.values.formats import Precision
from coscrew_codegen.runtime import callables, source_text
from coscrew_codegen.runtime.load import Kernels, kernels_of, restored
from tests.support.each import each_precision
from tests.support.scenes import scene_texts as texts
from tests.support.scenes.generated_scenes import ARGUMENTS, pendulum, slider
from tests.support.scenes.scene_values import same_bits

pytestmark = pytest.mark.usefixtures("users_compiler")

LEADS = ((), (0,), (3,), (2, 3))
by_lead = pytest.mark.parametrize("lead", LEADS, ids=str)


@pytest.fixture(scope="module", params=("compiled", "NumPy"))
def kernels(request: pytest.FixtureRequest, tmp_path_factory) -> Kernels:
    """The slider's kernels, compiled and not."""
    with pytest.MonkeyPatch.context() as patch, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
        if request.param == "NumPy":
            patch.setenv("CC", "/no/such/compiler")
        return kernels_of(slider())


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty cache."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return tmp_path / "cache" / "coscrew"


def every(kernels: Kernels, precision: Precision, lead: tuple[int, ...], kind: str = ""):
    """(description, function, arguments) of all functions."""
    draw = np.random.default_rng(3)
    for described in scene_calls.callables(kernels.functions):
        arguments = [draw.normal(size=(*lead, *shape)).astype(kind or precision.numpy_type)
                     for _, shape in described.inputs]
        yield described, getattr(getattr(kernels, precision.name), described.name), arguments


def tuple_of(result: object) -> tuple:
    return result if isinstance(result, tuple) else (result,)


def given_to(outs: tuple[np.ndarray, ...]) -> object:
    return outs if len(outs) > 1 else outs[0]


def spread(x: np.ndarray) -> np.ndarray:
    """Returns equal numbers, in reverse order and with gaps in memory."""
    wide = np.zeros([2 * n for n in x.shape], x.dtype)
    view = wide[(..., *(slice(None, None, -2) for _ in x.shape))]
    view[...] = x
    return view


def swapped(x: np.ndarray) -> np.ndarray:
    return x.astype(x.dtype.newbyteorder())


@by_lead
@each_precision
def test_results_go_where_out_says(kernels: Kernels, precision: Precision, lead):
    for described, function, arguments in every(kernels, precision, lead):
        wanted = tuple_of(function(*arguments))
        for layout in (np.ascontiguousarray, np.asfortranarray, spread, swapped,
                       lambda x: x.astype(np.longdouble)):
            outs = tuple(layout(np.full(np.shape(x), 7, np.result_type(x))) for x in wanted)
            outs = tuple(x.reshape(np.shape(y)) for x, y in zip(outs, wanted, strict=True))
            result = tuple_of(function(*arguments, out=given_to(outs)))
            assert all(x is y for x, y in zip(result, outs, strict=True)), described.name
            assert same_bits(tuple(x.astype(precision.numpy_type) for x in outs),
                             tuple(map(np.asarray, wanted))), described.name
        if len(wanted) > 1:
            part = np.empty(np.shape(wanted[1]), precision.numpy_type)
            first, second = function(*arguments, out=(None, part))
            assert second is part and same_bits((first, second), wanted)


@by_lead
@each_precision
def test_out_may_overlap_inputs(kernels: Kernels, precision: Precision, lead):
    count = 0
    for described, function, arguments in every(kernels, precision, lead):
        wanted = tuple_of(function(*arguments))
        names = [x for x, _ in described.inputs]
        for number, (_, shape) in enumerate(described.outputs):
            for place, (name, taken) in enumerate(described.inputs):
                if taken != shape or not shape:
                    continue
                for shift in (0, 1, -1):  # in numbers: the same array, or overlapping
                    room = np.zeros(arguments[place].size + 2, precision.numpy_type)
                    put, read = (room[1 + k:len(room) - 1 + k].reshape(arguments[place].shape)
                                 for k in (0, shift))
                    given = list(arguments)
                    put[...], read[...] = 0, arguments[place]
                    given[names.index(name)] = read
                    outs = [None] * len(wanted)
                    outs[number] = put
                    result = tuple_of(function(*given, out=tuple(outs)))
                    assert result[number] is put
                    assert same_bits(result, wanted), (described.name, name, shift)
                    count += 1
    assert count > 20


def test_steps_in_place_swap_nothing(kernels: Kernels):
    q, v = np.array([[0.1, 0.2]] * 4), np.array([[0.3, -0.4]] * 4)
    step = kernels.double.step_rk4
    wanted = step(2.0, 0.1, [1.5, 0.0], q, v)
    room = np.stack((q, v))
    assert same_bits(step(2.0, 0.1, [1.5, 0.0], *room, out=(room[1], room[0])), wanted)


@pytest.mark.parametrize("out, error, message", (
    (np.zeros(3), ValueError, r"out: got shape \(3,\); wanted shape \(2,\)"),
    (np.zeros((1, 2)), ValueError, r"out: got shape \(1, 2\); wanted shape \(2,\)"),
    (np.zeros(2, np.float32), TypeError, "out: got float32; wanted float64"),
    (np.zeros(2, int), TypeError, "out: got int64; wanted float64"),
    ([0.0, 0.0], TypeError, "out: got list; wanted an array"),
    (np.ma.zeros(2), TypeError, "out: got MaskedArray; wanted an array"),
    ((np.zeros(2), np.zeros(2)), TypeError, "out: got 2 arrays; wanted 1, as a tuple"),
    (np.broadcast_to(0.0, 2), ValueError,
     "out: got a read-only array; wanted a writable one")))
def test_wrong_out_is_named_and_nothing_written(kernels: Kernels, out, error, message):
    before = copy.deepcopy(out)
    for arguments in (ARGUMENTS, tuple(map(np.array, ARGUMENTS))):
        with pytest.raises(error, match=f"^{message}$"):
            kernels.double.forward_dynamics(*arguments, out=out)
    assert np.array_equal(before, out)


def test_wrong_outs_of_steps_are_named(kernels: Kernels):
    arguments = (2.0, 0.1, [1.5, 0.0], [0.1, 0.2], [0.3, -0.4])
    one = np.full((2, 2), 7.0)
    for out, error, message in (
            (one, TypeError, "out: got 1 arrays; wanted 2, as a tuple"),
            ((one[0], one[0]), ValueError, "out: got arrays that share memory"),
            ((one[0], one), ValueError, r"out: got shape \(2, 2\); wanted shape \(2,\)")):
        with pytest.raises(error, match=f"^{message}"):
            kernels.double.step_rk4(*arguments, out=out)
        assert (one == 7).all()


def test_out_is_given_by_name(kernels: Kernels):
    """A surplus argument never becomes the output."""
    with pytest.raises(TypeError, match=r"forward_dynamics\(t, p, q, v, tau\): got 6 arguments"):
        kernels.double.forward_dynamics(*ARGUMENTS, np.zeros(2))


@by_lead
@each_precision
def test_the_other_precision_and_any_strides_are_read(kernels: Kernels, precision, lead):
    other = "float32" if precision.name == "double" else "float64"
    for described, function, arguments in every(kernels, precision, lead, other):
        wanted = function(*(x.astype(precision.numpy_type) for x in arguments))
        for layout in (np.asarray, spread, swapped, np.asfortranarray):
            assert same_bits(function(*(x if x.ndim == 0 else layout(x) for x in arguments)),
                             wanted), (described.name, layout)


def test_one_state_in_the_other_precision_needs_no_checks(monkeypatch):
    """Compiled code converts it and reads any strides, without Python code."""
    kernels = kernels_of(slider())
    states = np.arange(40.0).reshape(2, 20)[::-1, ::5]

    def refuse(*_: object, **__: object):
        raise AssertionError("checked in Python")

    monkeypatch.setattr(callables.checks(source_text.checks()), "arrays", refuse)
    for kind in (np.float64, np.float32):
        q, v, tau, p = (states[:, k].astype(kind)[::-1] for k in range(4))
        for functions in (kernels.double, kernels.single):
            out = functions.forward_dynamics(2.0, p, q, v, tau)
            assert functions.forward_dynamics(2.0, p, q, v, tau, out=out) is out
            functions.step_rk4(np.float64(2), np.float32(0.1), p, *map(
                out.dtype.type, (q, v)))


@pytest.mark.parametrize("name", ("t", "q"))
def test_numbers_beyond_single_are_refused(kernels: Kernels, name: str):
    arguments = dict(zip(("t", "p", "q", "v", "tau"), ARGUMENTS, strict=True))
    arguments[name] = np.array([1e39, np.inf]) if name == "q" else 1e39
    for given in (arguments[name], np.array([arguments[name]] * 3)):
        with pytest.raises(ValueError, match=f"^{name}: got a number of magnitude 1e\\+39; the "
                                             "largest in float32 is 3.402"):
            kernels.single.forward_dynamics(**arguments | {name: given})
    assert np.isfinite(kernels.double.forward_dynamics(**arguments | {"q": [1e39, 0.0]})).all()


def test_subclasses_are_read_as_arrays(kernels: Kernels):
    class Tagged(np.ndarray):
        pass

    given = [np.array(x).view(Tagged) for x in ARGUMENTS]
    result = kernels.double.forward_dynamics(*given)
    assert same_bits(result, kernels.double.forward_dynamics(*ARGUMENTS))
    assert type(result) is np.ndarray


# Pickles

def test_pickles_hold_the_scene(kernels: Kernels):
    restored.cache_clear()
    wanted = kernels.double.forward_dynamics(*ARGUMENTS)
    for pickler in (pickle, cloudpickle):
        again = pickler.loads(pickler.dumps(kernels))
        assert dir(again.double) == dir(kernels.double) and again.functions == kernels.functions
        assert same_bits(again.double.forward_dynamics(*ARGUMENTS), wanted)
        assert pickler.loads(pickler.dumps(kernels.single)) is again.single
        function = pickler.loads(pickler.dumps(kernels.double.forward_dynamics))
        assert function is again.double.forward_dynamics
    for thing in (kernels, kernels.double, kernels.single.energy):
        assert copy.copy(thing) is thing and copy.deepcopy([thing])[0] is thing


def test_scenes_of_files_pickle(tmp_path: Path, cache: Path):
    (tmp_path / "scene.toml").write_text(texts.SPRING)
    spring = coscrew_codegen.load_scene(tmp_path / "scene.toml")
    (tmp_path / "scene.toml").unlink()
    again = pickle.loads(pickle.dumps(spring))
    assert again.scene == spring.scene and again.parameters == spring.parameters
    assert len(list(cache.rglob("*.so"))) == 1  # found again, not made again


@pytest.mark.parametrize("start", ("spawn", "fork"))
def test_other_processes_take_functions(cache: Path, start: str):
    function = kernels_of(pendulum()).double.forward_dynamics
    described = scene_calls.callables(pendulum())
    shapes = next(x.inputs for x in described if x.name == "forward_dynamics")
    arguments = [np.full((5, *shape), 0.3) for _, shape in shapes]
    before = sorted(cache.rglob("*.so"))
    with ProcessPoolExecutor(1, get_context(start)) as pool:
        assert same_bits(pool.submit(function, *arguments).result(), function(*arguments))
    assert sorted(cache.rglob("*.so")) == before  # found there, not made again


def test_dask_maps_functions(kernels: Kernels):
    t, p, q, v, tau = map(np.array, ARGUMENTS)
    states = np.random.default_rng(1).normal(size=(12, 2))
    function = kernels.double.forward_dynamics
    lazy = dask.array.apply_gufunc(
        lambda q: function(t, p, q, v, tau), "(n)->(n)",
        dask.array.from_array(states, chunks=(5, 2)), output_dtypes=float)
    assert same_bits(lazy.compute(scheduler="threads"), function(t, p, states, v, tau))
