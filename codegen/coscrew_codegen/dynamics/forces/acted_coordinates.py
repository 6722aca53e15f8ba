"""Coordinates along which an effect at joints acts: of a joint with one coordinate this; of a joint
with several, one for each velocity; or a weighted sum of joints' coordinates."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

from coscrew_codegen.algebra.recording.numbers import Number, dot, maximum, scaled, sqrt
from coscrew_codegen.dynamics.algorithms.motion import Motion
from coscrew_codegen.scene.effect import Effect, required
from coscrew_codegen.scene.mechanism.loop import WeightedCoordinate
from coscrew_codegen.scene.mechanism.tree import Tree
from coscrew_codegen.scene.scene import Applied, Setting

SUM = -1
"""Stands for the link of a weighted sum."""
_NO_ANGLE = Fraction(1, 10**12)
"""rad: nearer to rest a joint has no axis about which it is turned."""


@dataclass(frozen=True)
class ActedCoordinate:
    """q, its rate v, and the effect's values along it."""

    q: Number
    v: Number
    values: Mapping[str, Setting]
    link: int  # that its joint moves; SUM
    freedom: int = 0  # the number of the velocity among those of the joint
    weights: Mapping[int, Number | Fraction] = field(default_factory=dict)  # of a sum, by velocity


def acted_coordinates(motion: Motion, applied: Applied) -> list[ActedCoordinate]:
    """The coordinates along which the effect acts."""
    if applied.terms:
        return [ActedCoordinate(*sum_of(motion, applied.terms), applied.values, SUM,
                                weights=weights_of(motion.tree, applied.terms))]
    link = link_of(motion, applied.on)
    q, v = motion.coordinates(link), motion.speeds(link)
    if len(v) == 1:
        return [ActedCoordinate(q[0], v[0], applied.values, link)]
    if applied.effect.by_angle:
        return [_angle(motion, link, applied)]
    along, values = _from_rest(motion, link, applied)
    return [ActedCoordinate(x, rate, values(k), link, k)
            for k, (x, rate) in enumerate(zip(along, v, strict=True))]


def link_of(motion: Motion, joint: str) -> int:
    """The number of the link that a joint moves."""
    return motion.tree.links.index(motion.tree.link_of(joint))


def weights_of(tree: Tree, terms: Iterable[WeightedCoordinate]) -> dict[int, Fraction]:
    """The weights of the velocities in the rate of a sum; a follower's is its leader's, times its
    multiplier."""
    weights: dict[int, Fraction] = {}
    for term in terms:
        link = tree.link_of(term.joint)
        place, weight = link.v.start + term.coordinate, term.weight
        if link.driver:
            place = tree.links[link.driver.link].v.start
            weight = weight * link.driver.multiplier
        weights[place] = weights.get(place, Fraction(0)) + weight
    return {place: weight for place, weight in weights.items() if weight}


def sum_of(motion: Motion, terms: Iterable[WeightedCoordinate]) -> tuple[Number, Number]:
    """Σ weight q and Σ weight v."""
    q = v = motion.zero[0]
    for term in terms:
        link = link_of(motion, term.joint)
        q = q + motion.coordinates(link)[term.coordinate] * term.weight
        v = v + motion.speeds(link)[term.coordinate] * term.weight
    return q, v


def _angle(motion: Motion, link: int, applied: Applied) -> ActedCoordinate:
    """The angle by which a joint is turned, whose rate is that about the axis of its rotation."""
    x = motion.tree.links[link]
    deviation = required(required(x.joint.kind.manifold).deviation)
    turned = tuple(deviation(motion.coordinates(link), motion.recorder.numbers(
        [Fraction(y) for y in x.joint.kind.neutral])))
    angle = sqrt(maximum(dot(turned, turned), _NO_ANGLE**2))
    axis = scaled(1 / angle, turned)
    return ActedCoordinate(angle, dot(axis, motion.speeds(link)), applied.values, SUM,
                           weights=dict(zip(x.v, axis, strict=True)))


def _from_rest(motion: Motion, link: int, applied: Applied
               ) -> tuple[Sequence[Number], Callable[[int], Mapping[str, Setting]]]:
    """q along each velocity of a joint with several, and the values there: the deviation from the
    coordinates of rest, if the effect has such and q' is not v."""
    kind, effect, q = motion.tree.links[link].joint.kind, applied.effect, motion.coordinates(link)
    if kind.manifold is None:
        return q, lambda k: _with_rest(effect, applied.values, k)
    if not effect.rest or kind.manifold.deviation is None:
        return [motion.zero[0]] * kind.nv, lambda k: applied.values
    given = applied.values[effect.rest]
    rest = motion.recorder.numbers(
        [x for x in given if isinstance(x, Fraction)] if isinstance(given, tuple) else
        [Fraction(x) for x in kind.neutral])
    return kind.manifold.deviation(q, rest), lambda k: {
        **applied.values, effect.rest: Fraction(0)}


def _with_rest(effect: Effect, values: Mapping[str, Setting], k: int) -> Mapping[str, Setting]:
    """The values, of the coordinates at rest the k-th."""
    given = values[effect.rest] if effect.rest else None
    return {**values, effect.rest: given[k]} if isinstance(given, tuple) else values
