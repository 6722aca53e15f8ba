"""Functions of scenes with stated ranges, and mixtures of pairs and single numbers, that
certificates are made of."""

from dataclasses import replace
from functools import cache

import numpy as np

from coscrew_codegen.accuracy.tiers.mixed import CARRYING, Mixture
from coscrew_codegen.dynamics import derive
from coscrew_codegen.program import Op, Program
from coscrew_codegen.program.scene_functions import FunctionProgram
from tests.support.scenes import fixed_robots
from tests.support.scenes.ranged import SCENES


@cache
def function(scene: str, name: str) -> FunctionProgram:
    its = fixed_robots.scene(scene) if scene in fixed_robots.ROBOTS else SCENES[scene]()
    return derive(replace(its, functions=(name,), tiers=())).named(name)


def plain(its: FunctionProgram) -> Program:
    return its.program.fine or its.program


def mixture(its: FunctionProgram, seed: int) -> Mixture:
    """A random mixture; sine and cosine of an angle are pairs together."""
    draw, steps = np.random.default_rng(seed), plain(its).instructions
    paired = frozenset(x.name for x in steps if draw.random() < (0, 0.3, 0.6, 0.9)[seed % 4])
    angles = {x.operands for x in steps if x.op in (Op.SIN, Op.COS) and x.name in paired}
    kept = frozenset((x.name, n) for x in steps if x.op in CARRYING for n in range(2)
                     if draw.random() < 0.5)
    return Mixture(paired | {x.name for x in steps if x.operands in angles}, kept)
