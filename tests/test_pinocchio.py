"""Every function of a scene equals Pinocchio's, on real robots in random states.

Robots are read from the same URDF files.  Ours snaps entries of rotations within 1e-11 of 0 and ±1, so
Pinocchio gets the files with right angles written in full: 1.57079632679 as 1.5707963267948966.
Coordinates that follow others are projected out of Pinocchio's full model.
"""

import importlib.metadata
import re
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from tests import evaluation

from coscrew_codegen.dynamics import derive
from coscrew_codegen.scene_functions import SceneFunctions
from coscrew_codegen.dynamics.identifiers import identifiers
from coscrew_codegen.dynamics.model import WORLD, Joint, Kind
from coscrew_codegen.dynamics.scene import Applied, Scene
from coscrew_codegen.effects import EFFECTS
from coscrew_codegen.scene_files.urdf import read_urdf

pin = pytest.importorskip("pinocchio", reason="no wheel for this platform")

STATES = 8
DOUBLE, SINGLE = 2.0**-53, 2.0**-24

# file, whether its base is free, whether followers follow
ROBOTS = (
    ("ur_description/urdf/ur5_robot.urdf", False, False),
    ("panda_description/urdf/panda.urdf", False, True),
    ("kinova_description/robots/kinova.urdf", False, False),
    ("xarm_description/urdf/xarm7.urdf", False, False),
    ("allegro_hand_description/urdf/allegro_left_hand.urdf", False, False),
    ("tiago_description/robots/tiago.urdf", False, False),
    ("baxter_description/urdf/baxter.urdf", False, False),
    ("double_pendulum_description/urdf/double_pendulum.urdf", False, False),
    ("finger_edu_description/robots/finger_edu.urdf", False, False),
    ("solo_description/robots/solo12.urdf", True, False),
    ("anymal_b_simple_description/robots/anymal.urdf", True, False),
    ("go2_description/urdf/go2.urdf", True, False),
    ("bolt_description/robots/bolt.urdf", True, False),
    ("g1_description/urdf/g1_29dof_rev_1_0.urdf", True, False),
    ("talos_data/robots/talos_reduced.urdf", True, False),
    ("simple_humanoid_description/urdf/simple_humanoid.urdf", True, False),
    ("pr2_description/urdf/pr2.urdf", False, True),
    ("alexander_description/urdf/alexander_v1.lowerBodyOnly.urdf", True, False),
)


@dataclass(frozen=True)
class Robot:
    """A robot as both see it.  `follow` maps our speeds to Pinocchio's."""

    functions: SceneFunctions
    model: "pin.Model"
    follow: np.ndarray
    offset: np.ndarray  # of Pinocchio's coordinates with one number, by speed

    def states(self, seed: int = 0):
        """Random q, v, a of ours, a row a state, each number a float32."""
        rng = np.random.default_rng(seed)
        f = self.functions
        q = rng.uniform(-2, 2, (STATES, f.nq))
        for c in f.coordinates:
            if c.kind in ("free", "spherical"):
                x = q[:, c.q.stop - 4:c.q.stop]
                x /= np.linalg.norm(x, axis=1)[:, None]
        v, a = rng.uniform(-2, 2, (2, STATES, f.nv))
        return q, v, a

    def theirs(self, q: np.ndarray) -> np.ndarray:
        """q as Pinocchio orders it."""
        model, f = self.model, self.functions
        found = pin.neutral(model)
        one = np.zeros(f.nv)  # coordinates with one number, at their speeds' places
        for c in f.coordinates:
            if c.kind == "free":
                x = q[c.q.start:c.q.stop]
                found[:7] = [*x[:3], *x[4:], x[3]]
            else:
                one[c.v.start] = q[c.q.start]
        values = self.follow @ one + self.offset
        for joint in model.joints:
            if joint.nv == 1:
                x = values[joint.idx_v]
                found[joint.idx_q:joint.idx_q + joint.nq] = (
                    x if joint.nq == 1 else (np.cos(x), np.sin(x)))
        return found


