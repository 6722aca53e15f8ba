"""Central differences of the functions of a scene in 50 digits, along velocities."""

from collections.abc import Sequence

import mpmath
import numpy as np
from mpmath import mpf

from coscrew_codegen.dynamics import derive
from coscrew_codegen.dynamics.derivation import tree_for
from coscrew_codegen.program.scene_functions import SceneFunctions
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
    """The mechanism with these effects."""
    return m.scene(effects.mechanism(), *effects.effects(*names))


def chain_with(kind: JointKind, last: str = "c") -> Scene:
    """Links a, b and `last`, with a joint of this kind between the first two, so that its own
    motion and its carrier's count."""
    def link(name: str, parent: str, of: JointKind) -> Joint:
        return Joint(f"{name} joint", of, parent, name, m.at(1, 2, 3), m.Y,
                     axis2=m.X if len(of.axes) > 1 else None)

    bodies = [Body(x, m.inertia(2, (1, 2, 3), (20, 30, 40, 1, 2, 3))) for x in ("a", "b", last)]
    joints = [link("a", WORLD, Kind.REVOLUTE), link("b", "a", kind), link(last, "b", Kind.REVOLUTE)]
    return m.scene(assembled("chain", bodies, joints, Kind.FIXED), *effects.effects("gravity"))


def matrix(numbers: Sequence[mpf], columns: int) -> mpmath.matrix:
    """The numbers, row by row."""
    return mpmath.matrix([list(numbers[i:i + columns]) for i in range(0, len(numbers), columns)])


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
    """The components of a function's results, in 50 digits."""
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
    """The derivatives of a scene's dynamics are central differences."""
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
