"""Derivatives of inverse and forward dynamics with every effect and kind of joint: the recursion
agrees with differentiation of the torques' Program, and both with differences in 50 digits."""

from collections.abc import Sequence
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from coscrew_codegen.dynamics import derive, dynamics_derivatives
from coscrew_codegen.dynamics.derivation import tree_for
from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.scene.joints import KINDS
from coscrew_codegen.scene.mechanism.assembly import assembled
from coscrew_codegen.scene.mechanism.joint_kind import JointKind
from coscrew_codegen.scene.mechanism.model import WORLD, Body, Joint
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes import effect_scenes as effects
from tests.support.scenes import mechanisms as m
from tests.support.scenes.evaluation import MULTIPRECISE, evaluator
from tests.support.scenes.kinds import Kind

INVERSE, FORWARD = "inverse_dynamics_derivatives", "forward_dynamics_derivatives"
ACTING = tuple(x for x in effects.PLACES if x not in ("mimic", "reaction"))
STEP = mpf(10)**-18


def scene_with(names: Sequence[str]) -> Scene:
    return m.scene(effects.mechanism(), *effects.effects(*names))


def state(scene: Scene, functions: SceneFunctions, seed: int = 3) -> dict[str, list[mpf]]:
    """An argument of each name, q with quaternions of norm 1."""
    rng, tree = np.random.default_rng(seed), tree_for(scene)
    q = [mpf(x) for x in rng.uniform(-1, 1, functions.nq)]
    for link in tree.links:
        for part, places, _ in link.joint.kind.q_parts:
            if part.quaternion:
                k = slice(link.q.start + places.start, link.q.start + places.stop)
                q[k] = [x / mpmath.norm(q[k]) for x in q[k]]
    vectors = {name: [mpf(x) for x in rng.uniform(-1, 1, functions.nv)]
               for name in ("v", "a", "tau")}
    return {"q": q, "t": [mpf("0.3")], "p": [mpf(float(x.value)) for x in scene.parameters],
            **vectors}


def values(functions: SceneFunctions, name: str, given: dict[str, list[mpf]]) -> list[mpf]:
    program = functions.named(name).program
    return list(evaluator(program, MULTIPRECISE)([given[a.name] for a in program.inputs]))


def differences(functions: SceneFunctions, name: str, given: dict[str, list[mpf]], by: str
                ) -> list[list[mpf]]:
    """Central differences, along velocities by q: columns."""
    columns = []
    for j in range(functions.nv):
        ends = []
        for sign in (1, -1):
            unit = [sign * STEP * int(i == j) for i in range(functions.nv)]
            moved = (values(functions, "integrated", {**given, "phi": unit}) if by == "q" else
                     [x + d for x, d in zip(given[by], unit, strict=True)])
            ends.append(values(functions, name, {**given, by: moved}))
        columns.append([(x - y) / (2 * STEP) for x, y in zip(*ends, strict=True)])
    return columns


def check(scene: Scene) -> None:
    functions = derive(scene, (INVERSE, FORWARD, "inverse_dynamics", "forward_dynamics",
                               "integrated"))
    with mpmath.workdps(50):
        given, nv = state(scene, functions), functions.nv
        for derived, of, by in ((INVERSE, "inverse_dynamics", "qva"),
                                (FORWARD, "forward_dynamics", ("q", "v", "tau"))):
            result = values(functions, derived, given)
            for k, name in enumerate(by):
                own = result[k * nv * nv:(k + 1) * nv * nv]
                wanted = differences(functions, of, given, name)
                largest = max(abs(x) for column in wanted for x in column)
                for i in range(nv):
                    for j in range(nv):
                        assert abs(own[i * nv + j] - wanted[j][i]) <= largest * mpf(10)**-25, (
                            derived, name, i, j)


@pytest.mark.parametrize("names", [("gravity",), ACTING], ids=["gravity", "all"])
def test_they_are_differences_in_50_digits(names: Sequence[str]) -> None:
    check(scene_with(names))


@pytest.mark.parametrize("kind", [x for x in KINDS if x.moves], ids=lambda x: x.name)
def test_every_kind_of_joint(kind: JointKind) -> None:
    """Between two links, so that its own motion and its carrier's count."""
    def link(name: str, parent: str, of: JointKind) -> Joint:
        return Joint(f"{name} joint", of, parent, name, m.at(1, 2, 3), m.Y,
                     axis2=m.X if len(of.axes) > 1 else None)

    bodies = [Body(x, m.inertia(2, (1, 2, 3), (20, 30, 40, 1, 2, 3))) for x in "abc"]
    joints = [link("a", WORLD, Kind.REVOLUTE), link("b", "a", kind), link("c", "b", Kind.REVOLUTE)]
    check(m.scene(assembled("chain", bodies, joints, Kind.FIXED), *effects.effects("gravity")))


def test_recursion_and_differentiation_agree(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = scene_with(ACTING)
    recursion = derive(scene, (INVERSE,))
    monkeypatch.setattr(dynamics_derivatives.rnea_derivatives, "constant_screws",
                        lambda motion: False)
    with mpmath.workdps(50):
        given = state(scene, recursion)
        one, other = (values(x, INVERSE, given) for x in (recursion, derive(scene, (INVERSE,))))
        assert max(abs(x - y) for x, y in zip(one, other, strict=True)) <= mpf(10)**-40 * max(
            map(abs, other))


def test_of_a_pendulum() -> None:
    """tau = m l² a + m g l sin q, with g = 10 m/s²."""
    scene = m.scene(m.pendulum(2, Fraction(1, 2)), m.gravity(0, 0, -10))
    functions = derive(scene, (INVERSE, FORWARD))
    given = {"q": [mpf(1)], "v": [mpf(2)], "a": [mpf(3)], "tau": [mpf(4)]}
    stiff, mass = 10 * mpmath.cos(1), mpf("0.5")
    for name, wanted in ((INVERSE, (stiff, 0, mass)), (FORWARD, (-stiff / mass, 0, 1 / mass))):
        for x, y in zip(values(functions, name, given), wanted, strict=True):
            assert abs(x - y) <= mpf(10)**-13