@cache
def path_of(file: str) -> Path:
    """A robot's file, wherever example-robot-data is installed."""
    files = importlib.metadata.files("example-robot-data")
    return Path(next(f for f in files if f.as_posix().endswith(f"robots/{file}")).locate())


def _in_full(text: str) -> str:
    """The text with right angles written in full."""
    def angle(found: re.Match) -> str:
        x = float(found[0])
        near = round(x / (np.pi / 2)) * np.pi / 2
        return repr(near) if near and abs(x - near) < 1e-11 else found[0]

    return re.sub(r'rpy\s*=\s*"[^"]*"',
                  lambda found: re.sub(r"[-+0-9.eE]+", _safely(angle), found[0].split("=")[1])
                  .join(("rpy=", "")), text)


def _safely(function):
    def apply(found: re.Match) -> str:
        try:
            return function(found)
        except ValueError:
            return found[0]
    return apply


@cache
def robot(file: str, free: bool, mimics: bool) -> Robot:
    """The robot in both libraries."""
    path = path_of(file)
    model = read_urdf(path)
    if free:
        root = ({j.parent for j in model.joints} - {j.child for j in model.joints}).pop()
        joints = model.joints
        if root == WORLD:
            joints = tuple(replace(j, kind=Kind.FREE) if j.parent == WORLD else j for j in joints)
        else:
            joints = (Joint("base", Kind.FREE, WORLD, root), *joints)
        model = replace(model, joints=joints)
    effects = {effect.name: effect for effect in EFFECTS}
    applied = [Applied(effects["gravity"], "",
                       {"g": (Fraction(0), Fraction(0), Fraction(-981, 100))})]
    followers = [j for j in model.joints if j.mimic]
    if mimics:
        applied.append(Applied(effects["mimic"], "", {"joints": "all"}))
    functions = derive(Scene("robot", model, tuple(applied)))
    arguments = (_in_full(path.read_text()), *([pin.JointModelFreeFlyer()] if free else []))
    theirs = pin.buildModelFromXML(*arguments)
    theirs.gravity.linear = np.array([0, 0, -9.81])
    follow, offset = np.zeros((theirs.nv, functions.nv)), np.zeros(theirs.nv)
    places = {}
    for c in functions.coordinates:
        number = 1 if c.kind == "free" else theirs.getJointId(c.joint)
        start = theirs.joints[number].idx_v
        places[c.joint] = c.v.start
        for k in range(len(c.v)):
            follow[start + k, c.v.start + k] = 1
    for joint in followers if mimics else ():
        place = theirs.joints[theirs.getJointId(joint.name)].idx_v
        follow[place, places[joint.mimic.joint]] = float(joint.mimic.multiplier)
        offset[place] = float(joint.mimic.offset)
    return Robot(functions, theirs, follow, offset)


ALL = pytest.mark.parametrize("file, free, mimics", ROBOTS, ids=[r[0].split("/")[-1] for r in ROBOTS])


def _ours(x: Robot, name: str, *arguments: np.ndarray, dtype=np.float64) -> np.ndarray:
    program = next(f.program for f in x.functions.functions if f.name == name)
    arithmetic = evaluation.SINGLE if dtype == np.float32 else evaluation.DOUBLE
    columns = [list(a.astype(dtype).T) for a in arguments]
    found = evaluation.evaluator(program, arithmetic)(columns)
    return np.stack([np.broadcast_to(np.asarray(x, dtype), STATES) for x in found], -1)


def _error(found: np.ndarray, wanted: np.ndarray) -> float:
    """The largest difference, relative to the largest number."""
    wanted = np.reshape(wanted, -1)
    return float(np.abs(np.reshape(found, -1) - wanted).max() / max(np.abs(wanted).max(), 1e-300))


@ALL
def test_inverse_dynamics_is_pinocchios(file, free, mimics):
    x = robot(file, free, mimics)
    q, v, a = x.states()
    found = _ours(x, "inverse_dynamics", q, v, a)
    data = x.model.createData()
    for k in range(STATES):
        wanted = x.follow.T @ pin.rnea(x.model, data, x.theirs(q[k]), x.follow @ v[k],
                                       x.follow @ a[k])
        assert _error(found[k], wanted) <= 1e-12


