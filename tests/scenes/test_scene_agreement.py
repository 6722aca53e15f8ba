"""A scene's C and NumPy compute the same bits, and the right numbers."""

import inspect
from fractions import Fraction
from types import ModuleType

import mpmath
import numpy as np
import pytest

from coscrew_codegen.backends.python_extension import scene_calls
from coscrew_codegen.runtime.load import Kernels, kernels_of
from tests.support.each import each_precision
from tests.support.scenes.generated_scenes import CASES, imported
from tests.support.scenes.scene_values import inputs, same_bits

pytestmark = pytest.mark.usefixtures("users_compiler")


@pytest.fixture(scope="module")
def scenes(tmp_path_factory: pytest.TempPathFactory) -> dict[str, tuple[Kernels, ModuleType]]:
    """Compiled kernels and the generated package of each case."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
        return {name: (kernels_of(made()), imported(made(), tmp_path_factory.mktemp(name)))
                for name, made in CASES.items()}


def both(scenes, name: str, precision: str):
    """(function, compiled, in NumPy) for each function of a case."""
    kernels, package = scenes[name]
    assert kernels.compiled
    for function in scene_calls.callables(kernels.functions):
        yield (function, getattr(getattr(kernels, precision), function.name),
               getattr(getattr(package, precision), function.name))


@pytest.mark.parametrize("lead", ((), (0,), (5,), (2, 3)), ids=str)
@pytest.mark.parametrize("case", CASES)
@each_precision
def test_bits_are_the_same(scenes, precision, case, lead):
    for function, compiled, twin in both(scenes, case, precision.name):
        for special in (False, True):
            arguments = inputs(function, precision.numpy_type, *lead, special=special)
            result, wanted = compiled(*arguments), twin(*arguments)
            assert same_bits(result, wanted), (function.name, arguments, result, wanted)


@each_precision
def test_leading_axes_broadcast(scenes, precision):
    """Rows of one call are calls for each row, whichever argument has the rows."""
    kind = precision.numpy_type
    for name in CASES:
        for function, compiled, twin in both(scenes, name, precision.name):
            batch = inputs(function, kind, 3)
            for mixed in range(2 ** len(batch)):
                some = [x if mixed >> n & 1 else x[0] for n, x in enumerate(batch)]
                row = [[x[k] if mixed >> n & 1 else x[0] for n, x in enumerate(batch)]
                       for k in range(3 if mixed else 1)]
                for call in (compiled, twin):
                    result = call(*some)
                    for k, arguments in enumerate(row):
                        one = call(*arguments)
                        assert same_bits(_row(result, k) if mixed else result, one), function.name


def _row(result, k: int):
    return tuple(x[k] for x in result) if isinstance(result, tuple) else result[k]


def test_axes_of_all_arguments_combine(scenes):
    kernels, package = scenes["slider"]
    shapes = ((4, 1, 1), (2,), (1, 3, 2), (2,), (4, 1, 2))
    arguments = [np.random.default_rng(n).normal(size=s) for n, s in enumerate(shapes)]
    arguments[0] = arguments[0][..., 0]
    result = kernels.double.forward_dynamics(*arguments)
    assert result.shape == (4, 3, 2)
    assert same_bits(result, package.double.forward_dynamics(*arguments))
    t, p, q, v, _ = arguments
    stepped = kernels.double.step_rk4(t, np.full((5, 1, 1), 0.1), p, q, v)
    assert [x.shape for x in stepped] == [(5, 4, 3, 2)] * 2
    assert same_bits(stepped, package.double.step_rk4(t, np.full((5, 1, 1), 0.1), p, q, v))


def test_strided_and_read_only_arrays_are_taken(scenes):
    kernels, _ = scenes["slider"]
    t, p, q, v, tau = inputs(scene_calls.callables(kernels.functions)[1], "float64")
    wanted = kernels.double.forward_dynamics(t, p, q, v, tau)
    apart, frozen = np.repeat(q, 2)[::2], v.copy()
    frozen.flags.writeable = False
    packed = np.zeros(17, np.uint8)[1:].view(np.float64)  # not aligned
    packed[:] = tau
    swapped = tau.astype(">f8")
    for last in (packed, swapped, tau.tolist()):
        assert same_bits(kernels.double.forward_dynamics(t, p, apart, frozen, last), wanted)


def test_results_are_new_and_arguments_stay(scenes):
    for name in CASES:
        for function, compiled, twin in both(scenes, name, "double"):
            for call in (compiled, twin):
                arguments = inputs(function, "float64")
                before = [x.copy() for x in arguments]
                value = call(*arguments)
                for result in value if isinstance(value, tuple) else (value,):
                    assert not any(np.shares_memory(result, x) for x in arguments)
                assert all(map(same_bits, before, arguments)), function.name


def test_signatures_and_words_are_the_same_in_both(scenes):
    for name in CASES:
        for function, compiled, twin in both(scenes, name, "single"):
            wanted = str(inspect.signature(twin)).replace("out=None", "out=None, threads=1")
            assert str(inspect.signature(compiled)) == wanted
            assert compiled.__name__ == twin.__name__ == function.name
            assert inspect.getdoc(compiled).split() == inspect.getdoc(twin).split()


# truths


def test_slider_is_right_in_rationals(scenes):
    """a = (τ + f) / m with exact numbers; each of at most 5 rounding errors is one of a partial
    sum."""
    kernels, _ = scenes["slider"]
    draw = np.random.default_rng(2)
    for _ in range(200):
        t, m = draw.uniform(0, 3), draw.uniform(0.5, 2)
        q, v, tau = draw.normal(size=(3, 2))
        result = kernels.double.forward_dynamics(t, [m, 0], q, v, tau)
        T, M, Q, V, TAU = (Fraction(float(t)), Fraction(float(m)), *(
            [Fraction(float(x)) for x in y] for y in (q, v, tau)))
        rub = [Fraction(3, 10) * x * abs(x) for x in V]
        push = T - 1 if T > 1 else Fraction(0)
        wanted = ((TAU[0] + push - rub[0]) / M, (TAU[1] - 50 * Q[1] - rub[1]) / 2)
        terms = ((abs(TAU[0]) + abs(push) + abs(rub[0])) / M,
                 (abs(TAU[1]) + abs(50 * Q[1]) + abs(rub[1])) / 2)
        for x, truth, size in zip(result, wanted, terms, strict=True):
            assert abs(Fraction(float(x)) - truth) <= 7 * Fraction(1, 2**53) * size


def _pendulum_at(seconds: float, q: float, v: float, length: float) -> float:
    """θ of the pendulum, in 30 digits."""
    with mpmath.workdps(30):
        g = mpmath.mpf(981) / 100 / mpmath.mpf(length)
        solution = mpmath.odefun(lambda t, y: [
            y[1], -g * mpmath.sin(y[0]) - mpmath.tanh(y[1]) * mpmath.exp(-y[1] ** 2)], 0, [q, v])
        return float(solution(seconds)[0])


@pytest.mark.parametrize("step, order", (("semi_implicit_euler", 1), ("rk4", 4)))
def test_errors_of_steps_fall_with_their_order(scenes, step: str, order: int):
    kernels, package = scenes["pendulum"]
    truth = _pendulum_at(0.5, 0.5, 0.25, 0.5)
    for functions in (kernels.double, package.double):
        errors = []
        for n in (32, 64, 128):
            q, v = np.array([0.5]), np.array([0.25])
            for _ in range(n):
                q, v = getattr(functions, f"step_{step}")(0.5 / n, [0.5], q, v)
            errors.append(abs(q[0] - truth))
        ratios = [errors[0] / errors[1], errors[1] / errors[2]]
        assert all(0.9 * 2**order < x < 1.1 * 2**order for x in ratios), ratios


def test_a_step_of_rk4_on_quaternions_has_order_four(scenes):
    """The angular momentum of a free body is constant in space; its drift falls as h^4 or faster.
    """
    kernels, _ = scenes["spinner"]
    inertia = np.array([1.0, 2.0, 3.0])

    def drift(n: int) -> float:
        q, v = np.array([0, 0, 0, 1.0]), np.array([1.0, 2.0, -0.5])
        for _ in range(n):
            q, v = kernels.double.step_rk4(1 / n, q, v)
        return float(np.abs(_turned(q, inertia * v) - inertia * [1.0, 2.0, -0.5]).max())

    errors = [drift(n) for n in (16, 32, 64)]
    assert errors[0] / errors[1] > 15 and errors[1] / errors[2] > 15, errors


def _turned(q: np.ndarray, x: np.ndarray) -> np.ndarray:
    """R(q) x."""
    u, w = q[:3], q[3]
    return x + 2 * np.cross(u, np.cross(u, x) + w * x)


def test_implicit_step_is_by_hand(scenes):
    """v' = v + h f / (m + 3/10 h), q' = q + h v', in exact rationals to 1e-15 of the terms."""
    kernels, _ = scenes["slider"]
    q, v = kernels.double.step_linear_implicit_euler(0.0, 0.5, [1.5, 0], [0.25, 0.5], [1.0, -2.0])
    f = (-Fraction(3, 10), -50 * Fraction(1, 2) + Fraction(12, 10))
    for k, mass in enumerate((Fraction(3, 2), Fraction(2))):
        moved = Fraction((1, -2)[k]) + f[k] / (mass + Fraction(3, 20)) / 2
        assert abs(Fraction(v[k]) - moved) <= 8 * Fraction(1, 2**53) * (2 + abs(f[k]))
        there = Fraction(1 + k, 4) + moved / 2
        assert abs(Fraction(q[k]) - there) <= 8 * Fraction(1, 2**53) * (3 + abs(f[k]))


def test_time_and_parameters_arrive(scenes):
    kernels, package = scenes["slider"]
    for functions in (kernels.double, package.double, kernels.single, package.single):
        still = np.zeros(2)
        for t, m, wanted in ((0.0, 1.5, 0.0), (1.0, 1.5, 0.0), (4.0, 1.5, 2.0), (4.0, 3.0, 1.0)):
            result = functions.forward_dynamics(t, [m, 0], still, still, still)
            assert result[0] == wanted
            assert result.dtype == functions.mass_matrix([m, 0], still).dtype
        assert functions.mass_matrix([m, 0], still).tolist() == [[m, 0], [0, 2]]
