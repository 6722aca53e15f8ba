"""Dynamics of chains follow exactly from their Lagrangian: evaluated on Fractions, with rational
points of the circle as sines and cosines."""

from fractions import Fraction
from functools import cache
from random import Random

import numpy as np
import pytest

from coscrew_codegen.scene.mechanism.model import (
    Body,
    Inertia,
    Joint,
    Mimic,
    Model,
    Placement,
)
from tests.support.scenes.evaluation import Evaluated, rational
from tests.support.scenes.kinds import Kind
from tests.support.scenes.mechanisms import applied, ball, free_body, gravity, inertia, scene
from tests.support.truth.exact import Sample, array, rotation_of, skew
from tests.support.truth.lagrange import Motion, virtual_work

KINDS = {"R": Kind.REVOLUTE, "P": Kind.PRISMATIC}
G = (Fraction(1), Fraction(-2), Fraction(-981, 100))
AXES = tuple(tuple(map(Fraction, a)) for a in (
    (1, 0, 0), (0, 1, 0), (0, 0, 1), (0, -1, 0), ("3/5", 0, "4/5"), ("2/3", "-1/3", "2/3")))

SHAPES = ("R", "P", "RR", "RP", "PR", "PP", "RRR", "RRP", "RPR", "PRR", "RPP", "PRP", "PPR", "PPP",
          "RRR branch", "PRR branch", "RR<", "RP<", "RRR armature", "PR armature",
          "RRR<", "RPR< armature", "RRP< branch")
"""Joints in order; < means that the joint before it mimics the first."""


class Chosen:
    """A chain of random rational numbers, and a state of it."""

    def __init__(self, seed: int, shape: str):
        self.random, sample = Random(seed), Sample(seed)
        letters, _, others = shape.partition(" ")
        joints, bodies = [], []
        for n, letter in enumerate(letters.replace("<", "")):
            before = n - 2 if n > 1 and "branch" in others else n - 1
            follows = "<" in letters and letters.index("<") == n + 1
            R = rotation_of(array([self._small() for _ in range(4)]))
            joints.append(Joint(
                f"j{n}", KINDS[letter], f"b{before}" if n else "world", f"b{n}",
                Placement(tuple(np.ravel(R)), self._vector()), self.random.choice(AXES),
                mimic=Mimic("j0", Fraction(-3, 2), Fraction(1, 3)) if follows else None))
            bodies.append(Body(f"b{n}", self._inertia(sample)))
        self.model = Model("chain", tuple(bodies), tuple(joints))
        self.follows = any(j.mimic for j in joints)
        self.armature = {f"j{n}": Fraction(n + 1, 3) for n in range(len(joints))} \
            if "armature" in shape else {}
        n = sum(not j.mimic for j in joints)
        self.q = [Fraction(k + 1, 7) for k in range(n)]
        self.v, self.a = ([self._small() for _ in range(n)] for _ in range(2))
        angles = (*self.q, Fraction(-3, 2) * self.q[0] + Fraction(1, 3))
        self.circle = {q: tuple(sample.sine_cosine()) for q in angles}

    def _small(self) -> Fraction:
        return Fraction(self.random.randint(1, 9) * self.random.choice((-1, 1)),
                        self.random.randint(1, 5))

    def _vector(self) -> tuple[Fraction, ...]:
        return tuple(self._small() for _ in range(3))

    def _inertia(self, sample: Sample) -> Inertia:
        """Rotated principal moments such as 3, 4, 5: physically possible, with all six moments
        different from 0."""
        R = sample.rotation()
        I = R @ np.diag(array([Fraction(self.random.randint(6, 9)) for _ in range(3)])) @ R.T
        return Inertia(abs(self._small()), self._vector(),
                       (I[0, 0], I[1, 1], I[2, 2], I[0, 1], I[0, 2], I[1, 2]))


@cache
def case(number: int) -> tuple[Chosen, Motion, Evaluated]:
    """The mechanism, its Lagrangian, and the generated functions."""
    x = Chosen(number, SHAPES[number])
    motion = Motion(x.model, x.circle, x.q, x.v, x.a, G, x.armature, x.follows)
    effects = [gravity(*G), *(applied("armature", j, inertia=i) for j, i in x.armature.items()),
               *([applied("mimic")] if x.follows else []),
               *(applied("reaction", j.name) for j in x.model.joints)]
    return x, motion, Evaluated(scene(x.model, *effects), rational(x.circle))


chains = pytest.mark.parametrize("number", range(len(SHAPES)), ids=lambda n: f"{n}-{SHAPES[n]}")


@chains
def test_inverse_dynamics_is_lagranges(number: int) -> None:
    x, motion, f = case(number)
    assert f("inverse_dynamics", q=x.q, v=x.v, a=x.a) == motion.torques()


@chains
def test_forward_dynamics_inverts_inverse_dynamics(number: int) -> None:
    x, motion, f = case(number)
    assert f("forward_dynamics", q=x.q, v=x.v, tau=motion.torques()) == x.a


@chains
def test_mass_matrix_is_the_hessian_of_the_kinetic_energy(number: int) -> None:
    x, motion, f = case(number)
    assert f("mass_matrix", q=x.q) == sum(motion.mass_matrix(), [])


@chains
def test_energy_and_momentum_are_the_sums_over_masses(number: int) -> None:
    x, motion, f = case(number)
    assert f("energy", q=x.q, v=x.v) == [motion.at(motion.kinetic), motion.at(motion.potential)]
    assert f("momentum", q=x.q, v=x.v) == motion.momentum()
    assert f("power", q=x.q, v=x.v) == 0