@ALL
def test_mass_matrix_and_forward_dynamics_are_pinocchios(file, free, mimics):
    x = robot(file, free, mimics)
    q, v, tau = x.states(1)
    masses = _ours(x, "mass_matrix", q)
    found = _ours(x, "forward_dynamics", q, v, tau)
    data = x.model.createData()
    for k in range(STATES):
        theirs = x.theirs(q[k])
        upper = np.triu(pin.crba(x.model, data, theirs))
        M = x.follow.T @ (upper + np.triu(upper, 1).T) @ x.follow
        assert _error(masses[k], M) <= 1e-12
        bias = x.follow.T @ pin.nle(x.model, data, theirs, x.follow @ v[k])
        wanted = np.linalg.solve(M, tau[k] - bias)
        if not mimics:
            wanted = x.follow.T @ pin.aba(x.model, data, theirs, x.follow @ v[k],
                                          x.follow @ tau[k])
        assert _error(found[k], wanted) <= max(1e-12, DOUBLE * np.linalg.cond(M))


@ALL
def test_single_precision_is_within_its_condition(file, free, mimics):
    """The error of single precision, from states that single precision can hold: RNEA within 100 u of
    the largest torque, ABA within 100 u |M^-1| (|tau| + |bias|)."""
    x = robot(file, free, mimics)
    q, v, a = (y.astype(np.float32).astype(np.float64) for y in x.states(2))
    exact = _ours(x, "inverse_dynamics", q, v, a)
    found = _ours(x, "inverse_dynamics", q, v, a, dtype=np.float32)
    assert found.dtype == np.float32
    assert _error(found, exact) <= 100 * SINGLE
    tau = exact.astype(np.float32).astype(np.float64)
    exact = _ours(x, "forward_dynamics", q, v, tau)
    found = _ours(x, "forward_dynamics", q, v, tau, dtype=np.float32)
    masses = _ours(x, "mass_matrix", q).reshape(STATES, x.functions.nv, -1)
    bias = _ours(x, "bias_torques", q, v)
    for k in range(STATES):
        torque = np.abs(tau[k]).max() + np.abs(bias[k]).max()
        scale = np.abs(np.linalg.inv(masses[k])).sum(1).max() * torque
        assert np.abs(found[k] - exact[k]).max() <= 100 * SINGLE * scale


@ALL
def test_energies_poses_twists_and_jacobians_are_pinocchios(file, free, mimics):
    x = robot(file, free, mimics)
    q, v, _ = x.states(3)
    energy = _ours(x, "energy", q, v)
    poses = _ours(x, "body_poses", q).reshape(STATES, -1, 12)
    twists = _ours(x, "body_twists", q, v).reshape(STATES, -1, 6)
    data = x.model.createData()
    names = dict(zip(x.functions.bodies, identifiers(x.functions.bodies), strict=True))
    jacobians = {f.name: _ours(x, f.name, q) for f in x.functions.functions
                 if f.name.startswith("jacobian_")}
    compared = 0
    for k in range(STATES):
        theirs = x.theirs(q[k])
        pin.computeJointJacobians(x.model, data, theirs)
        kinetic = pin.computeKineticEnergy(x.model, data, theirs, x.follow @ v[k])
        potential = pin.computePotentialEnergy(x.model, data, theirs)
        assert _error(energy[k], np.array([kinetic, potential])) <= 1e-12
        pin.framesForwardKinematics(x.model, data, theirs)
        for number, (body, name) in enumerate(names.items()):
            if not x.model.existBodyName(body):
                continue
            frame = x.model.getFrameId(body, pin.BODY)
            J = pin.getFrameJacobian(x.model, data, frame, pin.LOCAL) @ x.follow
            assert _error(poses[k, number], data.oMf[frame].homogeneous[:3]) <= 1e-12
            scale = max(np.abs(J).max(), 1) * np.abs(v[k]).max()
            assert np.abs(twists[k, number] - J @ v[k]).max() <= 1e-12 * scale
            if f"jacobian_{name}" in jacobians:
                assert _error(jacobians[f"jacobian_{name}"][k], J) <= 1e-12
                compared += 1
    assert compared >= STATES
