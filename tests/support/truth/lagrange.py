"""Dynamics of chains from their Lagrangian, by SymPy's polynomials over the rationals; of chains
with quaternions, from d'Alembert's principle.

Around a point, sin, cos and q are replaced by their Taylor polynomials of second order in
deviations x: Lagrange's equations need no more of L(x, w) there, so that they are exact.  A body's
kinetic energy is that of its mass and of its second moments, ½ m ṗ·ṗ + ½ tr(Ṙ Σ Ṙ^T): no ω, no
screws, no recursion.  Shares no code with the generator.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

import numpy as np
from sympy import QQ
from sympy.polys.rings import PolyElement, PolyRing, ring

from coscrew_codegen.scene.mechanism.model import Body, Joint, Model, value
from tests.support.scenes.kinds import Kind
from tests.support.truth.exact import array, eye, rotation_of, skew, zeros

Matrix = np.ndarray  # of polynomials or Fractions
Circle = Mapping[Fraction, tuple[Fraction, Fraction]]  # angle → (sin, cos)


@dataclass(frozen=True)
class Motion:
    """A chain at q, with velocities v and accelerations a of the joints that follow no other."""

    model: Model
    circle: Circle
    q: Sequence[Fraction]
    v: Sequence[Fraction]
    a: Sequence[Fraction]
    gravity: Sequence[Fraction]
    armature: Mapping[str, Fraction]
    follows: bool = False  # whether joints with a mimic follow their leaders

    @cached_property
    def leading(self) -> list[Joint]:
        """The joints with coordinates of their own."""
        return [j for j in self.model.joints if not (self.follows and j.mimic)]

    @property
    def n(self) -> int:
        return len(self.q)

    @cached_property
    def _ring(self) -> PolyRing:
        return ring([f"{letter}{i}" for letter in "xw" for i in range(self.n)], QQ)[0]

    @cached_property
    def x(self) -> list[PolyElement]:
        """Deviations of the coordinates."""
        return list(self._ring.gens[:self.n])

    @cached_property
    def w(self) -> list[PolyElement]:
        """Velocities."""
        return list(self._ring.gens[self.n:])

    def _coordinate(self, joint: Joint) -> tuple[Fraction, PolyElement]:
        """A joint's value at the point, and its deviation."""
        if self.follows and joint.mimic:
            number = [j.name for j in self.leading].index(joint.mimic.joint)
            k = joint.mimic.multiplier
            return k * self.q[number] + joint.mimic.offset, _rational(k) * self.x[number]
        number = self.leading.index(joint)
        return self.q[number], self.x[number]

    def _moved(self, joint: Joint) -> tuple[Matrix, Matrix]:
        """R and t of the joint's child in its parent, as polynomials in x."""
        value, x = self._coordinate(joint)
        one = self._ring.one
        R = _polynomials(one, np.reshape(array(joint.placement.R), (3, 3)))
        t = _polynomials(one, array(joint.placement.t))
        axis = array(joint.axis)
        if joint.kind is Kind.PRISMATIC:
            return R, t + R @ (_polynomials(one, axis) * (x + _rational(value)))
        s, c = map(_rational, self.circle[value])
        sine, cosine = s + c * x - s * x**2 / 2, c - s * x - c * x**2 / 2
        outer = np.outer(axis, axis)
        turn = (_polynomials(one, outer) + _polynomials(one, skew(axis)) * sine
                + _polynomials(one, eye(3) - outer) * cosine)
        return R @ turn, t

    @cached_property
    def poses(self) -> dict[str, tuple[Matrix, Matrix]]:
        """R and t of each body in the world, as polynomials in x."""
        one = self._ring.one
        got = {"world": (_polynomials(one, eye(3)), _polynomials(one, array([Fraction(0)] * 3)))}
        for joint in self.model.joints:
            (R, t), (own_R, own_t) = got[joint.parent], self._moved(joint)
            got[joint.child] = R @ own_R, t + R @ own_t
        return {body.name: got[body.name] for body in self.model.bodies}

    def _bodies(self) -> Iterator[tuple[Body, PolyElement, Matrix, Matrix, Matrix]]:
        """Each body with its mass, second moments Σ about the centre, R, centre."""
        one = self._ring.one
        for body in self.model.bodies:
            R, t = self.poses[body.name]
            mass, com, second = _massive(body)
            yield (body, _rational(mass), _polynomials(one, second), R,
                   t + R @ _polynomials(one, com))

    def rate(self, X: Matrix) -> Matrix:
        """Σ ∂X/∂x_i w_i."""
        return sum(_each(X, lambda p, x=x: p.diff(x)) * w
                   for x, w in zip(self.x, self.w, strict=True))

    @cached_property
    def kinetic(self) -> PolyElement:
        total = self._ring.zero
        for _, mass, second, R, com in self._bodies():
            u, U = self.rate(com), self.rate(R)
            total += (mass * (u @ u) + np.trace(U @ second @ U.T)) / 2
        for joint in self.model.joints:
            if joint.name in self.armature:
                own = self.rate(array([self._coordinate(joint)[1]]))[0]
                total += _rational(self.armature[joint.name]) * own**2 / 2
        return total

    @cached_property
    def potential(self) -> PolyElement:
        total = self._ring.zero
        for _, mass, _, _, com in self._bodies():
            total -= mass * sum(_rational(g) * x for g, x in zip(self.gravity, com, strict=True))
        return total

    def at(self, p: PolyElement) -> Fraction:
        """The value at the point: x = 0, w = v."""
        result = p.evaluate([(x, 0) for x in self.x] + [
            (w, _rational(v)) for w, v in zip(self.w, self.v, strict=True)])
        return Fraction(int(result.numerator), int(result.denominator))

    def mass_matrix(self) -> list[list[Fraction]]:
        """∂²L/∂w∂w."""
        return [[self.at(self.kinetic.diff(a).diff(b)) for b in self.w] for a in self.w]

    def torques(self) -> list[Fraction]:
        """d/dt ∂L/∂w - ∂L/∂x."""
        L, result = self.kinetic - self.potential, []
        for x, w in zip(self.x, self.w, strict=True):
            p = L.diff(w)
            rates = zip((*self.w, *self.x), (*self.a, *self.v), strict=True)
            result.append(sum(self.at(p.diff(y)) * rate for y, rate in rates) - self.at(L.diff(x)))
        return result

    def values(self, X: Matrix) -> Matrix:
        """X at the point."""
        return _each(X, self.at)

    def second(self, X: Matrix) -> Matrix:
        """d²X/dt²."""
        speeding = sum(_each(X, lambda p, x=x: self.at(p.diff(x))) * a
                       for x, a in zip(self.x, self.a, strict=True))
        return speeding + self.values(self.rate(self.rate(X)))

    def momentum(self) -> list[Fraction]:
        """Σ m ṗ; Σ m p × ṗ + ∫ r × ṙ dm."""
        linear, angular = array([Fraction(0)] * 3), array([Fraction(0)] * 3)
        for _, mass, second, R, com in self._bodies():
            p, u = self.values(com), self.values(self.rate(com))
            m = Fraction(int(mass.numerator), int(mass.denominator))
            linear = linear + m * u
            angular = angular + m * skew(p) @ u + _moment(
                self.values(second), self.values(R), self.values(self.rate(R)))
        return [*linear, *angular]

    def jacobian(self, body: str) -> Matrix:
        """Columns (R^T ∂t/∂x; the vector of R^T ∂R/∂x), 6 × n."""
        R, t = self.poses[body]
        columns = []
        for x in self.x:
            Rt, W = self.values(R).T, self.values(_each(R, lambda p, x=x: p.diff(x)))
            W = Rt @ W
            columns.append([*(Rt @ self.values(_each(t, lambda p, x=x: p.diff(x)))),
                            W[2, 1], W[0, 2], W[1, 0]])
        return array(columns).T

    def reaction(self, joint: Joint) -> list[Fraction]:
        """The net force and moment of all bodies beyond the joint, in the frame of the first of
        them."""
        behind = {joint.child}
        for other in self.model.joints:
            behind |= {other.child} if other.parent in behind else set()
        R0, t0 = map(self.values, self.poses[joint.child])
        force, moment = array([Fraction(0)] * 3), array([Fraction(0)] * 3)
        for body, _, second, R, com in self._bodies():
            if body.name in behind:
                f = _massive(body)[0] * (self.second(com) - array(list(self.gravity)))
                force = force + f
                moment = moment + skew(self.values(com) - t0) @ f + _moment(
                    self.values(second), self.values(R), self.second(R))
        return [*(R0.T @ force), *(R0.T @ moment)]


