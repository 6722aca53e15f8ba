"""The accurate tier where intermediate results have lost all digits, or are of huge angles, though
the results are well-conditioned: right to one unit of the last digit below a condition of 1e13."""

from collections.abc import Sequence
from pathlib import Path
from typing import TypeAlias

import numpy as np
from gmpy2 import mpfr

from coscrew_codegen.program import Program
from coscrew_codegen.program.interpreter import interpreter
from coscrew_codegen.program.multiprecise import MULTIPRECISE, precise
from coscrew_codegen.runtime.load import Kernels, kernels_for
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.limits import LARGEST_CONDITION
from tests.support.scenes.tiers import components
from tests.support.truth.condition import conditions

Given: TypeAlias = list[np.ndarray]
DIGITS, LARGEST = 120, LARGEST_CONDITION["double"]
GEARED = """
name = "geared"
tiers = ["accurate"]
functions = ["inverse_dynamics", "forward_dynamics"]
[bodies]
arm = { mass = 0.1, com = [0.01, -0.02, 0.03], inertia = [0.011, 0.010, 0.010, 1e-4, -2e-4, 3e-4] }
rotor = { mass = 1e-3, com = [0.1, 0.1, 0.1], inertia = [1e-6, 2e-6, 1.7e-6] }
[joints.elbow]
type = "revolute"
child = "arm"
axis = [1, 2, 3]
origin = { xyz = [0.1, 0.2, 0.3], rpy = [0.1, -0.7, 2.3] }
[joints.gear]
type = "revolute"
parent = "arm"
child = "rotor"
axis = [0, 1, 1]
origin = { xyz = [0.1, 0, 0], axis = [1, 1, 0], angle = 1.2 }
mimic = { joint = "elbow", multiplier = MULTIPLIER, offset = 0.3 }
[effects.mimic]
"""
SLIDING = """
[bodies.load]
mass = 7.8
com = [0.2, 0.11, 0]
inertia = [0.018, 0.160, 0.158]
[bodies.tool]
mass = 3.3
com = [0, 0, -0.1]
inertia = [0.01, 0.02, 0.02, 0.001, 0.001, 0.001]
[joints.wrist]
type = "spherical"
parent = "rotor"
child = "load"
origin = { xyz = [0.1, 0, 0.3] }
[joints.slide]
type = "prismatic"
parent = "load"
child = "tool"
axis = [0.3, 0, 1]
[effects.gravity]
g = [0.1, 0.2, -9.81]
"""
"""A ball joint and a slide on the rotor, whose inertia at the elbow is 1e16 times its own."""
SPINNING = """
[bodies.ball]
mass = 1.3
com = [0, 0, 0]
inertia = [0.7, 0.7, 0.7]
[joints.spindle]
type = "revolute"
parent = "rotor"
child = "ball"
axis = [0, 1, 1]
"""
"""A ball that turns about the rotor's axis: its inertia is the same at all angles of both."""


WORST = (
    (("0x1.8c295692747e2p+22", "-0x1.15868c7767054p-1", "-0x1.19e92123b83d4p-1",
      "0x1.486bfa909508fp-2", "-0x1.188209472133fp-1", "0x1.145c5069c407dp+15"),
     ("0x1.91dc994e7b298p+0", "-0x1.a533d2e27a082p+0", "-0x1.befb8e69f2a50p-1",
      "0x1.0ce7a4ffe4200p-3", "-0x1.97aec8d11d618p-1"),
     ("-0x1.4d9541feb9cd8p-2", "0x1.0fe06dcee273cp-1", "-0x1.03aca1cd92380p-6",
      "-0x1.78e433f059e1ep+0", "-0x1.b73f4244a61a2p+0")),
    (("0x1.bbb407e046e4cp-47", "-0x1.c31cb93fc56f1p-1", "-0x1.5a944de9e6e05p-2",
      "-0x1.2fc9b2e4faca0p-3", "-0x1.2e49c53e78cadp-2", "0x1.7bf739e17c51cp+17"),
     ("0x1.531cf0b5dfd88p-2", "-0x1.04c059ba94ca2p+0", "0x1.d794235842668p-2",
      "-0x1.3b9fd52a0d324p-1", "0x1.166dc218e4b54p+0"),
     ("0x1.8b8c7babbfe68p-1", "0x1.e126b71129b00p+0", "0x1.0651be4df6b10p+0",
      "-0x1.6c93bf1894328p-2", "0x1.04892e8c7d7b4p+0")),
)
"""Arguments at which results were wrong by 393 and 1.7 units while sums were multiplied as they
came, unrounded."""


