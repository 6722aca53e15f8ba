"""An arm, the truth of its accurate functions at random states, and the signs of their C that can
be flipped unnoticed."""

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np

from coscrew_codegen.backends.output_files import scene_files
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program.scene_functions import FunctionProgram, SceneFunctions
from coscrew_codegen.program.values.formats import DOUBLE
from coscrew_codegen.scene.scene import Scene
from tests.support.scenes import mechanisms as m
from tests.support.scenes.kinds import Kind
from tests.support.scenes.tiers import components, states, truths
from tests.support.truth.condition import conditions
from tests.support.truth.sign_mutants import mutants

LARGEST = 1e9  # condition
MOST = 0.5 + 1e-5  # units of the last digit


@dataclass(frozen=True)
class Judged:
    """A function's text and its expected results."""

    text: str
    name: str
    package: str
    given: list[np.ndarray]
    high: np.ndarray  # the truth in two parts, in units of its last digit from `high`
    low: np.ndarray
    unit: np.ndarray
    condition: np.ndarray

    @property
    def counted(self) -> np.ndarray:
        """True if the condition allows a judgement."""
        return self.condition < LARGEST


@dataclass(frozen=True)
class Links:
    """Common data of all links of an arm.

    The numbers, and those of the inertia about the joint, are in double odd multiples of their last
    digit, so that a sum in another order than Two-Sum's is not exact by chance."""

    at: tuple[str, str, str]
    mass: str
    com: tuple[str, str, str]
    moments: tuple[str, ...]


ARMS = (Links(("0.228", "-0.31", "0.163"), "1.05", ("0.043", "0.059", "-0.082"),
              ("0.24", "0.334", "0.413", "0.108", "-0.075", "0.126")),
        Links(("0.02", "-0.014", "0.018"), "7.7", ("2.128", "1.479", "-1.392"),
              ("8.744", "12.92", "16.637", "29.507", "-25.465", "4.954")))
"""In the first, what a link moves outweighs it; in the second, it outweighs what it moves."""

SAME = ("U1xyn - U1xyn_right_1) [+] (dw1z - U1xyn_right_1)",
        "U1zy + U1zy_right_1) [-] (dw1xn - U1zy_right_1)",
        "mB4z - mB4z_right_1) [+] (forward_dynamics->u4 -")
"""Signs of what is zero: the second part b - right of the error of a + b, b being c - a rounded.
If |a| > |b|, either c / a is in [1/2, 2] and b is c - a, or b / a is in [-1, -1/2]; so a + b is
exact.  If |a| <= |b|, a + b rounds to c, and right = c - a to b again (ties apart)."""


def scene(arm: Links) -> Scene:
    """Four joints that turn about different axes, one that slides, dampers."""
    links = [(Kind.PRISMATIC if n == 2 else Kind.REVOLUTE, axis, m.at(*arm.at),
              m.inertia(arm.mass, arm.com, arm.moments))
             for n, axis in enumerate((m.Z, m.Y, m.X, m.X, m.Z))]
    dampers = [m.applied("viscous", f"j{n}", d=Fraction("0.3")) for n in range(5)]
    return replace(m.scene(m.chain(*links, name="arm"), m.gravity(), *dampers),
                   functions=("inverse_dynamics", "forward_dynamics"), tiers=("accurate",))


def named_scene(arm: Links = ARMS[0]) -> SceneFunctions:
    """Its functions."""
    return replace(derive(scene(arm)), name="signed_arm")


def judge(derived: SceneFunctions, function: FunctionProgram, count: int, head: str = "",
          text: str = ""
          ) -> Judged:
    """Truth at random states."""
    given = states(derived, function, count, DOUBLE)
    true = truths(function.program, given)
    high = np.array([[float(x) for x in row] for row in true])
    low = np.array([[float(x - mpmath.mpf(y)) for x, y in zip(row, numbers, strict=True)]
                    for row, numbers in zip(true, high, strict=True)])
    condition = np.transpose([np.broadcast_to(x, count) for x in conditions(
        function.program, components(function.program, given))])
    return Judged(f"{head}\n@errstate{text}", function.name, "signed_arm.accurate", given,
                  high, low, np.spacing(abs(high)), condition)


def unnoticed(name: str, count: int, folder: Path, arms: Sequence[Links] = ARMS
              ) -> tuple[int, list[str]]:
    """The number of signs in the C of a function, and the signs that can be flipped unnoticed at
    this many states of any of the arms, besides signs that change nothing."""
    (lines, missed), *others = (_unnoticed(arm, name, count, folder) for arm in arms)
    noticed = {place for result, unseen in others
               for place in {*map(_place, result)} - {*map(_place, unseen)}}
    return len(lines), [x for x in missed if _place(x) not in noticed
                        and not any(same in x for same in SAME)]


def _place(line: str) -> str:
    """The part of a place that is common to the texts of all arms."""
    return re.sub(r"-?\b\d+\.\d+(e-?\d+)?|_\d+\b", "", line)


def _unnoticed(arm: Links, name: str, count: int, folder: Path
               ) -> tuple[tuple[str, ...], list[str]]:
    """The signs of a function's C, and the unnoticed ones.

    One is noticed if a result errs by more than MOST, or hi + lo, in which errors of second order
    show, by more than twice what it errs as it is, per condition."""
    derived = named_scene(arm)
    judged = judge(derived, next(f for f in derived.functions if f.name == name), count)
    made = mutants(folder / arm.mass, scene_files(derived), "signed_arm_accurate",
                   f"signed_arm_{name}_accurate", judged.high.shape[1])
    high, low = (np.where(judged.counted, x, 0) for x in (judged.high, judged.low))
    unit = np.where(judged.counted, judged.unit, np.inf)
    truth = high, low, unit, unit * judged.condition * 2.0**-53
    (rounded, whole), = made.worst([-1], judged.given, truth, (np.inf, np.inf))
    assert rounded <= MOST
    assert whole < 2
    worst = made.worst(range(len(made.lines)), judged.given, truth, (MOST, 2 * whole))
    return made.lines, [line for line, (x, y) in zip(made.lines, worst, strict=True)
                        if x <= MOST and y <= 2 * whole]
