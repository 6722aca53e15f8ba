"""Derivatives of inverse dynamics of rigid bodies, by a recursion over the tree.

∂tau/∂q along velocities (of q ⊕ φ at φ = 0), ∂tau/∂v and ∂tau/∂a = M, after Singh, Russell and
Wensing, "Efficient analytical derivatives of rigid-body dynamics using spatial vector algebra"
(2022), in the links' own frames and with accelerations of points, as inverse dynamics has them.
For a freedom with the screw s = (l; e), at the link's origin in its frame,

    ψ' = (v × e + w × l; w × e)        σ = ψ' + (v; w) × s
    ψ'' = (a × e + U l + 2 v × (w × e); U e)

are the rates of s and of its parent's motion: w, v, a and U = w'~ + w~ w~ are those of the link if
it has one freedom, whose own motion does not change its screw, else those of its parent at the
link's origin.  v is relative to the origin of the tree's first link, and a less gravity's, so that
errors do not grow with the speed and the place of a free base.

With m, h, I and T = ∫ r' r^T dm, p = ∫ r' dm of all links beyond a joint, and their net wrench f,

    u1 = B s,  u2 = (0; G^T e + 2 p × l),  u3 = 2 C ψ' + B ψ'' + s ×* f,  u4 = 2 C s + B σ
    2 C (l; e) = (e × 2 p; G e),  G = tr(2 T) 1 - 2 T

are moved to the joints before it, where they have these components along their freedoms:

    M_jc = s_j·u1,  ∂tau_j/∂q_c = s_j·u3,  ∂tau_j/∂v_c = s_j·u4
    ∂tau_c/∂q_j = u2·ψ'_j + u1·ψ''_j,  ∂tau_c/∂v_j = u2·s_j + u1·σ_j

Entries of joints in different branches are zero, and nothing computes them.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from coscrew_codegen.algebra.recording.numbers import (
    Number,
    Vector,
    add,
    angular,
    cross,
    linear,
    negative,
    rotated,
    rotated_back,
    rotation,
    scaled,
    translation,
)
from coscrew_codegen.dynamics.algorithms.bodies import Rigid, symmetric
from coscrew_codegen.dynamics.algorithms.motion import Displacement, Motion
from coscrew_codegen.dynamics.algorithms.rnea import Wrench, net_wrenches
from coscrew_codegen.dynamics.algorithms.screw_rates import subspace_rates
from coscrew_codegen.dynamics.forces.own_inertias import OwnInertias

Matrix = list[list[Number]]
Six = tuple[Number, ...]
Nine = tuple[Number, ...]  # a matrix of three rows


@dataclass(frozen=True)
class TorqueDerivatives:
    """∂tau/∂q, ∂tau/∂v and ∂tau/∂a, row by row: rows are torques."""

    dq: Matrix
    dv: Matrix
    M: Matrix


@dataclass(frozen=True)
class _Freedom:
    """A freedom of a joint: its screw and the rates ψ', ψ'', σ."""

    s: Six
    rate: Six
    second: Six
    sigma: Six


@dataclass(frozen=True)
class _Beyond:
    """A link and all beyond it, in its frame: inertia, 2 T, 2 p and net wrench."""

    inertia: Six
    T: Nine
    p: Vector
    f: Wrench

    def plus(self, other: "_Beyond") -> "_Beyond":
        """The sum."""
        return _Beyond(add(self.inertia, other.inertia), add(self.T, other.T),
                       add(self.p, other.p), add(self.f, other.f))


def derivatives(motion: Motion, rigids: Sequence[Rigid], inertias: OwnInertias
                ) -> TorqueDerivatives:
    """The derivatives of the torques for a motion, of links with these inertias; `inertias`, those
    of joints themselves, are added to M's diagonal.  Each joint's screws must be constants in its
    link's frame."""
    return _Recursion(motion, rigids).derivatives(inertias)


def constant_screws(motion: Motion) -> bool:
    """True if each joint's screws are constants in its link's frame."""
    return all(link.joint.kind.subspace_rate is None for link in motion.tree.links)