def _moment(second: Matrix, R: Matrix, other: Matrix) -> Matrix:
    """∫ R ρ × X ρ dm for the second moments of ρ."""
    return sum(second[i, j] * (skew(R[:, i]) @ other[:, j]) for i in range(3) for j in range(3))


def _rational(x: Fraction) -> object:
    return QQ(Fraction(x).numerator, Fraction(x).denominator)


def _polynomials(one: PolyElement, X: Matrix) -> Matrix:
    return _each(X, lambda x: one * _rational(x))


def _each(X: Matrix, f: Callable[..., object]) -> Matrix:
    result = np.empty(X.shape, dtype=object)
    for index in np.ndindex(X.shape):
        result[index] = f(X[index])
    return result


def virtual_work(model: Model, circle: Circle, g: Sequence[Fraction], q: Sequence[Fraction],
                 v: Sequence[Fraction], a: Sequence[Fraction]) -> list[Fraction]:
    """τ_k = Σ m (p'' - g)·∂p/∂δ_k + ∫ ∂r/∂δ_k · r'' dm: every joint's motion is a matrix E(t) with
    E' = E W, E'' = E (W W + W'), its virtual displacements E W_k; all else is the product rule."""
    result = np.array([Fraction(0)] * len(v), dtype=object)
    weight = _homogeneous(zeros(3, 3), array(list(g)), Fraction(0))
    X, first, second = eye(4), zeros(4, 4), zeros(4, 4)
    variations: list[tuple[int, Matrix]] = []
    for joint, body, (nq, nv) in zip(model.joints, model.bodies, _places(model), strict=True):
        screws = [_rate_matrix(joint, k) for k in range(joint.kind.nv)]
        W, dW = (sum(s * x for s, x in zip(screws, rates[nv:], strict=False)) for rates in (v, a))
        P = _homogeneous(np.reshape(array(joint.placement.R), (3, 3)), array(joint.placement.t))
        D = P @ _joint_matrix(joint, q[nq:nq + joint.kind.nq], circle)
        second = second @ D + 2 * first @ D @ W + X @ D @ (W @ W + dW)
        first, X = first @ D + X @ D @ W, X @ D
        variations = [(k, Y @ D) for k, Y in variations]
        variations += [(nv + k, X @ screw) for k, screw in enumerate(screws)]
        for k, Y in variations:
            result[k] += np.trace(Y @ _pseudo_inertia(body) @ (second - weight).T)
    return list(result)


