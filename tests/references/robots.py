"""Robots of example scenes with Pinocchio's dynamics, and effects written by hand.

Reads the scenes' TOML itself.  With a free base, y holds its position and quaternion (x, y, z, w),
then the joints' angles, then velocities in Pinocchio's order, which is also the scenes'.
"""

import math
import tomllib
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

import numpy as np
import pinocchio as pin

from tests.references.figures import Figure, figure
from tests.references.peer import solved

SCENES = Path(__file__).parents[2] / "examples/scenes"
_NAMES = {"__builtins__": {}, "pi": math.pi, "sin": math.sin, "cos": math.cos}


class Robot:
    """Gravity, armature, viscous and smoothed dry friction, and saturated PD motors."""

    def __init__(self, name: str) -> None:
        self.scene = tomllib.loads((SCENES / f"{name}.toml").read_text())
        self.free = self.scene.get("base") == "free"
        urdf = self.scene.get("model")
        self.model = (pin.buildModelFromUrdf(str(SCENES / urdf), pin.JointModelFreeFlyer())
                      if urdf else _built(self.scene))
        self.model.gravity.linear = np.array([0, 0, -9.81])
        self.joints = [x for x in self.model.names[1:] if x != "root_joint"]
        self.first = self.model.nv - len(self.joints)  # of the motors' speeds in v
        damping, friction = self._of_model("damping"), self._of_model("friction")
        effort = self._of_model("effort")
        effects = self.scene["effects"]
        gears = effects["armature"]
        self.armature = gears["gear"]**2 * self._each(gears["rotor"])
        self.d, self.tau_c, self.limit = damping, friction, effort
        self.eps = effects["coulomb"]["eps"]
        motors = effects["actuator"]
        self.kp, self.kd = self._each(motors["kp"]), self._each(motors["kd"])
        self.target = [_function(motors["target"][x]) for x in self.joints]
        speeds = motors.get("target_v", dict.fromkeys(self.joints, "0"))
        self.target_v = [_function(speeds[x]) for x in self.joints]
        self.model.armature = np.concatenate((np.zeros(self.first), self.armature))
        self.data = self.model.createData()

    def _each(self, value: float | Mapping[str, float]) -> np.ndarray:
        each = [value[x] if isinstance(value, dict) else value for x in self.joints]
        return np.array(each, float)

    def _of_model(self, key: str) -> np.ndarray:
        if "joints" in self.scene:
            tables = [self.scene["joints"][x] for x in self.joints]
            results = [x["limits"][key] if key == "effort" else x[key] for x in tables]
            return np.array(results, float)
        numbers = {"damping": self.model.damping, "friction": self.model.upperDryFrictionLimit,
                   "effort": self.model.upperEffortLimit}[key]
        return np.array(numbers[self.first:])

    def start(self) -> np.ndarray:
        """y at t = 0."""
        given = self.scene["start"]
        q = [float(given["q"].get(x, 0)) for x in self.joints]
        v = [float(given.get("v", {}).get(x, 0)) for x in self.joints]
        if self.free:
            q, v = [*given["q"]["base"], *q], [*given["v"]["base"], *v]
        return np.array([*q, *v], float)

    def split(self, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """q, its quaternion of norm 1, and v."""
        q, v = np.array(y[:self.model.nq]), np.array(y[self.model.nq:])
        if self.free:
            q[3:7] /= np.linalg.norm(q[3:7])
        return q, v

    def torques(self, t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """Torques of motors, and of friction.  (nv)."""
        angle, speed = q[-len(self.joints):], v[self.first:]
        u = (self.kp * (np.array([f(t) for f in self.target]) - angle)
             + self.kd * (np.array([f(t) for f in self.target_v]) - speed))
        friction = self.d * speed + self.tau_c * np.tanh(speed / self.eps)
        motors = np.clip(u, -self.limit, self.limit)
        return np.concatenate((np.zeros(self.first), motors - friction))

    def acceleration(self, t: float, y: np.ndarray) -> np.ndarray:
        """(nv)."""
        q, v = self.split(y)
        return pin.aba(self.model, self.data, q, v, self.torques(t, q, v))

    def rates(self, t: float, y: np.ndarray) -> np.ndarray:
        """y'."""
        q, v = self.split(y)
        moved = v[self.first:]
        if self.free:
            R = pin.Quaternion(q[3:7]).matrix()
            w, turn = y[6], y[3:6]
            moved = np.concatenate((R @ v[:3], (w * v[3:6] + np.cross(turn, v[3:6])) / 2,
                                    [-turn @ v[3:6] / 2], moved))
        return np.concatenate((moved, self.acceleration(t, y)))

    def energy(self, y: np.ndarray) -> float:
        """Kinetic energy, the rotors' included, and gravity's potential energy."""
        q, v = self.split(y)
        pin.crba(self.model, self.data, q)
        M = np.triu(self.data.M) + np.triu(self.data.M, 1).T
        return v @ M @ v / 2 + pin.computePotentialEnergy(self.model, self.data, q)

    def reaction(self, t: float, y: np.ndarray, joint: str) -> np.ndarray:
        """Force and moment on the body that the joint moves, in that body's axes.  (6)."""
        q, v = self.split(y)
        pin.rnea(self.model, self.data, q, v, self.acceleration(t, y))
        return self.data.f[self.model.getJointId(joint)].vector


def figures(robot: Robot, joints: tuple[str, ...], reaction: str, times: tuple[float, ...],
            tolerance: float) -> Iterator[Figure]:
    """Angles and speeds of joints, pose of a free base, energy, reaction of a joint."""
    states = solved(robot.rates, robot.start(), times, tolerance)
    for t, y in zip(times, states, strict=True):
        q, v = robot.split(y)
        named = {}
        if robot.free:
            named = {f"q.base.{i}": x for i, x in enumerate(q[:7])}
            named |= {f"v.base.{i}": x for i, x in enumerate(v[:6])}
        for joint in joints:
            place = robot.joints.index(joint)
            named[f"q.{joint}"] = q[place - len(robot.joints)]
            named[f"v.{joint}"] = v[place - len(robot.joints)]
        named["energy"] = robot.energy(y)
        named |= {f"reaction.{reaction}.{i}": x
                  for i, x in enumerate(robot.reaction(t, y, reaction))}
        yield from (figure(quantity, t, float(x)) for quantity, x in named.items())


def _function(text: str | float) -> Callable[[float], float]:
    code = compile(str(text), "<scene>", "eval")
    return lambda t: eval(code, _NAMES, {"t": t})


def _built(scene: Mapping) -> pin.Model:
    """The model of the scene's own tables, parents first."""
    model, at = pin.Model(), {"world": (0, pin.SE3.Identity())}
    for name, joint in scene["joints"].items():
        number, place = at[joint.get("parent", "world")]
        place = place * _placement(joint.get("origin", {}))
        if joint["type"] == "revolute":
            number = model.addJoint(number, pin.JointModelRevoluteUnaligned(
                np.array(joint["axis"], float)), place, name)
            place = pin.SE3.Identity()
        at[joint["child"]] = number, place
        body = scene["bodies"][joint["child"]]
        model.appendBodyToJoint(number, pin.Inertia(
            body["mass"], np.array(body["com"], float), np.diag(body["inertia"])), place)
    return model


def _placement(origin: Mapping) -> pin.SE3:
    return pin.SE3(pin.rpy.rpyToMatrix(np.array(origin.get("rpy", [0, 0, 0]), float)),
                   np.array(origin.get("xyz", [0, 0, 0]), float))
