"""Law of contacts: Hertz's with Hunt and Crossley's damping along the normal, elastic-plastic
bristles across it, which hold for ever what dry friction would let creep; moments that resist spin
and rolling."""

from dataclasses import dataclass, replace
from fractions import Fraction
from math import log
from math import sqrt as root_of

from coscrew_codegen.algebra.recording.numbers import (
    Number,
    Vector,
    add,
    dot,
    less,
    maximum,
    minimum,
    negative,
    scaled,
    sqrt,
    subtract,
    where,
)
from coscrew_codegen.scene.contacts.closeness import MOST_AT_REST, BodyContact, Resting
from coscrew_codegen.scene.effect import ContactForce, Given, ParameterOf, Slopes, StateOf, Values

_LEAST = Fraction(1, 10**30)
"""N: instead of a force of zero, so that there is no 0/0."""
_FREE_FALL = Fraction(981, 100)
"""m/s²: of a load where there is no gravity."""


@dataclass(frozen=True)
class Meeting:
    """One surface over another, in the world's frame: the gap, the normal out of the other, the
    velocities of the first relative to the other, and the bristles."""

    gap: Number
    n: Vector
    u: Vector  # of the point of contact
    x: Vector
    w: Vector = ()  # angular velocity, where a moment resists it


def contact_law(at: Meeting, values: Values) -> ContactForce:
    """Along the normal N = k δ^1.5 max(1 - 1.5 alpha u_n, 0); across it -s (k_t z + d_t u_t), with
    s such that it is at most mu N.

    The bristles z are in the world's frame.  They move with u_t and keep within mu N/k_t, and store
    k_t |z|²/2; the power holds all that the force across the normal does, also what they store."""
    gap, n, u = at.gap, at.n, at.u
    rise = dot(u, n)
    slip = subtract(u, scaled(rise, n))
    depth = maximum(-gap, 0)
    root, steepness = values["k"] * sqrt(depth), values["alpha"] * Fraction(3, 2)
    elastic, push = root * depth, maximum(1 - steepness * rise, 0)
    N = elastic * push
    grip, k_t, d_t = values["mu"] * N, values["k_t"], values["d_t"]
    z = subtract(at.x, scaled(dot(at.x, n), n))
    pull = add(scaled(k_t, z), scaled(d_t, slip))
    share = grip / maximum(maximum(sqrt(dot(pull, pull)), grip), _LEAST)
    friction = scaled(share, pull)
    bent = k_t * sqrt(dot(z, z))
    held = minimum(bent, grip)
    damping = where(less(gap.like(0), push), steepness * elastic, 0)
    law = ContactForce(
        subtract(scaled(N, n), friction), energy=elastic * depth * Fraction(2, 5),
        power=(N - elastic) * rise - dot(friction, slip),
        across=Slopes(share * d_t, share * k_t),
        along=Slopes(damping, root * push * Fraction(3, 2)),
        rates=slip, bounded=z, share=minimum(grip / maximum(bent, _LEAST), 1),
        switches=(gap, grip - sqrt(dot(pull, pull)), grip - bent), stored=held * held / (2 * k_t),
        contact=BodyContact(values["k"], gap, rise, values["depth"]))
    return _with_moments(law, at, N, values) if at.w else law


def resists_turning(values: Values) -> bool:
    """Returns whether the contact has moments."""
    return values.get("torsional") is not None or values.get("rolling") is not None


def _with_moments(law: ContactForce, at: Meeting, N: Number, values: Values) -> ContactForce:
    """The law with the moments -torsional N w_n and -rolling N w_t, each over |w| or, where that is
    smaller, smoothly over eps.  Their slopes are those of the lines through rest."""
    zero, eps = N.like(0), values["eps"]
    spin = dot(at.w, at.n)
    roll = subtract(at.w, scaled(spin, at.n))
    slopes = [zero if (lever := values.get(name)) is None else
              lever * N / sqrt(square + eps * eps)
              for name, square in (("torsional", spin * spin), ("rolling", dot(roll, roll)))]
    torsional, rolling = slopes
    moment = negative(add(scaled(torsional * spin, at.n), scaled(rolling, roll)))
    return replace(law, moment=moment, power=law.power + dot(moment, at.w),
                   torsional=Slopes(torsional, zero), rolling=Slopes(rolling, zero))


