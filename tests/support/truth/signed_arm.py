"""An arm, the truth of its accurate functions at random states, and the signs of their C that can
be flipped unnoticed."""

from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np

from coscrew_codegen.formats import DOUBLE
from coscrew_codegen.layout import scene_files
from coscrew_codegen.mechanics import derive
from coscrew_codegen.scene.model import Kind
from coscrew_codegen.scene.scene import Scene
from coscrew_codegen.scene_functions import Function, SceneFunctions
from tests.support.scenes import mechanisms as m
from tests.support.scenes.tiers import components, states, truths
from tests.support.truth.condition import conditions
from tests.support.truth.sign_mutants import mutants

LARGEST = 1e9  # condition
MOST = 0.5 + 1e-5  # units of the last digit


@dataclass(frozen=True)
class Judged:
    """A function's text and what it must return."""

    text: str
    name: str
    package: str
    given: list[np.ndarray]
    high: np.ndarray  # the truth in two parts, in units of its last digit from `high`
    low: np.ndarray
    unit: np.ndarray
    told: np.ndarray  # whether the condition allows a judgement


def scene() -> Scene:
    """Four joints that turn about different axes, one that slides, dampers."""
    moments = ("0.22", "0.33", "0.41", "0.11", "-0.07", "0.13")
    links = [(Kind.PRISMATIC if n == 2 else Kind.REVOLUTE, axis, m.at("0.1", "-0.2", "0.3"),
              m.inertia("1.1", ("0.01", "0.07", "-0.03"), moments))
             for n, axis in enumerate((m.Z, m.Y, m.X, m.X, m.Z))]
    dampers = [m.applied("viscous", f"j{n}", d=Fraction("0.3")) for n in range(5)]
    return replace(m.scene(m.chain(*links, name="arm"), m.gravity(), *dampers),
                   functions=("inverse_dynamics", "forward_dynamics"), tiers=("accurate",))


def named_scene() -> SceneFunctions:
    """Its functions."""
    return replace(derive(scene()), name="signed_arm")


def judge(derived: SceneFunctions, function: Function, count: int, head: str = "", text: str = ""
          ) -> Judged:
    """Truth at random states."""
    given = states(derived, function, count, DOUBLE)
    true = truths(function.program, given)
    high = np.array([[float(x) for x in row] for row in true])
    low = np.array([[float(x - mpmath.mpf(y)) for x, y in zip(row, numbers, strict=True)]
                    for row, numbers in zip(true, high, strict=True)])
    told = np.transpose([np.broadcast_to(x, count) for x in conditions(
        function.program, components(function.program, given))]) < LARGEST
    return Judged(f"{head}\n@errstate{text}", function.name, "signed_arm.accurate", given,
                  high, low, np.spacing(abs(high)), told)


def unnoticed(judged: Judged, folder: Path) -> tuple[int, list[str]]:
    """How many signs the C of a function has, and those that can be flipped unnoticed."""
    size = judged.high.shape[1]
    made = mutants(folder, scene_files(named_scene()), "signed_arm_accurate",
                   f"signed_arm_{judged.name}_accurate", size)
    unit = np.where(judged.told, judged.unit, np.inf)
    high, low = (np.where(judged.told, x, 0) for x in (judged.high, judged.low))
    worst = made.worst([-1, *range(len(made.lines))], judged.given, high, low, unit, MOST)
    assert worst[0] <= MOST
    return len(made.lines), [line for line, x in zip(made.lines, worst[1:], strict=True)
                             if x <= MOST]
