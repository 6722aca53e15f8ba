"""Errors of runs: those of a linear oscillator are known, its steps being powers of a matrix; a run
in the certified tier is the compiled one; numbers are MPFR's."""

import math
import re
from dataclasses import replace

import mpmath
import numpy as np
import pytest
from gmpy2 import mpfr
from mpmath import matrix, mpf

from coscrew_codegen.algebra.recording.recorder import array
from coscrew_codegen.program import Op, Program
from coscrew_codegen.program.in_python import FLOATS, in_python
from coscrew_codegen.program.interpreter import interpreter
from coscrew_codegen.program.multiprecise import MULTIPRECISE, precise
from coscrew_codegen.program.program import Constant, Input, Instruction, NotANumber, Ref
from coscrew_codegen.program.values.formats import BY_NAME, DOUBLE, PRECISIONS, SINGLE
from coscrew_codegen.reports.cost.figures.cost_page import of_run
from coscrew_codegen.reports.cost.run_errors import (
    DIGITS,
    RunError,
    RunErrors,
    _Compared,
    _Steps,
    run_errors,
)
from coscrew_codegen.runtime.load import Kernels
from coscrew_codegen.scene.integrators import named
from coscrew_codegen.simulation.plan import plan
from coscrew_codegen.simulation.run_summary import RunOverrides
from coscrew_codegen.simulation.system import system
from tests.support.scenes import scene_texts as texts
from tests.support.scenes.selecting import checked

H, UNTIL = 2.0**-7, 0.5
STEPS = int(UNTIL / H)
BOUNCING = """precision = "both"
[bodies.ball]
mass = 1
[joints.slide]
type = "prismatic"
child = "ball"
axis = [0, 0, 1]
limits = { lower = 0, upper = 2 }
[start.q]
slide = 0.01
[effects.gravity]
[effects.limit]
joints = ["slide"]
k = 2000
[effects.actuator]
kind = "pd"
joints = ["slide"]
kp = 10
target = "0.1*sin(pi*t)"
[run]
duration = 0.25
step = 0.0078125
"""


@pytest.fixture(scope="module")
def spring(tmp_path_factory: pytest.TempPathFactory) -> Kernels:
    path = tmp_path_factory.mktemp("spring") / "spring.toml"
    path.write_text(texts.SPRING)
    return checked(path)


def overrides(**other: str) -> RunOverrides:
    return RunOverrides(until=UNTIL, step=H, **other)


@pytest.fixture(scope="module")
def errors(spring: Kernels) -> RunErrors:
    errors = run_errors(spring, overrides(), (("accurate", DOUBLE), ("pairs", SINGLE)))
    assert errors and errors.whole
    return errors


def linear(h: mpf, steps: int) -> tuple[mpf, mpf]:
    """q and v after steps of the classical Runge-Kutta method: powers of Σ (h A)^k / k!, k ≤ 4."""
    m, k, d = (mpf(x) for x in (texts.MASS, texts.STIFFNESS, texts.DAMPING))
    A = h * matrix([[0, 1], [-k / m, -d / m]])
    once = sum((A**n / mpmath.factorial(n) for n in range(1, 5)), mpmath.eye(2))
    return tuple(once**steps * matrix([mpf(0.1), 0]))


def test_rounding_and_step_of_a_linear_oscillator(spring: Kernels, errors: RunErrors):
    marks = range(1, STEPS + 1)
    assert errors.times == tuple(n * H for n in marks) and errors.integrator == "rk4"
    with mpmath.workdps(DIGITS):
        exact = [linear(mpf(H), n)[0] for n in marks]
        fine = [linear(mpf(H) / 4, 4 * n)[0] for n in marks]
        by_cause = {(x.cause, x.of): x.errors for x in errors.rows}
        assert by_cause["step", f"{H:g} s"] == pytest.approx(
            [float(abs(x - y)) for x, y in zip(exact, fine, strict=True)], rel=1e-12)
        for name in BY_NAME:
            its = system(spring, name)
            ends = [its.stepper("step_rk4")(n, 0, H, *its.start())[0] for n in marks]
            assert by_cause["rounding", f"{name} plain"] == pytest.approx(
                [float(abs(mpf(float(q[0])) - x)) for q, x in zip(ends, exact, strict=True)],
                rel=1e-12)


