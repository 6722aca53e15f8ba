"""Accelerations of a mechanism: Pinocchio's, with the laws of effects written here by hand.

A state is y = (q; v) as in scene files: of a free joint position and quaternion (x, y, z, w),
linear and angular velocity in the body's frame."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import pinocchio as pin

from tests.support.motions.mechanism import WORLD, Acting, Joint, Mechanism, State, Value

Along = Callable[[float, float, float], float]
"""(t, q, v) of a joint -> torque."""
_FUNCTIONS = {name: getattr(math, name) for name in ("sin", "cos", "exp", "tanh", "sqrt", "pi")}


def of_time(value: Value) -> Callable[[float], float]:
    """A number or a formula in t."""
    if isinstance(value, str):
        code = compile(value, "formula", "eval")
        return lambda t: float(eval(code, {**_FUNCTIONS, "abs": abs, "min": min, "max": max,
                                           "t": t}))
    number = float(value)  # type: ignore[arg-type]
    return lambda t: number


def _numbers(values: Mapping[str, Value], *names: str, default: float = 0.0) -> tuple[float, ...]:
    return tuple(float(values.get(name, default)) for name in names)  # type: ignore[arg-type]


def _actuator(x: Mapping[str, Value], joint: Joint) -> Along:
    most = _numbers(x, "limit", default=math.inf)[0]

    def saturated(law: Along) -> Along:
        return lambda t, q, v: min(max(law(t, q, v), -most), most)

    if x["kind"] == "torque":
        torque = of_time(x["torque"])
        return saturated(lambda t, q, v: torque(t))
    if x["kind"] == "pd":
        kp, kd = _numbers(x, "kp", "kd")
        target, target_v = of_time(x["target"]), of_time(x.get("target_v", 0.0))
        return saturated(lambda t, q, v: kp * (target(t) - q) + kd * (target_v(t) - v))
    voltage, (kt, ke, R) = of_time(x["voltage"]), _numbers(x, "kt", "ke", "R")
    gear = _numbers(x, "gear", default=1.0)[0]
    return saturated(lambda t, q, v: gear * kt / R * (voltage(t) - ke * gear * v))


def _stribeck(x: Mapping[str, Value], joint: Joint) -> Along:
    tau_c, tau_s, v_s, eps = _numbers(x, "tau_c", "tau_s", "v_s", "eps")
    return lambda t, q, v: -(tau_c + (tau_s - tau_c) * math.exp(-min((v / v_s)**2, 700.0))
                             ) * math.tanh(v / eps)


def _coulomb(x: Mapping[str, Value], joint: Joint) -> Along:
    tau_c, eps = _numbers(x, "tau_c", "eps")
    return lambda t, q, v: -tau_c * math.tanh(v / eps)


def _spring(x: Mapping[str, Value], joint: Joint) -> Along:
    k, q0 = _numbers(x, "k", "q0")
    return lambda t, q, v: -k * (q - q0)


def _viscous(x: Mapping[str, Value], joint: Joint) -> Along:
    d, = _numbers(x, "d")
    return lambda t, q, v: -d * v


def _joint_drag(x: Mapping[str, Value], joint: Joint) -> Along:
    c, = _numbers(x, "c")
    return lambda t, q, v: -c * abs(v) * v


def _limit(x: Mapping[str, Value], joint: Joint) -> Along:
    """Hunt and Crossley's law at both ends."""
    k, alpha = _numbers(x, "k", "alpha")
    lower = -math.inf if joint.lower is None else joint.lower
    upper = math.inf if joint.upper is None else joint.upper

    def law(t: float, q: float, v: float) -> float:
        if q < lower:
            return max(k * (lower - q)**1.5 * (1 - 1.5 * alpha * v), 0.0)
        if q > upper:
            return -max(k * (q - upper)**1.5 * (1 + 1.5 * alpha * v), 0.0)
        return 0.0

    return law


_ALONG = {"actuator": _actuator, "stribeck": _stribeck, "coulomb": _coulomb, "spring": _spring,
          "viscous": _viscous, "joint_drag": _joint_drag, "limit": _limit}
_ON_BODIES = ("spring_damper", "drag", "wrench")


def _of_kind(joint: Joint) -> "pin.JointModel":
    axis = np.array(joint.axis) / np.linalg.norm(joint.axis)
    return {"continuous": pin.JointModelRevoluteUnaligned,
            "revolute": pin.JointModelRevoluteUnaligned,
            "prismatic": pin.JointModelPrismaticUnaligned}[joint.kind](axis) \
        if joint.kind not in ("spherical", "free") else \
        {"spherical": pin.JointModelSpherical, "free": pin.JointModelFreeFlyer}[joint.kind]()


@dataclass(frozen=True)
class Place:
    """Places of a joint's numbers in q and v."""

    joint: Joint
    number: int  # Pinocchio's
    q: slice
    v: slice


