"""Contact between two bodies, spheres or capsules, by the law of contacts."""

from fractions import Fraction

from coscrew_codegen.algebra.recording.numbers import (
    Number,
    Vector,
    add,
    dot,
    maximum,
    minimum,
    scaled,
    sqrt,
    subtract,
)
from coscrew_codegen.scene.contacts.closeness import Resting
from coscrew_codegen.scene.contacts.contact_law import (
    COMMON,
    STATES,
    SWITCHES,
    Meeting,
    completed,
    contact_law,
)
from coscrew_codegen.scene.contacts.touching_parts import side_of
from coscrew_codegen.scene.effect import (
    FIRST,
    POINTS,
    SECOND,
    Between,
    Effect,
    Given,
    ParameterOf,
    Place,
    TwoBodies,
    Values,
)

_LEAST = Fraction(1, 10**12)
"""m: where two axes are closer, the normal from one to the other fades to zero."""
_PARALLEL = Fraction(1, 10**6)
"""Square of the sine of the angle below which axes are parallel: they touch at the middle."""


def _force(state: TwoBodies, values: Values) -> Between:
    """The law's force on the first body, at the point halfway between both surfaces."""
    first, second = state.first, state.second
    places = _closest(state, values)
    apart = state.apart(*places)
    length = sqrt(dot(apart, apart))
    n = scaled(1 / maximum(length, _LEAST), apart)
    gap = length - values["first_radius"] - values["second_radius"]
    here = subtract(places[0], scaled(values["first_radius"] + gap / 2, first.own_direction(n)))
    there = add(places[1], scaled(values["second_radius"] + gap / 2, second.own_direction(n)))
    u = subtract(first.world_direction(first.velocity(here)),
                 second.world_direction(second.velocity(there)))
    return Between((here, there), n, u, contact_law(Meeting(gap, n, u, state.x), values))


def _closest(state: TwoBodies, values: Values) -> tuple[Vector, Vector]:
    """The closest points of both axes, in the bodies' frames.

    Of lines they follow from two equations; each is then put within its axis, and the other is the
    closest to it.  Nearly parallel ones meet in the middle."""
    a, b = values.vector(FIRST), values.vector(SECOND)
    ends = [values.optional_vector(name) for name in ("first_end", "second_end")]
    along = [None if end is None else subtract(end, start)
             for end, start in zip(ends, (a, b), strict=True)]
    r = state.apart(a, b)
    d, e = (None if line is None else body.world_direction(line)
            for body, line in zip((state.first, state.second), along, strict=True))
    if d is None or e is None or along[0] is None or along[1] is None:
        if d is not None and along[0] is not None:
            a = add(a, scaled(_within(-dot(d, r) / dot(d, d)), along[0]))
        if e is not None and along[1] is not None:
            b = add(b, scaled(_within(dot(e, r) / dot(e, e)), along[1]))
        return a, b
    dd, ee, de, dr, er = dot(d, d), dot(e, e), dot(d, e), dot(d, r), dot(e, r)
    parallel = dd * ee * _PARALLEL
    s = _within((de * er - dr * ee + parallel / 2) / maximum(
        dd * ee - de * de + parallel, parallel))
    t = _within((de * s + er) / ee)
    s = _within((de * t - dr) / dd)
    return add(a, scaled(s, along[0])), add(b, scaled(t, along[1]))


def _within(x: Number) -> Number:
    return maximum(minimum(x, 1), 0)


def _completed(values: Given, resting: Resting) -> Given:
    """The values with the law's defaults, for the radius of a ball that bends as both do.  Raises
    ValueError for a side without a radius."""
    for side in (FIRST, SECOND):
        if values[f"{side}_radius"] is None:
            raise ValueError(f"{side}_radius: missing; wanted the radius of the {side} body's "
                             "sphere or capsule, or such shapes in the model's file")
    radii = [x for name in ("first_radius", "second_radius")
             if isinstance(x := values[name], Fraction)]
    own = completed({**values, "radius": min(radii, default=None)}, resting)
    return {name: own[name] for name in values}


EFFECT = Effect(
    "contact_pair", "contact of two bodies, spheres or capsules: as with the ground",
    "N = k δ^1.5 max(1 - 1.5 alpha u_n, 0); T = -(k_t z + d_t u_t), at most mu N; z' = u_t until "
    "k_t |z| is mu N; on the first, the opposite on the second", Place.PAIR,
    (*(ParameterOf(x.name, "m", f"centre of the {x.name} body's sphere, or of an end of its "
                   "capsule, in its frame", x.kind, x.default) for x in POINTS),
     *(ParameterOf(f"{x.name}_end", "m", f"centre of the other end of the {x.name} body's capsule, "
                   "in its frame", "vector", required=False) for x in POINTS),
     *(ParameterOf(f"{x.name}_radius", "m", f"radius of the {x.name} body's sphere or capsule; "
                   "without these keys the body has the shapes of the model's file",
                   required=False, positive=True) for x in POINTS),
     *COMMON),
    bodies_force=_force, stores_energy=True, side_of=side_of, completed=_completed, states=STATES,
    switches=SWITCHES)