def test_an_effect_left_out_is_its_share(errors: RunErrors):
    """Without its spring and damper the mass stays where it is."""
    bare = next(x for x in errors.rows if x.of == "bare")
    with mpmath.workdps(DIGITS):
        moved = [float(abs(linear(mpf(H), round(t / H))[0] - mpf(0.1))) for t in errors.times]
    assert bare.cause == "model" and bare.errors == pytest.approx(moved, rel=1e-12)


def test_tiers_round_as_much_as_their_precision(errors: RunErrors):
    """An accurate step rounds the state once a call, so its error is of the size of plain's."""
    by_cause = {x.of: max(x.errors) for x in errors.rows if x.cause == "rounding"}
    assert list(by_cause) == ["double plain", "single plain", "double accurate", "single pairs"]
    assert 2.0**-58 < by_cause["double accurate"] < 2 * by_cause["double plain"] < 2.0**-48
    assert 2.0**-29 < by_cause["single pairs"] < 2 * by_cause["single plain"] < 2.0**-19


@pytest.mark.parametrize("precision", PRECISIONS, ids=lambda x: x.name)
@pytest.mark.parametrize("name", ("spring", "ball"))
def test_a_run_in_the_certified_tier_is_the_compiled_one(request, tmp_path, name, precision):
    """Certified functions return plain's results: call by call the same bits, in split steps, too.
    """
    path = tmp_path / "ball.toml"
    path.write_text(BOUNCING)
    kernels = checked(path) if name == "ball" else request.getfixturevalue("spring")
    given = RunOverrides() if name == "ball" else overrides()
    planned = plan(system(kernels, "double"), given.until, given.step, given.integrator)
    step = next(x for x in kernels.functions.steps
                if x.name == named(planned.integrator).step_name)
    run, marks = _Steps(kernels, given, planned, step), [3, 17, 32]
    pairs = zip(run.in_tier("certified", precision, marks), run.compiled(precision, marks),
                strict=True)
    for state, wanted in pairs:
        for x, y in zip(state, wanted, strict=True):
            assert np.array(x, precision.numpy_type).tobytes() == np.array(y).tobytes()


def test_split_steps_of_a_bounce_round_little(tmp_path):
    """The ball bounces within the run: its steps are taken in parts, also with 40 digits."""
    path = tmp_path / "ball.toml"
    path.write_text(BOUNCING)
    kernels = checked(path)
    errors = run_errors(kernels, RunOverrides(), ())
    assert errors and errors.whole and named(errors.integrator).splits
    by_cause = {x.of: x.errors for x in errors.rows}
    assert max(by_cause["double plain"]) < 1e-12 < max(by_cause["single plain"]) < 1e-4
    assert by_cause["without limit"][-1] > 0.05  # it falls
    each = sum(len(kernels.functions.named(x.function).program.instructions)
               for x in kernels.functions.steps[0].calls)
    early = run_errors(kernels, RunOverrides(), (), most=5 * 32 * each)
    assert early and not early.whole  # parts of steps are counted, too


def test_few_instructions_end_the_run_early(spring: Kernels, errors: RunErrors):
    early = run_errors(spring, overrides(), (), most=5000)
    assert early and early.times[-1] < UNTIL == errors.times[-1]
    text = of_run(early).notes[0]
    assert re.search(r"the first 0\.\d+ s of 0\.5 s: more .* 0\.005 million instructions", text)
    assert "the whole 0.5 s" in of_run(errors).text() and "t = 0.5 s" in of_run(errors).text()
    assert "rounding: single pairs" in of_run(errors).text()


# when digits are gone

@pytest.mark.parametrize("size, error, gone", (
    (0.5, 0.04, None), (0.5, 0.06, 0.75), (100, 0.3, None), (100, 0.35, 0.75)))
