"""Errors of runs: those of a linear oscillator are known: its steps are powers of a matrix."""

import re

import mpmath
import pytest
from mpmath import matrix, mpf

from coscrew_codegen.cost.run_errors import DIGITS, RunErrors, run_errors
from coscrew_codegen.cost.table import of_run
from coscrew_codegen.formats import BY_NAME
from coscrew_codegen.integrators import named
from coscrew_codegen.simulate.load import Kernels
from coscrew_codegen.simulate.outcome import RunOverrides
from coscrew_codegen.simulate.system import system
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
def found(spring: Kernels) -> RunErrors:
    told = run_errors(spring, overrides())
    assert told
    return told


def linear(h: mpf, steps: int) -> tuple[mpf, mpf]:
    """q and v after steps of the classical Runge-Kutta method: powers of Σ (h A)^k / k!, k ≤ 4."""
    m, k, d = (mpf(x) for x in (texts.MASS, texts.STIFFNESS, texts.DAMPING))
    A = h * matrix([[0, 1], [-k / m, -d / m]])
    once = sum((A**n / mpmath.factorial(n) for n in range(1, 5)), mpmath.eye(2))
    return tuple(once**steps * matrix([mpf(0.1), 0]))


def test_rounding_and_step_of_a_linear_oscillator(spring: Kernels, found: RunErrors):
    marks = [STEPS // 8, STEPS // 4, STEPS // 2, STEPS]
    assert found.times == tuple(n * H for n in marks) and found.integrator == "rk4"
    with mpmath.workdps(DIGITS):
        exact = [linear(mpf(H), n)[0] for n in marks]
        fine = [linear(mpf(H) / 4, 4 * n)[0] for n in marks]
        told = {(x.cause, x.of): x.errors for x in found.rows}
        assert told["step", f"{H:g} s"] == pytest.approx(
            [float(abs(x - y)) for x, y in zip(exact, fine, strict=True)], rel=1e-12)
        for name in BY_NAME:
            its = system(spring, name)
            ends = [its.stepper("step_rk4")(n, 0, H, *its.start())[0] for n in marks]
            assert told["rounding", name] == pytest.approx(
                [float(abs(mpf(float(q[0])) - x)) for q, x in zip(ends, exact, strict=True)],
                rel=1e-12)


def test_an_effect_left_out_is_its_share(found: RunErrors):
    """Without its spring and damper the mass stays where it is."""
    bare = next(x for x in found.rows if x.of == "bare")
    with mpmath.workdps(DIGITS):
        moved = [float(abs(linear(mpf(H), round(t / H))[0] - mpf(0.1))) for t in found.times]
    assert bare.cause == "model" and bare.errors == pytest.approx(moved, rel=1e-12)


def test_split_steps_of_a_bounce_round_little(tmp_path):
    """The ball bounces within the run: its steps are taken in parts, also with 40 digits."""
    path = tmp_path / "ball.toml"
    path.write_text(BOUNCING)
    found = run_errors(checked(path), RunOverrides())
    assert found and named(found.integrator).splits
    told = {x.of: x.errors for x in found.rows}
    assert max(told["double"]) < 1e-12 < max(told["single"]) < 1e-4
    assert told["without limit"][-1] > 0.05  # it falls


def test_few_instructions_end_the_run_early(spring: Kernels, found: RunErrors):
    early = run_errors(spring, overrides(), most=5000)
    assert early and early.times[-1] < UNTIL == found.times[-1]
    assert re.search(r"the first 0\.\d+ s of 0\.5 s, .* 40 digits", of_run(early).text())
    assert "rounding: double" in of_run(found).text() and "t = 0.5 s" in of_run(found).text()


def test_scipys_integrators_have_no_steps(spring: Kernels):
    assert run_errors(spring, overrides(integrator="dop853")) is None
