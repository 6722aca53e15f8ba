"""KSL's functions of arrays, its angles that go on, and its matrix in the other precision.

The truth is exact fractions, and arctangents in 60 digits.
"""

import ctypes
from fractions import Fraction
from pathlib import Path

import mpmath as mp
import numpy as np
import pytest

from coscrew_codegen.program.values.formats import Precision
from tests.support.compiled.c_harness import C11, COMPILERS, EXACT, INCLUDE, STRICT, run
from tests.support.each import each_precision

SOURCE = Path(__file__).with_name("ksl_arrays.c")
PI = np.pi
CLOSE = Fraction(1, 10**6)


@pytest.fixture(scope="module", params=COMPILERS)
def functions(request, tmp_path_factory) -> ctypes.CDLL:
    """The functions of tests/peers/ksl_arrays.c."""
    library = tmp_path_factory.mktemp("ksl") / "arrays.so"
    run((request.param, *C11, "-O2", *STRICT, EXACT, "-fPIC", "-shared", "-I", INCLUDE, SOURCE,
         "-o", library, "-lm"))
    return ctypes.CDLL(str(library))


def call(functions: ctypes.CDLL, name: str, precision: Precision, *arguments, real=False):
    """Calls the function of this name and precision; floats are numbers, lists arrays."""
    function = getattr(functions, f"{name}_{precision.c_type}")
    number = {"double": ctypes.c_double, "float": ctypes.c_float}[precision.c_type]
    function.restype = number if real else ctypes.c_int
    return function(*(x.ctypes.data_as(ctypes.c_void_p) if isinstance(x, np.ndarray) else
                      x if isinstance(x, int) else number(x) for x in arguments))


def array(precision: Precision, x) -> np.ndarray:
    return np.array(x, precision.numpy_type)


def unit(precision: Precision) -> Fraction:
    return Fraction(float(np.finfo(precision.numpy_type).eps)) / 2


def pairs_about_the_limit(precision: Precision):
    """Numbers of every size and sign, and others that differ by about a millionth of them."""
    rng = np.random.default_rng(7)
    for n in range(4000):
        a = rng.choice((-1, 1)) * 10.0**rng.uniform(-9, 9 if n % 3 else 30)
        off = 1e-6 * max(abs(a), 1) * rng.choice((0.5, 1 - 1e-3, 1, 1 + 1e-3, 2, 1e6))
        yield array(precision, [a]), array(precision, [a + rng.choice((-1, 1)) * off])


@each_precision
def test_close_is_a_millionth_of_the_first_or_of_one(precision, functions):
    decided, u = {0: 0, 1: 0}, unit(precision)
    for a, b in pairs_about_the_limit(precision):
        x, y = Fraction(float(a[0])), Fraction(float(b[0]))
        off = abs(x - y) / max(abs(x), 1)
        if abs(off - CLOSE) > 4 * u * CLOSE:  # else the function's roundings decide
            result = call(functions, "close", precision, 1, a, b)
            assert result == (off <= CLOSE), (a[0].hex(), b[0].hex())
            decided[result] += 1
    assert min(decided.values()) > 1000


@each_precision
def test_every_pair_must_be_close(precision, functions):
    ones = array(precision, np.ones(7))
    for place in range(7):
        other = ones.copy()
        other[place] = 1.01
        for count in range(8):
            result = call(functions, "close", precision, count, ones, other)
            assert result == (count <= place)
    assert call(functions, "close", precision, -1, ones, 2 * ones) == 1


@each_precision
def test_infinities_are_close_to_themselves_and_nan_to_nothing(precision, functions):
    largest = np.finfo(precision.numpy_type).max
    numbers = (0.0, 1.0, largest, -largest, np.inf, -np.inf, np.nan)
    for a in numbers:
        for b in numbers:
            result = call(functions, "close", precision, 1, array(precision, [a]),
                          array(precision, [b]))
            assert result == (a == b), (a, b)


def test_integers_are_close_if_equal(functions):
    a = np.arange(-3, 4, dtype=np.intc)
    for place in range(7):
        b = a.copy()
        b[place] += 1
        for count in range(8):
            result = functions.equal_int(count, a.ctypes.data_as(ctypes.c_void_p),
                                         b.ctypes.data_as(ctypes.c_void_p))
            assert result == (count <= place)


def ends(precision: Precision) -> tuple[np.ndarray, np.ndarray]:
    """Ends of every size: alike, equal, of both signs, the largest numbers, zeros."""
    rng, largest = np.random.default_rng(5), float(np.finfo(precision.numpy_type).max)
    sizes = 10.0**rng.uniform(-8, 8, (2, 400)) * rng.choice((-1, 1), (2, 400))
    a, b = sizes
    near = a * (1 + rng.uniform(-1e-4, 1e-4, 400))
    special = [(largest, -largest), (-largest, largest), (largest, largest / 2), (0, -1), (1, 0),
               (0.1, 0.1), (1e30, 1), (1, 1e30), (-0.3, -0.3)]
    first, last = zip(*special, strict=True)
    return array(precision, [*a, *a, *first]), array(precision, [*b, *near, *last])


