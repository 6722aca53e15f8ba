"""Rotors behind elastic gears: a rotor of inertia J at the angle θ and speed ω, both at the joint's
side of the gear, drives a joint at q, v by the torque k (θ - q) + d (ω - v).

In an implicit step its row is eliminated.  With the weights (w, c) of the gear's damping and
stiffness and (w_m, c_m) of its motors', which push by u, the step's accelerations α and a meet

    (J + w_m) α = U - S - w (α - a),   U = u - c_m ω,   S = k (θ - q) + (d + c) (ω - v),

so that, with J' = J + w_m, the inertia w J'/(J' + w) and the torque (S J' + w U)/(J' + w) act on
the joint: stable for any k, and for k → ∞ an armature J.
"""

from collections.abc import Callable
from dataclasses import dataclass, field, replace

from coscrew_codegen.algebra.recording.numbers import Number
from coscrew_codegen.dynamics.forces.linearization import JointEffect
from coscrew_codegen.scene.effect import Elastic, required

Weights = Callable[..., tuple[Number, Number]]


@dataclass(frozen=True)
class Rotor:
    """The rotor of a gear, and the motors that drive it."""

    gears: list[JointEffect] = field(default_factory=list)  # one
    motors: list[JointEffect] = field(default_factory=list)

    @property
    def gear(self) -> JointEffect:
        """The gear's effect on the joint."""
        return self.gears[0]

    @property
    def elastic(self) -> Elastic:
        """The numbers of the gear."""
        return required(self.gear.torque.elastic)

    @property
    def driven(self) -> Number:
        """The torque of the motors."""
        total = self.gear.at.v.like(0)
        for motor in self.motors:
            total = total + required(motor.torque.torque)
        return total

    @property
    def acceleration(self) -> Number:
        """α where nothing is implicit."""
        return (self.driven - required(self.gear.torque.torque)) / self.elastic.inertia

    def with_later(self, later: "Rotor") -> "Rotor":
        """The rotor, with the larger damping of motors that start at once."""
        return replace(self, motors=[x.with_later(y) for x, y in zip(
            self.motors, later.motors, strict=True)])


@dataclass(frozen=True)
class Eliminated:
    """J' α = U - S - w (α - a)."""

    inertia: Number  # J'
    mass: Number  # w
    driven: Number  # U
    held: Number  # S
    rate: Number  # the damping of the motors over the inertia that it acts on

    @property
    def on_joint(self) -> tuple[Number, Number]:
        """The torque and the inertia that act on the joint."""
        share = self.mass / (self.inertia + self.mass)
        return self.held + share * (self.driven - self.held), share * self.inertia

    def acceleration(self, a: Number) -> Number:
        """α for the joint's acceleration."""
        return (self.driven - self.held + self.mass * a) / (self.inertia + self.mass)


def eliminated(now: Rotor, start: Rotor, weights: Weights, beside: Number | None = None
               ) -> Eliminated:
    """The rotor's row in a step, with the torques of motors `now` linear about those at the step's
    start; `beside` is the inertia that the joint moves."""
    elastic, at = start.elastic, start.gear.at
    J, (angle, speed) = elastic.inertia, at.x
    mobility = 1 / J if beside is None else 1 / J + 1 / beside
    w, c = weights(elastic.damping, elastic.stiffness, elastic.damping * mobility)
    moved = J if beside is None else J + w / (w + beside) * beside
    held = elastic.stiffness * (angle - at.q) + (elastic.damping + c) * (speed - at.v)
    driven, inertia, rate = now.driven, J, J.like(0)
    for motor in start.motors:
        rate = rate + motor.slopes.damping / moved
    for motor, later in zip(start.motors, now.motors, strict=True):
        slopes = motor.slopes
        own, own_c = weights(slopes.damping, slopes.stiffness, rate)
        driven = driven - own_c * speed
        if later is not motor:
            driven = driven + slopes.damping * (later.at.v - speed)
        inertia = inertia + own
    return Eliminated(inertia, w, driven, held, rate)
