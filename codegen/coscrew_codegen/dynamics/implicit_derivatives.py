"""Derivatives of accelerations that are implicit in damping and stiffness at joints, by the rule of
implicit functions: the solution of a linear system is not differentiated.

In one pass, with the velocities v before the step and u at which forces act, a solves

    R = tau_inverse(q, u, a) - tau + m a + c v - d (u - v) = 0,   so   ∂a = -(M + m)⁻¹ ∂R at this a.

The inertia m(d, k, r) and the torque per velocity c(d, k, r) represent the damping d and the
stiffness k, taken at v.  r = d/D, where D is the inertia that the damping acts on: with the joints
nearer to the base at rest, and those beyond free, a unit velocity moves them with y, and

    D = y·(M + m) y,   ∂D = y·∂M y + Σ y² ∂m,   y·∂M/∂q y = 2 ∂T/∂q at the velocities y,

T the kinetic energy and m the inertias beyond; y is stationary."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from coscrew_codegen.algebra.recording import derivatives
from coscrew_codegen.algebra.recording.numbers import Number, add, scaled, subtract
from coscrew_codegen.algebra.recording.recorder import Recorder, array
from coscrew_codegen.dynamics import gradients
from coscrew_codegen.dynamics.algorithms import energies, forward, kicks, rnea_derivatives
from coscrew_codegen.dynamics.algorithms.linear_systems import LeafFactors, factored_from_leaves
from coscrew_codegen.dynamics.forces import effect_derivatives
from coscrew_codegen.dynamics.forces.applied_effects import AppliedEffects
from coscrew_codegen.dynamics.forces.effect_derivatives import Delays, differentiated
from coscrew_codegen.dynamics.forces.soft_rows import Weights
from coscrew_codegen.dynamics.function_recording import FunctionRecording
from coscrew_codegen.program import Program
from coscrew_codegen.program.differentiate import Dual
from coscrew_codegen.scene.situation import carries

Row = Sequence[Number]
Rows = Sequence[Row]
WeightsOf = Callable[[Number], Weights]
BY = ("q", "v", "tau", "p")
"""The inputs by which accelerations are differentiated, as far as they take them."""


def program(x: FunctionRecording, weights: WeightsOf, passes: int) -> Program | None:
    """The derivatives of an acceleration by each input of BY that it takes, after one pass or two,
    in a recording of its inputs; None if forces on points, between bodies or on sums of coordinates
    are implicit, damping depends on later velocities, a joint's screws depend on q, effects add
    inertia to bodies, a free base moves straight on while it drifts, or loops are closed."""
    solution = _Solution(x, weights)
    if not solution.at_joints_alone:
        return None
    with x.recorder.part("derivatives"):
        rows = solution.derivatives(passes)
    outputs, first = [], 0
    for name, width in solution.widths.items():
        outputs.append((array(f"da_d{name}", (x.tree.nv, width)),
                        tuple(y for row in rows for y in row[first:first + width])))
        first += width
    return x.recorder.program("implicit_derivatives", outputs)


@dataclass(frozen=True)
class _Weighed:
    """A number of a velocity, and its derivatives along all directions."""

    value: Number
    slopes: Row


@dataclass(frozen=True)
class _Represented:
    """Inertia m and torque per velocity c that represent a damping d and a stiffness."""

    d: _Weighed
    m: _Weighed
    c: _Weighed
    rate: _Weighed


class _Solution:
    """A recorded acceleration's solution, and its derivatives along all directions: along
    velocities by q, then by the other inputs."""

    def __init__(self, x: FunctionRecording, weights: WeightsOf):
        self.x, self.weights = x, weights
        self.h, = x.recorder.argument("h")
        self.q, self.v = x.recorder.argument("q"), x.recorder.argument("v")
        self.zero, self.nv = x.recorder.number(0), x.tree.nv
        self.start = self._acting(self.v)
        self.widths = {name: len(x.scene.parameters) if name == "p" else self.nv
                       for name in BY if x.recorder.has(name)}

    @property
    def at_joints_alone(self) -> bool:
        """True if slopes are those of torques along velocities, and screws are constants; inertias
        are those of rigid bodies; velocities of free bases stay the same in their own frame."""
        x, start = self.x, self.start
        return (rnea_derivatives.constant_screws(start.motion) and not start.pairs
                and not start.looks_ahead and all(len(s.weights) == 1 for s in start.sums)
                and not any(map(start.resisting, range(len(x.tree.links))))
                and not any(rigid.added for rigid in x.rigids)
                and not carries(x.scene) and not x.scene.model.loops)

    def derivatives(self, passes: int) -> Rows:
        """The derivatives of the last pass's accelerations."""
        of_v = self._spread(v=self._units())
        slopes = self._pass(self.v, of_v, self._guess.a, {})
        if passes == 1:
            return slopes
        u, of_u = ([add(row, scaled(self.h / 2, more)) for row, more in zip(
            rows, by, strict=True)] for rows, by in (([self.v], [self._guess.a]), (of_v, slopes)))
        delays = kicks.delays(self.x, self.h, self._guess.rates)
        return self._pass(u[0], of_u, self._implicit(self._acting(u[0], delays)).a, {
            "rates": self._guess.rates} if self.x.recorder.has("t") else {})

    # the solution

    def _acting(self, u: Row, delays: Delays | None = None) -> AppliedEffects:
        return AppliedEffects(self.x.scene, self.x.motion(at=(self.q, u)), delays).act()

    def _implicit(self, acting: AppliedEffects) -> forward.Implicit:
        x = self.x
        return forward.implicit(acting.motion, acting, x.rigids, x.inertias, self.weights(self.h),
                                x.tau, self.start)

    @cached_property
    def _guess(self) -> forward.Implicit:
        return self._implicit(self.start)

    @cached_property
    def _factors(self) -> LeafFactors:
        """Factors of M + m."""
        M = self._rigid(self.v, self._guess.a).M
        weights, slopes = self.weights(self.h), forward.slopes_at_joints(self.start)
        for i, (d, k, rate) in enumerate(zip(*slopes, self._guess.rates, strict=True)):
            M[i][i] = M[i][i] + weights(d, k, rate)[0]
        return factored_from_leaves(M)

    def _rigid(self, u: Row, a: Row) -> rnea_derivatives.TorqueDerivatives:
        return rnea_derivatives.derivatives(self.x.motion(at=(self.q, u), a=a), self.x.rigids,
                                            self.x.inertias)

    # its derivatives

    def _pass(self, u: Row, of_u: Rows, a: Row, rates: Mapping[str, Row]) -> Rows:
        """-(M + m)⁻¹ ∂R, where u changes by `of_u`; effects are delayed as by the rates."""
        rigid, given = self._rigid(u, a), {"v": u, "a": a, **rates}
        by = ("q", "v", *rates)
        effects = differentiated(
            self.x, lambda y: effect_derivatives.of_effects(y, _delays(y)), by, given)
        own = dict(zip(by, effects, strict=True))
        by_u = [add(x, y) for x, y in zip(rigid.dv, own["v"], strict=True)]
        rows = self._spread(
            q=[add(x, y) for x, y in zip(rigid.dq, own["q"], strict=True)],
            tau=[scaled(self.zero.like(-1), row) for row in self._units()],
            p=self._by_parameters(lambda y: effect_derivatives.of_all(y, _delays(y)), given))
        of_rates, of_v = [x.rate.slopes for x in self._represented], self._spread(v=self._units())
        total: list[Row] = []
        for i, (row, x) in enumerate(zip(rows, self._represented, strict=True)):
            row = add(row, _combined(by_u[i], of_u, self.zero))
            if rates:
                row = add(row, _combined(own["rates"][i], of_rates, self.zero))
            row = add(row, add(scaled(a[i], x.m.slopes), scaled(self.v[i], x.c.slopes)))
            row = subtract(row, scaled(u[i] - self.v[i], x.d.slopes))
            total.append(add(row, subtract(scaled(x.c.value, of_v[i]), scaled(
                x.d.value, subtract(of_u[i], of_v[i])))))
        columns = (self._factors.solve([-y for y in column]) for column in zip(*total, strict=True))
        return [list(row) for row in zip(*columns, strict=True)]

    @cached_property
    def _represented(self) -> list[_Represented]:
        """By velocity; computed from the leaves."""
        slopes = [x for values in forward.slopes_at_joints(self.start) for x in values]
        by = [name for name in ("q", "v", "p") if name in self.widths]
        rows = self._spread(**dict(zip(by, differentiated(self.x, _slopes_at_joints, by, {}),
                                       strict=True)))
        weighed = list(map(_Weighed, slopes, rows))
        results: dict[int, _Represented] = {}
        for i in reversed(range(self.nv)):
            results[i] = self._represent(i, weighed[i], weighed[self.nv + i], results)
        return [results[i] for i in range(self.nv)]

    def _represent(self, i: int, d: _Weighed, k: _Weighed, beyond: Mapping[int, _Represented]
                   ) -> _Represented:
        """The weights of a velocity's damping and stiffness, given those beyond."""
        rate, inertia = self._guess.rates[i], self._guess.inertias[i]
        of_rate: Row = [self.zero] * len(d.slopes)
        if not rate.is_zero:
            change = subtract(d.slopes, scaled(rate, self._of_inertia(i, beyond)))
            of_rate = scaled(1 / inertia, change)
        duals = derivatives.along(self._weights, self.x.recorder, [
            [Dual(self.h, (None,) * len(d.slopes))], *([Dual(y, tuple(s))] for y, s in (
                (d.value, d.slopes), (k.value, k.slopes), (rate, of_rate)))])
        m, c = (_Weighed(y.value, [self.zero if s is None else s for s in y.slopes])
                for y in duals)
        return _Represented(d, m, c, _Weighed(rate, of_rate))

    @cached_property
    def _weights(self) -> Program:
        """h, d, k, rate -> m, c."""
        recorder = Recorder([array(name, ()) for name in ("h", "d", "k", "rate")])
        h, *given = (recorder.argument(a.name)[0] for a in recorder.inputs)
        return recorder.program("weights", [(array("weights", (2,)), self.weights(h)(*given))])

    def _of_inertia(self, i: int, beyond: Mapping[int, _Represented]) -> Row:
        """∂D of a velocity."""
        y, x = self._moved(i), self.x
        of_q, _ = gradients.of_kinetic(x, x.motion(at=(self.q, y)))
        twice = [g * 2 for g in of_q]
        total, = self._spread(q=[twice], p=self._by_parameters(
            lambda z: [energies.kinetic(z, z.motion(accelerating=False)) * 2], {"v": y}))
        for j, own in beyond.items():
            if not y[j].is_zero:
                total = add(total, scaled(y[j] * y[j], own.m.slopes))
        return total

    def _moved(self, i: int) -> Row:
        """The velocities with which a unit velocity moves the joints beyond, if they are free."""
        y = [self.zero] * self.nv
        y[i] = self.zero.like(1)
        if forward.dense(self.start.motion, self.x.inertias):  # D is then a diagonal entry of M
            return y
        L = self._factors.reversed_factors.L
        end = next(link.v.stop for link in self.x.tree.links if i in link.v)
        last = self.nv - 1
        for j in range(end, self.nv):  # towards the leaves
            value = -L[last - i][last - j]
            for k in range(end, j):
                value = value - L[last - k][last - j] * y[k]
            y[j] = value
        return y

    # directions

    def _units(self) -> Rows:
        return [[self.zero.like(int(i == j)) for j in range(self.nv)] for i in range(self.nv)]

    def _by_parameters(self, of: effect_derivatives.Torques, given: Mapping[str, Row]) -> Rows:
        """The derivatives of numbers by run-time parameters, if there are any."""
        if "p" not in self.widths:
            return []
        return differentiated(self.x, of, ("p",), dict(given))[0]

    def _spread(self, **by: Sequence[Row]) -> Rows:
        """Rows along all directions of derivatives by inputs, those that the function takes."""
        count = max(map(len, by.values()))
        none = {name: [[self.zero] * width] * count for name, width in self.widths.items()}
        taken = {name: by.get(name) or none[name] for name in self.widths}
        return [[y for rows in taken.values() for y in rows[i]] for i in range(count)]


def _delays(y: FunctionRecording) -> Delays | None:
    """By the input rates, if there is one."""
    if not y.recorder.has("rates"):
        return None
    h, = y.recorder.argument("h")
    return kicks.delays(y, h, y.recorder.argument("rates"))


def _slopes_at_joints(y: FunctionRecording) -> Row:
    acting = AppliedEffects(y.scene, y.motion(accelerating=False)).act()
    return [x for values in forward.slopes_at_joints(acting) for x in values]


def _combined(factors: Row, rows: Rows, zero: Number) -> Row:
    """Σ factor row."""
    total: Row = [zero] * len(rows[0])
    for factor, row in zip(factors, rows, strict=True):
        if not factor.is_zero:
            total = add(total, scaled(factor, row))
    return total
