"""Followers of followers are attached to the joint at the end of their chain, in linear time."""

import random
from fractions import Fraction as F

import pytest

from coscrew_codegen.scene.mechanism.assembly import ModelError, without_chains, wrong_mimics
from coscrew_codegen.scene.mechanism.model import Body, Joint, Mimic, Model
from tests.support.scenes.kinds import Kind
from tests.support.work import calls_of


def model_of(mimics, kinds=()):
    """A model with a joint for each entry, which is whom it follows, or None."""
    joints = [Joint(f"j{n}", dict(kinds).get(n, Kind.REVOLUTE), "world", f"b{n}",
                    mimic=Mimic(*mimic) if mimic else None) for n, mimic in enumerate(mimics)]
    return Model("m", tuple(Body(joint.child) for joint in joints), tuple(joints))


def value(mimics, n, q):
    """The coordinate of joint n, by following its chain step by step."""
    if mimics[n] is None:
        return q[n]
    leader, multiplier, offset = mimics[n]
    return multiplier * value(mimics, int(leader[1:]), q) + offset


@pytest.mark.parametrize("seed", range(20))
def test_chains_have_the_values_of_their_steps(seed):
    draw = random.Random(seed)
    count = draw.randint(2, 30)
    order = draw.sample(range(count), count)  # a joint follows one that is earlier in this order
    mimics = [None] * count
    for place, n in enumerate(order[1:], 1):
        if draw.random() < 0.8:
            mimics[n] = (f"j{draw.choice(order[:place])}", F(draw.randint(-3, 3)),
                         F(draw.randint(-3, 3), 7))
    q = [F(draw.randint(-9, 9), 11) for _ in range(count)]
    attached = without_chains(model_of(mimics))
    for n, joint in enumerate(attached.joints):
        if joint.mimic:
            leader = int(joint.mimic.joint[1:])
            assert mimics[leader] is None
            assert joint.mimic.multiplier * q[leader] + joint.mimic.offset == value(mimics, n, q)
        else:
            assert mimics[n] is None


def test_whoever_follows_a_wrong_follower_is_wrong():
    """0 follows 1 follows nobody that is there; 2, 3 and 4 a circle and its follower; 5 a fixed
    joint; 7 is right."""
    mimics = [(f"j{n}", F(2), F(1)) for n in (1, 9, 3, 2, 3, 6)] + [None, ("j8", F(1), F(0)), None]
    model = model_of(mimics, [(6, Kind.FIXED)])
    wrong = wrong_mimics(model)
    assert sorted(wrong) == ["j0", "j1", "j2", "j3", "j4", "j5"]
    assert wrong["j0"] == wrong["j1"] and "mimics 'j9', which is no joint" in wrong["j1"]
    assert all("mimics itself" in wrong[name] for name in ("j2", "j3", "j4"))
    assert "mimics 'j6', which is fixed" in wrong["j5"]
    with pytest.raises(ModelError, match="^joint 'j0': mimics 'j9'"):
        without_chains(model)


@pytest.mark.parametrize("leader", [
    lambda n, count: f"j{n + 1}" if n + 1 < count else None,
    lambda n, count: f"j{(n + 1) % count}", lambda n, count: f"x{n}"],
    ids=["a chain", "a circle", "leaders that are not there"])
def test_the_work_is_linear_in_the_number_of_followers(leader):
    def calls(count):
        names = [leader(n, count) for n in range(count)]
        model = model_of([(name, F(1), F(0)) if name else None for name in names])
        return calls_of(lambda: wrong_mimics(model))

    assert calls(4000) < 6 * calls(1000)
