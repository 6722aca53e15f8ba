"""Differentiates the laws of effects: the torque of an energy, damping and stiffness of torques.

A law is recorded separately, as a function of its coordinate, and differentiated.

Implicit steps use the damping d and the stiffness k of a torque u(q, v):

    d = -∂u/∂v,  k = -∂u/∂q

if these do not depend on q and v.  States x of an effect, which move by x' = r(q, v), add
-∂u/∂x ∂r/∂v to k: within a step they move as q does.  If d and k depend on q and v, negative values
are replaced by 0; these slopes are left to the explicit part of the step.  Where u saturates, its
slopes vanish, although a step may still jump over the point where u changes sign; there the slope
of the secant through that point is used:

    dry friction (u is 0 at v = 0):       d = max(-∂u/∂v, |u|/|v|)
    a limit (sat u, |sat u| <= limit):    d and k of u, times limit/max(|u|, limit)
    a speed without load:                 d = max(d, |u|/(speed - v sgn u)), u after its limit

The last is the line to the state in which the torque vanishes, the limit's own slope where that
acts.  With the larger of these d at the start and in the middle of a step, u_m there, no step of
any length h passes that speed: from v it leads to v + h (u_m + d (v_m - v))/(I + θ h d)."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property

from coscrew_codegen.algebra.recording import numbers
from coscrew_codegen.algebra.recording.naming import NamePart
from coscrew_codegen.algebra.recording.numbers import (
    Number,
    absolute,
    less,
    maximum,
    minimum,
    tanh,
    where,
)
from coscrew_codegen.algebra.recording.recorder import Recorder, array
from coscrew_codegen.dynamics.forces.effect_parameters import settings
from coscrew_codegen.program import Program, differentiate
from coscrew_codegen.program.differentiate import Dual
from coscrew_codegen.scene.effect import CoordinateState, Force, Slopes, Torque, Values, required
from coscrew_codegen.scene.scene import Setting

Law = Callable[[CoordinateState, Values], Torque]

_AT_REST = Fraction(1, 10**30)
"""Smallest divisor |v| in |u|/|v|, in rad/s or m/s, and smallest limit, so that there is no 0/0."""


@dataclass(frozen=True)
class JointEffect:
    """An effect's law at a coordinate; its values are evaluated once, among those of the effect."""

    law: Law
    at: CoordinateState
    values: Mapping[str, Setting]
    part: NamePart
    freedom: int = 0  # the number of the velocity among those of the joint
    later: "JointEffect | None" = None  # within the step, if its damping starts at once
    over: Number | None = None  # the time for which a torque with a lag has followed its demand

    @cached_property
    def torque(self) -> Torque:
        """The law's Torque, with the torque derived from the energy if it gives none, and limited;
        with a lag the torque that follows it."""
        result, torque = self._stated, self.demanded
        with self.at.q.recorder.resumed(self.part):
            if result.lag is not None:
                x, = self.at.x
                result = replace(result, rates=((torque - x) / result.lag,))
                torque = x if self.over is None else self.followed(self.over)
            torque.recorder.label("tau", torque)
            return replace(result, torque=torque)

    @cached_property
    def demanded(self) -> Number:
        """The limited torque, without a lag."""
        result = self._stated
        torque = result.torque
        if result.limit is not None and result.energy is not None:
            raise TypeError("a torque with a limit has no energy: beyond the limit it would be "
                            "another")
        with self.at.q.recorder.resumed(self.part):
            if torque is None:
                torque = self._replayed(self._own.torque)
            if result.limit is not None and not torque.is_zero:
                above, below = _limits(result, self.at.v)
                torque = maximum(minimum(torque, above), -below)
            return torque

    def followed(self, time: Number) -> Number:
        """The torque with a lag after a time in which the demand is this one."""
        x, = self.at.x
        with self.at.q.recorder.resumed(self.part):
            return x + self._share(time) * (self.demanded - x)

    def _share(self, time: Number) -> Number:
        """1 - exp(-time/lag), true also for small times: 2 s/(1 + s), s = tanh(time/(2 lag))."""
        s = tanh(time / (required(self._stated.lag) * 2))
        return 2 * s / (1 + s)

    @property
    def saturated(self) -> Number:
        """1 where the limit reduces the torque, else 0, for a torque with a limit."""
        with self.at.q.recorder.resumed(self.part):
            torque, limit = required(self._stated.torque), _limit(self._stated, self.at.v)
            return where(less(limit, absolute(torque)), 1, 0)

    @cached_property
    def slopes(self) -> Slopes:
        """The damping and stiffness of the torque."""
        d, k = self._stated.damping, self._stated.stiffness
        with self.at.q.recorder.resumed(self.part):
            d = self._replayed(self._own.damping) if d is None else d
            k = self._replayed(self._own.stiffness) if k is None else k
            if self._stated.lag is not None:
                share = d.like(0) if self.over is None else self._share(self.over)
                d, k = share * d, share * k
            if self.later:
                d = maximum(d, self.later.slopes.damping)
            return Slopes(d, k)

    def with_later(self, later: "JointEffect") -> "JointEffect":
        """This one, with the larger damping of both if its damping starts at once, or leads to a
        speed without load."""
        return replace(self, later=later) if self.looks_ahead else self

    @property
    def looks_ahead(self) -> bool:
        """True if its damping in a step also depends on the velocities that it leads to."""
        return bool(self._stated.ahead) or self._stated.no_load is not None

    @cached_property
    def _stated(self) -> Torque:
        recorder = self.at.q.recorder
        with recorder.resumed(self.part):
            return self.law(self.at, settings(recorder, self.values, self.at.t))

    @cached_property
    def _own(self) -> "_Law":
        return _recorded(self.law, self.values, self.at)

    def _replayed(self, value: Number) -> Number:
        """A value of the separately recorded law, at this coordinate."""
        recorder, at = self.at.q.recorder, self.at
        p = [recorder.argument("p")] if recorder.has("p") else []
        held = [] if at.holding is None else [at.holding]
        return recorder.replay(self._own.program(value), at.q, at.v, at.t, *held, *p,
                               *([at.x] if at.x else []))[0]


