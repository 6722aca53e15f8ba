"""Scenes that sweeps vary, and sweeps of them without workers."""

import io
from collections.abc import Sequence
from pathlib import Path

import pyarrow
import pyarrow.parquet

from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.simulation.run_summary import RunOverrides
from coscrew_codegen.simulation.sweep import chunk, prepare, sweep_options
from coscrew_codegen.simulation.sweep.prepare import Prepared
from tests.support.scenes.simulated import scene_file

SLIDER = """
runtime = ["block.mass", "block.inertia"]
[bodies.block]
mass = 2
inertia = [1, 1, 1]
[bodies.needle]
mass = 1
inertia = [1, 1, 1]
[joints.slide]
type = "prismatic"
child = "block"
axis = [1, 0, 0]
limits = { lower = -1, upper = 2, velocity = 3 }
[joints.swivel]
type = "continuous"
parent = "block"
child = "needle"
axis = [0, 0, 1]
[effects.wrench.block]
force = [3, 0, 0]
[effects.limit.slide]
lower = -20
upper = 200
k = 1
[outputs]
record = ["q.slide", "v.slide"]
every = 0.25
[run]
duration = 1
step = 0.015625
integrator = "rk4"
"""
"""A block of mass m = block.mass with a needle of mass 1, pushed by 3 N: q = q0 + v0 t + 1.5 t²/(m
+ 1); all numbers are binary fractions where m + 1 is a power of two."""

BALL = """
base = "free"
[bodies.ball]
mass = 1
inertia = [1, 1, 1]
[bodies.cup]
mass = 1
inertia = [1, 1, 1]
[joints.socket]
type = "spherical"
parent = "ball"
child = "cup"
[effects.gravity]
[run]
duration = 0.1
"""
"""A floating base and a spherical joint: quaternions."""

UNITS = """
runtime = ["block.mass", "block.com", "block.inertia", "gravity.g", "spring.slide.k",
           "spring.swivel.k", "actuator.slide.gear", "actuator.swivel.gear", "wrench.block.force"]
[bodies]
block = { mass = 2, com = [0, 0, 0], inertia = [1, 1, 1] }
needle = { mass = 1, inertia = [1, 1, 1] }
[joints]
slide = { type = "prismatic", child = "block", axis = [1, 0, 0] }
swivel = { type = "continuous", parent = "block", child = "needle", axis = [0, 0, 1] }
[effects.gravity]
[effects.spring]
joints = "all"
k = 1
[effects.actuator]
joints = "all"
kind = "dc"
voltage = "0.1*t"
gear = 10
kt = 0.1
ke = 0.1
R = 1
[effects.wrench.block]
force = [1, 0, 0]
"""
"""Parameters of bodies and effects, on a joint that slides and one that turns."""


_NONE = RunOverrides()


def prepared(folder: Path, text: str, grids: Sequence[str] = (), sobols: Sequence[str] = (),
             samples: int | None = None, *, seed: int | None = None, record: Sequence[str] = (),
             series: bool = False, overrides: RunOverrides = _NONE) -> Prepared:
    """The sweep that these options ask for, of a scene in this folder."""
    return prepare.prepared(read_scene(scene_file(folder, text)), prepare.SweepRequest(
        tuple(map(sweep_options.grid, grids)), tuple(map(sweep_options.sobol, sobols)), samples,
                                                                                       seed, record,
        series, overrides))


def table(its: Prepared, number: int = 0) -> pyarrow.Table:
    """A chunk's file, read back."""
    result = chunk.computed(chunk.Job.of(its.kernels, its.specification), number)
    return pyarrow.parquet.read_table(io.BytesIO(result.content))