@chains
def test_torques_split_into_their_parts(number: int) -> None:
    """bias: a = 0; gravity alone: a = 0, v = 0."""
    x, motion, f = case(number)
    still = [Fraction(0)] * motion.n
    for name, v in (("bias_torques", x.v), ("gravity_torques", still)):
        parts = Motion(x.model, x.circle, x.q, v, still, G, x.armature, x.follows)
        assert f(name, q=x.q, v=v) == parts.torques()


@chains
def test_poses_twists_and_jacobians_are_derivatives(number: int) -> None:
    x, motion, f = case(number)
    poses, twists = [], []
    for body in x.model.bodies:
        R, t = map(motion.values, motion.poses[body.name])
        poses += [entry for i in range(3) for entry in (*R[i], t[i])]
        J = motion.jacobian(body.name)
        assert f(f"jacobian_{body.name}", q=x.q) == list(np.ravel(J))
        twists += list(J @ array(x.v))
    assert f("body_poses", q=x.q) == poses
    assert f("body_twists", q=x.q, v=x.v) == twists


@chains
def test_reactions_are_newtons_and_eulers(number: int) -> None:
    x, motion, f = case(number)
    for joint in x.model.joints:
        assert f(f"reaction_{joint.name}", q=x.q, v=x.v, a=x.a) == motion.reaction(joint)


# joints with quaternions: Euler's equations


COM = array([Fraction(1, 3), Fraction(-2), Fraction(1, 2)])
MOMENTS = (5, 6, 7, 1, -1, Fraction(1, 2))


def about_origin(m: int) -> np.ndarray:
    """I + m (c·c - c c^T)."""
    xx, yy, zz, xy, xz, yz = map(Fraction, MOMENTS)
    I = array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    return I - m * skew(COM) @ skew(COM)


@pytest.mark.parametrize("seed", range(3))
def test_free_bodies_obey_newton_and_euler(seed: int) -> None:
    """f = m (v' + ω×v + ω'×c + ω×(ω×c) - g), τ = I ω' + ω × I ω + m c × (v' + ω×v - g)."""
    sample, m = Sample(seed), 3
    f = Evaluated(scene(free_body(m, tuple(COM), MOMENTS), gravity(*G)), rational({}))
    p, quaternion, v, a = sample.vector(), sample.quaternion(), sample.vector(6), sample.vector(6)
    R, I, u, w, dw = rotation_of(quaternion), about_origin(m), v[:3], v[3:], a[3:]
    origin = a[:3] + skew(w) @ u - R.T @ array(G)
    tau = [*(m * (origin + skew(dw) @ COM + skew(w) @ (skew(w) @ COM))),
           *(I @ dw + skew(w) @ (I @ w) + m * skew(COM) @ origin)]
    q = [*p, *quaternion]
    assert f("inverse_dynamics", q=q, v=v, a=a) == tau
    assert f("forward_dynamics", q=q, v=v, tau=tau) == list(a)
    assert f("energy", q=q, v=v)[0] == (m * u @ u + w @ I @ w) / 2 + m * u @ (skew(w) @ COM)
    force = R @ (m * (u + skew(w) @ COM))
    assert f("momentum", q=q, v=v) == [
        *force, *(R @ (I @ w + m * skew(COM) @ u) + skew(p) @ force)]


@pytest.mark.parametrize("seed", range(3))
def test_balls_obey_euler(seed: int) -> None:
    """τ = I ω' + ω × I ω - m c × g, about the fixed point."""
    sample, m = Sample(seed), 3
    f = Evaluated(scene(ball(m, tuple(COM), MOMENTS), gravity(*G)), rational({}))
    quaternion, w, dw = sample.quaternion(), sample.vector(), sample.vector()
    I, down = about_origin(m), rotation_of(quaternion).T @ array(G)
    tau = list(I @ dw + skew(w) @ (I @ w) - m * skew(COM) @ down)
    assert f("inverse_dynamics", q=quaternion, v=w, a=dw) == tau
    assert f("forward_dynamics", q=quaternion, v=w, tau=tau) == list(dw)
    assert f("energy", q=quaternion, v=w)[0] == w @ I @ w / 2


def _mixed() -> Model:
    """A free body with a ball joint, an arm on that, and a slider on that."""
    sample, joints, bodies = Sample(9), [], []
    for n, kind in enumerate((Kind.FREE, Kind.SPHERICAL, Kind.REVOLUTE, Kind.PRISMATIC)):
        placement = Placement(tuple(np.ravel(sample.rotation())), tuple(sample.vector()))
        joints.append(Joint(f"j{n}", kind, f"b{n - 1}" if n else "world", f"b{n}", placement,
                            AXES[4 + n % 2]))
        bodies.append(Body(f"b{n}", inertia(n + 2, tuple(sample.vector()), MOMENTS)))
    return Model("mixed", tuple(bodies), tuple(joints))


@pytest.mark.parametrize("seed", range(3))
def test_mixed_chains_obey_dalembert(seed: int) -> None:
    sample, model = Sample(seed), _mixed()
    circle = {Fraction(1, 7): tuple(sample.sine_cosine())}
    f = Evaluated(scene(model, gravity(*G)), rational(circle))
    q = [*sample.vector(), *sample.quaternion(), *sample.quaternion(), Fraction(1, 7),
         sample.scalar()]
    v, a = sample.vector(11), sample.vector(11)
    tau = f("inverse_dynamics", q=q, v=v, a=a)
    assert tau == virtual_work(model, circle, G, q, list(v), list(a))
    assert f("forward_dynamics", q=q, v=v, tau=tau) == list(a)