@dataclass(frozen=True)
class Dynamics:
    """The equations of motion of a mechanism."""

    mechanism: Mechanism

    @cached_property
    def model(self) -> "pin.Model":
        model, numbers = pin.Model(), {WORLD: 0}
        inertias = {b.name: pin.Inertia(b.mass, np.array(b.com), np.diag(b.moments))
                    for b in self.mechanism.bodies}
        model.gravity = pin.Motion.Zero()
        for joint in self.mechanism.joints:
            at = pin.SE3(pin.rpy.rpyToMatrix(*joint.rpy), np.array(joint.xyz))
            number = model.addJoint(numbers[joint.parent], _of_kind(joint), at, joint.name)
            model.appendBodyToJoint(number, inertias[joint.child], pin.SE3.Identity())
            numbers[joint.child] = number
        for x in self.mechanism.acting:
            if x.effect == "gravity":
                model.gravity.linear = np.array(x.values.get("g", (0.0, 0.0, -9.81)))
            if x.effect == "armature":
                inertia, rotor = _numbers(x.values, "inertia", "rotor")
                gear, = _numbers(x.values, "gear", default=1.0)
                index = model.joints[model.getJointId(x.on)].idx_v
                model.armature[index] = inertia + gear**2 * rotor
        return model

    @cached_property
    def data(self) -> "pin.Data":
        return self.model.createData()

    @cached_property
    def places(self) -> tuple[Place, ...]:
        results = []
        for joint in self.mechanism.joints:
            number = self.model.getJointId(joint.name)
            at = self.model.joints[number]
            results.append(Place(joint, number, slice(at.idx_q, at.idx_q + at.nq),
                                 slice(at.idx_v, at.idx_v + at.nv)))
        return tuple(results)

    @cached_property
    def _numbers(self) -> dict[str, int]:
        """Pinocchio's joint of each body."""
        return {WORLD: 0} | {p.joint.child: p.number for p in self.places}

    @cached_property
    def _along(self) -> tuple[tuple[int, int, Along], ...]:
        at = {p.joint.name: p for p in self.places}
        return tuple((at[x.on].q.start, at[x.on].v.start, _ALONG[x.effect](
            x.values, at[x.on].joint)) for x in self.mechanism.acting if x.effect in _ALONG)

    @cached_property
    def _on_bodies(self) -> tuple[Acting, ...]:
        return tuple(x for x in self.mechanism.acting if x.effect in _ON_BODIES)

    def accelerations(self, t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """Pinocchio's articulated-body algorithm under the effects' torques and forces."""
        tau = np.zeros(self.model.nv)
        for i, j, law in self._along:
            tau[j] += law(t, q[i], v[j])
        forces = self._forces(t, q, v) if self._on_bodies else None
        if self.followers:
            return self._following(q, v, tau, forces)
        if forces is None:
            return pin.aba(self.model, self.data, q, v, tau)
        return pin.aba(self.model, self.data, q, v, tau, forces)

    @cached_property
    def followers(self) -> tuple[tuple[Place, Place], ...]:
        """Joints that follow others, with their leaders."""
        at = {p.joint.name: p for p in self.places}
        return tuple((p, at[p.joint.mimic.joint]) for p in self.places if p.joint.mimic)

    @cached_property
    def _freedoms(self) -> np.ndarray:
        """The velocities of all joints from those of the leaders."""
        T = np.eye(self.model.nv)
        for follower, leader in self.followers:
            assert follower.joint.mimic
            T[follower.v.start, leader.v.start] = follower.joint.mimic.multiplier
        return np.delete(T, [p.v.start for p, _ in self.followers], 1)

    def _following(self, q: np.ndarray, v: np.ndarray, tau: np.ndarray,
                   forces: "list[pin.Force] | None") -> np.ndarray:
        """Accelerations under the constraints, by d'Alembert's principle."""
        T, rest = self._freedoms, (q, v, 0 * v)
        bias = pin.rnea(self.model, self.data, *rest, *(() if forces is None else (forces,)))
        M = np.triu(pin.crba(self.model, self.data, q))
        M = M + np.triu(M, 1).T
        return T @ np.linalg.solve(T.T @ M @ T, T.T @ (tau - bias))

    def followed(self, q: np.ndarray, v: np.ndarray) -> None:
        """Sets the coordinates and velocities of followers.  (…, nq), (…, nv)."""
        for follower, leader in self.followers:
            mimic = follower.joint.mimic
            assert mimic
            q[..., follower.q] = mimic.multiplier * q[..., leader.q] + mimic.offset
            v[..., follower.v] = mimic.multiplier * v[..., leader.v]

    def _forces(self, t: float, q: np.ndarray, v: np.ndarray) -> list["pin.Force"]:
        """The wrench on each body in its own frame."""
        pin.forwardKinematics(self.model, self.data, q, v)
        total = [np.zeros(6) for _ in range(self.model.njoints)]
        for x in self._on_bodies:
            for body, point, force in self._at_points(x, t):
                number = self._numbers[body]
                local = self.data.oMi[number].rotation.T @ force
                total[number] += np.concatenate((local, np.cross(point, local)))
        return [pin.Force(f) for f in total]

    def _at_points(self, x: Acting, t: float) -> list[tuple[str, np.ndarray, np.ndarray]]:
        """(body, point in its frame, force in the world's) of an effect on bodies."""
        if x.effect == "spring_damper":
            return self._spring_damper(x.values)
        point = np.array(x.values.get("point", (0.0, 0.0, 0.0)))
        if x.effect == "wrench":
            force = np.array([of_time(f)(t) for f in x.values["force"]])  # type: ignore[union-attr]
            return [(x.on, point, force)]
        u = self._of_point(x.on, point)[1]
        if x.values["kind"] == "stokes":
            return [(x.on, point, -_numbers(x.values, "b")[0] * u)]
        rho, area = _numbers(x.values, "rho", "area")
        return [(x.on, point, -rho * area * np.linalg.norm(u) * u / 2)]

    def _spring_damper(self, values: Mapping[str, Value]
                       ) -> list[tuple[str, np.ndarray, np.ndarray]]:
        first, second = map(str, values["bodies"])  # type: ignore[arg-type]
        points = [np.array(values.get(name, (0.0, 0.0, 0.0))) for name in ("first", "second")]
        (p, u), (r, w) = (self._of_point(body, point) for body, point in
                          zip((first, second), points, strict=True))
        k, d, rest = _numbers(values, "k", "d", "length")
        apart = r - p
        length = np.linalg.norm(apart)
        along = apart / length
        force = (k * (length - rest) + d * along @ (w - u)) * along
        return [(first, points[0], force), (second, points[1], -force)]

    def _of_point(self, body: str, point: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Position and velocity of a body's point, in the world's frame."""
        number = self._numbers[body]
        if not number:
            return point, np.zeros(3)
        at, twist = self.data.oMi[number], self.data.v[number]
        return at.act(point), at.rotation @ (twist.linear + np.cross(twist.angular, point))

    def packed(self, q: State, v: State) -> np.ndarray:
        """y of a start; joints that it does not name are at zero."""
        found_q, found_v = pin.neutral(self.model), np.zeros(self.model.nv)
        for p in self.places:
            found_q[p.q] = q.get(p.joint.name, found_q[p.q])
            found_v[p.v] = v.get(p.joint.name, found_v[p.v])
        self.followed(found_q, found_v)
        return np.concatenate((self.normalized(found_q), found_v))

    def normalized(self, q: np.ndarray) -> np.ndarray:
        """q with quaternions of norm 1."""
        q = np.array(q)
        for p in self._quaternions:
            q[p] /= math.sqrt(q[p] @ q[p])
        return q

    @cached_property
    def _quaternions(self) -> tuple[slice, ...]:
        return tuple(slice(p.q.stop - 4, p.q.stop) for p in self.places
                     if p.joint.kind in ("free", "spherical"))

    def rates(self, t: float, y: np.ndarray) -> np.ndarray:
        """y'."""
        nq = self.model.nq
        v = y[nq:]
        if not self._quaternions:
            return np.concatenate((v, self.accelerations(t, y[:nq], v)))
        q = self.normalized(y[:nq])
        return np.concatenate((self._q_rates(y[:nq], q, v), self.accelerations(t, q, v)))

    def _q_rates(self, y: np.ndarray, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        result = np.empty(len(q))
        for p in self.places:
            if p.joint.kind in ("free", "spherical"):
                turn = slice(p.q.stop - 4, p.q.stop)
                result[turn] = _turning(y[turn], v[p.v.stop - 3:p.v.stop])
                if p.joint.kind == "free":
                    rotation = pin.Quaternion(q[turn]).toRotationMatrix()
                    result[p.q.start:turn.start] = rotation @ v[p.v.start:p.v.start + 3]
            else:
                result[p.q] = v[p.v]
        return result

    def energy(self, q: np.ndarray, v: np.ndarray) -> float:
        """Kinetic and gravity's potential energy of a state."""
        return float(pin.computeKineticEnergy(self.model, self.data, q, v)
                     + pin.computePotentialEnergy(self.model, self.data, q))


def _turning(r: np.ndarray, w: np.ndarray) -> np.ndarray:
    """r' = r (w; 0) / 2."""
    x, y, z, s = r
    a, b, c = w / 2
    return np.array([s * a + y * c - z * b, s * b + z * a - x * c, s * c + x * b - y * a,
                     -(x * a + y * b + z * c)])