@each_precision
def test_numbers_between_two_err_by_3_u(precision, functions):
    a, b = ends(precision)
    rng, least = np.random.default_rng(6), Fraction(2)**precision.least_exponent
    for p in array(precision, [*rng.uniform(0, 1, 12), 1e-12, 0.5, 1 - 1e-7, 2e-10]):
        result = np.full_like(a, np.nan)
        call(functions, "lerp", precision, len(a), float(p), a, b, result)
        for x, y, z in zip(a, b, result, strict=True):
            k, first, last, between = (Fraction(float(number)) for number in (p, x, y, z))
            left, right = (1 - k) * first, k * last
            bound = 3 * unit(precision) * (abs(left) + abs(right)) * (1 + 8 * unit(precision))
            assert abs(between - left - right) <= bound + least, (x.hex(), y.hex(), p.hex())
            assert x != y or z == x


@each_precision
def test_ends_are_reached_exactly_and_not_left(precision, functions):
    a, b = ends(precision)
    for p, want in ((0.0, a), (-0.5, a), (-np.inf, a), (1.0, b), (1.5, b), (np.inf, b)):
        result = np.full_like(a, np.nan)
        call(functions, "lerp", precision, len(a), p, a, b, result)
        assert result.tobytes() == want.tobytes()
    result = a[:3].copy()
    call(functions, "lerp", precision, 2, np.nan, a, b, result)
    assert np.isnan(result[:2]).all() and result[2] == a[2]


@each_precision
def test_interpolation_works_in_place(precision, functions):
    a, b = ends(precision)
    apart, first, last = np.empty_like(a), a.copy(), b.copy()
    call(functions, "lerp", precision, len(a), 0.3, a, b, apart)
    call(functions, "lerp", precision, len(a), 0.3, first, b, first)
    call(functions, "lerp", precision, len(a), 0.3, a, last, last)
    assert apart.tobytes() == first.tobytes() == last.tobytes()


@each_precision
def test_the_largest_magnitude_is_found(precision, functions):
    """The first one of several; NaN counts as less than every number."""
    rng = np.random.default_rng(9)
    nan = np.nan
    lists = [rng.integers(-4, 5, rng.integers(1, 9)).astype(float).tolist() for _ in range(300)]
    lists += [[nan], [nan, nan], [nan, 0], [0, nan], [nan, -1, 2, nan, -2], [-np.inf, 1, np.inf]]
    for numbers in lists:
        sizes = [-1 if np.isnan(x) else abs(x) for x in numbers]
        result = call(functions, "largest", precision, len(numbers), array(precision, numbers))
        assert result == sizes.index(max(sizes)), numbers
    for count in (0, -3):
        assert call(functions, "largest", precision, count, array(precision, [1])) == -1


def points(precision: Precision):
    """(y, x, theta): points all around, thetas of every size, and next to the ends of intervals."""
    rng, real = np.random.default_rng(4), np.dtype(precision.numpy_type).type
    for n in range(1500):
        angle = rng.uniform(-PI, PI) if n % 5 else rng.choice((-PI, -PI / 2, 0, PI / 2, PI, PI / 4))
        theta = rng.uniform(-20, 20) if n % 2 else rng.choice((-1, 1)) * 10.0**rng.uniform(-3, 4)
        if n % 7 == 0:
            theta = angle + PI / 4 + PI * rng.integers(-3, 4)
        length = 10.0**rng.uniform(-20, 20)
        yield real(length * np.sin(angle)), real(length * np.cos(angle)), real(theta)


@each_precision
@pytest.mark.parametrize("name, halves", [("whole", 2), ("half", 1)])
def test_angles_go_on_next_to_theta(name, halves, precision, functions):
    u = float(unit(precision))
    with mp.workdps(60):
        turn = halves * mp.pi
        for y, x, theta in points(precision):
            result = mp.mpf(call(functions, name, precision, float(y), float(x), float(theta),
                                 real=True))
            error = result - mp.atan2(mp.mpf(float(y)), mp.mpf(float(x)))
            error -= turn * mp.nint(error / turn)
            bound = 4 * u * (abs(result) + mp.pi)
            assert abs(error) <= bound, (y.hex(), x.hex(), theta.hex())
            least = mp.mpf(float(theta)) - mp.pi / 4
            slack = bound + 4 * u * abs(float(theta))
            assert least - slack <= result <= least + turn + slack, (y.hex(), x.hex(), theta.hex())


@each_precision
def test_angles_follow_a_wheel(precision, functions):
    """Through three turns either way, by steps of less than an eighth; also where the point and its
    opposite take turns."""
    for way in (1, -1):
        whole = half = 0.0
        for n in range(200):
            angle = way * 0.1 * n
            y, x = float(np.sin(angle)), float(np.cos(angle))
            whole = call(functions, "whole", precision, y, x, whole, real=True)
            sign = -1 if n % 3 else 1
            half = call(functions, "half", precision, sign * y, sign * x, half, real=True)
            assert max(abs(whole - angle), abs(half - angle)) < 1e-5


def test_displacements_are_rounded_to_single_precision(functions):
    """Each number to the nearest, as NumPy rounds; those beyond become infinite or zero."""
    rng, m = np.random.default_rng(8), np.empty((4, 4), np.float32)
    for n in range(200):
        d = rng.normal(size=(4, 3)) * 10.0**rng.uniform(-50 if n % 2 else -3, 45 if n % 2 else 3)
        functions.to_single(d.ctypes.data_as(ctypes.c_void_p), m.ctypes.data_as(ctypes.c_void_p))
        with np.errstate(all="ignore"):
            want = np.column_stack((d.astype(np.float32), [0, 0, 0, 1])).astype(np.float32)
        assert m.tobytes() == want.tobytes()
