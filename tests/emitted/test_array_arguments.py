"""Arguments other than arrays of double or single precision or of integers raise a TypeError that
names them."""

import pickle
import re
from fractions import Fraction
from importlib import import_module

import numpy as np
import pytest

import coscrew
from coscrew import _dispatch
from coscrew_codegen.accuracy.tiers import TIERS
from coscrew_codegen.algebra.operations import OPERATIONS

PACKAGES = tuple(import_module(tier.package) for tier in TIERS)
NAMESPACES = {f"{tier.__name__} {name}": module for tier in PACKAGES for name, module in (
    ("compiled", tier), ("without compilation", __import__(f"{tier.__name__}._dispatch",
                                                          fromlist=["_dispatch"])),
    ("double", tier.double), ("single", tier.single))}
by_namespace = pytest.mark.parametrize("namespace", NAMESPACES.values(), ids=NAMESPACES)


class Tracer:
    """Refuses to become an array, as JAX's tracers and PyTorch's tensors on other devices do."""

    def __init__(self, error: Exception):
        self.error = error

    def __array__(self, dtype=None, copy=None):
        raise self.error


class Table:
    """Like a pandas table, whose columns would be taken for rows."""

    __pandas_priority__ = 4000

    def __array__(self, dtype=None, copy=None):
        return np.ones(6)

    def __array_ufunc__(self, ufunc, method, *arguments, **options):
        return "columns"


def wrong(shape: tuple[int, ...]) -> dict[str, object]:
    """Arguments of this shape that are refused, by the error's message."""
    ones = np.ones(shape)
    kinds = (np.longdouble, np.float16, np.bool_, np.complex128, np.clongdouble, "M8[s]", "m8[s]",
             "U3", "S3", [("x", float)])
    results: dict[str, object] = {f"got {np.dtype(k)}": np.zeros(shape, k) for k in kinds}
    return results | {
        "got a masked array": np.ma.masked_array(ones, ones > 2),
        "got objects (NoneType)": np.full(shape, None),
        "got objects (str)": np.full(shape, "one", object),
        "got a pandas Table; wanted its to_numpy()": Table(),
        "got list": [[1.0], [1.0, 2.0]],
        "got Tracer, which NumPy cannot convert (a traced array)":
            Tracer(TypeError("a traced array\nwith much to say")),
        "got Tracer, which NumPy cannot convert (on another device)":
            Tracer(RuntimeError("on another device")),
    }


@by_namespace
def test_every_argument_of_every_operation_is_held_to_it(namespace):
    count = 0
    for operation in OPERATIONS:
        call = getattr(namespace, operation.name, None)
        for place, argument in enumerate(operation.inputs if call else ()):
            shape = argument.quantity.shape
            for message, value in wrong(shape).items():
                given = [value if n == place else np.ones(a.quantity.shape)
                         for n, a in enumerate(operation.inputs)]
                with pytest.raises(TypeError) as caught:
                    call(*given)
                text = str(caught.value)
                assert text.startswith(f"{operation.name}: {argument.name}: {message}"), text
                assert "float64, float32 or integers" in text
                count += 1
    assert count > 1000


@pytest.mark.parametrize("namespace", (coscrew, _dispatch), ids=("compiled", "without compilation"))
def test_objects_are_for_the_twins(namespace):
    halves = [Fraction(k, 2) for k in range(6)]
    with pytest.raises(TypeError, match=r"^coscrew_inverted: ci: got objects \(Fraction\); "):
        namespace.coscrew_inverted(halves)
    with pytest.raises(TypeError, match=r"^coscrew_inverted: ci: got objects \(int\); "):
        namespace.coscrew_inverted([2**64] * 6)
    for twin in (coscrew.double, coscrew.single):
        assert twin.coscrew_inverted(halves).tolist() == [-x for x in halves]


@pytest.mark.parametrize("namespace", (coscrew, _dispatch), ids=("compiled", "without compilation"))
def test_what_becomes_an_array_of_numbers_is_taken(namespace):
    class Foreign:
        def __array__(self, dtype=None, copy=None):
            return np.arange(6, dtype=np.float32)

    class Tagged(np.ndarray):
        pass

    c = np.arange(6.0)
    for given in ([0, 1, 2, 3, 4, 5], (0, 1.0, 2, 3, 4, 5), c.astype(">f8"), c.astype(np.uint64),
                  c.astype(np.int8), c.view(Tagged), memoryview(c), range(6)):
        result = namespace.coscrew_inverted(given)
        assert result.dtype == np.float64 and (result == -c).all()
    assert namespace.coscrew_inverted(Foreign()).dtype == np.float32
    assert namespace.coscrew_inverted(c.astype(">f4")).dtype == np.float32