def completed(values: Given, resting: Resting) -> Given:
    """The values with defaults for those that are not given, from the depth and the load.

    Raises ValueError for values that exclude each other, and if a load is missing."""
    given = {name: x for name, x in values.items() if isinstance(x, Fraction)}
    for one, other in (("depth", "k"), ("restitution", "alpha")):
        if one in given and other in given:
            raise ValueError(f"{one} and {other} are given; wanted one of them")
    if given.get("restitution", Fraction(0)) > 1:
        raise ValueError("a bounce does not gain speed; wanted a restitution of at most 1")
    load, k = given.get("load", resting.load), given.get("k")
    if not load and not {"k", "k_t", "d_t"} <= given.keys():
        raise ValueError("without gravity no weight presses on the ground; wanted load in N")
    radius = given.get("radius", Fraction(0))
    depth = given.get("depth", min(Fraction(1, 1000), radius / 20 or 1))
    if k is None:
        k = _fraction(float(load) / float(depth)**1.5)
    else:
        depth = _fraction((float(load) / float(k))**(2 / 3))
    k_t = given.get("k_t") or load / depth
    d_t = given["d_t"] if "d_t" in given else _fraction(
        0.4 * root_of(float(k_t * load / (resting.g or _FREE_FALL))))
    alpha = _fraction(damping_of(float(given["restitution"]), float(given["speed"]))) \
        if "restitution" in given else given.get("alpha", Fraction(1))
    return {**values, "load": load, "depth": depth, "k": k, "alpha": alpha, "k_t": k_t, "d_t": d_t}


def _fraction(x: float) -> Fraction:
    return Fraction(repr(x))


def damping_of(restitution: float, speed: float) -> float:
    """alpha with which a bounce at this speed keeps this share e of it.

    With y = 1.5 alpha v the law's bounce has (1 + e) y = log((1 + y)/(1 - e y)); y lies between 0
    and 1/e."""
    if restitution >= 1:
        return 0.0
    e, low, high = restitution, 0.0, 1 / restitution
    while low < (y := (low + high) / 2) < high:
        if (1 + e) * y < log((1 + y) / (1 - e * y)):
            high = y
        else:
            low = y
    return y / (1.5 * speed)


COMMON = (
    ParameterOf("mu", "1", "coefficient of friction", nonnegative=True),
    ParameterOf("depth", "m", "how deep it sinks under the load, in place of k; 1 mm, or 1/20 of "
                "the radius if that is less, if neither is given", required=False, positive=True),
    ParameterOf("load", "N", "the weight of the body's tree over the number of its contacts, at "
                f"most {MOST_AT_REST}, or of the lighter of two trees, if not given",
                required=False, positive=True),
    ParameterOf("k", "N/m^1.5", "stiffness; load/depth^1.5 if not given", required=False,
                positive=True),
    ParameterOf("alpha", "s/m", "damping: a bounce at the speed v keeps about 1/(1 + alpha v) of "
                "it; 1 if neither it nor restitution is given", required=False, nonnegative=True),
    ParameterOf("restitution", "1", "share of its speed that a bounce at `speed` keeps, in place "
                "of alpha", required=False, positive=True),
    ParameterOf("speed", "m/s", "speed of that bounce", default=1, positive=True),
    ParameterOf("k_t", "N/m", "stiffness of the bristles; load/depth if not given",
                required=False, positive=True),
    ParameterOf("d_t", "N s/m", "damping of the bristles; 0.4 sqrt(k_t load/g) if not given",
                required=False, nonnegative=True))
"""The parameters of the law without moments."""
MOMENTS = (
    ParameterOf("torsional", "m", "largest moment about the normal that resists spin, over the "
                "normal force", required=False, nonnegative=True),
    ParameterOf("rolling", "m", "largest moment that resists rolling, over the normal force",
                required=False, nonnegative=True),
    ParameterOf("eps", "rad/s", "angular velocity at which these moments have 71 % of their "
                "values: slower ones creep", default=Fraction(1, 1000), positive=True))
STATES = tuple(StateOf(x, "m", f"deflection of the bristles along the world's {x}") for x in "xyz")
SWITCHES = 3
"""It closes or opens, it begins or ceases to slip, its bristles reach their bounds or leave them.
"""
