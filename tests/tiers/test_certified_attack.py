"""Certified bounds of scenes hold in double and single precision, at hard states too, as compiled;
and parts left out of the proof are noticed."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from coscrew_codegen import load_scene
from coscrew_codegen.accuracy.tiers import certified_wide
from coscrew_codegen.accuracy.tiers.sizes import Size, Sizes
from coscrew_codegen.program import ONE, ZERO, Constant, Op, Operand
from coscrew_codegen.program.values.formats import PRECISIONS
from tests.certified_attack import Found, kernels, of_free_joint, of_scene
from tests.support.scenes.tiers import flat, states
from tests.support.truth import free_motion
from tests.support.truth.wide import IS_WIDE

FUNCTIONS = "inverse_dynamics", "energy"
needs_quad = pytest.mark.skipif(not IS_WIDE, reason="numbers of 113 bits are libquadmath's, of x86")


def _found(scene: str, outputs: int, folder: Path) -> dict[str, Found]:
    """By precision."""
    results: dict[str, Found] = {}
    for _, precision, x in of_scene(kernels(scene, FUNCTIONS), outputs, folder, 1):
        results[precision] = results.get(precision, Found()) + x
    return results


@needs_quad
@pytest.mark.parametrize("scene", ("pendulum", "wingnut"))
def test_no_bound_is_broken(scene: str, tmp_path: Path):
    for result in _found(scene, 10_000, tmp_path).values():
        assert not result.broken and result.outputs > 15_000
        assert result.worst > 1 - 1e-6  # a bound is the error to so many digits


def test_bounds_of_moved_free_joints_hold():
    """At hard states of all sizes."""
    for *_, result in of_free_joint(7_000, seed=1):
        assert not result.broken and result.outputs > 6_000
        assert result.worst > 1 - 1e-6


WORST = {"double": """
-0x0.0p+0 -0x1.07abf46d805e8p-34 0x1.aa961a6a83a92p-66 0x1.9e2cae59d9ccfp-33 0x0.0p+0 0x0.0p+0
-0x1.0p+0 0x0.0p+0 0x1.0p+0 0x0.0p+0 0x1.921fb544aa5cbp+2 0x0.0p+0 0x0.0p+0
""", "single": """
0x1.61ec88p-11 -0x1.2a9244p-13 -0x1.ec36b8p-10 -0x1.61ec8ap-13 0x1.2a9244p-15 0x1.ec36b4p-12
0x1.fffffcp-1 -0x1.61ec8ap-11 0x1.2a9244p-13 0x1.ec36b6p-10 0x1.61ec8ap-12 -0x1.2a9244p-14
-0x1.ec36b6p-11
"""}
"""q and phi with the largest error / bound of 1.5e6 outputs."""


def test_bounds_of_moved_quaternions_are_their_errors():
    """Their norms are computed from split numbers."""
    plain = kernels("wingnut", ("integrated",))
    function = plain.functions.named("integrated")
    for p in PRECISIONS:
        worst = np.array([list(map(float.fromhex, WORST[p.name].split()))], p.numpy_type)
        q, phi = map(np.concatenate, zip(states(plain.functions, function, 500, p),
                                         (worst[:, :7], worst[:, 7:]), strict=True))
        result = free_motion.ratios((q, phi), *(flat(x, 501) for x in getattr(
            plain.certified, p.name).integrated(q, phi)))
        assert result.max() <= 1 and np.quantile(result[result > 0], 0.01) > 0.999


LIMITED = """
functions = ["inverse_dynamics"]
[bodies]
bob = { mass = 2, com = [0, 0, -0.5], inertia = [0.01, 0.01, 0.01] }
[joints]
pivot = { type = "revolute", child = "bob", axis = [0, 1, 0], limits = { upper = 1.1 } }
[effects.limit]
joints = "all"
k = 1000
alpha = 0.1
"""


def test_limits_that_are_not_reached_widen_no_bound(tmp_path: Path):
    """There the sign of the distance is uncertain, and its root near 0."""
    path = tmp_path / "limited.toml"
    path.write_text(LIMITED)
    limited = load_scene(path, tiers=["certified"]).certified
    for precision, largest in (("double", 1e-10), ("single", 1e-5)):
        kernel = getattr(limited, precision).inverse_dynamics
        for v in (0, 1, -3):
            assert kernel(*(np.array([x], precision) for x in (0.9, v, 0.3)))[1] < largest


def _first_order(self: Sizes, x: Operand, size: Size) -> Operand:
    """|d| for a bound."""
    low = None if isinstance(x, Constant) else self.errors.low(self._at, x)
    return ZERO if low is None else self.do(Op.ABS, low)


@needs_quad
@pytest.mark.parametrize("weaken, precision", (
    (lambda patch: patch.setattr(Sizes, "_bound", _first_order), "double"),
    (lambda patch: patch.setattr(certified_wide, "LEAST", ZERO), "single"),
    (lambda patch: patch.setattr(certified_wide, "ROUNDED", ONE), "single")),
    ids=("second order", "least number", "rounding"))
def test_a_weaker_proof_is_noticed(weaken: Callable[[pytest.MonkeyPatch], None], precision: str,
                                   tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    weaken(monkeypatch)
    assert _found("pendulum", 10_000, tmp_path)[precision].broken
