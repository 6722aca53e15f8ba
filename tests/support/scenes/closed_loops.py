"""Scenes with closed loops: linkages whose motion is published or follows from one equation."""

from collections.abc import Mapping
from math import pi

PLANAR = 'type = "continuous", axis = [0, 0, 1]'


def andrews() -> str:
    """Andrews' squeezing mechanism: seven bodies in a plane, three points closed, of one freedom,
    with the numbers of the test set for solvers of initial value problems.

    Joints turn relative to their parents: beta, theta, gamma, delta, phi, epsilon, omega."""
    bodies = {
        "K1": (0.04325, (92e-5, 0), 2.194e-6), "K2": (0.00365, (-115e-4, 0), 4.410e-7),
        "K3": (0.02373, (1043e-5, -1874e-5), 5.255e-6),
        "K5": (0.07050, (2308e-5, 916e-5), 1.169e-5),
        "K4": (0.00706, (0, -(2e-2 - 1421e-5)), 5.667e-7),
        "K7": (0.05498, (-449e-5, -1228e-5), 1.912e-5),
        "K6": (0.00706, (2e-2 - 1421e-5, 0), 5.667e-7)}
    joints = {"beta": ("world", "K1", (0, 0)), "theta": ("K1", "K2", (7e-3, 0)),
              "gamma": ("world", "K3", (-0.03635, 0.03273)),
              "delta": ("world", "K5", (-0.06934, -0.00227)), "phi": ("K5", "K4", (4e-2, 0)),
              "epsilon": ("world", "K7", (-0.06934, -0.00227)), "omega": ("K7", "K6", (0, -4e-2))}
    start = {"beta": -.0617138900142764496, "theta": 0, "gamma": .455279819163070380,
             "delta": .487364979543842550, "phi": .222668390165885885,
             "epsilon": 1.23054744454982119, "omega": -.222668390165885885}
    ends = {"gamma": ("K3", (0, -35e-3)), "phi": ("K4", (0, -2e-2)), "omega": ("K6", (2e-2, 0))}
    loops = "".join(f"""[loops.{name}]
kind = "point"
bodies = ["K2", "{body}"]
first = [-28e-3, 0, 0]
second = [{x!r}, {y!r}, 0]
""" for name, (body, (x, y)) in ends.items())
    return f"""{_bodies(bodies)}{_joints(joints)}{loops}[effects.actuator.beta]
kind = "torque"
torque = 0.033
[effects.spring_damper.spring]
bodies = ["K3", "world"]
first = [2e-2, -18e-3, 0]
second = [0.014, 0.072, 0]
k = 4530
length = 0.07785
[start]
q = {{ {", ".join(f"{name} = {x!r}" for name, x in start.items())} }}
"""


def linked_four_bars(loops: str = "point", g: float = 9.81) -> str:
    """Two four-bar linkages of equal rods of 1 m and 1 kg, side by side (A02 of the IFToMM library
    of benchmarks): one freedom, and all rods in line at dead points.

    Three posts turn about their ends, two beams move along: θ'' = 3.5 g/3 sin θ of the posts' angle
    from the vertical, which starts at 0 with 1 rad/s."""
    rod = (1, (0.5, 0), 1 / 12)
    names = ("post1", "beam1", "post2", "beam2", "post3")
    joints = {"first": ("world", "post1", (0, 0)), "beam_1": ("post1", "beam1", (1, 0)),
              "second": ("world", "post2", (1, 0)), "beam_2": ("post2", "beam2", (1, 0)),
              "third": ("world", "post3", (2, 0))}
    closed = "".join(f"""[loops.{post}]
kind = "{loops}"
bodies = ["{beam}", "{post}"]
first = [1, 0, 0]
second = [1, 0, 0]
{"axis = [0, 0, 1]" if loops == "hinge" else ""}
""" for beam, post in (("beam1", "post2"), ("beam2", "post3")))
    posts, beams = (pi / 2, -1.0), (-pi / 2, 1.0)
    start = {"first": posts, "beam_1": beams, "second": posts, "beam_2": beams, "third": posts}
    return f"""{_bodies(dict.fromkeys(names, rod))}{_joints(joints)}{closed}[effects.gravity]
g = [0, {-g!r}, 0]
[start]
q = {{ {", ".join(f"{name} = {q!r}" for name, (q, _) in start.items())} }}
v = {{ {", ".join(f"{name} = {v!r}" for name, (_, v) in start.items())} }}
"""


