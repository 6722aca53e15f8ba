"""KSL's functions that are no single formula: Euler angles, principal axes, inverses, whole turns,
loops over arrays.

The truth is products of turns in 50 digits, exact fractions, and SciPy for the convention.
"""

import ctypes
import re
from fractions import Fraction
from functools import cache
from itertools import product
from pathlib import Path

import mpmath as mp
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from coscrew_codegen.algebra.operations.formulas.euler import BACKWARD
from coscrew_codegen.backends.c.c_ksl import SEQUENCES
from coscrew_codegen.program.values.formats import PRECISIONS, Precision
from tests.support.compiled.c_harness import C11, COMPILERS, EXACT, INCLUDE, STRICT, run
from tests.support.each import each_precision

SOURCE = Path(__file__).with_name("ksl_functions.c")
ROWS = 90
PRINCIPAL = 100  # in u, as the comment says
PI = np.pi
each_sequence = pytest.mark.parametrize("number, name, axes", [
    (n, name, axes) for n, (name, axes) in enumerate(SEQUENCES)], ids=[s for s, _ in SEQUENCES])


@pytest.fixture(scope="module", params=COMPILERS)
def functions(request, tmp_path_factory) -> ctypes.CDLL:
    """The functions of tests/ksl_functions.c."""
    library = tmp_path_factory.mktemp("ksl") / "functions.so"
    run((request.param, *C11, "-O2", *STRICT, "-Wno-pedantic", EXACT, "-fPIC", "-shared", "-I",
         INCLUDE, SOURCE, "-o", library, "-lm"))
    return ctypes.CDLL(str(library))


def numbers(precision: Precision, x) -> np.ndarray:
    return np.ascontiguousarray(x, precision.numpy_type)


def call(functions: ctypes.CDLL, name: str, precision: Precision, *arguments, returned=None):
    """Calls the function of this name and precision; arrays are passed by address."""
    function = getattr(functions, f"{name}_{precision.c_type}")
    real = {"double": ctypes.c_double, "float": ctypes.c_float}[precision.c_type]
    function.restype = real if returned is float else returned
    return function(*(x.ctypes.data_as(ctypes.c_void_p) if isinstance(x, np.ndarray) else
                      real(x) if isinstance(x, (float, np.floating)) else x for x in arguments))


def unit(precision: Precision) -> float:
    return float(np.finfo(precision.numpy_type).eps) / 2


@cache
def turn(axis: int, angle: float) -> mp.matrix:
    """The rotation about x, y or z."""
    with mp.workdps(50):
        s, c, R = mp.sin(mp.mpf(angle)), mp.cos(mp.mpf(angle)), mp.eye(3)
        j, k = (axis + 1) % 3, (axis + 2) % 3
        R[j, j] = R[k, k] = c
        R[k, j], R[j, k] = s, -s
        return R


def rotation(axes: tuple[int, ...], angles) -> np.ndarray:
    """R_i(a) R_j(b) R_k(c), rounded from 50 digits to extended precision."""
    with mp.workdps(50):
        a, b, c = (turn(axis, float(angle)) for axis, angle in zip(axes, angles, strict=True))
        R = a * b * c
        return np.array([[np.longdouble(mp.nstr(R[i, j], 25)) for j in range(3)]
                         for i in range(3)])


def set_from(functions, precision, number: int, angles) -> np.ndarray:
    R = np.empty((3, 3), precision.numpy_type)
    call(functions, "set", precision, number, numbers(precision, angles), R)
    return R.T


def get_from(functions, precision, number: int, R, reference=None) -> np.ndarray:
    angles = np.empty(3, precision.numpy_type)
    given = None if reference is None else numbers(precision, reference)
    call(functions, "get", precision, number, numbers(precision, R.T), given, angles)
    return angles


def lock_of(axes: tuple[int, ...]) -> tuple[float, ...]:
    """Middle angles of gimbal lock."""
    return (0.0, PI) if axes[0] == axes[2] else (PI / 2, -PI / 2)


