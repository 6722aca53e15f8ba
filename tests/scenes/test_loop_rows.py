"""Closures of loops at 50 digits: their rows are their rates, accelerations keep the rows' rates at
zero, and what closes a loop does no other work than along the rows."""

from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path

import mpmath
import pytest
from mpmath import mpf

from coscrew_codegen.scene.mechanism.loop import LOOP_KINDS
from coscrew_codegen.scene.mechanism.rotations import quaternion
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from tests.support.scenes.closed_loops import spatial
from tests.support.scenes.evaluation import MULTIPRECISE, Evaluated

NEAR = mpf(10)**-15  # of two states, for differences of 50 digits
CLOSE = mpf(10)**-20
SECOND = {"between bodies": "hand", "to the world": "world"}
V = [mpf(x) / 10 for x in (3, -2, 5, 1, 4, -3, 2, 5, -1, 3, -4, 2, 6)]
TAU = [mpf(x) for x in (1, -2, 3, 2, -1, 1, 4, -3, 2, 1, -2, 3, 1)]


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(50):
        yield


class Closed:
    """A mechanism at a state that closes its loop, with other velocities than those it allows."""

    def __init__(self, path: Path, kind: str, second: str):
        unit = [mpf(x) / 5 for x in (1, 2, 2, 4)]
        q = [mpf(1) / 3, mpf(-1) / 4, mpf(1) / 2, *unit, mpf(2) / 5, *unit, mpf(1) / 3,
             mpf(-1) / 2, mpf(3) / 5]
        place = _between(path, second, q)
        path.write_text(spatial(kind, second, place), encoding="utf-8")
        self.f, self.rows = Evaluated(read_scene(path), MULTIPRECISE), LOOP_KINDS[kind].count
        for _ in range(3):
            phi, E = self.closure(q)
            step = E.T * mpmath.lu_solve(E * E.T, -mpmath.matrix(phi))
            q = self.f.components("integrated", q=q, phi=list(step))
        assert max(map(abs, self.closure(q)[0])) < mpf(10)**-45
        self.q = q

    def closure(self, q: list[mpf]) -> tuple[list[mpf], mpmath.matrix]:
        """phi and E."""
        numbers = self.f.components("closure", q=q)
        E = numbers[self.rows:]
        return numbers[:self.rows], mpmath.matrix(
            [E[i * self.f.nv:(i + 1) * self.f.nv] for i in range(self.rows)])

    def moved(self, h: mpf) -> list[mpf]:
        """The coordinates after a time h at V."""
        return self.f.components("integrated", q=self.q, phi=[h * x for x in V])

    def rates(self, h: mpf, a: list[mpf]) -> mpmath.matrix:
        """E v after a time h at V with accelerations a."""
        v = mpmath.matrix([x + h * y for x, y in zip(V, a, strict=True)])
        return self.closure(self.moved(h))[1] * v


def _between(path: Path, second: str, q: list[mpf]) -> str:
    """The frame of the first end in the second body, to double precision."""
    path.write_text(spatial("point", second), encoding="utf-8")
    f = Evaluated(read_scene(path), MULTIPRECISE)
    names, poses = [x.name for x in f.scene.model.bodies], f.components("body_poses", q=q)
    D, D2 = (_matrix(poses[12 * k:12 * k + 12]) if k >= 0 else mpmath.eye(4) for k in (
        names.index("end"), names.index(second) if second in names else -1))
    R = D2**-1 * D
    rotation = tuple(Fraction(float(R[i, j])) for i in range(3) for j in range(3))
    xyz, turned = [float(R[i, 3]) for i in range(3)], map(float, quaternion(rotation))
    return f"xyz = {xyz}, quaternion = {list(turned)}"


def _matrix(D: list[mpf]) -> mpmath.matrix:
    return mpmath.matrix([D[:4], D[4:8], D[8:], [0, 0, 0, 1]])


CASES = pytest.mark.parametrize("second", SECOND.values(), ids=SECOND)
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