def crank_rocker(kind: str = "point", loops: int = 1) -> str:
    """A four-bar linkage of 0.3, 0.8, 0.6 and 0.9 m whose crank turns at about 9 rad/s; its loop is
    closed so many times."""
    rods = {"crank": (1, (0.15, 0), 0.0075), "coupler": (1, (0.4, 0), 0.8**2 / 12),
            "rocker": (1, (0.3, 0), 0.03)}
    joints = {"drive": ("world", "crank", (0, 0)), "elbow": ("crank", "coupler", (0.3, 0)),
              "pivot": ("world", "rocker", (0.9, 0))}
    closed = "".join(f"""[loops.knee{n}]
kind = "{kind}"
bodies = ["coupler", "rocker"]
first = [0.8, 0, 0]
second = [0.6, 0, 0]
{"axis = [0, 0, 1]" if kind == "hinge" else ""}
""" for n in range(loops))
    return f"""{_bodies(rods)}{_joints(joints)}{closed}[effects.gravity]
g = [0, -9.81, 0]
[start]
q = {{ drive = 0.502096581, elbow = 0.103283917, pivot = 1.53612081 }}
v = {{ drive = 9, elbow = -12.616119075, pivot = -0.578448498 }}
"""


def floating_loop() -> str:
    """A free body that carries a four-bar linkage, and spins without gravity."""
    rods = {"crank": (1, (0.15, 0), 0.0075), "coupler": (1, (0.4, 0), 0.8**2 / 12),
            "rocker": (1, (0.3, 0), 0.03)}
    joints = {"drive": ("base", "crank", (0, 0)), "elbow": ("crank", "coupler", (0.3, 0)),
              "pivot": ("base", "rocker", (0.9, 0))}
    return f"""{_bodies({"base": (2, (0, 0), 0.08), **rods})}{_joints(joints)}
root = {{ type = "free", child = "base" }}
[loops.knee]
kind = "point"
bodies = ["coupler", "rocker"]
first = [0.8, 0, 0]
second = [0.6, 0, 0]
[start]
q = {{ drive = 0.502096581, elbow = 0.103283917, pivot = 1.53612081 }}
v = {{ root = [0.1, 0.2, -0.1, 0.3, 0.5, 0.7] }}
"""


def rope(length: float = 2.0) -> str:
    """A body on a rod from its centre of mass to the world, without gravity."""
    return f"""[bodies]
ball = {{ mass = 3, inertia = [0.1, 0.2, 0.25] }}
[joints]
root = {{ type = "free", child = "ball" }}
[loops.rod]
kind = "rod"
bodies = ["ball", "world"]
length = {length!r}
[start]
q = {{ root = [{length!r}, 0, 0, 0, 0, 0, 1] }}
v = {{ root = [0, 5, 0, 0, 0, 0] }}
"""


def beam(cut: bool) -> str:
    """A double pendulum whose second link is whole, or cut in halves that are welded: the outer
    half floats."""
    half = "com = [0.25, 0, 0], inertia = [0.01, 0.02, 0.03]"
    link = "{ mass = 1, com = [0.1, 0.2, 0.3], inertia = [0.1, 0.1, 0.15] }"
    cut_off = """far = { type = "free", child = "outer" }
[frames]
end = { to = "inner", xyz = [0.5, 0, 0], rpy = [0.3, 0.2, 0.1] }
begin = { to = "outer", rpy = [0.3, 0.2, 0.1] }
[loops.weld]
kind = "frame"
bodies = ["end", "begin"]
""" if cut else """far = { type = "fixed", parent = "inner", child = "outer",""" \
        " origin = { xyz = [0.5, 0, 0] } }\n"
    return f"""[bodies]
link = {link}
inner = {{ mass = 2, {half} }}
outer = {{ mass = 1, {half} }}
[joints]
first = {{ type = "revolute", child = "link", axis = [1, 0, 0] }}
second = {{ type = "revolute", parent = "link", child = "inner", axis = [0, 1, 0], {_AT_TIP} }}
{cut_off}[effects.gravity]
[start]
{"q = { far = [0.5, 0.1, 0.4, 0, 0, 0, 1] }" if cut else ""}
"""


_AT_TIP = "origin = { xyz = [0, 0.1, 0.4] }"