def angles_of(axes: tuple[int, ...], seed: int) -> np.ndarray:
    """Any angles; gimbal lock, and 1e-1 … 1e-17 from it."""
    rng = np.random.default_rng([seed, *axes])
    angles = rng.uniform(-PI, PI, (ROWS, 3))
    near = 10.0**-rng.uniform(1, 17, ROWS) * rng.choice((-1, 0, 1), ROWS)
    middle = rng.choice(lock_of(axes), ROWS) + near
    angles[:, 1] = np.where(np.arange(ROWS) % 3, middle, angles[:, 1])
    return angles


@each_precision
@each_sequence
def test_turns_are_about_the_bodys_axes(number, name, axes, precision, functions):
    for row in angles_of(axes, 1)[:30]:
        given = numbers(precision, row)
        result = set_from(functions, precision, number, given)
        assert np.abs(result - rotation(axes, given)).max() <= 4 * unit(precision), row
        theirs = Rotation.from_euler(name, given.astype(float)).as_matrix()  # capitals: intrinsic
        assert np.abs(result - theirs).max() <= 4 * unit(precision) + 1e-15


@each_precision
@each_sequence
def test_angles_turn_to_the_rotation_near_gimbal_lock_too(number, name, axes, precision, functions):
    """In addition to the error of R's rounded entries: half an ulp each, so u."""
    worst = 0.0
    for row in angles_of(axes, 2):
        R = rotation(axes, row).astype(precision.numpy_type)
        result = get_from(functions, precision, number, R)
        worst = max(worst, float(np.abs(rotation(axes, result) - R).max()))
    # angles up to 7/4 π are rounded to u 2^2; the matrix follows by as much.
    assert worst <= (BACKWARD + 8) * unit(precision), worst / unit(precision)


@each_precision
@each_sequence
def test_angles_are_next_to_the_reference(number, name, axes, precision, functions):
    """Within KSL's windows, from the reference z in [-1/8, 3/8) of a turn and x, y in [-1/8, 7/8),
    there is one triple; so these are KSL's numbers."""
    rng, slack = np.random.default_rng(number), 1e4 * unit(precision)
    for row in rng.uniform(-PI, PI, (ROWS, 3)):
        near = rng.uniform(-20, 20, 3) if rng.random() < 0.7 else np.zeros(3)
        reference = None if not near.any() else near
        R = rotation(axes, row).astype(precision.numpy_type)
        result = get_from(functions, precision, number, R, reference)
        less = np.array(result, float) - near
        assert (less >= -PI / 4 - slack).all() and (less[:2] <= 7 * PI / 4 + slack).all()
        assert less[2] <= 3 * PI / 4 + slack
        assert np.abs(rotation(axes, result) - R).max() <= 100 * unit(precision)


@each_sequence
def test_small_angles_come_back(number, name, axes, functions):
    for precision in PRECISIONS:
        angles = numbers(precision, (0.2, 0.3, 0.4))
        R = set_from(functions, precision, number, angles)
        for reference in (None, (0.21, 0.31, 0.41)):
            result = get_from(functions, precision, number, R, reference)
            assert np.abs(result - angles).max() <= 20 * unit(precision)


def test_sequences_that_are_none_give_no_numbers(functions):
    for precision in PRECISIONS:
        assert np.isnan(set_from(functions, precision, len(SEQUENCES), (1, 2, 3))).all()
        R = numbers(precision, np.eye(3))
        assert np.isnan(get_from(functions, precision, len(SEQUENCES), R)).all()


def test_sequences_and_axes_belong_to_each_other(functions):
    table = {axes: number for number, (_, axes) in enumerate(SEQUENCES)}
    for axes in product(range(-1, 4), repeat=3):
        assert functions.sequence_of(*axes) == table.get(axes, len(SEQUENCES))
    for number, (_, axes) in enumerate(SEQUENCES):
        assert tuple(functions.axes_of(number, i) for i in range(3)) == axes


