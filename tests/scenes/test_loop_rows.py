"""Closures of loops at 50 digits: their rows are their rates, accelerations keep the rows' rates at
zero, and what closes a loop does no other work than along the rows."""

from collections.abc import Iterator
from pathlib import Path

import mpmath
import pytest
from mpmath import mpf

from coscrew_codegen.scene.mechanism.loop import LOOP_KINDS
from tests.support.scenes.closed_states import CASES, TAU, Closed, V

NEAR = mpf(10)**-15  # of two states, for differences of 50 digits
CLOSE = mpf(10)**-20


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(50):
        yield


KINDS = pytest.mark.parametrize("kind", LOOP_KINDS)


@KINDS
@CASES
def test_rows_are_the_rates_of_closures(tmp_path: Path, kind: str, second: str) -> None:
    at = Closed(tmp_path / "loop.toml", kind, second)
    ahead, behind = (at.closure(at.moved(h))[0] for h in (NEAR, -NEAR))
    rates = at.closure(at.q)[1] * mpmath.matrix(V)
    assert max(map(abs, rates)) > 0.1
    for x, y, rate in zip(ahead, behind, rates, strict=True):
        assert abs((x - y) / (2 * NEAR) - rate) < CLOSE


@KINDS
@CASES
def test_accelerations_keep_the_rates_of_closures(tmp_path: Path, kind: str, second: str) -> None:
    at = Closed(tmp_path / "loop.toml", kind, second)
    a = at.f.components("forward_dynamics", q=at.q, v=V, tau=TAU)
    ahead, behind = (at.rates(h, a) for h in (NEAR, -NEAR))
    for x, y in zip(ahead, behind, strict=True):
        assert abs((x - y) / (2 * NEAR)) < CLOSE


@KINDS
@CASES
def test_what_closes_a_loop_works_along_its_rows_alone(tmp_path: Path, kind: str, second: str
                                                       ) -> None:
    """M a + bias - tau = E^T λ, and for every v its power is that of the recorded wrench."""
    at = Closed(tmp_path / "loop.toml", kind, second)
    a = at.f.components("forward_dynamics", q=at.q, v=V, tau=TAU)
    torques = at.f.components("inverse_dynamics", q=at.q, v=V, a=a)
    closing = mpmath.matrix([x - y for x, y in zip(torques, TAU, strict=True)])
    E = at.closure(at.q)[1]
    multipliers = mpmath.lu_solve(E * E.T, E * closing)
    assert mpmath.norm(closing) > 0.1
    assert mpmath.norm(closing - E.T * multipliers) < CLOSE
    f = at.f.components("closing_closing", q=at.q, v=V, tau=TAU)
    power = (closing.T * mpmath.matrix(V))[0]
    along = mpmath.matrix([0, mpf(3) / 5, mpf(4) / 5])  # of a law's first joint
    wanted = _power(at, f, second) if kind != "law" else (
        along.T * mpmath.matrix(f[:3]))[0] * (E * mpmath.matrix(V))[0]
    assert abs(power - wanted) < CLOSE


def _power(at: Closed, f: list[mpf], second: str) -> mpf:
    """The power of the wrench f on the first body, at the loop's point, and of -f on the other."""
    poses = at.f.components("body_poses", q=at.q)
    twists = at.f.components("body_twists", q=at.q, v=V)
    names = [x.name for x in at.f.scene.model.bodies]
    D, V1 = (x[k * n:(k + 1) * n] for x, n in ((poses, 12), (twists, 6))
             for k in [names.index("end")])
    R = mpmath.matrix([[D[0], D[1], D[2]], [D[4], D[5], D[6]], [D[8], D[9], D[10]]])
    point = mpmath.matrix([mpf(x) / 100 for x in (5, 10, -10)])
    force, moment = R * mpmath.matrix(f[:3]), R * mpmath.matrix(f[3:])
    at_point = R * point + mpmath.matrix([D[3], D[7], D[11]])
    power = _of(force, moment, R, D, V1, at_point)
    k = names.index("other")
    D2, V2 = poses[12 * k:12 * k + 12], twists[6 * k:6 * k + 6]
    R2 = mpmath.matrix([[D2[0], D2[1], D2[2]], [D2[4], D2[5], D2[6]], [D2[8], D2[9], D2[10]]])
    return power - _of(force, moment, R2, D2, V2, at_point)


def _of(force: mpmath.matrix, moment: mpmath.matrix, R: mpmath.matrix, D: list[mpf],
        twist: list[mpf], at: mpmath.matrix) -> mpf:
    """F·(velocity of the body at a point of space) + N·ω."""
    origin = mpmath.matrix([D[3], D[7], D[11]])
    v, w = R * mpmath.matrix(twist[:3]), R * mpmath.matrix(twist[3:])
    r = at - origin
    turning = mpmath.matrix([w[1] * r[2] - w[2] * r[1], w[2] * r[0] - w[0] * r[2],
                             w[0] * r[1] - w[1] * r[0]])
    return (force.T * (v + turning))[0] + (moment.T * w)[0]


@KINDS
def test_states_are_moved_onto_closures(tmp_path: Path, kind: str) -> None:
    """v has no component along the rows; q closes quadratically, up to what ε leaves."""
    at = Closed(tmp_path / "loop.toml", kind, "hand")
    allowed = at.f.components("with_closed_loops", q=at.q, v=V)[len(at.q):]
    rates = at.closure(at.q)[1] * mpmath.matrix(allowed)
    assert mpmath.norm(rates) < mpf(10)**-25
    q = at.f.components("integrated", q=at.q, phi=[x / 1000 for x in V])
    before = max(map(abs, at.closure(q)[0]))
    after = max(map(abs, at.closure(at.f.components("with_closed_loops", q=q, v=V)[:len(q)])[0]))
    assert mpf(10)**-5 < before
    assert after < 100 * before**2