def _bodies(bodies: Mapping[str, tuple[float, tuple[float, float], float]]) -> str:
    """Tables of bodies in the plane: mass, centre, moment about the centre."""
    return "[bodies]\n" + "".join(
        f"{name} = {{ mass = {m!r}, com = [{x!r}, {y!r}, 0], inertia = [{I!r}, {I!r}, {I!r}] }}\n"
        for name, (m, (x, y), I) in bodies.items())


def _joints(joints: Mapping[str, tuple[str, str, tuple[float, float]]]) -> str:
    """Tables of joints in the plane: parent, child, origin."""
    return "[joints]\n" + "".join(
        f'{name} = {{ {PLANAR}, parent = "{parent}", child = "{child}", '
        f"origin = {{ xyz = [{x!r}, {y!r}, 0] }} }}\n"
        for name, (parent, child, (x, y)) in joints.items())


_LAW = """joints = { rail = 1, "cross.1" = 0.3 }
leaders = { shoulder = 1 }
polynomial = [0.388533333333333333, 0.4, -0.3, 0.2]"""
"""Closed at 1/3, 3/5 and 2/5."""


def spatial(kind: str, second: str = "hand", place: str = "xyz = [0.2, 0.1, 0.1]") -> str:
    """A floating base with two arms of all kinds of joints, and a loop of this kind between a frame
    at the end of one and a frame at that `place` of the other, or of the world; it is closed where
    both frames coincide.  A law is of their joints."""
    more = {"hinge": "axis = [1, 2, 2]", "rod": "length = 0.7"}
    apart = "[0.47, 0.66, -0.1]" if kind == "rod" else "[0.05, 0.1, -0.1]"
    closure = f"""bodies = ["end", "other"]
first = [0.05, 0.1, -0.1]
second = {apart}
{more.get(kind, "")}"""
    inertia = "inertia = [0.3, 0.4, 0.5, 0.01, 0.02, -0.03]"
    bodies = "".join(f"{name} = {{ mass = {m}, com = [0.1, {y}, -0.2], {inertia} }}\n"
                     for name, m, y in (("base", 3, 0.1), ("upper", 1.5, 0.2), ("tip", 1, -0.1),
                                        ("slider", 2, 0.3), ("hand", 0.7, 0.05)))
    turned = "xyz = [0.1, 0.2, 0.3], quaternion = [0.2, 0.4, 0.4, 0.8]"
    return f"""[bodies]
{bodies}[joints.root]
type = "free"
child = "base"
[joints.shoulder]
type = "revolute"
parent = "base"
child = "upper"
axis = [1, 2, 2]
origin = {{ xyz = [0.2, 0.3, 0.1] }}
[joints.elbow]
type = "spherical"
parent = "upper"
child = "tip"
origin = {{ {turned} }}
[joints.rail]
type = "prismatic"
parent = "base"
child = "slider"
axis = [0, 0.6, 0.8]
origin = {{ xyz = [-0.2, 0.1, 0.4] }}
[joints.cross]
type = "universal"
parent = "slider"
child = "hand"
axis = [1, 0, 0]
axis2 = [0, 1, 0]
origin = {{ {turned} }}
[frames]
end = {{ to = "tip", xyz = [0.1, -0.2, 0.3], rpy = [0.3, -0.5, 0.7] }}
other = {{ to = "{second}", {place} }}
[loops.closing]
kind = "{kind}"
{_LAW if kind == "law" else closure}
[effects.gravity]
[effects.viscous]
joints = "all"
d = 0.2
"""

J, M = 0.3, 2.0
CAM = f"""
[bodies]
cam = {{ mass = 1, inertia = [0.2, 0.2, {J}] }}
valve = {{ mass = {M}, com = [0.1, 0, 0], inertia = [0.1, 0.1, 0.1] }}
[joints]
shaft = {{ type = "continuous", child = "cam", axis = [0, 0, 1] }}
lift = {{ type = "prismatic", child = "valve", axis = [0, 1, 0] }}
[loops.follow]
kind = "law"
joints = {{ lift = 1 }}
leaders = {{ shaft = 1 }}
polynomial = [0.1, 0.4, -0.3, 0.2]
[outputs]
record = ["q", "energy", "closing.follow"]
[start.q]
lift = 0.1
[start.v]
shaft = 0.5
lift = 0.2
[run]
duration = 1
"""
"""A cam of inertia J that lifts a valve of mass M by a polynomial of its angle."""
