"""Names in a scene's text: symbols with the number of a link or behind a name, and their legend."""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence

SYMBOLS: dict[tuple[str, ...], str] = {
    ("s", "c"): "sine and cosine of the joint's angle",
    ("R",): "rotation of the link's frame in its parent's",
    ("t",): "origin of the link's frame in its parent's",
    ("Rw",): "rotation of the link's frame in the world's",
    ("tw",): "origin of the link's frame in the world's",
    ("xw",): "position of a point of the body in the world's frame",
    ("wp",): "angular velocity of the parent",
    ("w",): "angular velocity",
    ("v",): "velocity of the origin",
    ("dw",): "angular acceleration",
    ("U",): "acceleration tensor dw~ + w~ w~, where w~ x = w × x: U x is the acceleration of "
             "a point x relative to the origin",
    ("a",): "acceleration of the origin, less that of gravity",
    ("B", "Bm", "Bh", "BI"): "inertia of the link, of all its bodies: mass; first and second "
                             "moments about the origin",
    ("I",): "inertia of the joint alone, such as gear^2 rotor of an armature",
    ("n", "nl", "na"): "axes of the joint in the link's frame (linear; angular)",
    ("f", "m"): "net force and moment about the origin, less those of effects",
    ("fj", "mj"): "force and moment about the origin that the joint transmits",
    ("fp", "mp"): "what the joint transmits, force and moment or momentum, in the parent's frame, "
                  "about its origin",
    ("fA", "mA"): "net force and moment of the link and of all links beyond it, whose joints move "
                  "freely",
    ("fB", "mB"): "what the joint transmits, less articulated inertia times the link's "
                  "acceleration",
    ("tau",): "force or torque along the joint's axis; after an effect's name, the effect's",
    ("p", "L"): "momentum and angular momentum about the origin",
    ("pj", "Lj"): "momentum and angular momentum of the link and all links beyond it",
    ("T", "V"): "kinetic and potential energy",
    ("C", "Cm", "Ch", "CI"): "composite inertia of the link and all links beyond it",
    ("Cp", "Cpm", "Cph", "CpI"): "composite inertia in the parent's frame",
    ("F",): "force and moment for a unit acceleration of the joint",
    ("M",): "entries of the mass matrix",
    ("A", "Al", "Ac", "Aa"): "articulated inertia A = [[Al, Ac^T], [Ac, Aa]], linear part first",
    ("Ap", "Apl", "Apc", "Apa"): "the part of the articulated inertia that acts on the parent "
                                 "through the joint, in the parent's frame",
    ("S", "Sl", "Sa"): "articulated inertia times the joint's axes (linear; angular)",
    ("D",): "inertia along the joint's axes; of several axes, L D L^T",
    ("Di",): "1 / D",
    ("K", "Kl", "Ka"): "articulated inertia times the joint's axes, over D (linear; angular)",
    ("u",): "torque that accelerates the joint: along its axis, less the transmitted wrench",
    ("qdd",): "acceleration of the joint",
    ("al", "aa"): "acceleration (linear, angular) due to the joints' accelerations",
    ("own",): "of the joint itself: inertia, torques of effects",
    ("J",): "columns of the Jacobian",
    ("cm",): "centre of mass of all links, in the link's frame",
    ("h",): "momentum of the link and all links beyond it for a unit velocity of the joint",
    ("ds",): "rates of the joint's axes",
    ("dT",): "gradients of the kinetic energy",
    ("q",): "coordinates after the step",
    ("drift", "kick"): "change of q, and velocities, after part of a step",
}
_KNOWN = [symbol for symbols in SYMBOLS for symbol in symbols]


def legend(names: Iterable[str]) -> tuple[str, ...]:
    """Paragraphs that explain the symbols in these names: 'wp: angular velocity of the parent'; ()
    if there are none."""
    known = {name: read for name in sorted(set(names)) if (read := reading(name))[0]}
    results = {symbol for symbol, *_ in known.values()}
    rows = tuple(f"{', '.join(x for x in symbols if x in results)}: {words}"
                 for symbols, words in SYMBOLS.items() if results.intersection(symbols))
    return (*_marks({name: [x for x in marks if x] for name, (_, *marks) in known.items()}),
            *rows) if rows else ()


_MARKS = "(?P<sign>n?)(?P<number>(?:v[0-9]+)?)(?P<step>(?:_[0-9]+)?)"
_OF_LINK = re.compile(f"(?P<symbol>[A-Za-z]+)[0-9]+[xyz]{{0,2}}{_MARKS}")
_OF_NAME = re.compile(f"[A-Za-z0-9_]+_(?P<symbol>{'|'.join(_KNOWN)})[xyz]{{0,2}}{_MARKS}")


def reading(name: str) -> tuple[str, str, str, str]:
    """The parts of a name: its symbol, and "sign", "number", "step" if it has these, else "".  All
    are empty if it has no symbol."""
    match = _OF_LINK.fullmatch(name) or _OF_NAME.fullmatch(name)
    if not match or match["symbol"] not in _KNOWN:
        return "", "", "", ""
    sign, number, step = (x if match[x] else "" for x in ("sign", "number", "step"))
    return match["symbol"], sign, number, step


def _marks(known: Mapping[str, Sequence[str]]) -> Iterator[str]:
    """The way in which names are made, by examples among those `known`, each with its marks."""
    example = next((x for x, marks in known.items() if not marks and _VECTOR.fullmatch(x)), "")
    of = _VECTOR.fullmatch(example)
    such = f": {example} is {of[1]} of link {of[2]} along {of[3]}" if of else ""
    yield ("Names consist of the symbol of a quantity, the number of its link, which headings "
           f"name, and a component{such}.  Vectors are in the link's frame, about its origin, "
           "unless stated otherwise; intermediate results are in any frame.  Equal values have one "
           "name.  q[0] is an element of the argument q, sin_q its sine.")
    described = []
    for mark, words in _MARKED.items():
        if name := next((x for x, marks in known.items() if marks == [mark]), ""):
            described.append(f"{name} is {words.format(_MARK.sub('', name))}")
    if described:
        yield "; ".join(described) + "."


_VECTOR = re.compile("([A-Za-z]+)([0-9]+)([xyz])")
_MARK = re.compile("(n|v[0-9]+|_[0-9]+)$")
_MARKED = {"sign": "-{}", "number": "another value of {}, such as a longer sum",
           "step": "an intermediate result for {}"}
"""Meanings of the marks at the ends of names."""