def coriolis_matrix(motion: Motion, rigids: Sequence[Rigid]) -> Matrix:
    """C with C v = the torques of inverse dynamics at a = 0, for a motion without gravity, and
    M' - 2 C skew; row by row.

    With the rate s' of each screw, C_jc = s_j·(C s_c + B s_c') and C_cj = s_j·(C^T s_c) +
    s_j'·(B s_c) for a joint j before c: after Echeandia and Wensing, "Numerical methods to compute
    the Coriolis matrix and Christoffel symbols for rigid-body systems" (2021)."""
    return _Coriolis(motion, rigids).matrix()


class _Recursion:
    """The recursion on one motion."""

    def __init__(self, motion: Motion, rigids: Sequence[Rigid]):
        self.motion, self.rigids, self.tree = motion, rigids, motion.tree
        self.zero, self.call = motion.zero[0], motion.recorder.call
        self.places, nv = [], 0  # each link's first freedom, also of followers
        for number in range(len(self.tree.links)):
            self.places.append(nv)
            nv += len(motion.subspace(number))
        self.M, self.dq, self.dv = (
            [[self.zero] * nv for _ in range(nv)] for _ in range(3))
        self.v: list[Vector] = []  # of the origin, relative to the first link's
        self.carried: list[Vector] = []  # likewise, of the parent at the link's origin
        self.freedoms: list[list[_Freedom]] = []
        for number in range(len(self.tree.links)):
            self._enter_velocity(number)
            self.freedoms.append(self._freedoms(number))

    def derivatives(self, inertias: OwnInertias) -> TorqueDerivatives:
        """The matrices, of velocities."""
        wrenches = net_wrenches(self.motion, self.rigids, None)
        moved: list[list[_Beyond]] = [[] for _ in wrenches]  # by parent
        for number in reversed(range(len(wrenches))):
            beyond = self._own(number, wrenches[number])
            with self.motion.part(number, "C"):
                for child in moved[number]:
                    beyond = beyond.plus(child)
            with self.motion.part(number, "u"):
                self._enter(number, beyond)
            parent = self.tree.links[number].parent
            if parent >= 0:
                with self.motion.part(number, "C"):
                    moved[parent].append(self._moved(number, beyond))
        dq, dv, M = map(self._gathered, (self.dq, self.dv, self._with(inertias)))
        return TorqueDerivatives(dq, dv, inertias.enter(M))

    # outwards: velocities, and the rates of screws

    def _enter_velocity(self, number: int) -> None:
        """v = R^T (v_parent + w_parent × t) + slide."""
        motion, link = self.motion, self.tree.links[number]
        with motion.part(number, "vr"):
            own = linear(motion.relative_twist(number))
            if link.parent < 0:
                self.carried.append(negative(own))
                self.v.append(motion.zero)
                return
            D = motion.frame(number)
            w = motion.angular_velocity(link.parent)
            self.carried.append(rotated_back(
                rotation(D), add(self.v[link.parent], cross(w, translation(D)))))
            self.v.append(add(self.carried[number], own))

    def _freedoms(self, number: int) -> list[_Freedom]:
        motion = self.motion
        screws = motion.subspace(number)
        if len(screws) == 1:
            with motion.part(number, "psi"):
                v, w = self.v[number], motion.angular_velocity(number)
                a, U = motion.acceleration(number), motion.acceleration_tensor(number)
                rate, second = self._rates(screws[0], v, w, a, U)
                return [_Freedom(screws[0], rate, second, scaled(self.zero.like(2), rate))]
        freedoms = []
        with motion.part(number, "psi"):
            w, twist = self._parent_w(number), (*self.v[number], *motion.angular_velocity(number))
            a, U = self._parent_acceleration(number)
            for s in screws:
                rate, second = self._rates(s, self.carried[number], w, a, U)
                freedoms.append(_Freedom(
                    s, rate, second, add(rate, self.call("cross_ss", twist, s))))
        return freedoms

    def _parent_w(self, number: int) -> Vector:
        return (self.motion.parent_angular_velocity(number)
                if self.tree.links[number].parent >= 0 else self.motion.zero)

    def _parent_acceleration(self, number: int) -> tuple[Vector, Nine]:
        """a and U of the parent at the link's origin, in the link's frame."""
        motion, parent = self.motion, self.tree.links[number].parent
        D = motion.frame(number)
        R, dw, at_origin = rotation(D), motion.zero, motion.acceleration(parent)
        if parent >= 0:
            dw = rotated_back(R, motion.angular_acceleration(parent))
            at_origin = add(at_origin, rotated(motion.acceleration_tensor(parent), translation(D)))
        return rotated_back(R, at_origin), self.call("acceleration_tensor", self._parent_w(number),
                                                     dw)

    def _rates(self, s: Six, v: Vector, w: Vector, a: Vector, U: Nine) -> tuple[Six, Six]:
        """(ψ', ψ'')."""
        l, e = linear(s), angular(s)
        turned, two = cross(w, e), self.zero.like(2)
        rate = (*add(cross(v, e), cross(w, l)), *turned)
        return rate, (*add(add(cross(a, e), rotated(U, l)), cross(v, scaled(two, turned))),
                      *rotated(U, e))

    # inwards: what lies beyond a joint, and the entries of its freedoms

    def _own(self, number: int, f: Wrench) -> _Beyond:
        """The link's own terms: 2 T = w~ (tr(I) 1 - 2 I) + v (2 h)^T, 2 p = 2 m v + w × 2 h."""
        body, motion = self.rigids[number], self.motion
        with motion.part(number, "T"):
            w, v, two = motion.angular_velocity(number), self.v[number], self.zero.like(2)
            I, h = symmetric(body.I), scaled(two, body.h)
            trace = I[0] + I[4] + I[8]
            columns = [cross(w, tuple((trace if i == j else self.zero) - two * I[3 * i + j]
                                      for i in range(3))) for j in range(3)]
            T = tuple(columns[j][i] + v[i] * h[j] for i in range(3) for j in range(3))
            return _Beyond(body.numbers, T, add(scaled(two * body.m, v), cross(w, h)), f)

    def _moved(self, number: int, x: _Beyond) -> _Beyond:
        """In the parent's frame: R T R^T + (R p) t^T."""
        D: Displacement = self.motion.frame(number)
        R, t = rotation(D), translation(D)
        columns = [rotated(R, x.T[j::3]) for j in range(3)]
        rows = [rotated(R, tuple(column[i] for column in columns)) for i in range(3)]
        p = rotated(R, x.p)
        return _Beyond(self.call("spatial_inertia_transformed", D, x.inertia),
                       tuple(rows[i][j] + p[i] * t[j] for i in range(3) for j in range(3)), p,
                       self.call("product_CoAdc", D, x.f))

    def _enter(self, number: int, x: _Beyond) -> None:
        """The entries of the joint's freedoms, and of those before it."""
        for k, own in enumerate(self.freedoms[number]):
            column, l, e = self.places[number] + k, linear(own.s), angular(own.s)
            u1 = self.call("product_Bs", x.inertia, own.s)
            u2 = (*self.motion.zero, *add(_turned_back(x.T, e), cross(x.p, l)))
            inner = add(_coriolis(x, own.rate), self.call("product_Bs", x.inertia, own.second))
            u4 = add(_coriolis(x, own.s), self.call("product_Bs", x.inertia, own.sigma))
            for other, row in self._places(number):
                self.M[row][column] = self._along(u1, other.s)
                self.dq[row][column] = self._along(inner, other.s)
                self.dv[row][column] = self._along(u4, other.s)
            us = (u1, u2, add(inner, self.call("cross_sc", own.s, x.f)), u4)
            self._enter_before(number, column, us)

    def _enter_before(self, number: int, column: int, us: tuple[Six, ...]) -> None:
        """Each of u3 and u4 is moved to the base before the next one: few values wait at a time."""
        *both, u3, u4 = us
        for at, (u1, u2) in self._inwards(number, *both):
            for x, row in self._places(at):
                self.M[row][column] = self.M[column][row] = self._along(u1, x.s)
                self.dq[column][row] = self._along(u2, x.rate) + self._along(u1, x.second)
                self.dv[column][row] = self._along(u2, x.s) + self._along(u1, x.sigma)
        for u, matrix in ((u3, self.dq), (u4, self.dv)):
            for at, (moved,) in self._inwards(number, u):
                for x, row in self._places(at):
                    matrix[row][column] = self._along(moved, x.s)

    def _inwards(self, number: int, *us: Six) -> Iterator[tuple[int, tuple[Six, ...]]]:
        """Links before this one, and the coscrews in their frames."""
        at = number
        while (parent := self.tree.links[at].parent) >= 0:
            D, at = self.motion.frame(at), parent
            us = tuple(self.call("product_CoAdc", D, u) for u in us)
            yield at, us

    def _places(self, number: int) -> list[tuple[_Freedom, int]]:
        return [(x, self.places[number] + k) for k, x in enumerate(self.freedoms[number])]

    def _along(self, c: Six, s: Six) -> Number:
        """c·s."""
        return self.call("dot_cs", c, s)[0]

    # velocities

    def _with(self, inertias: OwnInertias) -> Matrix:
        for number, link in enumerate(self.tree.links):
            if link.joint.name in inertias:
                for _, place in self._places(number):
                    self.M[place][place] = self.M[place][place] + inertias[link.joint.name]
        return self.M

    def _gathered(self, A: Matrix) -> Matrix:
        """Rows and columns of followers, times multipliers, are added to their leaders'."""
        if not self.tree.follows:
            return A
        entries = [[self.zero] * self.tree.nv for _ in range(self.tree.nv)]
        to = [self._velocity(number, k) for number in range(len(self.tree.links))
              for k in range(len(self.freedoms[number]))]
        for (i, factor_i), row in zip(to, A, strict=True):
            for (j, factor_j), x in zip(to, row, strict=True):
                entries[i][j] = entries[i][j] + x * (factor_i * factor_j)
        return entries

    def _velocity(self, number: int, freedom: int) -> tuple[int, Fraction | int]:
        """(place of the velocity that a freedom depends on, its multiplier)."""
        link = self.tree.links[number]
        if link.driver:
            return self.tree.links[link.driver.link].v.start, link.driver.multiplier
        return link.v.start + freedom, 1


