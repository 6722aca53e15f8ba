"""A sweep of a 6-joint arm against MuJoCo's rollout: the same model, starts, steps and cores.

Both integrate a UR5 with damping and armature under gravity, 1,000 steps of 1 ms, linearly implicit
in damping.  The sweep also records energy and statistics, and writes its Parquet files.  Rounds of
both take turns; what a million runs take is extrapolated from them."""

import argparse
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

import mujoco
import numpy as np
from mujoco import rollout
from tabulate import tabulate

from coscrew_codegen.reports.timing.loop_timing import Timing
from coscrew_codegen.scene.readers.toml.toml_scene import read_scene
from coscrew_codegen.simulation.run_summary import RunOverrides
from coscrew_codegen.simulation.sweep import cluster, member_values, sweep_options
from coscrew_codegen.simulation.sweep.chunk import Job
from coscrew_codegen.simulation.sweep.files.folder import opened
from coscrew_codegen.simulation.sweep.prepare import Prepared, SweepRequest, prepared
from tests.benchmarks.bars import Bar, show
from tests.benchmarks.mujoco_steps import PASSIVE, model_of
from tests.benchmarks.pinocchio_loops import ROBOTS
from tests.benchmarks.words import span
from tests.support.scenes.robots import path_of

STEPS, STEP = 1000, 1e-3
MANY = 1_000_000
WANTED = 30  # MuJoCo's time / ours
THEIRS = 512  # runs a round: rollout returns every state of each
SCENE = f"""
model = "{path_of(ROBOTS["ur5"][0])}"
[effects.gravity]
[effects.viscous]
joints = "all"
d = 0.5
[effects.armature]
joints = "all"
inertia = 0.1
[outputs]
record = ["q", "v"]
every = 0.01
[run]
duration = {STEPS * STEP}
step = {STEP}
integrator = "linear-implicit-euler"
"""


def sweep(folder: Path, samples: int, seed: int, precision: str) -> Prepared:
    """The sweep of so many starts."""
    path = folder / "ur5.toml"
    path.write_text(SCENE)
    return prepared(read_scene(path),
                    SweepRequest((), (sweep_options.sobol("start.q.*=-2:2"),), samples, seed,
                                 (), False, RunOverrides(precision=precision)))


def ours(client, folder: Path, its: Prepared) -> float:
    """Seconds a run."""
    job, began = Job.of(its.kernels, its.specification), time.perf_counter()
    with opened(folder, its.specification, {}) as target:
        for number, result in cluster.finished(client, job, target.missing()):
            target.write(number, result.content)
    return (time.perf_counter() - began) / its.specification.varied.members


@contextmanager
def theirs(cores: int) -> Iterator:
    """A function that returns seconds a run from these starts."""
    model = model_of("ur5", PASSIVE)
    datas = [mujoco.MjData(model) for _ in range(cores)]
    size = mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_FULLPHYSICS)
    with rollout.Rollout(nthread=cores) as run:

        def timed(starts: np.ndarray) -> tuple[float, np.ndarray]:
            states = np.zeros((len(starts), size))
            states[:, 1:7] = starts
            began = time.perf_counter()
            result, _ = run.rollout(model, datas, states, nstep=STEPS)
            return (time.perf_counter() - began) / len(starts), result[:, -1, 1:7]

        yield timed


def main(arguments: Sequence[str] = ()) -> list[Bar]:
    """Print times and ratios."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--samples", type=int, default=65536)
    parser.add_argument("--rounds", type=int, default=3)
    options = parser.parse_args(arguments)
    cores = cluster.cores()
    rows, bars = [], []
    with TemporaryDirectory() as place, cluster.local(cores) as client, theirs(cores) as other:
        for precision in ("double", "single"):
            base = Path(place) / precision
            base.mkdir()
            ours(client, base / "warm", sweep(base, 4096, 0, precision))
            times = []
            for n in range(options.rounds):
                its = sweep(base, options.samples, n + 1, precision)
                starts = member_values.values(its.specification.varied, range(THEIRS))
                times.append((ours(client, base / str(n), its), other(starts)[0]))
            own, rival = (Timing(np.array(x)) for x in zip(*times, strict=True))
            rows.append((precision, span(own.time, 1e6), span(rival.time, 1e6),
                         span(rival.ratio(own)), f"{own.time.median * MANY:.0f}"))
            bars.append(Bar(f"rollout / sweep in {precision} of a UR5, {cores} cores", WANTED,
                            rival.ratio(own), note=f"{options.rounds} rounds"))
    print(f"\n{STEPS} steps of a UR5 on {cores} cores, µs a run: coscrew sweep ({options.samples} "
          f"runs a round) and MuJoCo's rollout ({THEIRS}), {options.rounds} rounds in turn")
    print(tabulate(rows, ("precision", "sweep", "rollout (double)", "rollout / sweep",
                          f"s for {MANY:.0e} runs, extrapolated"), disable_numparse=True))
    return bars


if __name__ == "__main__":
    show(main(sys.argv[1:]))
