"""A robot in coscrew and in MuJoCo, joints by name: their mass matrices, biases and torques."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import mujoco
import numpy as np

from coscrew_codegen import load_scene
from coscrew_codegen.scene.mechanism.mimics import followers
from coscrew_codegen.scene.mechanism.model import Mimic
from coscrew_codegen.scene.scene import Scene

_OFF = (mujoco.mjtDisableBit.mjDSBL_CONSTRAINT, mujoco.mjtDisableBit.mjDSBL_CONTACT,
        mujoco.mjtDisableBit.mjDSBL_ACTUATION)
_FREE, _BALL = int(mujoco.mjtJoint.mjJNT_FREE), int(mujoco.mjtJoint.mjJNT_BALL)
Array = np.ndarray


@dataclass(frozen=True)
class Worst:
    """The largest differences, relative to the largest entry."""

    mass_matrix: float
    bias: float
    torques: float


def compared(scene: Scene, model: "mujoco.MjModel", states: int = 10) -> Worst:
    """Inverse dynamics, their value without acceleration, and the mass matrix, at random states, in
    which followers follow.

    MuJoCo's are without contacts, limits, dry friction and actuators."""
    passive = tuple(x for x in scene.effects if x.effect.name != "actuator")
    kernels = load_scene(replace(scene, effects=passive, parameters=()),
                         functions=["inverse_dynamics", "mass_matrix"])
    ours, data = kernels.double, mujoco.MjData(model)
    model.opt.disableflags |= sum(map(int, _OFF))
    rng, worst = np.random.default_rng(7), [0.0, 0.0, 0.0]
    for _ in range(states):
        q, v, a = _following(model, followers(scene), *_state(model, rng))
        Q, V, A, T = _converted(kernels.interface.coordinates, model, q, v, a)
        T = _coupled(model, followers(scene), T)
        data.qpos[:], data.qvel[:], data.qacc[:] = q, v, a
        mujoco.mj_inverse(model, data)
        M = np.zeros((model.nv, model.nv))
        mujoco.mj_fullM(model, data, M)
        torques, M = T.T @ data.qfrc_inverse, T.T @ M @ T
        mine = ours.inverse_dynamics(Q, V, A)
        bias = ours.inverse_dynamics(Q, V, np.zeros_like(A))
        pairs = ((ours.mass_matrix(Q), M), (bias, torques - M @ A), (mine, torques))
        scale = max(np.abs(torques).max(), np.abs(M @ A).max())
        for n, (x, y) in enumerate(pairs):
            size = scale if n else np.abs(M).max()
            worst[n] = max(worst[n], float(np.abs(x - y).max() / size))
    return Worst(*worst)


def _state(model: "mujoco.MjModel", rng: np.random.Generator) -> tuple[Array, Array, Array]:
    q = rng.uniform(-1.5, 1.5, model.nq)
    for j in range(model.njnt):
        at = model.jnt_qposadr[j] + 3 * (model.jnt_type[j] == _FREE)
        if model.jnt_type[j] in (_FREE, _BALL):
            q[at:at + 4] /= np.linalg.norm(q[at:at + 4])
    return q, rng.normal(size=model.nv), rng.normal(size=model.nv)


def _places(model: "mujoco.MjModel", joint: str) -> tuple[int, int]:
    """The places of a joint's first coordinate and velocity."""
    number = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, joint)
    assert number >= 0, f"MuJoCo has no joint {joint!r}"
    return model.jnt_qposadr[number], model.jnt_dofadr[number]


def _following(model: "mujoco.MjModel", mimics: Mapping[str, Mimic], q: Array, v: Array, a: Array
               ) -> tuple[Array, Array, Array]:
    """A state in which followers follow."""
    for name, mimic in mimics.items():
        (at, to), (its, its_v) = _places(model, name), _places(model, mimic.joint)
        q[at] = float(mimic.multiplier) * q[its] + float(mimic.offset)
        v[to], a[to] = float(mimic.multiplier) * v[its_v], float(mimic.multiplier) * a[its_v]
    return q, v, a


def _coupled(model: "mujoco.MjModel", mimics: Mapping[str, Mimic], T: Array) -> Array:
    """T with the rows of followers."""
    for name, mimic in mimics.items():
        T[_places(model, name)[1]] = float(mimic.multiplier) * T[_places(model, mimic.joint)[1]]
    return T


def _converted(coordinates: object, model: "mujoco.MjModel", q: Array, v: Array, a: Array
               ) -> tuple[Array, Array, Array, Array]:
    """Our q, v, a, and T with v = T v_ours.  Free joints: linear velocity in the body's frame."""
    parts = list(coordinates)  # type: ignore[call-overload]
    Q, V, A = np.zeros(sum(len(c.q) for c in parts)), *np.zeros((2, sum(len(c.v) for c in parts)))
    T = np.zeros((model.nv, len(V)))
    for c in parts:
        at, to = _places(model, c.joint)
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
