"""Names in a scene's text: symbols with the number of a link or behind a name, and their legend."""

import re
from collections.abc import Iterable, Iterator

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
    ("fp", "mp"): "fj and mj, fB and mB, or pj and Lj, in the parent's frame, about its origin",
    ("fA", "mA"): "f and m, with fp and mp of the links beyond, whose joints move freely",
    ("fB", "mB"): "fA and mA with the part of u: what the joint transmits less A times the link's "
                  "acceleration",
    ("tau",): "force or torque along the joint's axis; after an effect's name, the effect's",
    ("p", "L"): "momentum and angular momentum about the origin",
    ("pj", "Lj"): "the same of the link and all links beyond it",
    ("T", "V"): "kinetic and potential energy",
    ("C", "Cm", "Ch", "CI"): "composite inertia of the link and all links beyond it",
    ("Cp", "Cpm", "Cph", "CpI"): "the same in the parent's frame",
    ("F",): "force and moment for a unit acceleration of the joint",
    ("M",): "entries of the mass matrix",
    ("A", "Al", "Ac", "Aa"): "articulated inertia A = [[Al, Ac^T], [Ac, Aa]], linear part first",
    ("Ap", "Apl", "Apc", "Apa"): "the part of it that acts on the parent through the joint, in the "
                                 "parent's frame",
    ("S", "Sl", "Sa"): "articulated inertia times the joint's axes (linear; angular)",
    ("D",): "inertia along the joint's axes; of several axes, L D L^T",
    ("Di",): "1 / D",
    ("K", "Kl", "Ka"): "articulated inertia times the joint's axes, over D (linear; angular)",
    ("u",): "torque that accelerates the joint: along its axis, less the transmitted wrench",
    ("qdd",): "acceleration of the joint",
    ("al", "aa"): "acceleration (linear, angular) due to the joints' accelerations",
    ("own",): "of the joint itself: inertia, torques of effects",
    ("J",): "columns of the Jacobian",
    ("q",): "coordinates after the step",
    ("drift", "kick"): "change of q, and velocities, after part of a step",
}
_KNOWN = [symbol for symbols in SYMBOLS for symbol in symbols]


def legend(names: Iterable[str]) -> tuple[str, ...]:
    """Paragraphs that explain the symbols in these names: 'wp: angular velocity of the parent'; ()
    if there are none."""
    found: set[str] = set()
    marks: set[str] = set()
    for name in set(names):
        symbol, *others = reading(name)
        found.add(symbol)
        marks.update(others)
    rows = tuple(f"{', '.join(x for x in symbols if x in found)}: {words}"
                 for symbols, words in SYMBOLS.items() if found.intersection(symbols))
    return (*_marks(marks), *rows) if rows else ()


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


def _marks(marks: set[str]) -> Iterator[str]:
    yield ("Names consist of the symbol of a quantity, the number of its link, which headings "
           "name, and a component: w3x is w of link 3 along x.  Vectors are in the link's frame, "
           "about its origin, unless stated otherwise; intermediate results are in any frame.  "
           "Equal values have one name.  a[0] is an element of the argument a.")
    words = {"sign": "w3xn is -w3x", "number": "w3xv2 another value of it, such as a longer sum",
             "step": "w3x_1 an intermediate result for it, w3_1 one for several components"}
    if said := [words[x] for x in words if x in marks]:
        yield "; ".join(said) + "."
