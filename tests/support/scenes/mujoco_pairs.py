"""A robot in coscrew and in MuJoCo, joints by name: their mass matrices, biases and torques."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import mujoco
import numpy as np

from coscrew_codegen import load_scene
from coscrew_codegen.program.scene_functions import Coordinate
from coscrew_codegen.scene.mechanism.assembly import followers
from coscrew_codegen.scene.mechanism.model import Mimic
from coscrew_codegen.scene.readers.mjcf.mjcf_names import MjcfNames
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes.peer_states import PeerState, Worst, worst

_OFF = (mujoco.mjtDisableBit.mjDSBL_CONSTRAINT, mujoco.mjtDisableBit.mjDSBL_CONTACT,
        mujoco.mjtDisableBit.mjDSBL_ACTUATION)
_FREE, _BALL = int(mujoco.mjtJoint.mjJNT_FREE), int(mujoco.mjtJoint.mjJNT_BALL)
Array = np.ndarray
_Places = Mapping[str, tuple[int, int]]


def compared(scene: Scene, model: "mujoco.MjModel", states: int = 10) -> Worst:
    """Inverse dynamics, their value without acceleration, and the mass matrix, at random states, in
    which followers follow.

    MuJoCo's are without contacts, limits, dry friction and actuators."""
    passive = tuple(x for x in scene.effects if x.effect.name != "actuator")
    kernels = load_scene(replace(scene, effects=passive, parameters=()),
                         functions=["inverse_dynamics", "mass_matrix"])
    ours = kernels.double
    return worst(ours.inverse_dynamics, ours.mass_matrix,
                 mujoco_states(scene, kernels.interface.coordinates, model, states))


def mujoco_states(scene: Scene, coordinates: Sequence[Coordinate], model: "mujoco.MjModel",
                  states: int) -> Iterator[PeerState]:
    """Random states with MuJoCo's results."""
    data, names, led = mujoco.MjData(model), MjcfNames(model), followers(scene)
    places = {names.joint(j): (int(model.jnt_qposadr[j]), int(model.jnt_dofadr[j]))
              for j in range(model.njnt)}
    model.opt.disableflags |= sum(map(int, _OFF))
    rng = np.random.default_rng(7)
    for _ in range(states):
        q, v, a = _following(places, led, *_state(model, rng))
        Q, V, A, T = _converted(coordinates, model.nv, places, q, v, a)
        T = _coupled(places, led, T)
        data.qpos[:], data.qvel[:], data.qacc[:] = q, v, a
        mujoco.mj_inverse(model, data)
        M = np.zeros((model.nv, model.nv))
        mujoco.mj_fullM(model, data, M)
        yield PeerState(Q, V, A, T.T @ M @ T, T.T @ data.qfrc_inverse)


def _state(model: "mujoco.MjModel", rng: np.random.Generator) -> tuple[Array, Array, Array]:
    q = rng.uniform(-1.5, 1.5, model.nq)
    for j in range(model.njnt):
        at = model.jnt_qposadr[j] + 3 * (model.jnt_type[j] == _FREE)
        if model.jnt_type[j] in (_FREE, _BALL):
            q[at:at + 4] /= np.linalg.norm(q[at:at + 4])
    return q, rng.normal(size=model.nv), rng.normal(size=model.nv)


def _following(places: _Places, mimics: Mapping[str, Mimic], q: Array, v: Array, a: Array
               ) -> tuple[Array, Array, Array]:
    """A state in which followers follow."""
    for name, mimic in mimics.items():
        (at, to), (its, its_v) = places[name], places[mimic.joint]
        q[at] = float(mimic.multiplier) * q[its] + float(mimic.offset)
        v[to], a[to] = float(mimic.multiplier) * v[its_v], float(mimic.multiplier) * a[its_v]
    return q, v, a


def _coupled(places: _Places, mimics: Mapping[str, Mimic], T: Array) -> Array:
    """T with the rows of followers."""
    for name, mimic in mimics.items():
        T[places[name][1]] = float(mimic.multiplier) * T[places[mimic.joint][1]]
    return T


def _converted(coordinates: Sequence[Coordinate], nv: int, places: _Places, q: Array, v: Array,
               a: Array) -> tuple[Array, Array, Array, Array]:
    """Our q, v, a, and T with v = T v_ours.  Free joints: linear velocity in the body's frame."""
    Q = np.zeros(sum(len(c.q) for c in coordinates))
    V, A = np.zeros((2, sum(len(c.v) for c in coordinates)))
    T = np.zeros((nv, len(V)))
    for c in coordinates:
        at, to = places[c.joint]
        x, w, dw = q[at:at + len(c.q)], v[to:to + len(c.v)], a[to:to + len(c.v)]
        block = np.eye(len(c.v))
        if c.kind == "spherical":
            x = np.roll(x, -1)
        elif c.kind == "free":
            entries = np.zeros(9)
            mujoco.mju_quat2Mat(entries, x[3:])
            R = entries.reshape(3, 3)
            block[:3, :3] = R
            x = np.r_[x[:3], x[4:], x[3]]
            w = np.r_[R.T @ w[:3], w[3:]]
            dw = np.r_[R.T @ dw[:3] - np.cross(w[3:], w[:3]), dw[3:]]
        Q[c.q.start:c.q.stop], V[c.v.start:c.v.stop], A[c.v.start:c.v.stop] = x, w, dw
        T[to:to + len(c.v), c.v.start:c.v.stop] = block
    return Q, V, A, T
