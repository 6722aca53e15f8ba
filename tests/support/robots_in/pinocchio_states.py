"""A URDF's torques and mass matrix as Pinocchio computes them."""

from collections.abc import Iterator

import numpy as np
import pinocchio as pin

from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.scene.mechanism.model import value
from coscrew_codegen.scene.scene import Scene
from tests.support.robots_in.outcome import NotCompared
from tests.support.scenes.peer_states import PeerState
from tests.support.scenes.robots import in_full, paired_with

STATES = 10


def pinocchio_states(scene: Scene, functions: SceneFunctions, text: str) -> Iterator[PeerState]:
    """Random states of a robot under the scene's gravity.  Raises NotCompared for what Pinocchio
    does not read, and for planar joints, whose velocities are in other axes there."""
    if any(x.kind in ("planar", "spherical") for x in functions.coordinates):
        raise NotCompared("Pinocchio's velocities of a planar joint are in other axes")
    try:
        model = pin.buildModelFromXML(in_full(text))
    except (ValueError, RuntimeError) as error:
        raise NotCompared(f"Pinocchio says: {' '.join(str(error).split())[:120]}") from None
    gravity = next(x for x in scene.effects if x.effect.name == "gravity")
    model.gravity.linear = np.array([float(value(x)) for x in gravity.vector("g")])
    pair, data = paired_with(scene, functions, model), model.createData()
    for q, v, a in zip(*pair.states(STATES), strict=True):
        at, v_there, a_there = pair.theirs(q), pair.follow @ v, pair.follow @ a
        upper = np.triu(pin.crba(model, data, at))
        M = pair.follow.T @ (upper + np.triu(upper, 1).T) @ pair.follow
        yield PeerState(q, v, a, M,
                        pair.follow.T @ pin.rnea(model, data, at, v_there, a_there))