def test_digits_are_gone_from_a_tenth_of_the_motion_or_of_half_a_turn(
        tmp_path, size, error, gone):
    path = tmp_path / "pendulum.toml"
    path.write_text(texts.PENDULUM)
    its = system(checked(path), "double")
    exact = [([mpfr(x)], [mpfr(0)]) for x in (0, -size, size / 2, 0)]
    off = [([float(q[0]) + x], v) for (q, v), x in zip(exact, (0, error / 2, -error, 0),
                                                       strict=True)]
    row = _Compared(its, (0.25, 0.5, 0.75, 1.0), exact).row("rounding", "double plain", off)
    assert row.gone == gone and row.errors == pytest.approx((0, error / 2, error, 0), abs=1e-13)


def test_the_table_says_when_digits_are_gone():
    def row(cause: str, of: str, *errors: float, gone: float | None = None) -> RunError:
        return RunError(cause, of, errors, gone)

    times = (1.0, 2.0, 3.0, 4.0)
    errors = RunErrors("rk4", 1e-3, 4.0, times, (
        row("rounding", "double plain", 1e-15, 1e-14, 1e-13, 1e-12),
        row("rounding", "single plain", 1e-6, 1e-3, 1, 3, gone=3.0),
        row("step", "0.001 s", 1e-9, 1e-8, 1e-7, 1e-6)), 10**6)
    table = of_run(errors)
    assert [x[-1] for x in table.rows] == ["", "from 3 s", ""]
    assert table.notes[2:] == (
        "In double precision rounding moves the run by at most 1e-12, the step by 1e-6: shorter "
        "steps would be more accurate.",
        "In single precision until t = 2 s rounding moves the run by at most 0.001, the step by "
        "1e-8: shorter steps would gain nothing.")
    at_once = of_run(replace(errors, rows=(
        row("rounding", "single plain", 1, 1, 1, 1, gone=1.0), *errors.rows[2:])))
    assert at_once.notes[2:] == ()


# numbers

def test_programs_in_python_are_those_of_the_interpreter(spring: Kernels):
    """On many digits and on floats, for all functions of the oscillator and its steps."""
    draw = np.random.default_rng(1)
    for function in spring.functions.functions:
        program = function.program
        given = [draw.normal(size=max(a.quantity.size, 1)).tolist() for a in program.inputs]
        assert in_python(program, FLOATS)(given) == interpreter(program, FLOATS)(given)
        with precise(DIGITS) as context:
            assert context.precision > DIGITS * math.log2(10)
            numbers = [[mpfr(x) / 3 for x in part] for part in given]
            errors = in_python(program, MULTIPRECISE)(numbers)
            assert errors == interpreter(program, MULTIPRECISE)(numbers)
            assert {x.precision for x in errors} == {context.precision}


@pytest.mark.parametrize("arithmetic", (MULTIPRECISE, FLOATS), ids=("40 digits", "floats"))
def test_what_has_no_value_is_infinite_or_nan_as_in_c(arithmetic):
    """1/0, -1/0, 0/0, √-1, exp 1e300, and a product with the infinite one; nothing is raised."""
    one, zero = Input(0, 0), Input(0, 1)
    steps = (("a", Op.DIV, (one, zero)), ("n", Op.NEG, (one,)), ("b", Op.DIV, (Ref("n"), zero)),
             ("c", Op.DIV, (zero, zero)), ("d", Op.SQRT, (Ref("n"),)),
             ("h", Op.MUL, (Constant(10**300, 10**30), one)), ("e", Op.EXP, (Ref("h"),)),
             ("f", Op.MUL, (Ref("a"), zero)))
    program = Program("none", (array("x", (2,)),), (array("y", (7,)),), tuple(
        Instruction(name, op, operands, "y") for name, op, operands in steps),
        tuple(map(Ref, "abcdef")) + (NotANumber(),))
    with precise(DIGITS), np.errstate(all="ignore"):
        number = float if arithmetic is FLOATS else mpfr
        for make in (in_python, interpreter):
            a, b, c, d, e, f, g = map(float, make(program, arithmetic)([[number(1), number(0)]]))
            assert (a, b, e) == (math.inf, -math.inf, math.inf)
            assert all(map(math.isnan, (c, d, f, g)))


def test_scipys_integrators_have_no_steps(spring: Kernels):
    assert run_errors(spring, overrides(integrator="dop853"), ()) is None
