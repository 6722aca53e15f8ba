"""Derivatives of closed loops' accelerations and steps: differences in 50 digits, with rows that
are independent, and along motions of loops whose rows repeat others."""

from collections.abc import Iterator, Sequence
from pathlib import Path

import mpmath
import pytest
from mpmath import mpf

from coscrew_codegen.dynamics import derive
from coscrew_codegen.scene.integrators import named
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes import closed_loops, differentiated
from tests.support.scenes.closed_loops import CAM
from tests.support.scenes.closed_states import TAU, Closed, V
from tests.support.scenes.evaluation import DOUBLE, MULTIPRECISE, SINGLE, Evaluated

FORWARD, DERIVATIVES = "forward_dynamics", "forward_dynamics_derivatives"
STEP = mpf(10)**-14
CLOSE = mpf(10)**-22
Vector = Sequence[mpf]


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(50):
        yield


def scene_of(text: str, folder: Path) -> Scene:
    path = folder / "loops.toml"
    path.write_text(text, encoding="utf-8")
    return read_scene(path)


class Differences:
    """The accelerations of a scene at a state, and their differences."""

    def __init__(self, f: Evaluated[mpf], q: Vector, v: Vector, tau: Vector):
        self.f, self.q, self.v, self.tau = f, q, v, tau

    def along(self, by: str, d: Vector) -> list[mpf]:
        """The derivative of the accelerations along a direction of q, v or tau."""
        ahead, behind = (self._at(by, [sign * STEP * x for x in d]) for sign in (1, -1))
        return [(x - y) / (2 * STEP) for x, y in zip(ahead, behind, strict=True)]

    def _at(self, by: str, d: Vector) -> list[mpf]:
        given = {"q": self.q, "v": self.v, "tau": self.tau}
        given[by] = self.f.components("integrated", q=self.q, phi=d) if by == "q" else [
            x + y for x, y in zip(given[by], d, strict=True)]
        return self.f.components(FORWARD, **given)

    def matrices(self, f: "Evaluated | None" = None) -> dict[str, mpmath.matrix]:
        """The derivatives by each input."""
        numbers = (f or self.f).components(DERIVATIVES, q=self.q, v=self.v, tau=self.tau)
        n = self.f.nv
        return {by: mpmath.matrix([[mpf(float(x)) if f else x for x in numbers[
            (k * n + i) * n:(k * n + i + 1) * n]] for i in range(n)])
            for k, by in enumerate(("q", "v", "tau"))}


def assert_same(x: Vector, y: Vector, close: mpf) -> None:
    size = max(1, *map(abs, y))
    for one, other in zip(x, y, strict=True):
        assert abs(one - other) <= close * size


@pytest.mark.parametrize("kind, second", [("point", "hand"), ("frame", "world"), ("hinge", "hand"),
                                          ("rod", "world")])
def test_derivatives_are_differences(tmp_path: Path, kind: str, second: str) -> None:
    """At velocities and torques that the loop does not allow, too: each by itself is exact."""
    at = Closed(tmp_path / "loop.toml", kind, second)
    its = Differences(at.f, at.q, V, TAU)
    for by, matrix in its.matrices().items():
        assert mpmath.norm(matrix) > 0.1
        for k in range(at.f.nv):
            unit = [mpf(int(i == k)) for i in range(at.f.nv)]
            assert_same(list(matrix[:, k]), its.along(by, unit), CLOSE)


def closed_state(f: Evaluated[mpf], q: Vector) -> Differences:
    """A state that closes the loops, near q, also if rows repeat others."""
    rows, v = len(f.scene.model.loops) and len(f.components("closure", q=q)) // (f.nv + 1), V
    for _ in range(60):
        numbers = f.components("closure", q=q)
        E = mpmath.matrix([numbers[rows + i * f.nv:rows + (i + 1) * f.nv] for i in range(rows)])
        W = E * E.T + mpf(10)**-20 * mpmath.eye(rows)
        phi = E.T * mpmath.lu_solve(W, -mpmath.matrix(numbers[:rows]))
        q = f.components("integrated", q=q, phi=list(phi))
        v = mpmath.matrix(list(v)[:f.nv])
        v = list(v - E.T * mpmath.lu_solve(W, E * v))
    return Differences(f, q, v, TAU[:f.nv])


