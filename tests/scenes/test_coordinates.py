"""Coordinates with quaternions move by exponentials, and stay of norm 1."""

from pathlib import Path

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from coscrew_codegen import load_scene
from coscrew_codegen.program.values.formats import DOUBLE, Precision
from coscrew_codegen.scene.integrators import EMITTED, named
from coscrew_codegen.scene.mechanism.joint_kind import JointKind
from coscrew_codegen.scene.mechanism.model import HERE
from tests.support.each import each_precision
from tests.support.scenes.evaluation import MULTIPRECISE, Evaluated
from tests.support.scenes.kinds import Kind
from tests.support.scenes.mechanisms import Z, chain, inertia, scene

KINDS = pytest.mark.parametrize("kind", [Kind.SPHERICAL, Kind.FREE], ids=lambda kind: kind.name)


def evaluated(kind: JointKind) -> Evaluated:
    """A body behind one joint."""
    return Evaluated(scene(chain((kind, Z, HERE, inertia(1, moments=(1, 2, 2, 0, 0, 0))))),
                     MULTIPRECISE)


def turned(f: Evaluated) -> list[mpf]:
    """A q with a quaternion of norm 1, in fifths."""
    return [mpf(x) for x in (1, -2, 3)[:f.nq - 4]] + [
        mpf(x) / 10 for x in (2, -4, 4, 8)]


@KINDS
def test_rates_of_displacements_are_right_to_third_order(kind: JointKind) -> None:
    """d/dt integrated(q, φ + t u) is d/dt integrated(integrated(q, φ), t v), except for O(|φ|⁴)."""
    f = evaluated(kind)
    v = [mpf(x) for x in (3, -1, 2, 1, 4, -2)[-f.nv:]]
    far = [mpf(x) / 10 for x in (2, 1, -3, 2, -2, 1)[-f.nv:]]
    q, t = turned(f), mpf(10)**-5

    def difference(phi: list[mpf]) -> mpf:
        u = f("chart_rate", v=v, phi=phi)
        here = f("integrated", q=q, phi=phi)
        ends = [[(b - a) / (2 * t) for a, b in zip(*(of(s) for s in (-t, t)), strict=True)]
                for of in (lambda s: f("integrated", q=q, phi=[
                               x + s * y for x, y in zip(phi, u, strict=True)]),
                           lambda s: f("integrated", q=here, phi=[s * y for y in v]))]
        return mpmath.norm([a - b for a, b in zip(*ends, strict=True)])

    assert difference([x / 2 for x in far]) <= difference(far) / 14
    assert difference(far) <= mpf(10)**-2


LENGTHS = ("1e-150", "1e-9", "0.999", "1", "1.7320508", "2.4", "1e9", "1e150")


@KINDS
def test_norms_come_back_to_one(kind: JointKind) -> None:
    """From every length, at once."""
    f = evaluated(kind)
    for length in map(mpf, LENGTHS):
        q = turned(f)
        q[-4:] = [x * length for x in q[-4:]]
        result = f("integrated", q=q, phi=[mpf(1) / 7] * f.nv)[-4:]
        assert abs(mpmath.norm(result) - 1) <= mpf(2)**-50


SPINNING = """
[bodies]
hull = {{ mass = 3, com = [0.1, 0, -0.2], inertia = [0.3, 0.2, 0.4] }}
[joints]
base = {{ type = "{kind}", child = "hull" }}
[effects.gravity]
[run]
integrator = "{integrator}"
"""
SPREAD = 64
"""In u of 1: how far steps from multiples of a quaternion differ, whose squares round otherwise."""


@each_precision
@pytest.mark.parametrize("integrator", [x.name for x in EMITTED])
@KINDS
def test_steps_from_quaternions_of_any_length_are_those_of_norm_1(
        kind: JointKind, integrator: str, precision: Precision, tmp_path: Path) -> None:
    """Lengths whose squares single precision holds, for it."""
    path = tmp_path / "spinning.toml"
    path.write_text(SPINNING.format(kind=kind.name, integrator=integrator))
    real, u = np.dtype(precision.numpy_type).type, 2.0**-precision.digits
    step = getattr(getattr(load_scene(path), precision.name), named(integrator).step_name)
    draw = np.random.default_rng(5)
    for length in map(float, LENGTHS):
        length = length if precision == DOUBLE else length**0.12
        q, v = draw.normal(size=7 if kind is Kind.FREE else 4), draw.normal(size=6)
        v = v[:6 if kind is Kind.FREE else 3]
        q[-4:] /= np.linalg.norm(q[-4:])
        far = q.copy()
        far[-4:] *= length
        ends = [step(real(1e-3), x.astype(real), v.astype(real)) for x in (q, far)]
        assert abs(np.linalg.norm(ends[1][0][-4:].astype(float)) - 1) <= 4 * u
        for one, other in zip(*ends, strict=True):
            assert np.abs(one.astype(float) - other).max() <= SPREAD * u * np.abs(one).max()