# matrices


def exact(x: np.ndarray) -> np.ndarray:
    return np.vectorize(lambda y: Fraction(float(y)), otypes=[object])(x)


def symmetric_matrices(precision: Precision):
    """Matrices with eigenvalues far apart, close, equal, of very different sizes; diagonal
    matrices."""
    rng = np.random.default_rng(precision.bytes)
    for n in range(120):
        Q, _ = np.linalg.qr(rng.normal(size=(3, 3)))
        values = ((3, 2, 1), (1, 1 + 1e-6, 1), (5, 5, 5), (1, 1e-8, 1e-16), (2, -1, 0),
                  (7, 1e-3, 7))[n % 6]
        A = Q * np.array(values) @ Q.T if n % 5 else np.diag(rng.permutation(values).astype(float))
        A = (A * 2.0**rng.integers(-30, 30)).astype(precision.numpy_type)
        yield np.tril(A) + np.tril(A, -1).T


@each_precision
def test_principal_axes(precision, functions):
    header, u = (INCLUDE / "ksl/mat3x3.h").read_text("utf-8"), Fraction(unit(precision))
    assert len(re.findall(rf"<= {PRINCIPAL} u", header)) == 4
    for A in symmetric_matrices(precision):
        D, v = A.copy(), np.empty_like(A)
        call(functions, "pca", precision, D, v)  # both column by column
        V, d = exact(v.T), np.diag(D)
        assert not (D - np.diag(d)).any() and (np.diff(d) <= 0).all()
        residual = np.abs(V @ np.diag(exact(d)) @ V.T - exact(A)).max()
        assert residual <= PRINCIPAL * u * exact(np.abs(A)).max()
        assert np.abs(V.T @ V - np.eye(3, dtype=int)).max() <= PRINCIPAL * u
        assert abs(np.linalg.det(v.astype(float)) - 1) < 1e-5
        assert np.allclose(d, np.linalg.eigvalsh(A.astype(float))[::-1], rtol=0,
                           atol=3 * PRINCIPAL * float(u) * float(np.abs(A).max()))


@each_precision
def test_inverses_are_right_or_refused(precision, functions):
    rng, refused = np.random.default_rng(5), 0
    for n in range(200):
        R = rng.integers(-3, 4, (3, 3)).astype(precision.numpy_type)
        if n % 4 == 0:  # no leading entry to divide by
            R = np.eye(3, dtype=R.dtype)[rng.permutation(3)]
        singular = exact_determinant(R) == 0
        result = np.ascontiguousarray(R.T)
        answer = call(functions, "invert", precision, result, returned=ctypes.c_int)
        assert answer == (-3 if singular else 0)
        refused += singular
        if singular:
            assert np.isnan(result).all()
        else:
            error = np.abs(exact(R) @ exact(result.T) - np.eye(3, dtype=int)).max()
            assert error <= 200 * Fraction(unit(precision))
    assert refused > 3


@each_precision
def test_size_refuses_no_inverse(precision, functions):
    """Determinants that underflow or overflow are no reason to refuse."""
    info = np.finfo(precision.numpy_type)
    for exponent in range(1 - info.maxexp, info.maxexp - 2, 5):
        R = np.ldexp(np.array([[0.0, 2, 0], [0, 0, -1], [1, 0, 0]]), exponent)
        result = np.ascontiguousarray(R.T, precision.numpy_type)
        assert call(functions, "invert", precision, result, returned=ctypes.c_int) == 0
        assert np.array_equal(R @ result.T, np.eye(3))
    for x in (0, np.inf, np.nan):
        result = numbers(precision, np.diag([1, x, 1]))
        assert call(functions, "invert", precision, result, returned=ctypes.c_int) == -3


def exact_determinant(R: np.ndarray) -> Fraction:
    a, b, c = exact(R)
    return a @ np.cross(b, c)