REPEATED = {"three points at once": (closed_loops.crank_rocker("point", 3),
                                     ["0.502096581", "0.103283917", "1.53612081"]),
            "a hinge in a plane": (closed_loops.crank_rocker("hinge"),
                                   ["0.502096581", "0.103283917", "1.53612081"]),
            "a weld": (closed_loops.beam(True),
                       ["0.1", "-0.2", "0.5", "0.1", "0.4", "0", "0", "0", "1"]),
            "none, of a law of joints": (CAM, ["0.3", "0.2"])}


@pytest.mark.parametrize("text, q", REPEATED.values(), ids=REPEATED)
def test_rows_that_repeat_others_make_no_difference(tmp_path: Path, text: str, q: list[str]
                                                    ) -> None:
    """Nor do rounding and ε of both precisions, beyond their size."""
    scene = scene_of(text, tmp_path)
    its = closed_state(Evaluated(scene, MULTIPRECISE), [mpf(x) for x in q])
    exact, nv = its.matrices(), its.f.nv
    for by, matrix in exact.items():
        for k in range(nv):
            unit = [mpf(int(i == k)) for i in range(nv)]
            assert_same(list(matrix[:, k]), its.along(by, unit), CLOSE)
    for numbers, close in ((DOUBLE, 1e-13), (SINGLE, 1e-4)):
        rounded = its.matrices(Evaluated(scene, numbers))
        for by, matrix in exact.items():
            assert_same(list(rounded[by]), list(matrix), mpf(close))


def test_derivatives_by_torques_are_symmetric_and_keep_the_rows(tmp_path: Path) -> None:
    at = Closed(tmp_path / "loop.toml", "hinge", "hand")
    by_tau = Differences(at.f, at.q, V, TAU).matrices()["tau"]
    E = at.closure(at.q)[1]
    assert mpmath.norm(by_tau - by_tau.T) < CLOSE
    assert mpmath.norm(E * by_tau) < CLOSE


@pytest.mark.parametrize("name", [FORWARD, "with_closed_loops", "closing_knee", "reaction_drive"])
def test_tangents_and_adjoints_are_differences(tmp_path: Path, name: str,
                                               monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(differentiated, "CLOSE", CLOSE)
    monkeypatch.setattr(differentiated, "STEP", STEP)
    scene = scene_of(closed_loops.floating_loop(), tmp_path)
    differentiated.check(scene, differentiated.entry(scene, name))


@pytest.mark.parametrize("name", ["leapfrog", "rk4", "linear-implicit-euler"])
def test_derivatives_of_steps_are_differences(tmp_path: Path, name: str) -> None:
    """A of a step of a crank with a damper and a torque at run time; also B_p."""
    text = f'runtime = ["viscous.elbow.d"]\n{closed_loops.crank_rocker("point", 2)}'
    text += "[effects.viscous.elbow]\nd = 0.3\n"
    scene, step = scene_of(text, tmp_path), named(name).step_name
    functions = derive(scene, (f"{step}_derivatives", f"{step}_tangent", "closure", "integrated"))
    its = closed_state(Evaluated(scene, MULTIPRECISE, functions), [
        mpf("0.502096581"), mpf("0.103283917"), mpf("1.53612081")])
    given = {"h": mpf("0.01"), "q": its.q, "v": its.v, "p": [mpf("0.3")]}
    still = {f"d_{x}": [mpf(0)] * (1 if x in "hp" else 3) for x in given}
    whole = differentiated.results(functions, f"{step}_derivatives", _lists(given))

    def ends(by: str, d: Vector) -> list[mpf]:
        results = []
        for sign in (1, -1):
            at = {**given, by: [x + sign * STEP * y for x, y in zip(given[by], d, strict=True)]}
            its = differentiated.results(functions, f"{step}_tangent", {**_lists(at), **still})
            results.append([*its["qo"], *its["vo"]])
        return [(x - y) / (2 * STEP) for x, y in zip(*results, strict=True)]

    A = mpmath.matrix([whole["A"][6 * i:6 * i + 6] for i in range(6)])
    for k in range(6):
        unit = [mpf(int(i == k % 3)) for i in range(3)]
        assert_same(list(A[:, k]), ends("qv"[k // 3], unit), CLOSE)
    assert_same(whole["B_p"], ends("p", [mpf(1)]), CLOSE)
    assert max(map(abs, whole["B_p"])) > 1e-6


def _lists(given: dict) -> dict[str, list[mpf]]:
    return {key: x if isinstance(x, list) else [x] for key, x in given.items()}
