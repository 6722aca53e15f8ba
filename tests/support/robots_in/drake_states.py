"""An SDF's torques and mass matrix as Drake computes them."""

import logging
import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from coscrew_codegen.program.scene_functions import SceneFunctions
from coscrew_codegen.scene.mechanism.model import value
from coscrew_codegen.scene.mechanism.tree import tree_of
from coscrew_codegen.scene.scene import Scene
from tests.support.robots_in.outcome import NotCompared
from tests.support.scenes.peer_states import PeerState

STATES = 10
_SHAPES = re.compile(r"<(visual|collision|contact)\b.*?</\1>|<laser_retro>.*?</laser_retro>", re.S)


def drake_states(scene: Scene, functions: SceneFunctions, path: Path) -> Iterator[PeerState]:
    """Random states of a robot under the scene's gravity, without damping.  Raises NotCompared
    without Drake, and for what it does not read."""
    try:
        from pydrake.multibody.parsing import Parser
        from pydrake.multibody.plant import MultibodyPlant
        from pydrake.multibody.tree import MultibodyForces
    except ImportError as error:
        raise NotCompared(f"no Drake: {error}") from None
    if any("mass 0 kg" in x for x in scene.model.implausible):
        raise NotCompared("Drake gives a body of 0 kg 1 kg, as a ball")
    logging.getLogger("drake").setLevel(logging.ERROR)
    plant = MultibodyPlant(0.0)
    try:
        Parser(plant).AddModelsFromString(_prepared(path.read_text()), "sdf")
        gravity = next(x for x in scene.effects if x.effect.name == "gravity")
        g = [float(value(x)) for x in gravity.vector("g")]
        plant.mutable_gravity_field().set_gravity_vector(g)
        plant.Finalize()
    except RuntimeError as error:
        raise NotCompared(f"Drake says: {' '.join(str(error).split())[-120:]}") from None
    context, maps = plant.CreateDefaultContext(), _Maps(scene, functions, plant)
    rng = np.random.default_rng(5)
    for _ in range(STATES):
        q = rng.uniform(-2, 2, functions.nq)
        v, a = rng.uniform(-2, 2, (2, functions.nv))
        for c in functions.coordinates:
            if c.kind in ("free", "spherical"):
                q[c.q.stop - 4:c.q.stop] /= np.linalg.norm(q[c.q.stop - 4:c.q.stop])
        there, T, a_there = maps.of(q, v, a)
        plant.SetPositions(context, there)
        plant.SetVelocities(context, 0 * (T @ v))  # at rest dampers exert nothing
        forces = MultibodyForces(plant)
        plant.CalcForceElementsContribution(context, forces)
        plant.SetVelocities(context, T @ v)
        M = plant.CalcMassMatrix(context)
        yield PeerState(q, v, a, T.T @ M @ T,
                        T.T @ plant.CalcInverseDynamics(context, a_there, forces))


def _prepared(text: str) -> str:
    """The text without shapes; a link called world, which Drake refuses, is called world_."""
    text = _SHAPES.sub("", text)
    if re.search(r"""<link name=["']world["']""", text):
        text = re.sub(r"""(<link name=["']world|>\s*world)(["']|\s*<)""", r"\1_\2", text)
    return text


class _Maps:
    """Our coordinates in Drake's order; a free body's twist is in the world's axes there."""

    def __init__(self, scene: Scene, functions: SceneFunctions, plant: object) -> None:
        self.coordinates, self.plant = functions.coordinates, plant
        self.links = {x.joint.name: x for x in tree_of(scene.model, False).links}
        joints = [plant.get_joint(j) for j in plant.GetJointIndices()]  # type: ignore[attr-defined]
        self.joints = {x.name(): x for x in joints if x.num_velocities()}
        self.free = [x for x in joints if x.num_velocities() == 6]
        if missing := [c.joint for c in self.coordinates
                       if c.kind != "free" and c.joint not in self.joints]:
            raise NotCompared(f"Drake has no joint {missing[0]!r}")

    def of(self, q: np.ndarray, v: np.ndarray, a: np.ndarray
           ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Drake's q, T with v = T v_ours, and Drake's accelerations."""
        nq = self.plant.num_positions()  # type: ignore[attr-defined]
        nv = self.plant.num_velocities()  # type: ignore[attr-defined]
        there, T, extra = np.zeros(nq), np.zeros((nv, len(v))), np.zeros(nv)
        for c in self.coordinates:
            x, columns = q[c.q.start:c.q.stop], range(c.v.start, c.v.stop)
            joint = self.free[0] if c.kind == "free" else self.joints[c.joint]
            at, to = joint.position_start(), joint.velocity_start()
            if c.kind != "free":
                if c.kind == "spherical":
                    raise NotCompared("Drake's ball joints have other angles")
                there[at:at + len(x)] = x
                T[range(to, to + len(x)), columns] = 1
                continue
            place = self.links[c.joint].placement
            R0, t0 = (np.array([float(y) for y in of]) for of in (place.R, place.t))
            R0 = R0.reshape(3, 3)
            R = R0 @ _rotation(x[3:])
            there[at:at + 7] = *_quaternion(R), *(t0 + R0 @ x[:3])
            T[to:to + 3, columns[3:]] = R
            T[to + 3:to + 6, columns[:3]] = R
            linear, angular = v[columns[:3]], v[columns[3:]]
            extra[to + 3:to + 6] = R @ np.cross(angular, linear)
        return there, T, T @ a + extra


def _rotation(q: np.ndarray) -> np.ndarray:
    x, y, z, w = q
    v = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + 2 * w * v + 2 * v @ v


def _quaternion(R: np.ndarray) -> np.ndarray:
    """w, x, y, z."""
    from scipy.spatial.transform import Rotation

    x, y, z, w = Rotation.from_matrix(R).as_quat()
    return np.array([w, x, y, z])