@pytest.mark.parametrize("namespace", (coscrew, _dispatch), ids=("compiled", "without compilation"))
@pytest.mark.parametrize("given, error, message", (
    ((np.eye(3, 4),), TypeError, r"takes 2 arguments \(D, ci\); got 1"),
    ((np.eye(4), np.ones(6)), ValueError,
     r"D has shape \(4, 4\); its last axes must be \(3, 4\)"),
    ((np.eye(3, 4), np.ones(5)), ValueError, r"ci has shape \(5,\); its last axes must be \(6,\)"),
    ((np.ones((2, 3, 4)), np.ones((3, 6))), ValueError,
     r"leading axes \[\(2,\), \(3,\)\] do not broadcast")))
def test_shapes_are_named(namespace, given, error, message):
    with pytest.raises(error, match=f"^product_CoAdc: {message}$"):
        namespace.product_CoAdc(*given)


@pytest.mark.parametrize("namespace", (coscrew, _dispatch), ids=("compiled", "without compilation"))
def test_dtype_chooses_the_precision(namespace):
    c, narrow = np.arange(6) / 7, (np.arange(6) / 7).astype(np.float32)
    for given in (c, narrow, c.tolist()):
        for dtype in (np.float32, "float32", np.float64, float):
            result = namespace.axpy_cc(0.1, given, given, dtype=dtype)
            module = coscrew.single if np.dtype(dtype) == np.float32 else coscrew.double
            assert result.dtype == dtype
            assert result.tobytes() == module.axpy_cc(0.1, given, given).tobytes()
    with pytest.raises(TypeError, match="coscrew_inverted"):
        namespace.coscrew_inverted(c, dtype=np.float16)


def test_single_takes_doubles_within_its_range():
    c = np.array([1e30, 1.0, 0.1, 1e-60, np.inf, np.nan])
    result = coscrew.single.coscrew_copy(c)
    assert result.dtype == np.float32
    assert result.tobytes() == c.astype(np.float32).tobytes()
    c[0] = -1e39
    with pytest.raises(ValueError, match=r"^coscrew_copy: ci: got a number of magnitude 1e\+39; "
                                         "the largest in float32 is 3.402823"):
        coscrew.single.coscrew_copy(c)


def test_gufuncs_are_still_numpys():
    f = coscrew.product_CoAdc
    D, c = np.eye(3, 4), np.arange(6.0)
    assert isinstance(f, np.ufunc) and f.signature == "(3,4),(6)->(6)"
    assert sorted(f.types) == ["dd->d", "ff->f"]
    out = np.zeros((6,))
    assert f(D, c, out) is out and f(D, c, out=(out,)) is out and (out == c).all()
    assert f(D, c, dtype=np.float32).dtype == f(D, c, signature="ff->f").dtype == np.float32
    assert f(D, c.astype(np.longdouble), dtype=float).dtype == float  # as asked
    assert f(*(D, c), axes=[(0, 1), 0, 0]).tolist() == c.tolist()
    assert f(D[:, :, None], c[:, None], axes=[(0, 1), 0, 0]).shape == (6, 1)
    with pytest.raises(TypeError, match="unexpected keyword argument 'where_'"):
        f(D, c, where_=True)
    assert pickle.loads(pickle.dumps(f)) is f


def test_errors_of_others_are_left_alone():
    class Stubborn:
        def __array_ufunc__(self, *arguments, **options):
            raise LookupError("mine")

        def __array__(self, dtype=None, copy=None):
            raise AssertionError("never asked")

    class Silent:
        __array_ufunc__ = None

    with pytest.raises(LookupError, match="^mine$"):
        coscrew.coscrew_inverted(Stubborn())
    with pytest.raises(TypeError, match="does not support ufuncs"):
        coscrew.coscrew_inverted(Silent())
    with np.errstate(all="raise"), pytest.raises(FloatingPointError):
        coscrew.coscrew_scale(np.full(6, 1e200), 1e200)


@pytest.mark.parametrize("tier", PACKAGES[1:])
def test_operations_without_a_tier_are_told(tier):
    name = re.escape(tier.__name__)
    other = "'vec3_copy'; coscrew.vec3_copy is there"
    with pytest.raises(AttributeError, match=f"^{name} has no {other}"):
        tier.vec3_copy
    with pytest.raises(AttributeError, match=f"^{name} has no 'SO3_xep'$"):
        tier.SO3_xep