def _places(model: Model) -> list[tuple[int, int]]:
    places, nq, nv = [], 0, 0
    for joint in model.joints:
        places.append((nq, nv))
        nq, nv = nq + joint.kind.nq, nv + joint.kind.nv
    return places


def _homogeneous(R: Matrix, t: Matrix, corner: Fraction = Fraction(1)) -> Matrix:
    D = eye(4) * corner
    D[:3, :3], D[:3, 3] = R, t
    return D


def _joint_matrix(joint: Joint, q: Sequence[Fraction], circle: Circle) -> Matrix:
    axis, origin = array(joint.axis), array([Fraction(0)] * 3)
    if joint.kind is Kind.PRISMATIC:
        return _homogeneous(eye(3), q[0] * axis)
    if joint.kind is Kind.REVOLUTE:
        s, c = circle[q[0]]
        outer = np.outer(axis, axis)
        return _homogeneous(outer + s * skew(axis) + c * (eye(3) - outer), origin)
    if joint.kind is Kind.SPHERICAL:
        return _homogeneous(rotation_of(array(q)), origin)
    return _homogeneous(rotation_of(array(q[3:])), array(q[:3]))


def _rate_matrix(joint: Joint, k: int) -> Matrix:
    """[[ω~, v], [0, 0]] of one freedom."""
    unit, none = [Fraction(int(i == k)) for i in range(6)], [Fraction(0)] * 3
    linear, angular = {Kind.FREE: (unit[:3], unit[3:]), Kind.SPHERICAL: (none, unit[:3]),
                       Kind.REVOLUTE: (none, joint.axis),
                       Kind.PRISMATIC: (joint.axis, none)}[joint.kind]
    return _homogeneous(skew(array(list(angular))), array(list(linear)), Fraction(0))


def _massive(body: Body) -> tuple[Fraction, Matrix, Matrix]:
    """Mass, its centre, and second moments Σ about that."""
    assert body.inertia
    xx, yy, zz, xy, xz, yz = map(value, body.inertia.moments)
    I = array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    com = array([value(x) for x in body.inertia.com])
    return value(body.inertia.mass), com, eye(3) * (xx + yy + zz) / 2 - I


def _pseudo_inertia(body: Body) -> Matrix:
    """∫ (r; 1) (r; 1)^T dm."""
    m, com, second = _massive(body)
    J = _homogeneous(second + m * np.outer(com, com), m * com, m)
    J[3, :3] = m * com
    return J