def kernels(folder: Path, multiplier: str, more: str) -> Kernels:
    text = GEARED.replace("MULTIPLIER", multiplier) + more
    (folder / "scene.toml").write_text(text)
    return kernels_for(read_scene(folder / "scene.toml"))


def run(program: Program, rows: Sequence[Sequence[float]]) -> list[mpfr]:
    """The results at a state, in the context's digits."""
    return interpreter(program, MULTIPRECISE)([[mpfr(float(x)) for x in row] for row in rows])


def ulps(program: Program, given: Given, result: np.ndarray) -> np.ndarray:
    """Errors of results in units of the last digit."""
    with precise(DIGITS):
        true = [run(program, rows) for rows in zip(*given, strict=True)]
        return np.array([[float(abs(mpfr(float(x)) - y) / mpfr(np.spacing(abs(float(y)))))
                          for x, y in zip(*rows, strict=True)]
                         for rows in zip(result, true, strict=True)])


def sizes(program: Program, given: Given) -> np.ndarray:
    """Conditions of the results."""
    return np.transpose(conditions(program, components(program, given)))


def sliding_states(count: int) -> Given:
    """States of the arm with a slide, which is far out; the last of them are the worst ones found.
    """
    rng = np.random.default_rng(5)
    q, v, tau = (rng.uniform(-2, 2, (count, n)) for n in (6, 5, 5))
    q[:, 0] *= 10.0**rng.integers(-16, 10, count)
    q[:, 1:5] /= np.linalg.norm(q[:, 1:5], axis=1)[:, None]
    q[:, 5] *= 10.0**rng.integers(0, 7, count)
    worst = zip(*([[float.fromhex(x) for x in row] for row in rows] for rows in WORST),
                strict=True)
    return [np.vstack(both) for both in zip((q, v, tau), worst, strict=True)]


def test_intermediate_results_may_lose_all_digits(tmp_path: Path):
    made = kernels(tmp_path, "123456789.1", SLIDING)
    program, given = made.functions.named("forward_dynamics").program, sliding_states(150)
    errors = ulps(program, given, made.accurate.double.forward_dynamics(*given))
    messages = sizes(program, given) < LARGEST
    assert messages[-len(WORST):, 0].all() and messages.sum() > 400
    assert errors[messages].max() <= 1
    plain = ulps(program, given, made.double.forward_dynamics(*given))
    assert plain[messages].max() > 1e6, "plain has digits left"


def spinning_states(program: Program, count: int) -> Given:
    """States of the arm with a ball, far from zero; the accelerations nearly cancel at the elbow.
    """
    rng = np.random.default_rng(1)
    q, a, v = *(rng.uniform(-2, 2, (count, 2)) for _ in range(2)), np.zeros((count, 2))
    q[:, 0] *= 10.0**rng.integers(0, 11, count)
    with precise(DIGITS):
        for k in range(count):
            first, second = (run(program, (q[k], v[k], unit))[0] for unit in ((1, 0), (0, 1)))
            near = 1 + mpfr(10)**-int(rng.integers(9, 12))
            a[k, 0] = float(-second * mpfr(float(a[k, 1])) / first * near)
    return [q, v, a]


def test_huge_angles_that_change_nothing(tmp_path: Path):
    """Sine and cosine of an angle of 1e10, which a double has to 1e-6, are known to 2^-100: the
    result does not depend on the angle, but on their squares' sum being 1."""
    made = kernels(tmp_path, "1.1", SPINNING)
    program = made.functions.named("inverse_dynamics").program
    given = spinning_states(program, 80)
    messages = sizes(program, given) < LARGEST
    assert messages[:, 0].sum() > 40
    assert ulps(program, given, made.accurate.double.inverse_dynamics(*given))[messages].max() <= 1