@each_precision
def test_any_axis_turns(precision, functions):
    """An axis of any length; at half a turn, where KSL's own axis is wrong, too."""
    rng = np.random.default_rng(3)
    for n in range(60):
        axis = rng.normal(size=3) * 10.0**rng.uniform(-3, 3)
        angle = PI if n % 3 == 0 else rng.uniform(0, PI)
        R, result = np.empty((3, 3), precision.numpy_type), np.empty(4, precision.numpy_type)
        call(functions, "axis_angle", precision, numbers(precision, axis), angle, R, result)
        a = axis / np.linalg.norm(axis)
        wanted = Rotation.from_rotvec(a * angle).as_matrix()
        assert np.abs(R.T - wanted).max() <= 12 * unit(precision) + 1e-15
        back = Rotation.from_rotvec(result[:3] * float(result[3])).as_matrix()
        assert np.abs(back - wanted).max() <= 40 * unit(precision) + 1e-15


# numbers


def angles_around(precision: Precision, turn_: float) -> list[np.floating]:
    """Angles of every size; whole turns, and angles next to them."""
    rng, info = np.random.default_rng(1), np.finfo(precision.numpy_type)
    real = np.dtype(precision.numpy_type).type
    turns = [real(turn_ * n) for n in (-1000, -3, -2, -1, 0, 1, 2, 3, 17, 1000, 2**20)]
    return [*rng.uniform(-1000, 1000, 200).astype(real), *turns,
            *(np.nextafter(x, real(to)) for x in turns for to in (-np.inf, np.inf)),
            *map(real, (-1e-20, 1e-20, -0.0, 1e5, 1e15, -1e15)),
            *(rng.choice((-1, 1), 300) * 2.0**rng.uniform(0, 60, 300)).astype(real),
            info.max, -info.max]


@each_precision
def test_degrees_are_exact(precision, functions):
    """Except for one rounding of negative ones."""
    real = np.dtype(precision.numpy_type).type
    for angle in angles_around(precision, 360):
        result = call(functions, "degrees", precision, angle, returned=float)
        truth = Fraction(float(angle)) % 360
        assert 0 <= result < 360 and not np.signbit(result)
        half = Fraction(float(np.spacing(real(truth.numerator / truth.denominator)))) / 2
        near = truth - 360 if result == 0 and truth > 359 else truth
        assert abs(Fraction(result) - near) <= (0 if angle >= 0 else half)


@each_precision
def test_whole_turns_are_taken_away(precision, functions):
    """Multiples of the number 2 π itself, as the header's comment says."""
    real = np.dtype(precision.numpy_type).type
    off, growth = {"double": (1.2e-15, 2e-32), "single": (8e-7, 7e-15)}[precision.name]
    header = (INCLUDE / "ksl/trig.h").read_text()
    assert f"error <= {off:g} + {growth:g} |angle|".replace("e-0", "e-") in header
    with mp.workdps(400):
        turn_ = 2 * mp.pi
        for angle in angles_around(precision, 2 * PI):
            result = call(functions, "radians", precision, angle, returned=float)
            assert 0 <= result < turn_ and not np.signbit(result)
            error = mp.mpf(result) - mp.mpf(float(angle))
            error -= turn_ * mp.nint(error / turn_)
            assert abs(error) <= off + growth * abs(float(angle)), (angle, float(error))
            assert result == angle or not 0 <= angle < real(2 * PI)


@each_precision
def test_rows_and_columns_are_copied(precision, functions):
    assert call(functions, "moves", precision, returned=ctypes.c_int) == 0
    assert functions.integers() == 0


@each_precision
def test_multiples_are_added(precision, functions):
    rng = np.random.default_rng(2)
    x, y = (rng.normal(size=9).astype(precision.numpy_type) for _ in range(2))
    a = np.dtype(precision.numpy_type).type(0.3)
    result = y.copy()
    call(functions, "axpy", precision, 8, a, x, result)
    assert (result[:8] == a * x[:8] + y[:8]).all() and result[8] == y[8]
