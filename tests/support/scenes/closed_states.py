"""States at which a mechanism's loop is closed, at 50 digits."""

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

SECOND = {"between bodies": "hand", "to the world": "world"}
V = [mpf(x) / 10 for x in (3, -2, 5, 1, 4, -3, 2, 5, -1, 3, -4, 2, 6)]
TAU = [mpf(x) for x in (1, -2, 3, 2, -1, 1, 4, -3, 2, 1, -2, 3, 1)]
CASES = pytest.mark.parametrize("second", SECOND.values(), ids=SECOND)


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
