"""Chains of fixed joints are one frame: right angles stay right, general ones are the product of
the joints' rotations, and numbers grow neither with the chain nor beyond single precision."""

import random
from fractions import Fraction as F
from itertools import accumulate

import mpmath
import pytest

from coscrew_codegen.algebra.recording.numbers import add
from coscrew_codegen.algebra.recording.recorder import Recorder
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program import Constant
from coscrew_codegen.scene.mechanism import rotations
from coscrew_codegen.scene.mechanism.model import (
    HERE,
    WORLD,
    Body,
    Inertia,
    Joint,
    Model,
    Placement,
)
from coscrew_codegen.scene.mechanism.rotations import SNAP
from coscrew_codegen.scene.mechanism.tree import PlacedBody, composed, lumped_inertia, tree_of
from coscrew_codegen.scene.scene import Scene
from tests.support.cases import for_all
from tests.support.scenes.kinds import Kind

LONG = 300
QUARTER = F("1.57079632679489661923132169163975144")
HEAVY = Inertia(F(1), (F("0.1"), F("0.02"), F("0.3")), (F("0.02"),) * 3 + (F(0),) * 3)


def frame(x, y, z, *rpy):
    return Placement(rotations.from_rpy(*map(F, rpy)), (F(x), F(y), F(z)))


def chain(frames, kinds=None, first=Kind.REVOLUTE):
    """A joint that moves, and bodies one upon the other at these frames, by default fixed."""
    names = [f"b{n}" for n in range(len(frames) + 1)]
    joints = [Joint(f"j{n}", kind, *ends, at) for n, (kind, ends, at) in enumerate(zip(
        kinds or [Kind.FIXED] * len(frames), zip(names, names[1:], strict=False), frames,
        strict=True))]
    return Model("chain", tuple(Body(name, HEAVY) for name in names),
                 (Joint("moves", first, WORLD, names[0]), *joints))


def last(frames):
    """The frame of the last body in the link's."""
    (link,) = tree_of(chain(frames), False).links
    return link.bodies[-1].placement


def decimal_quarter(random_, digits):
    """A multiple of a right angle with so many decimals."""
    return F(round(random_.choice((0, 0, 1, -1, 2)) * QUARTER * 10**digits), 10**digits)


def product_in_full(frames):
    """The product of the frames in 80 digits."""
    with mpmath.workdps(80):
        D = mpmath.eye(4)
        for x in frames:
            rows = [[mpmath.mpf(e.numerator) / e.denominator for e in row]
                    for row in ((*x.R[:3], x.t[0]), (*x.R[3:6], x.t[1]), (*x.R[6:], x.t[2]))]
            D = D * mpmath.matrix([*rows, [0, 0, 0, 1]])
        return D


def distance(result, truth):
    """(of rotations, of origins), the largest difference of entries."""
    with mpmath.workdps(80):
        def off(x, i, j):
            return abs(mpmath.mpf(x.numerator) / x.denominator - truth[i, j])
        return (max(off(result.R[3 * i + j], i, j) for i in range(3) for j in range(3)),
                max(off(result.t[i], i, 3) for i in range(3)))


@for_all(seed=range(20), digits=(11, 13, 16, 30))
def test_right_angles_stay_right_in_chains_of_any_length(seed, digits):
    rand = random.Random(f"{seed} {digits}")
    frames = [frame(*rand.choices(("0", "0.1", "-0.25"), k=3),
                    *(decimal_quarter(rand, digits) for _ in range(3)))
              for _ in range(rand.choice((2, 3, 10, 60)))]
    result = last(frames)
    assert set(result.R) <= {-1, 0, 1}
    assert all((x * 20).denominator == 1 for x in result.t)
    truth = list(accumulate(frames, composed))[-1]
    assert result == truth