class _Coriolis(_Recursion):
    """The recursion for the Coriolis matrix; only C is entered, as `dv`."""

    def matrix(self) -> Matrix:
        """C, of velocities."""
        self.screw_rates = [self._screw_rates(n) for n in range(len(self.tree.links))]
        return self.derivatives(OwnInertias()).dv

    def _screw_rates(self, number: int) -> list[Six]:
        """(v; w) × s, plus the rates of screws that depend on q."""
        with self.motion.part(number, "ds"):
            twist = (*self.v[number], *self.motion.angular_velocity(number))
            return [add(self.call("cross_ss", twist, x.s), own) for x, own in zip(
                self.freedoms[number], subspace_rates(self.motion, number), strict=True)]

    def _enter(self, number: int, x: _Beyond) -> None:
        half = self.zero.like(1) / 2
        for k, own in enumerate(self.freedoms[number]):
            column, l, e = self.places[number] + k, linear(own.s), angular(own.s)
            u1 = self.call("product_Bs", x.inertia, own.s)
            u2 = (*self.motion.zero,
                  *scaled(half, add(_turned_back(x.T, e), cross(x.p, l))))
            u3 = add(scaled(half, _coriolis(x, own.s)),
                     self.call("product_Bs", x.inertia, self.screw_rates[number][k]))
            for other, row in self._places(number):
                self.dv[row][column] = self._along(u3, other.s)
            self._enter_before(number, column, (u1, u2, u3))

    def _enter_before(self, number: int, column: int, us: tuple[Six, ...]) -> None:
        for at, (u1, u2, u3) in self._inwards(number, *us):
            for (x, row), rate in zip(self._places(at), self.screw_rates[at], strict=True):
                self.dv[row][column] = self._along(u3, x.s)
                self.dv[column][row] = self._along(u2, x.s) + self._along(u1, rate)


def _spin(T: Nine, e: Vector, place: int) -> Vector:
    """G e, or with `place` 1, G^T e: G = tr(2 T) 1 - 2 T."""
    diagonal = (T[4] + T[8], T[0] + T[8], T[0] + T[4])
    values = []
    for i in range(3):
        value = diagonal[i] * e[i]
        for j in range(3):
            if j != i:
                value = value - (T[3 * j + i] if place else T[3 * i + j]) * e[j]
        values.append(value)
    return tuple(values)


def _turned_back(T: Nine, e: Vector) -> Vector:
    """G^T e."""
    return _spin(T, e, 1)


def _coriolis(x: _Beyond, s: Six) -> Six:
    """2 C s = (e × 2 p; G e)."""
    e = angular(s)
    return (*cross(e, x.p), *_spin(x.T, e, 0))