def _limits(stated: Torque, v: Number) -> tuple[Number, Number]:
    """The largest torques along +v and -v: limit, less by v/no_load where they drive."""
    limit, no_load = required(stated.limit), stated.no_load
    if no_load is None:
        return limit, limit
    share = v / no_load
    above, below = (limit * minimum(maximum(1 - x, 0), 1) for x in (share, -share))
    return above, below


def _limit(stated: Torque, v: Number) -> Number:
    """The largest torque in the direction of the stated one."""
    above, below = _limits(stated, v)
    return above if stated.no_load is None else where(less(required(stated.torque), 0), below,
                                                      above)


def _recorded(law: Law, values: Mapping[str, Setting], outer: CoordinateState) -> "_Law":
    """Records the law as a function of q, v, t, the torque that holds the joint, the run-time
    parameters of the outer recording and the effect's states.  The holding torque is explicit: it
    has no slope."""
    names = ("q", "v", "t") if outer.holding is None else ("q", "v", "t", "holding")
    recorder = Recorder([*(array(name, ()) for name in names), *(
        a for a in outer.q.recorder.inputs if a.name == "p"), *(
            [array("x", (len(outer.x),))] if outer.x else [])])
    q, v, t, *held = (recorder.argument(name)[0] for name in names)
    at = CoordinateState(q, v, t, held[0] if held else None,
                         recorder.argument("x") if outer.x else ())
    return _Law(at, law(at, settings(recorder, values, at.t)))


@dataclass(frozen=True)
class _Law:
    """A separately recorded law, and its derivatives."""

    at: CoordinateState
    stated: Torque

    @property
    def recorder(self) -> Recorder:
        """The recorder of the law."""
        return self.at.q.recorder

    @cached_property
    def torque(self) -> Number:
        """The torque before it is limited."""
        if self.stated.torque is not None:
            return self.stated.torque
        energy = self.stated.energy
        if energy is None:
            raise TypeError("an effect gives a torque or an energy; this one gives neither")
        if {self.at.v.operand, self.at.t.operand} & self.program(energy).used_inputs():
            raise TypeError("an energy from which a torque follows depends on q alone, not on v or "
                            "t")
        return -self._slope(energy, "q")

    @property
    def damping(self) -> Number:
        """d."""
        slope = -self._slope(self.torque, "v")
        if self._moves(slope):
            slope = maximum(slope, self._secant() if self._rests() else 0)
        slope = slope * self._share()
        return slope if self.stated.no_load is None else maximum(slope, self._to_no_load())

    @property
    def stiffness(self) -> Number:
        """k."""
        slope = -self._slope(self.torque, "q")
        for place, rate in enumerate(self.stated.rates):
            slope = slope - self._slope(self.torque, "x", place) * self._slope(rate, "v")
        if self._moves(slope):
            slope = maximum(slope, 0)
        return slope * self._share()

    def program(self, value: Number) -> Program:
        """The Program that computes a value."""
        return self.recorder.program("law", [(array("value", ()), [value])])

    def _slope(self, value: Number, by: str, place: int = 0) -> Number:
        """∂value/∂q or ∂v, or by a component of x."""
        recorder = self.recorder
        one = recorder.number(1)
        inputs = [[Dual(x, (one if a.name == by and k == place else None,))
                   for k, x in enumerate(recorder.argument(a.name))] for a in recorder.inputs]
        (result,) = differentiate.tangent(self.program(value), recorder.arithmetic, numbers, inputs)
        return recorder.number(0) if result.slopes[0] is None else result.slopes[0]

    def _secant(self) -> Number:
        """|u|/|v|."""
        return absolute(self.torque) / maximum(absolute(self.at.v), _AT_REST)

    def _share(self) -> Number | int:
        """The factor on the slopes where the torque exceeds its limit."""
        if self.stated.limit is None:
            return 1
        limit = _limit(self.stated, self.at.v)
        positive = limit if limit.constant else maximum(limit, _AT_REST)  # 0 at run time: no 0/0
        return limit / maximum(absolute(self.torque), positive)

    def _to_no_load(self) -> Number:
        """|u|/(speed - v sgn u): along the line to the state in which the torque vanishes."""
        limit, v, torque = _limit(self.stated, self.at.v), self.at.v, self.torque
        if torque.is_zero:
            return torque
        left = required(self.stated.no_load) - where(less(torque, 0), -v, v)
        return minimum(absolute(torque), limit) / maximum(left, _AT_REST)

    def _moves(self, value: Number) -> bool:
        """Returns whether the value depends on q or v."""
        return bool({self.at.q.operand, self.at.v.operand} & self.program(value).used_inputs())

    def _rests(self) -> bool:
        """Returns whether the torque is 0 at v = 0 for all other inputs."""
        given = [self.recorder.numbers([0]) if a.name == "v" else self.recorder.argument(a.name)
                 for a in self.recorder.inputs]
        return self.recorder.replay(self.program(self.torque), *given)[0].is_zero


def own_power(x: Torque | Force, whole: Callable[[], Number]) -> Number | int:
    """The power of the part without potential energy; `whole` computes that of the whole."""
    if x.power is not None:
        return x.power
    return whole() if x.energy is None else 0