@for_all(seed=range(30), digits=range(3, 9))
def test_rough_right_angles_leave_no_residues(seed, digits):
    """1.5708 is no right angle, and its cosine stays; entries that should be zero are zero."""
    rand = random.Random(f"{seed} {digits}")
    frames = [frame("0.1", "0", "-0.3", *(decimal_quarter(rand, digits) for _ in range(3)))
              for _ in range(rand.choice((2, 3, 10, 60)))]
    result = last(frames)
    assert all(not x or abs(x) > SNAP for x in result.R)
    assert max(distance(result, product_in_full(frames))) <= float(SNAP)


@for_all(seed=range(10), digits=(3, 4, 8, 20))
def test_a_chain_and_its_inverse_cancel_exactly(seed, digits):
    rand = random.Random(f"{seed} {digits}")
    turns = [(rand.randrange(3), F(round(rand.uniform(-3, 3) * 10**digits), 10**digits))
             for _ in range(rand.choice((1, 2, 7, 40)))]

    def about(axis, angle):
        return frame(0, 0, 0, *(angle if axis == k else 0 for k in range(3)))

    there, back = ([about(axis, sign * angle) for axis, angle in turns[::sign]] for sign in (1, -1))
    assert last([*there, *back]) == HERE
    assert last([*there, frame("0.1", "-0.2", "0.3", 0, 0, 0), *back,
                 *there, frame("-0.1", "0.2", "-0.3", 0, 0, 0), *back]) == HERE


@for_all(seed=range(4), length=(2, 9, LONG))
def test_general_chains_are_products_in_full(seed, length):
    rand = random.Random(f"{seed} {length}")
    frames = [frame(*(F(round(rand.uniform(-3, 3), 4)) for _ in range(6))) for _ in range(length)]
    rotation, origin = distance(last(frames), product_in_full(frames))
    assert rotation < length * mpmath.mpf(10)**-49
    assert origin < length * 10 * length * mpmath.mpf(10)**-49


def test_numbers_do_not_grow_with_the_chain():
    """Time is linear in the length, as long as the numbers do not grow with it."""
    def digits(length):
        (link,) = tree_of(chain([frame("0.1", "0.2", "-0.3", "0.1", "1.5708", "2.5")] * length),
                          False).links
        placements = [x.placement for x in link.bodies]
        return (max(y.denominator.bit_length() for x in placements for y in (*x.R, *x.t)),
                max(x.denominator.bit_length() for x in lumped_inertia(link.bodies).numbers))

    short, long = digits(10), digits(LONG)
    assert max(*short, *long) < 500
    assert all(b <= a + 8 for a, b in zip(short, long, strict=True))


@pytest.mark.parametrize("seed", range(12))
def test_single_precision_holds_every_chain(seed):
    """Chains with sliding joints between them are included; their rotations are constants of the
    functions."""
    rand = random.Random(seed)
    angles = [F(x) for x in ("0.7", "-1.1", "0.2", "0.1", "0")] if seed % 3 == 0 else None
    length = rand.choice((2, 3, 5))
    frames = [frame(*rand.choices(("0", "0.1", "-0.25"), k=3),
                    *(rand.choice(angles) if angles else decimal_quarter(rand, 3 + seed % 6)
                      for _ in range(3))) for _ in range(length)]
    kinds = rand.choices((Kind.FIXED, Kind.FIXED, Kind.PRISMATIC), k=length)
    result = derive(Scene("chain", chain(frames, kinds)))
    assert result.precisions == ("double", "single")
    assert result.has("forward_dynamics")


def test_a_frame_that_turned_there_and_back_costs_nothing():
    """Rotations by a prismatic joint's frames cancel like those of fixed ones."""
    there, back = frame(0, 0, 0, 0, 0, "-1.5708"), frame(0, 0, 0, 0, "1.5708", "1.5708")
    (poses,) = (f.program for f in derive(Scene("chain", chain(
        [there, back], [Kind.PRISMATIC, Kind.FIXED], Kind.PRISMATIC)), ("body_poses",)).functions)
    operands = [x for step in poses.instructions for x in step.operands]
    constants = {abs(x.double) for x in (*operands, *poses.results) if isinstance(x, Constant)}
    assert len(constants) > 2
    assert all(not x or x > SNAP for x in constants)


