"""Drag in wind resists motion relative to the fluid, at 50 digits: a body drifts as closed forms
say."""

from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path

import mpmath
import pytest
from mpmath import mpf

from coscrew_codegen.dynamics import derive
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.scenes.evaluation import MULTIPRECISE, Evaluated
from tests.support.scenes.kinds import Kind
from tests.support.scenes.mechanisms import (
    HERE,
    Formula,
    Z,
    applied,
    chain,
    gravity,
    inertia,
    scene,
)

CLOSE = mpf(10)**-40
QUATERNION = [Fraction(1, 5), Fraction(2, 5), Fraction(2, 5), Fraction(4, 5)]
POINT = (1, 2, 3)
WIND = (Formula("3 + sin(t)"), Fraction(-2), Formula("t"))


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(50):
        yield


def ball(*effects: object) -> Evaluated:
    body = inertia(2, moments=(1, 2, 3, 0, 0, 0))
    return Evaluated(scene(chain((Kind.FREE, Z, HERE, body)), *effects), MULTIPRECISE)


def rotation() -> mpmath.matrix:
    """R of QUATERNION, (x, y, z, w)."""
    x, y, z, w = (mpf(c.numerator) / c.denominator for c in QUATERNION)
    return mpmath.matrix([
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def cross(a: mpmath.matrix, b: mpmath.matrix) -> mpmath.matrix:
    return mpmath.matrix([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                          a[0] * b[1] - a[1] * b[0]])


@pytest.mark.parametrize("values, resistance", [
    ({"rho": 3, "area": 2}, lambda u: 3 * mpmath.norm(u)),
    ({"kind": "stokes", "b": 5}, lambda u: 5)])
def test_drag_resists_motion_in_the_fluid(values: dict, resistance) -> None:
    """-resistance(u) u at the point, u = v + ω × r - R^T w."""
    drag, t, v = applied("drag", "b0", point=POINT, **values), mpf(7) / 4, [1, 2, 3, 4, 5, 6]
    state = {"t": t, "q": [0, 0, 0, *QUATERNION], "v": v}
    r, w = mpmath.matrix(POINT), mpmath.matrix([3 + mpmath.sin(t), -2, t])
    u = mpmath.matrix(v[:3]) + cross(mpmath.matrix(v[3:]), r) - rotation().T * w
    force = -resistance(u) * u
    result = ball(drag, applied("wind", velocity=WIND))("bias_torques", **state)
    without = ball()("bias_torques", **state)
    for a, b, x in zip(without, result, [*force, *cross(r, force)], strict=True):
        assert abs(a - b - x) <= CLOSE * 1000


def test_the_effect_alone_is_in_the_same_wind() -> None:
    """Its recorded force, its power and what it feeds are those with the wind."""
    f = ball(gravity(), applied("drag", "b0", rho=3, area=2), applied("wind", velocity=WIND))
    state = {"t": mpf(1), "q": [0, 0, 0, 0, 0, 0, 1], "v": [0] * 6}
    u = mpmath.matrix([3 + mpmath.sin(1), -2, 1])
    parts = f.components("effect_drag_b0", **state)
    assert max(abs(a - b) for a, b in zip(parts, 3 * mpmath.norm(u) * u, strict=False)) <= CLOSE


def test_a_body_at_rest_in_a_gust_follows_it() -> None:
    """v = w - w/(1 + c w s) after the time s in a steady wind, c = rho area/2m: by implicit steps;
    twice as many err by a quarter."""
    f = ball(applied("drag", "b0", rho=3, area=2), applied("wind", velocity=(8, 0, 0)))
    wanted = 8 - 8 / (1 + mpf(3) / 2 * 8 / 2)

    def error(count: int) -> mpf:
        q, v, h = [0] * 6 + [1], [mpf(0)] * 6, mpf(1) / 2 / count
        for _ in range(count):
            q = f("integrated", q=q, phi=[h / 2 * x for x in v])
            v = [x + h * a for x, a in zip(v, f("midpoint_acceleration", h=h, q=q, v=v),
                                           strict=True)]
            q = f("integrated", q=q, phi=[h / 2 * x for x in v])
        return abs(v[0] - wanted)

    coarse, fine = error(64), error(128)
    assert coarse < mpf("1e-3") and mpf("3.6") < coarse / fine < mpf("4.4")


def test_constant_wind_takes_no_time_and_none_no_step() -> None:
    """Functions take t only if the wind depends on it; wind alone leaves everything as it is."""
    drag, calm = applied("drag", "b0", rho=3, area=2), applied("wind", velocity=(8, 0, 0))
    bodies = chain((Kind.FREE, Z, HERE, inertia(2, moments=(1, 2, 3, 0, 0, 0))))
    names = ("inverse_dynamics", "energy")
    timed = derive(scene(bodies, drag, applied("wind", velocity=WIND)), names)
    still = derive(scene(bodies, drag, calm), names)
    assert timed.named("inverse_dynamics").takes("t")
    assert not still.named("inverse_dynamics").takes("t")
    alone, none = (derive(scene(bodies, *x), names) for x in ((calm,), ()))
    assert [x.program for x in alone.functions] == [x.program for x in none.functions]


def test_wind_without_drag_is_told(tmp_path: Path) -> None:
    path = tmp_path / "calm.toml"
    path.write_text('''
[bodies.a]
mass = 1
[joints.j]
type = "prismatic"
child = "a"
axis = [1, 0, 0]
[effects.wind]
velocity = ["sin(t)", 0, 0]
''')
    assert read_scene(path).unused == (
        "wind does nothing: no effect depends on the fluid; write [effects.drag.BODY]",)
