"""A Delta robot with six rods that have masses: three arms on the world, rods in ball joints at
their ends, a platform that floats and closes the loops."""

from dataclasses import dataclass

import numpy as np

BASE, PLATFORM, ARM, ROD, APART = 0.15, 0.05, 0.2, 0.4, 0.05
"""m: radii of both plates, lengths of arms and rods, half the distance of parallel rods."""
START = 0.3
"""rad: by which the arms hang at the start."""
ARM_MASS, ROD_MASS, PLATFORM_MASS = 0.15, 0.03, 0.2
ARM_MOMENTS = (1e-5, ARM_MASS * ARM**2 / 12, ARM_MASS * ARM**2 / 12)
ROD_MOMENTS = (1e-6, ROD_MASS * ROD**2 / 12, ROD_MASS * ROD**2 / 12)
PLATFORM_MOMENTS = (2e-4, 2e-4, 4e-4)
NAMES = ((0, -1), (0, 1), (1, -1), (1, 1), (2, -1), (2, 1))
"""(arm, side) of each rod."""


@dataclass(frozen=True)
class Rod:
    """A rod of an arm, at one side."""

    arm: int
    side: int

    @property
    def name(self) -> str:
        return f"rod{self.arm}{'ab'[self.side > 0]}"

    @property
    def begin(self) -> tuple[float, float, float]:
        """Its end in the arm's frame."""
        return ARM, self.side * APART, 0.0

    @property
    def end(self) -> np.ndarray:
        """Its other end in the platform's frame."""
        return turn(self.arm) @ (PLATFORM, self.side * APART, 0.0)

    @property
    def start(self) -> np.ndarray:
        """The quaternion (x, y, z, w) in its arm's frame at the start, from x to its direction."""
        c, s = np.cos(START), np.sin(START)
        world = turn(self.arm) @ [[c, 0, s], [0, 1, 0], [-s, 0, c]]
        begin = turn(self.arm) @ (BASE, 0, 0) + world @ self.begin
        way = world.T @ ((0, 0, height()) + self.end - begin) / ROD
        quaternion = np.array([0, -way[2], way[1], 1 + way[0]])
        return quaternion / np.linalg.norm(quaternion)


RODS = tuple(Rod(*x) for x in NAMES)


def turn(arm: int) -> np.ndarray:
    """R of an arm's plane about z."""
    c, s = np.cos(2 * np.pi * arm / 3), np.sin(2 * np.pi * arm / 3)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def height() -> float:
    """z of the platform at the start."""
    out = BASE + ARM * np.cos(START) - PLATFORM
    return float(-ARM * np.sin(START) - np.sqrt(ROD**2 - out**2))


def scene() -> str:
    """The scene's text."""
    bodies = "".join(f"arm{n} = {{ mass = {ARM_MASS}, com = [{ARM / 2}, 0, 0], inertia = "
                     f"{list(ARM_MOMENTS)} }}\n" for n in range(3))
    bodies += "".join(f"{x.name} = {{ mass = {ROD_MASS}, com = [{ROD / 2}, 0, 0], inertia = "
                      f"{list(ROD_MOMENTS)} }}\n" for x in RODS)
    joints = "".join(x for n in range(3) for x in (_shoulder(n), *(
        _ball(rod) for rod in RODS if rod.arm == n)))
    loops = "".join(f'[loops.{x.name}]\nkind = "point"\nbodies = ["{x.name}", "platform"]\nfirst = '
                    f"[{ROD}, 0, 0]\nsecond = {x.end.tolist()}\n" for x in RODS)
    start = "".join(f"shoulder{n} = {START}\n" for n in range(3))
    start += "".join(f"{x.name} = {x.start.tolist()}\n" for x in RODS)
    return f"""[bodies]
{bodies}platform = {{ mass = {PLATFORM_MASS}, inertia = {list(PLATFORM_MOMENTS)} }}
[joints]
{joints}plate = {{ type = "free", child = "platform" }}
{loops}[effects.gravity]
[start.q]
{start}plate = [0, 0, {height()!r}, 0, 0, 0, 1]
"""


def _shoulder(n: int) -> str:
    origin = f'xyz = {(turn(n) @ (BASE, 0, 0)).tolist()}, rpy = [0, 0, "{n}*2*pi/3"]'
    return (f'shoulder{n} = {{ type = "revolute", child = "arm{n}", axis = [0, 1, 0], origin = '
            f"{{ {origin} }} }}\n")


def _ball(rod: Rod) -> str:
    return (f'{rod.name} = {{ type = "spherical", parent = "arm{rod.arm}", child = "{rod.name}", '
            f"origin = {{ xyz = {list(rod.begin)} }} }}\n")