def test_sums_that_only_rounding_keeps_from_zero_are_zero():
    """A sum of constants cancels up to the rounding of its terms, and no further."""
    recorder = Recorder(())
    third = F(round(F(1, 3) * 2**160), 2**160)
    rest = recorder.number(third) * 3 - 1
    assert rest.is_zero and (1 - recorder.number(third) * 3).is_zero
    for tiny in (F(1, 10**30), -F(1, 10**36)):
        assert (recorder.number(1 + tiny) - 1).constant == tiny
        assert (recorder.number(tiny * F(1, 10**40)) + 0).constant == tiny * F(1, 10**40)


@pytest.mark.parametrize("seed", range(6))
def test_bodies_that_move_as_one_have_the_sum_of_their_inertias(seed):
    """By points: a body of moments I about c is six points around it."""
    rand = random.Random(seed)
    bodies = []
    for n in range(rand.choice((1, 2, 5))):
        radii = [F(rand.randrange(1, 9), 10) for _ in range(3)]
        mass, com = F(rand.randrange(1, 9)), tuple(F(rand.randrange(-9, 9), 10) for _ in range(3))
        x, y, z = (mass * r * r / 3 for r in radii)  # two points of mass/6 at ±r on each axis
        bodies.append((radii, PlacedBody(
            Body(f"b{n}", Inertia(mass, com, (y + z, x + z, x + y, F(0), F(0), F(0)))),
            frame(n, "0.2", "-0.1", *(F(rand.randrange(-30, 30), 10) for _ in range(3))))))
    points = [(placed.body.inertia.mass / 6, _moved(placed, axis, sign * radii[axis]))
              for radii, placed in bodies for axis in range(3) for sign in (1, -1)]
    result = lumped_inertia([placed for _, placed in bodies])
    assert result.mass == sum(m for m, _ in points)
    for i in range(3):
        assert abs(result.first[i] - sum(m * p[i] for m, p in points)) < F(1, 10**45)
    second = [[sum(m * p[i] * p[j] for m, p in points) for j in range(3)] for i in range(3)]
    (a, b, c), (xy, xz, yz) = (second[i][i] for i in range(3)), (
        second[i][j] for i, j in ((0, 1), (0, 2), (1, 2)))
    for x, y in zip(result.moments, (b + c, a + c, a + b, -xy, -xz, -yz), strict=True):
        assert abs(x - y) < F(1, 10**44)


def _moved(placed, axis, by):
    """A point beside the centre of mass, in the link's frame."""
    at = list(placed.body.inertia.com)
    at[axis] += by
    R = placed.placement.R
    return add([sum(R[3 * i + k] * at[k] for k in range(3)) for i in range(3)], placed.placement.t)


def test_equal_moments_that_are_turned_together_leave_no_products():
    """Balls on general frames: no residue of their rotations remains in the sum."""
    frames = [frame(0, 0, 0, "0.1", "0.2", "0.3"), frame(0, 0, 0, "-0.7", "1.1", "2.9")]
    ball = Inertia(F(2), (F(0),) * 3, (F("0.01"),) * 3 + (F(0),) * 3)
    result = lumped_inertia([PlacedBody(Body("ball", ball), at)
                             for at in (*frames, composed(*frames))])
    assert result.first == (0, 0, 0)
    assert result.moments[1:] == (result.moments[0], result.moments[0], 0, 0, 0)


def test_a_centre_of_mass_that_is_turned_to_the_axis_is_on_it():
    """3, 4 and 5, whose cosines have 50 digits: the body's point is the link's origin."""
    at = Placement(rotations.from_quaternion((F(0), F(0), F(1), F(2))), (F("0.1"), F(0), F(0)))
    point = Inertia(F(2), (F("-0.06"), F("0.08"), F(0)), (F(0),) * 6)
    result = lumped_inertia([PlacedBody(Body("point", point), at)])
    assert result.numbers == (2, *(0,) * 9)
